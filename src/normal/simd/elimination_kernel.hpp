/// Dense linear equations with two right-hand sides, for influence matrices.
#pragma once

#include "base/eight_parts.hpp"
#include "normal/simd/tasks.hpp"

namespace wrc::simd {
namespace {

constexpr std::int32_t group = EightParts::parts;

/// Rows of equations, the right-hand sides up to the column `end`.
struct EquationRows {
  std::int64_t stride, end;
};

/// Vectors of columns: four at most, or eight with AVX-512.
struct FourColumns {
  static Columns all(double a) { return in_all_columns(a); }
  static Columns load(const double* from) { return load_columns(from); }
  static void store(double* to, Columns a) { store_columns(to, a); }
};
struct MostColumns {
  static Native all(double a) { return broadcast(a); }
  static Native load(const double* from) { return load_lanes(from); }
  static void store(double* to, Native a) { store_lanes(to, a); }
};

/// Calls take(kind of vector, c) for the columns from `from`, a multiple of four, to `end`. With AVX-512 it
/// goes on to the end of a group of eight, which rows have.
template <class Take>
void for_columns(std::int64_t from, std::int64_t end, const Take& take) {
  std::int64_t c = from;
  for (; c % native_lanes != 0; c += abreast) take(FourColumns{}, c);
  for (; c < end; c += native_lanes) take(MostColumns{}, c);
}

/// From `count` rows the multiples of four pivot rows are taken away that make their elements in the pivots'
/// columns vanish. The pivots stand on the diagonal as their inverses.
template <std::int32_t count>
void take_away(const double* pivots, std::int32_t column, const EquationRows& all, double* rows) {
  const std::int64_t stride = all.stride;
  // Factors of the four pivot rows, from the columns of the pivots: forward substitution in those four.
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
  for_columns(column + 4, all.end, [&](auto v, std::int64_t c) {
    // The other columns of the rows, less the pivot rows times their factors.
    const auto p0 = v.load(pivots + c), p1 = v.load(pivots + stride + c),
               p2 = v.load(pivots + 2 * stride + c), p3 = v.load(pivots + 3 * stride + c);
    for (std::int32_t i = 0; i < count; ++i) {
      double* const at = rows + i * stride + c;
      const double* const f = factor[i];
      v.store(at, v.load(at) - v.all(f[0]) * p0 - v.all(f[1]) * p1 - v.all(f[2]) * p2 - v.all(f[3]) * p3);
    }
  });
}

/// Eliminates four rows from each other, and leaves the inverses of the pivots on the diagonal.
inline void triangulate(double* rows, std::int32_t column, const EquationRows& all) {
  const std::int64_t stride = all.stride;
  double *const row0 = rows, *const row1 = row0 + stride, *const row2 = row1 + stride,
                *const row3 = row2 + stride;
  // The four columns of the diagonal first: they give the factors f. Written out, they stay in registers.
  double *const a0 = row0 + column, *const a1 = row1 + column, *const a2 = row2 + column,
                *const a3 = row3 + column;
  a0[0] = 1.0 / a0[0];
  const double f10 = a1[0] * a0[0], f20 = a2[0] * a0[0], f30 = a3[0] * a0[0];
  const double a11 = 1.0 / (a1[1] - f10 * a0[1]), a12 = a1[2] - f10 * a0[2], a13 = a1[3] - f10 * a0[3];
  const double f21 = (a2[1] - f20 * a0[1]) * a11, f31 = (a3[1] - f30 * a0[1]) * a11;
  const double a22 = 1.0 / (a2[2] - f20 * a0[2] - f21 * a12), a23 = a2[3] - f20 * a0[3] - f21 * a13;
  const double f32 = (a3[2] - f30 * a0[2] - f31 * a12) * a22;
  a3[3] = 1.0 / (a3[3] - f30 * a0[3] - f31 * a13 - f32 * a23);
  a1[1] = a11, a1[2] = a12, a1[3] = a13, a2[2] = a22, a2[3] = a23;
  for_columns(column + 4, all.end, [&](auto v, std::int64_t c) {
    const auto first = v.load(row0 + c);
    const auto second = v.load(row1 + c) - v.all(f10) * first;
    const auto third = v.load(row2 + c) - v.all(f20) * first - v.all(f21) * second;
    const auto fourth = v.load(row3 + c) - v.all(f30) * first - v.all(f31) * second - v.all(f32) * third;
    v.store(row1 + c, second);
    v.store(row2 + c, third);
    v.store(row3 + c, fourth);
  });
}

/// Sum over row[c] x[c], c = from .. to - 1, both multiples of `group`.
inline double product(const double* row, const double* x, std::int64_t from, std::int64_t to) {
  EightParts sum = no_parts();
  for (std::int64_t c = from; c < to; c += group)
    for (std::int32_t k = 0; k < EightParts::vectors; ++k) {
      const std::int64_t at = c + k * native_lanes;
      sum.of[k] = sum.of[k] + load_lanes(row + at) * load_lanes(x + at);
    }
  return sum.sum();
}

/// NormalKernels::eliminate, without pivoting: the influence of a strip is largest on itself, the matrix
/// close to symmetric and positive definite.
void eliminate_kernel(const EliminationTask& task) {
  const std::int64_t stride = task.stride;
  // With right-hand sides given, columns beyond them are not read.
  const EquationRows all{stride, task.r ? task.size + 4 : stride};
  // Column 0 of an eliminated row, of which those before its group of eight may be another row's: a row
  // without a place lies where one far above has no columns left.
  double* const matrix = task.matrix;
  const std::int32_t places = task.rows ? task.places : task.size;
  const auto rows_at = [&](std::int32_t i) {
    const std::int64_t behind = i / 8, above = (task.size + 7) / 8 + 1 - behind;
    return i < places ? matrix + i * stride : matrix + (8 * above + i % 8) * stride - 8 * behind;
  };
  const std::int32_t first = task.rows ? task.first : 0, end = task.rows ? task.end : task.size;
  if (first == 0) {
    // Rows that have a place, four pivots at a time. The next four are found as soon as their rows are known:
    // their divisions take as long as other rows.
    triangulate(matrix, 0, all);
    for (std::int32_t k = 0; k + 4 < end; k += 4) {
      const auto below = [&](std::int32_t i) {
        (i + 8 <= end ? take_away<8> : take_away<4>)(rows_at(k), k, all, rows_at(i));
      };
      below(k + 4);
      triangulate(rows_at(k + 4), k + 4, all);
      for (std::int32_t i = k + 12; i < end; i += 8) below(i);
    }
  } else {
    // Rows without a place, eight or the last four: less all pivot rows above, then each four among
    // themselves.
    const bool eight = end - first == 8;
    for (std::int32_t k = 0; k < first; k += 4)
      (eight ? take_away<8> : take_away<4>)(rows_at(k), k, all, task.rows);
    triangulate(task.rows, first, all);
    if (eight) {
      take_away<4>(task.rows, first, all, task.rows + 4 * stride);
      triangulate(task.rows + 4 * stride, first + 4, all);
    }
    // To where they are kept, from the diagonal on.
    double* const kept = rows_at(first);
    for (std::int32_t q = 0; q < end - first; ++q)
      for (std::int64_t c = first; c < stride; ++c) kept[q * stride + c] = task.rows[q * stride + c];
  }
  if (!task.r || end < task.size) return;
  // Back substitution, upwards; solutions not known yet count as zero.
  const std::int64_t columns = (task.size + group - 1) / group * group;
  for (std::int64_t c = 0; c < columns; ++c) {
    task.r[c] = 0.0;
    if (task.s) task.s[c] = 0.0;
  }
  for (std::int32_t i = task.size - 4; i >= 0; i -= 4) {
    // x_i = (r_i - sum of the known x) / pivot; within the four row by row.
    const std::int64_t from = (i + 4) / group * group;
    const auto substitute = [&](double* x, std::int32_t column) {
      double right[4];
      for (std::int32_t q = 0; q < 4; ++q) {
        const double* const row = rows_at(i + q);
        right[q] = row[column] - product(row, x, from, columns);
      }
      for (std::int32_t q = 3; q >= 0; --q) {
        const double* const row = rows_at(i + q) + i;
        for (std::int32_t k = 3; k > q; --k) right[q] -= row[k] * right[k];
        x[i + q] = right[q] = right[q] * row[q];
      }
    };
    substitute(task.r, task.size);
    if (task.s) substitute(task.s, task.size + 1);
  }
}

}  // namespace
}  // namespace wrc::simd
