/// The tangential and damage stages: which region a variant works on, and the frames around it.
#include <algorithm>
#include <cmath>

#include "contact/contact.hpp"
#include "damage/fatigue.hpp"
#include "damage/frictional_power.hpp"
#include "tangential/fastsim.hpp"
#include "tangential/fastsim_eqe.hpp"
#include "tangential/fastsim_eql.hpp"
#include "tangential/fastsim_sdec.hpp"
#include "tangential/strip_fastsim.hpp"

namespace wrc {
namespace {

/// Does the variant replace the patch by its equivalent ellipse?
bool works_on_ellipse(TangentialMethod method) {
  return method == TangentialMethod::fastsim || method == TangentialMethod::fastsim_eqe;
}

/// Fills the region's strips of one patch, in the frame the variant wants them: about the patch's initial
/// contact point, or about the ellipse's own centre.
void prepare_region(Contact& contact, Patch& patch, TangentialMethod method) {
  patch.region_first = patch.first;
  patch.region_count = patch.count;
  Strips region = region_strips(contact, patch);
  if (works_on_ellipse(method)) {
    const Sdec ellipse{patch.sdec.a, patch.sdec.b, 0.0};
    sdec_strips(ellipse, 0.0, 0.0, patch.extent.normal_force, patch.count, region);
    patch.region_count = region.count;
    return;
  }
  const Strips own = patch_strips(contact, patch);
  for (std::int32_t j = 0; j < own.count; ++j) region.y[j] = own.y[j] - patch.y_contact;
  std::copy_n(own.width, own.count, region.width);
  std::copy_n(own.centre, own.count, region.centre);
  std::copy_n(own.half_length, own.count, region.half_length);
  std::copy_n(own.peak, own.count, region.peak);
}

/// x and normal pressure of every cell of a patch.
void fill_cells(Contact& contact, const Patch& patch) {
  const Strips region = region_strips(contact, patch);
  const std::int32_t cells = contact.model->options.sizes.cells;
  double* x = cell_block(contact, Array::cell_x, patch);
  double* pressure = cell_block(contact, Array::pressure, patch);
  for (std::int32_t i = 0; i < cells; ++i) {
    const double s = 1.0 - (2.0 * i + 1.0) / cells;
    const double shape = std::sqrt(1.0 - s * s);
    for (std::int32_t j = 0; j < region.count; ++j) {
      const std::int32_t at = i * region.count + j;
      x[at] = region.centre[j] + s * region.half_length[j];
      pressure[at] = shape * region.peak[j];
    }
  }
}

TangentialFields cell_fields(Contact& contact, const Patch& patch) {
  return {cell_block(contact, Array::traction_x, patch), cell_block(contact, Array::traction_y, patch),
          cell_block(contact, Array::slip_x, patch), cell_block(contact, Array::slip_y, patch)};
}

/// One patch. The variants refer everything to the patch's initial contact point, which is not the origin of
/// the contact frame for a second patch, or for a gap of the host: nu_x there is nu_x - phi y_contact, and
/// M_z comes back by - y_contact F_x.
Fault roll(Contact& contact, Patch& patch, TangentialSensitivities* sensitivities) {
  const Model& model = *contact.model;
  const TangentialMethod method = model.options.tangential_method;
  prepare_region(contact, patch, method);
  RollingContact rolling;
  rolling.region = region_strips(contact, patch);
  rolling.a = patch.sdec.a;
  rolling.b = patch.sdec.b;
  rolling.shape_number = patch.sdec.psi;
  rolling.shear_modulus = model.options.material.shear_modulus;
  rolling.linear_theory = &model.linear_theory;
  rolling.grid = &model.march_grid;
  rolling.creepage = contact.creepage;
  rolling.creepage.longitudinal -= contact.creepage.spin * patch.y_contact;
  rolling.friction = contact.friction;
  rolling.bound = model.options.traction_bound;
  const TangentialFields fields = sensitivities ? TangentialFields{} : cell_fields(contact, patch);
  Fault fault;
  switch (method) {
    case TangentialMethod::fastsim:
      patch.forces = fastsim(rolling, fields, fault, sensitivities);
      break;
    case TangentialMethod::fastsim_eqe:
      patch.forces = fastsim_eqe(rolling, fields, fault, sensitivities);
      break;
    case TangentialMethod::fastsim_eql:
      patch.forces = fastsim_eql(rolling, fields, fault, sensitivities);
      break;
    case TangentialMethod::fastsim_sdec:
      patch.forces = fastsim_sdec(rolling, fields, fault, sensitivities);
      break;
    case TangentialMethod::strip_fastsim:
      patch.forces = strip_fastsim(rolling, fields, fault, sensitivities);
      break;
  }
  patch.forces.mz -= patch.y_contact * patch.forces.fx;
  if (sensitivities) refer_to(patch.y_contact, *sensitivities);

  const double centre = method == TangentialMethod::fastsim_eqe ? patch.sdec.psi * patch.sdec.b : 0.0;
  Strips region = region_strips(contact, patch);
  for (std::int32_t j = 0; j < region.count; ++j) region.y[j] += patch.y_contact + centre;
  fill_cells(contact, patch);
  return fault;
}

/// Adds up the patches; the share that sticks is weighted by area.
TangentialForces sum_of_patches(const Contact& contact) {
  TangentialForces sum;
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

Fault solve_tangential(Contact& contact, const Creepage& creepage, double friction, double speed,
                       TangentialSensitivities* sensitivities) {
  if (contact.reached < Stage::patch) {
    return {.status = WRC_ERROR_SEQUENCE,
            .field = "patch",
            .cause = "there is no patch: call wrc_normal first, or hand over strips or a patch"};
  }
  contact.reached = Stage::tangential;
  contact.creepage = creepage;
  contact.friction = friction;
  contact.speed = speed;
  contact.forces = {};
  contact.damage = {};
  contact.worn = false;
  if (!contact.touching) return {.status = WRC_FLAG_NO_CONTACT};
  Fault fault;
  if (sensitivities) *sensitivities = {};
  for (std::int32_t k = 0; k < contact.patches; ++k) {
    TangentialSensitivities own;
    worsen(fault, roll(contact, contact.patch[k], sensitivities ? &own : nullptr));
    if (!sensitivities) continue;
    // The loads of the patches grow in proportion.
    const double share = contact.patch[k].extent.normal_force / contact.extent.normal_force;
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 5; ++c) sensitivities->d[r][c] += own.d[r][c] * (c == 3 ? share : 1.0);
    }
  }
  contact.forces = sum_of_patches(contact);
  return fault;
}

Fault assess_damage(Contact& contact) {
  if (contact.reached < Stage::tangential) {
    return {.status = WRC_ERROR_SEQUENCE, .field = "forces", .cause = "call wrc_tangential first"};
  }
  contact.reached = Stage::damage;
  if (!contact.touching) return {.status = WRC_FLAG_NO_CONTACT};
  const ModelOptions& options = contact.model->options;
  const std::int32_t cells = options.sizes.cells;
  DamageNumbers& damage = contact.damage;
  damage = {};
  for (std::int32_t k = 0; k < contact.patches; ++k) {
    const Patch& patch = contact.patch[k];
    const Strips region = region_strips(contact, patch);
    const TangentialFields fields = cell_fields(contact, patch);
    double* density = cell_block(contact, Array::power_density, patch);
    double* per_width = array(contact, Array::strip_power) + patch.region_first;
    double* local_index = cell_block(contact, Array::fatigue_index, patch);
    frictional_power_density(fields, region.count, cells, contact.speed, density);
    frictional_power_per_width(density, region, cells, per_width);
    local_fatigue_index(fields, region, cells, options.shear_yield, local_index);
    damage.power += frictional_power(per_width, region);
    const double densest = *std::max_element(density, density + cells * region.count);
    damage.peak_power_density = std::max(damage.peak_power_density, densest);
    const double worst_cell = *std::max_element(local_index, local_index + cells * region.count);

    // Variants that spread the load over the equivalent ellipse have that ellipse's peak pressure.
    const bool on_ellipse = works_on_ellipse(options.tangential_method);
    const double peak = on_ellipse
                            ? peak_pressure({patch.sdec.a, patch.sdec.b, 0.0}, patch.extent.normal_force)
                            : patch.extent.peak_pressure;
    const ShakedownPoint point =
        shakedown_point(patch.forces, patch.extent.normal_force, peak, options.shear_yield);
    const double index = fatigue_index(point);
    if (k == 0 || worst_cell > damage.local_fatigue_index) damage.local_fatigue_index = worst_cell;
    if (k == 0 || index > damage.fatigue_index) {  // the patch nearest to damage speaks for the contact
      damage.fatigue_index = index;
      damage.utilisation = point.utilised_friction;
      damage.load_factor = point.load_factor;
      damage.shakedown_limit = shakedown_limit(point.utilised_friction);
    }
  }
  damage.t_gamma = t_gamma(contact.forces);
  damage.t_gamma_no_spin = t_gamma_without_spin(contact.forces, contact.creepage);
  return {};
}

Fault assess_wear(Contact& contact, const WearLaws& laws, WearNumbers& wear) {
  wear = {};
  if (contact.reached < Stage::tangential) {
    return {.status = WRC_ERROR_SEQUENCE, .field = "forces", .cause = "call wrc_tangential first"};
  }
  if (!contact.touching) return {.status = WRC_FLAG_NO_CONTACT};
  const ModelOptions& options = contact.model->options;
  wear.worn_area_rate =
      worn_area_rate(laws.t_gamma, t_gamma(contact.forces), 2.0 * options.wheelset.nominal_radius);
  const std::int32_t cells = options.sizes.cells;
  for (std::int32_t k = 0; k < contact.patches; ++k) {
    const Patch& patch = contact.patch[k];
    const Strips region = region_strips(contact, patch);
    const TangentialFields fields = cell_fields(contact, patch);
    const double* pressure = cell_block(contact, Array::pressure, patch);
    double* per_width = array(contact, Array::strip_wear) + patch.region_first;
    for (std::int32_t j = 0; j < region.count; ++j) {
      double sum = 0.0;
      for (std::int32_t i = 0; i < cells; ++i) {
        const std::int32_t at = i * region.count + j;
        const double sx = fields.slip_x[at], sy = fields.slip_y[at];
        // What friction takes is not negative; the march may leave a trace of the other sign beside a stick
        // zone.
        const double work = std::max(0.0, -(sx * fields.traction_x[at] + sy * fields.traction_y[at]));
        const double depth_rate = wear_depth_rate(laws.sheffield, work);
        sum += depth_rate;
        wear.largest_depth_rate = std::max(wear.largest_depth_rate, depth_rate);
        wear.largest_depth_velocity = std::max(
            wear.largest_depth_velocity,
            wear_depth_velocity(laws.archard, pressure[at], contact.speed * std::sqrt(sx * sx + sy * sy)));
      }
      per_width[j] = sum * 2.0 * region.half_length[j] / cells;
    }
  }
  contact.worn = true;
  return {};
}

}  // namespace wrc
