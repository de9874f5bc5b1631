/// Patches and reference solutions the tangential tests share.
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "kernels/kernels.hpp"
#include "patch/material.hpp"
#include "patch/strips.hpp"
#include "tangential/march/march.hpp"
#include "tangential/rolling_contact.hpp"

namespace wrc::test {

/// Strips that own their memory.
class OwnedStrips {
 public:
  explicit OwnedStrips(int count) : values_(5 * static_cast<std::size_t>(count)) {
    double* p = values_.data();
    strips_.capacity = strips_.count = count;
    strips_.y = p;
    strips_.width = p + count;
    strips_.centre = p + 2 * count;
    strips_.half_length = p + 3 * count;
    strips_.peak = p + 4 * count;
  }
  OwnedStrips(const OwnedStrips&) = delete;
  OwnedStrips& operator=(const OwnedStrips&) = delete;
  OwnedStrips(OwnedStrips&&) = default;
  const patch::Strips& get() const { return strips_; }

 private:
  std::vector<double> values_;
  patch::Strips strips_;
};

/// A single double-elliptical contact with the exact semi-elliptic pressure of load N; psi = 0 is an ellipse.
/// Strips of equal width, half length and peak those of their middle.
inline OwnedStrips sdec_strips(double a, double b, double psi, double normal_force, int count) {
  OwnedStrips owned(count);
  const patch::Strips& s = owned.get();
  const double p0 = 1.5 * normal_force / (pi * a * b);
  for (int j = 0; j < count; ++j) {
    const double y = b * (psi - 1.0 + (2.0 * j + 1.0) / count);
    const double eta = y / (y > 0.0 ? b * (1.0 + psi) : b * (1.0 - psi));
    s.y[j] = y;
    s.width[j] = 2.0 * b / count;
    s.centre[j] = 0.0;
    s.half_length[j] = a * std::sqrt(1.0 - eta * eta);
    s.peak[j] = p0 * s.half_length[j] / a;
  }
  return owned;
}

/// A grid that owns its memory.
class OwnedGrid {
 public:
  explicit OwnedGrid(int cells, InstructionSet set = InstructionSet::baseline)
      : memory_(tangential::march_grid_size(cells)),
        grid_(tangential::make_march_grid(cells, memory_.data(), kernels_for(set))) {}
  OwnedGrid(const OwnedGrid&) = delete;
  OwnedGrid& operator=(const OwnedGrid&) = delete;
  const tangential::MarchGrid& get() const { return grid_; }

 private:
  std::vector<double> memory_;
  tangential::MarchGrid grid_;
};

/// FASTSIM as the textbooks march it: explicit, first order, one cell after the other, slip from Kalker's
/// L (p - p*) / h. Independent of the library's kernel; needs several hundred cells to converge.
inline tangential::TangentialForces textbook_fastsim(const tangential::TangentialProblem& problem,
                                                     int cells) {
  const patch::Strips& s = problem.region;
  const tangential::Creepage& c = problem.creepage;
  const theory::Flexibility& L = problem.flexibility;
  double cubes = 0.0, squares = 0.0;
  for (int j = 0; j < s.count; ++j) {
    cubes += 4.0 / 3.0 * std::pow(s.half_length[j], 3) * s.width[j];
    squares += 0.5 * pi * std::pow(s.half_length[j], 2) * s.width[j];
  }
  const double N = patch::totals(s).normal_force;
  tangential::TangentialForces f;
  double area = 0.0, slid = 0.0;
  for (int j = 0; j < s.count; ++j) {
    const double l = s.half_length[j], h = 2.0 * l / cells, y = s.y[j], cell = h * s.width[j];
    double px = 0.0, py = 0.0;
    for (int i = 0; i < cells; ++i) {
      const double from_centre = l - (i + 0.5) * h, x = s.centre[j] + from_centre;
      const double step = i == 0 ? 0.5 * h : h;
      const double x_step = x + 0.5 * step;
      const double qx = px - step * (c.longitudinal / L.l11 - c.spin * y / L.l13);
      const double qy = py - step * (c.lateral / L.l22 + c.spin * x_step / L.l23);
      const double parabola = l * l - from_centre * from_centre;
      const double per_friction = problem.bound == tangential::TractionBound::parabolic ? N / cubes * parabola
                                  : problem.bound == tangential::TractionBound::ellipsoidal
                                      ? N / squares * std::sqrt(parabola)
                                      : s.peak[j] / l * std::sqrt(parabola);
      const double tau = problem.friction[j] * per_friction;
      const double q = std::hypot(qx, qy);
      px = q <= tau ? qx : tau * qx / q;
      py = q <= tau ? qy : tau * qy / q;
      f.power_per_speed -= (L.l11 * (px - qx) * px + L.l22 * (py - qy) * py) / step * cell;
      slid += q <= tau ? 0.0 : cell;
      area += cell;
      f.fx += px * cell;
      f.fy += py * cell;
      f.mz += (x * py - y * px) * cell;
    }
  }
  f.adhesion_fraction = 1.0 - slid / area;
  return f;
}

/// A random SDEC patch in partial to full slip, of the range met on railways: a/b 0.25 to 3, |psi| <= 0.7.
struct RandomCase {
  double a, b, psi, normal_force, friction, shear_modulus, poisson;
  tangential::Creepage creepage;
};

inline RandomCase random_case(std::mt19937& random) {
  // The generator's own bits, not std::uniform_real_distribution: the same cases with every standard library.
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
  };
  RandomCase c;
  const double ratio = 0.25 * std::pow(12.0, uniform(0.0, 1.0));
  const double size = 1e-3 * uniform(3.0, 8.0);  // sqrt(a b)
  c.a = size * std::sqrt(ratio);
  c.b = size / std::sqrt(ratio);
  c.psi = uniform(-0.7, 0.7);
  c.normal_force = 2.0 / 3.0 * pi * c.a * c.b * 1e9 * uniform(0.5, 1.8);
  c.friction = uniform(0.1, 0.5);
  c.shear_modulus = 80e9;
  c.poisson = 0.28;
  const double unit = c.friction * c.normal_force / (c.shear_modulus * c.a * c.b);
  const double level = std::pow(30.0, uniform(0.0, 1.0)) * 0.1;
  c.creepage.longitudinal = level * unit * uniform(-1.0, 1.0);
  c.creepage.lateral = level * unit * uniform(-1.0, 1.0);
  c.creepage.spin = level * unit / size * uniform(-1.5, 1.5);
  return c;
}

inline tangential::TangentialProblem problem_of(const RandomCase& c, const patch::Strips& region,
                                                tangential::TractionBound bound) {
  Fault fault;
  return {region, c.creepage,
          theory::sdec_flexibility(c.a, c.b, c.psi, c.shear_modulus, theory::SdecTable(c.poisson), fault),
          c.friction, bound};
}

}  // namespace wrc::test
