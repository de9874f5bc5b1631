#include "contact/contact.hpp"

#include <algorithm>
#include <cmath>
#include <new>

#include "base/flush_subnormals.hpp"
#include "contact/methods.hpp"
#include "geometry/gap_rows.hpp"
#include "normal/damping.hpp"
#include "tangential/methods/strip_memory.hpp"

namespace wrc {
namespace {

std::size_t offset(const Contact& contact, Array which) {
  return contact.model->layout.offset[static_cast<std::size_t>(which)];
}

/// How far from the contact point the gap is looked at: the widest patch of two rails' heads, tread and
/// flange root.
constexpr double gap_half_width = 0.030;  // [m]

/// How deep the wheel stands in the rail when the gap is taken [m]: a usual approach. Pressed down
/// vertically, a wheel slides along an inclined contact plane by approach * tan(angle); near the flange a gap
/// taken at first touch is tilted by that, which costs 1 % of the approach. Half of the effect remains where
/// the approach is half of this, or twice.
constexpr double pressed_depth = 80e-6;

/// The wheel where its gap is taken, lowered to first touch and pressed_depth further, and the contact point
/// as the origin of that gap: the wheel is down already.
struct PressedWheel {
  PosedWheel wheel;
  ContactPoint origin;

  PressedWheel(const Wheel& placed, Pose pose, const ContactPoint& first_touch) : origin(first_touch) {
    pose.vertical += first_touch.vertical_gap + pressed_depth / first_touch.cosine;
    wheel = posed(placed, pose);
    origin.vertical_gap = 0.0;
  }
};

/// The strips whose five arrays begin with `first`.
Strips strips_at(Contact& contact, Array first, std::int32_t count) {
  const auto member = [&](int i) { return array(contact, static_cast<Array>(static_cast<int>(first) + i)); };
  return {contact.model->options.sizes.strips, count, member(0), member(1), member(2), member(3), member(4)};
}

/// Forgets the results of every stage after `stage`.
void back_to(Contact& contact, Stage stage) {
  contact.reached = stage;
  contact.newest = Solution::stages;
  contact.touching = false;
  contact.pressed = false;
  contact.strips = 0;
  contact.patches = 0;
  contact.main_patch = 0;
  contact.normal = {};
  contact.damping_factor = 1.0;
  contact.extent = {};
  contact.forces = {};
  contact.damage = {};
}

/// Where the bodies of a patch first touch: the gap's minimum within it; for strips of the host, which come
/// without a gap, the origin if the patch holds it, and otherwise the strip of the largest peak.
double contact_of(Contact& contact, const Strips& strips, const StripTotals& extent) {
  if (contact.gap_rows > 0) return minimum(gap_rows(contact), extent.y_min, extent.y_max).y;
  if (extent.y_min < 0.0 && extent.y_max > 0.0) return 0.0;
  return strips.y[std::max_element(strips.peak, strips.peak + strips.count) - strips.peak];
}

/// A patch narrower than this [m] counts as none: far below the size of an atom the borders of its strips may
/// be the same number.
constexpr double least_patch_width = 1e-11;

/// Splits the strips into patches. Those beyond the room the model has are dropped from the tangential stage
/// and flagged; the normal result keeps them. So are those without a width, which carry next to nothing.
Fault find_patches(Contact& contact) {
  const Strips strips = all_strips(contact);
  contact.extent = totals(strips);
  contact.patches = 0;
  std::int32_t first = 0;
  while (first < strips.count) {
    const std::int32_t end = patch_end(strips, first);
    const Strips own = slice(strips, first, end);
    const StripTotals extent = totals(own);
    if (extent.y_max - extent.y_min < least_patch_width) {
      first = end;
      continue;
    }
    if (contact.patches == contact.model->options.max_patches) {
      return Fault::more_patches("config.planar.max_patches", {contact.patches, "patches"});
    }
    Patch& patch = contact.patch[contact.patches];
    patch = {};
    patch.first = first;
    patch.count = end - first;
    patch.extent = extent;
    patch.y_contact = contact_of(contact, own, patch.extent);
    if (patch.extent.normal_force > contact.patch[contact.main_patch].extent.normal_force) {
      contact.main_patch = contact.patches;
    }
    ++contact.patches;
    first = end;
  }
  return {};
}

}  // namespace

std::size_t state_bytes(const Model& model) { return model.layout.bytes; }

std::size_t contact_bytes(const Model& model) {
  return state_bytes(model) + std::max(state_bytes(model), model.layout.behind);
}

Contact& make_contact(const Model& model, Side side, void* memory) {
  auto* bytes = static_cast<unsigned char*>(memory);
  std::fill_n(bytes, contact_bytes(model), static_cast<unsigned char>(0));  // also touches every page, once
  auto* contact = new (memory) Contact;
  contact->model = &model;
  contact->side = side;
  if (model.options.non_steady)
    make_strip_memory(model.options.sizes.strips, array(*contact, Array::rolling_memory));
  return *contact;
}

const Bodies& bodies(const Contact& contact) { return contact.model->bodies[static_cast<int>(contact.side)]; }

double* array(Contact& contact, Array which) {
  return reinterpret_cast<double*>(reinterpret_cast<char*>(&contact) + offset(contact, which));
}

const double* array(const Contact& contact, Array which) {
  return reinterpret_cast<const double*>(reinterpret_cast<const char*>(&contact) + offset(contact, which));
}

GapRows gap_rows(const Contact& contact) {
  return {contact.gap_rows, array(contact, Array::gap_y), array(contact, Array::gap_height),
          array(contact, Array::gap_centre), array(contact, Array::gap_curvature)};
}

Strips all_strips(Contact& contact) { return strips_at(contact, Array::strip_y, contact.strips); }

Strips patch_strips(Contact& contact, const Patch& patch) {
  return slice(all_strips(contact), patch.first, patch.first + patch.count);
}

Strips region_strips(Contact& contact, const Patch& patch) {
  const Strips all = strips_at(contact, Array::region_y, contact.model->options.sizes.strips);
  return slice(all, patch.region_first, patch.region_first + patch.region_count);
}

double* cell_block(Contact& contact, Array which, const Patch& patch) {
  return array(contact, which) + patch.region_first * contact.model->options.sizes.cells;
}

TangentialFields cell_fields(Contact& contact, const Patch& patch) {
  return {cell_block(contact, Array::traction_x, patch), cell_block(contact, Array::traction_y, patch),
          cell_block(contact, Array::slip_x, patch), cell_block(contact, Array::slip_y, patch)};
}

double* work_space(Contact& contact) { return array(contact, Array::surface_workspace); }

// ----------------------------------------------------------------------------------------------------------
// gap

namespace {

/// Where the first touch leaps across the tread or to the flange, the patch stays behind: its last solution,
/// from which the next normal solve may start, is taken over from the frame of the contact point `before`
/// into the present one. What the frames are turned against each other does not matter for a start. A contact
/// point that merely moves takes its patch along.
void carry_start_over_leap(Contact& contact, const ContactPoint& before) {
  if (contact.start_strips == 0) return;
  constexpr double leap = 0.25;  // of the patch's width
  const ContactPoint& now = contact.point;
  const double moved = now.cosine * (now.y - before.y) + now.sine * (now.z - before.z);
  double* const y = array(contact, Array::start_y);
  if (std::abs(moved) < leap * (y[contact.start_strips - 1] - y[0])) return;
  for (std::int32_t j = 0; j < contact.start_strips; ++j) y[j] -= moved;
}

}  // namespace

Fault find_gap(Contact& contact, const Pose& pose) {
  back_to(contact, Stage::none);
  contact.gap_rows = 0;
  const bool moved_on = contact.posed;
  const ContactPoint before = contact.point;
  contact.posed = false;
  const Model& model = *contact.model;
  if (!model.has_geometry) {
    return Fault::sequence(
        "pose", "the model was made without profiles: hand over a gap, or give config.wheel and config.rail");
  }
  std::int32_t found = 0;
  const auto& [placed, rail] = bodies(contact);
  Fault fault = find_contact(rail, posed(placed, pose), 1, &contact.point, found);
  if (fault.failed()) return fault;
  if (moved_on && model.options.warm_start) carry_start_over_leap(contact, before);

  const auto [wheel, origin] = PressedWheel(placed, pose, contact.point);
  const GapWindow window = gap_window(rail, wheel, origin, {model.options.gap_limit, gap_half_width});
  GapRows rows;
  const GapRowMemory memory{model.options.sizes.gap_rows, array(contact, Array::gap_y),
                            array(contact, Array::gap_height), array(contact, Array::gap_centre),
                            array(contact, Array::gap_curvature)};
  keep_worst(fault,
             fill_gap_rows(rail, wheel, origin, window, memory.capacity, memory, *model.kernels, rows));
  if (fault.failed()) return fault;
  for (std::int32_t j = 0; j < rows.count; ++j) memory.height[j] += pressed_depth;
  contact.gap_rows = rows.count;
  contact.pose = pose;
  contact.posed = true;
  contact.reached = Stage::gap;
  return fault;
}

SurfaceGap surface_gap(const Contact& contact) {
  const auto [wheel, origin] = PressedWheel(bodies(contact).wheel, contact.pose, contact.point);
  return {bodies(contact).rail, wheel, origin};
}

Fault find_creepages(const Contact& contact, const WheelsetMotion& motion, RigidCreepage& rigid) {
  if (!contact.posed)
    return Fault::sequence("pose", "call wrc_planar_geometry first: creepages belong to its contact point");
  rigid = creepage(posed(bodies(contact).wheel, contact.pose), contact.point, motion);
  if (rigid.limited) return Fault::creepages_limited("motion");
  return {};
}

void take_gap(Contact& contact, const GapRows& rows) {
  back_to(contact, Stage::gap);
  contact.posed = false;
  contact.gap_rows = rows.count;
  std::copy_n(rows.y, rows.count, array(contact, Array::gap_y));
  std::copy_n(rows.height, rows.count, array(contact, Array::gap_height));
  if (rows.centre != nullptr) {
    std::transform(rows.centre, rows.centre + rows.count, array(contact, Array::gap_centre),
                   flush_subnormals);
  } else {
    std::fill_n(array(contact, Array::gap_centre), rows.count, 0.0);
  }
  std::copy_n(rows.curvature, rows.count, array(contact, Array::gap_curvature));
}

Fault take_gap(Contact& contact, const GapGrid& grid) {
  back_to(contact, Stage::none);
  contact.posed = false;
  contact.gap_rows = 0;
  // Rows are needed accurately where they may touch; a quarter of the depth that matters leaves the rest out
  // of the fit.
  const Fault fault =
      rows_from_grid(grid, 0.25 * contact.model->options.gap_limit, array(contact, Array::gap_height),
                     array(contact, Array::gap_centre), array(contact, Array::gap_curvature));
  if (fault.failed()) return fault;
  std::copy_n(grid.y, grid.rows, array(contact, Array::gap_y));
  contact.gap_rows = grid.rows;
  contact.reached = Stage::gap;
  return fault;
}

// -------------------------------------------------------------------------------------------------------
// normal

namespace {

/// The smallest approach taken for a contact [m]. Below, down to the smallest number there is, areas and
/// pressures lose their digits and then vanish.
constexpr double smallest_approach = 1e-12;

/// Can a load and a size be read off these strips? Not where the gap is flat to the last bit, or so much more
/// slender than a strip that the strip's own displacement has no digits left, nor where every patch is
/// narrower than least_patch_width.
bool carries_load(const Strips& strips) {
  const StripTotals sum = totals(strips);
  if (!(std::isfinite(sum.normal_force) && std::isfinite(sum.area) && std::isfinite(sum.length) &&
        sum.normal_force > 0.0 && sum.area > 0.0))
    return false;
  for (std::int32_t first = 0; first < strips.count; first = patch_end(strips, first)) {
    const StripTotals patch = totals(slice(strips, first, patch_end(strips, first)));
    if (patch.y_max - patch.y_min >= least_patch_width) return true;
  }
  return false;
}

/// The same patch under `share` times the pressure.
void scale_pressure(Contact& contact, Strips& strips, double share) {
  for (std::int32_t j = 0; j < strips.count; ++j) strips.peak[j] *= share;
  contact.normal.normal_force *= share;
  contact.normal.peak_pressure *= share;
}

/// A pressure is taken for none below this share of the elastic one: far beneath any force that counts, and
/// far above where the numbers lose their digits.
constexpr double least_damping_factor = 1e-9;

}  // namespace

Fault solve_normal(Contact& contact, const Load& load) {
  if (contact.gap_rows == 0)
    return Fault::sequence("gap", "call wrc_planar_geometry first, or hand over a gap");
  back_to(contact, Stage::gap);
  contact.pressed = true;
  if (load.prescribed == Prescribed::approach && load.value < smallest_approach) {
    contact.reached = Stage::patch;
    return Fault::no_contact("load.approach");
  }
  const ModelOptions& options = contact.model->options;
  NormalProblem problem;
  problem.gap = gap_rows(contact);
  problem.material = options.material;
  problem.prescribed = load.prescribed;
  (load.prescribed == Prescribed::load ? problem.normal_force : problem.approach) = load.value;
  // Rows of a pose are looked for up to the limit; how far the last lie above it is chance.
  if (contact.posed) problem.deepest = options.gap_limit;
  problem.strips = options.sizes.strips;
  problem.max_iterations = options.max_iterations;
  problem.force_tolerance = options.load_tolerance;
  problem.kernels = contact.model->kernels;

  Strips strips = all_strips(contact);
  Fault fault = options.normal_method->planar ? options.normal_method->planar(problem, strips, contact.normal)
                                              : options.normal_method->solve(contact, problem, strips);
  if (!fault.failed() && strips.count > 0 && !carries_load(strips))
    fault = Fault::load("gap",
                        "no patch of finite size and pressure: is the gap flat, or far more slender than "
                        "config.planar.strips can resolve?");
  if (fault.failed()) {
    back_to(contact, Stage::gap);
    return fault;
  }
  // An unfinished search may have ended beside the load: its patch is kept, but carries what was asked for,
  // so that a host's equilibrium does not depend on the search; the flag reports it.
  if (fault.status == WRC_FLAG_ITERATION_CAP && load.prescribed == Prescribed::load) {
    scale_pressure(contact, strips, load.value / contact.normal.normal_force);
  }
  contact.reached = Stage::patch;
  if (load.prescribed == Prescribed::approach && load.damping > 0.0) {
    const double factor = damping_factor(load.approach_velocity, load.damping);
    if (factor < least_damping_factor) {
      back_to(contact, Stage::patch);
      return Fault::no_contact("load.approach_velocity");
    }
    scale_pressure(contact, strips, factor);
    contact.normal.stiffness *= factor;
    contact.damping_factor = factor;
  }
  contact.strips = strips.count;
  contact.touching = strips.count > 0;
  keep_worst(fault, find_patches(contact));
  return fault;
}

Fault take_strips(Contact& contact, const Strips& strips) {
  back_to(contact, Stage::patch);
  contact.posed = false;
  contact.gap_rows = 0;
  contact.strips = strips.count;
  const Strips ours = all_strips(contact);
  std::copy_n(strips.y, strips.count, ours.y);
  std::copy_n(strips.width, strips.count, ours.width);
  if (strips.centre != nullptr) {
    std::transform(strips.centre, strips.centre + strips.count, ours.centre, flush_subnormals);
  } else {
    std::fill_n(ours.centre, strips.count, 0.0);
  }
  std::copy_n(strips.half_length, strips.count, ours.half_length);
  std::transform(strips.peak, strips.peak + strips.count, ours.peak, flush_subnormals);
  const Fault fault = find_patches(contact);
  contact.touching = contact.extent.normal_force > 0.0;
  return contact.touching ? fault : Fault::no_contact();
}

Fault take_double_ellipse(Contact& contact, const Sdec& sdec, double normal_force) {
  back_to(contact, Stage::patch);
  contact.posed = false;
  contact.gap_rows = 0;
  Strips strips = all_strips(contact);
  sdec_strips(sdec, 0.0, 0.0, normal_force, contact.model->options.sizes.strips, strips);
  contact.strips = strips.count;
  contact.touching = true;
  contact.extent = totals(strips);
  contact.extent.area = pi * sdec.a * sdec.b;  // exactly, where the strips converge to it
  contact.extent.normal_force = normal_force;
  contact.extent.peak_pressure = peak_pressure(sdec, normal_force);
  contact.extent.length = 2.0 * sdec.a;
  contact.patches = 1;
  contact.patch[0] = {};
  contact.patch[0].count = strips.count;
  contact.patch[0].extent = contact.extent;
  contact.patch[0].sdec = sdec;
  return {};
}

Fault regularise_patch(Contact& contact) {
  if (contact.reached < Stage::patch) {
    return Fault::sequence("strips", "there is no patch: call wrc_planar_normal first, or hand over strips");
  }
  if (!contact.touching) return Fault::no_contact();
  Fault fault;
  for (std::int32_t k = 0; k < contact.patches; ++k) {
    Patch& patch = contact.patch[k];
    keep_worst(fault,
               regularise(patch.extent, patch.y_contact, contact.model->options.regularisation, patch.sdec));
  }
  return fault;
}

}  // namespace wrc
