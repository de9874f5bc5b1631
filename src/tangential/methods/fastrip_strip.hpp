/// FaStrip's closed form for one strip (fastrip.hpp has the equations), for strips of a patch and for strips
/// with slips of their own alike.
#pragma once

#include <cstdint>

#include "tangential/march/march_grid.hpp"
#include "tangential/problem.hpp"

namespace wrc::tangential {

/// Growth of a strip's tractions with the creepages in strip theory, corrected to the linear theory of the
/// patch [Pa, Pa/m].
struct StripGrowth {
  double longitudinal = 0.0;       ///< 2 G C11 / pi^2 nu_x
  double longitudinal_spin = 0.0;  ///< k13 phi
  double lateral = 0.0;            ///< 2 G C22 / pi^2 nu_y
  double lateral_spin = 0.0;       ///< 3 G c C23 / (2 pi a) phi
  double weight = 1.0;             ///< w: weight of (q, r) against psi d in the direction of traction [-]
};

/// Where a strip slips, and its direction of traction at the border of the stick zone.
struct StripSolution {
  double slip_length = 0.0;  ///< 2 d [m]
  double kappa = 0.0, lambda = 0.0, psi = 0.0;
};

/// steepness: t' [Pa/m]; y, centre of the strip about the origin of the creepages [m].
StripSolution solve_strip(const StripGrowth& growth, double steepness, double y, double centre,
                          double half_length);

/// A strip about the origin of the creepages, and the traction bound at its middle.
struct SlidingStrip {
  double half_length, width, centre, y;  ///< [m]
  double bound;                          ///< [Pa]
  Creepage creepage;
};

/// A strip's part of the sums: forces [N], moment [N m], areas [m^2], power of the slip before it is scaled
/// [N].
struct RolledStrip {
  double fx = 0.0, fy = 0.0, mz = 0.0, area = 0.0, slid = 0.0, power = 0.0;

  RolledStrip& operator+=(const RolledStrip& strip) {
    fx += strip.fx;
    fy += strip.fy;
    mz += strip.mz;
    area += strip.area;
    slid += strip.slid;
    power += strip.power;
    return *this;
  }
  double adhesion_fraction() const { return area > 0.0 ? 1.0 - slid / area : 0.0; }
};

/// FASTSIM's tractions in every cell, laid out as the fields: slip takes their directions.
struct SlipDirections {
  const double *separate_x, *separate_y;  ///< with separate flexibilities
  const double *common_x, *common_y;      ///< with a common one, for strips that slip as a whole
};

/// Tractions and slip, not yet scaled, of strip j of `strips`. Cell by cell `fields` are written behind the
/// reading of `directions`: they may be the same arrays.
RolledStrip roll_strip(const SlidingStrip& sliding, const StripSolution& strip, const MarchGrid& grid,
                       const SlipDirections& directions, std::int32_t strips, std::int32_t j,
                       const TangentialFields& fields);

}  // namespace wrc::tangential
