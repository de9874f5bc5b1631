/// Natural cubic splines.
#pragma once

#include <cstdint>

namespace wrc {

/// Second derivatives of the natural spline through (s, v) at its n knots, by Thomas's elimination; `c` is
/// scratch, as long as the others.
inline void second_derivatives(std::int32_t n, const double* s, const double* v, double* second, double* c) {
  second[0] = c[0] = 0.0;
  for (std::int32_t i = 1; i + 1 < n; ++i) {
    const double h0 = s[i] - s[i - 1], h1 = s[i + 1] - s[i];
    const double rhs = 6.0 * ((v[i + 1] - v[i]) / h1 - (v[i] - v[i - 1]) / h0);
    const double pivot = 2.0 * (h0 + h1) - h0 * c[i - 1];
    c[i] = h1 / pivot;
    second[i] = (rhs - h0 * second[i - 1]) / pivot;
  }
  second[n - 1] = 0.0;
  for (std::int32_t i = n - 2; i > 0; --i) second[i] -= c[i] * second[i + 1];
}

}  // namespace wrc
