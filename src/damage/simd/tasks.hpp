/// Arguments that cross between the damage stage and the kernels of an instruction set: plain data, no
/// constructors.
#pragma once

#include <cstdint>

#include "tangential/march/march_grid.hpp"
#include "tangential/problem.hpp"

namespace wrc::simd {

/// A patch whose cells are to be assessed, and where the results go; arrays over cells are laid out as the
/// tangential fields.
struct CellTask {
  const patch::Strips* region;
  const tangential::TangentialFields* fields;  ///< all four set
  const tangential::CellMiddles* middles;
  std::int32_t cells;
  double speed;           ///< V, rolling [m/s]
  double shear_yield;     ///< k [Pa]
  double* power_density;  ///< out, over cells [W/m^2]
  double* fatigue_index;  ///< out, over cells [-]
  double* strip_power;    ///< out, over strips: the density integrated along the strip [W/m]
};

/// The largest of all cells.
struct CellExtremes {
  double power_density;  ///< at least zero [W/m^2]
  double fatigue_index;  ///< [-]
};

/// Sums over loads are in so many parts, whatever the width of a pack: element of a load modulo this.
constexpr std::int32_t stress_parts = 16;

/// Six components of a stress in parts: xx, yy, zz, xy, yz, zx.
struct StressParts {
  double part[6][stress_parts];
};

/// Forces at points along x, as seen from a point; arrays have a multiple of stress_parts elements.
struct PointLoads {
  double poisson;
  double x, y, z;      ///< point seen from the loads' centre, y and z the same for all loads [m]
  double half_length;  ///< with the sign of the way [m]
  double scale;        ///< [N]
  std::int32_t count;
  const double* place;   ///< place of each load, in half lengths
  const double* weight;  ///< its normal force over the scale
  const double* along;   ///< its tangential ones over the normal one
  const double* across;
  double spared;  ///< loads less than this from the point along x are left out; 0: none [m]
};

/// Corners of loaded cells, count a multiple of stress_parts: place seen from them, and the change there of
/// pressure and tractions [Pa].
struct CornerLoads {
  double poisson;
  double z;
  std::int32_t count;
  const double *x, *y;
  const double *pressure, *along, *across;
};

}  // namespace wrc::simd
