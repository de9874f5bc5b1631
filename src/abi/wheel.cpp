/// The wheel on a rail: arguments checked and translated, results handed back.
#include "abi/wheel.hpp"

#include <algorithm>
#include <cmath>

#include "abi/call.hpp"
#include "abi/friction.hpp"
#include "elementary.hpp"
#include "felt.hpp"

namespace wrc::abi {
namespace {

constexpr const char* millimetres = "did you pass mm?";
constexpr const char* degrees = "did you pass degrees or mrad?";

Fault none_of(const char* field, std::int32_t value, const char* cause) {
  return {.status = WRC_ERROR_UNSUPPORTED,
          .field = field,
          .value = static_cast<double>(value),
          .unit = "",
          .cause = cause};
}

/// R = Rx(roll) Rz(yaw) whose axle has the direction `axle` of unit length, which is (-sin yaw, cos roll cos
/// yaw, sin roll cos yaw): the rotation without its pitch.
void rotation_of_axle(const double (&axle)[3], double (&rotation)[3][3]) {
  const double cosine_yaw = std::sqrt(axle[1] * axle[1] + axle[2] * axle[2]), sine_yaw = -axle[0];
  const double cosine_roll = axle[1] / cosine_yaw, sine_roll = axle[2] / cosine_yaw;
  const double full[3][3] = {{cosine_yaw, -sine_yaw, 0.0},
                             {cosine_roll * sine_yaw, cosine_roll * cosine_yaw, -sine_roll},
                             {sine_roll * sine_yaw, sine_roll * cosine_yaw, cosine_roll}};
  for (int i = 0; i < 3; ++i) std::copy_n(full[i], 3, rotation[i]);
}

Fault check_rotation(const double* r) {
  Fault fault = check_all(r, 9, "wheel.rotation", "", -1.001, 1.001, "these are not cosines between axes",
                          "these are not cosines between axes");
  if (fault.failed()) return fault;
  constexpr double tolerance = 1e-6;
  double furthest = 0.0;  // of R R^T from 1
  for (int i = 0; i < 3; ++i) {
    for (int k = i; k < 3; ++k) {
      const double product = r[3 * i] * r[3 * k] + r[3 * i + 1] * r[3 * k + 1] + r[3 * i + 2] * r[3 * k + 2];
      furthest = std::max(furthest, std::abs(product - (i == k ? 1.0 : 0.0)));
    }
  }
  if (furthest > tolerance) {
    return {.status = WRC_ERROR_RANGE,
            .field = "largest difference of wheel.rotation times its transpose from 1",
            .value = furthest,
            .unit = "",
            .low = 0.0,
            .high = tolerance,
            .cause = "this is no rotation; it is 9 numbers row by row"};
  }
  const double determinant = r[0] * (r[4] * r[8] - r[5] * r[7]) - r[1] * (r[3] * r[8] - r[5] * r[6]) +
                             r[2] * (r[3] * r[7] - r[4] * r[6]);
  if (determinant < 0.0) {
    return {.status = WRC_ERROR_RANGE,
            .field = "determinant of wheel.rotation",
            .value = determinant,
            .unit = "",
            .low = 1.0,
            .high = 1.0,
            .cause = "this is a mirror image; a left wheel is not mirrored, wheel.side says which it is"};
  }
  constexpr double sine_most = 0.479425538604203;  // of 0.5 rad
  if (!(r[4] > 0.0) || std::abs(r[1]) > sine_most || std::abs(r[7]) > sine_most) {
    return {.status = WRC_ERROR_RANGE,
            .field = "angle of the axle against the track's y axis: cosine",
            .value = r[4],
            .unit = "",
            .cause =
                "the second column of wheel.rotation is the axle in track axes, to the right: is it the "
                "transpose, or are axes named otherwise?"};
  }
  return {};
}

Fault read_wheel(const wrc_wheel_state* theirs, bool height_read, HostedWheel& hosted) {
  wrc_wheel_state ours;
  Fault fault = read(theirs, "wheel", ours);
  if (fault.failed()) return fault;
  if (ours.side != WRC_SIDE_RIGHT && ours.side != WRC_SIDE_LEFT)
    return none_of("wheel.side", ours.side, "see enum wrc_side");
  if (ours.reference != WRC_REFERENCE_WHEELSET && ours.reference != WRC_REFERENCE_WHEEL)
    return none_of("wheel.reference", ours.reference, "see enum wrc_wheel_reference");
  if (ours.angular_axes != WRC_AXES_TRACK && ours.angular_axes != WRC_AXES_BODY)
    return none_of("wheel.angular_axes", ours.angular_axes, "see enum wrc_axes");
  const double angle_most = ours.rotation == nullptr ? 0.5 : 0.0;
  const char* const angle_cause =
      ours.rotation == nullptr ? degrees : "give roll and yaw or a rotation, not both";
  const double* const v = ours.velocity;
  const double* const w = ours.angular_velocity;
  fault = first_of(
      {check(ours.y, "wheel.y", "m", -0.2, 0.2, millimetres, millimetres),
       height_read
           ? check(ours.z, "wheel.z", "m", -0.5, 0.2, millimetres,
                   "did you pass mm, or a height above the rail? 0 is the nominal height, down is positive")
           : Fault{},
       check(ours.roll, "wheel.roll", "rad", -angle_most, angle_most, angle_cause, angle_cause),
       check(ours.yaw, "wheel.yaw", "rad", -angle_most, angle_most, angle_cause, angle_cause),
       check(v[0], "wheel.velocity[0]", "m/s", -200.0, 200.0, "did you pass km/h?", "did you pass km/h?"),
       check(v[1], "wheel.velocity[1]", "m/s", -50.0, 50.0, "did you pass mm/s, or other axes?",
             "did you pass mm/s, or other axes?"),
       check(v[2], "wheel.velocity[2]", "m/s", -50.0, 50.0, "did you pass mm/s, or other axes?",
             "did you pass mm/s, or other axes?"),
       check(w[0], "wheel.angular_velocity[0]", "rad/s", -200.0, 200.0, "the axle is the y axis",
             "the axle is the y axis"),
       check(w[1], "wheel.angular_velocity[1]", "rad/s", -2000.0, 2000.0, "did you pass rpm or degrees?",
             "did you pass rpm or degrees?"),
       check(w[2], "wheel.angular_velocity[2]", "rad/s", -200.0, 200.0, "the axle is the y axis",
             "the axle is the y axis")});
  if (!fault.failed() && ours.rotation != nullptr) fault = check_rotation(ours.rotation);
  if (fault.failed()) return fault;

  double given[3][3];
  if (ours.rotation != nullptr) {
    for (int i = 0; i < 3; ++i) std::copy_n(ours.rotation + 3 * i, 3, given[i]);
    double axle[3] = {given[0][1], given[1][1], given[2][1]};
    const double length = std::sqrt(axle[0] * axle[0] + axle[1] * axle[1] + axle[2] * axle[2]);
    for (double& part : axle) part /= length;
    rotation_of_axle(axle, hosted.rotation);
  } else {
    const auto [sine_roll, cosine_roll] = sine_cosine(felt(ours.roll));
    const auto [sine_yaw, cosine_yaw] = sine_cosine(felt(ours.yaw));
    rotation_of_axle({-sine_yaw, cosine_roll * cosine_yaw, sine_roll * cosine_yaw}, hosted.rotation);
    for (int i = 0; i < 3; ++i) std::copy_n(hosted.rotation[i], 3, given[i]);
  }
  hosted.side = ours.side == WRC_SIDE_LEFT ? Side::left : Side::right;
  hosted.of_wheelset = ours.reference == WRC_REFERENCE_WHEELSET;
  hosted.y = felt(ours.y);
  hosted.z = height_read ? felt(ours.z) : 0.0;
  for (int i = 0; i < 3; ++i) {
    hosted.velocity[i] = felt(v[i]);
    hosted.angular_velocity[i] = felt(ours.angular_axes == WRC_AXES_TRACK
                                          ? w[i]
                                          : given[i][0] * w[0] + given[i][1] * w[1] + given[i][2] * w[2]);
  }
  return {};
}

Fault read_rail(const wrc_rail_state* theirs, RailMotion& rail) {
  rail = {};
  if (theirs == nullptr) return {};
  wrc_rail_state ours;
  const Fault fault = read(theirs, "rail", ours);
  if (fault.failed()) return fault;
  rail = {.y = felt(ours.y),
          .z = felt(ours.z),
          .roll = felt(ours.roll),
          .velocity_y = felt(ours.y_velocity),
          .velocity_z = felt(ours.z_velocity),
          .velocity_roll = felt(ours.roll_velocity)};
  return first_of(
      {check(ours.y, "rail.y", "m", -0.2, 0.2, millimetres, millimetres),
       check(ours.z, "rail.z", "m", -0.2, 0.2, millimetres, millimetres),
       check(ours.roll, "rail.roll", "rad", -0.5, 0.5, degrees, degrees),
       check(ours.y_velocity, "rail.y_velocity", "m/s", -50.0, 50.0, "did you pass mm/s?",
             "did you pass mm/s?"),
       check(ours.z_velocity, "rail.z_velocity", "m/s", -50.0, 50.0, "did you pass mm/s?",
             "did you pass mm/s?"),
       check(ours.roll_velocity, "rail.roll_velocity", "rad/s", -200.0, 200.0, degrees, degrees)});
}

/// Friction of a wheel on a rail. There is no contact frame that its zones could count from.
Fault read_hosted_friction(const wrc_friction* theirs, HostedWheel& hosted) {
  hosted.frictionless = theirs == nullptr;
  if (hosted.frictionless) return {};
  const Fault fault = read_friction(theirs, TangentialMethod::strip_fastsim, hosted.friction);
  if (fault.failed()) return fault;
  if (hosted.friction.law.zones.count > 0 && hosted.friction.zone_frame != ZoneFrame::rail)
    return {.status = WRC_ERROR_UNSUPPORTED,
            .field = "friction.zone_frame",
            .value = static_cast<double>(theirs->zone_frame),
            .unit = "",
            .cause = "a wheel on a rail has no one contact frame: use WRC_ZONES_RAIL_PROFILE"};
  return {};
}

}  // namespace

Fault read_hosted(const wrc_wheel_input* theirs, HostedWheel& hosted) {
  wrc_wheel_input ours;
  Fault fault = read(theirs, "input", ours);
  if (fault.failed()) return fault;
  if (ours.prescribed != WRC_PRESCRIBE_HEIGHT && ours.prescribed != WRC_PRESCRIBE_VERTICAL_LOAD)
    return none_of("input.prescribed", ours.prescribed, "see enum wrc_wheel_prescribed");
  const bool height = ours.prescribed == WRC_PRESCRIBE_HEIGHT;
  fault = first_of(
      {read_wheel(ours.wheel, height, hosted), read_rail(ours.rail, hosted.rail),
       read_hosted_friction(ours.friction, hosted),
       height
           ? check(ours.vertical_load, "input.vertical_load", "N", 0.0, 0.0,
                   "the height is prescribed: leave the load 0",
                   "the height is prescribed: leave the load 0, or choose WRC_PRESCRIBE_VERTICAL_LOAD")
           : check(ours.vertical_load, "input.vertical_load", "N", 1e2, 1e6,
                   ours.vertical_load < 0.0 ? "the load is positive where the rail pushes the wheel upwards"
                                            : "did you pass kN? near lift-off prescribe the height instead",
                   "did you pass a pressure, or grams?"),
       height ? check(ours.damping, "input.damping", "s/m", 0.0, 10.0, "damping takes energy out",
                      "it is not a viscous constant: that over 3/2 of the force it was found at")
              : check(ours.damping, "input.damping", "s/m", 0.0, 0.0,
                      "a prescribed load is the whole load: leave damping 0",
                      "a prescribed load is the whole load: leave damping 0")});
  if (fault.failed()) return fault;
  hosted.load_prescribed = !height;
  hosted.vertical_load = ours.vertical_load;
  hosted.damping = felt(ours.damping);
  return {};
}

wrc_wrench wrench_of(const HostedWrench& hosted) {
  const Wrench& wrench = hosted.wrench;
  wrc_wrench ours = empty<wrc_wrench>();
  ours.regions = wrench.regions;
  ours.iterations = wrench.sweeps;
  for (int i = 0; i < 3; ++i) {
    ours.force[i] = wrench.force[i];
    ours.moment[i] = wrench.moment[i];
    ours.rail_force[i] = -wrench.force[i];
    ours.rail_moment[i] = hosted.rail_moment[i];
  }
  ours.z = wrench.height;
  ours.normal_force = wrench.normal_force;
  ours.area = wrench.area;
  ours.peak_pressure = wrench.peak_pressure;
  ours.power = wrench.power;
  ours.steepest_angle = hosted.steepest_angle;
  return ours;
}

namespace {

wrc_region region_of(const Contact& contact, std::int32_t index) {
  const SurfaceRegion& region = contact.wheel.wrench.region[index];
  const RegionPlace& place = contact.wheel.place[index];
  wrc_region ours = empty<wrc_region>();
  for (int i = 0; i < 3; ++i) {
    ours.point[i] = region.point[i];
    ours.force[i] = region.force[i];
    ours.moment[i] = region.moment[i];
    ours.creepage[i] = region.creepage[i];
  }
  ours.y_wheel = place.y_wheel;
  ours.z_wheel = place.z_wheel;
  ours.y_rail = place.y_rail;
  ours.z_rail = place.z_rail;
  ours.angle = region.angle;
  ours.normal_force = region.normal_force;
  ours.area = region.area;
  ours.peak_pressure = region.peak_pressure;
  ours.power = region.power;
  return ours;
}

std::int32_t wheel_step(wrc_contact* handle, const wrc_wheel_input* input, wrc_wrench* wrench) {
  return call(handle, clear(wrench), [&](Contact& contact) {
    contact.wheel_solved = 0;
    HostedWheel hosted;
    Fault outcome = read_hosted(input, hosted);
    if (!outcome.failed()) outcome = solve_wheel(contact, hosted);
    if (!outcome.failed()) write(wrench_of(contact.wheel), wrench);
    return outcome;
  });
}

}  // namespace
}  // namespace wrc::abi

namespace abi = wrc::abi;

extern "C" {

int32_t wrc_wheel_step(wrc_contact* handle, const wrc_wheel_input* input, wrc_wrench* wrench) {
  return abi::wheel_step(handle, input, wrench);
}

int32_t wrc_wheel_region(wrc_contact* handle, int32_t index, wrc_region* region) {
  return abi::call(handle, abi::clear(region), [&](wrc::Contact& contact) -> wrc::Fault {
    if (region == nullptr) return {.status = WRC_ERROR_NULL, .field = "region"};
    if (contact.wheel_solved == 0)
      return {.status = WRC_ERROR_SEQUENCE, .field = "region", .cause = "call wrc_wheel_step first"};
    const wrc::Fault outcome =
        abi::check(static_cast<double>(index), "index", "", 0.0, contact.wheel.wrench.regions - 1.0);
    if (!outcome.failed()) abi::write(abi::region_of(contact, index), region);
    return outcome;
  });
}

int32_t wrc_wheel_step_batch(wrc_contact* const* contacts, uint32_t count, const wrc_wheel_input* inputs,
                             uint64_t input_stride, wrc_wrench* wrenches, uint64_t wrench_stride,
                             int32_t* statuses) {
  const bool missing = contacts == nullptr || inputs == nullptr || wrenches == nullptr;
  wrc::Fault gravest{.status = missing ? WRC_ERROR_NULL : WRC_OK};
  for (uint32_t i = 0; i < count; ++i) {
    const int32_t status =
        abi::wheel_step(contacts == nullptr ? nullptr : contacts[i], abi::element(inputs, i * input_stride),
                        abi::element(wrenches, i * wrench_stride));
    if (statuses != nullptr) statuses[i] = status;
    worsen(gravest, wrc::Fault{.status = status});
  }
  return gravest.status;
}

int32_t wrc_wheel_step_flat(wrc_contact* handle, const double* in, double* out) {
  if (out != nullptr) std::fill_n(out, WRC_FLAT_WHEEL_OUTPUTS, 0.0);
  return abi::call(handle, {}, [&](wrc::Contact& contact) -> wrc::Fault {
    if (in == nullptr) return {.status = WRC_ERROR_NULL, .field = "in"};
    if (out == nullptr) return {.status = WRC_ERROR_NULL, .field = "out"};
    for (const int32_t k : {0, 1, 19}) {
      if (in[k] == 0.0 || in[k] == 1.0) continue;
      return {.status = std::isfinite(in[k]) ? WRC_ERROR_RANGE : WRC_ERROR_NOT_FINITE,
              .index = k,
              .field = "in",
              .value = in[k],
              .unit = "",
              .cause = "it stands for one of an enumeration: 0 or 1"};
    }
    wrc_wheel_state wheel = abi::defaults<wrc_wheel_state>();
    wheel.side = static_cast<int32_t>(in[0]);
    wheel.reference = static_cast<int32_t>(in[1]);
    wheel.y = in[2];
    wheel.z = in[3];
    wheel.roll = in[4];
    wheel.yaw = in[5];
    std::copy_n(in + 6, 3, wheel.velocity);
    std::copy_n(in + 9, 3, wheel.angular_velocity);
    wrc_rail_state rail = abi::defaults<wrc_rail_state>();
    rail.y = in[12];
    rail.z = in[13];
    rail.roll = in[14];
    rail.y_velocity = in[15];
    rail.z_velocity = in[16];
    rail.roll_velocity = in[17];
    wrc_friction friction = abi::defaults<wrc_friction>();
    friction.coefficient = in[18];
    wrc_wheel_input input = abi::defaults<wrc_wheel_input>();
    input.wheel = &wheel;
    input.rail = &rail;
    input.friction = in[18] == 0.0 ? nullptr : &friction;
    input.prescribed = static_cast<int32_t>(in[19]);
    input.vertical_load = in[20];
    input.damping = in[21];
    wrc::HostedWheel hosted;
    contact.wheel_solved = 0;
    wrc::Fault outcome = abi::read_hosted(&input, hosted);
    if (!outcome.failed()) outcome = wrc::solve_wheel(contact, hosted);
    if (outcome.failed()) return outcome;
    const wrc_wrench wrench = abi::wrench_of(contact.wheel);
    std::copy_n(wrench.force, 3, out);
    std::copy_n(wrench.moment, 3, out + 3);
    std::copy_n(wrench.rail_force, 3, out + 6);
    std::copy_n(wrench.rail_moment, 3, out + 9);
    out[12] = wrench.z;
    out[13] = wrench.normal_force;
    out[14] = wrench.area;
    out[15] = wrench.peak_pressure;
    out[16] = wrench.power;
    out[17] = wrench.regions;
    return outcome;
  });
}

}  // extern "C"
