/// A region of a solution as it rolled, one of the stages' patches or of a wheel's regions: its strips, and
/// tractions and slips over their cells. Fields, damage, wear, temperatures and stresses follow from this,
/// whichever solution it is of.
#pragma once

#include <cstdint>

#include "contact/state.hpp"
#include "damage/cells.hpp"
#include "damage/film.hpp"
#include "damage/wear.hpp"
#include "patch/strips.hpp"
#include "tangential/problem.hpp"

namespace wrc::contact {

/// Strips of a region among those in contact of the last solve_wheel().
struct StripRun {
  std::int32_t first = 0, count = 0;
};
StripRun strip_run(const surface::StripResults& kept, const surface::SurfaceRegion& region);

/// The same strips as a film meets them; `strips` has room for most_overlapping_strips. Returns their number.
std::int32_t touching_strips(const Contact& contact, damage::TouchingStrip* strips);

/// Where numbers over the cells of a region go, and one per strip.
struct CellNumbers {
  double *power_density = nullptr, *fatigue_index = nullptr;  ///< element (cell i, strip j) at i * strips + j
  double* strip_power = nullptr;
};

struct RolledRegion {
  /// A patch that has been pressed; its cells where it has rolled, by a method that gives tractions.
  RolledRegion(Contact& contact, const Patch& patch);
  /// A wheel's region; its cells where they are wanted and its strips rolled on their own: then they take
  /// a march, and lie in the contact's work space.
  RolledRegion(Contact& contact, const surface::SurfaceRegion& region, bool with_cells = true);

  /// y in the contact frame, or the arc length of the rail; x from the origin of that frame, or from the
  /// wheel's reference point.
  patch::Strips strips;
  const tangential::MarchGrid* grid = nullptr;  ///< their cells
  tangential::TangentialFields fields;          ///< without cells none
  const double* friction = nullptr;             ///< coefficient of each strip; nullptr: has not rolled [-]
  double speed = 0.0;                           ///< divisor of the slips [m/s]
  double direction = 1.0;                       ///< 1: rolls along x; -1: against it
  /// A wheel's strips alone: places on the rail's profile [m], and angles there [rad].
  const double *profile_y = nullptr, *profile_z = nullptr, *angle = nullptr;
  /// Work space. It may be that of the slips: a cell is read before it is written.
  CellNumbers work;

  std::int32_t cells() const { return grid->cells; }
  /// Place [m] and pressure [Pa] of the middle of a cell.
  double x(std::int32_t cell, std::int32_t strip) const {
    return strips.centre[strip] + direction * strips.half_length[strip] * grid->middles.place[cell];
  }
  double pressure(std::int32_t cell, std::int32_t strip) const {
    return strips.peak[strip] * grid->middles.pressure[cell];
  }
  /// Area of each cell of a strip [m^2].
  double cell_area(std::int32_t strip) const {
    return 2.0 * strips.half_length[strip] / cells() * strips.width[strip];
  }
};

/// Fills numbers over the cells and strips (assessments.cpp).
damage::CellDamage assess(const Contact& contact, const RolledRegion& rolled, const CellNumbers& into);

/// Volume lost by a strip per width and distance rolled [m]; `largest` takes the depths of its cells [m/m].
double worn_of_strip(const RolledRegion& rolled, const damage::SheffieldWearLaw& law, std::int32_t strip,
                     double& largest);

/// Sums over the strips of a region of the last solve_wheel(), in the contact axes of RegionResult.
struct WheelSums {
  patch::StripTotals extent;            ///< y by arc length
  tangential::TangentialForces forces;  ///< without adhesion
  tangential::Creepage creepage;
};
WheelSums wheel_sums(Contact& contact, std::int32_t index);

}  // namespace wrc::contact
