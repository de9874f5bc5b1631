/// All regions where the undeformed bodies overlap by a threshold, connected to the contact point's or not:
/// the outline of EKP_ELLIPSE and the chord its curvature comes from.
///
/// The reference program takes every row above the threshold, so that a region beside the contact enters the
/// outline with no size and joins the patch with the size it has. Its chord may jump, though: to the far side
/// of a valley of the gap that comes above half depth, or over a flat of it. The load then falls by up to
/// some per cent. Here sudden growth of the chord counts gradually.
#pragma once

#include <algorithm>
#include <array>

#include "kernels/kernels.hpp"
#include "normal/penetration/penetration.hpp"

namespace wrc::normal {

/// Calls `take(span)` for the regions of overlap beyond `y` in one direction (+1 or -1), outwards; `y` is a
/// border of the overlap, or the end of the rows.
template <class Scale, class Take>
void regions_beyond(Overlap<Scale>& overlap, double y, int direction, Take&& take) {
  const patch::GapRows& rows = overlap.rows;
  const auto above = static_cast<std::int32_t>(std::upper_bound(rows.y, rows.y + rows.count, y) - rows.y);
  bool inside = false;
  double from = y, y_before = y, g_before = 0.0;
  const auto end = [&](double to, bool at_edge) {
    take(Span{std::min(from, to), std::max(from, to), at_edge});
  };
  for (std::int32_t j = direction > 0 ? above : above - 1; j >= 0 && j < rows.count; j += direction) {
    // A region opens where the overlap rises above 0 and ends where it falls back.
    const double here = rows.y[j], g = overlap.at_row(j);
    if (g > 0.0 && !inside) from = border_between(overlap, here, g, y_before, g_before);
    if (g <= 0.0 && inside) end(border_between(overlap, y_before, g_before, here, g), false);
    inside = g > 0.0;
    y_before = here;
    g_before = g;
  }
  if (inside) end(y_before, true);
}

/// The chord of lateral_curvature() over all regions below half the approach.
LateralCurvature curvature_of_all_regions(const patch::GapRows& rows, const patch::GapMinimum& lowest,
                                          double approach) noexcept;

/// Regions of overlap at increasing y.
struct OverlapRegions {
  static constexpr std::int32_t capacity = 8;  ///< more lie on no profile; the outermost are left out
  std::array<Span, capacity> of{};
  std::int32_t count = 0;
  bool at_edge = false;
};

/// The region `main` round the contact point and the others, `most` of them at most.
OverlapRegions overlap_regions(const patch::GapRows& rows, const patch::GapMinimum& lowest,
                               const PenetrationScale& scale, double approach, const Span& main,
                               std::int32_t most) noexcept;

/// divide_span() over several regions: strips of one width over all of them together, and where one would lie
/// across a border, its parts on either side; no more than `count`. Area and load then move with the borders.
void divide_regions(const Kernels& kernels, const patch::GapRows& rows, const patch::GapMinimum& lowest,
                    const PenetrationScale& scale, double approach, const OverlapRegions& regions,
                    std::int32_t count, patch::Strips& strips) noexcept;

}  // namespace wrc::normal
