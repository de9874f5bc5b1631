/// The wheel on a rail: arguments checked and translated, results handed back.
#include "abi/wheel.hpp"

#include <algorithm>
#include <cmath>

#include "abi/call.hpp"
#include "abi/friction.hpp"
#include "abi/results.hpp"
#include "base/elementary.hpp"
#include "base/flush_subnormals.hpp"

namespace wrc::abi {
namespace {

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
  Fault fault = check_all(r, 9, "input.wheel.rotation", "", -1.001, 1.001,
                          "these are not cosines between axes", "these are not cosines between axes");
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
            .field = "largest difference of input.wheel.rotation times its transpose from 1",
            .value = furthest,
            .unit = "",
            .low = 0.0,
            .high = tolerance,
            .cause = "this is no rotation; it is 9 numbers row by row"};
  }
  const double determinant = r[0] * (r[4] * r[8] - r[5] * r[7]) - r[1] * (r[3] * r[8] - r[5] * r[6]) +
                             r[2] * (r[3] * r[7] - r[4] * r[6]);
  if (determinant < 0.0) {
    return {
        .status = WRC_ERROR_RANGE,
        .field = "determinant of input.wheel.rotation",
        .value = determinant,
        .unit = "",
        .low = 1.0,
        .high = 1.0,
        .cause = "this is a mirror image; a left wheel is not mirrored, the contact's side says which it is"};
  }
  constexpr double sine_most = 0.479425538604203;  // of 0.5 rad
  if (!(r[4] > 0.0) || std::abs(r[1]) > sine_most || std::abs(r[7]) > sine_most) {
    return {
        .status = WRC_ERROR_RANGE,
        .field = "angle of the axle against the track's y axis: cosine",
        .value = r[4],
        .unit = "",
        .cause =
            "the second column of input.wheel.rotation is the axle in track axes, to the right: is it the "
            "transpose, or are axes named otherwise?"};
  }
  return {};
}

Fault read_wheel(const wrc_wheel_state& ours, bool height_read, HostedWheel& hosted) {
  Fault fault;
  if (height_read) fault = check(member<wrc_wheel_state>("z"), "input.wheel", ours.z);
  if (!fault.failed() && ours.rotation != nullptr) {
    constexpr const char* not_both = "give roll and yaw or a rotation, not both";
    fault = first_of({check(ours.roll, "input.wheel.roll", "rad", 0.0, 0.0, not_both, not_both),
                      check(ours.yaw, "input.wheel.yaw", "rad", 0.0, 0.0, not_both, not_both),
                      check_rotation(ours.rotation)});
  }
  if (fault.failed()) return fault;

  const double* const v = ours.velocity;
  const double* const w = ours.angular_velocity;
  double given[3][3];
  if (ours.rotation != nullptr) {
    for (int i = 0; i < 3; ++i) std::copy_n(ours.rotation + 3 * i, 3, given[i]);
    double axle[3] = {given[0][1], given[1][1], given[2][1]};
    const double length = std::sqrt(axle[0] * axle[0] + axle[1] * axle[1] + axle[2] * axle[2]);
    for (double& part : axle) part /= length;
    rotation_of_axle(axle, hosted.rotation);
  } else {
    const auto [sine_roll, cosine_roll] = sine_cosine(flush_subnormals(ours.roll));
    const auto [sine_yaw, cosine_yaw] = sine_cosine(flush_subnormals(ours.yaw));
    rotation_of_axle({-sine_yaw, cosine_roll * cosine_yaw, sine_roll * cosine_yaw}, hosted.rotation);
    for (int i = 0; i < 3; ++i) std::copy_n(hosted.rotation[i], 3, given[i]);
  }
  hosted.axes_turn = ours.angular_axes != WRC_AXES_TRACK;
  if (hosted.axes_turn)
    for (int i = 0; i < 3; ++i) std::copy_n(given[i], 3, hosted.axes[i]);
  hosted.of_wheelset = ours.reference == WRC_REFERENCE_WHEELSET;
  hosted.y = flush_subnormals(ours.y);
  hosted.z = height_read ? flush_subnormals(ours.z) : 0.0;
  for (int i = 0; i < 3; ++i) {
    hosted.velocity[i] = flush_subnormals(v[i]);
    hosted.angular_velocity[i] = flush_subnormals(
        ours.angular_axes == WRC_AXES_TRACK ? w[i]
                                            : given[i][0] * w[0] + given[i][1] * w[1] + given[i][2] * w[2]);
  }
  return {};
}

RailMotion rail_of(const wrc_rail_state& checked) {
  return {.y = flush_subnormals(checked.y),
          .z = flush_subnormals(checked.z),
          .roll = flush_subnormals(checked.roll),
          .velocity_y = flush_subnormals(checked.y_velocity),
          .velocity_z = flush_subnormals(checked.z_velocity),
          .velocity_roll = flush_subnormals(checked.roll_rate)};
}

/// Friction of a wheel on a rail. There is no contact frame that its zones could count from.
Fault read_hosted_friction(const wrc_friction& ours, const TangentialMethod& method, HostedWheel& hosted) {
  hosted.frictionless = ours.coefficient == 0.0 && ours.zone_count == 0;
  if (hosted.frictionless) return {};
  const Fault fault = read_friction(ours, "input.friction", method, hosted.friction);
  if (fault.failed()) return fault;
  if (hosted.friction.law.zones.count > 0 && hosted.friction.zone_frame == ZoneFrame::contact)
    return {.status = WRC_ERROR_UNSUPPORTED,
            .field = "input.friction.zone_frame",
            .value = static_cast<double>(ours.zone_frame),
            .unit = "",
            .cause =
                "a wheel on a rail has no one contact frame: use WRC_ZONES_RAIL_PROFILE or "
                "WRC_ZONES_WHEEL_PROFILE"};
  return {};
}

}  // namespace

Fault read_hosted(const wrc_wheel_input* theirs, const TangentialMethod& method, HostedWheel& hosted) {
  wrc_wheel_input ours;
  Fault fault = read(theirs, "input", ours);
  if (fault.failed()) return fault;
  const bool height = ours.prescribed == WRC_PRESCRIBE_HEIGHT;
  fault =
      first_of({read_wheel(ours.wheel, height, hosted), read_hosted_friction(ours.friction, method, hosted)});
  if (fault.failed()) return fault;
  hosted.rail = rail_of(ours.rail);
  hosted.rail.turning = flush_subnormals(ours.roller_rate);
  hosted.frame_speed = flush_subnormals(ours.frame.speed);
  hosted.frame_turning[0] = hosted.frame_speed * ours.frame.twist;
  hosted.frame_turning[1] = hosted.frame_speed * ours.frame.vertical_curvature;
  hosted.frame_turning[2] = hosted.frame_speed * ours.frame.curvature;
  hosted.load_prescribed = !height;
  hosted.start_anew = ours.start == WRC_START_COLD;
  hosted.vertical_load = ours.vertical_load;
  hosted.damping = flush_subnormals(ours.damping);
  hosted.distance = flush_subnormals(ours.distance);
  hosted.angle = flush_subnormals(ours.angle);
  return {};
}

wrc_wrench wrench_of(const HostedWrench& hosted) {
  const Wrench& wrench = hosted.wrench;
  wrc_wrench ours = empty<wrc_wrench>();
  ours.region_count = wrench.regions;
  ours.iterations = wrench.sweeps;
  for (int i = 0; i < 3; ++i) {
    ours.force[i] = wrench.force[i];
    ours.moment[i] = wrench.moment[i];
    ours.rail_force[i] = -wrench.force[i];
    ours.rail_moment[i] = hosted.rail_moment[i];
  }
  ours.z = wrench.height;
  ours.clearance = wrench.clearance;
  ours.normal_force = wrench.normal_force;
  ours.area = wrench.area;
  ours.peak_pressure = wrench.peak_pressure;
  ours.power = wrench.power;
  ours.steepest_angle = wrench.steepest_angle;
  return ours;
}

namespace {

wrc_wrench_derivatives derivatives_of(const HostedSlopes& slopes) {
  static_assert(hosted_inputs == WRC_WRENCH_INPUTS);
  wrc_wrench_derivatives ours = empty<wrc_wrench_derivatives>();
  for (int i = 0; i < 6; ++i) std::copy_n(slopes.wrench[i], hosted_inputs, ours.wrench[i]);
  std::copy_n(slopes.z, hosted_inputs, ours.z);
  return ours;
}

/// The solution stays in the contact. `slopes`: its derivatives; nullptr: not wanted.
Fault solve(Contact& contact, const wrc_wheel_input* input, HostedSlopes* slopes = nullptr) {
  contact.wheel_solved = 0;
  HostedWheel hosted;
  const Fault fault = read_hosted(input, *contact.model->options.tangential_method, hosted);
  return fault.failed() ? fault : solve_wheel(contact, hosted, slopes);
}

std::int32_t wheel_step(wrc_contact* handle, const wrc_wheel_input* input, wrc_wrench* wrench) {
  return call("wrc_contact_wrench", handle, clear(wrench), [&](Contact& contact) {
    const Fault outcome = solve(contact, input);
    if (!outcome.failed()) write(with_flags(wrench_of(contact.wheel), outcome), wrench);
    return outcome;
  });
}

}  // namespace
}  // namespace wrc::abi

namespace abi = wrc::abi;

extern "C" {

int32_t wrc_contact_wrench(wrc_contact* handle, const wrc_wheel_input* input, wrc_wrench* wrench) {
  return abi::wheel_step(handle, input, wrench);
}

int32_t wrc_contact_wrench_derivatives(wrc_contact* handle, const wrc_wheel_input* input,
                                         wrc_wrench* wrench, wrc_wrench_derivatives* derivatives) {
  return abi::call(
      __func__, handle, abi::first_of({abi::clear(wrench), abi::clear(derivatives)}), [&](wrc::Contact& contact) {
        wrc::HostedSlopes slopes;
        const wrc::Fault outcome = abi::solve(contact, input, derivatives == nullptr ? nullptr : &slopes);
        if (outcome.failed()) return outcome;
        abi::write(abi::with_flags(abi::wrench_of(contact.wheel), outcome), wrench);
        if (derivatives != nullptr) abi::write(abi::derivatives_of(slopes), derivatives);
        return outcome;
      });
}

int32_t wrc_contact_wrench_batch(wrc_contact* const* contacts, uint32_t count, const wrc_wheel_input* inputs,
                                 uint64_t input_stride, wrc_wrench* wrenches, uint64_t wrench_stride,
                                 int32_t* statuses) {
  return abi::batch(contacts, count, inputs, input_stride, wrenches, wrench_stride, statuses,
                    abi::wheel_step);
}

}  // extern "C"
