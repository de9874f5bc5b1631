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

namespace wrc {
namespace {

/// Does the variant replace the patch by its equivalent ellipse?
bool works_on_ellipse(TangentialMethod method) {
  return method == TangentialMethod::fastsim || method == TangentialMethod::fastsim_eqe;
}

/// Fills the region's strips, in the frame the variant wants them: about the initial contact point (y_contact
/// of the contact frame), or about the ellipse's own centre.
void prepare_region(Contact& contact, TangentialMethod method) {
  Strips region = region_strips(contact);
  if (works_on_ellipse(method)) {
    const Sdec ellipse{contact.sdec.a, contact.sdec.b, 0.0};
    sdec_strips(ellipse, 0.0, 0.0, contact.extent.normal_force, contact.model->options.sizes.strips, region);
    contact.region_strips = region.count;
    return;
  }
  const Strips patch = patch_strips(contact);
  for (std::int32_t j = 0; j < patch.count; ++j) region.y[j] = patch.y[j] - contact.normal.y_contact;
  std::copy_n(patch.width, patch.count, region.width);
  std::copy_n(patch.centre, patch.count, region.centre);
  std::copy_n(patch.half_length, patch.count, region.half_length);
  std::copy_n(patch.peak, patch.count, region.peak);
  contact.region_strips = patch.count;
}

/// x and normal pressure of every cell.
void fill_cells(Contact& contact) {
  const Strips region = region_strips(contact);
  const std::int32_t cells = contact.model->options.sizes.cells;
  double* x = array(contact, Array::cell_x);
  double* pressure = array(contact, Array::pressure);
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

TangentialFields cell_fields(Contact& contact) {
  return {array(contact, Array::traction_x), array(contact, Array::traction_y), array(contact, Array::slip_x),
          array(contact, Array::slip_y)};
}

}  // namespace

Fault solve_tangential(Contact& contact, const Creepage& creepage, double friction, double speed) {
  if (contact.reached < Stage::patch) {
    return {.status = WRC_ERROR_SEQUENCE,
            .field = "patch",
            .cause = "there is no patch: call wrc_normal first, or hand over strips or a patch"};
  }
  const Model& model = *contact.model;
  const TangentialMethod method = model.options.tangential_method;
  contact.reached = Stage::tangential;
  contact.creepage = creepage;
  contact.friction = friction;
  contact.speed = speed;
  contact.forces = {};
  contact.damage = {};
  contact.region_strips = 0;
  if (!contact.touching) return {.status = WRC_FLAG_NO_CONTACT};

  // The variants refer everything to the initial contact point; the contact frame of a host's own gap may
  // have its origin elsewhere: nu_x there is nu_x - phi y_contact, and M_z comes back by - y_contact F_x.
  const double y_contact = contact.normal.y_contact;
  prepare_region(contact, method);
  RollingContact rolling;
  rolling.region = region_strips(contact);
  rolling.a = contact.sdec.a;
  rolling.b = contact.sdec.b;
  rolling.shape_number = contact.sdec.psi;
  rolling.shear_modulus = model.options.material.shear_modulus;
  rolling.linear_theory = &model.linear_theory;
  rolling.grid = &model.march_grid;
  rolling.creepage = {creepage.longitudinal - creepage.spin * y_contact, creepage.lateral, creepage.spin};
  rolling.friction = friction;
  rolling.bound = model.options.traction_bound;
  const TangentialFields fields = cell_fields(contact);
  Fault fault;
  switch (method) {
    case TangentialMethod::fastsim:
      contact.forces = fastsim(rolling, fields, fault);
      break;
    case TangentialMethod::fastsim_eqe:
      contact.forces = fastsim_eqe(rolling, fields, fault);
      break;
    case TangentialMethod::fastsim_eql:
      contact.forces = fastsim_eql(rolling, fields, fault);
      break;
    case TangentialMethod::fastsim_sdec:
      contact.forces = fastsim_sdec(rolling, fields, fault);
      break;
  }
  contact.forces.mz -= y_contact * contact.forces.fx;

  const double shift =
      y_contact + (method == TangentialMethod::fastsim_eqe ? contact.sdec.psi * contact.sdec.b : 0.0);
  Strips region = region_strips(contact);
  for (std::int32_t j = 0; j < region.count; ++j) region.y[j] += shift;
  fill_cells(contact);
  return fault;
}

Fault assess_damage(Contact& contact) {
  if (contact.reached < Stage::tangential) {
    return {.status = WRC_ERROR_SEQUENCE, .field = "forces", .cause = "call wrc_tangential first"};
  }
  contact.reached = Stage::damage;
  if (!contact.touching) return {.status = WRC_FLAG_NO_CONTACT};
  const ModelOptions& options = contact.model->options;
  const Strips region = region_strips(contact);
  const std::int32_t cells = options.sizes.cells;
  const TangentialFields fields = cell_fields(contact);
  double* density = array(contact, Array::power_density);
  double* per_width = array(contact, Array::strip_power);
  double* local_index = array(contact, Array::fatigue_index);
  frictional_power_density(fields, region.count, cells, contact.speed, density);
  frictional_power_per_width(density, region, cells, per_width);
  local_fatigue_index(fields, region, cells, options.shear_yield, local_index);

  // The peak pressure is the patch's own, also where a variant spreads the load over the equivalent ellipse.
  const ShakedownPoint point = shakedown_point(contact.forces, contact.extent.normal_force,
                                               contact.extent.peak_pressure, options.shear_yield);
  DamageNumbers& damage = contact.damage;
  damage.power = frictional_power(per_width, region);
  damage.peak_power_density = *std::max_element(density, density + cells * region.count);
  damage.t_gamma = t_gamma(contact.forces);
  damage.t_gamma_no_spin = t_gamma_without_spin(contact.forces, contact.creepage);
  damage.utilisation = point.utilised_friction;
  damage.load_factor = point.load_factor;
  damage.shakedown_limit = shakedown_limit(point.utilised_friction);
  damage.fatigue_index = fatigue_index(point);
  damage.local_fatigue_index = *std::max_element(local_index, local_index + cells * region.count);
  return {};
}

}  // namespace wrc
