#include "contact/contact.hpp"

#include <algorithm>
#include <cmath>
#include <new>

#include "felt.hpp"
#include "geometry/gap_rows.hpp"
#include "normal/analyn.hpp"
#include "normal/damping.hpp"
#include "normal/ekp.hpp"
#include "normal/hertz.hpp"
#include "normal/kik_piotrowski.hpp"
#include "normal/load_search.hpp"
#include "normal/penetration.hpp"
#include "normal/strip_halfspace.hpp"
#include "normal/stripes.hpp"

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

  PressedWheel(const Model& model, Pose pose, const ContactPoint& first_touch) : origin(first_touch) {
    pose.vertical += first_touch.vertical_gap + pressed_depth / first_touch.cosine;
    wheel = posed(model.wheel, pose);
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
  contact.worn = false;
}

/// Where the bodies of a patch first touch: the gap's minimum within it; for strips of the host, which come
/// without a gap, the origin if the patch holds it, and otherwise the strip of the largest peak.
double contact_of(Contact& contact, const Strips& strips, const StripTotals& extent) {
  if (contact.gap_rows > 0) return minimum(gap_rows(contact), extent.y_min, extent.y_max).y;
  if (extent.y_min < 0.0 && extent.y_max > 0.0) return 0.0;
  return strips.y[std::max_element(strips.peak, strips.peak + strips.count) - strips.peak];
}

/// Splits the strips into patches. Those beyond the room the model has are dropped from the tangential stage
/// and flagged; the normal result keeps them.
Fault find_patches(Contact& contact) {
  const Strips strips = all_strips(contact);
  contact.extent = totals(strips);
  contact.patches = 0;
  std::int32_t first = 0;
  while (first < strips.count) {
    const std::int32_t end = patch_end(strips, first);
    if (contact.patches == contact.model->options.max_patches) {
      return {.status = WRC_FLAG_MORE_PATCHES,
              .field = "config.max_patches",
              .value = static_cast<double>(contact.patches),
              .unit = "patches"};
    }
    Patch& patch = contact.patch[contact.patches];
    patch = {};
    patch.first = first;
    patch.count = end - first;
    const Strips own = slice(strips, first, end);
    patch.extent = totals(own);
    patch.y_contact = contact_of(contact, own, patch.extent);
    if (patch.extent.normal_force > contact.patch[contact.main_patch].extent.normal_force) {
      contact.main_patch = contact.patches;
    }
    ++contact.patches;
    first = end;
  }
  return {};
}

Fault sequence(const char* field, const char* cause) {
  return {.status = WRC_ERROR_SEQUENCE, .field = field, .cause = cause};
}

}  // namespace

std::size_t state_bytes(const Model& model) { return model.layout.bytes; }

std::size_t contact_bytes(const Model& model) {
  return state_bytes(model) + std::max(state_bytes(model), model.layout.behind);
}

Contact& make_contact(const Model& model, void* memory) {
  auto* bytes = static_cast<unsigned char*>(memory);
  std::fill_n(bytes, contact_bytes(model), static_cast<unsigned char>(0));  // also touches every page, once
  auto* contact = new (memory) Contact;
  contact->model = &model;
  return *contact;
}

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

Strips all_strips(Contact& contact) { return strips_at(contact, Array::patch_y, contact.strips); }

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
    return sequence(
        "pose", "the model was made without profiles: hand over a gap, or give config.wheel and config.rail");
  }
  std::int32_t found = 0;
  Fault fault = find_contact(model.rail, posed(model.wheel, pose), 1, &contact.point, found);
  if (fault.failed()) return fault;
  if (moved_on && model.options.warm_start) carry_start_over_leap(contact, before);

  const auto [wheel, origin] = PressedWheel(model, pose, contact.point);
  const GapWindow window = gap_window(model.rail, wheel, origin, {model.options.gap_limit, gap_half_width});
  GapRows rows;
  const GapRowMemory memory{model.options.sizes.gap_rows, array(contact, Array::gap_y),
                            array(contact, Array::gap_height), array(contact, Array::gap_centre),
                            array(contact, Array::gap_curvature)};
  worsen(fault, fill_gap_rows(model.rail, wheel, origin, window, memory.capacity, memory,
                              *model.geometry_kernels, rows));
  if (fault.failed()) return fault;
  for (std::int32_t j = 0; j < rows.count; ++j) memory.height[j] += pressed_depth;
  contact.gap_rows = rows.count;
  contact.pose = pose;
  contact.posed = true;
  contact.reached = Stage::gap;
  return fault;
}

SurfaceGap surface_gap(const Contact& contact) {
  const auto [wheel, origin] = PressedWheel(*contact.model, contact.pose, contact.point);
  return {contact.model->rail, wheel, origin};
}

Fault find_creepages(const Contact& contact, const WheelsetMotion& motion, RigidCreepage& rigid) {
  if (!contact.posed)
    return sequence("pose", "call wrc_geometry first: creepages belong to its contact point");
  rigid = creepage(posed(contact.model->wheel, contact.pose), contact.point, motion);
  if (rigid.limited) return {.status = WRC_FLAG_CREEPAGES_LIMITED, .field = "motion"};
  return {};
}

void take_gap(Contact& contact, const GapRows& rows) {
  back_to(contact, Stage::gap);
  contact.posed = false;
  contact.gap_rows = rows.count;
  std::copy_n(rows.y, rows.count, array(contact, Array::gap_y));
  std::copy_n(rows.height, rows.count, array(contact, Array::gap_height));
  if (rows.centre != nullptr) {
    std::transform(rows.centre, rows.centre + rows.count, array(contact, Array::gap_centre), felt);
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

/// The strip half-space solver with its scratch memory, from its last solution where the model asks for that;
/// beyond what the gap carries it is continued as the other methods are.
Fault solve_from_start(Contact& contact, const NormalProblem& problem, Strips& strips) {
  const ModelOptions& options = contact.model->options;
  NormalWorkspace workspace{array(contact, Array::normal_workspace), options.sizes.normal_workspace_bytes};
  StripHalfspaceStart start{options.sizes.strips,
                            options.warm_start ? contact.start_strips : 0,
                            array(contact, Array::start_y),
                            array(contact, Array::start_width),
                            array(contact, Array::start_length_squared),
                            array(contact, Array::start_shift)};
  const auto solve = [&](const NormalProblem& posed) {
    return solve_strip_halfspace(posed, {.max_sweeps = options.max_iterations}, *contact.model->strip_kernel,
                                 workspace, start, strips, contact.normal);
  };
  bool beyond = problem.prescribed == Prescribed::approach && problem.approach > problem.deepest;
  Fault fault;
  if (!beyond) {
    fault = solve(problem);
    beyond = fault.status == WRC_ERROR_LOAD || (!fault.failed() && contact.normal.approach > problem.deepest);
    if (beyond) start.count = 0;  // what is beyond the gap is no start
  }
  if (beyond) {
    NormalProblem end = problem;
    end.prescribed = Prescribed::approach;
    end.approach = std::min(deepest_approach(problem.gap, minimum(problem.gap)), problem.deepest);
    fault = solve(end);
    if (!fault.failed()) fault = continue_beyond(problem, strips, contact.normal);
  }
  contact.start_strips = fault.failed() ? 0 : start.count;
  return fault;
}

/// The smallest approach taken for a contact: a hundredth of an atom. Below, down to the smallest number
/// there is, areas and pressures lose their digits and then vanish.
constexpr double smallest_approach = 1e-12;  // [m]

/// Can a load and a size be read off these strips? Not where the gap is flat to the last bit, or so much more
/// slender than a strip that the strip's own displacement has no digits left, nor where the patch is narrower
/// than an atom, so that the borders of its strips are the same number.
bool carries_load(const StripTotals& patch) {
  constexpr double least_width = 1e-11;  // [m]
  return std::isfinite(patch.normal_force) && std::isfinite(patch.area) && std::isfinite(patch.length) &&
         patch.normal_force > 0.0 && patch.area > 0.0 && patch.y_max - patch.y_min >= least_width;
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
  if (contact.gap_rows == 0) return sequence("gap", "call wrc_geometry first, or hand over a gap");
  back_to(contact, Stage::gap);
  contact.pressed = true;
  contact.load = load;
  if (load.prescribed == Prescribed::approach && load.value < smallest_approach) {
    contact.reached = Stage::patch;
    return {.status = WRC_FLAG_NO_CONTACT, .field = "load.approach"};
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
  problem.kernels = &normal_kernels(options.instruction_set);

  Strips strips = all_strips(contact);
  Fault fault;
  switch (options.normal_method) {
    case NormalMethod::hertz:
      fault = solve_hertz(problem, strips, contact.normal);
      break;
    case NormalMethod::kik_piotrowski:
      fault = solve_kik_piotrowski(problem, {}, strips, contact.normal);
      break;
    case NormalMethod::ekp:
      fault = solve_ekp(problem, {EkpScale::area}, strips, contact.normal);
      break;
    case NormalMethod::ekp_ellipse:
      fault = solve_ekp(problem, {EkpScale::ellipse}, strips, contact.normal);
      break;
    case NormalMethod::analyn:
      fault = solve_analyn(problem, strips, contact.normal);
      break;
    case NormalMethod::stripes:
      fault = solve_stripes(problem, strips, contact.normal);
      break;
    case NormalMethod::strip_halfspace:
      fault = solve_from_start(contact, problem, strips);
      break;
  }
  if (!fault.failed() && strips.count > 0 && !carries_load(totals(strips)))
    fault = {.status = WRC_ERROR_LOAD,
             .field = "gap",
             .cause =
                 "no patch of finite size and pressure: is the gap flat, or far more slender than "
                 "config.strips can resolve?"};
  if (fault.failed()) {
    back_to(contact, Stage::gap);
    return fault;
  }
  // An unfinished search may have ended beside the load: its patch is kept, but carries what was asked for,
  // so that a host's equilibrium does not see the search. The flag tells.
  if (fault.status == WRC_FLAG_ITERATION_CAP && load.prescribed == Prescribed::load) {
    scale_pressure(contact, strips, load.value / contact.normal.normal_force);
  }
  contact.reached = Stage::patch;
  if (load.prescribed == Prescribed::approach && load.damping > 0.0) {
    const double factor = damping_factor(load.approach_velocity, load.damping);
    if (factor < least_damping_factor) {
      back_to(contact, Stage::patch);
      return {.status = WRC_FLAG_NO_CONTACT, .field = "load.approach_velocity"};
    }
    scale_pressure(contact, strips, factor);
    contact.normal.stiffness *= factor;
    contact.damping_factor = factor;
  }
  contact.strips = strips.count;
  contact.touching = strips.count > 0;
  worsen(fault, find_patches(contact));
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
    std::transform(strips.centre, strips.centre + strips.count, ours.centre, felt);
  } else {
    std::fill_n(ours.centre, strips.count, 0.0);
  }
  std::copy_n(strips.half_length, strips.count, ours.half_length);
  std::transform(strips.peak, strips.peak + strips.count, ours.peak, felt);
  const Fault fault = find_patches(contact);
  contact.touching = contact.extent.normal_force > 0.0;
  return contact.touching ? fault : Fault{.status = WRC_FLAG_NO_CONTACT};
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
    return sequence("strips", "there is no patch: call wrc_normal first, or hand over strips");
  }
  if (!contact.touching) return {.status = WRC_FLAG_NO_CONTACT};
  Fault fault;
  for (std::int32_t k = 0; k < contact.patches; ++k) {
    Patch& patch = contact.patch[k];
    worsen(fault,
           regularise(patch.extent, patch.y_contact, contact.model->options.regularisation, patch.sdec));
  }
  return fault;
}

}  // namespace wrc
