/// Tangential stage: rolls the patches one by one, in the frame of each, and adds up their forces.
#include <algorithm>
#include <cmath>

#include "contact/methods.hpp"
#include "contact/stages.hpp"
#include "kernels/kernels.hpp"
#include "tangential/friction/heated_friction.hpp"
#include "tangential/methods/strip_memory.hpp"
#include "tangential/simd/tasks.hpp"

namespace wrc::contact {
namespace {

// Every method rolls along x. Rolling backwards is its mirror image in the plane x = 0: x, vectors along x
// and rotations about y or z change sign, before the solution and after it.

double mirrored(double along_x, double direction) { return direction < 0.0 ? 0.0 - along_x : along_x; }

tangential::Creepage mirrored(const tangential::Creepage& creepage, double direction) {
  return {mirrored(creepage.longitudinal, direction), creepage.lateral, mirrored(creepage.spin, direction)};
}

void mirror(tangential::TangentialForces& forces, double direction) {
  forces.fx = mirrored(forces.fx, direction);
  forces.mz = mirrored(forces.mz, direction);
}

void mirror(tangential::TangentialSensitivities& sensitivities, double direction) {
  // Rows Fx, Fy, Mz; columns longitudinal and lateral creepage, spin, load, friction. A derivative changes
  // sign where one of row and column does.
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 5; ++c) {
      const bool force_changes = r != 1, input_changes = c == 0 || c == 2;
      if (force_changes != input_changes) sensitivities.d[r][c] = mirrored(sensitivities.d[r][c], direction);
    }
  }
}

/// Turns strips and cells of a patch that rolled backwards to the caller's x.
void mirror_region(Contact& contact, const Patch& patch) {
  const patch::Strips region = region_strips(contact, patch);
  for (std::int32_t j = 0; j < region.count; ++j) region.centre[j] = mirrored(region.centre[j], -1.0);
  if (!gives_fields(contact)) return;
  const std::int32_t cells = contact.model->options.sizes.cells * region.count;
  for (const Array which : {Array::traction_x, Array::slip_x}) {
    double* const along_x = cell_block(contact, which, patch);
    for (std::int32_t i = 0; i < cells; ++i) along_x[i] = mirrored(along_x[i], -1.0);
  }
}

/// Fills the region's strips of one patch, about its initial contact point or, of an ellipse that replaces
/// it, about the ellipse's own centre.
void prepare_region(Contact& contact, Patch& patch, const tangential::PatchModel& model, double direction) {
  patch.region_first = patch.first;
  patch.region_count = patch.count;
  patch::Strips region = region_strips(contact, patch);
  // The equivalent ellipse, symmetric about its own centre, in the place of the strips.
  if (model.on_ellipse) {
    const patch::Sdec ellipse{patch.sdec.a, patch.sdec.b, 0.0};
    patch::sdec_strips(ellipse, 0.0, 0.0, patch.extent.normal_force, patch.count, region);
    patch.region_count = region.count;
    return;
  }
  // The patch's own strips, y counted from its contact point.
  const patch::Strips own = patch_strips(contact, patch);
  for (std::int32_t j = 0; j < own.count; ++j) region.y[j] = own.y[j] - patch.y_contact;
  for (std::int32_t j = 0; j < own.count; ++j) region.centre[j] = mirrored(own.centre[j], direction);
  std::copy_n(own.width, own.count, region.width);
  std::copy_n(own.half_length, own.count, region.half_length);
  std::copy_n(own.peak, own.count, region.peak);
}

/// The law's coefficients on the region's strips, whose y is counted from `origin` in the contact frame.
tangential::StripFriction strip_friction(Contact& contact, const Patch& patch, const Friction& friction,
                                         double origin, double direction) {
  // Zones over a profile: y there = y of its contact point + cos(contact angle) times y of the contact frame;
  // profiles on the left are mirror images.
  tangential::FrictionFrame frame{.origin = origin};
  if (friction.zone_frame != ZoneFrame::contact) {
    frame.zone_origin = friction.zone_frame == ZoneFrame::rail ? contact.point.y_rail : contact.point.y_wheel;
    frame.zone_slope = contact.side == geometry::Side::left ? -contact.point.cosine : contact.point.cosine;
  }
  const tangential::SlidingSpeed sliding =
      friction.slope.falls() || contact.model->options.tangential_method->one_sliding_speed
          ? tangential::SlidingSpeed::of_patch
          : tangential::SlidingSpeed::of_strip;
  return tangential::evaluate(friction.law, region_strips(contact, patch), frame,
                              mirrored(contact.creepage, direction), contact.rolling.speed, sliding,
                              array(contact, Array::strip_friction) + patch.region_first);
}

/// Turns the method's strips, whose y is counted from `origin`, to y in the contact frame, and their shares
/// of the mean friction to coefficients.
void show_region(Contact& contact, const Patch& patch, double origin) {
  patch::Strips region = region_strips(contact, patch);
  double* const friction_of_strip = array(contact, Array::strip_friction) + patch.region_first;
  for (std::int32_t j = 0; j < region.count; ++j) {
    friction_of_strip[j] *= patch.friction;
    region.y[j] += origin;
  }
}

/// Solves a patch whose friction falls with the temperature that it makes. The rise of temperature in the
/// contact is work space.
tangential::TangentialForces roll_heated(Contact& contact, const Patch& patch,
                                         const tangential::FrictionLaw& law,
                                         const tangential::TangentialFields& fields,
                                         tangential::RollingContact& rolling, Fault& fault) {
  const ModelOptions& options = contact.model->options;
  const patch::Strips& region = rolling.region;
  constexpr std::int32_t most_strips = 512;
  double cold[most_strips] = {}, share[most_strips] = {};
  double* const shares = array(contact, Array::strip_friction) + patch.region_first;
  for (std::int32_t j = 0; j < region.count; ++j) cold[j] = rolling.friction[j];
  tangential::HeatedFriction heat(law, options.effusivities, options.sizes.cells, contact.rolling.speed);
  tangential::TangentialForces forces;
  // One solution at given shares of the cold coefficients, which solve_heated() repeats until friction and
  // temperature agree.
  const auto solve = [&] {
    for (std::int32_t j = 0; j < region.count; ++j) shares[j] = cold[j] * share[j];
    rolling.friction = tangential::shared_out(region, shares);
    forces = options.tangential_method->solve(rolling, fields, fault, nullptr);
  };
  double* const rise = cell_block(contact, Array::temperature_rise, patch);
  const Fault unsettled = tangential::solve_heated(heat, region, fields, rise, share, solve);
  keep_worst(fault, unsettled);
  return forces;
}

/// The contact's memory of its tractions, for a patch: over the rail's y where a pose is known.
tangential::RollingMemory memory_of(Contact& contact, const Patch& patch, double direction) {
  // y of the rail = origin + slope * y of the patch.
  tangential::RollingMemory memory{.at = array(contact, Array::rolling_memory),
                                   .rolled = contact.rolled,
                                   .at_rest = contact.rolling.speed == 0.0,
                                   .direction = direction};
  if (contact.posed) {
    memory.slope = contact.side == geometry::Side::left ? -contact.point.cosine : contact.point.cosine;
    memory.origin = contact.point.y_rail;
  }
  // borders of the nearest patches on both sides [m]
  const double middle = memory.y(0.5 * (patch.extent.y_min + patch.extent.y_max));
  for (std::int32_t k = 0; k < contact.patches; ++k) {
    const Patch& other = contact.patch[k];
    if (&other == &patch) continue;
    const auto [low, high] = std::minmax({memory.y(other.extent.y_min), memory.y(other.extent.y_max)});
    if (low < middle)
      memory.below = std::max(memory.below, high);
    else
      memory.above = std::min(memory.above, low);
  }
  memory.origin += memory.slope * patch.y_contact;
  return memory;
}

/// A model that remembers rolls one way in a step, and its friction is not solved for.
Fault check_memory(const Contact& contact, const Friction& friction, const Rolling& rolling) {
  if (!contact.model->options.non_steady) return {};
  if (friction.law.heated()) {
    return Fault::unsupported(
        "friction.temperature_law",
        "config.planar.non_steady rolls on once a step, friction over temperature would several times");
  }
  if (friction.layer.present()) {
    return Fault::unsupported("friction.layer_thickness, layer_yield",
                              "config.planar.non_steady remembers tractions, not how far a layer has flowed");
  }
  if (rolling.reverse_share == 0.0) return {};
  return Fault::unsupported("creepage.reverse_share", {rolling.reverse_share, ""},
                            "config.planar.non_steady rolls one way in a step, or rests");
}

/// One patch, rolling along x times `direction`. `sensitivities`: see solve_tangential().
Fault roll(Contact& contact, Patch& patch, const Friction& friction, double direction,
           tangential::TangentialSensitivities* sensitivities) {
  const Model& model = *contact.model;
  const TangentialMethod& method = *model.options.tangential_method;
  const tangential::PatchModel& shape = model.options.patch_model;
  prepare_region(contact, patch, shape, direction);

  // Shape and stiffness of the patch; a layer between the bodies acts as a lower shear modulus.
  tangential::RollingContact rolling;
  rolling.region = region_strips(contact, patch);
  rolling.a = patch.sdec.a;
  rolling.b = patch.sdec.b;
  rolling.shape_number = patch.sdec.psi;
  rolling.shear_modulus = model.options.material.shear_modulus * friction.slope_reduction;
  rolling.linear_theory = &model.linear_theory;
  rolling.grid = &model.march_grid;
  rolling.model = shape;
  // The methods refer everything to the patch's initial contact point, which is not the origin of the contact
  // frame for a second patch, or for a gap of the host; and on an ellipse about mid-width to its centre.
  const double centre = shape.at_middle ? patch.sdec.psi * patch.sdec.b : 0.0;
  rolling.creepage = tangential::seen_from(patch.y_contact, mirrored(contact.creepage, direction));
  if (shape.at_middle) rolling.creepage = tangential::seen_from(centre, rolling.creepage);
  rolling.friction = strip_friction(contact, patch, friction, patch.y_contact + centre, direction);

  // Law of the method, its tables and its memory.
  rolling.bound = model.options.traction_bound;
  rolling.form = model.options.flexibility;
  rolling.slope = friction.slope;
  rolling.slope_reduction = friction.slope_reduction;
  rolling.layer = friction.layer;
  rolling.reduction = friction.reduction;
  rolling.normal_force = patch.extent.normal_force;
  rolling.force_table = &model.force_table;
  rolling.workspace = work_space(contact);
  if (model.options.non_steady) rolling.memory = memory_of(contact, patch, direction);

  // Forces [N], [N m] about the method's origin, and cell fields unless derivatives are asked for.
  const tangential::TangentialFields fields =
      sensitivities ? tangential::TangentialFields{} : cell_fields(contact, patch);
  Fault fault;
  patch.forces = friction.law.heated() ? roll_heated(contact, patch, friction.law, fields, rolling, fault)
                 : model.options.non_steady ? tangential::roll_with_memory(rolling, fields, fault)
                                            : method.solve(rolling, fields, fault, sensitivities);
  // A difference of sums of areas: rounding may leave it just outside 0..1.
  patch.forces.adhesion_fraction = std::clamp(patch.forces.adhesion_fraction, 0.0, 1.0);
  // Back to the origin of the contact frame, in the order reverse to the way in.
  if (shape.at_middle) tangential::refer_back(centre, patch.forces, sensitivities);
  tangential::refer_back(patch.y_contact, patch.forces, sensitivities);

  patch.friction = rolling.friction.mean;
  show_region(contact, patch, patch.y_contact + centre);
  if (direction > 0.0) return fault;
  mirror(patch.forces, direction);
  mirror_region(contact, patch);
  if (sensitivities) mirror(*sensitivities, direction);
  return fault;
}

/// One patch near standstill: forces F = (1 - r) F_forwards + r F_backwards, r the reverse share, so that
/// they pass continuously through standstill. Its fields are those of `direction` alone, which is solved
/// last.
Fault roll_both_directions(Contact& contact, Patch& patch, const Friction& friction,
                           tangential::TangentialSensitivities* sensitivities) {
  // The reverse direction first: its fields are overwritten.
  const Rolling& rolling = contact.rolling;
  tangential::TangentialSensitivities others;
  Fault fault = roll(contact, patch, friction, -rolling.direction, sensitivities ? &others : nullptr);
  const tangential::TangentialForces other = patch.forces;
  keep_worst(fault, roll(contact, patch, friction, rolling.direction, sensitivities));
  const auto blend = [&](double& own, double of_other) {
    own = (1.0 - rolling.reverse_share) * own + rolling.reverse_share * of_other;
  };
  blend(patch.forces.fx, other.fx);
  blend(patch.forces.fy, other.fy);
  blend(patch.forces.mz, other.mz);
  blend(patch.forces.power_per_speed, other.power_per_speed);
  blend(patch.forces.adhesion_fraction, other.adhesion_fraction);
  if (!sensitivities) return fault;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 5; ++c) blend(sensitivities->d[r][c], others.d[r][c]);
  }
  return fault;
}

/// Adds up the patches; the share that sticks is weighted by area.
tangential::TangentialForces sum_of_patches(const Contact& contact) {
  // Forces add; moments are about one origin; the adhering area over the whole area [-].
  tangential::TangentialForces sum;
  double area = 0.0;
  for (std::int32_t k = 0; k < contact.patches; ++k) {
    const Patch& patch = contact.patch[k];
    sum.fx += patch.forces.fx;
    sum.fy += patch.forces.fy;
    sum.mz += patch.forces.mz;
    sum.power_per_speed += patch.forces.power_per_speed;
    sum.adhesion_fraction += patch.forces.adhesion_fraction * patch.extent.area;
    area += patch.extent.area;
  }
  sum.adhesion_fraction /= area;
  return sum;
}

}  // namespace

bool differentiates(const Contact& contact) {
  const ModelOptions& options = contact.model->options;
  const Friction& friction = contact.law;
  return options.tangential_method->gives_derivatives &&
         options.flexibility == tangential::FlexibilityForm::separate && !friction.law.falls() &&
         !friction.slope.falls();
}

Friction friction_of(const Contact& contact) {
  Friction friction = contact.law;
  if (friction.law.zones.count > 0) {
    friction.law.zones.y = contact.zone_y;
    friction.law.zones.coefficient = contact.zone_coefficient;
  }
  return friction;
}

void find_cells(Contact& contact) {
  if (contact.model->options.non_steady || !gives_fields(contact) || cells_known(contact) > 0.0) return;
  cells_known(contact) = 1.0;
  const Friction friction = friction_of(contact);
  for (std::int32_t k = 0; k < contact.patches; ++k) {
    // those of the own direction, as roll_both_directions() leaves them; forces stay
    Patch again = contact.patch[k];
    roll(contact, again, friction, contact.rolling.direction, nullptr);
  }
}

Fault solve_tangential(Contact& contact, const tangential::Creepage& creepage, const Friction& friction,
                       const Rolling& rolling, tangential::TangentialSensitivities* sensitivities) {
  if (contact.reached < Stage::patch) {
    return Fault::sequence("patch",
                           "there is no patch: call wrc_planar_normal first, or hand over strips or a patch");
  }
  if (friction.zone_frame != ZoneFrame::contact && !contact.posed) {
    return Fault::sequence("friction.zone_frame",
                           "zones over a profile need the contact point of a wrc_planar_geometry");
  }
  if (const Fault fault = check_memory(contact, friction, rolling); fault.failed()) return fault;

  // The inputs are kept: damage, derivatives and regions ask for them.
  contact.reached = Stage::tangential;
  contact.newest = Solution::stages;
  contact.creepage = creepage;
  contact.friction = friction.law.coefficient;
  contact.rolling = rolling;
  contact.forces = {};
  contact.damage = {};
  cells_known(contact) = sensitivities ? 0.0 : 1.0;

  // A model that remembers goes on by a step even where the bodies are apart: memory of patches without
  // contact is lost.
  void* const memory = contact.model->options.non_steady ? array(contact, Array::rolling_memory) : nullptr;
  if (memory) tangential::begin_step(memory);
  if (!contact.touching) {
    if (memory) tangential::end_step(memory);
    contact.rolled = 0.0;
    return Fault::no_contact();
  }

  // The law is kept without the caller's arrays: zones are copied, so that a saved state has no pointers.
  Fault fault;
  contact.law = friction;
  contact.law.law.zones.y = contact.law.law.zones.coefficient = nullptr;
  if (friction.law.zones.count > 0) {
    std::copy_n(friction.law.zones.y, friction.law.zones.count, contact.zone_y);
    std::copy_n(friction.law.zones.coefficient, friction.law.zones.count, contact.zone_coefficient);
  }

  // Patch by patch: forces, derivatives, and limit = sum of mu N, load = sum of N [N] for the mean friction.
  if (sensitivities) *sensitivities = {};
  double limit = 0.0, load = 0.0;
  for (std::int32_t k = 0; k < contact.patches; ++k) {
    Patch& patch = contact.patch[k];
    tangential::TangentialSensitivities own;
    tangential::TangentialSensitivities* const wanted = sensitivities ? &own : nullptr;
    keep_worst(fault, rolling.reverse_share > 0.0
                          ? roll_both_directions(contact, patch, friction, wanted)
                          : roll(contact, patch, friction, rolling.direction, wanted));
    limit += patch.friction * patch.extent.normal_force;
    load += patch.extent.normal_force;
    if (!sensitivities) continue;
    // The patches' loads grow in proportion to the whole: dN_k / dN = N_k / N, in the column of the load.
    const double share = patch.extent.normal_force / contact.extent.normal_force;
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 5; ++c) sensitivities->d[r][c] += own.d[r][c] * (c == 3 ? share : 1.0);
    }
  }
  if (memory) tangential::end_step(memory);
  contact.rolled = 0.0;
  contact.friction = load > 0.0 ? limit / load : 0.0;
  contact.forces = sum_of_patches(contact);
  if (rolling.reverse_share > 0.0) {
    keep_worst(fault, Fault::creepages_limited("creepage.reverse_share", {rolling.reverse_share, ""}));
  }
  return fault;
}

}  // namespace wrc::contact
