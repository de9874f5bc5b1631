#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "geometry/smoothing.hpp"

namespace wrc::geometry {
namespace {

struct Result {
  std::vector<double> y, z, scratch;
  SmoothedPoints smooth;
};

/// `curve(t)` gives the point at parameter t.
template <typename Curve>
Result smoothed(double from, double to, double spacing, double wavelength, Curve&& curve) {
  Result r;
  for (int i = 0; from + i * spacing < to; ++i) {
    const auto [y, z] = curve(from + i * spacing);
    r.y.push_back(y);
    r.z.push_back(z);
  }
  r.scratch.resize(smoothing_scratch * r.y.size());
  r.smooth = smooth_points(static_cast<std::int32_t>(r.y.size()), r.y.data(), r.z.data(), wavelength,
                           r.scratch.data());
  return r;
}

TEST(Smoothing, KeepsStraightLinesHoweverSteep) {
  for (double slope : {0.0, 0.3, -20.0}) {
    const Result r =
        smoothed(-0.05, 0.05, 0.5e-3, 5e-3, [&](double y) { return std::pair(y, 0.1 + slope * y); });
    EXPECT_LT(r.smooth.deviation, 1e-12) << slope;
    for (std::size_t i = 0; i < r.y.size(); ++i) EXPECT_NEAR(r.smooth.y[i], r.y[i], 1e-12);
  }
}

/// A wave of length L keeps 1 / (1 + (wavelength / L)^4), at any density of points, on the level as on a
/// slope of 70 degrees: what counts is the length along the curve.
TEST(Smoothing, DampsWavesByTheirLengthAlongTheCurve) {
  constexpr double wavelength = 4e-3, pi = 3.14159265358979;
  for (double degrees : {0.0, 70.0}) {
    const double c = std::cos(degrees * pi / 180.0), s = std::sin(degrees * pi / 180.0);
    for (double spacing : {0.1e-3, 0.25e-3}) {
      for (double wave : {2e-3, 4e-3, 8e-3}) {
        const auto height = [&](double t) { return 1e-5 * std::cos(2.0 * pi * t / wave); };
        const Result r = smoothed(-0.05, 0.05, spacing, wavelength, [&](double t) {
          return std::pair(c * t - s * height(t), s * t + c * height(t));
        });
        const double kept = 1.0 / (1.0 + std::pow(wavelength / wave, 4.0));
        double product = 0.0, square = 0.0;
        for (std::size_t i = r.y.size() / 4; i < 3 * r.y.size() / 4; ++i) {
          const double given = c * r.z[i] - s * r.y[i];
          product += (c * r.smooth.z[i] - s * r.smooth.y[i]) * given;
          square += given * given;
        }
        EXPECT_NEAR(product / square, kept, 0.01) << wave << " spacing " << spacing << " at " << degrees;
      }
    }
  }
}

/// An arc of radius R shrinks by lambda / R^3, away from its ends.
TEST(Smoothing, ShrinksArcsByLittle) {
  constexpr double radius = 13e-3, wavelength = 5e-3, pi = 3.14159265358979;
  const Result r = smoothed(-1.4, 1.4, 0.2 / 13.0, wavelength, [&](double angle) {
    return std::pair(radius * std::sin(angle), radius * std::cos(angle));
  });
  const std::size_t middle = r.y.size() / 2;
  const double shrunk = radius - std::hypot(r.smooth.y[middle], r.smooth.z[middle]);
  EXPECT_NEAR(shrunk, std::pow(wavelength / (2.0 * pi), 4.0) / std::pow(radius, 3.0), 0.02e-6);
}

/// Noise makes the chords between dense points too long; the smoothing must not become shorter by that.
TEST(Smoothing, DoesNotDependOnHowDenselyNoisyPointsLie) {
  constexpr double wavelength = 5e-3, pi = 3.14159265358979;
  double kept[2];
  const double spacings[] = {0.5e-3, 0.01e-3};
  for (int k = 0; k < 2; ++k) {
    std::uint32_t state = 1;
    const auto noise = [&] {
      state = 1664525u * state + 1013904223u;
      return 20e-6 * (static_cast<double>(state) / 4294967296.0 - 0.5);
    };
    const auto wave = [&](double y) { return 1e-3 * std::cos(2.0 * pi * y / wavelength); };
    const Result r = smoothed(-0.05, 0.05, spacings[k], wavelength,
                              [&](double y) { return std::pair(y, wave(y) + noise()); });
    double product = 0.0, square = 0.0;
    for (std::size_t i = r.y.size() / 4; i < 3 * r.y.size() / 4; ++i) {
      product += r.smooth.z[i] * wave(r.y[i]);
      square += wave(r.y[i]) * wave(r.y[i]);
    }
    kept[k] = product / square;
  }
  EXPECT_NEAR(kept[1], kept[0], 0.03);
}

}  // namespace
}  // namespace wrc::geometry
