/// A profile as a smooth curve through its points: cubic splines over the arc length.
#pragma once

#include <vector>

namespace wrc::halfspace {

class SectionCurve {
 public:
  struct Point {
    double y = 0.0, z = 0.0;    ///< [m]
    double dy = 1.0, dz = 0.0;  ///< unit tangent, towards larger s
  };

  SectionCurve() = default;
  /// Through the points (y[k], z[k]) [m] in order along the curve, at least four; points nearer to the one
  /// before than `least_spacing` are left out. The parameter is the length of chords: it differs from the arc
  /// length by the fraction (spacing * curvature)^2 / 24, 1e-5 for points 0.2 mm apart on a radius of 13 mm.
  SectionCurve(const std::vector<double>& y, const std::vector<double>& z, double least_spacing = 5e-5);

  double length() const { return s_.empty() ? 0.0 : s_.back(); }
  /// Arc lengths of the points it runs through [m].
  const std::vector<double>& places() const { return s_; }

  /// The curve at s [m] from its first point; beyond the ends the end tangents continue.
  Point at(double s) const;

 private:
  std::vector<double> s_, y_, z_;
  std::vector<double> y2_, z2_;  // second derivatives at the points; zero at the ends
};

}  // namespace wrc::halfspace
