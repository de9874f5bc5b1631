/// How long work reports its progress and is cancelled.
#pragma once

namespace wrc::halfspace {

/// `report` gets the fraction done, 0..1, and `user`; it returns false to cancel. Work without one runs
/// through.
struct ProgressCallback {
  bool (*report)(double fraction, void* user) = nullptr;
  void* user = nullptr;

  bool goes_on(double fraction) const { return report == nullptr || report(fraction, user); }
};

}  // namespace wrc::halfspace
