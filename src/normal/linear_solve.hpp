/// Dense linear equations with two right-hand sides, for influence matrices.
#pragma once

#include <cstdint>

namespace wrc {

/// Solves A x = r and A x = s in place by elimination without pivoting: the influence of a strip is largest
/// on itself, the matrix close to symmetric and positive definite. `matrix` is n x n by rows and destroyed; r
/// and s become the solutions.
inline void solve_two(std::int32_t n, double* matrix, double* r, double* s) noexcept {
  for (std::int32_t k = 0; k < n; ++k) {
    const double* const pivot_row = matrix + static_cast<std::int64_t>(k) * n;
    const double inverse = 1.0 / pivot_row[k];
    for (std::int32_t i = k + 1; i < n; ++i) {
      double* const row = matrix + static_cast<std::int64_t>(i) * n;
      const double factor = row[k] * inverse;
      for (std::int32_t j = k + 1; j < n; ++j) row[j] -= factor * pivot_row[j];
      r[i] -= factor * r[k];
      s[i] -= factor * s[k];
    }
  }
  for (std::int32_t i = n - 1; i >= 0; --i) {
    const double* const row = matrix + static_cast<std::int64_t>(i) * n;
    double sum_r = r[i], sum_s = s[i];
    for (std::int32_t j = i + 1; j < n; ++j) {
      sum_r -= row[j] * r[j];
      sum_s -= row[j] * s[j];
    }
    r[i] = sum_r / row[i];
    s[i] = sum_s / row[i];
  }
}

}  // namespace wrc
