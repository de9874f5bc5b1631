#include "tangential/march/march_grid.hpp"

#include <algorithm>
#include <cmath>

#include "base/elementary.hpp"

namespace wrc {

MarchGrid make_march_grid(std::int32_t cells, double* memory, const Kernels& kernels) {
  double* const parabolic_mean = memory;
  double* const parabolic_rise = memory + cells;
  double* const elliptic_mean = memory + 2 * cells;
  double* const elliptic_rise = memory + 3 * cells;
  double* const place = memory + 4 * cells;
  double* const pressure = memory + 5 * cells;
  double* const inverse_pressure = memory + 6 * cells;
  double* const inverse_weight = memory + 7 * cells;

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
    const double lead = border(i), trail = border(i + 1);
    parabolic_mean[i] = (parabola_integral(lead) - parabola_integral(trail)) / size;
    parabolic_rise[i] = half_square_rise(1.0 - lead * lead, 1.0 - trail * trail, parabolic_mean[i]);
    elliptic_mean[i] = (ellipse_integral(lead) - ellipse_integral(trail)) / size;
    elliptic_rise[i] = half_square_rise(ellipse(lead), ellipse(trail), elliptic_mean[i]);
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

}  // namespace wrc
