/// Dense linear equations with two right-hand sides, for influence matrices.
#pragma once

#include <cstdint>

namespace wrc {

/// Elements from row to row of an n x n matrix for solve_two: n rounded up to a multiple of four.
inline std::int64_t solve_stride(std::int32_t n) noexcept {
  return (static_cast<std::int64_t>(n) + 3) / 4 * 4;
}

/// Solves A x = r and A x = s in place by elimination without pivoting: the influence of a strip is largest
/// on itself, the matrix close to symmetric and positive definite. `matrix` has n rows, solve_stride(n)
/// apart, and is destroyed; r and s become the solutions.
///
/// Row by row, four pivot rows at a time, and columns in blocks of four: a row is read and written a quarter
/// as often, and the compiler has no odd ends to care for. What stands beyond column n is set to zero.
inline void solve_two(std::int32_t n, double* matrix, double* r, double* s) noexcept {
  const std::int64_t stride = solve_stride(n);
  const auto row_of = [&](std::int32_t i) { return matrix + i * stride; };
  for (std::int32_t i = 0; i < n; ++i) {
    double* __restrict const row = row_of(i);
    for (std::int64_t j = n; j < stride; ++j) row[j] = 0.0;
    double r_i = r[i], s_i = s[i];
    std::int32_t k = 0;
    for (; k + 4 <= i; k += 4) {
      // The pivots stand on the diagonal as their inverses.
      const double* __restrict const p0 = row_of(k);
      const double* __restrict const p1 = p0 + stride;
      const double* __restrict const p2 = p1 + stride;
      const double* __restrict const p3 = p2 + stride;
      const double f0 = row[k] * p0[k];
      const double f1 = (row[k + 1] - f0 * p0[k + 1]) * p1[k + 1];
      const double f2 = (row[k + 2] - f0 * p0[k + 2] - f1 * p1[k + 2]) * p2[k + 2];
      const double f3 = (row[k + 3] - f0 * p0[k + 3] - f1 * p1[k + 3] - f2 * p2[k + 3]) * p3[k + 3];
      for (std::int64_t j = k + 4; j < stride; j += 4)
        for (std::int64_t c = j; c < j + 4; ++c)
          row[c] = row[c] - f0 * p0[c] - f1 * p1[c] - f2 * p2[c] - f3 * p3[c];
      r_i = r_i - f0 * r[k] - f1 * r[k + 1] - f2 * r[k + 2] - f3 * r[k + 3];
      s_i = s_i - f0 * s[k] - f1 * s[k + 1] - f2 * s[k + 2] - f3 * s[k + 3];
    }
    for (; k < i; ++k) {
      const double* __restrict const pivot_row = row_of(k);
      const double factor = row[k] * pivot_row[k];
      for (std::int64_t j = k + 1; j < n; ++j) row[j] -= factor * pivot_row[j];
      r_i -= factor * r[k];
      s_i -= factor * s[k];
    }
    row[i] = 1.0 / row[i];
    r[i] = r_i;
    s[i] = s_i;
  }
  for (std::int32_t i = n - 1; i >= 0; --i) {
    const double* const row = row_of(i);
    double sum_r = r[i], sum_s = s[i];
    for (std::int32_t j = i + 1; j < n; ++j) {
      sum_r -= row[j] * r[j];
      sum_s -= row[j] * s[j];
    }
    r[i] = sum_r * row[i];
    s[i] = sum_s * row[i];
  }
}

}  // namespace wrc
