/// Stresses below strips in bounded time against the exact ones of the same loads.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <vector>

#include "damage/cell_stress.hpp"
#include "damage/subsurface.hpp"
#include "halfspace/subsurface.hpp"

namespace wrc::damage {
namespace {

constexpr double nu = 0.28;

/// An ellipse in strips, its tractions a share of the pressure: full slip.
struct Slipping {
  static constexpr std::int32_t strips = 60, cells = 32;
  double a, b;
  std::vector<double> y, width, centre, half, peak, pressure, x, y_traction;
  patch::Strips region{};
  tangential::TangentialFields fields{};

  Slipping(double a_, double b_, double share_x, double share_y) : a(a_), b(b_) {
    for (std::int32_t j = 0; j < strips; ++j) {
      y.push_back(b * ((2.0 * j + 1.0) / strips - 1.0));
      const double eta = y.back() / b;
      width.push_back(2.0 * b / strips);
      centre.push_back(0.0);
      half.push_back(a * std::sqrt(1.0 - eta * eta));
      peak.push_back(std::sqrt(1.0 - eta * eta));
    }
    for (std::int32_t i = 0; i < cells; ++i) {
      const double xi = 1.0 - (2.0 * i + 1.0) / cells;
      pressure.push_back(std::sqrt(1.0 - xi * xi));
      for (std::size_t j = 0; j < strips; ++j) {
        x.push_back(share_x * peak[j] * pressure.back());
        y_traction.push_back(share_y * peak[j] * pressure.back());
      }
    }
    region = {strips, strips, y.data(), width.data(), centre.data(), half.data(), peak.data()};
    fields = {x.data(), y_traction.data(), nullptr, nullptr};
  }
  LoadLanes lanes(double way = 1.0, double sign = 1.0, InstructionSet set = best_instruction_set()) const {
    LoadLanes loads(nu, kernels_for(set));
    loads.add_patch(region, pressure.data(), fields, cells, strips, way, sign);
    return loads;
  }
};

TEST(StripStresses, CircleIsHertz) {
  const LoadLanes loads = Slipping(1.0, 1.0, 0.0, 0.0).lanes();
  for (const double z : {0.2, 0.48, 1.0}) {
    const Stress s = loads.at(0.0, 0.0, z);
    EXPECT_NEAR(s.zz, -1.0 / (1.0 + z * z), 0.01);
    EXPECT_NEAR(s.xx, -(1.0 + nu) * (1.0 - z * std::atan(1.0 / z)) + 0.5 / (1.0 + z * z), 0.01);
  }
  StressPeaks below = loads.peaks(0.4);
  EXPECT_NEAR(below.shear.value, 0.311, 3e-3);
  loads.refine(below.shear, &StressPeaks::shear, 0.3, 0.6, below);
  EXPECT_NEAR(below.shear.value, 0.3145, 2e-3);
  EXPECT_NEAR(below.shear.z, 0.48, 0.02);
  const StressPeaks surface = loads.peaks(0.0);
  EXPECT_NEAR(surface.tension.value, (1.0 - 2.0 * nu) / 3.0, 0.01);  // at the edge
}

TEST(StripStresses, AreTheExactOnesOfTheSameLoads) {
  const Slipping patch(2.0, 1.0, -0.35, 0.1);
  const LoadLanes loads = patch.lanes();
  halfspace::BodyLoads exact;
  exact.grid = halfspace::grid_over_box(-2.0, 2.0, -1.0, 1.0, 96, 64);
  exact.poisson = nu;
  for (std::size_t k = 0; k < exact.grid.cells(); ++k) {
    const double x = exact.grid.x(static_cast<int>(k) % 96) / 2.0, y = exact.grid.y(static_cast<int>(k) / 96);
    exact.pressure.push_back(std::sqrt(std::fmax(0.0, 1.0 - x * x - y * y)));
    exact.traction_x.push_back(-0.35 * exact.pressure.back());
    exact.traction_y.push_back(0.1 * exact.pressure.back());
  }
  halfspace::StressField field(exact);
  for (const double z : {0.0, 0.1, 0.5}) {
    const StressPeaks found = loads.peaks(z), truth = field.peaks(z);
    EXPECT_NEAR(found.von_mises.value, truth.von_mises.value, 0.01 * truth.von_mises.value) << z;
    EXPECT_NEAR(found.shear.value, truth.shear.value, 0.01 * truth.shear.value) << z;
    if (z < 0.5) {  // deeper what is left of it lies further out than is looked
      EXPECT_NEAR(found.tension.value, truth.tension.value, 0.05 * truth.tension.value) << z;
    }
    const Stress here = loads.at(0.31, -0.17, z), there = halfspace::stress_at(exact, 0.31, -0.17, z);
    for (double Stress::*each :
         {&Stress::xx, &Stress::yy, &Stress::zz, &Stress::xy, &Stress::yz, &Stress::zx})
      EXPECT_NEAR(here.*each, there.*each, z > 0.0 ? 0.01 : 0.03) << z;
  }
}

// Short and wide, so that a lane is wider than the points along it lie apart.
TEST(StripStresses, OfALineContactAreHertzs) {
  const LoadLanes loads = Slipping(1.0, 10.0, 0.0, 0.0).lanes();
  for (const double z : {0.1, 0.2, 0.3, 0.5, 0.786, 1.0, 1.5, 2.0}) {
    const double middle = -1.0 / std::sqrt(1.0 + z * z);        // Johnson 1985, 4.2
    EXPECT_NEAR(loads.at(0.0, 0.0, z).zz, middle, 0.015) << z;  // between two of 20 lanes
    EXPECT_NEAR(loads.at(0.0, 0.5, z).zz, middle, 0.015) << z;  // below the centre of one
  }
}

/// A circle whose strips adhere at the leading edge as Carter's rolling cylinder does: tractions -mu p, less
/// a smaller semi-ellipse where it adheres (Haines and Ollerton 1963: what slips is as long in every strip).
struct Carter {
  static constexpr double mu = 0.5, slips = 0.7;
  static double traction(double x, double y) {
    const double half2 = 1.0 - y * y;
    if (half2 <= x * x) return 0.0;
    const double adheres = std::sqrt(half2) - 0.5 * slips, middle = 0.5 * slips;
    const double less2 = adheres > 0.0 ? adheres * adheres - (x - middle) * (x - middle) : 0.0;
    return -mu * (std::sqrt(half2 - x * x) - std::sqrt(std::fmax(0.0, less2)));
  }
};

TEST(StripStresses, PeakWhereAdhesionEnds) {
  Slipping patch(1.0, 1.0, 0.0, 0.0);
  std::vector<double> slip;
  for (std::int32_t i = 0; i < Slipping::cells; ++i) {
    for (std::size_t j = 0; j < Slipping::strips; ++j) {
      const double x = patch.half[j] * (1.0 - (2.0 * i + 1.0) / Slipping::cells);
      patch.x[slip.size()] = Carter::traction(x, patch.y[j]);
      slip.push_back(x < Carter::slips - patch.half[j] ? 1e-3 : 0.0);
    }
  }
  const std::vector<double> none(slip.size(), 0.0);
  patch.fields.slip_x = slip.data();
  patch.fields.slip_y = const_cast<double*>(none.data());
  halfspace::BodyLoads exact;
  exact.grid = halfspace::grid_over_box(-1.0, 1.0, -1.0, 1.0, 128, 64);
  exact.poisson = nu;
  for (std::size_t k = 0; k < exact.grid.cells(); ++k) {
    const double x = exact.grid.x(static_cast<int>(k) % 128), y = exact.grid.y(static_cast<int>(k) / 128);
    exact.pressure.push_back(std::sqrt(std::fmax(0.0, 1.0 - x * x - y * y)));
    exact.traction_x.push_back(Carter::traction(x, y));
    exact.traction_y.push_back(0.0);
  }
  const LoadLanes loads = patch.lanes();
  const StressPeak found = loads.peaks(0.0).von_mises;
  // A cusp: its height depends on how near to it is looked, so the exact one is taken at the same place.
  const double truth = von_mises(halfspace::stress_at(exact, found.x, found.y, 0.0));
  EXPECT_NEAR(found.value, truth, 0.01 * truth);
  const double border = Carter::slips - std::sqrt(1.0 - found.y * found.y);
  EXPECT_LT(found.x, border);
  EXPECT_GT(found.x, border - 0.05);
  patch.fields.slip_x = nullptr;  // the same without knowing where adhesion ends
  EXPECT_LT(patch.lanes().peaks(0.0).von_mises.value, 0.985 * found.value);
}

TEST(StripStresses, TurnedLoadsTurnTheStresses) {
  const Slipping patch(2.0, 1.0, 0.3, 0.0);
  const StressPeaks forward = patch.lanes().peaks(0.2), other_body = patch.lanes(1.0, -1.0).peaks(0.2),
                    backward = patch.lanes(-1.0).peaks(0.2);
  EXPECT_NEAR(other_body.von_mises.value, forward.von_mises.value, 1e-9);
  EXPECT_NEAR(backward.von_mises.value, forward.von_mises.value, 1e-9);  // full slip: no edge leads
  // The places that are looked at do not lie alike at both ends.
  EXPECT_NEAR(other_body.tension.value, forward.tension.value, 0.01 * forward.tension.value);
  EXPECT_NEAR(other_body.tension.x, -forward.tension.x, 0.1);
}

// Depths at which rectangles, points, and few points serve.
TEST(StripStresses, HaveTheSameBitsWithEveryInstructionSet) {
  const Slipping patch(2.0, 1.0, -0.35, 0.1);
  const auto numbers = [&](InstructionSet set) {
    const LoadLanes loads = patch.lanes(1.0, 1.0, set);
    std::vector<double> all;
    for (const double z : {0.0, 0.1, 0.5, 1.5}) {
      const Stress s = loads.at(0.31, -0.17, z);
      const StressPeaks found = loads.peaks(z);
      all.insert(all.end(), {s.xx, s.yy, s.zz, s.xy, s.yz, s.zx});
      for (const StressPeak& peak : {found.von_mises, found.shear, found.tension})
        all.insert(all.end(), {peak.value, peak.x, peak.y});
    }
    return all;
  };
  const std::vector<double> baseline = numbers(InstructionSet::baseline);
  for (const InstructionSet set : {InstructionSet::avx2, InstructionSet::avx512}) {
    if (set > best_instruction_set()) continue;
    const std::vector<double> wide = numbers(set);
    EXPECT_EQ(std::memcmp(baseline.data(), wide.data(), baseline.size() * sizeof(double)), 0)
        << static_cast<int>(set);
  }
}

// Far away a cell is a force at a point, in all components.
TEST(CellStress, FarAwayIsThatOfAPointForce) {
  for (const double z : {0.0, 7.0}) {
    const double x = 30.0, y = -20.0, r2 = x * x + y * y + z * z;
    const CellStress cell = cell_stress(nu, x, y, z, 0.1, 0.1);
    const Stress points[3] = {point_force_stress(nu, x, y, z, 0.01, 0.0, 0.0),
                              point_force_stress(nu, x, y, z, 0.0, 0.01, 0.0),
                              point_force_stress(nu, x, y, z, 0.0, 0.0, 0.01)};
    const Stress cells[3] = {cell.of_pressure, cell.of_traction_x, cell.of_traction_y};
    for (int k = 0; k < 3; ++k)
      for (double Stress::*each :
           {&Stress::xx, &Stress::yy, &Stress::zz, &Stress::xy, &Stress::yz, &Stress::zx})
        EXPECT_NEAR(cells[k].*each, points[k].*each, 1e-5 * 0.01 / r2) << k;
  }
}

}  // namespace
}  // namespace wrc::damage
