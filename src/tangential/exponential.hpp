/// exp(-x) with the same bits on every machine; that of libm differs in its last bit between versions.
#pragma once

#include <cmath>

namespace wrc {

/// exp(-x) for x >= 0, within two units of the last place; 0 from x = 708 on.
inline double decaying_exponential(double x) {
  constexpr double log2_e = 1.4426950408889634;
  // ln 2 in two parts, the first with trailing zeros: k times it is exact.
  constexpr double ln2_high = 0x1.62e42fee00000p-1, ln2_low = 0x1.a39ef35793c76p-33;
  if (!(x < 708.0)) return 0.0;
  const double k = std::floor(x * log2_e + 0.5);
  const double r = k * ln2_low - (x - k * ln2_high);  // -x = -k ln 2 + r, |r| <= ln 2 / 2
  double sum = 1.0;
  for (int n = 13; n >= 1; --n) sum = 1.0 + r / n * sum;  // Taylor: the next term is below 1e-17
  return std::ldexp(sum, -static_cast<int>(k));
}

}  // namespace wrc
