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
  if (which == Array::workspace)
    return doubles(std::max(sizes.stage_workspace_bytes, sizes.surface_workspace_bytes));
  if (which <= Array::slip_y || which == Array::temperature_rise)
    return strips * static_cast<std::size_t>(sizes.cells);
  if (which >= Array::gap_y && which <= Array::gap_curvature) return static_cast<std::size_t>(sizes.gap_rows);
  return strips;
}

std::size_t rounded_up(std::size_t bytes) {
  return (bytes + block_alignment - 1) / block_alignment * block_alignment;
}

}  // namespace

static_assert(static_cast<std::size_t>(Array::workspace) + 1 == array_count, "it lies behind all others");

ArrayLayout lay_out(const ArraySizes& sizes, std::size_t header_bytes) {
  // Each array begins on a cache line; the work space, which is no part of the state, comes last and is not
  // counted.
  ArrayLayout layout;
  std::size_t at = rounded_up(header_bytes);
  for (std::size_t i = 0; i < array_count; ++i) {
    layout.offset[i] = at;
    const std::size_t bytes = rounded_up(length(static_cast<Array>(i), sizes) * sizeof(double));
    if (static_cast<Array>(i) == Array::workspace) {
      layout.behind = bytes;
    } else {
      at += bytes;
    }
  }
  layout.bytes = at;
  return layout;
}

}  // namespace wrc::contact
