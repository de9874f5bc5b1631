/// What does not change while a wheel rolls on a rail: both cross sections by arc length, the rail's strips,
/// elastic constants and tables. Immutable after creation; any number of contacts use one.
#pragma once

#include <cstddef>
#include <cstdint>

#include "geometry/profile.hpp"
#include "kernels/kernels.hpp"
#include "normal/elasticity/influence_tables.hpp"
#include "patch/material.hpp"
#include "surface/geometry/out_of_round.hpp"
#include "surface/geometry/overlap.hpp"
#include "surface/geometry/rail_strips.hpp"
#include "surface/geometry/varying_rail.hpp"
#include "surface/pressure/planar_pressure.hpp"
#include "surface/pressure/pressure.hpp"
#include "surface/rolling/region_rolling.hpp"
#include "surface/rolling/surface_rolling.hpp"
#include "surface/wrench/wheel_on_rail.hpp"
#include "surface/wrench/wrench_slopes.hpp"
#include "tangential/friction/flash_temperature.hpp"
#include "tangential/march/march_grid.hpp"

namespace wrc {

/// What a wheel on a rail is solved with.
struct SurfaceMethods {
  PlanarMethod planar;  ///< without `solve`: strips in half-space equilibrium on the surface
  SurfaceRollingMethod strips = SurfaceRollingMethod::strip_fastsim;
  bool parabolic = false;  ///< SurfaceRollingInput
  RegionRolling
      region;  ///< with `solve`: patch by patch where by_region, or the slope of the creep curve falls
  bool by_region = false;

  bool differentiable() const { return !planar.solve && !region.solve; }
};

/// The bodies, right-hand, as the caller gave them.
struct SurfaceBodies {
  Profile wheel;                                    ///< from its own origin, z down
  Profile rail;                                     ///< from its own origin, not canted
  double rail_inclination = 0.0;                    ///< tangent of the cant about that origin
  double rail_origin_y = 0.0, rail_origin_z = 0.0;  ///< of the right-hand rail, track axes [m]
  double nominal_radius = 0.0;                      ///< of the wheel at its profile's origin [m]
  std::int32_t sections = 0;                        ///< 0: the rail is the same everywhere
  const RailSection* section = nullptr;
  RadiusTable radius;             ///< without rows: the wheel is round
  double roller_curvature = 0.0;  ///< of a rail that is a roller, at its profile's origin [1/m]
  Material material;
  Effusivities effusivities;
  // These outlive the model:
  const InfluenceTables* influence = nullptr;
  const Kernels* kernels = nullptr;
  const KalkerTable* ellipse = nullptr;  ///< of the material's Poisson ratio
  const MarchGrid* grid = nullptr;
  SurfaceMethods methods;
};

struct SurfaceModel {
  Curve rail_curve;
  RailStrips rail;
  WheelCurve wheel;
  VaryingRail varying;
  OutOfRound out_of_round;
  double rail_origin_y = 0.0, rail_origin_z = 0.0;
  double wheel_radius = 0.0;      ///< nominal [m]
  double roller_curvature = 0.0;  ///< of a rail that is a roller, at its profile's origin [1/m]
  Material material;
  Effusivities effusivities;
  const InfluenceTables* influence = nullptr;
  const Kernels* kernels = nullptr;
  StripCoefficientTable coefficients;
  const MarchGrid* grid = nullptr;
  SurfaceMethods methods;
};

/// Most strips a rail may be cut into, and most of them that may overlap a wheel at a time.
inline constexpr std::int32_t most_strips_of_a_rail = 1024, most_overlapping_strips = 256;

/// The strips in contact of the last solution, by increasing arc length, for what is asked of its regions
/// afterwards: each strip's own axes, of right-hand bodies. Doubles only, so that there is no padding.
struct StripResults {
  double count = 0.0;
  double speed = 0.0;            ///< what slips are over: divisor of rolling_reference() [m/s]
  double rolling_speed = 0.0;    ///< [m/s]; < 0 against x
  double backwards = 0.0;        ///< 1: the wheel rolls against x
  double rolls = 0.0;            ///< 1: there is friction
  double by_region = 0.0;        ///< 1: as whole patches; strips have no tractions and slips of their own
  double slope_reduction = 1.0;  ///< of a layer between the bodies
  double factor = 1.0;  ///< on pressures and tractions: the load goes on beyond the deepest overlap solved
  double strip[most_overlapping_strips] = {};                                       ///< of the rail
  double place[most_overlapping_strips] = {}, width[most_overlapping_strips] = {};  ///< by arc length [m]
  double y[most_overlapping_strips] = {}, z[most_overlapping_strips] = {};  ///< on the rail's profile [m]
  double angle[most_overlapping_strips] = {};                               ///< strip_angle() [rad]
  double half_length[most_overlapping_strips] = {};                         ///< [m]
  double peak[most_overlapping_strips] = {};                                ///< [Pa]
  double solved_peak[most_overlapping_strips] = {};                         ///< without the factor [Pa]
  double centre[most_overlapping_strips] = {};     ///< x from the reference point of the host [m]
  double curvature[most_overlapping_strips] = {};  ///< [1/m]
  double slip_x[most_overlapping_strips] = {}, slip_y[most_overlapping_strips] = {};  ///< [-]
  double spin[most_overlapping_strips] = {};                                          ///< [1/m]
  double friction[most_overlapping_strips] = {};                                      ///< [-]
  double fx[most_overlapping_strips] = {}, fy[most_overlapping_strips] = {};  ///< without the factor [N]
  double mz[most_overlapping_strips] = {};       ///< about each strip's own middle, without the factor [N m]
  double power[most_overlapping_strips] = {};    ///< frictional, without the factor [W]
  double y_wheel[most_overlapping_strips] = {};  ///< where they touch the wheel, its profile's coordinate [m]
};

/// Over the cells of some of them, element (cell i, strip j) at i * strips + j; without the factor.
struct StripFields {
  std::int32_t strips = 0, cells = 0;
  double *traction_x = nullptr, *traction_y = nullptr;  ///< on the wheel [Pa]
  double *slip_x = nullptr, *slip_y = nullptr;          ///< sliding velocity / rolling speed [-]
  double* of_strips = nullptr;                          ///< work space: a number for each strip
};

/// The last solution: where the next one may start. Plain memory, saved and restored by copying bytes.
struct SurfaceState {
  double set = 0.0;     ///< 1: the rest holds a solution
  double height = 0.0;  ///< of the wheel [m], where the load was given
  double length_squared[most_strips_of_a_rail] = {};
  double shift[most_strips_of_a_rail] = {};
  double depth[most_strips_of_a_rail] = {};  ///< overlaps [m]
  StripResults kept;
};

/// `sections`, `section_nodes`: how many, and nodes of the longest.
std::size_t surface_model_bytes(std::int32_t wheel_nodes, std::int32_t rail_nodes, std::int32_t sections,
                                std::int32_t section_nodes, const RadiusTable& radius);
std::int64_t surface_state_bytes();
/// Of a solve, and of fields over so many cells along a strip.
std::int64_t surface_workspace_bytes(std::int32_t wheel_nodes, const SurfaceMethods& methods,
                                     std::int32_t cells, bool varying);

/// Makes the model in memory of surface_model_bytes(), aligned as a double.
Fault make_surface_model(const SurfaceBodies& bodies, void* memory, const SurfaceModel*& model);

/// The model's constants of the normal problem.
inline PressureModel pressure_model(const SurfaceModel& model) {
  return {*model.influence, *model.kernels, model.material.normal_compliance()};
}

/// Is there anything that changes along the track or round the wheel?
inline bool varies(const SurfaceModel& model) {
  return model.varying.faces > 0 || model.out_of_round.rows > 0 || model.roller_curvature != 0.0;
}

/// Solves a step. `state` is where the solve starts when `warm`, and left with the solution. `workspace` has
/// surface_workspace_bytes(). WRC_FLAG_NO_CONTACT with zeros where nothing touches; WRC_FLAG_ITERATION_CAP.
/// `slopes`, if given: the wrench with its derivatives, of methods that are differentiable(); at the border
/// where the overlap is deeper than what is solved. `by_track`: those by distance and angle in place of its
/// first two (wrench_slopes.hpp).
Fault solve_wheel_on_rail(const SurfaceModel& model, const WheelOnRail& input, bool warm, SurfaceState& state,
                          void* workspace, Wrench& wrench, RailFrameJacobian* slopes = nullptr,
                          RailFrameJacobian* by_track = nullptr) noexcept;

/// Tractions and slips over the cells of `count` kept strips from `first` on, which are one region or
/// several: in the workspace, until the next call that uses it. Where the wheel hardly rolls, of the way it
/// rolls. Not of patches that rolled as wholes.
StripFields roll_kept(const SurfaceModel& model, const StripResults& kept, std::int32_t first,
                      std::int32_t count, void* workspace) noexcept;

}  // namespace wrc
