/// Strips that remember (surface/rolling/remembering.hpp): energy, parts of patches, rows of places.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "kernels/kernels.hpp"
#include "patch/material.hpp"
#include "surface/rolling/remembering.hpp"
#include "tangential/methods/strip_memory.hpp"

namespace wrc::surface {
namespace {

/// Strips under random loads that wander, open, close and move in any way.
class Strips {
 public:
  static constexpr std::int32_t most = 24;

  Strips()
      : ellipse_(0.28),
        coefficients_(ellipse_),
        theory_(0.28),
        march_(tangential::march_grid_size(16)),
        grid_(tangential::make_march_grid(16, march_.data(), kernels_for(InstructionSet::baseline))),
        memory_(tangential::strip_memory_bytes(most) / sizeof(double) + 1),
        scratch_(bytes_of_scratch() / sizeof(double) + 8) {
    tangential::make_strip_memory(most, memory_.data());
  }

  /// A step; work put in and friction's work [J].
  struct Work {
    double in, dissipated;
  };
  Work go(std::mt19937& random) {
    const auto number = [&](double low, double high) {
      return low + (high - low) * std::uniform_real_distribution<>()(random);
    };
    const auto one_of = [&](int n) { return std::uniform_int_distribution<>(0, n - 1)(random) == 0; };
    // two humps that wander, grow and shrink
    centre_ += number(-2e-4, 2e-4);
    centre_ = std::clamp(centre_, -2e-3, 2e-3);
    second_ = std::clamp(second_ + number(-0.05, 0.05), 0.0, 1.0);
    load_ = std::clamp(load_ + number(-0.1, 0.1), 0.3, 1.0);
    std::int32_t count = 0;
    const double turn = one_of(3) ? number(-2.0, 2.0) : 0.0, slip = one_of(4) ? 0.0 : number(-3e-3, 3e-3),
                 across = number(-3e-3, 3e-3);
    for (std::int32_t j = 0; j < most; ++j) {
      const double y = rail_place_[j] = 5e-4 * (j - 0.5 * most);
      const auto hump = [&](double at, double width, double size) {
        const double t = (y - at) / width;
        return size * std::max(0.0, 1.0 - t * t);
      };
      const double square =
          load_ * (hump(centre_, 3e-3, 36e-6) + hump(centre_ - 4e-3, 1.5e-3, 16e-6 * second_));
      if (!(square > 1e-9)) continue;
      place_[count] = y;
      width_[count] = 5e-4;
      half_length_[count] = std::sqrt(square);
      peak_[count] = 2e11 * half_length_[count];
      curvature_[count] = 2.2;
      slip_x_[count] = slip - turn * y;
      slip_y_[count] = across;
      spin_[count] = turn;
      friction_[count] = 0.3 + 0.1 * std::sin(500.0 * y);
      along_[count] = 1e-4 * std::sin(300.0 * y);
      number_[count++] = j;
    }
    const double travel = std::pow(10.0, number(-6.0, -1.5)),
                 rolled = one_of(3) ? 0.0 : travel * number(0.0, 2.0);
    const RememberingResult result = roll(count, travel, rolled, one_of(2) ? -1.0 : 1.0);
    double work = 0.0;
    for (std::int32_t k = 0; k < count; ++k) {
      work -= travel * (fx_[k] * slip_x_[k] + fy_[k] * slip_y_[k] + mz_[k] * spin_[k]);
      EXPECT_TRUE(std::isfinite(fx_[k]) && std::isfinite(fy_[k]) && std::isfinite(mz_[k]));
    }
    if (!one_of(4))
      memory().turn_over();  // trial steps are not kept
    else
      return {0.0, 0.0};
    return {work, result.dissipated};
  }

 protected:
  tangential::Memory& memory() { return *reinterpret_cast<tangential::Memory*>(memory_.data()); }

  /// Rolls `count` strips of the arrays below.
  RememberingResult roll(std::int32_t count, double travel, double rolled, double direction) {
    SurfaceRollingInput strips;
    strips.count = count;
    rail_.s = rail_place_;
    strips.place = place_;
    strips.width = width_;
    strips.half_length = half_length_;
    strips.peak = peak_;
    strips.curvature = curvature_;
    strips.slip_x = slip_x_;
    strips.slip_y = slip_y_;
    strips.spin = spin_;
    strips.friction = friction_;
    strips.shear_modulus = strips.normal_shear_modulus = 82e9;
    strips.coefficients = &coefficients_;
    strips.grid = &grid_;
    // nothing is read before it is written
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    std::fill(scratch_.begin(), scratch_.end(), nan);
    std::fill_n(&memory().other()->y, count * sizeof(tangential::PastStrip) / sizeof(double), nan);
    const RememberingInput step{strips,         along_,          number_,
                                rail_,          theory_,         travel,
                                rolled,         direction,       memory().remembered(),
                                memory().count, memory().other()};
    const RememberingResult result = roll_remembering(step, Arena(aligned()), {fx_, fy_, mz_});
    memory().written = count;
    return result;
  }

  RailStrips rail_ = [] {
    RailStrips rail;
    rail.ranges = 1;
    rail.range[0] = {0, most, 0.0, 0.0, 0.0};
    return rail;
  }();
  double place_[most], width_[most], half_length_[most], peak_[most], curvature_[most], slip_x_[most],
      slip_y_[most], spin_[most], friction_[most], along_[most], number_[most], rail_place_[most], fx_[most],
      fy_[most], mz_[most];

 private:
  static std::size_t bytes_of_scratch() {
    Arena arena;
    count_remembering(arena, most);
    return static_cast<std::size_t>(arena.bytes());
  }
  void* aligned() {
    auto at = reinterpret_cast<std::uintptr_t>(scratch_.data());
    return reinterpret_cast<void*>((at + 63) / 64 * 64);
  }

  theory::KalkerTable ellipse_;
  StripCoefficientTable coefficients_;
  theory::SdecTable theory_;
  std::vector<double> march_;
  tangential::MarchGrid grid_;
  std::vector<double> memory_, scratch_;
  double centre_ = 0.0, second_ = 0.5, load_ = 1.0;
};

TEST(SurfaceRemembering, GivesBackNoMoreThanWasPutIn) {
  std::mt19937 random(3);
  Strips strips;
  double balance = 0.0, exchanged = 0.0, worst = 0.0;
  for (int i = 0; i < 20000; ++i) {
    const Strips::Work work = strips.go(random);
    balance += work.in;
    exchanged += std::abs(work.in);
    worst = std::min(worst, balance);
    EXPECT_GE(work.dissipated, -1e-12 * exchanged);
  }
  EXPECT_GT(exchanged, 0.0);
  EXPECT_GE(worst, -1e-9 * exchanged) << "energy gained";
}

/// Strips that a test gives one by one.
struct GivenStrips : Strips {
  using Strips::memory, Strips::roll, Strips::rail_, Strips::rail_place_, Strips::fx_, Strips::peak_,
      Strips::friction_, Strips::half_length_;
  std::int32_t count = 0;

  /// A strip with this number, under creepages, and spin about `place` = 0.
  void add(std::int32_t number, double place, double width, double half_length, double along, double spin) {
    place_[count] = place;
    width_[count] = width;
    half_length_[count] = half_length;
    peak_[count] = 2e11 * half_length;
    curvature_[count] = 2.2;
    slip_x_[count] = 1e-3 - spin * place;
    slip_y_[count] = 0.0;
    spin_[count] = spin;
    friction_[count] = 0.3;
    along_[count] = along;
    number_[count++] = number;
  }
};

/// The valley's lowest point lies within the last strip, which is wide, or mirrored the first. So one patch
/// has a part of each strip.
TEST(SurfaceRemembering, AStripThatAValleyCutsIsOfBothPatches) {
  constexpr double unit = 0.5e-3, largest = 5e-3;
  const double widths[] = {1.0, 1.0, 0.5, 1.5}, places[] = {-2.0, -1.0, 0.0, 1.0},
               loads[] = {0.9, 1.0, 0.05, 0.1};
  double force[4];
  for (const bool mirrored : {false, true}) {
    GivenStrips strips;
    for (int i = 0; i < 4; ++i) {
      const int from = mirrored ? 3 - i : i;
      strips.add(i, (mirrored ? -unit : unit) * places[from], unit * widths[from],
                 largest * std::sqrt(loads[from]), 0.0, 0.0);
    }
    // far enough to slide everywhere
    strips.roll(strips.count, 0.05, 5e-3, 1.0);
    for (int i = 0; i < 4; ++i) {
      double& same = force[mirrored ? 3 - i : i];
      if (!mirrored) same = strips.fx_[i];
      EXPECT_NEAR(strips.fx_[i], same, 1e-6 * std::abs(same)) << i;
      const tangential::PastStrip& strip = strips.memory().other()[i];
      for (int cell = 0; cell < tangential::memory_cells; ++cell) {
        const double bound = strip.bound[std::min(cell, tangential::memory_cells - 1 - cell)];
        EXPECT_LE(std::hypot(strip.px[cell], strip.py[cell]), (1.0 + 1e-9) * bound) << i << " " << cell;
      }
    }
  }
}

/// The valley's lowest point lies midway between two strips. Rounded, their border is on either side of it,
/// or both strips overlap there: each counts once.
TEST(SurfaceRemembering, AValleyMidwayBetweenStripsIsTheLimitOfThoseBeside) {
  constexpr double width = 0.5e-3;
  const double loads[] = {0.7, 1.0, 0.8, 0.1, 0.1, 0.8, 1.0, 0.7};
  for (int place = 0; place < 100; ++place) {
    double force[8];
    for (const double more : {1e-9, 0.0}) {
      GivenStrips strips;
      for (int i = 0; i < 8; ++i)
        strips.add(i, 1e-5 * place + width * (i - 3.5), width,
                   4e-3 * std::sqrt(loads[i] * (i == 3 ? 1.0 + more : 1.0)), 0.0, 0.0);
      strips.roll(strips.count, 5e-4, 5e-4, 1.0);
      for (int i = 0; i < 8; ++i) {
        if (more > 0.0) force[i] = strips.fx_[i];
        ASSERT_NEAR(strips.fx_[i], force[i], 1e-6 * std::abs(force[i])) << place << " " << i;
      }
    }
  }
}

/// A hump whose load is too small for its means leaves the others as they are.
TEST(SurfaceRemembering, AHumpOfTheLeastLoadIsNone) {
  double force[4];
  for (const double peak : {1e-200, 1e-320}) {
    GivenStrips strips;
    for (int i = 0; i < 7; ++i) {
      const double l = i < 4 ? 4e-3 - 1e-3 * std::abs(i - 1) : 4e-3;
      strips.add(i, 0.5e-3 * i, 0.5e-3, l, 0.0, 0.0);
    }
    strips.peak_[4] = strips.peak_[5] = strips.peak_[6] = 0.0;
    strips.peak_[5] = peak;
    for (int step = 0; step < 2; ++step) {
      strips.roll(strips.count, 5e-4, 5e-4, 1.0);
      strips.memory().turn_over();
      strips.friction_[0] = 0.0;  // its force is lost
    }
    for (int i = 0; i < 4; ++i) {
      if (peak == 1e-200) force[i] = strips.fx_[i];
      EXPECT_NEAR(strips.fx_[i], force[i], 1e-9 * std::abs(force[i])) << i;
    }
  }
}

/// A place at the end of a ramp becomes the first row of its face. Forces lost on the ramp are none of its
/// own, whether or not another face is in contact.
TEST(SurfaceRemembering, FacesRenumberTheirRowsByThemselves) {
  constexpr int of_face = 8;
  double alone[of_face];
  for (const bool other_face : {false, true}) {
    GivenStrips strips;
    strips.rail_.ranges = 2;
    strips.rail_.range[0] = {0, of_face, 0.0, 0.0, 0.0};
    strips.rail_.range[1] = {of_face, Strips::most - of_face, 0.0, 0.0, 0.0};
    for (int i = 0; i < Strips::most; ++i) strips.rail_place_[i] = 0.5e-3 * i + (i < of_face ? 0.0 : 1.0);
    const auto add_row = [&](int first, int count, int row, double along) {
      for (int i = first; i < first + count; ++i)
        strips.add(i + row * second_places, strips.rail_place_[i] + row * rows_apart, 0.5e-3, 4e-3, along,
                   0.0);
    };
    constexpr double rolled = 1e-3;
    add_row(0, of_face, 0, 0.0);
    if (other_face) add_row(of_face, of_face, 0, 0.0);
    add_row(0, of_face, 1, 10e-3);
    strips.roll(strips.count, rolled, rolled, 1.0);
    strips.memory().turn_over();
    strips.count = 0;
    add_row(0, of_face, 0, 10e-3 - rolled);
    if (other_face) add_row(of_face, of_face, 0, 0.0);
    strips.roll(strips.count, rolled, rolled, 1.0);
    for (int i = 0; i < of_face; ++i) {
      if (!other_face) alone[i] = strips.fx_[i];
      EXPECT_NEAR(strips.fx_[i], alone[i], 1e-9 * std::abs(alone[i])) << i;
    }
  }
}

/// Energy that the half-spaces store by their turning counts alike below and above 1.5 lengths.
TEST(SurfaceRemembering, EnergyGoesOnWhereSteadyRollingBegins) {
  GivenStrips strips;
  double longest = 0.0;
  for (int i = 0; i < 16; ++i) {
    const double y = 0.5e-3 * (i - 7.5), half_length = 4e-3 * std::sqrt(1.0 - y * y / 20e-6);
    longest = std::max(longest, 2.0 * half_length);
    strips.add(i, y, 0.5e-3, half_length, 0.0, 1.0);
  }
  const auto dissipated = [&](double lengths) {
    const double rolled = lengths * longest;
    return strips.roll(strips.count, rolled, rolled, 1.0).dissipated;
  };
  const double below = dissipated(1.5 - 1e-6);
  EXPECT_NEAR(dissipated(1.5 + 1e-6), below, 1e-4 * below);
}

/// Where nothing before the step is seen, its end has the cells of steady rolling: those of a step that is
/// hardly shorter.
TEST(SurfaceRemembering, CellsGoOnWhereNothingBeforeIsSeen) {
  GivenStrips strips;
  for (int i = 0; i < 16; ++i)
    strips.add(i, 0.5e-3 * (i - 7.5), 0.5e-3, 4e-3 * std::sqrt(1.0 - (i - 7.5) * (i - 7.5) / 80.0), 0.0, 1.0);
  const auto cells_after = [&](double lengths) {
    const double rolled = lengths * 2.0 * strips.half_length_[7];
    strips.roll(strips.count, rolled, rolled, 1.0);
    return std::vector(strips.memory().other(), strips.memory().other() + strips.count);
  };
  const auto before = cells_after(2.0 - 1e-6), beyond = cells_after(2.0 + 1e-6);
  for (int i = 0; i < strips.count; ++i)
    for (int cell = 0; cell < tangential::memory_cells; ++cell) {
      const double bound = before[i].bound[tangential::memory_cells / 2 - 1];
      EXPECT_NEAR(beyond[i].px[cell], before[i].px[cell], 1e-4 * bound) << i << " " << cell;
      EXPECT_NEAR(beyond[i].py[cell], before[i].py[cell], 1e-4 * bound) << i << " " << cell;
    }
}

}  // namespace
}  // namespace wrc::surface
