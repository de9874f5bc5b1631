#include "linear_theory/linear_theory.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

#include "linear_theory/ellipse_linear_theory.hpp"
#include "patch/material.hpp"
#include "sdec_pressure.hpp"

namespace wrc::halfspace {
namespace {

struct Strip {
  double y = 0.0, low = 0.0, high = 0.0, half_length = 0.0;
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

// Borders of the strips, at nearly equal angles of the half circle over the width: as many eighths of the
// strips in the narrow half as its part of the half circle has, so that a strip begins at the joint.
std::vector<Strip> divide(const SdecPatch& patch, int strips) {
  const double joint = std::acos(patch.psi);  // the half circle's angle, from the end at -b (1 - psi)
  const int below = strips / 8 * std::clamp(static_cast<int>(std::lround(8.0 * joint / pi)), 1, 7);
  const auto y = [&](double j) {
    const double angle =
        j < below ? joint * j / below : joint + (pi - joint) * (j - below) / (strips - below);
    return patch.b * (patch.psi - std::cos(angle));
  };
  std::vector<Strip> out;
  for (int j = 0; j < strips; ++j) {
    const double middle = y(j + 0.5);
    out.push_back({.y = middle, .low = y(j), .high = y(j + 1), .half_length = patch.half_length(middle)});
  }
  return out;
}

// Cells of a strip of half length 1, from the trailing edge.
struct Cells {
  std::vector<double> border, middle;  // `middle` has one point more, ahead of the leading edge

  explicit Cells(int n) {
    for (int i = 0; i <= n; ++i) border.push_back(-std::cos(pi * i / n));
    for (int i = 0; i < n; ++i) middle.push_back(-std::cos(pi * (i + 0.5) / n));
    middle.push_back(2.0 - middle.back());
  }
};

// Fills the block of slips in strip `to` from tractions in strip `from`: the influence of a cell is the
// difference of two edges, a slip the difference of two displacements over their distance.
void fill(Eigen::MatrixXd& matrix, const std::vector<Strip>& strips, const Cells& cells, int to, int from,
          double poisson) {
  const Strip& t = strips[static_cast<std::size_t>(to)];
  const Strip& f = strips[static_cast<std::size_t>(from)];
  const std::size_t n = cells.border.size() - 1;
  std::vector<Edge> before(n + 1), here(n + 1);
  for (std::size_t i = 0; i <= n; ++i) {
    for (std::size_t k = 0; k <= n; ++k) {
      const double x = t.half_length * cells.middle[i] - f.half_length * cells.border[k];
      here[k] = edge(x, t.y - f.high, t.y - f.low, poisson);
    }
    for (std::size_t k = 0; k < n && i > 0; ++k) {
      const double distance = t.half_length * (cells.middle[i] - cells.middle[i - 1]);
      const auto slip = [&](double Edge::*c) {
        return ((before[k].*c - before[k + 1].*c) - (here[k].*c - here[k + 1].*c)) / distance;
      };
      const auto row = static_cast<Eigen::Index>(2 * (static_cast<std::size_t>(to) * n + i - 1));
      const auto column = static_cast<Eigen::Index>(2 * (static_cast<std::size_t>(from) * n + k));
      matrix(row, column) = slip(&Edge::xx);
      matrix(row + 1, column + 1) = slip(&Edge::yy);
      matrix(row, column + 1) = matrix(row + 1, column) = slip(&Edge::xy);
    }
    before.swap(here);
  }
}

using Member = double LinearCoefficients::*;
constexpr Member all[] = {&LinearCoefficients::c11, &LinearCoefficients::c22, &LinearCoefficients::c13,
                          &LinearCoefficients::c23, &LinearCoefficients::c31, &LinearCoefficients::c32,
                          &LinearCoefficients::c33};
constexpr Member of_the_ellipse[] = {&LinearCoefficients::c11, &LinearCoefficients::c22,
                                     &LinearCoefficients::c23, &LinearCoefficients::c32,
                                     &LinearCoefficients::c33};

/// c13, c31 and c33 about a point at y, the others as they are; c = 1. Spin about it is spin about the old
/// one and longitudinal creepage y phi. (C23 would move by y C21: an asymmetric patch has small C12 = -C21,
/// which SDEC leaves out.)
LinearCoefficients about(LinearCoefficients c, double y) {
  c.c33 += y * (c.c13 + c.c31) + y * y * c.c11;
  c.c13 += y * c.c11;
  c.c31 += y * c.c11;
  return c;
}

/// By the reciprocal theorem c31 = c13, c32 = -c23; on strips of finite width the means are closer.
LinearCoefficients reciprocal(LinearCoefficients c) {
  c.c13 = c.c31 = 0.5 * (c.c13 + c.c31);
  c.c23 = 0.5 * (c.c23 - c.c32);
  c.c32 = -c.c23;
  return c;
}

constexpr int ellipse_degree = 60;

EstimatedCoefficients ellipse(double axis_ratio, double poisson) {
  const LinearCoefficients c = ellipse_linear_coefficients(axis_ratio, poisson, ellipse_degree);
  const LinearCoefficients half = ellipse_linear_coefficients(axis_ratio, poisson, ellipse_degree / 2);
  EstimatedCoefficients out{.value = reciprocal(c), .error = {}};
  for (const Member m : all) out.error.*m = std::max(std::abs(c.*m - half.*m), std::abs(c.*m - out.value.*m));
  return out;
}

/// Value and error estimate from n = 1/2, 3/4 and 1 times the finest.
struct Extrapolated {
  double value = 0.0, error = 0.0;
};
Extrapolated extrapolate(double coarse, double middle, double fine) {
  const double value = 4.0 * fine - 3.0 * middle, from_coarser = 3.0 * middle - 2.0 * coarse;
  return {value, std::max(std::abs(value - fine), std::abs(value - from_coarser))};
}

}  // namespace

LinearCoefficients strip_linear_coefficients(double axis_ratio, double psi, double poisson, int strip_count,
                                             int n) {
  const double a = std::sqrt(axis_ratio), b = 1.0 / a;  // c = 1, G = 1
  const std::vector<Strip> strips = divide({.a = a, .b = b, .psi = psi}, strip_count);
  const Cells cells(n);
  const Eigen::Index size = 2 * static_cast<Eigen::Index>(strip_count) * n;
  Eigen::MatrixXd matrix(size, size);
  for (int to = 0; to < strip_count; ++to) {
    for (int from = 0; from < strip_count; ++from) fill(matrix, strips, cells, to, from, poisson);
  }
  Eigen::MatrixXd rigid(size, 3),
      force = Eigen::MatrixXd::Zero(3, size);  // of nu_x, nu_y, phi; F_x, F_y, M_z
  for (int j = 0; j < strip_count; ++j) {
    const Strip& s = strips[static_cast<std::size_t>(j)];
    for (int i = 0; i < n; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const Eigen::Index k = 2 * (static_cast<Eigen::Index>(j) * n + i);
      const double area = s.half_length * (cells.border[at + 1] - cells.border[at]) * (s.high - s.low);
      const double slip_x = 0.5 * s.half_length * (cells.middle[at] + cells.middle[at + 1]);
      const double traction_x = 0.5 * s.half_length * (cells.border[at] + cells.border[at + 1]);
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

LinearTheory::LinearTheory(double axis_ratio, double poisson, int finest)
    : axis_ratio_(axis_ratio),
      poisson_(poisson),
      finest_(finest),
      ellipse_(ellipse(axis_ratio, poisson)),
      ellipse_on_strips_(divisions(0.0)) {}

LinearTheory::Divisions LinearTheory::divisions(double psi) const {
  const double middle = psi / std::sqrt(axis_ratio_);  // psi b
  const auto divided = [&](int n) {
    return reciprocal(about(strip_linear_coefficients(axis_ratio_, psi, poisson_, n, n), middle));
  };
  return {divided(finest_ / 2), divided(3 * finest_ / 4), divided(finest_)};
}

EstimatedCoefficients LinearTheory::at(double psi) const {
  if (psi == 0.0) return ellipse_;
  const Divisions here = divisions(psi);
  EstimatedCoefficients out;
  for (const Member m : of_the_ellipse) {
    std::array<double, 3> ratio{};
    for (std::size_t i = 0; i < 3; ++i) ratio[i] = here[i].*m / ellipse_on_strips_[i].*m;
    const Extrapolated r = extrapolate(ratio[0], ratio[1], ratio[2]);
    out.value.*m = r.value * ellipse_.value.*m;
    out.error.*m = r.error * std::abs(ellipse_.value.*m) + r.value * ellipse_.error.*m;
  }
  const Extrapolated coupling = extrapolate(here[0].c13, here[1].c13, here[2].c13);
  out.value.c13 = out.value.c31 = coupling.value;
  out.error.c13 = out.error.c31 = coupling.error;

  const double joint = -psi / std::sqrt(axis_ratio_);
  out.value = about(out.value, joint);
  out.error.c33 += 2.0 * std::abs(joint) * out.error.c13 + joint * joint * out.error.c11;
  out.error.c13 += std::abs(joint) * out.error.c11;
  out.error.c31 = out.error.c13;
  return out;
}

}  // namespace wrc::halfspace
