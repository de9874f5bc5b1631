/// A wheel on a rail: from the axes, sides and reference points of the host to those of src/surface and back.
#include "contact/wheel.hpp"

#include <algorithm>
#include <cmath>

#include "base/elementary.hpp"
#include "contact/methods.hpp"
#include "surface/geometry/rail_direction.hpp"

namespace wrc {
namespace {

/// a + b x c
void add_cross(double* a, const double* b, const double* c) {
  a[0] += b[1] * c[2] - b[2] * c[1];
  a[1] += b[2] * c[0] - b[0] * c[2];
  a[2] += b[0] * c[1] - b[1] * c[0];
}

/// Vectors change the sign of y in the mirror image of the track, rotations those of x and z.
void mirror_vector(double* v) { v[1] = -v[1]; }
void mirror_turning(double* w) {
  w[0] = -w[0];
  w[2] = -w[2];
}

void mirror_body(WheelOnRail& problem) {
  WheelMotion& wheel = problem.wheel;
  RailMotion& rail = problem.rail;
  mirror_vector(wheel.position);
  mirror_vector(wheel.velocity);
  mirror_turning(wheel.angular_velocity);
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      if ((i == 1) != (k == 1)) wheel.rotation[i][k] = -wheel.rotation[i][k];
    }
  }
  rail.y = -rail.y;
  rail.velocity_y = -rail.velocity_y;
  rail.roll = -rail.roll;
  rail.slope_y = -rail.slope_y;
  rail.velocity_roll = -rail.velocity_roll;
}

void mirror_wrench(Wrench& wrench) {
  mirror_vector(wrench.force);
  mirror_turning(wrench.moment);
  for (std::int32_t i = 0; i < wrench.regions; ++i) {
    SurfaceRegion& region = wrench.region[i];
    mirror_vector(region.point);
    mirror_vector(region.force);
    mirror_turning(region.moment);
    region.angle = -region.angle;
    region.creepage[1] = -region.creepage[1];
    region.creepage[2] = -region.creepage[2];
  }
}

/// From velocities in the frame that follows the track to those against the ground, at a point of the frame.
/// Nothing at all where it does not move: bits stay.
void add_frame(const HostWheel& hosted, const double (&point)[3], WheelMotion& wheel) {
  if (hosted.frame_speed == 0.0) return;
  wheel.velocity[0] += hosted.frame_speed;
  add_cross(wheel.velocity, hosted.frame_turning, point);
  for (int i = 0; i < 3; ++i) wheel.angular_velocity[i] += hosted.frame_turning[i];
}

/// The bodies of src/surface are right-hand ones.
const Bodies& right(const Model& model) { return model.bodies[static_cast<int>(Side::right)]; }

/// Of a region's point on right-hand bodies, wheel at its height.
RegionPlace place_of(const Model& model, const WheelOnRail& problem, const double* point) {
  const WheelMotion& wheel = problem.wheel;
  double from_wheel[3] = {};  // in the wheel's axes
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < 3; ++i) from_wheel[k] += wheel.rotation[i][k] * (point[i] - wheel.position[i]);
  }
  const RailMotion& rail = problem.rail;
  const auto [sine, cosine] = sine_cosine(rail.roll);
  double from_rail[3] = {point[0], point[1] - right(model).rail.origin_y - rail.y,
                         point[2] - right(model).rail.origin_z - rail.z};
  if (rail.slope_y != 0.0 || rail.slope_z != 0.0)
    turn_along_rail(direction_of(rail.slope_y, rail.slope_z), from_rail);
  const double y = from_rail[1];
  double z = from_rail[2];
  const double from_axle = point[0] - wheel.position[0] + problem.distance;
  z -= 0.5 * model.options.roller_curvature * from_axle * from_axle;  // what a roller falls
  return {.y_wheel = from_wheel[1],
          .z_wheel = std::sqrt(from_wheel[0] * from_wheel[0] + from_wheel[2] * from_wheel[2]) -
                     right(model).wheel.nominal_radius,
          .y_rail = cosine * y + sine * z,
          .z_rail = cosine * z - sine * y};
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
  const SurfaceModel& surface = *model.surface;
  const bool roller = surface.roller_curvature != 0.0;
  if (hosted.rail.turning != 0.0 && !roller)
    return Fault::unsupported("input.roller_rate", {hosted.rail.turning, "rad/s"},
                              "the rail is no roller: give config.roller_curvature, or leave it 0");
  const RailMotion& rail = hosted.rail;
  if (roller && (rail.slope_y != 0.0 || rail.slope_z != 0.0))
    return Fault::unsupported(
        rail.slope_y != 0.0 ? "input.rail.y_slope" : "input.rail.z_slope",
        {rail.slope_y != 0.0 ? rail.slope_y : rail.slope_z, ""},
        "a roller leads nowhere along the track: turn its axle by the wheel's yaw, and leave it 0");
  constexpr double beside_roller = 0.2;  // [m]
  if (roller && !(std::abs(hosted.distance) <= beside_roller))
    return Fault::range("input.distance", {hosted.distance, "m", -beside_roller, beside_roller},
                        "the wheel does not stand on the roller: it is counted from above its axle");
  const bool same_everywhere = surface.varying.faces == 0 || model.options.check_rail;
  if (hosted.distance != 0.0 && same_everywhere && !roller)
    return Fault::unsupported("input.distance", {hosted.distance, "m"},
                              "the rail is the same everywhere: give config.rail_sections, or leave it 0");
  if (hosted.angle != 0.0 && surface.out_of_round.rows == 0)
    return Fault::unsupported("input.angle", {hosted.angle, "rad"},
                              "the wheel is round: give config.roundness, or leave it 0");
  placed = {};
  placed.left = contact.side == Side::left;
  const double outward = placed.left ? -1.0 : 1.0;
  const double half_base = outward * right(model).wheel.origin_y;
  if (hosted.of_wheelset) {
    for (int i = 0; i < 3; ++i) placed.arm[i] = hosted.rotation[i][1] * half_base;
  }
  placed.reference[1] = hosted.y + (hosted.of_wheelset ? 0.0 : half_base);
  placed.reference[2] = hosted.z - right(model).wheel.nominal_radius;
  placed.rail[0] = outward * right(model).rail.origin_y + hosted.rail.y;
  placed.rail[1] = right(model).rail.origin_z + hosted.rail.z;

  WheelOnRail& problem = placed.problem;
  for (int i = 0; i < 3; ++i) {
    problem.wheel.position[i] = placed.reference[i] + placed.arm[i];
    problem.wheel.velocity[i] = hosted.velocity[i];
    problem.wheel.angular_velocity[i] = hosted.angular_velocity[i];
    for (int k = 0; k < 3; ++k) problem.wheel.rotation[i][k] = hosted.rotation[i][k];
  }
  add_frame(hosted, placed.reference, problem.wheel);
  add_cross(problem.wheel.velocity, problem.wheel.angular_velocity, placed.arm);
  problem.rail = hosted.rail;
  problem.load_prescribed = hosted.load_prescribed;
  problem.vertical_load = hosted.vertical_load;
  const FrictionLaw& law = hosted.friction.law;
  problem.friction = hosted.frictionless ? 0.0 : law.zones.count > 0 ? 1.0 : law.coefficient;
  if (!law.is_one_number()) problem.law = &law;
  problem.zones_on_wheel = law.zones.count > 0 && hosted.friction.zone_frame == ZoneFrame::wheel;
  problem.slope_reduction = hosted.friction.slope_reduction;
  problem.slope = hosted.friction.slope;
  problem.damping = hosted.damping;
  if (!same_everywhere || roller) problem.distance = hosted.distance + placed.arm[0];
  problem.angle = hosted.angle;
  if (placed.left) mirror_body(problem);
  return {};
}

void hand_back(const Model& model, const PlacedWheel& placed, HostWrench& result) {
  Wrench& wrench = result.wrench;
  if (placed.left) mirror_wrench(wrench);
  add_cross(wrench.moment, placed.arm, wrench.force);
  const double z = placed.problem.load_prescribed ? wrench.height - placed.arm[2] : placed.reference[2];
  wrench.height = z + right(model).wheel.nominal_radius;
  const double from_rail[3] = {placed.reference[0], placed.reference[1] - placed.rail[0], z - placed.rail[1]};
  double about_rail[3] = {wrench.moment[0], wrench.moment[1], wrench.moment[2]};
  add_cross(about_rail, from_rail, wrench.force);
  for (int i = 0; i < 3; ++i) result.rail_moment[i] = -about_rail[i];
}

Fault solve_wheel(Contact& contact, const HostWheel& hosted, HostJacobian* slopes) {
  contact.wheel_solved = false;
  contact.newest = Solution::wheel;
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
  if (model.options.non_steady) {
    return Fault::unsupported("config.planar.non_steady",
                              "wrc_contact_wrench rolls steadily: use a model without it");
  }

  auto& state = *reinterpret_cast<SurfaceState*>(array(contact, Array::surface_state));
  HostWrench& result = contact.wheel;
  Wrench& wrench = result.wrench;
  WheelOnRail& problem = placed.problem;
  RailFrameJacobian found, by_track;
  fault = solve_wheel_on_rail(*model.surface, problem, !hosted.from_scratch, state, work_space(contact),
                              wrench, slopes ? &found : nullptr, slopes ? &by_track : nullptr);
  const bool touching = wrench.regions > 0 || fault.has(WRC_FLAG_CLIMBING);
  if (fault.failed() || (hosted.load_prescribed && !touching)) {
    result = {};
    if (fault.failed()) return fault;
    return Fault::load("input.vertical_load", {hosted.vertical_load, "N"},
                       "at no height does the rail carry this: is the wheel beside it?");
  }
  problem.wheel.position[2] = wrench.height;
  for (std::int32_t i = 0; i < wrench.regions; ++i)
    result.place[i] = place_of(model, problem, wrench.region[i].point);
  if (slopes) hand_back(model, hosted, placed, found, by_track, *slopes);
  hand_back(model, placed, result);
  if (!hosted.load_prescribed) wrench.height = hosted.z;
  contact.wheel_solved = true;
  return fault;
}

}  // namespace wrc
