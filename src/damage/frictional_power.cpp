#include "damage/frictional_power.hpp"

#include <cmath>

namespace wrc {

double t_gamma_without_spin(const TangentialForces& forces, const Creepage& creepage) {
  return std::fabs(forces.fx * creepage.longitudinal + forces.fy * creepage.lateral);
}

}  // namespace wrc
