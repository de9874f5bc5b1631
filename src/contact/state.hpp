/// State of one wheel/rail pair: plain values, and the arrays behind them (contact/layout.hpp). A contact
/// holds no pointer into itself, so that saving and restoring it is a copy of bytes.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/fault.hpp"
#include "contact/model.hpp"
#include "geometry/contact_search.hpp"
#include "geometry/creepages.hpp"
#include "normal/problem.hpp"
#include "patch/sdec.hpp"
#include "patch/split.hpp"
#include "patch/strips.hpp"
#include "surface/wrench/wheel_on_rail.hpp"
#include "tangential/friction/friction.hpp"
#include "tangential/problem.hpp"

namespace wrc::contact {

/// Origin of the y of friction zones: the contact frame, the rail's profile, or the wheel's.
enum class ZoneFrame : std::int64_t { contact, rail, wheel };

/// Friction between the bodies, with the effect of a layer between them on the slope of the creep curve.
struct Friction {
  tangential::FrictionLaw law;
  ZoneFrame zone_frame = ZoneFrame::contact;
  double slope_reduction = 1.0;            ///< k0: slope at small creepages over that of clean bodies [-]
  tangential::SlopeFall slope;             ///< fall of that slope as slip grows
  tangential::Layer layer;                 ///< that shears and yields
  tangential::ReductionFactors reduction;  ///< those in Polach's force law
};

/// Direction and speed of rolling. Backwards the leading edge is at -x; creepages are sliding velocities over
/// `speed` in both directions.
struct Rolling {
  double speed = 0.0;          ///< V, magnitude [m/s]
  double direction = 1.0;      ///< 1: along x; -1: backwards
  double reverse_share = 0.0;  ///< share of the forces from rolling against `direction`, near standstill [-]
};

/// Wear and fatigue numbers of one contact.
struct DamageNumbers {
  double power = 0.0;                ///< frictional [W]
  double peak_power_density = 0.0;   ///< [W/m^2]
  double t_gamma = 0.0;              ///< power / speed [N]
  double t_gamma_no_spin = 0.0;      ///< |Fx nu_x + Fy nu_y| [N]
  double utilisation = 0.0;          ///< mu_a [-]
  double load_factor = 0.0;          ///< p0 / k [-]
  double shakedown_limit = 0.0;      ///< limit for p0 / k at mu_a [-]
  double fatigue_index = 0.0;        ///< [-]
  double local_fatigue_index = 0.0;  ///< largest over the cells; 0 without cells [-]
};

/// One of the patches of a contact: a run of its strips with the results on it.
struct Patch {
  std::int32_t first = 0, count = 0;                ///< strips of the patch
  std::int32_t region_first = 0, region_count = 0;  ///< strips its tangential fields live on
  patch::StripTotals extent;
  double y_contact = 0.0;               ///< place where its bodies first touch [m]
  patch::Sdec sdec;                     ///< its equivalent double ellipse about y_contact
  double friction = 0.0;                ///< mean over the load [-]
  tangential::TangentialForces forces;  ///< moment about the origin of the contact frame
};

/// Place of a region's point on both bodies, in the coordinates of their profiles [m].
struct RegionPlace {
  double y_wheel = 0.0, z_wheel = 0.0, y_rail = 0.0, z_rail = 0.0;
};

/// Wrench of a wheel on a rail, track axes of the host.
struct HostWrench {
  surface::Wrench wrench;      ///< about the reference point; height: displacement z of that point
  double rail_moment[3] = {};  ///< on the rail, about the displaced origin of its profile [N m]
  RegionPlace place[surface::most_surface_regions];
};

/// Newest solution of a contact: none, that of the stages, or that of a wheel on a rail.
enum class Solution : std::uint16_t { none, stages, wheel };

/// The furthest stage whose result the contact holds.
enum class Stage : std::uint16_t { none, gap, patch, tangential, damage };

/// Most patches one contact can report.
inline constexpr std::int32_t patch_capacity = 16;

/// Most breakpoints of friction over y.
inline constexpr std::int32_t zone_capacity = 64;

/// Members are ordered, and those of its members chosen, so that there is no padding: see below.
struct Contact {
  const Model* model = nullptr;
  Fault last;  ///< fault of the last call

  Stage reached = Stage::none;
  Solution newest = Solution::none;
  bool touching = false;      ///< false: the bodies are apart and forces are zero
  bool posed = false;         ///< pose and point belong to the gap in the contact
  bool pressed = false;       ///< the patch belongs to the load
  bool wheel_solved = false;  ///< `wheel` holds the last solve_wheel(); the stages do not use it
  std::int32_t gap_rows = 0;  ///< rows in use
  std::int32_t start_strips =
      0;                    ///< strips of the solution that the next normal solve may start from; 0: none
  std::int32_t strips = 0;  ///< strips of all patches
  std::int32_t patches = 0;
  std::int32_t main_patch = 0;                  ///< index of the patch with the largest load
  geometry::Side side = geometry::Side::right;  ///< side of the wheelset

  geometry::Pose pose;  ///< pose of the last geometry stage
  geometry::ContactPoint point;
  normal::NormalSolution normal;
  double damping_factor = 1.0;  ///< damped over elastic pressure; strips and normal hold the damped one [-]
  patch::StripTotals extent;    ///< sums over all patches
  Patch patch[patch_capacity];
  tangential::Creepage creepage;
  double friction = 0.0;  ///< mean over the load; each strip's is in Array::strip_friction [-]
  Friction law;           ///< friction of the last tangential stage; its zones are the two arrays below
  double zone_y[zone_capacity] = {}, zone_coefficient[zone_capacity] = {};  ///< [m], [-]
  Rolling rolling;
  double rolled = 0.0;  ///< distance since the last tangential stage, of a model that remembers [m]
  tangential::TangentialForces forces;  ///< sums over all patches
  DamageNumbers damage;
  HostWrench wheel;
};

// A contact is saved as its bytes: with padding, where anything may lie, equal states could differ in their
// bytes. Each line is a struct and the sum of its members.
static_assert(sizeof(void*) != 8 || sizeof(tangential::FrictionLaw) == 13 * sizeof(double));
static_assert(sizeof(Friction) == sizeof(tangential::FrictionLaw) + 2 * sizeof(double) +
                                      sizeof(tangential::SlopeFall) + sizeof(tangential::Layer) +
                                      sizeof(tangential::ReductionFactors));
static_assert(sizeof(normal::NormalSolution) == 7 * sizeof(double));
static_assert(sizeof(Patch) == 4 * sizeof(std::int32_t) + sizeof(patch::StripTotals) + sizeof(patch::Sdec) +
                                   sizeof(tangential::TangentialForces) + 2 * sizeof(double));
static_assert(sizeof(void*) != 8 ||
              sizeof(Contact) == sizeof(void*) + sizeof(Fault) + sizeof(Stage) + sizeof(Solution) +
                                     4 * sizeof(bool) + 5 * sizeof(std::int32_t) + sizeof(geometry::Side) +
                                     sizeof(geometry::Pose) + sizeof(geometry::ContactPoint) +
                                     sizeof(normal::NormalSolution) + sizeof(patch::StripTotals) +
                                     sizeof(Patch[patch_capacity]) + sizeof(tangential::Creepage) +
                                     sizeof(Friction) + (3 + 2 * zone_capacity) * sizeof(double) +
                                     sizeof(Rolling) + sizeof(tangential::TangentialForces) +
                                     sizeof(DamageNumbers) + sizeof(HostWrench));
static_assert(sizeof(surface::SurfaceRegion) == 2 * sizeof(std::int32_t) + 17 * sizeof(double));
static_assert(sizeof(HostWrench) ==
              2 * sizeof(std::int32_t) + 18 * sizeof(double) +
                  surface::most_surface_regions * (sizeof(surface::SurfaceRegion) + sizeof(RegionPlace)));

/// Bytes of a contact: its state, and behind it the larger of a copy of the state, on which sensitivities are
/// found, with all that the stages have behind it, and the work space of a wheel on a rail.
std::size_t contact_bytes(const Model& model);

/// Bytes of the state, the part that is saved and restored.
std::size_t state_bytes(const Model& model);

/// Makes an empty contact in `memory` (contact_bytes, aligned).
Contact& make_contact(const Model& model, geometry::Side side, void* memory);

/// Takes over a saved state (state_bytes).
void take_state(Contact& contact, const void* saved);

/// Forgets the results of every stage after `stage`; the stages' solution is the newest.
void back_to(Contact& contact, Stage stage);

/// Wheel and rail of the contact's side.
const Bodies& bodies(const Contact& contact);

/// An array of the contact; its length follows from the sizes in the model.
double* array(Contact& contact, Array which);
const double* array(const Contact& contact, Array which);

/// Views over the contact's arrays, for the strips and rows in use.
patch::GapRows gap_rows(const Contact& contact);
patch::Strips all_strips(Contact& contact);
patch::Strips patch_strips(Contact& contact, const Patch& patch);
patch::Strips region_strips(Contact& contact, const Patch& patch);

/// The block of a cell array that belongs to one patch: element (cell i, strip j) at
/// i * patch.region_count + j.
double* cell_block(Contact& contact, Array which, const Patch& patch);

/// The tractions and slips of one patch, where the tangential stage has them: see find_cells().
tangential::TangentialFields cell_fields(Contact& contact, const Patch& patch);

/// Are the arrays over cells those of the last tangential stage? They are lost with a wheel on a rail,
/// sensitivities and saved states, in whose memory they lie or that do not hold them.
double& cells_known(Contact& contact);

/// The state of a wheel on a rail, of a model that has one: a view, by which a constant contact is only read.
surface::SurfaceState surface_state(const Contact& contact);

/// Work space behind the state, as much as the stages or a wheel on a rail need. Nothing in it outlives a
/// call.
double* work_space(Contact& contact);

/// Does the tangential method give tractions and slip of every cell?
bool gives_fields(const Contact& contact);

}  // namespace wrc::contact
