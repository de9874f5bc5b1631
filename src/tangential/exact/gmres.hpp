/// GMRES: solves a linear system known only through its products with vectors (Saad & Schultz 1986).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "base/arena.hpp"

namespace wrc::tangential {

/// Right side, solution and working memory of gmres().
struct Gmres {
  double *rhs, *x;
  double* basis;                ///< max_products + 1 vectors that span the Krylov space
  double* hessenberg;           ///< the projected matrix, after the rotations, by columns
  double *cosine, *minus_sine;  ///< rotations that make it triangular
  double* projected;            ///< right side of the projected system
};

inline Gmres cut_gmres(Arena& arena, std::size_t unknowns, std::size_t max_products) {
  const auto size = static_cast<std::int64_t>(unknowns), products = static_cast<std::int64_t>(max_products);
  Gmres w{};
  arena.each(size, w.rhs, w.x);
  w.basis = arena.take((products + 1) * size);
  w.hessenberg = arena.take(products * products);
  arena.each(products + 1, w.cosine, w.minus_sine, w.projected);
  return w;
}

/// Solves matrix(x) = rhs from x = 0 with the preconditioner on the right (so that the residual is the true
/// one), until |rhs - matrix(x)| <= accuracy |rhs| or `max_products`, both as `w` was cut. Both maps write to
/// their second argument. No restarts.
template <class Matrix, class Preconditioner>
void gmres(const Matrix& matrix, const Preconditioner& precondition, std::size_t size, double accuracy,
           std::size_t max_products, const Gmres& w) {
  const auto dot = [size](const double* a, const double* b) {
    double sum = 0.0;
    for (std::size_t k = 0; k < size; ++k) sum += a[k] * b[k];
    return sum;
  };
  const auto add = [size](double factor, const double* a, double* b) {
    for (std::size_t k = 0; k < size; ++k) b[k] += factor * a[k];
  };
  const auto basis = [=](std::size_t m) { return w.basis + m * size; };
  const auto column = [=](std::size_t m) { return w.hessenberg + m * max_products; };
  double *const rhs = w.rhs, *const x = w.x, *const cosine = w.cosine, *const minus_sine = w.minus_sine,
                *const projected = w.projected;

  // x = 0: the residual is the right side, the first direction of the space
  std::fill_n(x, size, 0.0);
  const double norm = std::sqrt(dot(rhs, rhs));
  if (!(norm > 0.0)) return;
  for (std::size_t k = 0; k < size; ++k) basis(0)[k] = rhs[k] / norm;
  projected[0] = norm;
  std::size_t used = 0;
  while (used < max_products && std::abs(projected[used]) > accuracy * norm) {
    // Arnoldi: the map of the newest direction, orthogonal to all before (modified Gram-Schmidt)
    const std::size_t m = used;
    double *const next = basis(m + 1), *const h = column(m);
    precondition(basis(m), x);
    matrix(x, next);
    for (std::size_t i = 0; i <= m; ++i) {
      h[i] = dot(basis(i), next);
      add(-h[i], basis(i), next);
    }
    // Givens rotations keep the projected matrix triangular; |projected[m + 1]| is then the residual.
    const double length = std::sqrt(dot(next, next));
    for (std::size_t i = 0; i < m; ++i) {
      // Two sums, not a sum and a difference: gcc 12 would make fused operations of such a pair for
      // processors that have them, whatever -ffp-contract says.
      const double upper = cosine[i] * h[i] + (-minus_sine[i]) * h[i + 1];
      h[i + 1] = cosine[i] * h[i + 1] + minus_sine[i] * h[i];
      h[i] = upper;
    }
    const double radius = std::sqrt(h[m] * h[m] + length * length);
    if (!(radius > 0.0)) break;  // the new direction is mapped to nothing new
    cosine[m] = h[m] / radius;
    minus_sine[m] = -(length / radius);
    h[m] = radius;
    projected[m + 1] = minus_sine[m] * projected[m];
    projected[m] *= cosine[m];
    ++used;
    if (!(length > 0.0)) break;
    for (std::size_t k = 0; k < size; ++k) next[k] /= length;
  }
  // back substitution, and the combination of directions through the preconditioner
  double* const combination = basis(max_products);  // the last direction is not used any more
  std::fill_n(combination, size, 0.0);
  for (std::size_t i = used; i-- > 0;) {
    for (std::size_t k = i + 1; k < used; ++k) projected[i] -= column(k)[i] * projected[k];
    projected[i] /= column(i)[i];
  }
  for (std::size_t i = used; i-- > 0;) add(projected[i], basis(i), combination);
  precondition(combination, x);
}

}  // namespace wrc::tangential
