#include "halfspace/gmres.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

namespace wrc::halfspace {
namespace {

double dot(const Vector& a, const Vector& b) {
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += a[k] * b[k];
  return sum;
}

void add(double factor, const Vector& a, Vector& b) {
  for (std::size_t k = 0; k < a.size(); ++k) b[k] += factor * a[k];
}

}  // namespace

void gmres(const LinearMap& matrix, const LinearMap& preconditioner, const Vector& rhs, double tolerance,
           int max_products, Vector& x) {
  x.assign(rhs.size(), 0.0);
  const double norm = std::sqrt(dot(rhs, rhs));
  if (norm == 0.0) return;

  std::vector<Vector> basis, hessenberg;  // hessenberg[k]: column k after the Givens rotations
  Vector cosines, sines, projected{norm};
  basis.push_back(rhs);
  for (double& v : basis[0]) v /= norm;
  double residual = 1.0;  // |b - A x| / |b|
  for (std::size_t k = 0; k < static_cast<std::size_t>(max_products) && residual > tolerance; ++k) {
    Vector next(rhs.size());
    preconditioner(basis[k], x);
    matrix(x, next);

    Vector column(k + 2);
    for (std::size_t i = 0; i <= k; ++i) {
      column[i] = dot(basis[i], next);
      add(-column[i], basis[i], next);
    }
    column[k + 1] = std::sqrt(dot(next, next));
    const double length = column[k + 1];
    for (std::size_t i = 0; i < k; ++i) {
      const double upper = cosines[i] * column[i] + sines[i] * column[i + 1];
      column[i + 1] = cosines[i] * column[i + 1] - sines[i] * column[i];
      column[i] = upper;
    }
    const double radius = std::sqrt(column[k] * column[k] + column[k + 1] * column[k + 1]);
    if (radius == 0.0) {  // the matrix maps the new direction to nothing new: no further progress possible
      break;
    }
    cosines.push_back(column[k] / radius);
    sines.push_back(column[k + 1] / radius);
    column[k] = radius;
    hessenberg.push_back(std::move(column));
    projected.push_back(-sines[k] * projected[k]);
    projected[k] *= cosines[k];
    residual = std::abs(projected[k + 1]) / norm;
    if (length == 0.0) break;
    for (double& v : next) v /= length;
    basis.push_back(std::move(next));
  }

  Vector combination(rhs.size());
  for (std::size_t k = hessenberg.size(); k-- > 0;) {
    for (std::size_t i = k + 1; i < hessenberg.size(); ++i) projected[k] -= hessenberg[i][k] * projected[i];
    projected[k] /= hessenberg[k][k];
    add(projected[k], basis[k], combination);
  }
  preconditioner(combination, x);
}

}  // namespace wrc::halfspace
