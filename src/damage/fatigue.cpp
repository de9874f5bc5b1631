#include "damage/fatigue.hpp"

#include <algorithm>
#include <cmath>

namespace wrc::damage {

ShakedownPoint shakedown_point(const tangential::TangentialForces& forces, double normal_force,
                               double peak_pressure, double shear_yield) {
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

double shakedown_limit_of_point(double friction) {
  constexpr double surface_first = 0.22;  // where both are 4.5
  if (friction > surface_first) return 1.0 / friction;
  const double square = friction * friction;
  return 1.0 / std::max(0.2139 + square * (0.1 + 0.25 * square), friction);
}

double whole_life_damage(const WholeLifeLaw& law, double t_gamma) {
  if (!(t_gamma > law.start)) return 0.0;
  return t_gamma < law.peak_at ? law.peak * (t_gamma - law.start) / (law.peak_at - law.start)
                               : law.peak * (law.end - t_gamma) / (law.end - law.peak_at);
}

}  // namespace wrc::damage
