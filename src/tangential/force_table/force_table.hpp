/// Force table: the total forces on a double ellipse (SDEC) in steady rolling, interpolated between
/// solutions of the exact half-space equations (in the spirit of KBTNH, Piotrowski, Liu and Bruni 2017).
///
/// Forces over friction * load depend on five numbers: the axis ratio a/b, the shape number psi, and the
/// three creepages about the centre of pressure, which lies at y = 3/4 psi b: there pure translation in full
/// slip has no moment, and linear theory next to no coupling C13, so that psi matters little. The creepages,
///
///     v = (K1 X, K2 Y, K3 S),   X = G c^2 nu_x / (mu N),  Y = G c^2 nu_y / (mu N),  S = G c^3 phi / (mu N),
///
/// c = sqrt(a b), are taken in spherical coordinates: the direction of v, and its length r as saturation
/// t = r / (r + r0). Stored is force / (mu N t), moment / (mu N c t) and the share of the area that sticks:
/// finite on the face t = 0, which is linear theory, and on t = 1, which is full slip. K1, K2 and K3 only
/// make the three creepages comparable; they are part of the table's definition, not of the physics.
///
/// Symmetries: all signs of creepages and forces may be changed together, so spin >= 0; mirroring y changes
/// the signs of psi, nu_y, phi, F_y and M_z, so psi >= 0.
///
/// Interpolation is by quadratic B-splines along all five axes: three nodes each, and C1 everywhere except
/// at psi = 0, where the slope over psi may change.
///
/// Poisson's ratio: the table has one. For another the creepages count in the ratio of the coefficients of
/// linear theory, C11, C22 and C23, at small creepage; in full slip, where elasticity has no influence, as
/// they are; between, the share 1 - t^2 of that ratio does it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "base/fault.hpp"
#include "patch/sdec.hpp"
#include "tangential/problem.hpp"

namespace wrc::tangential {

/// Nodes per axis, and where they lie.
struct ForceTableAxes {
  std::int32_t ratios = 0;       ///< a/b from 1 / largest_ratio to largest_ratio
  std::int32_t shapes = 0;       ///< psi from 0 to largest_shape_number
  std::int32_t elevations = 0;   ///< angles of v over the plane without spin, 0 to 90 degrees
  std::int32_t azimuths = 0;     ///< in that plane, from nu_x towards nu_y, round the circle; even
  std::int32_t saturations = 0;  ///< t from 0 to 1
  double largest_ratio = 0.0;
  double largest_shape_number = 0.0;
  double half_saturation = 0.0;  ///< r0
  double poisson = 0.0;          ///< Poisson ratio of the solutions [-]
};

/// Largest number of nodes along one axis.
inline constexpr std::int32_t force_table_nodes = 64;

/// Numbers of one node: F_x, F_y, M_z, share of the area that sticks.
inline constexpr std::int32_t force_table_values = 4;

/// Numbers of the whole table.
std::size_t force_table_size(const ForceTableAxes& axes);

/// Factors that make the three creepages comparable [-].
struct CreepageScale {
  double longitudinal = 0.0, lateral = 0.0, spin = 0.0;
};
CreepageScale creepage_scale(double ratio);

/// Places of the nodes along their axes.
double node_ratio(const ForceTableAxes& axes, std::int32_t i);
double node_shape_number(const ForceTableAxes& axes, std::int32_t i);
double node_saturation(const ForceTableAxes& axes, std::int32_t i);

/// Lateral position of the centre of pressure, about which the table's creepages and moments are [m].
inline double pressure_centre(const patch::Sdec& patch) { return 0.75 * patch.psi * patch.b; }

/// A table as a model holds it.
struct ForceTable {
  ForceTableAxes axes;
  /// Spline coefficients, value fastest, then shape, saturation, ratio, azimuth, elevation.
  const float* coefficients = nullptr;
  /// C11, C22 and C23 of the model's Poisson ratio over those of the table's, at the nodes of a/b.
  std::array<CreepageScale, force_table_nodes> stiffness{};
};

/// Fills table.stiffness.
void adapt_to_poisson(double poisson, ForceTable& table);

/// Forces on the patch under normal_force [N]; creepages and moment about the joint, power by the energy
/// balance -(F_x nu_x + F_y nu_y + M_z phi). Beyond the table's shapes its end is used, with
/// WRC_FLAG_TABLE_RANGE.
TangentialForces table_forces(const ForceTable& table, const patch::Sdec& patch, double normal_force,
                              double shear_modulus, double friction, const Creepage& creepage, Fault& fault);

}  // namespace wrc::tangential
