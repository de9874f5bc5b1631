#include "damage/fatigue.hpp"

#include <algorithm>
#include <cmath>

namespace wrc {

ShakedownPoint shakedown_point(const TangentialForces& forces, double normal_force, double peak_pressure,
                               double shear_yield) {
  if (!(normal_force > 0.0)) return {};
  return {std::sqrt(forces.fx * forces.fx + forces.fy * forces.fy) / normal_force,
          peak_pressure / shear_yield};
}

double fatigue_index(const ShakedownPoint& point) {
  return point.load_factor > 0.0
             ? std::max(no_fatigue_index, point.utilised_friction - 1.0 / point.load_factor)
             : no_fatigue_index;
}

void local_fatigue_index(const TangentialFields& fields, const Strips& strips, std::int32_t cells,
                         double shear_yield, double* index) {
  for (std::int32_t i = 0; i < cells; ++i) {
    const double t = 1.0 - (2.0 * i + 1.0) / cells;
    const double shape = std::sqrt(1.0 - t * t);
    for (std::int32_t j = 0; j < strips.count; ++j) {
      const std::int32_t at = i * strips.count + j;
      const double px = fields.traction_x[at], py = fields.traction_y[at];
      const double pressure = strips.peak[j] * shape;
      index[at] = pressure > 0.0
                      ? std::max(no_fatigue_index, (std::sqrt(px * px + py * py) - shear_yield) / pressure)
                      : no_fatigue_index;
    }
  }
}

double shakedown_limit(double friction) {
  const double in_depth = 0.25 + friction * (0.3025 + 0.045 * friction);
  return 1.0 / std::max(in_depth, friction);
}

}  // namespace wrc
