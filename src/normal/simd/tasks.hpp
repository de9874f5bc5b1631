/// Arguments of the kernels of normal contact: plain data, no constructors.
#pragma once

#include <cstdint>

#include "patch/gap.hpp"

namespace wrc::simd {

/// The widest pack of any instruction set. Kernels read whole packs: their arrays have memory, and
/// harmless numbers, up to the next multiple of this.
inline constexpr std::int32_t most_lanes = 16;

/// `count` rounded up to whole packs.
constexpr std::int64_t whole_packs(std::int64_t count) {
  return (count + most_lanes - 1) / most_lanes * most_lanes;
}

/// Tables of the influence function (influence_tables.hpp).
struct StripTables {
  const double *on_middle_plane, *edge_under, *anywhere;
};

/// Strips seen from the middle of one of them; arrays over all strips of the grid.
struct InfluenceTask {
  StripTables tables;
  std::int32_t count;
  const double *y, *width, *centre, *inverse_length;
  bool skewed;  ///< the centres are not all the same
};

/// Empty strips that an array of sources has on both sides: edges are taken a pack at a time, and reach from
/// each of them equally far.
inline constexpr std::int32_t beyond_sources = most_lanes + 8;

/// Lines of semi-elliptic pressure. Each array has beyond_sources zeros before its first element and behind
/// its last.
struct Sources {
  double *y, *centre;      ///< place [m]
  double* inverse_length;  ///< inverse of the half length [1/m]
  double* line_load;       ///< peak times width [N/m]
};

/// Edges of strips seen by the strips near to them, and by pairs of the strips farther away.
struct EdgeTask {
  StripTables tables;
  std::int32_t count;
  Sources strips;  ///< number 0 .. count - 1
  /// Pair k joins strips k and k + 1. Number -1 is the first strip alone, number count - 1 the last.
  Sources pairs;
  const double *x, *y;       ///< the edges
  const double* half_width;  ///< half widths of the strips over their half lengths
  double* displacement;      ///< found at the edges, over the compliance [m Pa]
};

/// Equations A x = r, A x = s: the rows of A, rows and columns filled up to `size`, a multiple of four, by
/// those of the unit matrix; each row is followed by its element of r and that of s. Or, where neither is
/// asked for, by as many right-hand sides as the stride holds, for the caller to substitute back: the
/// rows are left as those of a triangle, the inverses of the pivots on its diagonal.
///
/// Where there is memory for `places` rows alone, `rows` brings those from `first` to `end`, which those
/// before eliminate. First come `places` rows, in their places, then some at a time. These go where rows far
/// above have no columns left. With the last one the solutions are found. All but the last `end` are
/// multiples of eight.
struct EliminationTask {
  std::int32_t size;
  std::int64_t stride;     ///< from row to row, whole groups of eight; with r and s elimination_stride(size)
  double* matrix;          ///< destroyed
  double *r, *s;           ///< the solutions, `stride` elements each; s nullptr: of r alone; or both nullptr
  double* rows = nullptr;  ///< nullptr: all rows, in their places
  std::int32_t first = 0, end = 0, places = 0;
};

/// Fewest places that hold the rows of a triangle.
constexpr std::int32_t least_places(std::int32_t size) { return ((size + 7) / 8 + 3) / 2 * 8; }

/// A virtual penetration (penetration.hpp): the scale, a parabola over y, and the span where it leaves an
/// overlap, divided into `count` strips of `width`.
struct SpanTask {
  const patch::GapRows& rows;
  double lowest_height, approach;
  double scale_at_centre, scale_bend, scale_centre;
  double y_from, width;
  std::int32_t first_interval;  ///< between the rows, that holds y_from
  std::int32_t count;
};

/// Arrays of strips; no more than their `count` elements are touched.
struct StripArrays {
  double *y, *width, *centre, *half_length;
};

/// A point that sees strips of semi-elliptic pressure.
struct PointTask {
  const double* line_cubics;  ///< line_displacement over line_axis, four coefficients each interval
  double x, y;
  std::int32_t count;
};

/// Whole groups of eight columns.
constexpr std::int64_t elimination_stride(std::int32_t size) { return (size + 2 + 7) / 8 * 8; }

}  // namespace wrc::simd
