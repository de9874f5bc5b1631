/// Places of the strip half-space solver's strips: dense where the gap bends sharply, none where the
/// bodies cannot touch.
#pragma once

#include "patch/gap.hpp"
#include "patch/material.hpp"

namespace wrc::normal {

/// Stretches a grid may have.
inline constexpr std::int32_t most_regions = 8;

/// Strips of the solver; arrays of `count` in the caller's memory. Strips j and j + 1 are neighbours in the
/// same stretch of the gap if region[j] == region[j + 1].
struct CollocationGrid {
  std::int32_t count = 0;
  double* y = nullptr;      ///< middle [m]
  double* width = nullptr;  ///< [m]
  std::int32_t* region = nullptr;
  bool at_edge = false;  ///< the outermost stretch is cut off by the first or last row
};

/// Approach of the load by an elastic foundation with q = (0.6 approach - height) / (2 c) per unit of width,
/// c the compliance: within 3 % of Hertz for a sphere, within 30 % for wheel and rail. It sees every spot of
/// the gap, and moves smoothly when spots join. The search begins at `guess` > 0 [m].
double foundation_approach(const patch::GapRows& rows, double lowest_height, double normal_compliance,
                           double normal_force, double guess) noexcept;

/// Spreads `count` strips over all stretches where the height lies less than `depth` over the lowest. Widths
/// are inversely proportional to the root of the lateral curvature, as the width of a contact is to that of
/// 1 / radius. Curvature is the second difference over 4 % of the whole extent: shorter waves of a profile do
/// not move the strips. `grid` has memory for `count`.
void build_collocation_grid(const patch::GapRows& rows, const patch::GapMinimum& lowest, double depth,
                            std::int32_t count, CollocationGrid& grid) noexcept;

}  // namespace wrc::normal
