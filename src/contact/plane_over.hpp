/// The contact plane of the stages over one body's profile: finds the point of the profile over a point of
/// the plane.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "geometry/arc_length.hpp"
#include "geometry/profile.hpp"

namespace wrc::contact {

class PlaneOver {
 public:
  /// `at`: the contact point on the right-hand profile.
  PlaneOver(const geometry::MeasuredProfile& profile, double at)
      : measured_(profile), y0_(at), at_(at), piece_(geometry::piece_at(*profile.profile, at)) {
    point_ = geometry::evaluate(*profile.profile, at, piece_);
    z0_ = point_.z;
    cosine_ = 1.0 / std::sqrt(1.0 + point_.slope * point_.slope);
    sine_ = point_.slope * cosine_;
    run_ = 1.0 / cosine_;
  }

  /// y of the profile's point over `y` of the contact plane, to some nanometres. Strips come side by side:
  /// each is looked for from the one before.
  double find(double y) {
    // Newton's method for the profile's y `at_`: the residual is y - cos (at - y0) - sin (z(at) - z0), its
    // derivative cos + sin dz/dy.
    constexpr int most_steps = 8;
    constexpr double close = 5e-6;  // [m]: the next step would be some nanometres
    at_ += (y - y_) / run_;
    y_ = y;
    for (int n = 0; n < most_steps; ++n) {
      point_ = geometry::evaluate(*measured_.profile, at_, piece_);
      run_ =
          std::max(cosine_ + sine_ * point_.slope, 0.1);  // small where the profile turns away from the plane
      const double off = y - cosine_ * (at_ - y0_) - sine_ * (point_.z - z0_);
      move_ = std::clamp(off / run_, -0.02, 0.02);
      at_ += move_;
      if (std::abs(off) < close) break;
    }
    return at_;
  }

  /// z of the point found [m].
  double z() { return geometry::evaluate(*measured_.profile, at_, piece_).z; }

  /// Arc length of the profile's point over `y` of the contact plane.
  double arc(double y) {
    find(y);
    // From the strip before by the trapezoidal rule with its end correction: a tenth of the integral's cost.
    constexpr double beside = 0.6e-3;  // [m]
    // ds/dy = sqrt(1 + z'^2) and its derivative z' z'' / sqrt(1 + z'^2), z' brought along by the last Newton
    // step.
    const double slope = point_.slope + point_.second * move_, stretch = std::sqrt(1.0 + slope * slope);
    const double bend = slope * point_.second / stretch, step = at_ - last_;
    arc_ = std::abs(step) < beside ? arc_ + step * (0.5 * (stretch + stretch_) + step / 12.0 * (bend_ - bend))
                                   : geometry::arc_at(measured_, at_, piece_);
    last_ = at_;
    stretch_ = stretch;
    bend_ = bend;
    return arc_;
  }

 private:
  geometry::MeasuredProfile measured_;
  double y0_, z0_ = 0.0, cosine_ = 1.0, sine_ = 0.0, at_;
  geometry::ProfilePoint point_;                                 // before the last step
  double move_ = 0.0;                                            // that step
  double last_ = -1.0, arc_ = 0.0, stretch_ = 1.0, bend_ = 0.0;  // strip before; none so far
  double y_ = 0.0, run_ = 1.0;                                   // strip before
  std::int32_t piece_;
};

}  // namespace wrc::contact
