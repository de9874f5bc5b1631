#include "normal/methods/ekp.hpp"

#include <cmath>

#include "normal/check.hpp"
#include "normal/elasticity/contact_condition.hpp"
#include "normal/elasticity/hertz_theory.hpp"
#include "normal/penetration/load_search.hpp"
#include "normal/penetration/overlap_regions.hpp"
#include "normal/penetration/penetration.hpp"

namespace wrc::normal {
namespace {

PenetrationScale penetration_scale(EkpScale kind, double coefficient_x, const LateralCurvature& lateral,
                                   double approach) {
  const HertzShape shape = tabulated_hertz_shape(coefficient_x / lateral.coefficient);
  if (kind == EkpScale::area) return {.at_centre = std::sqrt(shape.eps_x * shape.eps_y)};
  // eps from eps_x at mid-width to eps_y at Hertz's b: bend = (eps_y - eps_x) / b^2.
  const double b2 = shape.eps_y * approach / lateral.coefficient;  // Hertz's b squared
  return {.at_centre = shape.eps_x, .bend = (shape.eps_y - shape.eps_x) / b2, .centre = lateral.middle};
}

}  // namespace

Fault solve_ekp(const NormalProblem& problem, const EkpOptions& options, patch::Strips& strips,
                NormalSolution& solution) noexcept {
  FirstTouch touch;
  const Fault fault = begin_solution(problem, strips, solution, touch);
  if (fault.status != WRC_OK) return fault;

  const patch::GapRows& rows = problem.gap;
  // A from the row of first touch [1/m].
  const double coefficient_x = 0.5 * touch.row.curvature;

  // eps(y) follows from A / B, with B from the chord at half the approach.
  const bool every_region = options.scale == EkpScale::ellipse;
  const auto scale_at = [&](double approach) {
    const LateralCurvature lateral = every_region ? curvature_of_all_regions(rows, touch.lowest, approach)
                                                  : lateral_curvature(rows, touch.lowest, approach);
    return penetration_scale(options.scale, coefficient_x, lateral, approach);
  };
  // Load [N] of the outline at a trial approach: strips of the overlap, then the contact condition.
  bool at_edge = false;
  const auto force = [&](double approach, const PenetrationScale& scale, const Span& span) {
    at_edge = span.at_edge;
    if (every_region) {
      const OverlapRegions regions =
          overlap_regions(rows, touch.lowest, scale, approach, span, problem.strips / 2);
      at_edge = regions.at_edge;
      divide_regions(*problem.kernels, rows, touch.lowest, scale, approach, regions, problem.strips, strips);
    } else {
      divide_span(*problem.kernels, rows, touch.lowest, scale, approach, span, problem.strips, strips);
    }
    return impose_approach(*problem.kernels, approach, problem.material, touch.row.centre, touch.lowest.y,
                           strips);
  };
  return solve_by_search(problem, touch.lowest, coefficient_x, scale_at, force, at_edge, strips, solution);
}

}  // namespace wrc::normal
