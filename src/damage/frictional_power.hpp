/// Frictional power over the contact patch, the input of wear models (Liu, Bruni 2024, eq. 10).
#pragma once

#include <cstdint>

#include "patch/strips.hpp"
#include "tangential/problem.hpp"

namespace wrc {

/// Power density P_f = -V (s_x p_x + s_y p_y) [W/m^2] of every cell, from the traction and slip fields (all
/// four set), V the rolling speed [m/s]. density: cells * strips values, laid out as the fields.
void frictional_power_density(const TangentialFields& fields, std::int32_t strips, std::int32_t cells,
                              double rolling_speed, double* density);

/// Power per unit width [W/m] of every strip: the density integrated along the rolling direction.
void frictional_power_per_width(const double* density, const Strips& strips, std::int32_t cells,
                                double* per_width);

/// Total frictional power [W]: the power per width integrated across the patch.
double frictional_power(const double* per_width, const Strips& strips);

/// T-gamma [N]: the energy dissipated per metre rolled, total frictional power / rolling speed. It includes
/// the work of spin.
inline double t_gamma(const TangentialForces& forces) { return forces.power_per_speed; }

/// T-gamma without spin [N], |Fx nu_x + Fy nu_y|: the form track engineering tabulates; it leaves out Mz phi.
double t_gamma_without_spin(const TangentialForces& forces, const Creepage& creepage);

}  // namespace wrc
