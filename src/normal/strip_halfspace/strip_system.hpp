/// The strips of the half-space solver (strip_halfspace.hpp) while it works on them.
#pragma once

#include <cstdint>

#include "normal/simd/tasks.hpp"
#include "normal/strip_halfspace/collocation_grid.hpp"
#include "patch/gap.hpp"

namespace wrc::normal {

/// Strips first .. first + count - 1 of the grid.
struct StripRange {
  std::int32_t first = 0, count = 0;
};

/// Arrays in the workspace, each over the grid's strips j or the active strips a, in whole packs;
/// `grid.count` and `active_count` are in use, and the elements that kernels read behind them are zero.
///
///   symbol (strip_halfspace.hpp)   array                         unit
///   y_j, width                     grid.y, grid.width            m       of outermost strips: fitted to the border
///   least h of the row             height                        m       over the lowest of the gap
///   x of that least h              gap_centre                    m
///   d2h/dx2                        curvature                     1/m
///   l_j, 1 / l_j                   half_length, inverse_length   m, 1/m
///   x_cj                           centre                        m
///   p_j                            peak                          Pa
struct StripSystem {
  CollocationGrid grid;
  double *cell_y = nullptr, *cell_width = nullptr;  ///< the strips as the grid has them [m]
  double *height = nullptr, *curvature = nullptr, *gap_centre = nullptr;
  double *half_length = nullptr, *inverse_length = nullptr, *centre = nullptr, *peak = nullptr;
  /// Row j column i: displacement at the middle of j by unit peak in i, over the compliance [m]; valid where
  /// row_known[j] is 1.
  double* influence = nullptr;
  std::int64_t stride = 0;        ///< elements of an array over strips, and from row to row of the influence
  double* matrix = nullptr;       ///< equations of the active strips, with their right-hand sides
  double* by_approach = nullptr;  ///< dp_a / d delta [Pa/m]
  double* by_height = nullptr;    ///< p_a = delta by_approach - by_height [Pa]
  double* peak_per_length = nullptr;  ///< p_a / l_a that the edge conditions ask for [Pa/m]
  double* shift = nullptr;            ///< x_ca - gap_centre that they ask for [m]
  simd::Sources sources{};            ///< the active strips
  simd::Sources pairs{};  ///< active strips a and a + 1 joined; the outermost strips alone at both ends
  double* half_width = nullptr;  ///< half width of active strips, over their half length [-]
  double* edge = nullptr;        ///< x of their edges [m]
  double *leading = nullptr, *trailing = nullptr;          ///< displacement there, over the compliance [m Pa]
  std::int32_t *active = nullptr, *next_active = nullptr;  ///< indices of the strips in contact
  std::int32_t* row_known = nullptr;  ///< 1: row j of the influence belongs to the present lengths
  std::int32_t active_count = 0;
  StripRange in_reach;  ///< strips of the present iteration: in contact, or where contact is looked for
  bool skewed = false;  ///< the gap's centre line is not straight along y
};

/// The system in memory of strip_halfspace_workspace(capacity) bytes (strip_halfspace.hpp).
StripSystem lay_out_strips(void* memory, std::int32_t capacity) noexcept;

/// Bytes of that memory.
std::int64_t strip_system_bytes(std::int32_t capacity) noexcept;

/// Rows of the equations of so many strips: a multiple of four.
constexpr std::int32_t elimination_size(std::int32_t strips) { return (strips + 3) / 4 * 4; }

/// True if active strips number a and a + 1 touch.
inline bool touch(const StripSystem& s, std::int32_t a) noexcept {
  return s.active[a + 1] == s.active[a] + 1 && s.grid.region[s.active[a + 1]] == s.grid.region[s.active[a]];
}

/// One past the last active strip of the patch that active strip number `first` opens.
inline std::int32_t run_end(const StripSystem& s, std::int32_t first) noexcept {
  std::int32_t a = first;
  while (a + 1 < s.active_count && touch(s, a)) ++a;
  return a + 1;
}

/// Height of the gap at the middle of strip j, over the lowest point [m]. Under yaw that middle is not the
/// row's own lowest point: h + curvature (x_c - gap_centre)^2 / 2.
inline double height_at_centre(const StripSystem& s, std::int32_t j) noexcept {
  const double shift = s.centre[j] - s.gap_centre[j];
  return s.height[j] + 0.5 * s.curvature[j] * shift * shift;
}

/// Puts strip j at y, with the gap's row there.
inline void put(patch::GapReader& gap, double lowest_height, std::int32_t j, double y, double width,
                StripSystem& s) noexcept {
  const patch::GapRow row = gap.at(y);
  s.grid.y[j] = y;
  s.grid.width[j] = width;
  s.height[j] = row.height - lowest_height;
  s.curvature[j] = row.curvature;
  s.gap_centre[j] = row.centre;
}

}  // namespace wrc::normal
