/// Stresses below a loaded surface against what is known of them: the loads on the surface, equilibrium,
/// Hertz's circle, a line contact that slides, and two ways of adding up.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "halfspace/subsurface.hpp"

namespace wrc::halfspace {
namespace {

constexpr double nu = 0.28;

/// Semi-elliptic loads over an ellipse a x b, tractions `share_x`, `share_y` of the pressure on the body.
BodyLoads ellipse(double a, double b, int n, double share_x = 0.0, double share_y = 0.0) {
  BodyLoads loads;
  loads.grid = grid_over_box(-a, a, -b, b, n, n);
  loads.poisson = nu;
  for (std::size_t k = 0; k < loads.grid.cells(); ++k) {
    const double x = loads.grid.x(static_cast<int>(k) % n) / a, y = loads.grid.y(static_cast<int>(k) / n) / b;
    const double pressure = std::sqrt(std::max(0.0, 1.0 - x * x - y * y));
    loads.pressure.push_back(pressure);
    loads.traction_x.push_back(share_x * pressure);
    loads.traction_y.push_back(share_y * pressure);
  }
  return loads;
}

TEST(Subsurface, AtTheSurfaceAreTheLoads) {
  const auto check = [](double x, double y, double inside) {
    const damage::CellStress s = damage::cell_stress(nu, x, y, 0.0, 2.0, 3.0);
    EXPECT_NEAR(s.of_pressure.zz, -inside, 1e-14);
    EXPECT_NEAR(s.of_pressure.zx, 0.0, 1e-14);
    EXPECT_NEAR(s.of_traction_x.zx, -inside, 1e-14);
    EXPECT_NEAR(s.of_traction_x.zz, 0.0, 1e-14);
    EXPECT_NEAR(s.of_traction_x.yz, 0.0, 1e-14);
    EXPECT_NEAR(s.of_traction_y.yz, -inside, 1e-14);
  };
  check(0.3, -1.2, 1.0);
  check(-0.9, 0.0, 1.0);
  check(1.4, 0.2, 0.0);
  check(-3.0, -5.0, 0.0);
}

// Nothing but the loads acts: the divergence of every column vanishes. And Beltrami's equations of
// elasticity: the sum of the normal stresses is harmonic.
TEST(Subsurface, IsInEquilibriumAndElastic) {
  constexpr double h = 1e-3;
  const auto at = [](double x, double y, double z) { return damage::cell_stress(nu, x, y, z, 2.0, 3.0); };
  for (const auto& [x, y, z] : {std::tuple{0.4, 0.7, 0.6}, {1.3, -1.1, 0.3}, {-2.0, 0.5, 1.5}}) {
    for (const damage::Stress damage::CellStress::*load :
         {&damage::CellStress::of_pressure, &damage::CellStress::of_traction_x,
          &damage::CellStress::of_traction_y}) {
      const damage::Stress xp = at(x + h, y, z).*load, xm = at(x - h, y, z).*load, yp = at(x, y + h, z).*load,
                           ym = at(x, y - h, z).*load, zp = at(x, y, z + h).*load, zm = at(x, y, z - h).*load,
                           here = at(x, y, z).*load;
      const double scale = 2e-5 * 2.0 * h;
      EXPECT_NEAR(xp.xx - xm.xx + yp.xy - ym.xy + zp.zx - zm.zx, 0.0, scale);
      EXPECT_NEAR(xp.xy - xm.xy + yp.yy - ym.yy + zp.yz - zm.yz, 0.0, scale);
      EXPECT_NEAR(xp.zx - xm.zx + yp.yz - ym.yz + zp.zz - zm.zz, 0.0, scale);
      const auto sum = [](const damage::Stress& s) { return s.xx + s.yy + s.zz; };
      EXPECT_NEAR(sum(xp) + sum(xm) + sum(yp) + sum(ym) + sum(zp) + sum(zm) - 6.0 * sum(here), 0.0,
                  1e-4 * h * h);
    }
  }
}

// A load far away is a force at a point: Boussinesq and Cerruti (Johnson, 3.4 and 3.6).
TEST(Subsurface, FarAwayIsThatOfAPointLoad) {
  const double x = 30.0, y = -20.0, z = 25.0, r = std::sqrt(x * x + y * y + z * z);
  const damage::CellStress s = damage::cell_stress(nu, x, y, z, 0.1, 0.1);
  const double force = 0.01, scale = -1.5 * force / (pi * r * r * r * r * r);
  EXPECT_NEAR(s.of_pressure.zz, scale * z * z * z, 1e-5 * std::abs(scale) * r * r * r);
  EXPECT_NEAR(s.of_pressure.zx, scale * x * z * z, 1e-5 * std::abs(scale) * r * r * r);
  EXPECT_NEAR(s.of_traction_x.zz, scale * x * z * z, 1e-5 * std::abs(scale) * r * r * r);
  EXPECT_NEAR(s.of_traction_x.zx, scale * x * x * z, 1e-5 * std::abs(scale) * r * r * r);
  EXPECT_NEAR(s.of_traction_x.yz, scale * x * y * z, 1e-5 * std::abs(scale) * r * r * r);
  EXPECT_NEAR(s.of_traction_y.zx, scale * x * y * z, 1e-5 * std::abs(scale) * r * r * r);
}

// Circle: along the axis sr = -(1 + nu) (1 - z atan(1/z)) + 1 / (2 (1 + z^2)), sz = -1 / (1 + z^2) (Johnson,
// 3.45): tau = 0.3145 p0 at 0.48 a and the surface's centre at -(1 + 2 nu) / 2 p0 for nu = 0.28.
TEST(Subsurface, CircleIsHertz) {
  const BodyLoads loads = ellipse(1.0, 1.0, 60);
  for (const double z : {0.2, 0.48, 1.0}) {
    const damage::Stress s = stress_at(loads, 0.0, 0.0, z);
    const double radial = -(1.0 + nu) * (1.0 - z * std::atan(1.0 / z)) + 0.5 / (1.0 + z * z);
    EXPECT_NEAR(s.xx, radial, 1e-3);
    EXPECT_NEAR(s.zz, -1.0 / (1.0 + z * z), 1e-3);
  }
  const SubsurfaceSolution found = search_stresses(loads, {0.0, 0.48}, {});
  EXPECT_NEAR(found.below.shear.value, 0.3145, 1e-3);
  EXPECT_NEAR(found.below.shear.z, 0.48, 0.01);
  EXPECT_NEAR(found.below.von_mises.value, 0.629, 2e-3);  // s1 = s2 on the axis: twice the shear
  EXPECT_NEAR(found.levels[1].shear.value, 0.3145, 1e-3);
  EXPECT_EQ(found.levels[0].von_mises.value, found.surface.von_mises.value);
  EXPECT_NEAR(found.surface.tension.value, (1.0 - 2.0 * nu) / 3.0, 0.02);  // at the edge: Johnson 3.42
  const damage::Stress centre = stress_at(loads, 1e-9, 1e-9, 0.0);
  EXPECT_NEAR(centre.xx, -0.78, 2e-3);
}

// A long contact: 0.300 p0 at 0.786 a, and under tractions mu p along x on the body the surface has
// s_xx = -p - 2 mu p0 x / a (Johnson, 4.48 and 7.6).
TEST(Subsurface, LineContactSlides) {
  constexpr int n = 200;
  constexpr double mu = 0.4;
  BodyLoads loads;
  loads.grid = grid_over_box(-1.0, 1.0, -1e4, 1e4, n, 1);
  loads.poisson = nu;
  for (int i = 0; i < n; ++i) {
    const double x = loads.grid.x(i);
    loads.pressure.push_back(std::sqrt(1.0 - x * x));
    loads.traction_x.push_back(mu * loads.pressure.back());
    loads.traction_y.push_back(0.0);
  }
  for (const int i : {20, 99, 150, 190}) {
    const double x = loads.grid.x(i);
    const damage::Stress s = stress_at(loads, x, 0.0, 0.0);
    EXPECT_NEAR(s.xx, -std::sqrt(1.0 - x * x) - 2.0 * mu * x, 0.02);
    EXPECT_NEAR(s.yy, nu * (s.xx + s.zz), 1e-3);  // plane strain
  }
  std::fill(loads.traction_x.begin(), loads.traction_x.end(), 0.0);
  const auto shear = [&](double z) { return damage::numbers_of(stress_at(loads, 0.0, 0.0, z)).shear; };
  EXPECT_NEAR(shear(0.786), 0.300, 1e-3);
  EXPECT_LT(shear(0.72), shear(0.786));
  EXPECT_LT(shear(0.86), shear(0.786));
}

TEST(Subsurface, FieldIsThePlainSum) {
  const BodyLoads loads = ellipse(2.0, 1.0, 12, 0.3, -0.1);
  StressField field(loads);
  for (const double z : {0.0, 0.4}) {
    field.peaks(z);
    const Grid& grid = field.grid();
    for (const std::size_t k : {std::size_t{0}, grid.index(7, 9), grid.index(3, 12), grid.cells() - 1}) {
      const damage::Stress whole = field.at(k);
      const damage::Stress sum =
          stress_at(loads, grid.x(static_cast<int>(k) % grid.nx), grid.y(static_cast<int>(k) / grid.nx), z);
      for (double damage::Stress::*each : {&damage::Stress::xx, &damage::Stress::yy, &damage::Stress::zz,
                                           &damage::Stress::xy, &damage::Stress::yz, &damage::Stress::zx})
        EXPECT_NEAR(whole.*each, sum.*each, 1e-13);
    }
  }
}

TEST(StressNumbers, AreThoseOfThePrincipalStresses) {
  // Turned from principal stresses 5, 2, -4 by 0.7 about z and 0.4 about x.
  const double c = std::cos(0.7), s = std::sin(0.7), cx = std::cos(0.4), sx = std::sin(0.4);
  const double axes[3][3] = {{c, s * cx, s * sx}, {-s, c * cx, c * sx}, {0.0, -sx, cx}};
  const double principal[3] = {5.0, 2.0, -4.0};
  double t[3][3] = {};
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) t[i][j] += principal[k] * axes[k][i] * axes[k][j];
  const damage::StressNumbers numbers =
      damage::numbers_of({t[0][0], t[1][1], t[2][2], t[0][1], t[1][2], t[2][0]});
  EXPECT_NEAR(numbers.tension, 5.0, 1e-13);
  EXPECT_NEAR(numbers.shear, 4.5, 1e-13);
  EXPECT_NEAR(numbers.von_mises, std::sqrt(0.5 * (9.0 + 36.0 + 81.0)), 1e-13);
  EXPECT_NEAR(damage::numbers_of({3.0, -1.0, -1.0}).tension, 3.0, 1e-7);
  EXPECT_NEAR(damage::numbers_of({-3.0, 1.0, 1.0}).tension, 1.0, 1e-7);
  EXPECT_EQ(damage::numbers_of({2.0, 2.0, 2.0}).shear, 0.0);
}

TEST(Subsurface, IsCancelled) {
  const auto never = [](double, void*) { return false; };
  EXPECT_EQ(search_stresses(ellipse(1.0, 1.0, 8), {}, {never, nullptr}).fault.status, WRC_ERROR_CANCELLED);
}

}  // namespace
}  // namespace wrc::halfspace
