/// The region where the undeformed bodies overlap by a given threshold: the outline of all methods of the
/// virtual-penetration family (Kik-Piotrowski, EKP, KPEC) and the span over which curvatures are fitted.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/fault.hpp"
#include "kernels/kernels.hpp"
#include "patch/gap.hpp"
#include "patch/strips.hpp"

namespace wrc::normal {

/// The scale eps(y) of the virtual penetration: a parabola about `centre`, kept within 0.05..1 (not 0: a
/// contact point far from the middle must stay inside its own patch).
struct PenetrationScale {
  double at_centre = 0.5;  ///< eps(centre) [-]
  double bend = 0.0;       ///< [1/m^2]
  double centre = 0.0;     ///< [m]

  double at(double y) const noexcept {
    const double eps = bend == 0.0 ? at_centre : at_centre + bend * (y - centre) * (y - centre);
    return std::clamp(eps, 0.05, 1.0);
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

/// g(y) for a scale: PenetrationScale, or any type with `double at(double y)`.
template <class Scale>
struct Overlap {
  const patch::GapRows& rows;
  const patch::GapMinimum& lowest;
  Scale scale;
  double approach;
  patch::GapReader gap{rows};

  double of(double y, double height) { return scale.at(y) * approach - (height - lowest.height); }
  double at_row(std::int32_t j) { return of(rows.y[j], rows.height[j]); }
  double at(double y) { return of(y, gap.height(y)); }
};

/// Root of the overlap between y_in (overlap > 0) and y_out (<= 0): regula falsi in Illinois' form.
template <class Scale>
double border_between(Overlap<Scale>& overlap, double y_in, double g_in, double y_out, double g_out) {
  constexpr int cap = 30;  // 4 to 7 are used
  // An end kept twice has its value halved: both ends then converge.
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
template <class Scale>
double border_from_minimum(Overlap<Scale>& overlap, int direction, bool& at_edge) {
  const patch::GapRows& rows = overlap.rows;
  double y_in = overlap.lowest.y;
  double g_in = overlap.at(y_in);
  if (g_in <= 0.0) return y_in;
  // The first row beyond the minimum in that direction.
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

/// Finds the borders as roots of g on the interpolated gap, so that they move smoothly with approach and
/// pose. A lobe that rises and falls between two rows is not seen.
template <class Scale>
Span penetration_span(const patch::GapRows& rows, const patch::GapMinimum& lowest, Scale scale,
                      double approach) noexcept {
  Overlap<Scale> overlap{rows, lowest, scale, approach};
  Span span;
  span.y_from = border_from_minimum(overlap, -1, span.at_edge);
  span.y_to = border_from_minimum(overlap, +1, span.at_edge);
  return span;
}

/// Divides the span into `count` strips of equal width; at each strip's middle the half length is that of the
/// overlap of the row's parabola, sqrt(2 g / curvature). Pressures are left to the caller. Area and load
/// are smooth because the strips are fitted to the span, not cut out of a fixed grid.
void divide_span(const Kernels& kernels, const patch::GapRows& rows, const patch::GapMinimum& lowest,
                 const PenetrationScale& scale, double approach, const Span& span, std::int32_t count,
                 patch::Strips& strips) noexcept;

/// Half widths of chords below this are taken for it [m]: down to none at all they lie between the numbers
/// that y can be, as in a needle of a gap, and no patch is to be found there.
inline constexpr double least_half_chord = 1e-12;

/// Lateral curvature of the gap as the patch sees it: the coefficient B of h = B (y - middle)^2 [1/m] through
/// the ends of the region below half the approach. A local second derivative would jump on every curvature
/// step of a standard profile; a chord over the patch does not.
struct LateralCurvature {
  double coefficient = 0.0;  ///< B [1/m]
  double middle = 0.0;       ///< [m]
  bool at_edge = false;
};
LateralCurvature lateral_curvature(const Span& chord, double approach) noexcept;
inline LateralCurvature lateral_curvature(const patch::GapRows& rows, const patch::GapMinimum& lowest,
                                          double approach) noexcept {
  return lateral_curvature(penetration_span(rows, lowest, PenetrationScale{}, approach), approach);
}

/// Deepest approach the rows can describe: where the overlap covers all of them [m].
double deepest_approach(const patch::GapRows& rows, const patch::GapMinimum& lowest) noexcept;

}  // namespace wrc::normal
