#include "normal/methods/kik_piotrowski.hpp"

#include <cmath>

#include "normal/check.hpp"
#include "normal/elasticity/contact_condition.hpp"
#include "normal/penetration/load_search.hpp"
#include "normal/penetration/penetration.hpp"

namespace wrc::normal {

Fault solve_kik_piotrowski(const NormalProblem& problem, const KikPiotrowskiOptions& options,
                           patch::Strips& strips, NormalSolution& solution) noexcept {
  FirstTouch touch;
  const Fault fault = begin_solution(problem, strips, solution, touch);
  if (fault.status != WRC_OK) return fault;

  const patch::GapRows& rows = problem.gap;
  const PenetrationScale scale{.at_centre = options.penetration_scale};

  // Load [N] at a trial approach.
  bool at_edge = false;
  patch::GapReader gap(rows);
  const auto scale_at = [&](double) { return scale; };
  const auto force = [&](double approach, const PenetrationScale&, const Span& span) {
    at_edge = span.at_edge;
    divide_span(*problem.kernels, rows, touch.lowest, scale, approach, span, problem.strips, strips);
    for (std::int32_t j = 0; j < strips.count; ++j) {
      // divide_span() took each row's own curvature and centre: the method knows those of first touch only,
      // x_f = sqrt(2 R g), R there.
      const double row_curvature = gap.at(strips.y[j]).curvature;
      strips.half_length[j] *= std::sqrt(row_curvature / touch.row.curvature);
      strips.centre[j] = touch.row.centre;
    }
    return impose_approach(*problem.kernels, approach, problem.material, touch.row.centre, touch.lowest.y,
                           strips);
  };
  return solve_by_search(problem, touch.lowest, 0.5 * touch.row.curvature, scale_at, force, at_edge, strips,
                         solution);
}

}  // namespace wrc::normal
