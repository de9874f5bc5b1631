#include "tangential/march/march_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/arena.hpp"
#include "base/elementary.hpp"

namespace wrc::tangential {

namespace {

std::array<double*, 8> cut(Arena& arena, std::int32_t cells) {
  std::array<double*, 8> arrays{};
  for (double*& array : arrays) array = arena.take(cells);
  return arrays;
}

}  // namespace

std::size_t march_grid_size(std::int32_t cells) {
  Arena arena;
  cut(arena, cells);
  return static_cast<std::size_t>(arena.doubles());
}

MarchGrid make_march_grid(std::int32_t cells, double* memory, const Kernels& kernels) {
  Arena arena(memory);
  const auto [parabolic_mean, parabolic_rise, elliptic_mean, elliptic_rise, place, pressure, inverse_pressure,
              inverse_weight] = cut(arena, cells);

  // integrals of 1 - s^2 and sqrt(1 - s^2), whose differences over a cell are exact means
  const double size = 2.0 / cells;
  const auto border = [&](std::int32_t i) { return 1.0 - size * i; };  // s, falling from 1 to -1
  const auto ellipse = [](double s) { return std::sqrt(std::max(0.0, 1.0 - s * s)); };
  const auto parabola_integral = [](double s) { return s - s * s * s / 3.0; };
  const auto ellipse_integral = [&](double s) {
    return 0.5 * (s * ellipse(s) + arcsine(std::clamp(s, -1.0, 1.0)));
  };
  const auto half_square_rise = [](double lead, double trail, double mean) {
    return 0.5 * (trail * trail - lead * lead) / mean;
  };
  for (std::int32_t i = 0; i < cells; ++i) {
    // the bounds' means, and their change as half that of the square over the mean
    const double lead = border(i), trail = border(i + 1);
    parabolic_mean[i] = (parabola_integral(lead) - parabola_integral(trail)) / size;
    parabolic_rise[i] = half_square_rise(1.0 - lead * lead, 1.0 - trail * trail, parabolic_mean[i]);
    elliptic_mean[i] = (ellipse_integral(lead) - ellipse_integral(trail)) / size;
    elliptic_rise[i] = half_square_rise(ellipse(lead), ellipse(trail), elliptic_mean[i]);
    // at the middle, where fields and damage are read; then the weight of the closed form's root
    place[i] = 1.0 - (2.0 * i + 1.0) / cells;
    pressure[i] = std::sqrt(1.0 - place[i] * place[i]);
    inverse_pressure[i] = 1.0 / pressure[i];
    const double ahead = cells - i, behind = ahead - 1.0;
    inverse_weight[i] = 1.0 / (ahead * std::sqrt(ahead) - behind * std::sqrt(behind));
  }
  return {cells,
          {parabolic_mean, parabolic_rise},
          {elliptic_mean, elliptic_rise},
          {place, pressure, inverse_pressure},
          inverse_weight,
          &kernels};
}

}  // namespace wrc::tangential
