/// Stresses in a half-space under a load that is constant on a rectangular cell: closed forms of Boussinesq,
/// Love (1929) and Cerruti, and those of a force at a point for cells far away.
///
/// The body lies at z >= 0 and x, y, z are the contact frame's for the rail; a wheel is its mirror image in
/// the contact plane, z its own depth. With F(x, y, z) = IInt load ln(r + z), F1 = IInt load (z ln(r + z) -
/// r), so that dF1/dz = F (Johnson, Contact Mechanics, 3.2), a pressure p into the body gives
///     2 pi s_xx = 2 nu F_zz - z F_xxz - (1 - 2 nu) F_xx       2 pi s_xy = -(1 - 2 nu) F_xy - z F_xyz
///     2 pi s_zz = F_zz - z F_zzz                              2 pi s_zx = -z F_xzz
/// and a traction q along x on the body
///     2 pi s_xx = 2 (1 + nu) F_xz + 2 nu F1_xxx - z F_xxx     2 pi s_xy = F_yz + 2 nu F1_xxy - z F_xxy
///     2 pi s_yy = 2 nu F_xz + 2 nu F1_xyy - z F_xyy           2 pi s_yz = -z F_xyz
///     2 pi s_zz = -z F_xzz                                    2 pi s_zx = F_zz - z F_xxz,
/// those left out by exchange of x and y. (The second set: Hooke's law on Johnson's displacements.)
#pragma once

#include "damage/stress.hpp"

namespace wrc::damage {

/// Stresses per unit load of a cell: a pressure into the body, tractions along x and y on the body.
struct CellStress {
  Stress of_pressure, of_traction_x, of_traction_y;
};

/// At (x, y) from the centre of a cell of size dx x dy [m] and at the depth z >= 0. At z = 0 not on the
/// cell's border, where a traction's stress is infinite.
CellStress cell_stress(double poisson, double x, double y, double z, double dx, double dy);

/// Its share at one corner, of which a cell's stress is the double difference: X, Y from the corner.
CellStress corner_stress(double poisson, double X, double Y, double z);

/// Stress of forces at a point of the surface, along z (into the body), x and y [N]: Boussinesq, Cerruti. Not
/// at the point itself.
Stress point_force_stress(double poisson, double x, double y, double z, double normal, double along,
                          double across);

void add(const Stress& from, double factor, Stress& to);
void add(const CellStress& from, double factor, CellStress& to);

}  // namespace wrc::damage
