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

/// InfluenceTables::at: J(tau, xi).
WRC_IN_LOOP Pack line_potential_at(const StripTables& tables, Pack tau, Pack xi) {
  const Pack tau2 = tau * tau;
  const Pack to_trailing = root((xi + 1.0) * (xi + 1.0) + tau2);
  const Pack to_leading = root((xi - 1.0) * (xi - 1.0) + tau2);
  const Pack one_minus_eta = 1.0 - 0.5 * magnitude(to_trailing - to_leading);
  constexpr OctaveAxis axis = InfluenceTables::chi_axis;
  const Places row = locate<axis.lowest_exponent, axis.octaves, axis.bits_per_octave>(
      0.5 * (to_trailing + to_leading) - 1.0);
  constexpr std::int32_t columns = InfluenceTables::eta_intervals;
  const Pack v = root(larger(one_minus_eta, 0.0)) * static_cast<double>(columns);
  const Pack column = smaller(whole_part(v), columns - 1.0);
  const Pack g = v - column;
  const Indices i = indices(row.interval * (columns + 1.0) + column);
  const Neighbours low = pick(tables.anywhere, i), high = pick(tables.anywhere + columns + 1, i);
  const Pack at_low = low.at + g * (low.behind - low.at);
  const Pack at_high = high.at + g * (high.behind - high.at);
  return at_low + row.fraction * (at_high - at_low);
}

}  // namespace
}  // namespace wrc::simd
