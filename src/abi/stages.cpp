/// The stages, the step and the field views: arguments checked and translated, outputs zeroed on failure.
#include <algorithm>
#include <cmath>

#include "abi/call.hpp"
#include "abi/friction.hpp"
#include "base/flush_subnormals.hpp"

namespace wrc::abi {
namespace {

// ------------------------------------------------------------------------------------------------ reading
// arguments

Fault read_pose(const wrc_pose* theirs, Pose& pose) {
  wrc_pose ours;
  const Fault fault = read(theirs, "pose", ours);
  pose = {.lateral = flush_subnormals(ours.lateral),
          .roll = flush_subnormals(ours.roll),
          .yaw = flush_subnormals(ours.yaw)};
  return fault;
}

Fault read_load(const wrc_load* theirs, Load& load) {
  wrc_load ours;
  const Fault fault = read(theirs, "load", ours);
  load = ours.prescribed == WRC_PRESCRIBE_LOAD
             ? Load{Prescribed::load, ours.normal_force}
             : Load{Prescribed::approach, ours.approach, ours.approach_velocity, ours.damping};
  return fault;
}

// What wrc_contact_creepages() makes of a motion is within what wrc_contact_tangential() takes.
static_assert(member<wrc_creepage>("longitudinal").high == largest_creepage);
static_assert(member<wrc_creepage>("lateral").high == largest_creepage);
static_assert(member<wrc_creepage>("spin").high == largest_spin);
static_assert(member<wrc_creepage>("speed").high == fastest_rolling);
static_assert(member<wrc_creepage>("other_way").high == largest_share_of_other_way);
static_assert(member<wrc_motion>("speed").high == fastest_rolling);

Fault read_creepage(const wrc_creepage* theirs, Creepage& creepage, Rolling& rolling) {
  wrc_creepage ours;
  const Fault fault = read(theirs, "creepage", ours);
  creepage = {flush_subnormals(ours.longitudinal), flush_subnormals(ours.lateral),
              flush_subnormals(ours.spin)};
  const double speed = flush_subnormals(ours.speed);
  rolling = {std::fabs(speed), speed < 0.0 ? -1.0 : 1.0, flush_subnormals(ours.other_way)};
  return fault;
}

/// Positions of rows or of the elements in them. `spacing`: what their distance is called.
Fault check_increasing(const double* y, std::uint32_t count, const char* field, const char* spacing,
                       const char* cause) {
  for (std::uint32_t j = 1; j < count; ++j) {
    if (y[j] > y[j - 1] && y[j] - y[j - 1] < row_spacing_least) {
      return {.status = WRC_ERROR_GAP,
              .index = static_cast<std::int32_t>(j),
              .field = spacing,
              .value = y[j] - y[j - 1],
              .unit = "m",
              .low = row_spacing_least,
              .high = 0.6,
              .cause = "so close together, slopes are made of the errors of heights: leave one out"};
    }
    if (!(y[j] > y[j - 1])) {
      return {.status = WRC_ERROR_GAP,
              .index = static_cast<std::int32_t>(j),
              .field = field,
              .value = y[j],
              .unit = "m",
              .cause = cause};
    }
  }
  return {};
}

Fault take_gap(Contact& contact, const wrc_gap* theirs) {
  wrc_gap gap;
  Fault fault = read(theirs, "gap", gap);
  if (fault.failed()) return fault;
  const std::int32_t room = contact.model->options.sizes.gap_rows;
  fault = first_of({check(member<wrc_gap>("rows"), "gap", gap.rows, room),
                    check_increasing(gap.y, gap.rows, "gap.y", "spacing of gap.y",
                                     "rows must be in order of strictly increasing y")});
  if (fault.failed()) return fault;
  const auto rows = static_cast<std::int32_t>(gap.rows);

  if (gap.columns > 0) {
    fault =
        first_of({check(static_cast<double>(gap.row_stride), "gap.row_stride", "",
                        static_cast<double>(gap.columns), 1e12, "rows overlap: the stride is in elements"),
                  check_increasing(gap.x, gap.columns, "gap.x", "spacing of gap.x",
                                   "columns must be in order of strictly increasing x")});
    if (fault.failed()) return fault;
    for (std::uint32_t j = 0; j < gap.rows; ++j) {
      fault = check_all(member<wrc_gap>("h"), "gap", gap.h + j * gap.row_stride, gap.columns);
      fault.index += static_cast<std::int32_t>(j * gap.row_stride);
      if (fault.failed()) return fault;
    }
    return wrc::take_gap(contact, GapGrid{rows, static_cast<std::int32_t>(gap.columns), gap.x, gap.y, gap.h,
                                          static_cast<std::int64_t>(gap.row_stride)});
  }

  wrc::take_gap(contact, GapRows{rows, gap.y, gap.height, gap.centre, gap.curvature});
  return {};
}

Fault take_strips(Contact& contact, const wrc_strips* theirs) {
  wrc_strips strips;
  Fault fault = read(theirs, "strips", strips);
  if (fault.failed()) return fault;
  const std::int32_t room = contact.model->options.sizes.strips;
  fault = check(member<wrc_strips>("count"), "strips", strips.count, room);
  if (fault.failed()) return fault;
  for (std::uint32_t j = 1; j < strips.count; ++j) {
    const double allowed = 1e-9 * strips.width[j];  // borders may meet up to rounding
    if (strips.y[j] - 0.5 * strips.width[j] < strips.y[j - 1] + 0.5 * strips.width[j - 1] - allowed) {
      return {.status = WRC_ERROR_RANGE,
              .index = static_cast<std::int32_t>(j),
              .of = "strips",
              .field = "y",
              .value = strips.y[j],
              .unit = "m",
              .cause = "strips must be in order of increasing y and not overlap"};
    }
  }
  // The strips of the caller are only read; the internal view has no const form.
  return wrc::take_strips(contact, Strips{.capacity = static_cast<std::int32_t>(strips.count),
                                          .count = static_cast<std::int32_t>(strips.count),
                                          .y = const_cast<double*>(strips.y),
                                          .width = const_cast<double*>(strips.width),
                                          .centre = const_cast<double*>(strips.centre),
                                          .half_length = const_cast<double*>(strips.half_length),
                                          .peak = const_cast<double*>(strips.peak)});
}

Fault take_patch(Contact& contact, const wrc_patch* theirs) {
  wrc_patch patch;
  const Fault fault = read(theirs, "patch", patch);
  if (fault.failed()) return fault;
  return take_double_ellipse(contact, Sdec{patch.a, patch.b, patch.psi}, patch.normal_force);
}

// ------------------------------------------------------------------------------------------------- writing
// results

wrc_contact_point point_of(const Contact& contact) {
  wrc_contact_point ours{};
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

/// `extent` and `shape`: of one patch, or of the whole contact and the patch that speaks for its shape.
wrc_patch patch_of(const Contact& contact, const StripTotals& extent, const Patch& shape,
                   std::int32_t strips) {
  wrc_patch ours{};
  ours.approach = contact.normal.approach;
  if (!contact.touching) return ours;
  ours.strips = strips;
  ours.iterations = static_cast<std::int32_t>(contact.normal.iterations);
  ours.patches = contact.patches;
  ours.a = shape.sdec.a;
  ours.b = shape.sdec.b;
  ours.psi = shape.sdec.psi;
  ours.normal_force = extent.normal_force;
  ours.stiffness = contact.normal.stiffness;
  ours.peak_pressure = extent.peak_pressure;
  ours.area = extent.area;
  ours.length = extent.length;
  ours.width = extent.y_max - extent.y_min;
  ours.y_min = extent.y_min;
  ours.y_max = extent.y_max;
  ours.damping_force = extent.normal_force * (1.0 - 1.0 / contact.damping_factor);
  return ours;
}

wrc_patch patch_of(const Contact& contact) {
  return patch_of(contact, contact.extent, contact.patch[contact.main_patch], contact.strips);
}

wrc_forces forces_of(const Contact& contact, const TangentialForces& forces, double normal_force) {
  wrc_forces ours{};
  if (!contact.touching) return ours;
  ours.fx = forces.fx;
  ours.fy = forces.fy;
  ours.fn = normal_force;
  ours.mz = forces.mz;
  ours.power = forces.power_per_speed * contact.rolling.speed;
  ours.adhesion_fraction = forces.adhesion_fraction;
  return ours;
}

wrc_forces forces_of(const Contact& contact) {
  return forces_of(contact, contact.forces, contact.extent.normal_force);
}

wrc_damage damage_of(const Contact& contact) {
  wrc_damage ours{};
  if (!contact.touching) return ours;
  ours.power = contact.damage.power;
  ours.peak_power_density = contact.damage.peak_power_density;
  ours.t_gamma = contact.damage.t_gamma;
  ours.t_gamma_no_spin = contact.damage.t_gamma_no_spin;
  ours.utilisation = contact.damage.utilisation;
  ours.load_factor = contact.damage.load_factor;
  ours.shakedown_limit = contact.damage.shakedown_limit;
  ours.fatigue_index = contact.damage.fatigue_index;
  ours.local_fatigue_index = contact.damage.local_fatigue_index;
  return ours;
}

/// struct_size of the local results is that of today's structs; write() keeps the caller's.
template <typename Struct>
void give(Struct ours, Struct* theirs) {
  ours.struct_size = sizeof(Struct);
  write(ours, theirs);
}

// ----------------------------------------------------------------------------------------------------------
// stages

/// The outputs of a step, zeroed; as read from the caller's struct.
Fault clear_outputs(const wrc_output* output, wrc_output& out) {
  const Fault fault = read(output, "output", out);
  if (fault.failed()) return fault;
  return first_of({clear(out.point), clear(out.patch), clear(out.forces), clear(out.damage)});
}

Fault solve_step(Contact& contact, const wrc_input* input, const wrc_output& out) {
  wrc_input in;
  Fault outcome = read(input, "input", in);
  if (outcome.failed()) return outcome;
  if (in.pose == nullptr && in.gap == nullptr) {
    return {.status = WRC_ERROR_NULL, .field = "input", .cause = "give a pose, or a gap of your own"};
  }
  Load load;
  Creepage creepage;
  Friction friction;
  Rolling rolling;
  outcome = first_of({read_load(in.load, load), read_creepage(in.creepage, creepage, rolling),
                      read_friction(in.friction, *contact.model->options.tangential_method, friction)});
  if (outcome.failed()) return outcome;
  if (in.pose != nullptr) {
    Pose pose;
    outcome = read_pose(in.pose, pose);
    if (!outcome.failed()) keep_worst(outcome, find_gap(contact, pose));
  } else {
    outcome = take_gap(contact, in.gap);
  }
  if (!outcome.failed()) keep_worst(outcome, solve_normal(contact, load));
  if (!outcome.failed()) keep_worst(outcome, regularise_patch(contact));
  if (!outcome.failed()) keep_worst(outcome, solve_tangential(contact, creepage, friction, rolling));
  if (!outcome.failed()) keep_worst(outcome, assess_damage(contact));
  if (outcome.failed()) return outcome;

  if (in.pose != nullptr) give(point_of(contact), out.point);
  give(patch_of(contact), out.patch);
  give(forces_of(contact), out.forces);
  give(damage_of(contact), out.damage);
  return outcome;
}

std::int32_t step(wrc_contact* handle, const wrc_input* input, const wrc_output* output) {
  wrc_output out;
  const Fault cleared = clear_outputs(output, out);
  return call(handle, cleared, [&](Contact& contact) { return solve_step(contact, input, out); });
}

/// Where a field lies and how long it is.
struct Field {
  const double* data = nullptr;          ///< nullptr: its stage has not been reached
  std::int32_t cells = 0, elements = 0;  ///< cells == 0: one value per strip or row
};

/// Fields of the tangential stage and what is made of them; the strips and the gap come from the normal
/// stage.
bool needs_cells(std::int32_t id) {
  return id <= WRC_FIELD_FATIGUE_INDEX || id == WRC_FIELD_STRIP_POWER || id == WRC_FIELD_STRIP_WEAR ||
         id == WRC_FIELD_STRIP_FRICTION;
}

Field find_field(const Contact& contact, const Patch* patch, std::int32_t id) {
  static constexpr Array cell_fields[] = {Array::cell_x,        Array::pressure,     Array::traction_x,
                                          Array::traction_y,    Array::slip_x,       Array::slip_y,
                                          Array::power_density, Array::fatigue_index};
  static constexpr Array patch_fields[] = {Array::patch_y, Array::patch_width, Array::patch_centre,
                                           Array::patch_half_length, Array::patch_peak};
  static constexpr Array region_fields[] = {Array::region_y, Array::region_width, Array::region_centre,
                                            Array::region_half_length, Array::region_peak};
  static constexpr Array gap_fields[] = {Array::gap_y, Array::gap_height, Array::gap_centre,
                                         Array::gap_curvature};

  if (id >= WRC_FIELD_GAP_Y && id <= WRC_FIELD_GAP_CURVATURE) {
    if (contact.gap_rows == 0) return {};
    return {array(contact, gap_fields[id - WRC_FIELD_GAP_Y]), 0, contact.gap_rows};
  }
  if (patch == nullptr || !contact.touching) return {};
  const bool rolled = contact.reached >= Stage::tangential && gives_fields(contact);
  const bool assessed = contact.reached >= Stage::damage;
  if (id == WRC_FIELD_STRIP_POWER) {
    if (!assessed) return {};
    return {array(contact, Array::strip_power) + patch->region_first, 0, patch->region_count};
  }
  if (id == WRC_FIELD_STRIP_FRICTION) {
    if (!rolled) return {};
    return {array(contact, Array::strip_friction) + patch->region_first, 0, patch->region_count};
  }
  if (id == WRC_FIELD_STRIP_WEAR) {
    if (!contact.worn) return {};
    return {array(contact, Array::strip_wear) + patch->region_first, 0, patch->region_count};
  }
  if (id >= WRC_FIELD_STRIP_Y) {
    const std::int32_t k = id - WRC_FIELD_STRIP_Y;
    if (rolled) return {array(contact, region_fields[k]) + patch->region_first, 0, patch->region_count};
    return {array(contact, patch_fields[k]) + patch->first, 0, patch->count};
  }
  if (!rolled || (id >= WRC_FIELD_POWER_DENSITY && !assessed)) return {};
  const std::int32_t cells = contact.model->options.sizes.cells;
  return {array(contact, cell_fields[id]) + patch->region_first * cells, cells, patch->region_count};
}

}  // namespace
}  // namespace wrc::abi

using wrc::Contact;
using wrc::Fault;
namespace abi = wrc::abi;

extern "C" {

int32_t wrc_contact_geometry(wrc_contact* handle, const wrc_pose* pose, wrc_contact_point* point) {
  return abi::call(handle, abi::clear(point), [&](Contact& contact) {
    wrc::Pose ours;
    Fault outcome = abi::read_pose(pose, ours);
    if (outcome.failed()) return outcome;
    outcome = wrc::find_gap(contact, ours);
    if (!outcome.failed()) abi::give(abi::point_of(contact), point);
    return outcome;
  });
}

int32_t wrc_contact_creepages(wrc_contact* handle, const wrc_motion* motion, wrc_creepage* creepage) {
  return abi::call(handle, abi::clear(creepage), [&](Contact& contact) -> Fault {
    wrc_motion ours;
    Fault outcome = abi::read(motion, "motion", ours);
    if (outcome.failed()) return outcome;
    wrc::RigidCreepage rigid;
    outcome = wrc::find_creepages(contact,
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
    result.other_way = rigid.other_way;
    result.approach_velocity = rigid.normal_velocity;
    abi::give(result, creepage);
    return outcome;
  });
}

int32_t wrc_contact_normal(wrc_contact* handle, const wrc_gap* gap, const wrc_load* load, wrc_patch* patch) {
  return abi::call(handle, abi::clear(patch), [&](Contact& contact) {
    wrc::Load ours;
    Fault outcome = abi::read_load(load, ours);
    if (!outcome.failed() && gap != nullptr) outcome = abi::take_gap(contact, gap);
    if (!outcome.failed()) keep_worst(outcome, wrc::solve_normal(contact, ours));
    if (!outcome.failed()) keep_worst(outcome, wrc::regularise_patch(contact));
    if (!outcome.failed()) abi::give(abi::patch_of(contact), patch);
    return outcome;
  });
}

int32_t wrc_contact_regularise(wrc_contact* handle, const wrc_strips* strips, wrc_patch* patch) {
  return abi::call(handle, abi::clear(patch), [&](Contact& contact) {
    Fault outcome;
    if (strips != nullptr) outcome = abi::take_strips(contact, strips);
    if (!outcome.failed()) keep_worst(outcome, wrc::regularise_patch(contact));
    if (!outcome.failed()) abi::give(abi::patch_of(contact), patch);
    return outcome;
  });
}

int32_t wrc_contact_tangential(wrc_contact* handle, const wrc_patch* patch, const wrc_creepage* creepage,
                               const wrc_friction* friction, wrc_forces* forces) {
  return abi::call(handle, abi::clear(forces), [&](Contact& contact) {
    wrc::Creepage ours;
    wrc::Friction law;
    wrc::Rolling rolling;
    Fault outcome =
        abi::first_of({abi::read_creepage(creepage, ours, rolling),
                       abi::read_friction(friction, *contact.model->options.tangential_method, law)});
    if (!outcome.failed() && patch != nullptr) outcome = abi::take_patch(contact, patch);
    if (!outcome.failed()) keep_worst(outcome, wrc::solve_tangential(contact, ours, law, rolling));
    if (!outcome.failed()) abi::give(abi::forces_of(contact), forces);
    return outcome;
  });
}

int32_t wrc_contact_damage(wrc_contact* handle, wrc_damage* damage) {
  return abi::call(handle, abi::clear(damage), [&](Contact& contact) {
    const Fault outcome = wrc::assess_damage(contact);
    if (!outcome.failed()) abi::give(abi::damage_of(contact), damage);
    return outcome;
  });
}

int32_t wrc_contact_step(wrc_contact* handle, const wrc_input* input, wrc_output* output) {
  return abi::step(handle, input, output);
}

int32_t wrc_contact_step_batch(wrc_contact* const* contacts, uint32_t count, const wrc_input* inputs,
                               uint64_t input_stride, const wrc_output* outputs, uint64_t output_stride,
                               int32_t* statuses) {
  // An array that is missing is a NULL in every step, so that what there is of outputs gets zeroed.
  const bool missing = contacts == nullptr || inputs == nullptr || outputs == nullptr;
  Fault gravest{.status = missing ? WRC_ERROR_NULL : WRC_OK};
  for (uint32_t i = 0; i < count; ++i) {
    const int32_t status =
        abi::step(contacts == nullptr ? nullptr : contacts[i], abi::element(inputs, i * input_stride),
                  abi::element(outputs, i * output_stride));
    if (statuses != nullptr) statuses[i] = status;
    keep_worst(gravest, Fault{.status = status});
  }
  return gravest.status;
}

int32_t wrc_contact_step_flat(wrc_contact* handle, const double* in, double* out) {
  if (out != nullptr) std::fill_n(out, WRC_FLAT_OUTPUTS, 0.0);
  return abi::call(handle, {}, [&](Contact& contact) -> Fault {
    if (in == nullptr) return {.status = WRC_ERROR_NULL, .field = "in"};
    if (out == nullptr) return {.status = WRC_ERROR_NULL, .field = "out"};
    wrc_pose pose = abi::defaults<wrc_pose>();
    pose.lateral = in[0];
    pose.roll = in[1];
    pose.yaw = in[2];
    wrc_load load = abi::defaults<wrc_load>();
    load.normal_force = in[3];
    wrc_creepage creepage = abi::defaults<wrc_creepage>();
    creepage.longitudinal = in[4];
    creepage.lateral = in[5];
    creepage.spin = in[6];
    wrc_friction friction = abi::defaults<wrc_friction>();
    friction.coefficient = in[7];
    wrc_input input = abi::defaults<wrc_input>();
    input.pose = &pose;
    input.load = &load;
    input.creepage = &creepage;
    input.friction = &friction;
    const wrc_output nothing = abi::defaults<wrc_output>();
    const Fault outcome = abi::solve_step(contact, &input, nothing);
    if (outcome.failed()) return outcome;
    const wrc_forces forces = abi::forces_of(contact);
    const wrc_patch patch = abi::patch_of(contact);
    const double values[WRC_FLAT_OUTPUTS] = {
        forces.fx,    forces.fy,      forces.fn,           forces.mz,
        forces.power, patch.approach, patch.peak_pressure, patch.area,
        patch.a,      patch.b,        patch.psi,           abi::damage_of(contact).fatigue_index};
    std::copy_n(values, WRC_FLAT_OUTPUTS, out);
    return outcome;
  });
}

int32_t wrc_contact_patch(wrc_contact* handle, int32_t index, wrc_patch* patch, wrc_forces* forces) {
  const Fault cleared = abi::first_of({abi::clear(patch), abi::clear(forces)});
  return abi::call(handle, cleared, [&](Contact& contact) -> Fault {
    if (contact.patches == 0)
      return {.status = WRC_ERROR_SEQUENCE, .field = "patch", .cause = "there is no patch yet"};
    const Fault outcome = abi::check(static_cast<double>(index), "index", "", 0.0, contact.patches - 1.0);
    if (outcome.failed()) return outcome;
    const wrc::Patch& one = contact.patch[index];
    abi::give(abi::patch_of(contact, one.extent, one, one.count), patch);
    if (contact.reached >= wrc::Stage::tangential) {
      abi::give(abi::forces_of(contact, one.forces, one.extent.normal_force), forces);
    }
    return outcome;
  });
}

int32_t wrc_contact_field(const wrc_contact* handle, int32_t patch, int32_t field, wrc_view* view) {
  const Fault cleared = abi::clear(view);
  if (!abi::valid(handle) || view == nullptr) return WRC_ERROR_NULL;
  if (cleared.failed()) return cleared.status;
  if (field < 0 || field > WRC_FIELD_STRIP_FRICTION) return WRC_ERROR_UNSUPPORTED;
  const Contact& contact = *handle->contact;
  if (!gives_fields(contact) && abi::needs_cells(field)) return WRC_ERROR_UNSUPPORTED;
  const bool of_gap = field >= WRC_FIELD_GAP_Y && field <= WRC_FIELD_GAP_CURVATURE;
  const bool of_patch = !of_gap && contact.patches > 0;
  if (of_patch && (patch < 0 || patch >= contact.patches)) return WRC_ERROR_RANGE;
  const abi::Field found = abi::find_field(contact, of_patch ? &contact.patch[patch] : nullptr, field);
  if (found.data == nullptr) return WRC_ERROR_SEQUENCE;
  wrc_view ours{};
  ours.data = found.data;
  const auto elements = static_cast<uint64_t>(found.elements);
  const bool cells = found.cells > 0;
  ours.rank = cells ? 2 : 1;
  ours.count[0] = cells ? static_cast<uint64_t>(found.cells) : elements;
  ours.count[1] = cells ? elements : 1;
  ours.stride[0] = cells ? elements : 1;
  ours.stride[1] = 1;
  abi::give(ours, view);
  return WRC_OK;
}

}  // extern "C"
