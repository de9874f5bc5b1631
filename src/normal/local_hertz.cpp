#include "normal/local_hertz.hpp"

#include <algorithm>

#include "normal/check.hpp"
#include "normal/hertz_theory.hpp"
#include "normal/load_search.hpp"
#include "normal/penetration.hpp"

namespace wrc {
namespace {

constexpr double flat = 0.1;  // [1/m]

/// The curvatures of the gap at y, and Hertz's eps_y for them as the scale of the penetration.
struct LocalCurvature {
  const GapRows& rows;
  double reach;

  double lateral(double y) const {
    const double beside = interpolate(rows, y - reach).height + interpolate(rows, y + reach).height;
    const double second = (beside - 2.0 * interpolate(rows, y).height) / (reach * reach);
    return std::max(0.5 * second, flat);
  }
  double longitudinal(double y) const { return 0.5 * interpolate(rows, y).curvature; }
  HertzShape shape(double y) const { return hertz_shape(longitudinal(y) / lateral(y)); }
  double at(double y) const { return shape(y).eps_y; }
};

}  // namespace

Fault solve_local_hertz(const NormalProblem& problem, CurvatureReach reach, Strips& strips,
                        NormalSolution& solution) noexcept {
  solution = {};
  Fault fault = check_normal_problem(problem, strips);
  if (fault.status != WRC_OK) return fault;

  const GapRows& rows = problem.gap;
  const GapMinimum lowest = minimum(rows);
  const double compliance = problem.material.normal_compliance();
  bool at_edge = false;
  const auto force = [&](double approach) {
    const Span half_depth = penetration_span(rows, lowest, PenetrationScale{}, approach);
    const LocalCurvature local{rows, reach(0.5 * half_depth.width())};
    const Span span = penetration_span(rows, lowest, local, approach);
    at_edge = span.at_edge;
    divide_span(rows, lowest, local, approach, span, problem.strips, strips);
    double load = 0.0;
    for (std::int32_t j = 0; j < strips.count; ++j) {
      const double y = strips.y[j];
      const double coefficient_x = local.longitudinal(y);
      const HertzShape shape = local.shape(y);
      const double overlap = coefficient_x * strips.half_length[j] * strips.half_length[j];
      const double depth = overlap / shape.eps_y;
      strips.half_length[j] *= std::sqrt(shape.eps_x / shape.eps_y);
      strips.peak[j] = hertz_ellipse(coefficient_x, local.lateral(y), depth, compliance).peak;
      load += 0.5 * pi * strips.half_length[j] * strips.peak[j] * strips.width[j];
    }
    return load;
  };
  fault = search_approach(problem, first_guess(problem, 0.5 * interpolate(rows, lowest.y).curvature),
                          deepest_approach(rows, lowest), force, solution);
  if (fault.failed()) {
    strips.count = 0;
    return fault;
  }
  complete_solution(strips, lowest, at_edge, solution, fault);
  return fault;
}

}  // namespace wrc
