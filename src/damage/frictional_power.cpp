#include "damage/frictional_power.hpp"

#include <cmath>

namespace wrc::damage {

double t_gamma_without_spin(const tangential::TangentialForces& forces,
                            const tangential::Creepage& creepage) {
  return std::fabs(forces.fx * creepage.longitudinal + forces.fy * creepage.lateral);
}

}  // namespace wrc::damage
