#include "damage/frictional_power.hpp"

#include <cmath>

namespace wrc {

void frictional_power_density(const TangentialFields& fields, std::int32_t strips, std::int32_t cells,
                              double rolling_speed, double* density) {
  const std::int32_t count = strips * cells;
  for (std::int32_t i = 0; i < count; ++i) {
    density[i] =
        -rolling_speed * (fields.slip_x[i] * fields.traction_x[i] + fields.slip_y[i] * fields.traction_y[i]);
  }
}

void frictional_power_per_width(const double* density, const Strips& strips, std::int32_t cells,
                                double* per_width) {
  for (std::int32_t j = 0; j < strips.count; ++j) per_width[j] = 0.0;
  for (std::int32_t i = 0; i < cells; ++i) {
    for (std::int32_t j = 0; j < strips.count; ++j) per_width[j] += density[i * strips.count + j];
  }
  for (std::int32_t j = 0; j < strips.count; ++j) per_width[j] *= 2.0 * strips.half_length[j] / cells;
}

double frictional_power(const double* per_width, const Strips& strips) {
  double sum = 0.0;
  for (std::int32_t j = 0; j < strips.count; ++j) sum += per_width[j] * strips.width[j];
  return sum;
}

double t_gamma_without_spin(const TangentialForces& forces, const Creepage& creepage) {
  return std::fabs(forces.fx * creepage.longitudinal + forces.fy * creepage.lateral);
}

}  // namespace wrc
