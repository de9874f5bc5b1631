#include "contact/layout.hpp"

#include <algorithm>

namespace wrc::contact {
namespace {

/// Doubles that hold so many bytes.
std::size_t doubles(std::int64_t bytes) {
  return (static_cast<std::size_t>(bytes) + sizeof(double) - 1) / sizeof(double);
}

/// Elements of an array.
std::size_t length(Array which, const ArraySizes& sizes) {
  // Memory of the methods, in bytes; then arrays over cells, rows of the gap, and strips.
  const auto strips = static_cast<std::size_t>(sizes.strips);
  if (which == Array::rolling_memory) return doubles(sizes.rolling_memory_bytes);
  if (which == Array::surface_state) return doubles(sizes.surface_state_bytes);
  if (which == Array::workspace) return doubles(sizes.stage_workspace_bytes);
  if (which == Array::cells_known) return 1;
  if (which <= Array::slip_y || which == Array::temperature_rise)
    return strips * static_cast<std::size_t>(sizes.cells);
  if (which >= Array::gap_y && which <= Array::gap_curvature) return static_cast<std::size_t>(sizes.gap_rows);
  return strips;
}

std::size_t rounded_up(std::size_t bytes) {
  return (bytes + block_alignment - 1) / block_alignment * block_alignment;
}

}  // namespace

ArrayLayout lay_out(const ArraySizes& sizes, std::size_t header_bytes) {
  // Each array begins on a cache line.
  ArrayLayout layout;
  std::size_t at = rounded_up(header_bytes);
  const auto place = [&](Array first, Array end) {
    for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(end); ++i) {
      layout.offset[i] = at;
      at += rounded_up(length(static_cast<Array>(i), sizes) * sizeof(double));
    }
  };
  const auto place_cells = [&] { place(Array::traction_x, Array::strip_y); };

  // the state, then all that is no part of it
  if (sizes.remembered_cells) place_cells();
  place(Array::strip_y, Array::cells_known);
  layout.bytes = at;
  place(Array::cells_known, Array::count_);
  if (!sizes.remembered_cells) place_cells();
  layout.stages = at - layout.bytes;
  const auto wheel = static_cast<std::size_t>(sizes.surface_workspace_bytes);
  layout.behind = std::max(layout.stages, block_alignment + rounded_up(wheel));
  return layout;
}

}  // namespace wrc::contact
