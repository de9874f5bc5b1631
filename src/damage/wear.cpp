#include "damage/wear.hpp"

#include "base/elementary.hpp"

namespace wrc::damage {

double worn_area_rate(const TGammaWearLaw& law, double t_gamma, double wheel_diameter) {
  const double mm3_per_km = t_gamma < law.t1    ? law.slope_mild * t_gamma
                            : t_gamma <= law.t2 ? law.plateau
                                                : law.slope_severe * t_gamma - law.offset_severe;
  // mm^3/km = 1e-12 m^3/m
  return mm3_per_km * 1e-12 / wheel_diameter;
}

double wear_depth_rate(const SheffieldWearLaw& law, double t_gamma_density) {
  const double x = t_gamma_density * 1e-6;  // N/mm^2
  const double plateau = law.slope_mild * law.x1;
  const double rate = x < law.x1    ? law.slope_mild * x
                      : x <= law.x2 ? plateau
                                    : plateau + law.slope_catastrophic * (x - law.x2);
  // microgram/(m mm^2) = 1e-3 kg/(m m^2)
  return rate * 1e-3 / law.density;
}

double wear_coefficient(const ArchardWearLaw& law, double pressure, double sliding_velocity) {
  const double by_speed = sliding_velocity < law.v1    ? law.mild_low_speed
                          : sliding_velocity <= law.v2 ? law.severe
                                                       : law.mild_high_speed;
  return pressure > law.seizure_pressure * law.hardness ? law.seizure : by_speed;
}

double wear_depth_velocity(const ArchardWearLaw& law, double pressure, double sliding_velocity) {
  return wear_coefficient(law, pressure, sliding_velocity) * pressure * sliding_velocity / law.hardness;
}

double wear_depth_velocity(const PowerWearLaw& law, double power_density) {
  if (!(power_density > 0.0)) return 0.0;
  const double proportional = law.coefficient / law.density * power_density;
  if (law.exponent == 1.0) return proportional;
  const double least = 1e-30 * law.reference;  // far below any density that wears
  const double ratio = (power_density > least ? power_density : least) / law.reference;
  return proportional * natural_exp((law.exponent - 1.0) * natural_log(ratio));
}

}  // namespace wrc::damage
