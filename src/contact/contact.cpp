#include "contact/contact.hpp"

#include <algorithm>
#include <new>

#include "geometry/gap_rows.hpp"
#include "normal/ekp.hpp"
#include "normal/hertz.hpp"
#include "normal/kik_piotrowski.hpp"

namespace wrc {
namespace {

std::size_t offset(const Contact& contact, Array which) {
  return contact.model->layout.offset[static_cast<std::size_t>(which)];
}

/// How far from the contact point the gap is looked at: the widest patch of two rails' heads, tread and
/// flange root.
constexpr double gap_half_width = 0.030;  // [m]

Strips strips_at(Contact& contact, Array first, std::int32_t count) {
  const auto member = [&](int i) { return array(contact, static_cast<Array>(static_cast<int>(first) + i)); };
  return {contact.model->options.sizes.strips, count, member(0), member(1), member(2), member(3), member(4)};
}

/// Forgets the results of every stage after `stage`.
void back_to(Contact& contact, Stage stage) {
  contact.reached = stage;
  contact.touching = false;
  contact.patch_strips = 0;
  contact.region_strips = 0;
  contact.normal = {};
  contact.extent = {};
  contact.sdec = {};
  contact.forces = {};
  contact.damage = {};
}

Fault sequence(const char* field, const char* cause) {
  return {.status = WRC_ERROR_SEQUENCE, .field = field, .cause = cause};
}

}  // namespace

std::size_t contact_bytes(const Model& model) { return model.layout.bytes; }

Contact& make_contact(const Model& model, void* memory) {
  auto* bytes = static_cast<unsigned char*>(memory);
  std::fill_n(bytes, model.layout.bytes, static_cast<unsigned char>(0));  // also touches every page, once
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

Strips patch_strips(Contact& contact) { return strips_at(contact, Array::patch_y, contact.patch_strips); }
Strips region_strips(Contact& contact) { return strips_at(contact, Array::region_y, contact.region_strips); }

// ----------------------------------------------------------------------------------------------------------
// gap

Fault find_gap(Contact& contact, const Pose& pose) {
  back_to(contact, Stage::none);
  contact.gap_rows = 0;
  const Model& model = *contact.model;
  if (!model.has_geometry) {
    return sequence(
        "pose", "the model was made without profiles: hand over a gap, or give config.wheel and config.rail");
  }
  const PosedWheel wheel = posed(model.wheel, pose);
  std::int32_t found = 0;
  Fault fault = find_contact(model.rail, wheel, 1, &contact.point, found);
  if (fault.failed()) return fault;

  const GapWindow window =
      gap_window(model.rail, wheel, contact.point, {model.options.gap_limit, gap_half_width});
  GapRows rows;
  const GapRowMemory memory{model.options.sizes.gap_rows, array(contact, Array::gap_y),
                            array(contact, Array::gap_height), array(contact, Array::gap_centre),
                            array(contact, Array::gap_curvature)};
  worsen(fault, fill_gap_rows(model.rail, wheel, contact.point, window, memory.capacity, memory, rows));
  if (fault.failed()) return fault;
  contact.gap_rows = rows.count;
  contact.reached = Stage::gap;
  return fault;
}

void take_gap(Contact& contact, const GapRows& rows) {
  back_to(contact, Stage::gap);
  contact.gap_rows = rows.count;
  std::copy_n(rows.y, rows.count, array(contact, Array::gap_y));
  std::copy_n(rows.height, rows.count, array(contact, Array::gap_height));
  if (rows.centre != nullptr) {
    std::copy_n(rows.centre, rows.count, array(contact, Array::gap_centre));
  } else {
    std::fill_n(array(contact, Array::gap_centre), rows.count, 0.0);
  }
  std::copy_n(rows.curvature, rows.count, array(contact, Array::gap_curvature));
}

Fault take_gap(Contact& contact, const GapGrid& grid) {
  back_to(contact, Stage::none);
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

Fault solve_normal(Contact& contact, const Load& load) {
  if (contact.gap_rows == 0) return sequence("gap", "call wrc_geometry first, or hand over a gap");
  back_to(contact, Stage::gap);
  const ModelOptions& options = contact.model->options;
  NormalProblem problem;
  problem.gap = gap_rows(contact);
  problem.material = options.material;
  problem.prescribed = load.prescribed;
  (load.prescribed == Prescribed::load ? problem.normal_force : problem.approach) = load.value;
  problem.strips = options.sizes.strips;
  problem.max_iterations = options.max_iterations;
  problem.force_tolerance = options.load_tolerance;

  Strips strips = patch_strips(contact);
  Fault fault;
  switch (options.normal_method) {
    case NormalMethod::hertz:
      fault = solve_hertz(problem, strips, contact.normal);
      break;
    case NormalMethod::kik_piotrowski:
      fault = solve_kik_piotrowski(problem, {}, strips, contact.normal);
      break;
    case NormalMethod::ekp:
      fault = solve_ekp(problem, {}, strips, contact.normal);
      break;
  }
  if (fault.failed()) {
    back_to(contact, Stage::gap);
    return fault;
  }
  contact.reached = Stage::patch;
  contact.patch_strips = strips.count;
  contact.touching = strips.count > 0;
  contact.extent = totals(strips);
  return fault;
}

Fault take_strips(Contact& contact, const Strips& strips) {
  back_to(contact, Stage::patch);
  contact.gap_rows = 0;
  contact.patch_strips = strips.count;
  const Strips ours = patch_strips(contact);
  std::copy_n(strips.y, strips.count, ours.y);
  std::copy_n(strips.width, strips.count, ours.width);
  if (strips.centre != nullptr) {
    std::copy_n(strips.centre, strips.count, ours.centre);
  } else {
    std::fill_n(ours.centre, strips.count, 0.0);
  }
  std::copy_n(strips.half_length, strips.count, ours.half_length);
  std::copy_n(strips.peak, strips.count, ours.peak);
  contact.extent = totals(ours);
  contact.touching = contact.extent.normal_force > 0.0;
  contact.normal.normal_force = contact.extent.normal_force;
  contact.normal.peak_pressure = contact.extent.peak_pressure;
  contact.normal.area = contact.extent.area;
  return contact.touching ? Fault{} : Fault{.status = WRC_FLAG_NO_CONTACT};
}

Fault take_double_ellipse(Contact& contact, const Sdec& sdec, double normal_force) {
  back_to(contact, Stage::patch);
  contact.gap_rows = 0;
  Strips strips = patch_strips(contact);
  sdec_strips(sdec, 0.0, 0.0, normal_force, contact.model->options.sizes.strips, strips);
  contact.patch_strips = strips.count;
  contact.touching = true;
  contact.extent = totals(strips);
  contact.extent.area = pi * sdec.a * sdec.b;  // exactly, where the strips converge to it
  contact.extent.normal_force = normal_force;
  contact.extent.peak_pressure = peak_pressure(sdec, normal_force);
  contact.extent.length = 2.0 * sdec.a;
  contact.normal.normal_force = normal_force;
  contact.normal.peak_pressure = contact.extent.peak_pressure;
  contact.normal.area = contact.extent.area;
  contact.sdec = sdec;
  return {};
}

Fault regularise_patch(Contact& contact) {
  if (contact.reached < Stage::patch) {
    return sequence("strips", "there is no patch: call wrc_normal first, or hand over strips");
  }
  if (!contact.touching) return {.status = WRC_FLAG_NO_CONTACT};
  return regularise(contact.extent, contact.normal.y_contact, contact.model->options.regularisation,
                    contact.sdec);
}

}  // namespace wrc
