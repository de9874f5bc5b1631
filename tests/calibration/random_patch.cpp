#include "random_patch.hpp"

#include <cmath>

#include "linear_theory/sdec.hpp"
#include "patch/material.hpp"

namespace wrc::calibration {
namespace {

/// The splitmix64 generator (Steele, Lea, Flood 2014): a counter and a scrambler, so that rows can be drawn
/// in any order and every standard library gives the same numbers.
class Random {
 public:
  Random(std::uint64_t seed, std::uint64_t row) : state_(seed) { state_ = bits() ^ (row << 32); }

  double uniform(double low, double high) {
    return low + (high - low) * 0x1p-53 * static_cast<double>(bits() >> 11);
  }
  double logarithmic(double low, double high) { return low * std::pow(high / low, uniform(0.0, 1.0)); }

 private:
  std::uint64_t bits() {
    state_ += 0x9e3779b97f4a7c15;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }
  std::uint64_t state_;
};

struct Direction {
  double x, y, spin;
};

Direction random_direction(Random& random) {
  const double spin = random.uniform(-1.0, 1.0), angle = random.uniform(0.0, 2.0 * pi);
  const double kind = random.uniform(0.0, 1.0);
  if (kind < 0.2) return {std::cos(angle), std::sin(angle), 0.0};
  if (kind < 0.4) return {0.0, 0.0, spin < 0.0 ? -1.0 : 1.0};
  const double rest = std::sqrt(1.0 - spin * spin);
  const Direction anywhere{rest * std::cos(angle), rest * std::sin(angle), spin};
  if (kind < 0.6 && anywhere.y * spin > 0.0) return {anywhere.x, -anywhere.y, spin};
  return anywhere;
}

}  // namespace

Patch random_patch(std::uint64_t seed, std::uint64_t row) {
  Random random(seed, row);
  Patch p{};
  const double ratio = random.logarithmic(0.25, 3.0), c = random.uniform(3e-3, 8e-3);
  p.a = c * std::sqrt(ratio);
  p.b = c / std::sqrt(ratio);
  p.psi = random.uniform(-0.7, 0.7);
  p.poisson = random.uniform(0.25, 0.30);
  p.shear_modulus = 80e9;
  p.friction = random.uniform(0.1, 0.5);
  p.p0 = random.uniform(0.5e9, 1.8e9);
  p.normal_force = 2.0 / 3.0 * pi * p.a * p.b * p.p0;

  Fault fault;
  const SdecCoefficients linear = SdecTable(p.poisson).at(ratio, p.psi, fault);
  const double level = random.logarithmic(0.1, 6.0);
  const double unit = level * p.friction * p.normal_force / (p.shear_modulus * c * c);
  const Direction to = random_direction(random);
  p.creepage = {to.x * unit / linear.c11, to.y * unit / linear.c22, to.spin * unit / (linear.c23 * c)};
  return p;
}

}  // namespace wrc::calibration
