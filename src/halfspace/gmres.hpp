/// GMRES: solves a linear system known only through its products with vectors (Saad & Schultz 1986).
#pragma once

#include <functional>
#include <vector>

namespace wrc::halfspace {

using Vector = std::vector<double>;
using LinearMap = std::function<void(const Vector& in, Vector& out)>;

/// Solves matrix(x) = rhs from x = 0 with the preconditioner on the right (so that the residual is the true
/// one), until |b - A x| <= tolerance |b| or `max_products`. No restarts: memory is max_products vectors at
/// most.
void gmres(const LinearMap& matrix, const LinearMap& preconditioner, const Vector& rhs, double tolerance,
           int max_products, Vector& x);

}  // namespace wrc::halfspace
