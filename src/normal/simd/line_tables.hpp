/// The tables of influence_tables.hpp read for a pack of places at once.
#pragma once

#include "base/pack.hpp"
#include "normal/elasticity/influence_tables.hpp"
#include "normal/simd/tasks.hpp"

namespace wrc::simd {
namespace {

/// Intervals of an axis, and where in them the numbers lie (0..1).
struct Places {
  Pack interval;  ///< whole numbers
  Pack fraction;
};

/// OctaveAxis::locate. Numbers outside the axis, and what is no number, are taken to its ends: an index is
/// valid whatever comes in.
template <int lowest_exponent, int octaves, int bits_per_octave>
Places locate(Pack x) {
  constexpr OctaveAxis axis{lowest_exponent, octaves, bits_per_octave};
  constexpr std::uint64_t first = std::bit_cast<std::uint64_t>(axis.node(0));
  constexpr std::uint64_t end = std::bit_cast<std::uint64_t>(axis.node(axis.intervals()));
  constexpr double low = axis.node(0), high = std::bit_cast<double>(end - 1);
  constexpr int mantissa_bits = 52, shift = mantissa_bits - axis.bits_per_octave;
  constexpr std::uint64_t mantissa = (std::uint64_t{1} << mantissa_bits) - 1;
  constexpr std::uint64_t one = std::uint64_t{1023} << mantissa_bits;
  // Behind the exponent of 2^52, where the double spacing is one, a whole number is its own mantissa.
  constexpr std::uint64_t unit_spacing = std::uint64_t{1023 + mantissa_bits} << mantissa_bits;
  const Bits bits = bits_of(smaller(larger(x, low), high));
  return {pack_of((bits >> shift) + (unit_spacing - (first >> shift))) - 4503599627370496.0,
          pack_of(((bits << axis.bits_per_octave) & mantissa) + one) - 1.0};
}

/// A table over the distance axis.
inline Pack read(const double* table, Pack tau) {
  constexpr OctaveAxis axis = InfluenceTables::distance_axis;
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

inline MiddlePlane<Pack> read_middle_plane(const StripTables& tables, Pack tau) {
  constexpr OctaveAxis axis = InfluenceTables::distance_axis;
  const Places place = locate<axis.lowest_exponent, axis.octaves, axis.bits_per_octave>(tau);
  const Neighbours twins = pick(tables.on_middle_plane, indices(place.interval));
  const auto between = [&](Pack at, Pack behind) { return at + place.fraction * (behind - at); };
  return {between(first_of(twins.at), first_of(twins.behind)),
          between(second_of(twins.at), second_of(twins.behind))};
}

/// J(tau, xi) for xi mostly near 0: the middle plane's with the leading effects of xi, which are right both
/// near the line, sqrt(1 - xi^2), and far from it, 1 / sqrt(tau^2 + xi^2). y = xi^2 / (1 + tau^2),
/// towards_line = 1 / (1 + tau^2); to 4e-4 where y < 0.1. The last three numbers are fitted to J.
template <class Number>
WRC_IN_LOOP Number near_middle_plane(const Number& potential, const Number& towards_line, const Number& y) {
  return potential * (1.0 - y * (0.5 - y * (0.355 - towards_line * (0.237 + 0.218 * towards_line))));
}

/// How much of J(tau, xi) is read from the table instead: both hold where one goes over into the other.
constexpr double beside_middle_plane = 0.06, off_middle_plane = 0.12;
template <class Number>
WRC_IN_LOOP Number part_off_middle_plane(const Number& y) {
  return smaller(larger(1.0 / (off_middle_plane - beside_middle_plane) * (y - beside_middle_plane), 0.0),
                 1.0);
}

/// What the width of a strip adds to the displacement by the line in its middle: the midpoint error of a
/// logarithm, see strip_displacement (contact_condition.cpp), with t = half the width over the distance.
template <class Number>
WRC_IN_LOOP Number width_correction(const Number& t, const Number& inverse_to_end) {
  const Number t2 = t * t;
  return 2.0 * (t2 * inverse_to_end) * (1.0 / 6.0 + t2 * (1.0 / 20.0 + 1.0 / 42.0 * t2));
}

/// EvenAxis::place, and where between octaves that is.
struct EvenPlaces {
  Pack place;
  Pack within;  ///< t
};

template <int lowest_exponent, int octaves, bool cubic, bool from_low = false>
EvenPlaces even_places(Pack x) {
  constexpr EvenAxis axis{lowest_exponent, octaves, cubic};
  constexpr double first = axis.first(), second = axis.second(), third = axis.third();
  static_assert(EvenAxis::per_octave == 8);
  constexpr int mantissa_bits = 52;
  constexpr double low = axis.low(), high = axis.high();
  constexpr std::uint64_t mantissa = (std::uint64_t{1} << mantissa_bits) - 1;
  constexpr std::uint64_t one = std::uint64_t{1023} << mantissa_bits;
  // Behind the exponent of 2^55 the double spacing is eight: the mantissa counts octaves.
  constexpr std::uint64_t spacing_eight = std::uint64_t{1023 + mantissa_bits + 3} << mantissa_bits;
  const Bits bits = bits_of(smaller(from_low ? x : larger(x, low), high));
  const Pack octaves_of_eight =
      pack_of((bits >> mantissa_bits) +
              (spacing_eight - static_cast<std::uint64_t>(1023 + lowest_exponent))) -
      0x1p55;
  const Pack t = pack_of((bits & mantissa) + one) - 1.0;
  const Pack bend = cubic ? second + t * third : Pack(second);
  return {octaves_of_eight + t * (first + t * bend), t};
}

/// Rows of InfluenceTables::anywhere.
struct LineRows {
  Pack first_cell;  ///< index of it in the table
  Pack fraction;    ///< of the way to the next row
};

inline LineRows line_rows_of(Pack place) {
  const Pack row = whole_part(place);
  return {row * static_cast<double>(InfluenceTables::columns) + index_origin, place - row};
}
inline LineRows line_rows(Pack tau) {
  constexpr EvenAxis axis = InfluenceTables::line_rows;
  return line_rows_of(even_places<axis.lowest_exponent, axis.octaves, axis.cubic>(tau).place);
}

/// Where the table is between two columns: J in both, as far between the rows as wanted.
struct BetweenColumns {
  Pack here, rise;            ///< to the next column
  Pack here_rise, next_rise;  ///< of both to the next row
  Pack fraction;              ///< of the way to the next column
};

/// xi - 1 >= -1, and the place of |xi - 1| + from_end.low() on the columns' axis.
WRC_IN_LOOP BetweenColumns between_columns(const StripTables& tables, const LineRows& rows, Pack from_end,
                                           Pack place_from_end) {
  const Pack place = static_cast<double>(InfluenceTables::to_middle) + with_sign(place_from_end, from_end);
  const Pack column = whole_part(place);
  const Neighbours cell = pick(tables.anywhere, indices_behind_origin(rows.first_cell + column));
  const Pack here = first_of(cell.at), next = first_of(cell.behind);
  const Pack here_rise = second_of(cell.at) - here, next_rise = second_of(cell.behind) - next;
  const Pack at_here = here + rows.fraction * here_rise;
  return {at_here, next + rows.fraction * next_rise - at_here, here_rise, next_rise, place - column};
}

/// InfluenceTables::at: J(tau, xi), xi >= 0, at line_rows(tau).
WRC_IN_LOOP Pack line_potential_at(const StripTables& tables, const LineRows& rows, Pack xi) {
  constexpr EvenAxis axis = InfluenceTables::from_end;
  constexpr double least = axis.low();
  const Pack from_end = xi - 1.0;
  const Pack place =
      even_places<axis.lowest_exponent, axis.octaves, axis.cubic, true>(magnitude(from_end) + least).place;
  const BetweenColumns j = between_columns(tables, rows, from_end, place);
  return j.here + j.fraction * j.rise;
}
WRC_IN_LOOP Pack line_potential_at(const StripTables& tables, Pack tau, Pack xi) {
  return line_potential_at(tables, line_rows(tau), xi);
}

/// J(tau, xi) for xi mostly near 0.
inline Pack line_potential_near(const StripTables& tables, const MiddlePlane<Pack>& middle, Pack tau,
                                Pack xi) {
  const Pack towards_line = middle.inverse_to_end * middle.inverse_to_end;
  const Pack y = xi * xi * towards_line;
  const Pack near = near_middle_plane(middle.potential, towards_line, y);
  if (!any(y > beside_middle_plane)) return near;
  return near + part_off_middle_plane(y) * (line_potential_at(tables, tau, xi) - near);
}

}  // namespace
}  // namespace wrc::simd
