/// The tables of influence_tables.hpp read for a pack of places at once.
#pragma once

#include "base/bits.hpp"
#include "base/pack.hpp"
#include "normal/elasticity/influence_tables.hpp"
#include "normal/simd/tasks.hpp"

namespace wrc::simd {
namespace {

/// Intervals of an axis, and where in them the numbers lie (0..1).
struct Places {
  Bits interval;  ///< in the lower halves
  Pack fraction;
};

/// OctaveAxis::locate. Numbers outside the axis, and NaN, are taken to its ends: an index is valid for any
/// input.
template <int lowest_exponent, int octaves, int bits_per_octave>
Places locate(Pack x) {
  constexpr normal::OctaveAxis axis{lowest_exponent, octaves, bits_per_octave};
  constexpr std::uint64_t first = axis.node_bits(0);
  constexpr double low = axis.node(0);
  const double high = number_of(axis.node_bits(axis.intervals()) - 1);
  constexpr int mantissa_bits = 52, shift = mantissa_bits - axis.bits_per_octave;
  constexpr std::uint64_t mantissa = (std::uint64_t{1} << mantissa_bits) - 1;
  constexpr std::uint64_t one = std::uint64_t{1023} << mantissa_bits;
  // The leading bits count intervals; those behind, as a mantissa of 1..2, are the fraction.
  const Bits bits = bits_of(smaller(larger(x, low), high));
  return {(bits >> shift) + (0 - (first >> shift)),
          pack_of(((bits << axis.bits_per_octave) & mantissa) | one) - 1.0};
}

/// A table over the distance axis.
inline Pack read(const double* table, Pack tau) {
  constexpr normal::OctaveAxis axis = normal::InfluenceTables::distance_axis;
  const Places place = locate<axis.lowest_exponent, axis.octaves, axis.bits_per_octave>(tau);
  const Neighbours value = pick(table, indices(place.interval));
  return value.at + place.fraction * (value.behind - value.at);
}

/// The two numbers in each place of a table of twins (influence_tables.hpp).
inline Pack first_of(Pack twin) { return pack_of(bits_of(twin) << 32); }
inline Pack second_of(Pack twin) { return pack_of(bits_of(twin) & ~std::uint64_t{0xffffffff}); }

/// A line seen from its middle plane: J(tau, 0), and over its half length the inverse of the distance to its
/// ends.
template <class Number>
struct MiddlePlane {
  Number potential, inverse_to_end;
};

/// Cells of their table; to be found for several places before any is read, so that none waits for its
/// index.
struct MiddlePlaneCells {
  Indices first;
  Pack fraction;  ///< share of the way to the next
};

WRC_IN_LOOP void find_cells(Pack tau, MiddlePlaneCells& cells) {
  constexpr normal::OctaveAxis axis = normal::InfluenceTables::distance_axis;
  const Places place = locate<axis.lowest_exponent, axis.octaves, axis.bits_per_octave>(tau);
  keep_indices(place.interval, cells.first);
  cells.fraction = place.fraction;
}

WRC_IN_LOOP MiddlePlane<Pack> read_middle_plane(const StripTables& tables, const MiddlePlaneCells& cells) {
  const Neighbours twins = pick(tables.on_middle_plane, cells.first);
  const auto between = [&](Pack at, Pack behind) { return at + cells.fraction * (behind - at); };
  return {between(first_of(twins.at), first_of(twins.behind)),
          between(second_of(twins.at), second_of(twins.behind))};
}

inline MiddlePlane<Pack> read_middle_plane(const StripTables& tables, Pack tau) {
  MiddlePlaneCells cells;
  find_cells(tau, cells);
  by_way_of_memory(cells.first);
  return read_middle_plane(tables, cells);
}

/// J(tau, xi) for xi mostly near 0: the middle plane's with the leading effects of xi, which are right both
/// near the line, sqrt(1 - xi^2), and far from it, 1 / sqrt(tau^2 + xi^2). y = xi^2 / (1 + tau^2),
/// towards_line = 1 / (1 + tau^2); to 4e-4 where y < 0.1. The last three numbers are fitted to J.
template <class Plane, class Number>
WRC_IN_LOOP Number near_middle_plane(const Plane& potential, const Plane& towards_line, const Number& y) {
  return potential * (1.0 - y * (0.5 - y * (0.355 - towards_line * (0.237 + 0.218 * towards_line))));
}

/// Part of J(tau, xi) that is read from the table instead [-]: both hold in the transition.
constexpr double beside_middle_plane = 0.06, off_middle_plane = 0.12;
template <class Number>
WRC_IN_LOOP Number part_off_middle_plane(const Number& y) {
  return smaller(larger(1.0 / (off_middle_plane - beside_middle_plane) * (y - beside_middle_plane), 0.0),
                 1.0);
}

/// Correction of the displacement by the line in a strip's middle for the strip's width: the midpoint error
/// of a logarithm, see strip_displacement (contact_condition.cpp), with t = half the width over the distance.
template <class Number>
WRC_IN_LOOP Number width_correction(const Number& t, const Number& inverse_to_end) {
  const Number t2 = t * t;
  return 2.0 * (t2 * inverse_to_end) * (1.0 / 6.0 + t2 * (1.0 / 20.0 + 1.0 / 42.0 * t2));
}

/// Rows of InfluenceTables::anywhere.
struct LineRows {
  Bits first_cell;  ///< index of it in the table, in the lower halves
  Pack fraction;    ///< share of the way to the next row
};

/// At places on the rows' axis; those outside are taken to its ends.
inline LineRows line_rows_at(Pack place) {
  constexpr double last = normal::InfluenceTables::line_rows.last();
  // The whole part selects the row; adding index_origin puts it into the lower bits.
  const Pack inside = smaller(larger(place, 0.0), last);
  const Pack row = whole_part(inside);
  return {bits_of(row * static_cast<double>(normal::InfluenceTables::columns) + index_origin), inside - row};
}

/// x > 0 in octaves from 1 on: see LogAxis.
struct Octaves {
  Pack whole;   ///< times eight
  Pack within;  ///< t
};

inline Octaves octaves_of(Pack x) {
  constexpr int mantissa_bits = 52;
  constexpr std::uint64_t mantissa = (std::uint64_t{1} << mantissa_bits) - 1;
  constexpr std::uint64_t one = std::uint64_t{1023} << mantissa_bits;
  // Behind the exponent of 2^55 the double spacing is eight: the mantissa counts octaves.
  constexpr std::uint64_t spacing_eight = std::uint64_t{1023 + mantissa_bits + 3} << mantissa_bits;
  const Bits bits = bits_of(x);
  return {pack_of((bits >> mantissa_bits) + spacing_eight) - (0x1p55 + 8.0 * 1023),
          pack_of((bits & mantissa) | one) - 1.0};
}

/// The place on any LogAxis, from x = 1 on; that of a quotient is the difference of two.
inline Pack place_from_one(Pack x) {
  static_assert(normal::LogAxis::per_octave == 8);
  const Octaves o = octaves_of(x);
  const Pack t = o.within;
  return o.whole +
         t * (normal::LogAxis::first +
              t * (normal::LogAxis::second + t * (normal::LogAxis::third + t * normal::LogAxis::fourth)));
}

inline LineRows line_rows(Pack tau) {
  constexpr double origin = normal::InfluenceTables::line_rows.origin();
  return line_rows_at(place_from_one(tau) + origin);
}

/// J in two neighbouring columns, interpolated between the rows.
struct BetweenColumns {
  Pack here, rise;            ///< to the next column, away from the line's end
  Pack here_rise, next_rise;  ///< rise of both to the next row
  Pack fraction;              ///< share of the way to the next column
};

/// Cells of that table, as MiddlePlaneCells.
struct LineCells {
  Indices first;
  Pack fraction, row_fraction;  ///< share of the way to the next column, to the next row
};

/// xi - 1 >= -1.
WRC_IN_LOOP void find_cells(const LineRows& rows, Pack from_end, LineCells& cells) {
  constexpr normal::OctaveAxis axis = normal::InfluenceTables::from_end;
  constexpr int mantissa_bits = 52;
  constexpr std::uint64_t first = axis.node_bits(0);
  constexpr double least = axis.node(0);
  const double high = number_of(axis.node_bits(axis.intervals()) - 1);
  constexpr int shift = mantissa_bits - axis.bits_per_octave;
  constexpr std::uint64_t mantissa = (std::uint64_t{1} << mantissa_bits) - 1;
  constexpr std::uint64_t one = std::uint64_t{1023} << mantissa_bits;
  constexpr std::uint64_t outside = (0 - (first >> shift)) & 0xffffffff;  // indices are the lower halves
  constexpr std::uint64_t inside = outside + normal::InfluenceTables::inside;
  const double outside_bits = number_of(outside), inside_bits = number_of(inside);
  // Row, side of the line's end, and interval of the distance from it add up to the cell.
  const Bits bits = bits_of(smaller(magnitude(from_end) + least, high));
  const Bits side = bits_of(select(from_end < 0.0, inside_bits, outside_bits));
  keep_indices((bits >> shift) + side + rows.first_cell, cells.first);
  cells.fraction = pack_of(((bits << axis.bits_per_octave) & mantissa) | one) - 1.0;
  cells.row_fraction = rows.fraction;
}

WRC_IN_LOOP BetweenColumns between_columns(const StripTables& tables, const LineCells& cells) {
  const Neighbours cell = pick(tables.anywhere, cells.first);
  // Bilinear, as InfluenceTables::at.
  const Pack here = first_of(cell.at), next = first_of(cell.behind);
  const Pack here_rise = second_of(cell.at) - here, next_rise = second_of(cell.behind) - next;
  const Pack at_here = here + cells.row_fraction * here_rise;
  return {at_here, next + cells.row_fraction * next_rise - at_here, here_rise, next_rise, cells.fraction};
}
WRC_IN_LOOP BetweenColumns between_columns(const StripTables& tables, const LineRows& rows, Pack from_end) {
  LineCells cells;
  find_cells(rows, from_end, cells);
  by_way_of_memory(cells.first);
  return between_columns(tables, cells);
}

/// InfluenceTables::at: J(tau, xi), xi >= 0, at line_rows(tau).
WRC_IN_LOOP Pack line_potential_at(const StripTables& tables, const LineRows& rows, Pack xi) {
  const BetweenColumns j = between_columns(tables, rows, xi - 1.0);
  return j.here + j.fraction * j.rise;
}

/// J(tau, xi) for xi mostly near 0; `rows` are asked for where the table is read.
template <class Rows>
WRC_IN_LOOP Pack line_potential_near(const StripTables& tables, const MiddlePlane<Pack>& middle, Pack xi,
                                     const Rows& rows) {
  // Near the middle plane by the fit; the table only if a lane of the pack needs it.
  const Pack towards_line = middle.inverse_to_end * middle.inverse_to_end;
  const Pack y = xi * xi * towards_line;
  const Pack near = near_middle_plane(middle.potential, towards_line, y);
  if (!any(y > beside_middle_plane)) return near;
  return near + part_off_middle_plane(y) * (line_potential_at(tables, rows(), xi) - near);
}

}  // namespace
}  // namespace wrc::simd
