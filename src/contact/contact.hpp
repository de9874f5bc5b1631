/// The contact: mutable state of one wheel/rail pair, and the stages of a step.
///
///     geometry -> normal -> regularise -> tangential -> damage
///
/// Each stage reads what the one before left in the contact and invalidates what comes after, so that a host
/// may enter in the middle with its own data. All of them are real-time code. Arguments have been checked by
/// the caller (abi/) for finiteness and range.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/fault.hpp"
#include "contact/model.hpp"
#include "damage/bins.hpp"
#include "damage/stress.hpp"
#include "damage/wear.hpp"
#include "geometry/contact_search.hpp"
#include "geometry/creepages.hpp"
#include "geometry/surface_gap.hpp"
#include "normal/problem.hpp"
#include "patch/sdec.hpp"
#include "patch/split.hpp"
#include "patch/strips.hpp"
#include "surface/wrench/wheel_on_rail.hpp"
#include "tangential/friction/flash_temperature.hpp"
#include "tangential/friction/friction.hpp"
#include "tangential/problem.hpp"

namespace wrc {

/// Wear and fatigue numbers of one contact.
struct DamageNumbers {
  double power = 0.0;                ///< [W]
  double peak_power_density = 0.0;   ///< [W/m^2]
  double t_gamma = 0.0;              ///< power / speed [N]
  double t_gamma_no_spin = 0.0;      ///< |Fx nu_x + Fy nu_y| [N]
  double utilisation = 0.0;          ///< mu_a [-]
  double load_factor = 0.0;          ///< p0 / k [-]
  double shakedown_limit = 0.0;      ///< of p0 / k at mu_a [-]
  double fatigue_index = 0.0;        ///< [-]
  double local_fatigue_index = 0.0;  ///< largest of the cells; 0 without cells [-]
};

/// Wear of one contact by the laws.
struct WearNumbers {
  double worn_area_rate = 0.0;                ///< by T-gamma [m^2/m]
  double largest_depth_rate = 0.0;            ///< Sheffield [m/m]
  double largest_depth_velocity = 0.0;        ///< Archard [m/s]
  double largest_power_depth_velocity = 0.0;  ///< power law [m/s]
};

/// Temperatures in one contact.
struct TemperatureNumbers {
  double at_entry = 0.0;                     ///< of both surfaces at first touch [degC]
  double rise = 0.0, x = 0.0, y = 0.0;       ///< the largest over that, and where [K], [m]
  double mean_rise = 0.0;                    ///< over the area [K]
  double wheel_heat = 0.0, rail_heat = 0.0;  ///< [W]
};

/// Where the y of friction zones counts from: the contact frame, the rail's profile, or the wheel's.
enum class ZoneFrame : std::int64_t { contact, rail, wheel };

/// Friction between the bodies, and what a layer between them does to the slope of the creep curve.
struct Friction {
  FrictionLaw law;
  ZoneFrame zone_frame = ZoneFrame::contact;
  double slope_reduction = 1.0;  ///< k0: slope at small creepages over that of clean bodies [-]
  SlopeFall slope;               ///< what it does to the slope as slip grows
};

/// Which way and how fast the bodies roll. Backwards the leading edge is at -x; creepages are sliding
/// velocities over `speed` either way.
struct Rolling {
  double speed = 0.0;          ///< V, its amount [m/s]
  double way = 1.0;            ///< 1: along x; -1: backwards
  double reverse_share = 0.0;  ///< share of the forces that is of rolling against `way`, near standstill
};

/// What presses the bodies together. Damping acts on a prescribed approach.
struct Load {
  Prescribed prescribed = Prescribed::load;
  double value = 0.0;              ///< [N] or [m]
  double approach_velocity = 0.0;  ///< [m/s]
  double damping = 0.0;            ///< alpha of normal/damping.hpp [s/m]
};

/// A wheel on a rail as a host has them, track axes; what the wheel is displaced from is in wrc_wheel.h.
struct HostWheel {
  bool of_wheelset = true;  ///< the reference point is the middle of the axle; otherwise that of the wheel
  double y = 0.0, z = 0.0;  ///< displacement of the reference point [m]
  double rotation[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};  ///< track = rotation * body, without pitch
  double velocity[3] = {};                                    ///< of the reference point [m/s]
  double angular_velocity[3] = {};                            ///< [rad/s]
  /// What the host gives of it are components along the columns of `axes`: those of the track or the body, or
  /// x, the axle and the rolled z, about which roll, the wheel and yaw turn.
  double axes[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  double turning_with_body[3] = {};  ///< its part along columns that turn with roll and yaw [rad/s]
  /// Of the frame that the velocities are given in, about its own axes.
  double frame_speed = 0.0, frame_turning[3] = {};  ///< [m/s], [rad/s]
  RailMotion rail;
  bool load_prescribed = false;
  double vertical_load = 0.0;  ///< [N]
  bool start_anew = false;     ///< not from the last solution
  bool frictionless = true;
  Friction friction;      ///< zones over the rail's y, those of the caller
  double damping = 0.0;   ///< [s/m]
  double distance = 0.0;  ///< of the reference point along the track, or from above a roller's axle [m]
  double angle = 0.0;     ///< about the axle [rad]
};

/// Where the point of a region lies on both bodies, in the coordinates of their profiles [m].
struct RegionPlace {
  double y_wheel = 0.0, z_wheel = 0.0, y_rail = 0.0, z_rail = 0.0;
};

/// What a wheel on a rail came to, track axes of the host.
struct HostWrench {
  Wrench wrench;  ///< about the reference point; height: displacement z of that point
  double rail_moment[3] = {};
  RegionPlace place[most_surface_regions];
};

/// What a wrench is differentiated by, as enum wrc_wrench_input. Roll and yaw are those of the axle.
enum HostInput : std::int32_t {
  by_y,
  by_z,
  by_roll,
  by_yaw,
  by_velocity,
  by_angular_velocity = by_velocity + 3,
  by_rail_y = by_angular_velocity + 3,
  by_rail_z,
  by_rail_roll,
  by_rail_velocity_y,
  by_rail_velocity_z,
  by_rail_velocity_roll,
  by_load,
  by_distance,
  by_angle,
  by_rail_slope_y,
  by_rail_slope_z,
  by_roller_velocity,
  by_friction,
  hosted_inputs
};

/// Derivatives of a wrench: rows force x, y, z, moment x, y, z, on the wheel about its reference point.
struct HostJacobian {
  double wrench[6][hosted_inputs] = {};
  double z[hosted_inputs] = {};  ///< of the displacement z, given or found
};

/// Which solution of a contact is its newest: that of the stages, or of a wheel on a rail.
enum class Solution : std::int32_t { none, stages, wheel };

/// The furthest stage whose result the contact holds.
enum class Stage : std::uint32_t { none, gap, patch, tangential, damage };

/// Most patches one contact can report.
inline constexpr std::int32_t patch_capacity = 16;

/// Most breakpoints of friction over y.
inline constexpr std::int32_t zone_capacity = 64;

/// One of the patches of a contact: a run of its strips, and what was found on it.
struct Patch {
  std::int32_t first = 0, count = 0;                ///< strips of the patch
  std::int32_t region_first = 0, region_count = 0;  ///< strips its tangential fields live on
  StripTotals extent;
  double y_contact = 0.0;   ///< where its bodies first touch [m]
  Sdec sdec;                ///< its equivalent double ellipse about y_contact
  double friction = 0.0;    ///< mean over the load [-]
  TangentialForces forces;  ///< moment about the origin of the contact frame
};

/// Members are ordered, and those of its members chosen, so that there is no padding: see below.
struct Contact {
  const Model* model = nullptr;
  Fault last;  ///< of the last call

  Stage reached = Stage::none;
  bool touching = false;          ///< false: the bodies are apart and forces are zero
  bool posed = false;             ///< pose and point belong to the gap in the contact
  bool pressed = false;           ///< the patch belongs to the load
  std::uint8_t filling = 0;       ///< in the place of padding
  std::int32_t gap_rows = 0;      ///< rows in use
  std::int32_t start_strips = 0;  ///< of the last solution the next normal solve may start from; 0: none
  std::int32_t strips = 0;        ///< of all patches
  std::int32_t patches = 0;
  std::int32_t main_patch = 0;  ///< the one that carries most
  Side side = Side::right;      ///< which wheel of the wheelset

  Pose pose;  ///< of the last geometry stage
  ContactPoint point;
  NormalSolution normal;
  double damping_factor = 1.0;  ///< damped over elastic pressure; strips and normal hold the damped one
  StripTotals extent;           ///< of all patches together
  Patch patch[patch_capacity];
  Creepage creepage;
  double friction = 0.0;  ///< mean over the load; each strip's is in Array::strip_friction [-]
  Friction law;           ///< of the last tangential stage; its zones are the two arrays below
  double zone_y[zone_capacity] = {}, zone_coefficient[zone_capacity] = {};
  Rolling rolling;
  double rolled = 0.0;      ///< since the last tangential stage, of a model that remembers [m]
  TangentialForces forces;  ///< of all patches together
  DamageNumbers damage;

  std::int32_t wheel_solved = 0;  ///< 1: `wheel` holds the last solve_wheel(); the stages do not use it
  Solution newest = Solution::none;
  HostWrench wheel;
};

// What is saved are the bytes of a contact: with padding, where anything may lie, equal states could differ
// in their bytes. Each line is a struct and what its members come to.
static_assert(sizeof(FrictionLaw) == 13 * sizeof(double));
static_assert(sizeof(Friction) == sizeof(FrictionLaw) + 2 * sizeof(double) + sizeof(SlopeFall));
static_assert(sizeof(NormalSolution) == 7 * sizeof(double));
static_assert(sizeof(Patch) == 4 * sizeof(std::int32_t) + sizeof(StripTotals) + sizeof(Sdec) +
                                   sizeof(TangentialForces) + 2 * sizeof(double));
static_assert(sizeof(Contact) == sizeof(void*) + sizeof(Fault) + sizeof(Stage) + 3 * sizeof(bool) +
                                     sizeof(std::uint8_t) + 4 * sizeof(std::int32_t) + sizeof(std::int64_t) +
                                     sizeof(Pose) + sizeof(ContactPoint) + sizeof(NormalSolution) +
                                     sizeof(StripTotals) + sizeof(Patch[patch_capacity]) + sizeof(Creepage) +
                                     sizeof(Friction) + (3 + 2 * zone_capacity) * sizeof(double) +
                                     sizeof(Rolling) + sizeof(TangentialForces) + sizeof(DamageNumbers) +
                                     sizeof(std::int32_t) + sizeof(Solution) + sizeof(HostWrench));
static_assert(sizeof(SurfaceRegion) == 2 * sizeof(std::int32_t) + 17 * sizeof(double));
static_assert(sizeof(HostWrench) == 2 * sizeof(std::int32_t) + 16 * sizeof(double) +
                                        most_surface_regions * (sizeof(SurfaceRegion) + sizeof(RegionPlace)));

/// Memory of a contact: its state, and behind it room for a copy on which sensitivities are found or for the
/// work space of a wheel on a rail.
std::size_t contact_bytes(const Model& model);

/// Its part that is to be saved and restored.
std::size_t state_bytes(const Model& model);

/// Makes an empty contact in `memory` (contact_bytes, aligned).
Contact& make_contact(const Model& model, Side side, void* memory);

/// Wheel and rail of the contact's side.
const Bodies& bodies(const Contact& contact);

/// An array of the contact; its length follows from the sizes in the model.
double* array(Contact& contact, Array which);
const double* array(const Contact& contact, Array which);

/// Views over the contact's arrays, for the strips and rows in use.
GapRows gap_rows(const Contact& contact);
Strips all_strips(Contact& contact);
Strips patch_strips(Contact& contact, const Patch& patch);
Strips region_strips(Contact& contact, const Patch& patch);

/// The block of a cell array that belongs to one patch: element (cell i, strip j) at
/// i * patch.region_count + j.
double* cell_block(Contact& contact, Array which, const Patch& patch);

/// The tractions and slips of one patch.
TangentialFields cell_fields(Contact& contact, const Patch& patch);

/// Work space behind the state: what a wheel on a rail needs, and state_bytes() at least. Nothing in it
/// outlives a call.
double* work_space(Contact& contact);

/// Does the tangential method give tractions and slip of every cell?
bool gives_fields(const Contact& contact);

/// Stages. Each returns what went wrong and leaves the contact usable.
Fault find_gap(Contact& contact, const Pose& pose);
Fault find_creepages(const Contact& contact, const WheelsetMotion& motion, RigidCreepage& rigid);
Fault solve_normal(Contact& contact, const Load& load);
Fault regularise_patch(Contact& contact);
/// Solves the tangential stage; both ways where `rolling` has a share of the other, of which only forces and
/// sensitivities are kept. `sensitivities`: nullptr, not wanted; in their stead no fields are computed, and
/// they are right where the contact differentiates().
Fault solve_tangential(Contact& contact, const Creepage& creepage, const Friction& friction,
                       const Rolling& rolling, TangentialSensitivities* sensitivities = nullptr);

/// Did the last tangential stage have exact derivatives? Not so where the method has none, with flexibilities
/// that depend on the creepages, and with friction or a slope that falls as they grow.
bool differentiates(const Contact& contact);

/// A hosted wheel as the right-hand one of src/surface, and what leads back.
struct PlacedWheel {
  WheelOnRail problem;
  bool left = false;         ///< `problem` is its mirror image
  double arm[3] = {};        ///< from the reference point to that of the wheel, host's track axes [m]
  double reference[3] = {};  ///< the reference point, its height as given [m]
  double rail[2] = {};       ///< y and z of the displaced origin of the rail's profile [m]
};

/// WRC_ERROR_UNSUPPORTED where the model has no surfaces: no profiles, or such as cannot be cut into strips.
/// The problem points to `hosted` where friction has a law.
Fault place_wheel(const Contact& contact, const HostWheel& hosted, PlacedWheel& placed);

/// Takes a wrench of `placed.problem` to the host's side and reference point and adds the rail's moment.
void hand_back(const Model& model, const PlacedWheel& placed, HostWrench& result);

/// Takes derivatives by what the rail sees to those by what the host gives (wheel_slopes.cpp). The height in
/// `placed.problem` is that of the solution.
void hand_back(const Model& model, const HostWheel& hosted, const PlacedWheel& placed,
               const RailFrameJacobian& found, const RailFrameJacobian& by_track, HostJacobian& slopes);

/// A wheel on a rail, from the pose to the wrench in one; the stages above are not touched (wheel.cpp).
/// `slopes`: nullptr, not wanted.
Fault solve_wheel(Contact& contact, const HostWheel& hosted, HostJacobian* slopes = nullptr);

/// The friction of the last tangential stage, its zones those kept in the contact.
Friction friction_of(const Contact& contact);
Fault assess_damage(Contact& contact);

/// Why nothing can be made of the contact's tractions: there are none yet, none of this method, for which
/// `why_not` is the sentence, or no contact.
Fault tractions_needed(const Contact& contact, const char* why_not);

/// What the last results of the contact, of the stages or of a wheel on a rail, do in a time
/// (accumulation.cpp).
struct Accumulation {
  double duration = 0.0;  ///< [s]
  double distance = 0.0;  ///< along the track where it begins [m]
  WearLaws wear;
  WholeLifeLaw whole_life;
};

/// What was added to each set of bins.
struct DamageTotals {
  double sum[damage_sums] = {};
  double largest_pressure = 0.0, largest_traction = 0.0;  ///< [Pa]
};

/// Adds to the bins of wheel and rail; nullptr: not wanted. The stages' frictional power is assessed where it
/// has not been.
Fault accumulate(Contact& contact, const Accumulation& accumulation, const DamageBins* wheel,
                 const DamageBins* rail, DamageTotals& totals);

/// Derivatives of the last tangential stage (sensitivities.cpp), found on a copy: the contact stays as it is.
Fault find_sensitivities(Contact& contact, TangentialSensitivities& sensitivities);

/// The surfaces whose expansion are the rows of find_gap(), heights up to one constant; of a contact that is
/// `posed`. Not real-time code.
SurfaceGap surface_gap(const Contact& contact);

/// Entry with data of the host: a gap, a pressure distribution, an exact double ellipse under load.
void take_gap(Contact& contact, const GapRows& rows);
Fault take_gap(Contact& contact, const GapGrid& grid);
Fault take_strips(Contact& contact, const Strips& strips);
Fault take_double_ellipse(Contact& contact, const Sdec& sdec, double normal_force);

}  // namespace wrc
