/// A wheel on a rail: where both are and how they move in, the wrench between them out.
///
/// Nothing here chooses a contact point. The rail's cross section is cut once into strips at fixed arc
/// lengths (rail_strips.hpp); a pose gives every strip its own overlap with the wheel (overlap.hpp), the
/// half-space solver their pressures (pressure.hpp), rigid-body kinematics of the wheel their slips
/// (surface_rolling.hpp). Forces are summed strip by strip in the rail's axes and turned into track axes
/// once.
///
/// Bodies here are those of a right-hand wheel on a right-hand rail; a left-hand contact is the mirror image,
/// made by the caller of this module: y, roll, yaw, their rates and M_x, M_z change sign.
///
/// Track axes: x rolling direction, y to the right, z down, origin on the track's centre line level with the
/// tops of the undisplaced rails.
#pragma once

#include <cstdint>

#include "base/arena.hpp"
#include "base/fault.hpp"
#include "surface/surface_model.hpp"
#include "surface/wrench/relative_motion.hpp"
#include "surface/wrench/strip_results.hpp"
#include "surface/wrench/wrench_jacobian.hpp"
#include "tangential/friction/film_rows.hpp"
#include "tangential/friction/friction.hpp"
#include "tangential/methods/strip_memory.hpp"
#include "tangential/rolling_contact.hpp"

namespace wrc::surface {

/// The problem: bodies as placed, friction and load.
struct WheelOnRail {
  WheelMotion wheel;
  RailMotion rail;
  bool load_prescribed =
      false;  ///< then `vertical_load` is given, and position[2] is read as a first guess alone
  double vertical_load = 0.0;  ///< the whole vertical force on the wheel, upwards positive [N]
  double friction = 0.3;       ///< coefficient; 0: frictionless
  const tangential::FrictionLaw* law =
      nullptr;                  ///< in place of the coefficient: over a profile's y and the sliding speed
  bool zones_on_wheel = false;  ///< the law's zones lie on the wheel's profile, not on the rail's
  const tangential::FilmRows* films = nullptr;  ///< on the law's friction; layers in place of `layer`
  double distance =
      0.0;  ///< place of the wheel's reference point along the track, or from above a roller's axle [m]
  double angle = 0.0;  ///< turn of the wheel about its axle, right-hand rule [rad]
  double slope_reduction =
      1.0;  ///< factor on the slope of the creep curve by a layer between the bodies, 0..1
  tangential::SlopeFall slope;             ///< its fall as slip grows
  tangential::Layer layer;                 ///< that shears and yields
  bool layer_of_strips = false;            ///< true: each strip has a layer of its own, by films
  tangential::ReductionFactors reduction;  ///< those in Polach's force law
  double damping = 0.0;                    ///< Hunt and Crossley [s/m]
  double time = 0.0;                       ///< since the committed step, of a model that remembers [s]
};

/// The motion with the wheel's reference point at this height [m].
inline RelativeMotion motion_at_height(const SurfaceModel& model, const WheelOnRail& in, double height) {
  WheelMotion wheel = in.wheel;
  wheel.position[2] = height;
  return relative_motion(model, wheel, in.rail, in.distance);
}

/// A run of strips in contact.
struct SurfaceRegion {
  std::int32_t first = 0, count = 0;  ///< strips of the rail
  double point[3] = {};               ///< load-weighted mean of its strips' pressure centres, track axes [m]
  double angle = 0.0;          ///< direction of its resultant normal force, about x from track z on [rad]
  double normal_force = 0.0;   ///< resultant of the pressure [N]
  double force[3] = {};        ///< on the wheel, track axes [N]
  double moment[3] = {};       ///< about `point`, on the wheel, track axes [N m]
  double area = 0.0;           ///< [m^2]
  double peak_pressure = 0.0;  ///< [Pa]
  double power = 0.0;          ///< frictional power [W]
  double creepage[3] = {};     ///< load-weighted means of its strips' slips: x, lateral [-], spin [1/m]
};

constexpr std::int32_t most_surface_regions = 16;

/// First touch is looked for up to this far above the rail [m].
inline constexpr double farthest_touch = 50e-3;

struct Wrench {
  double force[3] = {};       ///< on the wheel, track axes [N]
  double moment[3] = {};      ///< about the wheel's reference point, track axes [N m]
  double height = 0.0;        ///< position[2] of the wheel, as given or as found [m]
  double normal_force = 0.0;  ///< sum of the regions' resultants [N]
  double area = 0.0, peak_pressure = 0.0, power = 0.0;
  double steepest_angle = 0.0;  ///< largest angle of a strip in contact, the rail's roll included [rad]
  /// By how much a wheel that is apart must be lowered to touch: at most farthest_touch, which says that it
  /// is that or more; 0 in contact, and inside the rail [m].
  double clearance = 0.0;
  std::int32_t regions = 0;
  std::int32_t iterations = 0;  ///< number in the normal problem, all solves of the call
  double work = 0.0;            ///< the normal problem's, all solves of the call (PressureOptions::max_work)
  double residual = 0.0;        ///< residual of the normal problem at this height (PressureResult)
  SurfaceRegion region[most_surface_regions];
};

/// A solution that a later one may start from (PressureStart), but for its strips.
struct KeptStartHead {
  double set = 0.0;        ///< 1: the rest holds a solution
  double height = 0.0;     ///< position[2] of the wheel [m]
  double load = 0.0;       ///< vertical force on the rail [N]
  double stiffness = 0.0;  ///< dF/dh of the load over Hertz's 1.5 F / approach; 0: not known
  double count = 0.0;      ///< strips
};

/// The solution; one element per strip.
struct KeptStart {
  KeptStartHead* head = nullptr;
  double *strip = nullptr, *length_squared = nullptr, *shift = nullptr, *depth = nullptr;
};

/// Change between two solutions (SolutionChange), by the strips of the later one.
struct KeptChange {
  double *length_squared = nullptr, *shift = nullptr, *depth = nullptr;
};

/// Steps of a contact that remembers: y and z of the wheel from the rail, and its place along a rail that
/// varies [m], as committed and as in the last solution.
struct RememberedSteps {
  double committed = 0.0;  ///< 1: a step has been committed
  double pending = 0.0;    ///< 1: the last solution may be committed
  double from[3] = {}, to[3] = {};
};

/// The last solution, and the one that is marked: views of memory that is saved and restored by copying its
/// bytes. It holds doubles alone, and behind them the tractions of a model that remembers.
struct SurfaceState {
  KeptStart last, mark;
  KeptChange change;   ///< from the solution marked before to the marked one
  KeptChange earlier;  ///< from that marked two before to that marked before, by the strips of the marked one
  StripResults kept;
  RememberedSteps* steps = nullptr;
  tangential::Memory* memory = nullptr;  ///< nullptr: the model remembers nothing
};

/// Where the solution of a wheel starts.
enum class SolutionStart {
  anew,  ///< from the overlaps
  last,  ///< from the last solution, if there is one
  mark   ///< from the marked solution, if there is one: results depend on it and the input alone
};

/// Cuts the state of so many strips that may overlap. `remembered`: strips of a model that remembers, else 0.
SurfaceState cut_surface_state(Arena& arena, std::int32_t strips, std::int32_t remembered);
/// Memory of a solve, and of fields.
std::int64_t surface_workspace_bytes(const SurfaceModel& model);

/// Marks the last solution of the state.
void mark_solution(const SurfaceState& state);

/// Marks the last solution, and remembers its tractions. False: it has been committed before.
bool commit_solution(const SurfaceState& state);

/// Solves a step. `state` has where the solve starts, and is left with the solution. `workspace` has
/// surface_workspace_bytes(). WRC_FLAG_NO_CONTACT with zeros where nothing touches; WRC_FLAG_ITERATION_CAP.
/// `jacobian`, if given: the wrench with its derivatives, of methods that are differentiable(); at the border
/// where the overlap is deeper than the deepest solved. `by_track`: those by distance and angle in place of
/// its first two (wrench_jacobian.hpp).
Fault solve_wheel_on_rail(const SurfaceModel& model, const WheelOnRail& input, SolutionStart from,
                          const SurfaceState& state, void* workspace, Wrench& wrench,
                          RailFrameJacobian* jacobian = nullptr,
                          RailFrameJacobian* by_track = nullptr) noexcept;

/// Tractions and slips over the cells of `count` strips of `results` from `first` on, which are one region or
/// several: in the workspace, until the next call that uses it. Where the wheel hardly rolls, those of its
/// own direction of rolling. Not of patches that rolled as wholes.
StripFields fields_of_strips(const SurfaceModel& model, const StripResults& results, std::int32_t first,
                             std::int32_t count, void* workspace) noexcept;

}  // namespace wrc::surface
