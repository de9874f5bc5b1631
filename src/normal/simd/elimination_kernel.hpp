/// Dense linear equations with two right-hand sides, for influence matrices.
#pragma once

#include "base/pack.hpp"
#include "normal/simd/tasks.hpp"

namespace wrc::simd {
namespace {

constexpr std::int32_t group = 8;  // columns taken together, whatever the instruction set

/// From `count` rows the multiples of four pivot rows are taken away that make their elements in the pivots'
/// columns vanish. The pivots stand on the diagonal as their inverses.
template <std::int32_t count>
void take_away(const double* pivots, std::int32_t column, std::int64_t stride, double* rows) {
  double factor[count][4];
  const double* const p = pivots + column;
  for (std::int32_t i = 0; i < count; ++i) {
    const double* const row = rows + i * stride + column;
    double* const f = factor[i];
    f[0] = row[0] * p[0];
    f[1] = (row[1] - f[0] * p[1]) * p[stride + 1];
    f[2] = (row[2] - f[0] * p[2] - f[1] * p[stride + 2]) * p[2 * stride + 2];
    f[3] = (row[3] - f[0] * p[3] - f[1] * p[stride + 3] - f[2] * p[2 * stride + 3]) * p[3 * stride + 3];
  }
  // From the group on that holds the first column to the right: what else it holds is not read any more.
  for (std::int64_t c = (column + 4) / group * group; c < stride; c += native_lanes) {
    const Native p0 = load_lanes(pivots + c), p1 = load_lanes(pivots + stride + c),
                 p2 = load_lanes(pivots + 2 * stride + c), p3 = load_lanes(pivots + 3 * stride + c);
    for (std::int32_t i = 0; i < count; ++i) {
      double* const at = rows + i * stride + c;
      const double* const f = factor[i];
      store_lanes(at, load_lanes(at) - broadcast(f[0]) * p0 - broadcast(f[1]) * p1 - broadcast(f[2]) * p2 -
                          broadcast(f[3]) * p3);
    }
  }
}

/// Eliminates four rows from each other, and leaves the inverses of the pivots on the diagonal.
inline void triangulate(double* rows, std::int32_t column, std::int64_t stride) {
  // The four columns of the diagonal first: they give the factors.
  double a[4][4], factor[4][4];
  for (std::int32_t i = 0; i < 4; ++i)
    for (std::int32_t k = 0; k < 4; ++k) a[i][k] = rows[i * stride + column + k];
  for (std::int32_t i = 0; i < 4; ++i) {
    for (std::int32_t k = 0; k < i; ++k) {
      factor[i][k] = a[i][k] * a[k][k];
      for (std::int32_t c = k + 1; c < 4; ++c) a[i][c] -= factor[i][k] * a[k][c];
    }
    a[i][i] = 1.0 / a[i][i];
  }
  double *const row0 = rows, *const row1 = row0 + stride, *const row2 = row1 + stride,
                *const row3 = row2 + stride;
  for (std::int64_t c = (column + 4) / group * group; c < stride; c += native_lanes) {
    const Native first = load_lanes(row0 + c);
    const Native second = load_lanes(row1 + c) - broadcast(factor[1][0]) * first;
    const Native third =
        load_lanes(row2 + c) - broadcast(factor[2][0]) * first - broadcast(factor[2][1]) * second;
    const Native fourth = load_lanes(row3 + c) - broadcast(factor[3][0]) * first -
                          broadcast(factor[3][1]) * second - broadcast(factor[3][2]) * third;
    store_lanes(row1 + c, second);
    store_lanes(row2 + c, third);
    store_lanes(row3 + c, fourth);
  }
  for (std::int32_t i = 0; i < 4; ++i)
    for (std::int32_t k = i; k < 4; ++k) rows[i * stride + column + k] = a[i][k];
}

/// Sum over row[c] x[c], c = from .. to - 1, both multiples of `group`; in eight parts, added up at the end.
inline double product(const double* row, const double* x, std::int64_t from, std::int64_t to) {
  constexpr std::int32_t parts = group / native_lanes;
  Native sum[parts];
  for (std::int32_t k = 0; k < parts; ++k) sum[k] = broadcast(0.0);
  for (std::int64_t c = from; c < to; c += group)
    for (std::int32_t k = 0; k < parts; ++k) {
      const std::int64_t at = c + k * native_lanes;
      sum[k] = sum[k] + load_lanes(row + at) * load_lanes(x + at);
    }
  double part[group];
  for (std::int32_t k = 0; k < parts; ++k) store_lanes(part + k * native_lanes, sum[k]);
  return ((part[0] + part[4]) + (part[2] + part[6])) + ((part[1] + part[5]) + (part[3] + part[7]));
}

/// Kernels::eliminate, without pivoting: the influence of a strip is largest on itself, the matrix
/// close to symmetric and positive definite. By blocks of eight rows and four pivots.
void eliminate_kernel(const EliminationTask& task) {
  const std::int64_t stride = task.stride;
  const auto rows_at = [&](std::int32_t i) { return task.matrix + i * stride; };
  std::int32_t i = 0;
  for (; i + 8 <= task.size; i += 8) {
    for (std::int32_t k = 0; k < i; k += 4) take_away<8>(rows_at(k), k, stride, rows_at(i));
    triangulate(rows_at(i), i, stride);
    take_away<4>(rows_at(i), i, stride, rows_at(i + 4));
    triangulate(rows_at(i + 4), i + 4, stride);
  }
  if (i < task.size) {
    for (std::int32_t k = 0; k < i; k += 4) take_away<4>(rows_at(k), k, stride, rows_at(i));
    triangulate(rows_at(i), i, stride);
  }
  // What is not known yet counts as zero.
  for (std::int64_t c = 0; c < stride; ++c) task.r[c] = task.s[c] = 0.0;
  for (i = task.size - 4; i >= 0; i -= 4) {
    const std::int64_t from = (i + 4) / group * group;
    double r[4], s[4];
    for (std::int32_t q = 0; q < 4; ++q) {
      const double* const row = rows_at(i + q);
      r[q] = row[task.size] - product(row, task.r, from, stride);
      s[q] = row[task.size + 1] - product(row, task.s, from, stride);
    }
    for (std::int32_t q = 3; q >= 0; --q) {
      const double* const row = rows_at(i + q) + i;
      for (std::int32_t k = 3; k > q; --k) {
        r[q] -= row[k] * r[k];
        s[q] -= row[k] * s[k];
      }
      task.r[i + q] = r[q] = r[q] * row[q];
      task.s[i + q] = s[q] = s[q] * row[q];
    }
  }
}

}  // namespace
}  // namespace wrc::simd
