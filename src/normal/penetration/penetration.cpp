#include "normal/penetration/penetration.hpp"

#include "normal/simd/tasks.hpp"

namespace wrc::normal {

void divide_span(const Kernels& kernels, const patch::GapRows& rows, const patch::GapMinimum& lowest,
                 const PenetrationScale& scale, double approach, const Span& span, std::int32_t count,
                 patch::Strips& strips) noexcept {
  // The interval of the rows that holds the first border.
  const auto above = std::upper_bound(rows.y, rows.y + rows.count, span.y_from) - rows.y;
  const std::int32_t interval = std::clamp(static_cast<std::int32_t>(above) - 1, 0, rows.count - 2);
  kernels.normal.divide_span({rows, lowest.height, approach, scale.at_centre, scale.bend, scale.centre,
                              span.y_from, span.width() / count, interval, count},
                             {strips.y, strips.width, strips.centre, strips.half_length});
  strips.count = count;
}

LateralCurvature lateral_curvature(const Span& chord, double approach) noexcept {
  // B b^2 = depth, at half the approach.
  const double half_width = std::max(0.5 * chord.width(), least_half_chord);
  return {PenetrationScale{}.at_centre * approach / (half_width * half_width), chord.middle(), chord.at_edge};
}

double deepest_approach(const patch::GapRows& rows, const patch::GapMinimum& lowest) noexcept {
  return *std::max_element(rows.height, rows.height + rows.count) - lowest.height;
}

}  // namespace wrc::normal
