/// The strips of the half-space solver (strip_halfspace.hpp) while it works on them.
#pragma once

#include <cstdint>

#include "normal/simd/tasks.hpp"
#include "normal/strip_halfspace/collocation_grid.hpp"
#include "patch/gap.hpp"

namespace wrc {

/// Strips first .. first + count - 1 of the grid.
struct StripRange {
  std::int32_t first = 0, count = 0;
};

/// Arrays in the workspace, all with room for as many strips as the problem has, in whole packs; `grid.count`
/// are in use, and what the kernels read behind them is zero.
struct StripSystem {
  CollocationGrid grid;
  /// The strip as the grid has it; grid.y and grid.width of a patch's outermost strips are fitted to its
  /// border.
  double *cell_y = nullptr, *cell_width = nullptr;
  double* height = nullptr;     ///< over the lowest point [m]
  double* curvature = nullptr;  ///< d2h/dx2 [1/m]
  double* gap_centre = nullptr;
  double* half_length = nullptr;
  double* inverse_length = nullptr;
  double* centre = nullptr;
  double* peak = nullptr;
  std::int64_t influence_stride = 0;
  /// Row j column i: displacement at the middle of j by unit peak in i, over the compliance [m]. See
  /// row_known.
  double* influence = nullptr;
  double* matrix = nullptr;  ///< of the active strips, with the right-hand sides
  double* by_approach = nullptr;
  double* by_height = nullptr;
  double* level = nullptr;  ///< p / l the edge conditions ask for [Pa/m]
  double* shift = nullptr;  ///< of the centre against the gap's [m]
  simd::Sources sources{};  ///< the active strips
  simd::Sources
      pairs{};  ///< active strips number a and a + 1 joined; the outermost strips alone at both ends
  double* half_width = nullptr;                    ///< of the active strips, over their half length [-]
  double* edge = nullptr;                          ///< x of their edges [m]
  double *leading = nullptr, *trailing = nullptr;  ///< displacement there, over the compliance [m Pa]
  std::int32_t* active = nullptr;                  ///< indices of the strips in contact
  std::int32_t* next_active = nullptr;
  std::int32_t* row_known = nullptr;  ///< 1: row j of the influence belongs to the present lengths
  std::int32_t active_count = 0;
  StripRange in_reach;  ///< of the present sweep: in contact, or where contact is looked for
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

/// Height over the lowest point where strip j has its middle, beside the row's own lowest point under yaw
/// [m].
inline double height_at_centre(const StripSystem& s, std::int32_t j) noexcept {
  const double shift = s.centre[j] - s.gap_centre[j];
  return s.height[j] + 0.5 * s.curvature[j] * shift * shift;
}

/// Puts strip j at y, with the gap's row there.
inline void put(GapReader& gap, double lowest_height, std::int32_t j, double y, double width,
                StripSystem& s) noexcept {
  const GapRow row = gap.at(y);
  s.grid.y[j] = y;
  s.grid.width[j] = width;
  s.height[j] = row.height - lowest_height;
  s.curvature[j] = row.curvature;
  s.gap_centre[j] = row.centre;
}

}  // namespace wrc
