#include "normal/penetration.hpp"

namespace wrc {

LateralCurvature lateral_curvature(const Span& chord, double approach) noexcept {
  const double half_width = 0.5 * chord.width();
  return {PenetrationScale{}.at_centre * approach / (half_width * half_width), chord.middle(), chord.at_edge};
}

double deepest_approach(const GapRows& rows, const GapMinimum& lowest) noexcept {
  return *std::max_element(rows.height, rows.height + rows.count) - lowest.height;
}

}  // namespace wrc
