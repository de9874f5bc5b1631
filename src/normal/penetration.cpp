#include "normal/penetration.hpp"

#include <algorithm>
#include <cmath>

namespace wrc {
namespace {

struct Overlap {
  const GapRows& rows;
  const GapMinimum& lowest;
  const PenetrationScale& scale;
  double approach;

  double of(double y, double height) const { return scale.at(y) * approach - (height - lowest.height); }
  double at_row(std::int32_t j) const { return of(rows.y[j], rows.height[j]); }
  double at(double y) const { return of(y, interpolate(rows, y).height); }
};

/// Root of the overlap between y_in (overlap > 0) and y_out (<= 0): regula falsi in Illinois' form.
double border_between(const Overlap& overlap, double y_in, double g_in, double y_out, double g_out) {
  constexpr int cap = 30;  // 4 to 7 are used
  int kept_side = 0;
  double y = y_out;
  for (int i = 0; i < cap && g_in - g_out > 0.0; ++i) {
    y = y_out + (y_in - y_out) * (g_out / (g_out - g_in));
    const double g = overlap.at(y);
    if (std::abs(g) <= 1e-13 * overlap.approach) break;
    if (g > 0.0) {
      y_in = y;
      g_in = g;
      if (kept_side == 1) g_out *= 0.5;
      kept_side = 1;
    } else {
      y_out = y;
      g_out = g;
      if (kept_side == -1) g_in *= 0.5;
      kept_side = -1;
    }
  }
  return y;
}

/// Walks from the minimum over the rows in one direction (+1 or -1) to the first without overlap.
double border(const Overlap& overlap, int direction, bool& at_edge) {
  const GapRows& rows = overlap.rows;
  double y_in = overlap.lowest.y;
  double g_in = overlap.at(y_in);
  if (g_in <= 0.0) return y_in;
  const auto above = static_cast<std::int32_t>(std::upper_bound(rows.y, rows.y + rows.count, y_in) - rows.y);
  std::int32_t j = direction > 0 ? above : above - 1;
  for (; j >= 0 && j < rows.count; j += direction) {
    const double g = overlap.at_row(j);
    if (g <= 0.0) return border_between(overlap, y_in, g_in, rows.y[j], g);
    y_in = rows.y[j];
    g_in = g;
  }
  at_edge = true;
  return y_in;
}

}  // namespace

Span penetration_span(const GapRows& rows, const GapMinimum& lowest, const PenetrationScale& scale,
                      double approach) noexcept {
  const Overlap overlap{rows, lowest, scale, approach};
  Span span;
  span.y_from = border(overlap, -1, span.at_edge);
  span.y_to = border(overlap, +1, span.at_edge);
  return span;
}

void divide_span(const GapRows& rows, const GapMinimum& lowest, const PenetrationScale& scale,
                 double approach, const Span& span, std::int32_t count, Strips& strips) noexcept {
  const Overlap overlap{rows, lowest, scale, approach};
  const double width = span.width() / count;
  for (std::int32_t j = 0; j < count; ++j) {
    const double y = span.y_from + (j + 0.5) * width;
    const GapRow row = interpolate(rows, y);
    // A dip of the overlap between two rows must not end in the root of a negative number.
    const double g = std::max(overlap.of(y, row.height), 1e-12 * approach);
    strips.y[j] = y;
    strips.width[j] = width;
    strips.centre[j] = row.centre;
    strips.half_length[j] = std::sqrt(2.0 * g / row.curvature);
  }
  strips.count = count;
}

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
