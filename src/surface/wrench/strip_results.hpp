/// Numbers of the strips in contact: one list of them, as arrays of a solution and as memory that is kept.
#pragma once

#include <array>
#include <cstdint>

#include "surface/surface_model.hpp"

namespace wrc::surface {

/// One column per quantity, each strip in its own axes, of right-hand bodies. Column: memory, or a pointer to
/// it.
template <class Column>
struct StripColumns {
  Column strip = {};                ///< number among the rail's strips
  Column place = {}, width = {};    ///< by arc length [m]
  Column y = {}, z = {};            ///< on the rail's profile [m]
  Column angle = {};                ///< strip_angle() [rad]
  Column half_length = {};          ///< l [m]
  Column peak = {};                 ///< pressure at the strip's middle, times the factor [Pa]
  Column solved_peak = {};          ///< p0 without the factor [Pa]
  Column centre = {};               ///< x of the pressure, from the reference point of the host [m]
  Column curvature = {};            ///< kappa, times the damping factor [1/m]
  Column slip_x = {}, slip_y = {};  ///< rigid slips [-]
  Column spin = {};                 ///< [1/m]
  Column friction = {};             ///< coefficient [-]
  Column flexibility = {};          ///< F of the strip's own layer [m/Pa]
  Column yield = {};                ///< its tau_0 [Pa]
  Column hardening = {};            ///< its k [Pa/m]
  Column fx = {}, fy = {};          ///< tangential forces without the factor [N]
  Column mz = {};                   ///< about each strip's own middle, without the factor [N m]
  Column power = {};                ///< frictional, without the factor [W]
  Column y_wheel = {};              ///< where they touch the wheel, its profile's coordinate [m]

  static constexpr std::int32_t count_of_columns = 23;
  std::array<Column*, count_of_columns> columns() {
    return {&strip,       &place,     &width,     &y,      &z,      &angle, &half_length, &peak,
            &solved_peak, &centre,    &curvature, &slip_x, &slip_y, &spin,  &friction,    &flexibility,
            &yield,       &hardening, &fx,        &fy,     &mz,     &power, &y_wheel};
  }
};
static_assert(sizeof(StripColumns<double>) == StripColumns<double>::count_of_columns * sizeof(double));

/// A solution as a whole.
struct StripResultsHead {
  double count = 0.0;
  double speed = 0.0;            ///< divisor of the slips: that of rolling_reference() [m/s]
  double rolling_speed = 0.0;    ///< [m/s]; < 0 against x
  double backwards = 0.0;        ///< 1: the wheel rolls against x
  double rolls = 0.0;            ///< 1: there is friction
  double by_region = 0.0;        ///< 1: as whole patches; strips have no tractions and slips of their own
  double slope_reduction = 1.0;  ///< factor by a layer between the bodies
  tangential::Layer layer;       ///< that shears and yields
  double layer_of_strips = 0.0;  ///< 1: each strip has a layer of its own
  double factor = 1.0;  ///< on pressures and tractions: the load goes on beyond the deepest overlap solved
};

/// Columns in memory of their owner.
struct ContactArrays : StripColumns<double*> {
  /// The same columns from one strip on.
  ContactArrays from(std::int32_t first) const {
    ContactArrays later = *this;
    for (double** const column : later.columns()) *column += first;
    return later;
  }
};

/// The strips in contact of the last solution, by increasing arc length, from which a region's fields and
/// damage are computed later.
struct StripResults : ContactArrays {
  StripResultsHead* head = nullptr;
};

/// Tractions and slips over the cells of some strips, element (cell i, strip j) at i * strips + j; without
/// the factor.
struct StripFields {
  std::int32_t strips = 0, cells = 0;
  double *traction_x = nullptr, *traction_y = nullptr;  ///< on the wheel [Pa]
  double *slip_x = nullptr, *slip_y = nullptr;          ///< sliding velocity / rolling speed [-]
  double* of_strips = nullptr;                          ///< scratch: a number for each strip
};

}  // namespace wrc::surface
