/// The strips of the half-space solver (strip_halfspace.hpp) while it works on them.
#pragma once

#include <cstdint>

#include "normal/collocation_grid.hpp"
#include "patch/gap.hpp"

namespace wrc {

/// Arrays in the workspace, all with room for as many strips as the problem has; `grid.count` are in use.
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
  /// count x count, row j column i: displacement at the middle of j by unit peak in i, over the compliance
  /// [m]. Known where i and j are in contact.
  double* influence = nullptr;
  double* matrix = nullptr;  ///< of the active strips
  double* by_approach = nullptr;
  double* by_height = nullptr;
  double* level = nullptr;  ///< p / l the edge conditions ask for [Pa/m]
  double* shift = nullptr;  ///< of the centre against the gap's [m]
  /// Active strips number a and a + 1 joined, for all a.
  double *pair_y = nullptr, *pair_centre = nullptr, *pair_inverse_length = nullptr, *pair_strength = nullptr;
  std::int32_t* active = nullptr;  ///< indices of the strips in contact
  std::int32_t* next_active = nullptr;
  std::int32_t active_count = 0;
  bool skewed = false;  ///< the gap's centre line is not straight along y
};

/// The system in memory of strip_halfspace_workspace(capacity) bytes (strip_halfspace.hpp).
StripSystem lay_out_strips(void* memory, std::int32_t capacity) noexcept;

/// Bytes of that memory.
std::int64_t strip_system_bytes(std::int32_t capacity) noexcept;

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
