/// The wheel on a rail: arguments checked and translated, results handed back.
#include "abi/wheel.hpp"

#include <algorithm>
#include <cmath>

#include "abi/call.hpp"
#include "abi/friction.hpp"
#include "abi/prescribed.hpp"
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

/// `r`: row by row, each number a cosine already.
Fault check_rotation(const double (&r)[9]) {
  constexpr double tolerance = 1e-6;
  double furthest = 0.0;  // largest |R R^T - 1|
  for (int i = 0; i < 3; ++i) {
    for (int k = i; k < 3; ++k) {
      const double product = r[3 * i] * r[3 * k] + r[3 * i + 1] * r[3 * k + 1] + r[3 * i + 2] * r[3 * k + 2];
      furthest = std::max(furthest, std::abs(product - (i == k ? 1.0 : 0.0)));
    }
  }
  if (furthest > tolerance) {
    return Fault::range("largest difference of input.wheel.rotation times its transpose from 1",
                        {furthest, "", 0.0, tolerance}, "this is no rotation");
  }
  const double determinant = r[0] * (r[4] * r[8] - r[5] * r[7]) - r[1] * (r[3] * r[8] - r[5] * r[6]) +
                             r[2] * (r[3] * r[7] - r[4] * r[6]);
  if (determinant < 0.0) {
    return Fault::range(
        "determinant of input.wheel.rotation", {determinant, "", 1.0, 1.0},
        "this is a mirror image; a left wheel is not mirrored, the contact's side says which it is");
  }
  constexpr double sine_most = 0.479425538604203;  // sin(0.5 rad)
  if (!(r[4] > 0.0) || std::abs(r[1]) > sine_most || std::abs(r[7]) > sine_most) {
    return Fault::range(
        "angle of the axle against the track's y axis: cosine", {r[4], ""},
        "the second column of input.wheel.rotation is the axle in track axes, to the right: is it the "
        "transpose, or are axes named otherwise?");
  }
  return {};
}

/// Reads the direction of the axle into hosted.rotation; `axes`: those of the body, which may be turned by
/// the pitch, track = axes * body.
Fault read_axle(const wrc_wheel_state& ours, contact::HostWheel& hosted, double (&axes)[3][3]) {
  if (ours.orientation == WRC_ORIENTATION_ANGLES) {
    const auto [sine_roll, cosine_roll] = sine_cosine(flush_subnormals(ours.roll));
    const auto [sine_yaw, cosine_yaw] = sine_cosine(flush_subnormals(ours.yaw));
    rotation_of_axle({-sine_yaw, cosine_roll * cosine_yaw, sine_roll * cosine_yaw}, hosted.rotation);
    for (int i = 0; i < 3; ++i) std::copy_n(hosted.rotation[i], 3, axes[i]);
    return {};
  }
  double rows[9];
  const bool by_columns = ours.orientation == WRC_ORIENTATION_COLUMNS;
  for (int i = 0; i < 9; ++i) rows[i] = ours.rotation[by_columns ? i % 3 * 3 + i / 3 : i];
  RETURN_IF_FAILED(check_rotation(rows));
  for (int i = 0; i < 3; ++i) std::copy_n(rows + 3 * i, 3, axes[i]);
  double axle[3] = {axes[0][1], axes[1][1], axes[2][1]};
  const double length = std::sqrt(axle[0] * axle[0] + axle[1] * axle[1] + axle[2] * axle[2]);
  for (double& part : axle) part /= length;
  rotation_of_axle(axle, hosted.rotation);
  return {};
}

/// Reads the angular velocity; `body`: the body's axes.
void read_turning(const wrc_wheel_state& ours, const double (&body)[3][3], contact::HostWheel& hosted) {
  const double rates[3] = {ours.roll_rate, ours.pitch_rate, ours.yaw_rate};
  const bool by_rates = ours.angular_axes == WRC_AXES_NONE, in_track = ours.angular_axes == WRC_AXES_TRACK;
  const double* const w = by_rates ? rates : ours.angular_velocity;
  for (int i = 0; i < 3; ++i) {
    if (!in_track) std::copy_n(by_rates ? hosted.rotation[i] : body[i], 3, hosted.axes[i]);
    if (by_rates) hosted.axes[i][0] = i == 0 ? 1.0 : 0.0;  // roll is about the track's x
    const double* const along = hosted.axes[i];
    hosted.angular_velocity[i] =
        flush_subnormals(in_track ? w[i] : along[0] * w[0] + along[1] * w[1] + along[2] * w[2]);
    hosted.turning_with_body[i] = in_track   ? 0.0
                                  : by_rates ? along[1] * w[1] + along[2] * w[2]
                                             : hosted.angular_velocity[i];
  }
}

/// Part of a vector across an axle of unit length, over its whole; 0 of none.
double part_across(const double (&v)[3], double x, double y, double z) {
  const double along = v[0] * x + v[1] * y + v[2] * z;
  const double across[3] = {v[0] - along * x, v[1] - along * y, v[2] - along * z};
  const auto square = [](const double(&a)[3]) { return a[0] * a[0] + a[1] * a[1] + a[2] * a[2]; };
  const double whole = square(v);
  return whole > 0.0 ? std::sqrt(square(across) / whole) : 0.0;
}

/// Flags a rotation whose transpose has its axle along the angular velocity, which its own has not: without
/// pitch a transpose is a rotation that a wheel may have.
Fault look_for_transpose(const wrc_wheel_state& ours, const double (&body)[3][3],
                         const contact::HostWheel& hosted) {
  constexpr double least = 1e-3, much_less = 0.05;
  if (ours.orientation == WRC_ORIENTATION_ANGLES || ours.angular_axes != WRC_AXES_TRACK) return {};
  const auto& w = hosted.angular_velocity;
  const double across = part_across(w, body[0][1], body[1][1], body[2][1]);
  const double of_transpose = part_across(w, body[1][0], body[1][1], body[1][2]);
  if (!(across > least && of_transpose < much_less * across)) return {};
  return Fault::rotation_transposed(
      "part of input.wheel.angular_velocity across the axle", {across, "", 0.0, least},
      ours.orientation == WRC_ORIENTATION_ROWS
          ? "the angular velocity lies along the axle of the transpose of input.wheel.rotation: "
            "did you pass its columns? then say WRC_ORIENTATION_COLUMNS"
          : "the angular velocity lies along the axle of the transpose of input.wheel.rotation: "
            "did you pass its rows? then say WRC_ORIENTATION_ROWS");
}

Fault read_wheel(const wrc_wheel_state& ours, bool height_read, contact::HostWheel& hosted) {
  Fault fault;
  double body[3][3];
  if (height_read) fault = check(MEMBER(wrc_wheel_state, "z"), "input.wheel", ours.z);
  if (!fault.failed()) fault = read_axle(ours, hosted, body);
  if (fault.failed()) return fault;
  read_turning(ours, body, hosted);
  hosted.of_wheelset = ours.reference == WRC_REFERENCE_WHEELSET;
  hosted.y = flush_subnormals(ours.y);
  hosted.z = height_read ? flush_subnormals(ours.z) : 0.0;
  for (int i = 0; i < 3; ++i) hosted.velocity[i] = flush_subnormals(ours.velocity[i]);
  return look_for_transpose(ours, body, hosted);
}

surface::RailMotion rail_of(const wrc_rail_state& checked) {
  return {.y = flush_subnormals(checked.y),
          .z = flush_subnormals(checked.z),
          .roll = flush_subnormals(checked.roll),
          .slope_y = flush_subnormals(checked.y_slope),
          .slope_z = flush_subnormals(checked.z_slope),
          .velocity_y = flush_subnormals(checked.y_velocity),
          .velocity_z = flush_subnormals(checked.z_velocity),
          .velocity_roll = flush_subnormals(checked.roll_rate)};
}

/// Friction of a wheel on a rail. There is no contact frame that its zones could count from.
Fault read_hosted_friction(const wrc_friction& ours, const contact::TangentialMethod& method,
                           contact::HostWheel& hosted) {
  RETURN_IF_FAILED(read_films(ours, "input.friction", method, hosted.films));
  hosted.frictionless = ours.coefficient == 0.0 && ours.zone_count == 0 && ours.film_numbers == 0;
  if (hosted.frictionless) return {};
  RETURN_IF_FAILED(read_friction(ours, "input.friction", method, hosted.friction, Films::apart));
  if (hosted.friction.law.zones.count > 0 && hosted.friction.zone_frame == contact::ZoneFrame::contact)
    return Fault::unsupported("input.friction.zone_frame", {ours.zone_frame, ""},
                              "a wheel on a rail has no one contact frame: use WRC_ZONES_RAIL_PROFILE or "
                              "WRC_ZONES_WHEEL_PROFILE");
  return {};
}

}  // namespace

Fault read_hosted(const wrc_wheel_input* theirs, const contact::TangentialMethod& method,
                  contact::HostWheel& hosted) {
  wrc_wheel_input ours;
  Fault fault = read(theirs, "input", ours);
  if (!fault.failed()) fault = check_prescribed_of_wheel(ours.prescribed, "input");
  if (fault.failed()) return fault;
  const bool height = ours.prescribed == WRC_PRESCRIBE_HEIGHT;
  const Fault wheel = read_wheel(ours.wheel, height, hosted);
  fault = first_of({wheel, read_hosted_friction(ours.friction, method, hosted)});
  if (fault.failed()) return fault;
  hosted.rail = rail_of(ours.rail);
  hosted.rail.turning = flush_subnormals(ours.roller_rate);
  hosted.frame_speed = flush_subnormals(ours.frame.speed);
  hosted.frame_turning[0] = hosted.frame_speed * ours.frame.twist;
  hosted.frame_turning[1] = hosted.frame_speed * ours.frame.vertical_curvature;
  hosted.frame_turning[2] = hosted.frame_speed * ours.frame.curvature;
  hosted.load_prescribed = !height;
  static_assert(same<WRC_START_COLD>(surface::SolutionStart::anew) &&
                same<WRC_START_WARM>(surface::SolutionStart::last) &&
                same<WRC_START_MARK>(surface::SolutionStart::mark));
  hosted.from = static_cast<surface::SolutionStart>(ours.start);
  hosted.vertical_load = ours.vertical_load;
  hosted.damping = flush_subnormals(ours.damping);
  hosted.distance = flush_subnormals(ours.distance);
  hosted.angle = flush_subnormals(ours.angle);
  hosted.time = flush_subnormals(ours.time_step);
  return wheel;
}

wrc_wrench wrench_of(const contact::HostWrench& hosted) {
  const surface::Wrench& wrench = hosted.wrench;
  wrc_wrench ours = empty<wrc_wrench>();
  ours.region_count = wrench.regions;
  ours.iterations = wrench.iterations;
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
  ours.residual = wrench.residual;
  ours.work = wrench.work;
  return ours;
}

namespace {

wrc_wrench_derivatives derivatives_of(const contact::HostJacobian& slopes) {
  static_assert(contact::hosted_inputs == WRC_WRENCH_INPUTS);
  wrc_wrench_derivatives ours = empty<wrc_wrench_derivatives>();
  for (int i = 0; i < 6; ++i) std::copy_n(slopes.wrench[i], contact::hosted_inputs, ours.wrench[i]);
  std::copy_n(slopes.z, contact::hosted_inputs, ours.z);
  return ours;
}

/// The solution stays in the contact. `slopes`: its derivatives; nullptr: not wanted.
Fault solve(contact::Contact& contact, const wrc_wheel_input* input,
            contact::HostJacobian* slopes = nullptr) {
  contact.wheel_solved = false;
  contact::HostWheel hosted;
  const Fault reading = read_hosted(input, *contact.model->options.tangential_method, hosted);
  if (reading.failed()) return reading;
  Fault fault = contact::solve_wheel(contact, hosted, slopes);
  keep_worst(fault, reading);
  return fault;
}

std::int32_t wheel_step(wrc_contact* handle, const wrc_wheel_input* input, wrc_wrench* wrench) {
  return call("wrc_contact_wrench", handle, clear(wrench), [&](contact::Contact& contact) {
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

int32_t wrc_contact_wrench_derivatives(wrc_contact* handle, const wrc_wheel_input* input, wrc_wrench* wrench,
                                       wrc_wrench_derivatives* derivatives) {
  return abi::call(__func__, handle, abi::first_of({abi::clear(wrench), abi::clear(derivatives)}),
                   [&](wrc::contact::Contact& contact) {
                     wrc::contact::HostJacobian slopes;
                     const wrc::Fault outcome =
                         abi::solve(contact, input, derivatives == nullptr ? nullptr : &slopes);
                     if (outcome.failed()) return outcome;
                     abi::write(abi::with_flags(abi::wrench_of(contact.wheel), outcome), wrench);
                     if (derivatives != nullptr) abi::write(abi::derivatives_of(slopes), derivatives);
                     return outcome;
                   });
}

int32_t wrc_contact_mark(wrc_contact* handle) {
  return abi::call(__func__, handle, wrc::Fault{},
                   [](wrc::contact::Contact& contact) { return wrc::contact::mark_wheel(contact); });
}

int32_t wrc_contact_commit(wrc_contact* handle) {
  return abi::call(__func__, handle, wrc::Fault{},
                   [](wrc::contact::Contact& contact) { return wrc::contact::commit_wheel(contact); });
}

int32_t wrc_contact_wrench_batch(wrc_contact* const* contacts, uint32_t count, const wrc_wheel_input* inputs,
                                 uint64_t input_stride, wrc_wrench* wrenches, uint64_t wrench_stride,
                                 int32_t* statuses) {
  return abi::batch(contacts, count, inputs, input_stride, wrenches, wrench_stride, statuses,
                    abi::wheel_step);
}

}  // extern "C"
