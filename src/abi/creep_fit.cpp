/// Fit of friction and of a layer to a measured creep curve, behind the C interface. Offline: it allocates.
#include "curves/creep_fit.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "abi/friction.hpp"
#include "abi/offline.hpp"
#include "base/elementary.hpp"
#include "contact/methods.hpp"
#include "contact/model.hpp"

namespace wrc::abi {
namespace {

using contact::Option;

/// A parameter in the interface's terms.
struct Named {
  Member member;  ///< its description in wrc_friction
  const char* name;
  curves::FitParameter inside;
  double per = 1.0;  ///< value in the unit of the interface over that inside
};

using Inside = contact::Friction;
using Law = tangential::FrictionLaw;
using Factors = tangential::ReductionFactors;
using Spring = tangential::Layer;

/// All parameters, in the order of enum wrc_creep_parameter.
std::vector<Named> parameters_of(const wrc_friction& friction) {
  const auto law = [](double Law::*number) { return curves::FitParameter{.law = number}; };
  const auto factor = [](double Factors::*number) { return curves::FitParameter{.reduction = number}; };
  const auto layer = [](double Spring::*number) { return curves::FitParameter{.layer = number}; };
  const double modulus = friction.layer_modulus > 0.0 ? friction.layer_modulus : 1.0;
  std::vector<Named> all = {
      {MEMBER(wrc_friction, "coefficient"), "WRC_CREEP_COEFFICIENT", law(&Law::coefficient)},
      {MEMBER(wrc_friction, "kinetic_ratio"), "WRC_CREEP_KINETIC_RATIO", law(&Law::kinetic_ratio)},
      {MEMBER(wrc_friction, "fall_rate"), "WRC_CREEP_FALL_RATE", law(&Law::fall_rate)},
      {MEMBER(wrc_friction, "half_speed"), "WRC_CREEP_HALF_SPEED", law(&Law::half_speed)},
      {MEMBER(wrc_friction, "slope_reduction"),
       "WRC_CREEP_SLOPE_REDUCTION",
       {.friction = &Inside::slope_reduction}},
      {MEMBER(wrc_friction, "adhesion_reduction"), "WRC_CREEP_ADHESION_REDUCTION",
       factor(&Factors::adhesion)},
      {MEMBER(wrc_friction, "slip_reduction"), "WRC_CREEP_SLIP_REDUCTION", factor(&Factors::slip)},
      {MEMBER(wrc_friction, "layer_thickness"), "WRC_CREEP_LAYER_THICKNESS", layer(&Spring::flexibility),
       modulus},
      {MEMBER(wrc_friction, "layer_yield"), "WRC_CREEP_LAYER_YIELD", layer(&Spring::yield)},
      {MEMBER(wrc_friction, "layer_hardening"), "WRC_CREEP_LAYER_HARDENING", layer(&Spring::hardening)}};

  // Ranges, those of the members; positive parameters end above 0. A ratio of friction counts by itself, a
  // hardening by the modulus over the thickness, or by the yield over a micrometre where nothing shears.
  constexpr double least_thickness = 1e-9, least_rate = 1e-3, micrometre = 1e-6;
  for (Named& each : all) {
    each.inside.low = each.member.low / each.per;
    each.inside.high = each.member.high / each.per;
  }
  all[WRC_CREEP_FALL_RATE].inside.low = least_rate;
  all[WRC_CREEP_LAYER_THICKNESS].inside.low = least_thickness / modulus;
  curves::FitParameter& ratio = all[WRC_CREEP_KINETIC_RATIO].inside;
  ratio.positive = false;
  ratio.vague = 0.5;
  curves::FitParameter& hardening = all[WRC_CREEP_LAYER_HARDENING].inside;
  hardening.positive = false;
  hardening.unit = friction.layer_thickness > 0.0 ? modulus / friction.layer_thickness
                                                  : std::max(friction.layer_yield, 1e6) / micrometre;
  return all;
}

/// Does the law or the method read the parameter?
bool is_read(std::int32_t parameter, const wrc_friction& friction, const contact::TangentialMethod& method) {
  switch (parameter) {
    case WRC_CREEP_KINETIC_RATIO:
      return friction.speed_law != WRC_SPEED_LAW_NONE;
    case WRC_CREEP_FALL_RATE:
      return friction.speed_law == WRC_SPEED_LAW_EXPONENTIAL;
    case WRC_CREEP_HALF_SPEED:
      return friction.speed_law == WRC_SPEED_LAW_HYPERBOLIC;
    case WRC_CREEP_SLOPE_REDUCTION:
      return friction.layer_thickness == 0.0 && friction.layer_yield == 0.0;
    case WRC_CREEP_ADHESION_REDUCTION:
    case WRC_CREEP_SLIP_REDUCTION:
      return method.reads.has(Option::reduction_factors);
    case WRC_CREEP_LAYER_THICKNESS:
    case WRC_CREEP_LAYER_YIELD:
      return method.takes_layer;
    case WRC_CREEP_LAYER_HARDENING:
      return method.takes_layer && friction.layer_yield > 0.0;
    default:
      return true;
  }
}

/// The parameters to be found. Each is read and begins inside its range.
Fault check_parameters(const wrc_creep_curve& curve, const contact::TangentialMethod& method,
                       const std::vector<Named>& all) {
  for (std::int32_t k = 0; k < WRC_CREEP_PARAMETERS; ++k) {
    if ((curve.parameters >> k & 1U) == 0) continue;
    const Named& each = all[static_cast<std::size_t>(k)];
    if (!is_read(k, curve.friction, method)) {
      return Fault::unsupported({"curve.parameters", each.name},
                                "neither the law of curve.friction nor the tangential method read it");
    }
    if (!each.inside.positive) continue;
    const double begins = number_in(curve.friction, each.member), least = each.inside.low * each.per;
    if (begins < least) {
      return Fault::range({"curve.friction", each.member.name},
                          {begins, each.member.unit, least, each.member.high},
                          "it is looked for: let it begin where the layer or law has an effect");
    }
  }
  // a yield limit above all tractions has no effect
  if ((curve.parameters >> WRC_CREEP_LAYER_YIELD & 1U) == 0) return {};
  const wrc_ellipse& ellipse = curve.ellipse;
  const double largest_load = *std::max_element(curve.load, curve.load + curve.count);
  const double peak = patch::peak_pressure({ellipse.a, ellipse.b, ellipse.psi}, ellipse.normal_force) *
                      natural_exp(natural_log(largest_load / ellipse.normal_force) / 3.0);
  const double bound = curve.friction.coefficient * peak;
  if (curve.friction.layer_yield < bound) return {};
  return Fault::range({"curve.friction", "layer_yield"}, {curve.friction.layer_yield, "Pa", 1e3, bound},
                      "above friction times pressure the layer never yields, and nothing could be found");
}

/// Checks the curve: a plausible slope, and numbers rather than per cent.
Fault check_points(const wrc_creep_curve& curve, std::uint32_t wanted) {
  constexpr std::uint32_t more = 3;
  constexpr double most_points = 1e5;
  if (curve.count < wanted + more) {
    return Fault::range({"curve", "count"}, {curve.count, "", wanted + more, most_points},
                        "a fit needs three points more than parameters");
  }
  constexpr double least_slope = 2.0;  // adhesion over slip: steel has some 100, a soft layer 10
  double steepest = 0.0;
  for (std::uint32_t i = 0; i < curve.count; ++i)
    steepest = std::max(steepest, curve.adhesion[i] / curve.slip[i]);
  if (steepest >= least_slope) return {};
  return Fault::range(
      {"curve", "slip"}, {curve.slip[0], "", 1e-7, 1.0},
      "no point has adhesion of twice its slip: did you pass per cent? The rising part of the "
      "curve is needed");
}

/// Checks the friction that a fit begins with.
Fault check_law(const wrc_friction& friction) {
  if (friction.zone_count > 0)
    return Fault::unsupported("curve.friction.zone_count", {friction.zone_count, ""},
                              "the patch of a creep curve has one friction: give none");
  if (friction.temperature_law != WRC_TEMPERATURE_LAW_NONE)
    return Fault::unsupported("curve.friction.temperature_law", {friction.temperature_law, ""},
                              "a fit has no temperatures: WRC_TEMPERATURE_LAW_NONE");
  return {};
}

std::uint32_t count_of(std::uint32_t bits) {
  std::uint32_t count = 0;
  for (; bits != 0; bits >>= 1U) count += bits & 1U;
  return count;
}

/// The fit's problem, checked. `taken`: parameters to be found, in order.
Fault read_curve(const wrc_creep_curve* theirs, const contact::Model& model, wrc_creep_curve& curve,
                 std::vector<Named>& all, std::vector<std::size_t>& taken, curves::CurveFitProblem& problem) {
  RETURN_IF_FAILED(read(theirs, "curve", curve));
  const contact::TangentialMethod& method = *model.options.tangential_method;
  all = parameters_of(curve.friction);
  RETURN_IF_FAILED(first_of({check_points(curve, count_of(curve.parameters)), check_law(curve.friction),
                             check_parameters(curve, method, all)}));
  RETURN_IF_FAILED(read_friction(curve.friction, "curve.friction", method, problem.start));
  if (model.options.non_steady)
    return Fault::unsupported("config.planar.non_steady",
                              "a creep curve is of steady rolling: use a model without it");

  // points and patch
  for (std::uint32_t i = 0; i < curve.count; ++i)
    problem.points.push_back({curve.slip[i], curve.adhesion[i], curve.speed[i], curve.load[i]});
  problem.relative = curve.scatter == WRC_SCATTER_RELATIVE;
  problem.patch = {curve.ellipse.a, curve.ellipse.b, curve.ellipse.psi};
  problem.patch_load = curve.ellipse.normal_force;
  problem.max_iterations = curve.max_iterations;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if ((curve.parameters >> k & 1U) == 0) continue;
    taken.push_back(k);
    problem.parameters.push_back(all[k].inside);
  }
  return {};
}

/// The law of the fit, in the interface's terms, and its spread.
void write_fit(const curves::CurveFit& found, const wrc_creep_curve& curve, const std::vector<Named>& all,
               const std::vector<std::size_t>& taken, wrc_creep_fit& fit) {
  fit.iterations = found.iterations;
  fit.scatter = found.scatter;
  fit.friction = curve.friction;
  for (std::size_t i = 0; i < taken.size(); ++i) {
    const std::size_t k = taken[i];
    const curves::CurveFit::Of& of = found.of[i];
    const double per = all[k].per;
    fit.value[k] = per * of.value;
    fit.deviation[k] = per * of.deviation;
    fit.low[k] = per * of.low;
    fit.high[k] = per * of.high;
    fit.undetermined |= of.undetermined ? 1U << k : 0U;
    fit.at_limit |= of.at_limit ? 1U << k : 0U;
    std::memcpy(reinterpret_cast<char*>(&fit.friction) + all[k].member.offset, &fit.value[k], sizeof(double));
    for (std::size_t j = 0; j < taken.size(); ++j)
      fit.covariance[k][taken[j]] = per * all[taken[j]].per * found.covariance[i][j];
  }
}

/// Restores a contact after the fit.
class Kept {
 public:
  explicit Kept(contact::Contact& contact) : contact_(contact), bytes_(contact::state_bytes(*contact.model)) {
    std::memcpy(bytes_.data(), static_cast<const void*>(&contact), bytes_.size());
  }
  ~Kept() { take_state(contact_, bytes_.data()); }
  Kept(const Kept&) = delete;
  Kept& operator=(const Kept&) = delete;

 private:
  contact::Contact& contact_;
  std::vector<char> bytes_;
};

}  // namespace
}  // namespace wrc::abi

namespace abi = wrc::abi;
using wrc::Fault;

extern "C" int32_t wrc_fit_creep_curve(wrc_contact* contact, const wrc_creep_curve* curve, wrc_creep_fit* fit,
                                       double* adhesion) {
  const auto solve = [&](wrc::contact::Contact& of, wrc_creep_fit& ours) -> Fault {
    wrc_creep_curve read;
    std::vector<abi::Named> all;
    std::vector<std::size_t> taken;
    wrc::curves::CurveFitProblem problem;
    RETURN_IF_FAILED(abi::read_curve(curve, *of.model, read, all, taken, problem));
    if (adhesion != nullptr) std::fill_n(adhesion, read.count, 0.0);
    abi::Reporter reporter{.progress = read.progress, .user = read.user};
    problem.progress = reporter.callback();
    const abi::Kept kept(of);
    const wrc::curves::CurveFit found = wrc::curves::fit_curve(of, problem);
    if (found.fault.failed()) return found.fault;
    abi::write_fit(found, read, all, taken, ours);
    if (adhesion != nullptr) std::copy(found.adhesion.begin(), found.adhesion.end(), adhesion);
    return found.fault;
  };
  return abi::solve_exactly(__func__, contact, fit, "fit", solve);
}
