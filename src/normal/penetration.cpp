#include "normal/penetration.hpp"

namespace wrc {

LateralCurvature lateral_curvature(const GapRows& rows, const GapMinimum& lowest, double approach) noexcept {
  const PenetrationScale half{};
  const Span span = penetration_span(rows, lowest, half, approach);
  const double half_width = 0.5 * span.width();
  return {half.at_centre * approach / (half_width * half_width), span.middle(), span.at_edge};
}

double deepest_approach(const GapRows& rows, const GapMinimum& lowest) noexcept {
  return *std::max_element(rows.height, rows.height + rows.count) - lowest.height;
}

}  // namespace wrc
