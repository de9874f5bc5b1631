/// The region where the undeformed bodies overlap by a given threshold: the outline of all methods of the
/// virtual-penetration family (Kik-Piotrowski, EKP, KPEC) and the span over which curvatures are fitted.
#pragma once

#include "fault.hpp"
#include "patch/gap.hpp"
#include "patch/strips.hpp"

namespace wrc {

/// The scale eps(y) of the virtual penetration: a parabola about `centre`, kept within 0..1.
struct PenetrationScale {
  double at_centre = 0.5;  ///< eps(centre) [-]
  double bend = 0.0;       ///< [1/m^2]
  double centre = 0.0;     ///< [m]

  double at(double y) const noexcept {
    const double eps = at_centre + bend * (y - centre) * (y - centre);
    return eps < 0.0 ? 0.0 : (eps > 1.0 ? 1.0 : eps);
  }
};

/// Lateral extent of the connected region around the gap's minimum where
///   g(y) = eps(y) approach - (height(y) - lowest height) > 0 .
struct Span {
  double y_from = 0.0;   ///< [m]
  double y_to = 0.0;     ///< [m]
  bool at_edge = false;  ///< the region goes on beyond the first or the last row
  double width() const noexcept { return y_to - y_from; }
  double middle() const noexcept { return 0.5 * (y_from + y_to); }
};

/// Finds the borders as roots of g on the interpolated gap, so that they move smoothly with approach and
/// pose. A lobe that rises and falls between two rows is not seen.
Span penetration_span(const GapRows& rows, const GapMinimum& lowest, const PenetrationScale& scale,
                      double approach) noexcept;

/// Divides the span into `count` strips of equal width; at each strip's middle the half length is that of the
/// overlap of the row's parabola, sqrt(2 g / curvature). Pressures are left to the caller. Fitting the strips
/// to the span, instead of cutting it out of a fixed grid, is what makes area and load smooth.
void divide_span(const GapRows& rows, const GapMinimum& lowest, const PenetrationScale& scale,
                 double approach, const Span& span, std::int32_t count, Strips& strips) noexcept;

/// Lateral curvature of the gap as the patch sees it: the coefficient B of h = B (y - middle)^2 [1/m] through
/// the ends of the region below half the approach. A local second derivative would jump on every curvature
/// step of a standard profile; a chord over the patch does not. CONTACT's KPEC uses the same chord.
struct LateralCurvature {
  double coefficient = 0.0;  ///< B [1/m]
  double middle = 0.0;       ///< [m]
  bool at_edge = false;
};
LateralCurvature lateral_curvature(const GapRows& rows, const GapMinimum& lowest, double approach) noexcept;

/// Deepest approach the rows can describe: where the overlap covers all of them [m].
double deepest_approach(const GapRows& rows, const GapMinimum& lowest) noexcept;

}  // namespace wrc
