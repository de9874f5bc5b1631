#include "normal/methods/hertz.hpp"

#include "normal/check.hpp"
#include "normal/elasticity/hertz_theory.hpp"
#include "normal/penetration/load_search.hpp"
#include "normal/penetration/penetration.hpp"
#include "patch/sdec.hpp"

namespace wrc::normal {

Fault solve_hertz(const NormalProblem& problem, patch::Strips& strips, NormalSolution& solution) noexcept {
  FirstTouch touch;
  Fault fault = begin_solution(problem, strips, solution, touch);
  if (fault.status != WRC_OK) return fault;

  // A from the row of first touch, B from the chord [1/m].
  const double coefficient_x = 0.5 * touch.row.curvature;

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
  fault = search_approach(problem, touch.lowest, first_guess(problem, coefficient_x), scale_at, force, strips,
                          solution);
  if (fault.failed()) return fault;

  // The ellipse of the last trial, cut into strips that carry the load exactly.
  patch::sdec_strips({ellipse.a, ellipse.b, 0.0}, touch.row.centre, touch.lowest.y, solution.normal_force,
                     problem.strips, strips);
  complete_solution(strips, touch.lowest, at_edge, solution, fault);
  return fault;
}

}  // namespace wrc::normal
