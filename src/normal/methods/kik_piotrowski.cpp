#include "normal/methods/kik_piotrowski.hpp"

#include <cmath>

#include "normal/check.hpp"
#include "normal/elasticity/contact_condition.hpp"
#include "normal/penetration/load_search.hpp"
#include "normal/penetration/penetration.hpp"

namespace wrc {

Fault solve_kik_piotrowski(const NormalProblem& problem, const KikPiotrowskiOptions& options, Strips& strips,
                           NormalSolution& solution) noexcept {
  solution = {};
  const Fault fault = check_normal_problem(problem, strips);
  if (fault.status != WRC_OK) return fault;

  const GapRows& rows = problem.gap;
  const GapMinimum lowest = minimum(rows);
  const GapRow contact = interpolate(rows, lowest.y);
  const PenetrationScale scale{.at_centre = options.penetration_scale};

  bool at_edge = false;
  GapReader gap(rows);
  const auto scale_at = [&](double) { return scale; };
  const auto force = [&](double approach, const PenetrationScale&, const Span& span) {
    at_edge = span.at_edge;
    divide_span(*problem.kernels, rows, lowest, scale, approach, span, problem.strips, strips);
    for (std::int32_t j = 0; j < strips.count; ++j) {
      const double row_curvature = gap.at(strips.y[j]).curvature;
      strips.half_length[j] *= std::sqrt(row_curvature / contact.curvature);
      strips.centre[j] = contact.centre;
    }
    return impose_approach(*problem.kernels, approach, problem.material, contact.centre, lowest.y, strips);
  };
  return solve_by_search(problem, lowest, 0.5 * contact.curvature, scale_at, force, at_edge, strips,
                         solution);
}

}  // namespace wrc
