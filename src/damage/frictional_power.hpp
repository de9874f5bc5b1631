/// Frictional power of a contact as a whole, the input of wear models; cell by cell: damage/cells.hpp.
#pragma once

#include "tangential/problem.hpp"

namespace wrc::damage {

/// T-gamma [N]: the energy dissipated per metre rolled, total frictional power / rolling speed. It includes
/// the work of spin.
inline double t_gamma(const tangential::TangentialForces& forces) { return forces.power_per_speed; }

/// T-gamma without spin [N], |Fx nu_x + Fy nu_y|: the form track engineering tabulates; it leaves out Mz phi.
double t_gamma_without_spin(const tangential::TangentialForces& forces, const tangential::Creepage& creepage);

}  // namespace wrc::damage
