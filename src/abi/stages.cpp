/// The stages and the step: arguments checked and translated, outputs zeroed on failure.
#include "contact/stages.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "abi/call.hpp"
#include "abi/friction.hpp"
#include "abi/prescribed.hpp"
#include "abi/results.hpp"
#include "base/elementary.hpp"
#include "base/flush_subnormals.hpp"
#include "wrc/wrc_planar.h"

namespace wrc::abi {
namespace {

// ------------------------------------------------------------------------------------------------ reading
// arguments

geometry::Pose pose_of(const wrc_planar_pose& checked) {
  return {.lateral = flush_subnormals(checked.lateral),
          .roll = flush_subnormals(checked.roll),
          .yaw = flush_subnormals(checked.yaw)};
}

contact::Load load_of(const wrc_planar_load& checked) {
  return checked.prescribed == WRC_PRESCRIBE_NORMAL_FORCE
             ? contact::Load{normal::Prescribed::load, checked.normal_force}
             : contact::Load{normal::Prescribed::approach, checked.approach, checked.approach_velocity,
                             checked.damping};
}

// Creepages of wrc_planar_creepages() are within the range that wrc_planar_tangential() takes.
static_assert(MEMBER(wrc_creepage, "longitudinal").high == geometry::largest_creepage);
static_assert(MEMBER(wrc_creepage, "lateral").high == geometry::largest_creepage);
static_assert(MEMBER(wrc_creepage, "spin").high == geometry::largest_spin);
static_assert(MEMBER(wrc_creepage, "speed").high == geometry::fastest_rolling);
static_assert(MEMBER(wrc_creepage, "reverse_share").high == geometry::largest_share_of_other_way);
static_assert(MEMBER(wrc_planar_motion, "speed").high == geometry::fastest_rolling);

tangential::Creepage creepage_of(const wrc_creepage& checked) {
  return {flush_subnormals(checked.longitudinal), flush_subnormals(checked.lateral),
          flush_subnormals(checked.spin)};
}

contact::Rolling rolling_of(const wrc_creepage& checked) {
  const double speed = flush_subnormals(checked.speed);
  return {std::fabs(speed), speed < 0.0 ? -1.0 : 1.0, flush_subnormals(checked.reverse_share)};
}

/// Positions of rows, or of columns. `spacing`: the name of their distance.
Fault check_increasing(const double* y, std::uint32_t count, const char* of, const char* field,
                       const char* spacing, const char* cause) {
  for (std::uint32_t j = 1; j < count; ++j) {
    if (y[j] > y[j - 1] && y[j] - y[j - 1] < patch::row_spacing_least) {
      return Fault::gap(
          {of, spacing, j}, {y[j] - y[j - 1], "m", patch::row_spacing_least, 0.6},
          "they are so close together that slopes come from errors of the heights: leave one out");
    }
    if (!(y[j] > y[j - 1])) {
      return Fault::gap({of, field, j}, {y[j], "m"}, cause);
    }
  }
  return {};
}

Fault check_stride(const wrc_planar_gap& gap, const char* of) {
  Fault fault = check(static_cast<double>(gap.row_stride), "row_stride", "",
                      static_cast<double>(gap.column_count), 1e12, "rows overlap: the stride is in elements");
  fault.of = of;
  return fault;
}

Fault take_gap(contact::Contact& contact, const wrc_planar_gap* theirs, const char* of) {
  wrc_planar_gap gap;
  RETURN_IF_FAILED(read(theirs, of, gap));
  const std::int32_t room = contact.model->options.sizes.gap_rows;
  RETURN_IF_FAILED(check(MEMBER(wrc_planar_gap, "row_count"), of, gap.row_count, room));
  RETURN_IF_FAILED(check_increasing(gap.y, gap.row_count, of, "y", "y: spacing",
                                    "rows must be in order of strictly increasing y"));
  const auto rows = static_cast<std::int32_t>(gap.row_count);

  // Heights over a grid of x and y, from which the stage fits parabolas.
  if (gap.column_count > 0) {
    RETURN_IF_FAILED(check_stride(gap, of));
    RETURN_IF_FAILED(check_increasing(gap.x, gap.column_count, of, "x", "x: spacing",
                                      "columns must be in order of strictly increasing x"));
    for (std::uint32_t j = 0; j < gap.row_count; ++j) {
      Fault fault = check_all(MEMBER(wrc_planar_gap, "h"), of, gap.h + j * gap.row_stride, gap.column_count);
      fault.index += static_cast<std::int32_t>(j * gap.row_stride);
      if (fault.failed()) return fault;
    }
    return wrc::contact::take_gap(
        contact, patch::GapGrid{rows, static_cast<std::int32_t>(gap.column_count), gap.x, gap.y, gap.h,
                                static_cast<std::int64_t>(gap.row_stride)});
  }

  wrc::contact::take_gap(contact, patch::GapRows{rows, gap.y, gap.height, gap.centre, gap.curvature});
  return {};
}

Fault take_strips(contact::Contact& contact, const wrc_planar_strips* theirs) {
  wrc_planar_strips strips;
  RETURN_IF_FAILED(read(theirs, "strips", strips));
  const std::int32_t room = contact.model->options.sizes.strips;
  RETURN_IF_FAILED(check(MEMBER(wrc_planar_strips, "count"), "strips", strips.count, room));
  for (std::uint32_t j = 1; j < strips.count; ++j) {
    const double allowed = 1e-9 * strips.width[j];  // borders may meet up to rounding
    if (strips.y[j] - 0.5 * strips.width[j] < strips.y[j - 1] + 0.5 * strips.width[j - 1] - allowed) {
      return Fault::range({"strips", "y", j}, {strips.y[j], "m"},
                          "strips must be in order of increasing y and not overlap");
    }
  }
  // The strips of the caller are only read; the internal view has no const form.
  return wrc::contact::take_strips(contact,
                                   patch::Strips{.capacity = static_cast<std::int32_t>(strips.count),
                                                 .count = static_cast<std::int32_t>(strips.count),
                                                 .y = const_cast<double*>(strips.y),
                                                 .width = const_cast<double*>(strips.width),
                                                 .centre = const_cast<double*>(strips.centre),
                                                 .half_length = const_cast<double*>(strips.half_length),
                                                 .peak = const_cast<double*>(strips.peak)});
}

Fault take_ellipse(contact::Contact& contact, const wrc_ellipse* theirs) {
  wrc_ellipse ellipse;
  RETURN_IF_FAILED(read(theirs, "ellipse", ellipse));
  return contact::take_double_ellipse(contact, patch::Sdec{ellipse.a, ellipse.b, ellipse.psi},
                                      ellipse.normal_force);
}

// ------------------------------------------------------------------------------------------------- writing
// results

wrc_planar_point point_of(const contact::Contact& contact) {
  wrc_planar_point ours{};
  ours.x = contact.point.x;
  ours.y = contact.point.y;
  ours.z = contact.point.z;
  ours.y_wheel = contact.point.y_wheel;
  ours.y_rail = contact.point.y_rail;
  ours.angle = contact.point.angle;
  ours.vertical_gap = contact.point.vertical_gap;
  ours.rolling_radius = contact.point.rolling_radius;
  return ours;
}

wrc_planar_normal_solution normal_of(const contact::Contact& contact) {
  wrc_planar_normal_solution ours{};
  ours.approach = contact.normal.approach;
  if (!contact.touching) return ours;
  const patch::StripTotals& extent = contact.extent;
  ours.patch_count = contact.patches;
  ours.strip_count = contact.strips;
  ours.iterations = static_cast<std::int32_t>(contact.normal.iterations);
  const contact::Patch& main = contact.patch[contact.main_patch];
  ours.ellipse = ellipse_of(main.sdec, main.y_contact, main.extent.normal_force);
  ours.normal_force = extent.normal_force;
  ours.damping_force = extent.normal_force * (1.0 - 1.0 / contact.damping_factor);
  ours.stiffness = contact.normal.stiffness;
  ours.peak_pressure = extent.peak_pressure;
  ours.area = extent.area;
  ours.length = extent.length;
  ours.width = extent.y_max - extent.y_min;
  ours.y_min = extent.y_min;
  ours.y_max = extent.y_max;
  return ours;
}

/// Ends a call of the normal stage whose patch is known: equivalent ellipses, then the result. `outcome`: of
/// the call so far.
Fault regularise_and_write(contact::Contact& contact, Fault outcome, wrc_planar_normal_solution* normal) {
  if (!outcome.failed()) keep_worst(outcome, contact::regularise_patch(contact));
  if (!outcome.failed()) write(with_flags(normal_of(contact), outcome), normal);
  return outcome;
}

/// Bits of enum wrc_available that hold for results from the cells.
std::uint32_t of_tractions(const contact::Contact& contact) {
  return contact::gives_fields(contact) ? std::uint32_t{WRC_AVAILABLE_TRACTIONS} : 0U;
}

wrc_planar_forces forces_of(const contact::Contact& contact) {
  const tangential::TangentialForces& forces = contact.forces;
  wrc_planar_forces ours{};
  if (!contact.touching) return ours;
  ours.fx = forces.fx;
  ours.fy = forces.fy;
  ours.fn = contact.extent.normal_force;
  ours.mz = forces.mz;
  ours.power = forces.power_per_speed * contact.rolling.speed;
  ours.adhesion_fraction = forces.adhesion_fraction;
  ours.available = of_tractions(contact);
  return ours;
}

// ----------------------------------------------------------------------------------------------------------
// stages

/// The gravest fault of all stages, with the flags of all; `normal` and `tangential`: the faults of these
/// two.
Fault solve_step(contact::Contact& contact, const wrc_planar_input* input, Fault& normal, Fault& tangential) {
  // All of the input is checked before the first stage runs.
  wrc_planar_input in;
  contact::Friction friction;
  RETURN_IF_FAILED(read(input, "input", in));
  RETURN_IF_FAILED(check_prescribed_of_plane(in.load.prescribed, "input.load"));
  RETURN_IF_FAILED(
      read_friction(in.friction, "input.friction", *contact.model->options.tangential_method, friction));

  // A stage that fails ends the step; flags of those that ran are kept.
  Fault outcome = in.gap != nullptr ? take_gap(contact, in.gap, "input.gap")
                                    : contact::find_gap(contact, pose_of(in.pose));
  if (outcome.failed()) return outcome;
  normal = contact::solve_normal(contact, load_of(in.load));
  if (!normal.failed()) keep_worst(normal, contact::regularise_patch(contact));
  keep_worst(outcome, normal);
  if (outcome.failed()) return outcome;
  tangential =
      contact::solve_tangential(contact, creepage_of(in.creepage), friction, rolling_of(in.creepage));
  keep_worst(outcome, tangential);
  if (!outcome.failed()) keep_worst(outcome, contact::assess_damage(contact));
  return outcome;
}

std::int32_t step(wrc_contact* handle, const wrc_planar_input* input, wrc_planar_output* output) {
  return call("wrc_planar_step", handle, clear(output), [&](contact::Contact& contact) {
    Fault normal, tangential;
    const Fault outcome = solve_step(contact, input, normal, tangential);
    if (outcome.failed() || output == nullptr) return outcome;
    wrc_planar_output ours = empty<wrc_planar_output>();
    if (contact.posed) ours.point = point_of(contact);
    ours.flags = outcome.all_flags();
    ours.normal = with_flags(normal_of(contact), normal);
    ours.forces = with_flags(forces_of(contact), tangential);
    if (contact.touching) ours.damage = damage_of(contact.damage, contact::gives_fields(contact));
    write(ours, output);
    return outcome;
  });
}

}  // namespace
}  // namespace wrc::abi

using wrc::Fault;
using wrc::contact::Contact;
namespace abi = wrc::abi;

extern "C" {

int32_t wrc_planar_geometry(wrc_contact* handle, const wrc_planar_pose* pose, wrc_planar_point* point) {
  return abi::call(__func__, handle, abi::clear(point), [&](Contact& contact) {
    wrc_planar_pose ours;
    RETURN_IF_FAILED(abi::read(pose, "pose", ours));
    const Fault outcome = wrc::contact::find_gap(contact, abi::pose_of(ours));
    if (!outcome.failed()) abi::write(abi::point_of(contact), point);
    return outcome;
  });
}

int32_t wrc_planar_creepages(wrc_contact* handle, const wrc_planar_motion* motion, wrc_creepage* creepage) {
  return abi::call(__func__, handle, abi::clear(creepage), [&](Contact& contact) -> Fault {
    wrc_planar_motion ours;
    RETURN_IF_FAILED(abi::read(motion, "motion", ours));
    wrc::geometry::RigidCreepage rigid;
    const Fault outcome = wrc::contact::find_creepages(contact,
                                                       {.speed = ours.speed,
                                                        .lateral_velocity = ours.lateral_velocity,
                                                        .vertical_velocity = ours.vertical_velocity,
                                                        .roll_rate = ours.roll_rate,
                                                        .yaw_rate = ours.yaw_rate,
                                                        .pitch_rate = ours.pitch_rate},
                                                       rigid);
    if (outcome.failed()) return outcome;
    wrc_creepage result = abi::defaults<wrc_creepage>();
    result.longitudinal = rigid.longitudinal;
    result.lateral = rigid.lateral;
    result.spin = rigid.spin;
    result.speed = rigid.rolling_speed;
    result.reverse_share = rigid.reverse_share;
    result.approach_velocity = rigid.normal_velocity;
    abi::write(result, creepage);
    return outcome;
  });
}

int32_t wrc_planar_normal(wrc_contact* handle, const wrc_planar_gap* gap, const wrc_planar_load* load,
                          wrc_planar_normal_solution* normal) {
  return abi::call(__func__, handle, abi::clear(normal), [&](Contact& contact) -> Fault {
    wrc_planar_load ours;
    RETURN_IF_FAILED(abi::read(load, "load", ours));
    RETURN_IF_FAILED(abi::check_prescribed_of_plane(ours.prescribed, "load"));
    Fault outcome = gap == nullptr ? Fault{} : abi::take_gap(contact, gap, "gap");
    if (!outcome.failed()) keep_worst(outcome, wrc::contact::solve_normal(contact, abi::load_of(ours)));
    return abi::regularise_and_write(contact, outcome, normal);
  });
}

int32_t wrc_planar_regularise(wrc_contact* handle, const wrc_planar_strips* strips,
                              wrc_planar_normal_solution* normal) {
  return abi::call(__func__, handle, abi::clear(normal), [&](Contact& contact) {
    return abi::regularise_and_write(contact, strips == nullptr ? Fault{} : abi::take_strips(contact, strips),
                                     normal);
  });
}

int32_t wrc_planar_roll(wrc_contact* handle, double distance) {
  return abi::call(__func__, handle, {}, [&](Contact& contact) -> Fault {
    if (!contact.model->options.non_steady) {
      return Fault::unsupported("distance", {distance, "m"},
                                "the model's config.planar.non_steady is 0: rolling is steady");
    }
    constexpr double farthest = 1e6;
    const Fault outcome = abi::check(distance, "distance", "m", 0.0, farthest,
                                     "the sign of creepage.speed is the way", "did you pass mm?");
    if (!outcome.failed())
      contact.rolled = std::min(farthest, contact.rolled + wrc::flush_subnormals(distance));
    return outcome;
  });
}

int32_t wrc_planar_tangential(wrc_contact* handle, const wrc_ellipse* ellipse, const wrc_creepage* creepage,
                              const wrc_friction* friction, wrc_planar_forces* forces) {
  return abi::call(__func__, handle, abi::clear(forces), [&](Contact& contact) {
    wrc_creepage ours;
    wrc_friction theirs;
    wrc::contact::Friction law;
    RETURN_IF_FAILED(abi::read(creepage, "creepage", ours));
    RETURN_IF_FAILED(abi::read(friction, "friction", theirs));
    RETURN_IF_FAILED(abi::read_friction(theirs, "friction", *contact.model->options.tangential_method, law));
    Fault outcome = ellipse == nullptr ? Fault{} : abi::take_ellipse(contact, ellipse);
    if (!outcome.failed())
      keep_worst(outcome,
                 wrc::contact::solve_tangential(contact, abi::creepage_of(ours), law, abi::rolling_of(ours)));
    if (!outcome.failed()) abi::write(abi::with_flags(abi::forces_of(contact), outcome), forces);
    return outcome;
  });
}

int32_t wrc_planar_step(wrc_contact* handle, const wrc_planar_input* input, wrc_planar_output* output) {
  return abi::step(handle, input, output);
}

}  // extern "C"
