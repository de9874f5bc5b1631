#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "halfspace/convolution.hpp"
#include "tangential/exact/cell_influence.hpp"

namespace wrc::halfspace {
namespace {

constexpr patch::Material steel{.shear_modulus = 82e9, .poisson = 0.28};

// Midpoint sum of the point-load kernels over the cell, for points outside it.
tangential::CellInfluence by_quadrature(double x, double y, double dx, double dy) {
  constexpr int n = 200;
  tangential::CellInfluence sum;
  const double s = dx * dy / (n * n) / (pi * steel.shear_modulus), nu = steel.poisson;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const double px = x - dx * ((i + 0.5) / n - 0.5), py = y - dy * ((j + 0.5) / n - 0.5);
      const double r = std::hypot(px, py);
      sum.zz += s * (1 - nu) / r;
      sum.xx += s * ((1 - nu) / r + nu * px * px / (r * r * r));
      sum.yy += s * ((1 - nu) / r + nu * py * py / (r * r * r));
      sum.xy += s * nu * px * py / (r * r * r);
    }
  }
  return sum;
}

TEST(HalfspaceInfluence, IsTheIntegralOfTheBoussinesqAndCerrutiPointLoads) {
  for (const auto& [x, y] : {std::pair{0.3e-3, 0.9e-3}, {-1.1e-3, 0.2e-3}, {-0.4e-3, -2e-3}, {5e-3, 0.0}}) {
    const tangential::CellInfluence exact = tangential::cell_influence(steel, x, y, 0.4e-3, 0.7e-3),
                                    sum = by_quadrature(x, y, 0.4e-3, 0.7e-3);
    EXPECT_NEAR(exact.zz, sum.zz, 1e-5 * sum.zz);
    EXPECT_NEAR(exact.xx, sum.xx, 1e-5 * sum.zz);
    EXPECT_NEAR(exact.yy, sum.yy, 1e-5 * sum.zz);
    EXPECT_NEAR(exact.xy, sum.xy, 1e-5 * sum.zz);
  }
}

// Love 1929: centre of a uniformly loaded square of side s, u = 2 s (1-nu)/(pi G) ln(1 + sqrt 2) per unit
// pressure and body; twice that for the pair.
TEST(HalfspaceInfluence, CentreOfALoadedSquareIsLoves) {
  const double s = 1e-3;
  const double per_body =
      2.0 * s * (1 - steel.poisson) / (pi * steel.shear_modulus) * std::log(1 + std::sqrt(2.0));
  EXPECT_NEAR(tangential::cell_influence(steel, 0, 0, s, s).zz, 2.0 * per_body, 1e-14 * per_body);
}

class HalfspaceConvolution : public testing::TestWithParam<std::pair<int, int>> {};

TEST_P(HalfspaceConvolution, IsThePlainDoubleSum) {
  const auto [nx, ny] = GetParam();
  const Grid grid = grid_over_box(-3e-3, 3e-3, -5e-3, 4e-3, nx, ny);
  Convolution convolution(grid, steel, Convolution::Kernel::tangential);
  Field px(grid.cells()), py(grid.cells()), ux(grid.cells()), uy(grid.cells());
  for (std::size_t k = 0; k < px.size(); ++k) {
    px[k] = std::sin(1.7 * static_cast<double>(k));
    py[k] = std::cos(2.9 * static_cast<double>(k));
  }
  convolution.apply(px.data(), py.data(), ux.data(), uy.data());
  double scale = 0.0, worst = 0.0;
  for (int i = 0; i < nx; ++i) {
    for (int j = 0; j < ny; ++j) {
      double sx = 0.0, sy = 0.0;
      for (int k = 0; k < nx; ++k) {
        for (int l = 0; l < ny; ++l) {
          const tangential::CellInfluence here =
              tangential::cell_influence(steel, (i - k) * grid.dx, (j - l) * grid.dy, grid.dx, grid.dy);
          const tangential::CellInfluence up =
              tangential::cell_influence(steel, (i - k + 1) * grid.dx, (j - l) * grid.dy, grid.dx, grid.dy);
          sx +=
              ((here.xx - up.xx) * px[grid.index(k, l)] + (here.xy - up.xy) * py[grid.index(k, l)]) / grid.dx;
          sy +=
              ((here.xy - up.xy) * px[grid.index(k, l)] + (here.yy - up.yy) * py[grid.index(k, l)]) / grid.dx;
        }
      }
      scale = std::max({scale, std::abs(sx), std::abs(sy)});
      worst = std::max({worst, std::abs(sx - ux[grid.index(i, j)]), std::abs(sy - uy[grid.index(i, j)])});
    }
  }
  EXPECT_LT(worst, 1e-12 * scale);
}

// Padded lengths of these grids use the radices 2, 3, 4 and 5 in turn.
INSTANTIATE_TEST_SUITE_P(Sizes, HalfspaceConvolution,
                         testing::Values(std::pair{1, 1}, std::pair{3, 4}, std::pair{8, 13},
                                         std::pair{12, 23}, std::pair{14, 16}));

}  // namespace
}  // namespace wrc::halfspace
