#include "linear_theory/ellipse_linear_theory.hpp"

#include <Eigen/LU>
#include <Eigen/QR>
#include <cmath>
#include <complex>
#include <vector>

#include "patch/material.hpp"

namespace wrc::halfspace {
namespace {

// Coordinates xi = x/a, eta = y/b (unit disk), c = sqrt(a b) = 1, G = 1. Seen as functions on the unit
// hemisphere above the disk, polynomials split into spherical harmonics even in height. With
// q_m the Fourier coefficients of P on the border (m = -n, -n + 2, ..., n for harmonics of degree n),
//     k_m = (1/2 pi) Int k(t) e^(-i m t) dt,   k = Fourier transform of the half-space's compliance on the
//     unit circle of wave vectors in these coordinates,
// the harmonics' transforms, spherical Bessel functions orthogonal to each other, leave one Toeplitz system
// for each degree:   Sum_m k_(m' - m) q_m = (2 / pi) u e^(-i m' alpha)   for the displacement u P_n(xi
// cos(alpha) + eta sin(alpha)), P_n Legendre's polynomial: a zonal harmonic.
using Complex = std::complex<double>;

/// u P_n along a direction of the plane.
struct Displacement {
  int degree = 0;
  double direction = 0.0;
  double ux = 0.0, uy = 0.0;
};

/// What a displacement needs: tractions on the leading border (x, then y, at every sample), and their
/// resultants.
struct Response {
  Eigen::VectorXd border;
  Eigen::Vector3d force;  // F_x, F_y, M_z
};

class Ellipse {
 public:
  Ellipse(double axis_ratio, double poisson, int degree)
      : a_(std::sqrt(axis_ratio)), b_(1.0 / a_), samples_(3 * degree + 20) {
    const std::vector<Eigen::Matrix2cd> k = compliance(poisson, degree);
    for (int n = 0; n <= degree; ++n) {
      Eigen::MatrixXcd toeplitz(2 * (n + 1), 2 * (n + 1));
      for (int row = 0; row <= n; ++row) {
        for (int column = 0; column <= n; ++column) {
          const Eigen::Matrix2cd& block = k[static_cast<std::size_t>(std::abs(row - column))];
          toeplitz.block<2, 2>(2 * row, 2 * column) = row < column ? block.conjugate().eval() : block;
        }
      }
      degrees_.emplace_back(toeplitz);
    }
  }

  double a() const { return a_; }
  double b() const { return b_; }

  Response respond(const Displacement& u) const {
    const int n = u.degree;
    Eigen::VectorXcd right(2 * (n + 1));
    for (int i = 0; i <= n; ++i) {
      const Complex zonal = 2.0 / pi * std::polar(1.0, -(2 * i - n) * u.direction);
      right.segment<2>(2 * i) << u.ux * zonal, u.uy * zonal;
    }
    const Eigen::VectorXcd q = degrees_[static_cast<std::size_t>(n)].solve(right);
    Response out{.border = Eigen::VectorXd(2 * samples_), .force = Eigen::Vector3d::Zero()};
    for (int s = 0; s < samples_; ++s) {
      const double angle = pi * ((s + 0.5) / samples_ - 0.5);
      Eigen::Vector2cd traction = Eigen::Vector2cd::Zero();
      for (int i = 0; i <= n; ++i) traction += q.segment<2>(2 * i) * std::polar(1.0, (2 * i - n) * angle);
      out.border.segment<2>(2 * s) = traction.real();
    }
    // Int 1 / sqrt(1 - r^2) = 2 pi over the disk, Int xi^2 / sqrt(1 - r^2) = 2 pi / 3; higher harmonics have
    // no resultant. Of degree 1, P = 2 Re(q_1) xi - 2 Im(q_1) eta.
    if (n == 0) out.force.head<2>() = 2.0 * pi * q.real();
    if (n == 1) out.force(2) = 4.0 * pi / 3.0 * (a_ * q(3).real() + b_ * q(2).imag());
    return out;
  }

 private:
  /// Fourier coefficients of orders 0, 2, 4, ... of the compliance's transform, the rows and columns x, y.
  /// Before stretching, two equal bodies have (2 / |k|) (1 - nu cos^2, -nu sin cos; ..., 1 - nu sin^2) of the
  /// wave vector's direction. The trapezoidal rule converges geometrically on periodic functions.
  std::vector<Eigen::Matrix2cd> compliance(double poisson, int degree) const {
    const int points = 128 * (8 + degree / 4);
    std::vector<Eigen::Matrix2cd> k(static_cast<std::size_t>(degree) + 1, Eigen::Matrix2cd::Zero());
    for (int p = 0; p < points; ++p) {
      const double t = pi * (p + 0.5) / points;  // the other half circle is the same
      const Eigen::Vector2d wave(std::cos(t) / a_, std::sin(t) / b_);
      const double length = wave.norm();
      const Eigen::Matrix2d here =
          2.0 / length *
          (Eigen::Matrix2d::Identity() - poisson * wave * wave.transpose() / (length * length));
      for (std::size_t j = 0; j < k.size(); ++j) {
        k[j] += here * std::polar(1.0 / points, -2.0 * static_cast<double>(j) * t);
      }
    }
    return k;
  }

  double a_, b_;
  int samples_;
  std::vector<Eigen::PartialPivLU<Eigen::MatrixXcd>> degrees_;
};

}  // namespace

LinearCoefficients ellipse_linear_coefficients(double axis_ratio, double poisson, int degree) {
  const Ellipse ellipse(axis_ratio, poisson, degree);
  const double a = ellipse.a(), b = ellipse.b();
  // No slip: du/dx = (nu_x - phi y, nu_y + phi x), so u = (x nu_x - x y phi, x nu_y + x^2/2 phi) and a
  // function of y; x^2/2 is a^2/3 P_2(xi) and a constant, xi eta a third of the difference of P_2 along both
  // diagonals.
  const std::vector<Displacement> prescribed[] = {
      {{1, 0.0, a, 0.0}},
      {{1, 0.0, 0.0, a}},
      {{2, 0.25 * pi, -a * b / 3.0, 0.0}, {2, -0.25 * pi, a * b / 3.0, 0.0}, {2, 0.0, 0.0, a * a / 3.0}}};
  std::vector<Response> open;  // P_n(y/b) of u_x and of u_y
  for (int n = 0; n <= degree; ++n) {
    open.push_back(ellipse.respond({n, 0.5 * pi, 1.0, 0.0}));
    open.push_back(ellipse.respond({n, 0.5 * pi, 0.0, 1.0}));
  }
  const auto columns = static_cast<Eigen::Index>(open.size());
  Eigen::MatrixXd border(open.front().border.size(), columns), force(3, columns);
  for (Eigen::Index c = 0; c < columns; ++c) {
    // Columns of one length: what one function of degree n needs grows with n.
    const Response& r = open[static_cast<std::size_t>(c)];
    border.col(c) = r.border / r.border.norm();
    force.col(c) = r.force / r.border.norm();
  }
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> leading(border);
  Eigen::Matrix3d c = Eigen::Matrix3d::Zero();  // minus the resultants of nu_x, nu_y, phi = 1
  for (int creepage = 0; creepage < 3; ++creepage) {
    Eigen::VectorXd traction = Eigen::VectorXd::Zero(border.rows());
    for (const Displacement& u : prescribed[creepage]) {
      const Response r = ellipse.respond(u);
      traction += r.border;
      c.col(creepage) -= r.force;
    }
    c.col(creepage) += force * leading.solve(traction);
  }
  return {
      .c11 = c(0, 0), .c22 = c(1, 1), .c13 = 0.0, .c23 = c(1, 2), .c31 = 0.0, .c32 = c(2, 1), .c33 = c(2, 2)};
}

}  // namespace wrc::halfspace
