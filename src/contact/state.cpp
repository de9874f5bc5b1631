#include "contact/state.hpp"

#include <algorithm>
#include <cstring>
#include <new>

#include "contact/methods.hpp"
#include "tangential/methods/strip_memory.hpp"

namespace wrc::contact {
namespace {

std::size_t offset(const Contact& contact, Array which) {
  return contact.model->layout.offset[static_cast<std::size_t>(which)];
}

/// The strips whose five arrays begin with `first`, in the order of enum Array.
patch::Strips strips_at(Contact& contact, Array first, std::int32_t count) {
  const auto member = [&](int i) { return array(contact, static_cast<Array>(static_cast<int>(first) + i)); };
  return {contact.model->options.sizes.strips, count, member(0), member(1), member(2), member(3), member(4)};
}

}  // namespace

std::size_t state_bytes(const Model& model) { return model.layout.bytes; }

std::size_t contact_bytes(const Model& model) {
  const std::size_t copy = state_bytes(model) + model.layout.stages;
  return state_bytes(model) + std::max(copy, model.layout.behind);
}

Contact& make_contact(const Model& model, geometry::Side side, void* memory) {
  // Zeros make equal contacts equal in all their bytes, and touch every page once, before the first real-time
  // call.
  auto* bytes = static_cast<unsigned char*>(memory);
  std::fill_n(bytes, contact_bytes(model), static_cast<unsigned char>(0));
  auto* contact = new (memory) Contact;
  contact->model = &model;
  contact->side = side;
  if (model.options.non_steady)
    tangential::make_strip_memory(model.options.sizes.strips, array(*contact, Array::rolling_memory));
  if (const std::int32_t remembered = remembered_strips(model.options); remembered > 0)
    tangential::make_strip_memory(remembered, surface_state(*contact).memory);
  return *contact;
}

void take_state(Contact& contact, const void* saved) {
  const Model* const model = contact.model;
  std::memcpy(static_cast<void*>(&contact), saved, state_bytes(*model));
  contact.model = model;  // where it lies now
  cells_known(contact) = 0.0;
}

void back_to(Contact& contact, Stage stage) {
  // `posed`, the pose and the gap stay: callers of the geometry stage clear them.
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

const Bodies& bodies(const Contact& contact) { return contact.model->bodies[static_cast<int>(contact.side)]; }

double* array(Contact& contact, Array which) {
  return reinterpret_cast<double*>(reinterpret_cast<char*>(&contact) + offset(contact, which));
}

const double* array(const Contact& contact, Array which) {
  return reinterpret_cast<const double*>(reinterpret_cast<const char*>(&contact) + offset(contact, which));
}

patch::GapRows gap_rows(const Contact& contact) {
  return {contact.gap_rows, array(contact, Array::gap_y), array(contact, Array::gap_height),
          array(contact, Array::gap_centre), array(contact, Array::gap_curvature)};
}

patch::Strips all_strips(Contact& contact) { return strips_at(contact, Array::strip_y, contact.strips); }

patch::Strips patch_strips(Contact& contact, const Patch& patch) {
  return patch::slice(all_strips(contact), patch.first, patch.first + patch.count);
}

patch::Strips region_strips(Contact& contact, const Patch& patch) {
  // Strips that rolled: their own arrays, as an equivalent ellipse may stand for the patch.
  const patch::Strips all = strips_at(contact, Array::region_y, contact.model->options.sizes.strips);
  return patch::slice(all, patch.region_first, patch.region_first + patch.region_count);
}

double* cell_block(Contact& contact, Array which, const Patch& patch) {
  return array(contact, which) + patch.region_first * contact.model->options.sizes.cells;
}

tangential::TangentialFields cell_fields(Contact& contact, const Patch& patch) {
  return {cell_block(contact, Array::traction_x, patch), cell_block(contact, Array::traction_y, patch),
          cell_block(contact, Array::slip_x, patch), cell_block(contact, Array::slip_y, patch)};
}

surface::SurfaceState surface_state(const Contact& contact) {
  const Model& model = *contact.model;
  Arena arena(const_cast<double*>(array(contact, Array::surface_state)));
  return surface::cut_surface_state(arena, model.surface->most_overlapping, remembered_strips(model.options));
}

double& cells_known(Contact& contact) { return *array(contact, Array::cells_known); }

double* work_space(Contact& contact) { return array(contact, Array::workspace); }

bool gives_fields(const Contact& contact) {
  return contact.model->options.tangential_method->gives_tractions;
}

}  // namespace wrc::contact
