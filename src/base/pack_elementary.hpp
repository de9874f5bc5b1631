/// Logarithm and arctangent of packs (base/pack.hpp), to 1e-10: for sums over a field, not for single
/// numbers. Their bits are the same with every instruction set; they are not those of base/elementary.hpp.
#pragma once

#include "base/elementary.hpp"
#include "base/pack.hpp"

namespace wrc::simd {
namespace {

/// ln(x) for normal x > 0: relative error at most 2e-11, next to 1 absolute.
inline Pack natural_log(Pack x) {
  constexpr std::uint64_t mantissa = (std::uint64_t{1} << 52) - 1;
  const Bits bits = bits_of(x);
  // The exponent behind the leading one of 2^52 is a whole number above it.
  Pack octaves = pack_of((bits >> 52) + 0x4330000000000000ull) - Pack(4503599627370496.0 + 1023.0);
  Pack m = pack_of((bits & mantissa) + 0x3ff0000000000000ull);
  const Mask high = m > Pack(1.41421356237309504880);
  m = select(high, Pack(0.5) * m, m);
  octaves = select(high, octaves + Pack(1.0), octaves);
  // 2 artanh(s), s = (m - 1) / (m + 1), at most 0.172
  const Pack s = (m - Pack(1.0)) / (m + Pack(1.0)), s2 = s * s;
  Pack series = 1.0 / 15.0;
  series = Pack(1.0 / 13.0) + s2 * series;
  series = Pack(1.0 / 11.0) + s2 * series;
  series = Pack(1.0 / 9.0) + s2 * series;
  series = Pack(1.0 / 7.0) + s2 * series;
  series = Pack(1.0 / 5.0) + s2 * series;
  series = Pack(1.0 / 3.0) + s2 * series;
  return octaves * Pack(ln2_high + ln2_low) + Pack(2.0) * (s + s * (s2 * series));
}

/// atan(x) [rad], any x: error at most 1e-10.
inline Pack arctangent(Pack x) {
  // atan(x) = pi/4 + atan((x - 1) / (x + 1)) = pi/2 - atan(1 / x): the remaining argument is at most
  // tan(pi/8).
  const Pack size = magnitude(x), one = 1.0;
  const Mask large = size > Pack(2.41421356237309504880), middle = size > Pack(0.41421356237309504880);
  const Pack t = select(large, -one, select(middle, size - one, size)) /
                 select(large, size, select(middle, size + one, one));
  const Pack offset = select(large, Pack(0.5 * pi), select(middle, Pack(0.25 * pi), Pack(0.0)));
  const Pack t2 = t * t;
  Pack series = 1.0 / 23.0;
  series = Pack(1.0 / 21.0) - t2 * series;
  series = Pack(1.0 / 19.0) - t2 * series;
  series = Pack(1.0 / 17.0) - t2 * series;
  series = Pack(1.0 / 15.0) - t2 * series;
  series = Pack(1.0 / 13.0) - t2 * series;
  series = Pack(1.0 / 11.0) - t2 * series;
  series = Pack(1.0 / 9.0) - t2 * series;
  series = Pack(1.0 / 7.0) - t2 * series;
  series = Pack(1.0 / 5.0) - t2 * series;
  series = Pack(1.0 / 3.0) - t2 * series;
  const Pack angle = offset + (t - t * (t2 * series));
  return select(x < Pack(0.0), -angle, angle);
}

}  // namespace
}  // namespace wrc::simd
