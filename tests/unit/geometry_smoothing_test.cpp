#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "geometry/smoothing.hpp"

namespace wrc {
namespace {

struct Result {
  std::vector<double> y, z, smooth;
  double largest = 0.0;
};

template <typename Curve>
Result smoothed(double spacing, double wavelength, Curve&& curve) {
  Result r;
  for (double y = -0.05; y < 0.05; y += spacing) {
    r.y.push_back(y);
    r.z.push_back(curve(y));
  }
  r.smooth.resize(r.y.size());
  std::vector<double> scratch(smoothing_scratch * r.y.size());
  r.largest = smooth_points(static_cast<std::int32_t>(r.y.size()), r.y.data(), r.z.data(), wavelength,
                            scratch.data(), r.smooth.data());
  return r;
}

TEST(Smoothing, KeepsStraightLines) {
  const Result r = smoothed(0.5e-3, 5e-3, [](double y) { return 0.1 + 0.3 * y; });
  EXPECT_LT(r.largest, 1e-13);
}

/// A wave of length L keeps 1 / (1 + (wavelength / L)^4), at any density of points.
TEST(Smoothing, DampsWavesByTheirLength) {
  const double wavelength = 4e-3;
  for (double spacing : {0.1e-3, 0.25e-3}) {
    for (double wave : {2e-3, 4e-3, 8e-3}) {
      const auto curve = [&](double y) { return 1e-5 * std::cos(2.0 * 3.14159265358979 * y / wave); };
      const Result r = smoothed(spacing, wavelength, curve);
      const double kept = 1.0 / (1.0 + std::pow(wavelength / wave, 4.0));
      double product = 0.0, square = 0.0;
      for (std::size_t i = r.y.size() / 4; i < 3 * r.y.size() / 4; ++i) {
        product += r.smooth[i] * r.z[i];
        square += r.z[i] * r.z[i];
      }
      EXPECT_NEAR(product / square, kept, 0.01) << "wave " << wave << " spacing " << spacing;
    }
  }
}

}  // namespace
}  // namespace wrc
