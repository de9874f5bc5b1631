/// How long work reports its progress and is cancelled.
#pragma once

namespace wrc {

/// `report` gets the fraction done, 0..1, and `user`; it returns false to cancel. Work without one runs
/// through.
struct ProgressCallback {
  bool (*report)(double fraction, void* user) = nullptr;
  void* user = nullptr;

  bool goes_on(double fraction) const { return report == nullptr || report(fraction, user); }
};

/// A part of some work, whose fractions lie between two of the whole's. Both must outlive the callback.
class PartOfProgress {
 public:
  PartOfProgress(const ProgressCallback& whole, double begun, double done)
      : whole_(whole), begun_(begun), done_(done) {}
  ProgressCallback callback() { return whole_.report ? ProgressCallback{report, this} : ProgressCallback{}; }

 private:
  static bool report(double fraction, void* self) {
    const auto& part = *static_cast<const PartOfProgress*>(self);
    return part.whole_.goes_on(part.begun_ + (part.done_ - part.begun_) * fraction);
  }
  ProgressCallback whole_;
  double begun_, done_;
};

}  // namespace wrc
