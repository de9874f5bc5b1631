/// Normal stage: from the gap, or from a pressure distribution of the host, to strips, patches and their
/// equivalent ellipses.
#include <algorithm>
#include <cmath>

#include "base/flush_subnormals.hpp"
#include "contact/methods.hpp"
#include "contact/stages.hpp"
#include "normal/damping.hpp"

namespace wrc::contact {
namespace {

/// Place where the bodies of a patch first touch: the gap's minimum within it; for strips of the host, which
/// come without a gap, the origin if the patch holds it, and otherwise the strip of the largest peak.
double contact_of(Contact& contact, const patch::Strips& strips, const patch::StripTotals& extent) {
  if (contact.gap_rows > 0) return patch::minimum(gap_rows(contact), extent.y_min, extent.y_max).y;
  if (extent.y_min < 0.0 && extent.y_max > 0.0) return 0.0;
  return strips.y[std::max_element(strips.peak, strips.peak + strips.count) - strips.peak];
}

/// A patch narrower than this [m] counts as none: far below the size of an atom the borders of its strips may
/// be the same number.
constexpr double least_patch_width = 1e-11;

/// Splits the strips into patches. Those beyond config.planar.max_patches are dropped from the tangential
/// stage and flagged; the normal result keeps them. So are those without a width, which carry next to
/// nothing.
Fault find_patches(Contact& contact) {
  const patch::Strips strips = all_strips(contact);
  contact.extent = patch::totals(strips);
  contact.patches = 0;
  std::int32_t first = 0;
  while (first < strips.count) {
    // A patch is a run of strips that share borders.
    const std::int32_t end = patch::patch_end(strips, first);
    const patch::Strips own = patch::slice(strips, first, end);
    const patch::StripTotals extent = patch::totals(own);
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

/// The smallest approach taken for a contact [m]. Below, down to the smallest number there is, areas and
/// pressures lose their digits and then vanish.
constexpr double smallest_approach = 1e-12;

/// Can a load and a size be read off these strips? Not where the gap is flat to the last bit, nor where every
/// patch is narrower than least_patch_width. Nor where the gap is so much more slender than a strip that the
/// strip's own displacement has no digits left.
bool carries_load(const patch::Strips& strips) {
  const patch::StripTotals sum = patch::totals(strips);
  if (!(std::isfinite(sum.normal_force) && std::isfinite(sum.area) && std::isfinite(sum.length) &&
        sum.normal_force > 0.0 && sum.area > 0.0))
    return false;
  // One patch of finite width is enough: find_patches() drops the others.
  for (std::int32_t first = 0; first < strips.count; first = patch::patch_end(strips, first)) {
    const patch::StripTotals patch =
        patch::totals(patch::slice(strips, first, patch::patch_end(strips, first)));
    if (patch.y_max - patch.y_min >= least_patch_width) return true;
  }
  return false;
}

/// The same patch under `share` times the pressure.
void scale_pressure(Contact& contact, patch::Strips& strips, double share) {
  for (std::int32_t j = 0; j < strips.count; ++j) strips.peak[j] *= share;
  contact.normal.normal_force *= share;
  contact.normal.peak_pressure *= share;
}

/// A pressure is taken for none below this share of the elastic one: far beneath any force that counts, and
/// far above where the numbers lose their digits.
constexpr double least_damping_factor = 1e-9;

/// The problem of the contact's gap under `load`, by the model's options.
normal::NormalProblem normal_problem(const Contact& contact, const Load& load) {
  const ModelOptions& options = contact.model->options;
  // An approach or a load, of the combined half-space of both bodies.
  normal::NormalProblem problem;
  problem.gap = gap_rows(contact);
  problem.material = options.material;
  problem.prescribed = load.prescribed;
  (load.prescribed == normal::Prescribed::load ? problem.normal_force : problem.approach) = load.value;
  // Rows of a pose are looked for up to the limit; how far the last lie above it is chance.
  if (contact.posed) problem.deepest = options.gap_limit;
  problem.strips = options.sizes.strips;
  problem.max_iterations = options.max_iterations;
  problem.force_tolerance = options.load_tolerance;
  problem.kernels = contact.model->kernels;
  return problem;
}

}  // namespace

Fault solve_normal(Contact& contact, const Load& load) {
  if (contact.gap_rows == 0)
    return Fault::sequence("gap", "call wrc_planar_geometry first, or hand over a gap");
  // The patch will belong to this load; strips of the host have none.
  back_to(contact, Stage::gap);
  contact.pressed = true;
  if (load.prescribed == normal::Prescribed::approach && load.value < smallest_approach) {
    contact.reached = Stage::patch;
    return Fault::no_contact("load.approach");
  }

  // Elastic solution: a strip's centre [m], half length [m] and peak pressure [Pa].
  const NormalMethod& method = *contact.model->options.normal_method;
  const normal::NormalProblem problem = normal_problem(contact, load);
  patch::Strips strips = all_strips(contact);
  Fault fault =
      method.planar ? method.planar(problem, strips, contact.normal) : method.solve(contact, problem, strips);
  if (!fault.failed() && strips.count > 0 && !carries_load(strips))
    fault = Fault::load("gap",
                        "no patch of finite size and pressure: is the gap flat, or far more slender than "
                        "config.planar.strips can resolve?");
  if (fault.failed()) {
    back_to(contact, Stage::gap);
    return fault;
  }
  // An unfinished search may have ended beside the load: its patch is kept, but carries the load that was
  // prescribed, so that a host's equilibrium does not depend on the search; the flag reports it.
  if (fault.status == WRC_FLAG_ITERATION_CAP && load.prescribed == normal::Prescribed::load) {
    scale_pressure(contact, strips, load.value / contact.normal.normal_force);
  }
  contact.reached = Stage::patch;

  // Damping after Hunt and Crossley: the elastic pressure times 1 + (3/2) alpha v, v the velocity of
  // approach. Where that is 0 the bodies part faster than they spring back.
  if (load.prescribed == normal::Prescribed::approach && load.damping > 0.0) {
    const double factor = normal::damping_factor(load.approach_velocity, load.damping);
    if (factor < least_damping_factor) {
      back_to(contact, Stage::patch);
      return Fault::no_contact("load.approach_velocity");
    }
    scale_pressure(contact, strips, factor);
    contact.normal.stiffness *= factor;
    contact.damping_factor = factor;
  }

  // Runs of strips that share borders are patches, each rolled on its own.
  contact.strips = strips.count;
  contact.touching = strips.count > 0;
  keep_worst(fault, find_patches(contact));
  return fault;
}

Fault take_strips(Contact& contact, const patch::Strips& strips) {
  back_to(contact, Stage::patch);
  contact.posed = false;
  contact.gap_rows = 0;
  contact.strips = strips.count;
  // Numbers of the host whose products would be subnormal count as 0: they would slow the stages that follow.
  const patch::Strips ours = all_strips(contact);
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

Fault take_double_ellipse(Contact& contact, const patch::Sdec& sdec, double normal_force) {
  back_to(contact, Stage::patch);
  contact.posed = false;
  contact.gap_rows = 0;
  patch::Strips strips = all_strips(contact);
  patch::sdec_strips(sdec, 0.0, 0.0, normal_force, contact.model->options.sizes.strips, strips);
  contact.strips = strips.count;
  contact.touching = true;
  // Area, load, peak and length are the ellipse's exact ones, to which sums over strips converge only.
  contact.extent = patch::totals(strips);
  contact.extent.area = pi * sdec.a * sdec.b;
  contact.extent.normal_force = normal_force;
  contact.extent.peak_pressure = patch::peak_pressure(sdec, normal_force);
  contact.extent.length = 2.0 * sdec.a;
  // One patch, its contact point the origin, and its ellipse the one given.
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
    keep_worst(fault, patch::regularise(patch.extent, patch.y_contact, contact.model->options.regularisation,
                                        patch.sdec));
  }
  return fault;
}

}  // namespace wrc::contact
