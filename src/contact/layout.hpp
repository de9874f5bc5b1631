/// Places of a contact's arrays inside its block of memory.
///
/// A contact is one relocatable block: a header of plain values, then arrays at offsets that the model fixes.
/// No pointer into the block is stored in it, so that saving and restoring a contact is a copy of bytes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace wrc::contact {

inline constexpr std::size_t block_alignment = 64;  ///< a cache line, and the widest vector

/// Every array a contact owns: over cells, over the strips of the normal problem and the rows of the gap,
/// then over the `region_` strips that rolled (the same values unless a variant replaces the patch by an
/// ellipse). Those from `cells_known` on lie behind the state, where copies of it go; so do those over cells,
/// unless a method remembers them.
enum class Array : std::size_t {
  traction_x,
  traction_y,
  slip_x,
  slip_y,
  strip_y,
  strip_width,
  strip_centre,
  strip_half,
  strip_peak,
  strip_power,
  gap_y,
  gap_height,
  gap_centre,
  gap_curvature,
  strip_friction,
  region_y,
  region_width,
  region_centre,
  region_half_length,
  region_peak,
  start_y,
  start_width,
  start_length_squared,
  start_shift,
  rolling_memory,
  surface_state,
  cells_known,       ///< one number: 1 where the arrays over cells are those of the last tangential stage
  workspace,         ///< for all solutions: nothing in it outlives a call
  temperature_rise,  ///< over cells, work space of the tangential stage
  count_
};

inline constexpr std::size_t array_count = static_cast<std::size_t>(Array::count_);

struct ArraySizes {
  std::int32_t strips = 0, cells = 0, gap_rows = 0;
  std::int64_t rolling_memory_bytes = 0, surface_state_bytes = 0;
  bool remembered_cells = false;  ///< cells of a method with memory, which are not found a second time
  std::int64_t stage_workspace_bytes = 0;    ///< work space of the stages, of which one at a time is at work
  std::int64_t surface_workspace_bytes = 0;  ///< the same of a wheel on a rail
};

struct ArrayLayout {
  std::array<std::size_t, array_count> offset{};  ///< bytes from the start of the contact block
  std::size_t bytes = 0;                          ///< bytes of the state, which is saved and restored
  std::size_t stages = 0;                         ///< bytes behind it that the stages need
  std::size_t behind = 0;                         ///< bytes behind it
};

/// Lays the arrays out behind a header of `header_bytes`, each on a cache line. Arrays over cells lie behind
/// the stages' work space, in that of a wheel: they are found again where they are lost (find_cells()).
ArrayLayout lay_out(const ArraySizes& sizes, std::size_t header_bytes);

}  // namespace wrc::contact
