/// What crosses between the damage stage and the kernels of an instruction set: plain data, no constructors.
#pragma once

#include <cstdint>

#include "tangential/march/march_grid.hpp"
#include "tangential/problem.hpp"

namespace wrc {
namespace simd {

/// A patch whose cells are to be assessed, and where the results go; arrays over cells are laid out as the
/// tangential fields.
struct CellTask {
  const Strips* region;
  const TangentialFields* fields;  ///< all four set
  const CellMiddles* middles;
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

}  // namespace simd

}  // namespace wrc
