/// Influence coefficients: displacement differences of two elastic half-spaces under uniform loads on one
/// rectangular cell, in closed form.
///
/// Two bodies of the same material, loads equal and opposite, displacement u = u(wheel) - u(rail) per unit
/// traction on the wheel, evaluated at (x, y) from the cell's centre:
///     u_z = (1-nu)/(pi G) IInt p / r                                               Boussinesq, Love 1929
///     u_x = 1/(pi G) IInt [ ((1-nu)/r + nu x^2/r^3) p_x + nu x y/r^3 p_y ]         Cerruti; Johnson 3.2, 3.6
/// (u_y by exchange of x and y). Identical bodies: normal and tangential problems do not couple. For unlike
/// bodies G and nu are the combined values 2/G = 1/G1 + 1/G2, 2 nu/G = nu1/G1 + nu2/G2; the coupling through
/// Kalker's K = (G/4) ((1-2 nu1)/G1 - (1-2 nu2)/G2), 0 for equal materials, is beside these:
///     u_x under pressure            -K/(pi G) IInt p x/r^2         both bodies draw together under a load
///     opening under tractions        K/(pi G) IInt (p_x x + p_y y)/r^2         the same, by reciprocity
#pragma once

#include "patch/material.hpp"

namespace wrc::tangential {

/// Displacements per unit traction over the cell [m/Pa].
struct CellInfluence {
  double zz = 0.0;  ///< u_z from p_z
  double xx = 0.0;  ///< u_x from p_x
  double xy = 0.0;  ///< u_x from p_y, equal to u_y from p_x
  double yy = 0.0;  ///< u_y from p_y
};

/// IInt x/r^2 and IInt y/r^2 over the cell [m].
struct CouplingInfluence {
  double x = 0.0, y = 0.0;
};

CouplingInfluence coupling_influence(double x, double y, double dx, double dy);

/// Influence of a cell of size dx x dy [m] at the point (x, y) [m] from its centre; any point, the cell's own
/// included.
CellInfluence cell_influence(const patch::Material& material, double x, double y, double dx, double dy);

}  // namespace wrc::tangential
