/// Stress at a point of a body, and its invariants, which a search for the largest compares.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/elementary.hpp"

namespace wrc::damage {

/// Components along x, y and the depth z [Pa]; tension is positive.
struct Stress {
  double xx = 0.0, yy = 0.0, zz = 0.0, xy = 0.0, yz = 0.0, zx = 0.0;
};

/// Numbers of a stress that do not depend on axes [Pa].
struct StressNumbers {
  double von_mises = 0.0;
  double shear = 0.0;    ///< (s1 - s3) / 2: half of Tresca's
  double tension = 0.0;  ///< s1, the most tensile principal stress
};

/// sqrt(3 J2), J2 the second invariant of the deviator [Pa].
inline double von_mises(const Stress& s) {
  const double xy = s.xx - s.yy, yz = s.yy - s.zz, zx = s.zz - s.xx;
  const double sheared = s.xy * s.xy + s.yz * s.yz + s.zx * s.zx;
  return std::sqrt(0.5 * (xy * xy + yz * yz + zx * zx) + 3.0 * sheared);
}

/// Principal stresses by the angle of the deviator: s_k = m + 2 sqrt(J2 / 3) cos(theta - 2 pi k / 3),
/// cos 3 theta = (J3 / 2) (3 / J2)^(3/2), 0 <= theta <= pi / 3. Without the C library's functions: the
/// real-time calls use it too.
inline StressNumbers numbers_of(const Stress& s) {
  const double mean = (s.xx + s.yy + s.zz) / 3.0;
  StressNumbers numbers{von_mises(s), 0.0, mean};
  if (!(numbers.von_mises > 0.0)) return numbers;
  const double x = s.xx - mean, y = s.yy - mean, z = s.zz - mean;
  const double third =
      x * (y * z - s.yz * s.yz) - s.xy * (s.xy * z - s.yz * s.zx) + s.zx * (s.xy * s.yz - y * s.zx);
  const double radius = numbers.von_mises / 1.5;  // 2 sqrt(J2 / 3)
  const double triple = std::clamp(4.0 * third / radius / radius / radius, -1.0, 1.0);
  const double angle = (0.5 * pi - arcsine(triple)) / 3.0;
  const double first = radius * sine_cosine(angle).cosine;
  const double last = radius * sine_cosine(pi / 3.0 - angle).cosine;  // s3 = mean - last
  numbers.shear = 0.5 * (first + last);
  numbers.tension = mean + first;
  return numbers;
}

/// A largest number and where it is.
struct StressPeak {
  double value = 0.0;                ///< [Pa]
  double x = 0.0, y = 0.0, z = 0.0;  ///< [m]
};

/// The largest of each number.
struct StressPeaks {
  StressPeak von_mises, shear, tension;
  bool any = false;

  void take(const StressNumbers& numbers, double x, double y, double z) {
    const auto take_one = [&](StressPeak& peak, double value) {
      if (!any || value > peak.value) peak = {value, x, y, z};
    };
    take_one(von_mises, numbers.von_mises);
    take_one(shear, numbers.shear);
    take_one(tension, numbers.tension);
    any = true;
  }
  void take(const StressPeaks& other) {
    if (!other.any) return;
    const auto take_one = [&](StressPeak& peak, const StressPeak& found) {
      if (!any || found.value > peak.value) peak = found;
    };
    take_one(von_mises, other.von_mises);
    take_one(shear, other.shear);
    take_one(tension, other.tension);
    any = true;
  }
};

}  // namespace wrc::damage
