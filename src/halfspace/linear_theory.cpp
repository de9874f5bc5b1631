#include "halfspace/linear_theory.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

#include "patch/material.hpp"

namespace wrc::halfspace {
namespace {

struct Strip {
  double y = 0.0, width = 0.0, trail = 0.0, length = 0.0;  // length of one cell
};

double corner(double x, double y) { return x == 0.0 ? 0.0 : x * std::asinh(y / std::abs(x)); }

// The functions of influence.cpp differenced over a strip's width only: indefinite in x.
struct Edge {
  double xx = 0.0, yy = 0.0, xy = 0.0;
};
Edge edge(double x, double y_low, double y_high, double poisson) {
  const double yy_over_r3 = corner(x, y_high) - corner(x, y_low);
  const double xx_over_r3 = corner(y_high, x) - corner(y_low, x);
  const double xy_over_r3 = std::sqrt(x * x + y_low * y_low) - std::sqrt(x * x + y_high * y_high);
  return {.xx = (xx_over_r3 + (1.0 - poisson) * yy_over_r3) / pi,
          .yy = ((1.0 - poisson) * xx_over_r3 + yy_over_r3) / pi,
          .xy = poisson * xy_over_r3 / pi};
}

// Fills the block of slips in strip `to` from tractions in strip `from`. The displacements of a strip are
// needed at the n cell centres and one cell upstream of the last; each cell of `from` has two edges: (n +
// 1)^2 edge functions, differenced both ways.
void fill(Eigen::MatrixXd& matrix, const std::vector<Strip>& strips, int to, int from, int n,
          double poisson) {
  const Strip& t = strips[static_cast<std::size_t>(to)];
  const Strip& f = strips[static_cast<std::size_t>(from)];
  const double y_low = t.y - f.y - 0.5 * f.width, y_high = t.y - f.y + 0.5 * f.width;
  std::vector<Edge> before(static_cast<std::size_t>(n) + 1), here(before);
  for (int i = 0; i <= n; ++i) {
    for (int k = 0; k <= n; ++k) {
      const double x = t.trail + (i + 0.5) * t.length - (f.trail + k * f.length);
      here[static_cast<std::size_t>(k)] = edge(x, y_low, y_high, poisson);
    }
    for (int k = 0; k < n && i > 0; ++k) {
      const auto l = static_cast<std::size_t>(k);
      const auto slip = [&](double Edge::*c) {
        return ((before[l].*c - before[l + 1].*c) - (here[l].*c - here[l + 1].*c)) / t.length;
      };
      const int row = 2 * (to * n + i - 1), column = 2 * (from * n + k);
      matrix(row, column) = slip(&Edge::xx);
      matrix(row + 1, column + 1) = slip(&Edge::yy);
      matrix(row, column + 1) = matrix(row + 1, column) = slip(&Edge::xy);
    }
    before.swap(here);
  }
}

using Member = double LinearCoefficients::*;
constexpr Member members[] = {&LinearCoefficients::c11, &LinearCoefficients::c22, &LinearCoefficients::c13,
                              &LinearCoefficients::c23, &LinearCoefficients::c31, &LinearCoefficients::c32,
                              &LinearCoefficients::c33};

}  // namespace

LinearCoefficients linear_coefficients(double axis_ratio, double psi, double poisson, int strip_count,
                                       int n) {
  const double a = std::sqrt(axis_ratio), b = 1.0 / a;  // c = 1, G = 1
  const SdecPatch patch{.a = a, .b = b, .psi = psi};
  // As many strips in the narrow half as in the wide one: with strips of one width the joint falls inside a
  // strip and the narrow half has next to none, which costs 2 % at psi = 0.95 instead of 0.05 %.
  const int half = strip_count / 2;
  std::vector<Strip> strips;
  for (int j = 0; j < strip_count; ++j) {
    const double width = b * (j < half ? 1.0 - psi : 1.0 + psi) / half;
    const double y = (j - half + 0.5) * width;
    const double l = patch.half_length(y);
    strips.push_back({.y = y, .width = width, .trail = -l, .length = 2.0 * l / n});
  }
  const Eigen::Index size = 2 * static_cast<Eigen::Index>(strip_count) * n;
  Eigen::MatrixXd matrix(size, size);
  for (int to = 0; to < strip_count; ++to) {
    for (int from = 0; from < strip_count; ++from) fill(matrix, strips, to, from, n, poisson);
  }
  Eigen::MatrixXd rigid(size, 3),
      force = Eigen::MatrixXd::Zero(3, size);  // of nu_x, nu_y, phi; F_x, F_y, M_z
  for (int j = 0; j < strip_count; ++j) {
    const Strip& s = strips[static_cast<std::size_t>(j)];
    const double area = s.length * s.width;
    for (int i = 0; i < n; ++i) {
      const Eigen::Index k = 2 * (static_cast<Eigen::Index>(j) * n + i);
      const double slip_x = s.trail + (i + 0.75) * s.length, traction_x = s.trail + (i + 0.25) * s.length;
      rigid.row(k) << 1.0, 0.0, -s.y;
      rigid.row(k + 1) << 0.0, 1.0, slip_x;
      force.col(k) << area, 0.0, -area * s.y;
      force.col(k + 1) << 0.0, area, area * traction_x;
    }
  }
  // s = w + C p = 0: p = -C^-1 w, and the coefficients are minus the forces.
  const Eigen::Matrix3d c = force * matrix.partialPivLu().solve(rigid);
  return {.c11 = c(0, 0),
          .c22 = c(1, 1),
          .c13 = c(0, 2),
          .c23 = c(1, 2),
          .c31 = c(2, 0),
          .c32 = c(2, 1),
          .c33 = c(2, 2)};
}

ExtrapolatedCoefficients extrapolated_coefficients(double axis_ratio, double psi, double poisson,
                                                   int finest) {
  // Wide patches need resolution along their width. Long ones need it both ways, the strips at their ends
  // being short: of equal counts and of more cells than strips the former changes less from one division to
  // the next.
  const double stretch = axis_ratio < 1.0 ? std::sqrt(std::sqrt(axis_ratio)) : 1.0;
  // A multiple of 8, so that three quarters are even: each half has its own strips.
  const int strips = 8 * std::max(1, static_cast<int>(std::lround(0.125 * finest / stretch)));
  const int cells = 4 * std::max(2, static_cast<int>(std::lround(0.25 * finest * stretch)));
  const LinearCoefficients coarse = linear_coefficients(axis_ratio, psi, poisson, strips / 2, cells / 2);
  const LinearCoefficients middle =
      linear_coefficients(axis_ratio, psi, poisson, 3 * strips / 4, 3 * cells / 4);
  const LinearCoefficients fine = linear_coefficients(axis_ratio, psi, poisson, strips, cells);
  ExtrapolatedCoefficients out;
  for (const Member c : members) {
    // Nodes 1/n = h, 4/3 h, 2 h: the parabola through the three values at 0. The lines through the finer and
    // the coarser two miss it there by e and 2 e if the error has no higher terms; the larger e is the
    // estimate.
    const double finer = 4.0 * (fine.*c) - 3.0 * (middle.*c), coarser = 3.0 * (middle.*c) - 2.0 * (coarse.*c);
    out.value.*c = 8.0 * (fine.*c) - 9.0 * (middle.*c) + 2.0 * (coarse.*c);
    out.error.*c = std::max(std::abs(out.value.*c - finer), 0.5 * std::abs(out.value.*c - coarser));
  }
  return out;
}

}  // namespace wrc::halfspace
