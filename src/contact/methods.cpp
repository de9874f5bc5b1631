#include "contact/methods.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>

#include "contact/state.hpp"
#include "normal/methods/analyn.hpp"
#include "normal/methods/ekp.hpp"
#include "normal/methods/hertz.hpp"
#include "normal/methods/kik_piotrowski.hpp"
#include "normal/methods/stripes.hpp"
#include "normal/penetration/load_search.hpp"
#include "normal/strip_halfspace/strip_halfspace.hpp"
#include "tangential/force_table/force_table.hpp"
#include "tangential/methods/fastrip.hpp"
#include "tangential/methods/fastsim.hpp"
#include "tangential/methods/polach.hpp"
#include "tangential/methods/strip_fastsim.hpp"
#include "wrc/wrc_methods.h"

namespace wrc::contact {
namespace {

/// The strip half-space solver with its scratch memory, from its last solution where the model asks for that;
/// beyond the gap it is continued as the other methods are.
Fault solve_from_start(Contact& contact, const normal::NormalProblem& problem, patch::Strips& strips) {
  // Scratch, and the last solution: place, width, squared half length and shift of each strip.
  const ModelOptions& options = contact.model->options;
  normal::NormalWorkspace workspace{work_space(contact), options.sizes.stage_workspace_bytes};
  normal::StripHalfspaceStart start{options.sizes.strips,
                                    options.warm_start ? contact.start_strips : 0,
                                    array(contact, Array::start_y),
                                    array(contact, Array::start_width),
                                    array(contact, Array::start_length_squared),
                                    array(contact, Array::start_shift)};
  const auto solve = [&](const normal::NormalProblem& posed) {
    return normal::solve_strip_halfspace(posed, {.max_sweeps = options.max_sweeps}, *contact.model->influence,
                                         workspace, start, strips, contact.normal);
  };

  // Within the gap the solver as it is; `beyond` where its approach would pass the deepest row.
  bool beyond = problem.prescribed == normal::Prescribed::approach && problem.approach > problem.deepest;
  Fault fault;
  if (!beyond) {
    fault = solve(problem);
    beyond = fault.status == WRC_ERROR_LOAD || (!fault.failed() && contact.normal.approach > problem.deepest);
    if (beyond) start.count = 0;  // a solution beyond the gap is no start
  }
  // Beyond it: the solution at the gap's end, continued with its stiffness.
  if (beyond) {
    normal::NormalProblem end = problem;
    end.prescribed = normal::Prescribed::approach;
    end.approach =
        std::min(normal::deepest_approach(problem.gap, patch::minimum(problem.gap)), problem.deepest);
    fault = solve(end);
    if (!fault.failed()) fault = normal::continue_beyond(problem, strips, contact.normal);
  }
  contact.start_strips = fault.failed() ? 0 : start.count;
  return fault;
}

#define WRC_ENUMERATOR(name) \
  { name, #name }

constexpr NormalMethod normal_methods[] = {
    {.is = WRC_ENUMERATOR(WRC_NORMAL_HERTZ),
     .reads = {Option::max_iterations, Option::load_tolerance},
     .planar = normal::solve_hertz},
    {.is = WRC_ENUMERATOR(WRC_NORMAL_KIK_PIOTROWSKI),
     .reads = {Option::max_iterations, Option::load_tolerance},
     .planar =
         [](const normal::NormalProblem& problem, patch::Strips& strips, normal::NormalSolution& solution) {
           return normal::solve_kik_piotrowski(problem, {}, strips, solution);
         }},
    {.is = WRC_ENUMERATOR(WRC_NORMAL_EKP),
     .reads = {Option::max_iterations, Option::load_tolerance},
     .planar =
         [](const normal::NormalProblem& problem, patch::Strips& strips, normal::NormalSolution& solution) {
           return normal::solve_ekp(problem, {normal::EkpScale::area}, strips, solution);
         }},
    {.is = WRC_ENUMERATOR(WRC_NORMAL_EKP_ELLIPSE),
     .reads = {Option::max_iterations, Option::load_tolerance},
     .planar =
         [](const normal::NormalProblem& problem, patch::Strips& strips, normal::NormalSolution& solution) {
           return normal::solve_ekp(problem, {normal::EkpScale::ellipse}, strips, solution);
         }},
    {.is = WRC_ENUMERATOR(WRC_NORMAL_ANALYN),
     .reads = {Option::max_iterations, Option::load_tolerance},
     .planar = normal::solve_analyn},
    {.is = WRC_ENUMERATOR(WRC_NORMAL_STRIPES),
     .reads = {Option::max_iterations, Option::load_tolerance},
     .planar = normal::solve_stripes},
    {.is = WRC_ENUMERATOR(WRC_NORMAL_STRIP_HALFSPACE),
     .reads = {Option::max_sweeps, Option::warm_start,
               Option::surface_iteration},  // the load is met to rounding
     .half_space = true,
     .workspace = normal::strip_halfspace_workspace,
     .solve = solve_from_start},
};

constexpr TangentialMethod tangential_methods[] = {
    {.is = WRC_ENUMERATOR(WRC_TANGENTIAL_FASTSIM),
     .reads = {Option::patch_model, Option::traction_bound, Option::flexibility, Option::slope_fall},
     .gives_tractions = true,
     .gives_derivatives = true,
     .takes_layer = true,
     .over_strips = true,
     .strips = surface::SurfaceRollingMethod::fastsim,
     .solve = tangential::fastsim},
    {.is = WRC_ENUMERATOR(WRC_TANGENTIAL_FASTRIP),
     .reads = Option::patch_model,
     .gives_tractions = true,
     .over_strips = true,
     .strips = surface::SurfaceRollingMethod::fastrip,
     .workspace = tangential::fastrip_workspace,
     .solve = [](const tangential::RollingContact& c, const tangential::TangentialFields& fields,
                 Fault& fault,
                 tangential::TangentialSensitivities*) { return tangential::fastrip(c, fields, fault); }},
    {.is = WRC_ENUMERATOR(WRC_TANGENTIAL_STRIP_FASTSIM),
     .reads = {Option::non_steady, Option::surface_memory},
     .gives_tractions = true,
     .gives_derivatives = true,
     .takes_layer = true,
     .over_strips = true,
     .solve = tangential::strip_fastsim},
    {.is = WRC_ENUMERATOR(WRC_TANGENTIAL_FORCE_TABLE),
     .reads = Option::force_table,
     .solve =
         [](const tangential::RollingContact& c, const tangential::TangentialFields&, Fault& fault,
            tangential::TangentialSensitivities*) {
           return tangential::table_forces(*c.force_table, {c.a, c.b, c.shape_number}, c.normal_force,
                                           c.shear_modulus, c.friction.mean, c.creepage, fault);
         }},
    {.is = WRC_ENUMERATOR(WRC_TANGENTIAL_POLACH),
     .reads = Option::reduction_factors,
     .one_sliding_speed = true,
     .solve = [](const tangential::RollingContact& c, const tangential::TangentialFields&, Fault& fault,
                 tangential::TangentialSensitivities*) { return tangential::polach(c, fault); }},
};
#undef WRC_ENUMERATOR

/// Is every row at the place of its value?
template <class Method, std::size_t count>
constexpr bool in_order(const Method (&methods)[count]) {
  for (std::size_t i = 0; i < count; ++i)
    if (methods[i].is.value != static_cast<std::int32_t>(i)) return false;
  return true;
}
static_assert(in_order(normal_methods) && in_order(tangential_methods));

struct Sentence {
  char text[256] = {};
};

/// Lists the methods whose rows read an option, at compile time.
constexpr Sentence sentence_about(Option option) {
  Sentence sentence;
  std::size_t length = 0;
  int readers = 0;
  const auto add = [&](const char* piece) {
    while (*piece != '\0') sentence.text[length++] = *piece++;
  };
  const auto add_readers = [&](const auto& methods) {
    for (const auto& method : methods) {
      if (!method.reads.has(option)) continue;
      add(readers++ == 0 ? "only " : ", ");
      add(method.is.name);
    }
  };
  add_readers(normal_methods);
  add_readers(tangential_methods);
  add(readers == 1 ? " reads it" : " read it");
  return sentence;
}

constexpr auto sentences = [] {
  std::array<Sentence, static_cast<std::size_t>(Option::count)> all;
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = sentence_about(static_cast<Option>(i));
  return all;
}();

template <class Method, std::size_t count>
const Method* row(const Method (&methods)[count], std::int32_t value) {
  return value >= 0 && value < static_cast<std::int32_t>(count) ? &methods[value] : nullptr;
}

}  // namespace

const NormalMethod* normal_method(std::int32_t value) { return row(normal_methods, value); }

const TangentialMethod* tangential_method(std::int32_t value) { return row(tangential_methods, value); }

const char* readers_of(Option option) { return sentences[static_cast<std::size_t>(option)].text; }

surface::SurfaceMethods surface_methods(const ModelOptions& options) {
  const NormalMethod& normal = *options.normal_method;
  const TangentialMethod& tangential = *options.tangential_method;
  surface::SurfaceMethods methods;
  methods.remembers = options.surface_memory;
  // The planar method, if there is one, is laid over the rail's strips; otherwise the surface has its own
  // solver.
  methods.planar = {normal.planar, options.sizes.strips, options.max_iterations, options.load_tolerance};
  methods.strips = tangential.strips;
  methods.parabolic = options.traction_bound == tangential::TractionBound::parabolic;
  // Strip FASTSIM rolls strips one by one whatever the options; the others do in their strip forms only, and
  // otherwise roll whole regions.
  if (tangential.over_strips && tangential.strips == surface::SurfaceRollingMethod::strip_fastsim)
    return methods;
  const tangential::PatchModel& shape = options.patch_model;
  methods.by_region = !(tangential.over_strips && shape.of_sdec && !shape.on_ellipse &&
                        options.flexibility == tangential::FlexibilityForm::separate &&
                        options.traction_bound != tangential::TractionBound::ellipsoidal);
  methods.region = {.solve = tangential.solve,
                    .model = shape,
                    .bound = options.traction_bound,
                    .form = options.flexibility};
  // A region has no more strips than may overlap at once.
  if (tangential.workspace)
    methods.region.workspace_bytes =
        tangential.workspace(surface::most_overlapping_strips, options.surface_cells);
  return methods;
}

}  // namespace wrc::contact
