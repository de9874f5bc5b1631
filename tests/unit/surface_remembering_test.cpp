/// Strips that remember give back no more than was put in (surface/rolling/remembering.hpp).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
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
    SurfaceRollingInput strips;
    strips.count = count;
    RailStrips rail;
    rail.s = rail_place_;
    rail.ranges = 1;
    rail.range[0] = {0, most, 0.0, 0.0, 0.0};
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
    const double travel = std::pow(10.0, number(-6.0, -1.5)),
                 rolled = one_of(3) ? 0.0 : travel * number(0.0, 2.0);
    auto& memory = *reinterpret_cast<tangential::Memory*>(memory_.data());
    const RememberingInput step{strips,
                                along_,
                                number_,
                                rail,
                                theory_,
                                travel,
                                rolled,
                                one_of(2) ? -1.0 : 1.0,
                                memory.remembered(),
                                memory.count,
                                memory.other()};
    const RememberingResult result = roll_remembering(step, Arena(aligned()), {fx_, fy_, mz_});
    memory.written = count;
    double work = 0.0;
    for (std::int32_t k = 0; k < count; ++k) {
      work -= travel * (fx_[k] * slip_x_[k] + fy_[k] * slip_y_[k] + mz_[k] * spin_[k]);
      EXPECT_TRUE(std::isfinite(fx_[k]) && std::isfinite(fy_[k]) && std::isfinite(mz_[k]));
    }
    if (!one_of(4))
      memory.turn_over();  // trial steps are not kept
    else
      return {0.0, 0.0};
    return {work, result.dissipated};
  }

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
  double place_[most], width_[most], half_length_[most], peak_[most], curvature_[most], slip_x_[most],
      slip_y_[most], spin_[most], friction_[most], along_[most], number_[most], rail_place_[most], fx_[most],
      fy_[most], mz_[most];
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

}  // namespace
}  // namespace wrc::surface
