// Working memory of rolling is counted by the cut that uses it: nothing is written behind the counted size.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "surface/rolling/region_rolling.hpp"
#include "surface/rolling/rolling_arrays.hpp"
#include "tangential/methods/fastrip.hpp"
#include "tangential/methods/fastsim.hpp"
#include "tangential_patches.hpp"

namespace wrc::surface {
namespace {

/// As many numbers as asked for, and others behind them that nobody may touch.
class Guarded {
 public:
  explicit Guarded(std::size_t doubles) : memory_(doubles + guard, mark) {}
  double* data() { return memory_.data(); }
  bool intact() const {
    return std::all_of(memory_.end() - guard, memory_.end(), [](double x) { return x == mark; });
  }

 private:
  static constexpr std::ptrdiff_t guard = 64;
  static constexpr double mark = -1234.5;
  std::vector<double> memory_;
};

constexpr double G = 82e9, a = 6e-3, b = 4e-3, N = 80e3;

/// Hertz's ellipse, divided into strips that roll with slip along, across and spin.
struct Rolling {
  test::OwnedStrips owned;
  test::OwnedGrid grid{17};
  theory::SdecTable table{0.28};
  StripCoefficientTable coefficients{table.ellipse()};
  std::vector<double> curvature, slip_x, slip_y, spin, friction, fx, fy, mz;
  std::vector<double> field[4];
  SurfaceRollingInput in;

  explicit Rolling(int count) : owned(test::sdec_strips(a, b, 0.0, N, count)) {
    const patch::Strips& s = owned.get();
    const auto n = static_cast<std::size_t>(count);
    const double lambda = 1.5 * N / (pi * a * a * b);
    curvature.assign(n, hertz_relative_curvature(a / b) * (1.0 - 0.28) / G * lambda);
    slip_x.assign(n, 1e-3);
    slip_y.assign(n, -7e-4);
    spin.assign(n, 0.3);
    friction.assign(n, 0.3);
    for (auto* v : {&fx, &fy, &mz}) v->assign(n, 0.0);
    for (auto& f : field) f.assign(n * 17, 0.0);
    in = {.count = count, .place = s.y, .width = s.width, .half_length = s.half_length, .peak = s.peak};
    in.curvature = curvature.data();
    in.slip_x = slip_x.data();
    in.slip_y = slip_y.data();
    in.spin = spin.data();
    in.friction = friction.data();
    in.shear_modulus = in.normal_shear_modulus = G;
    in.coefficients = &coefficients;
    in.grid = &grid.get();
  }
  tangential::TangentialFields fields() {
    return {field[0].data(), field[1].data(), field[2].data(), field[3].data()};
  }
  SurfaceRollingForces forces() { return {fx.data(), fy.data(), mz.data()}; }
  double force() const {
    double x = 0.0, y = 0.0;
    for (std::size_t j = 0; j < fx.size(); ++j) {
      x += fx[j];
      y += fy[j];
    }
    return std::sqrt(x * x + y * y);
  }
};

TEST(RollingScratch, StripsKeepToTheirWorkspace) {
  for (const int count : {1, 7, 33}) {
    for (const auto method : {SurfaceRollingMethod::strip_fastsim, SurfaceRollingMethod::fastsim,
                              SurfaceRollingMethod::fastrip}) {
      Rolling rolling(count);
      rolling.in.method = method;
      Guarded workspace(surface_rolling_workspace(count));
      const SurfaceRollingTotals totals =
          roll_on_surface(rolling.in, workspace.data(), rolling.fields(), rolling.forces());
      EXPECT_TRUE(workspace.intact()) << count << " strips, method " << static_cast<int>(method);
      EXPECT_GT(rolling.force(), 0.05 * N);
      EXPECT_LT(rolling.force(), 0.3 * N * 1.001);
      EXPECT_GT(totals.power_per_speed, 0.0);
    }
  }
}

TEST(RollingScratch, PatchesKeepToTheirWorkspace) {
  for (const int count : {1, 7, 33}) {
    for (const bool fastrips : {false, true}) {
      Rolling rolling(count);
      RegionRolling method;
      method.solve = tangential::fastsim;
      if (fastrips) {
        method.solve = [](const tangential::RollingContact& c, const tangential::TangentialFields& fields,
                          Fault& fault, tangential::TangentialSensitivities*) {
          return tangential::fastrip(c, fields, fault);
        };
        method.workspace_bytes = tangential::fastrip_workspace(count, 17);
      }
      method.linear_theory = &rolling.table;
      const std::vector<double> along(static_cast<std::size_t>(count), 0.0);
      Guarded workspace(static_cast<std::size_t>(region_rolling_doubles(count, method)));
      roll_by_region({rolling.in, along.data()}, method, workspace.data(), rolling.fields(),
                     rolling.forces());
      EXPECT_TRUE(workspace.intact()) << count << " strips, FaStrip " << fastrips;
      EXPECT_GT(rolling.force(), 0.05 * N);
      EXPECT_LT(rolling.force(), 0.3 * N * 1.001);
    }
  }
}

TEST(RollingScratch, AGridKeepsToItsMemory) {
  for (const int cells : {1, 9, 64}) {
    Guarded memory(tangential::march_grid_size(cells));
    const tangential::MarchGrid grid =
        tangential::make_march_grid(cells, memory.data(), kernels_for(InstructionSet::baseline));
    EXPECT_TRUE(memory.intact()) << cells;
    // the last array cut: cell n - 1 has 1 / (1 - 0)
    EXPECT_EQ(grid.inverse_weight[cells - 1], 1.0);
  }
}

/// No two arrays share an element.
TEST(RollingScratch, ArraysLieApart) {
  constexpr int count = 5;
  std::vector<double> memory(static_cast<std::size_t>(rolling_doubles<double>(count)), 0.0);
  Arena arena(memory.data());
  const RollingArrays r = cut_rolling_arrays<double>(arena, count, count);
  std::vector<double*> arrays(std::begin(r.mean), std::end(r.mean));
  for (double* p :
       {r.load, r.link, r.pivot, r.c11, r.c22, r.c23, r.own, r.bound, r.growth_x, r.growth_y, r.curvature,
        r.slip_x, r.slip_y, r.elastic, r.turn_x, r.turn_y, r.edge_x, r.edge_y, r.across})
    arrays.push_back(p);
  for (double* p : arrays) std::for_each(p, p + count, [](double& x) { x += 1.0; });
  EXPECT_EQ(std::count(memory.begin(), memory.end(), 1.0),
            static_cast<std::ptrdiff_t>(arrays.size()) * count);
}

}  // namespace
}  // namespace wrc::surface
