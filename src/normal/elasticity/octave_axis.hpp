/// Functions of a positive number over many orders of magnitude, as polynomials between nodes at equal
/// distances within each octave: the node is read off the bits of the number, no logarithm is taken.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "base/bits.hpp"
#include "base/elementary.hpp"

namespace wrc::normal {

/// Nodes x > 0 at equal distances within each octave.
struct OctaveAxis {
  int lowest_exponent;  ///< exponent of the first octave: x starts at 2^lowest_exponent
  int octaves;
  int bits_per_octave;  ///< 2^bits intervals in each octave

  WRC_IN_LOOP constexpr int intervals() const { return octaves << bits_per_octave; }

  /// Node i = 0 .. intervals(), and its bits.
  constexpr double node(int i) const {
    const int within = i & ((1 << bits_per_octave) - 1);
    return power_of_two(lowest_exponent + (i >> bits_per_octave)) *
           (1.0 + within * power_of_two(-bits_per_octave));
  }
  WRC_IN_LOOP constexpr std::uint64_t node_bits(int i) const {
    const auto octave = static_cast<std::int64_t>(i >> bits_per_octave);
    const auto within = static_cast<std::int64_t>(i & ((1 << bits_per_octave) - 1));
    return static_cast<std::uint64_t>((exponent_bias + lowest_exponent + octave) << mantissa_bits |
                                      within << (mantissa_bits - bits_per_octave));
  }

  /// Interval that holds x, and where in it x lies (0..1). x outside the axis is taken to its ends.
  struct Place {
    std::int64_t index;
    double fraction;
  };
  Place locate(double x) const noexcept {
    // The leading bits of x, less those of the first node, count the intervals; the rest is the fraction.
    const std::int64_t first = (exponent_bias + lowest_exponent) << bits_per_octave;
    const int shift = mantissa_bits - bits_per_octave;
    const auto bits = static_cast<std::int64_t>(bits_of(x));
    const std::int64_t index = (bits >> shift) - first;
    if (index < 0) return {0, 0.0};
    if (index >= intervals()) return {intervals() - 1, 1.0};
    const std::int64_t rest = bits & ((std::int64_t{1} << shift) - 1);
    return {index, static_cast<double>(rest) * power_of_two(-shift)};
  }

 private:
  static constexpr int mantissa_bits = 52;
  static constexpr std::int64_t exponent_bias = 1023;
};

/// Nodes x > 0 evenly in log(x), eight in each octave. The place of a quotient is the difference of two
/// places. Without a logarithm, x = 2^e (1 + t), 0 <= t < 1, is placed e + t (c1 + t (c2 + t (c3 + t c4)))
/// octaves from x = 1, to a thousandth of an interval: the polynomial is 1 at t = 1 and half as steep as at t
/// = 0, so that value and slope do not jump from octave to octave. Functions of the logarithm of x are nearly
/// straight between these nodes, and half as many of them suffice as on an OctaveAxis.
struct LogAxis {
  static constexpr int per_octave = 8;

  int lowest_exponent;  ///< exponent of the first octave: x starts at 2^lowest_exponent
  int octaves;

  WRC_IN_LOOP constexpr int intervals() const { return octaves * per_octave; }

  /// The least number of the axis, and one that lies on it and near its end.
  constexpr double low() const { return power_of_two(lowest_exponent); }
  constexpr double high() const { return power_of_two(lowest_exponent + octaves) * (1.0 - 0x1p-20); }
  /// The place of `high`, and that of x = 1.
  constexpr double last() const { return intervals() * (1.0 - 0x1p-28); }
  constexpr double origin() const { return -per_octave * lowest_exponent; }

  /// c1 .. c4 in intervals.
  static constexpr double first = per_octave * 1.438, second = per_octave * -0.674,
                          third = per_octave * 0.315, fourth = per_octave * -0.079;

  /// Place of x, in intervals from the first node. x outside the axis is taken to its ends.
  double place(double x) const noexcept {
    const double inside = x > low() ? (x < high() ? x : high()) : low();
    const std::uint64_t bits = bits_of(inside);
    // x = 2^e (1 + t).
    const auto exponent = static_cast<int>(bits >> mantissa_bits) - exponent_bias;
    const double t = number_of((bits & mantissa) | one) - 1.0;
    return per_octave * (exponent - lowest_exponent) + t * (first + t * (second + t * (third + t * fourth)));
  }

  /// The x at a node, which may be outside the axis.
  double node(int i) const noexcept {
    // 2^octave times the rest of an octave; i may be negative, and the octave is rounded down.
    const int octave = i >= 0 ? i / per_octave : -((per_octave - 1 - i) / per_octave);
    return power_of_two(lowest_exponent + octave) *
           natural_exp((i - per_octave * octave) * (ln2_high + ln2_low) / per_octave);
  }

 private:
  static constexpr int mantissa_bits = 52, exponent_bias = 1023;
  static constexpr std::uint64_t mantissa = (std::uint64_t{1} << mantissa_bits) - 1;
  static constexpr std::uint64_t one = std::uint64_t{exponent_bias} << mantissa_bits;  // the bits of 1
};

/// Distances from a line of semi-elliptic pressure, over its half length: 1e-6 .. 256.
inline constexpr OctaveAxis line_axis{-20, 28, 4};

/// A cubic over one interval, t = 0..1 across it.
struct Cubic {
  double c0 = 0.0, c1 = 0.0, c2 = 0.0, c3 = 0.0;
  constexpr double at(double t) const { return c0 + t * (c1 + t * (c2 + t * c3)); }
};

/// A value and its derivative.
struct Slope {
  double value = 0.0, derivative = 0.0;
};

/// The cubic with these values and derivatives at the ends of an interval of this length.
constexpr Cubic hermite_cubic(Slope from, Slope to, double length) {
  // h(0), h(1) and the slopes m0, m1 by t = 0..1.
  const double m0 = from.derivative * length, m1 = to.derivative * length;
  const double rise = to.value - from.value;
  return {from.value, m0, 3.0 * rise - 2.0 * m0 - m1, m0 + m1 - 2.0 * rise};
}

}  // namespace wrc::normal
