/// GMRES: solves a linear system known only through its products with vectors (Saad & Schultz 1986).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace wrc {

/// Memory of gmres() [doubles].
constexpr std::size_t gmres_memory(std::size_t size, std::size_t max_products) {
  return (max_products + 1) * (size + max_products + 2) - 1;
}

/// Solves matrix(x) = rhs from x = 0 with the preconditioner on the right (so that the residual is the true
/// one), until |rhs - matrix(x)| <= accuracy |rhs| or `max_products`, in gmres_memory(). Both maps write to
/// their second argument. No restarts.
template <class Matrix, class Preconditioner>
void gmres(const Matrix& matrix, const Preconditioner& precondition, const double* rhs, std::size_t size,
           double accuracy, std::size_t max_products, double* memory, double* x) {
  const auto dot = [size](const double* a, const double* b) {
    double sum = 0.0;
    for (std::size_t k = 0; k < size; ++k) sum += a[k] * b[k];
    return sum;
  };
  const auto add = [size](double factor, const double* a, double* b) {
    for (std::size_t k = 0; k < size; ++k) b[k] += factor * a[k];
  };
  const auto basis = [=](std::size_t m) { return memory + m * size; };
  double* const hessenberg = basis(max_products + 1);
  // Column m of the projected matrix, after the rotations.
  const auto column = [=](std::size_t m) { return hessenberg + m * max_products; };
  double *const cosine = column(max_products), *const minus_sine = cosine + max_products,
                *const projected = minus_sine + max_products;

  std::fill_n(x, size, 0.0);
  const double norm = std::sqrt(dot(rhs, rhs));
  if (!(norm > 0.0)) return;
  for (std::size_t k = 0; k < size; ++k) basis(0)[k] = rhs[k] / norm;
  projected[0] = norm;
  std::size_t used = 0;
  while (used < max_products && std::abs(projected[used]) > accuracy * norm) {
    const std::size_t m = used;
    double *const next = basis(m + 1), *const h = column(m);
    precondition(basis(m), x);
    matrix(x, next);
    for (std::size_t i = 0; i <= m; ++i) {
      h[i] = dot(basis(i), next);
      add(-h[i], basis(i), next);
    }
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
  double* const combination = basis(max_products);  // which is not in use any more
  std::fill_n(combination, size, 0.0);
  for (std::size_t i = used; i-- > 0;) {
    for (std::size_t k = i + 1; k < used; ++k) projected[i] -= column(k)[i] * projected[k];
    projected[i] /= column(i)[i];
  }
  for (std::size_t i = used; i-- > 0;) add(projected[i], basis(i), combination);
  precondition(combination, x);
}

}  // namespace wrc
