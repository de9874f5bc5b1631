#include "normal/methods/hertz.hpp"

#include "normal/check.hpp"
#include "normal/elasticity/hertz_theory.hpp"
#include "normal/penetration/load_search.hpp"
#include "normal/penetration/penetration.hpp"
#include "patch/sdec.hpp"

namespace wrc {

Fault solve_hertz(const NormalProblem& problem, Strips& strips, NormalSolution& solution) noexcept {
  solution = {};
  Fault fault = check_normal_problem(problem, strips);
  if (fault.status != WRC_OK) return fault;

  const GapRows& rows = problem.gap;
  const GapMinimum lowest = minimum(rows);
  const GapRow contact = interpolate(rows, lowest.y);
  const double coefficient_x = 0.5 * contact.curvature;

  HertzEllipse ellipse;
  bool at_edge = false;
  // The ellipse's curvature is that of the chord, which depends on its ends alone.
  const auto scale_at = [](double) { return PenetrationScale{}; };
  const auto force = [&](double approach, const PenetrationScale&, const Span& chord) {
    const LateralCurvature lateral = lateral_curvature(chord, approach);
    at_edge = lateral.at_edge;
    ellipse =
        hertz_ellipse(coefficient_x, lateral.coefficient, approach, problem.material.normal_compliance());
    return ellipse.normal_force;
  };
  fault = search_approach(problem, lowest, first_guess(problem, coefficient_x), scale_at, force, strips,
                          solution);
  if (fault.failed()) return fault;

  sdec_strips({ellipse.a, ellipse.b, 0.0}, contact.centre, lowest.y, solution.normal_force, problem.strips,
              strips);
  complete_solution(strips, lowest, at_edge, solution, fault);
  return fault;
}

}  // namespace wrc
