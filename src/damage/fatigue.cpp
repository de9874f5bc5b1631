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

double shakedown_limit(double friction) {
  const double in_depth = 0.25 + friction * (0.3025 + 0.045 * friction);
  return 1.0 / std::max(in_depth, friction);
}

}  // namespace wrc
