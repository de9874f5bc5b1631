/// A wheel on a rail: from the axes, sides and reference points of the host to those of src/surface and back.
#include "contact/wheel.hpp"

#include <algorithm>
#include <cmath>

#include "base/elementary.hpp"
#include "contact/methods.hpp"
#include "contact/wheel_placement.hpp"
#include "surface/geometry/rail_direction.hpp"
#include "surface/wrench/strip_rolling.hpp"

namespace wrc::contact {
namespace {

void mirror_wrench(surface::Wrench& wrench) {
  mirror_vector(wrench.force);
  mirror_rotation(wrench.moment);
  for (std::int32_t i = 0; i < wrench.regions; ++i) {
    surface::SurfaceRegion& region = wrench.region[i];
    mirror_vector(region.point);
    mirror_vector(region.force);
    mirror_rotation(region.moment);
    region.angle = -region.angle;
    region.creepage[1] = -region.creepage[1];
    region.creepage[2] = -region.creepage[2];
  }
}

/// Place of a region's point on the profiles of both bodies, of right-hand bodies with the wheel at this
/// height.
RegionPlace place_of(const Model& model, const surface::WheelOnRail& problem, double height,
                     const double* point) {
  // in the wheel's axes: y on its profile, and the radius less the nominal one
  const surface::WheelMotion& wheel = problem.wheel;
  const double position[3] = {wheel.position[0], wheel.position[1], height};
  double from_wheel[3] = {};
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < 3; ++i) from_wheel[k] += wheel.rotation[i][k] * (point[i] - position[i]);
  }

  // in the rail's axes, back to the section where the rail is not bent down: x^2 / (2 radius) of a roller
  const surface::RailMotion& rail = problem.rail;
  const auto [sine, cosine] = sine_cosine(rail.roll);
  double from_rail[3] = {point[0], point[1] - right_bodies(model).rail.origin_y - rail.y,
                         point[2] - right_bodies(model).rail.origin_z - rail.z};
  if (rail.slope_y != 0.0 || rail.slope_z != 0.0)
    surface::turn_along_rail(surface::direction_of(rail.slope_y, rail.slope_z), from_rail);
  const double y = from_rail[1];
  double z = from_rail[2];
  const double from_axle = point[0] - wheel.position[0] + problem.distance;
  z -= 0.5 * model.options.roller_curvature * from_axle * from_axle;
  return {.y_wheel = from_wheel[1],
          .z_wheel = std::sqrt(from_wheel[0] * from_wheel[0] + from_wheel[2] * from_wheel[2]) -
                     right_bodies(model).wheel.nominal_radius,
          .y_rail = cosine * y + sine * z,
          .z_rail = cosine * z - sine * y};
}

}  // namespace

namespace {

/// Does anything change with the distance along the track?
bool reads_distance(const Model& model) {
  const surface::SurfaceModel& surface = *model.surface;
  return (surface.varying.faces > 0 && !model.options.check_rail) || surface.roller_curvature != 0.0;
}

/// Refuses inputs that the model does not read, which would otherwise be lost in silence.
Fault check_read(const Model& model, const HostWheel& hosted) {
  const surface::SurfaceModel& surface = *model.surface;
  const bool roller = surface.roller_curvature != 0.0;
  if (hosted.rail.turning != 0.0 && !roller)
    return Fault::unsupported("input.roller_rate", {hosted.rail.turning, "rad/s"},
                              "the rail is no roller: give config.roller_curvature, or leave it 0");
  const surface::RailMotion& rail = hosted.rail;
  if (roller && (rail.slope_y != 0.0 || rail.slope_z != 0.0))
    return Fault::unsupported(rail.slope_y != 0.0 ? "input.rail.y_slope" : "input.rail.z_slope",
                              {rail.slope_y != 0.0 ? rail.slope_y : rail.slope_z, ""},
                              "a roller has no slope along the track: give the angle of its axle by the "
                              "wheel's yaw, and leave it 0");
  constexpr double beside_roller = 0.2;  // [m]
  if (roller && !(std::abs(hosted.distance) <= beside_roller))
    return Fault::range(
        "input.distance", {hosted.distance, "m", -beside_roller, beside_roller},
        "the wheel does not stand on the roller: this distance counts from the place above its axle");
  if (hosted.distance != 0.0 && !reads_distance(model))
    return Fault::unsupported("input.distance", {hosted.distance, "m"},
                              "the rail is the same everywhere: give config.rail_sections, or leave it 0");
  if (hosted.angle != 0.0 && surface.out_of_round.rows == 0)
    return Fault::unsupported("input.angle", {hosted.angle, "rad"},
                              "the wheel is round: give config.roundness, or leave it 0");
  if (hosted.time != 0.0 && !model.options.surface_memory)
    return Fault::unsupported(
        "input.time_step", {hosted.time, "s"},
        "the model remembers nothing between steps: set config.surface.memory to 1, or leave it 0");
  return {};
}

}  // namespace

Fault place_wheel(const Contact& contact, const HostWheel& hosted, PlacedWheel& placed) {
  const Model& model = *contact.model;
  if (model.surface == nullptr) {
    return Fault::unsupported(
        "contact", model.has_geometry
                       ? "a wheel on a rail needs profiles that can be cut into strips by arc length"
                       : "a wheel on a rail needs a model with profiles: give config.wheel and config.rail");
  }
  const Fault fault = check_read(model, hosted);
  if (fault.failed()) return fault;

  // bodies in the axes of the host, then those of the right-hand side
  placed = {};
  placed.left = contact.side == geometry::Side::left;
  const double outward = placed.left ? -1.0 : 1.0;
  PlacedMotion<double> motion = place_motion(right_bodies(model), hosted, placed.left, host_motion(hosted));
  placed.rail[0] = outward * right_bodies(model).rail.origin_y + hosted.rail.y;
  placed.rail[1] = right_bodies(model).rail.origin_z + hosted.rail.z;
  std::copy_n(motion.arm, 3, placed.arm);
  std::copy_n(motion.reference, 3, placed.reference);
  if (placed.left) mirror_motion(motion);

  surface::WheelOnRail& problem = placed.problem;
  problem.wheel = motion.wheel;
  problem.rail = motion.rail;
  problem.load_prescribed = hosted.load_prescribed;
  problem.vertical_load = hosted.vertical_load;

  // zones have coefficients of their own: then the one number only says that there is friction
  const tangential::FrictionLaw& law = hosted.friction.law;
  const bool films = hosted.films.cells != nullptr;
  problem.friction = hosted.frictionless ? 0.0 : law.zones.count > 0 || films ? 1.0 : law.coefficient;
  if (!law.is_one_number() || films) problem.law = &law;
  if (films) problem.films = &hosted.films;
  problem.layer_of_strips = films && hosted.films.layered > 0.0;
  problem.zones_on_wheel = law.zones.count > 0 && hosted.friction.zone_frame == ZoneFrame::wheel;
  problem.slope_reduction = hosted.friction.slope_reduction;
  problem.slope = hosted.friction.slope;
  problem.layer = hosted.friction.layer;
  problem.reduction = hosted.friction.reduction;
  problem.damping = hosted.damping;
  if (reads_distance(model)) problem.distance = hosted.distance + placed.arm[0];
  problem.angle = hosted.angle;
  problem.time = hosted.time;
  return {};
}

void hand_back_wrench(const Model& model, const PlacedWheel& placed, HostWrench& result) {
  surface::Wrench& wrench = result.wrench;
  if (placed.left) mirror_wrench(wrench);
  // from the wheel's reference point to the host's: M + arm x F
  add_cross(wrench.moment, placed.arm, wrench.force);
  const double z = placed.problem.load_prescribed ? wrench.height - placed.arm[2] : placed.reference[2];
  wrench.height = z + right_bodies(model).wheel.nominal_radius;

  // the rail bears the opposite of both, about the displaced origin of its profile
  const double from_rail[3] = {placed.reference[0], placed.reference[1] - placed.rail[0], z - placed.rail[1]};
  double about_rail[3] = {wrench.moment[0], wrench.moment[1], wrench.moment[2]};
  add_cross(about_rail, from_rail, wrench.force);
  for (int i = 0; i < 3; ++i) result.rail_moment[i] = -about_rail[i];
}

Fault mark_wheel(Contact& contact) {
  if (!contact.wheel_solved)
    return Fault::sequence("wrench", "there is none to mark: call wrc_contact_wrench first");
  surface::mark_solution(surface_state(contact));
  return {};
}

Fault commit_wheel(Contact& contact) {
  if (!contact.model->options.surface_memory)
    return Fault::unsupported("config.surface.memory", {0, ""},
                              "the model remembers nothing: wrc_contact_mark marks solutions");
  if (!contact.wheel_solved)
    return Fault::sequence("wrench", "there is none to commit: call wrc_contact_wrench first");
  if (surface::commit_solution(surface_state(contact))) return {};
  return Fault::sequence("wrench", "the last one is committed already: call wrc_contact_wrench first");
}

namespace {

/// Refuses inputs that a model that remembers cannot take.
Fault check_memory(const Model& model, const HostWheel& hosted) {
  if (!model.options.surface_memory) return {};
  if (hosted.friction.law.heated())
    return Fault::unsupported(
        "input.friction.temperature_law",
        "temperatures are those of steady rolling, which config.surface.memory does not solve");
  if (hosted.friction.layer.present() || hosted.films.layered > 0.0)
    return Fault::unsupported("input.friction.layer_thickness, layer_yield",
                              "config.surface.memory remembers tractions, not how far a layer has flowed");
  return {};
}

}  // namespace

Fault solve_wheel(Contact& contact, const HostWheel& hosted, HostJacobian* slopes) {
  // the results of the last solve are gone, whatever follows
  contact.wheel_solved = false;
  contact.newest = Solution::wheel;
  cells_known(contact) = 0.0;
  if (slopes) *slopes = {};
  contact.wheel = {};
  const Model& model = *contact.model;
  PlacedWheel placed;
  Fault fault = place_wheel(contact, hosted, placed);
  if (fault.failed()) return fault;
  if (slopes && !model.surface->methods.differentiable()) {
    const bool normal = model.surface->methods.planar.solve != nullptr;
    return Fault::unsupported(
        normal ? model.options.normal_method->is.name : model.options.tangential_method->is.name,
        normal ? "derivatives of a wrench are those of WRC_NORMAL_STRIP_HALFSPACE alone"
               : "derivatives of a wrench are those of WRC_TANGENTIAL_STRIP_FASTSIM alone");
  }
  if (model.options.non_steady && !model.options.surface_memory) {
    return Fault::unsupported(
        "config.planar.non_steady",
        "only the planar stages read it: for wrc_contact_wrench set config.surface.memory");
  }

  fault = check_memory(model, hosted);
  if (fault.failed()) return fault;
  if (placed.problem.layer_of_strips && surface::rolls_by_region(*model.surface, placed.problem))
    return Fault::unsupported(
        "input.friction.film_rows",
        "this tangential method rolls whole patches, which have one layer: let substances have none, or "
        "choose WRC_TANGENTIAL_STRIP_FASTSIM or WRC_TANGENTIAL_FASTSIM");

  // solved as right-hand bodies
  HostWrench& result = contact.wheel;
  surface::Wrench& wrench = result.wrench;
  const surface::WheelOnRail& problem = placed.problem;
  surface::RailFrameJacobian found, by_track;
  fault = surface::solve_wheel_on_rail(*model.surface, problem, hosted.from, surface_state(contact),
                                       work_space(contact), wrench, slopes ? &found : nullptr,
                                       slopes ? &by_track : nullptr);

  // a load that no height carries is an error, but for that of the climbing flag, which says where the wheel
  // is
  const bool touching = wrench.regions > 0 || fault.has(WRC_FLAG_CLIMBING);
  if (fault.failed() || (hosted.load_prescribed && !touching)) {
    result = {};
    if (fault.failed()) return fault;
    return Fault::load("input.vertical_load", {hosted.vertical_load, "N"},
                       "the rail carries this load at no height: is the wheel beside the rail?");
  }

  // back to the host: places while the wrench is still that of right-hand bodies
  for (std::int32_t i = 0; i < wrench.regions; ++i)
    result.place[i] = place_of(model, problem, wrench.height, wrench.region[i].point);
  if (slopes) hand_back_jacobian(model, hosted, placed, wrench.height, found, by_track, *slopes);
  hand_back_wrench(model, placed, result);
  if (!hosted.load_prescribed) wrench.height = hosted.z;
  contact.wheel_solved = true;
  return fault;
}

}  // namespace wrc::contact
