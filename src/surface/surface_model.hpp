/// What does not change while a wheel rolls on a rail: both cross sections by arc length, the rail's strips,
/// elastic constants and tables. Immutable after creation; any number of contacts use one.
#pragma once

#include <cstddef>
#include <cstdint>

#include "geometry/profile.hpp"
#include "kernels/kernels.hpp"
#include "normal/elasticity/influence_tables.hpp"
#include "patch/material.hpp"
#include "surface/overlap.hpp"
#include "surface/rail_strips.hpp"
#include "surface/surface_normal.hpp"
#include "surface/surface_rolling.hpp"
#include "surface/wheel_on_rail.hpp"
#include "surface/wrench_slopes.hpp"
#include "tangential/march/march_grid.hpp"

namespace wrc {

/// The bodies, right-hand, as the caller gave them.
struct SurfaceBodies {
  Profile wheel;                                    ///< from its own origin, z down
  Profile rail;                                     ///< from its own origin, not canted
  double rail_inclination = 0.0;                    ///< tangent of the cant about that origin
  double rail_origin_y = 0.0, rail_origin_z = 0.0;  ///< of the right-hand rail, track axes [m]
  double nominal_radius = 0.0;                      ///< of the wheel at its profile's origin [m]
  Material material;
  // These outlive the model:
  const InfluenceTables* influence = nullptr;
  const Kernels* kernels = nullptr;
  const KalkerTable* ellipse = nullptr;  ///< of the material's Poisson ratio
  const MarchGrid* grid = nullptr;
};

struct SurfaceModel {
  Curve rail_curve;
  RailStrips rail;
  WheelCurve wheel;
  double rail_origin_y = 0.0, rail_origin_z = 0.0;
  Material material;
  const InfluenceTables* influence = nullptr;
  const Kernels* kernels = nullptr;
  StripCoefficientTable coefficients;
  const MarchGrid* grid = nullptr;
};

/// Most strips a rail may be cut into, and most of them that may overlap a wheel at a time.
inline constexpr std::int32_t most_strips_of_a_rail = 1024, most_overlapping_strips = 256;

/// The last solution: where the next one may start. Plain memory, saved and restored by copying bytes.
struct SurfaceState {
  double set = 0.0;     ///< 1: the rest holds a solution
  double height = 0.0;  ///< of the wheel [m], where the load was given
  double length_squared[most_strips_of_a_rail] = {};
  double shift[most_strips_of_a_rail] = {};
};

std::size_t surface_model_bytes(std::int32_t wheel_nodes, std::int32_t rail_nodes);
std::int64_t surface_state_bytes();
/// Of a solve; the march grid's fields over cells are not part of it.
std::int64_t surface_workspace_bytes(std::int32_t wheel_nodes);

/// Makes the model in memory of surface_model_bytes(), aligned as a double.
Fault make_surface_model(const SurfaceBodies& bodies, void* memory, const SurfaceModel*& model);

/// Solves a step. `state` is where the solve starts when `warm`, and left with the solution. `workspace` has
/// surface_workspace_bytes(). WRC_FLAG_NO_CONTACT with zeros where nothing touches; WRC_FLAG_ITERATION_CAP.
/// `slopes`, if given: the wrench with its derivatives; at the border where the overlap is deeper than what
/// is solved.
Fault solve_wheel_on_rail(const SurfaceModel& model, const WheelOnRail& input, bool warm, SurfaceState& state,
                          void* workspace, Wrench& wrench, SeenWrench* slopes = nullptr) noexcept;

/// The law's coefficient over a strip's width on the rail, at rest.
double friction_at_rest(const SurfaceModel& model, const FrictionLaw& law, std::int32_t strip);

/// Angle of a strip about x, from track z to its normal, with the rail undisplaced [rad].
double strip_angle(const SurfaceModel& model, std::int32_t strip);

}  // namespace wrc
