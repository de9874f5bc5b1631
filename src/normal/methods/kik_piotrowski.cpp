#include "normal/methods/kik_piotrowski.hpp"

#include <algorithm>
#include <cmath>

#include "normal/check.hpp"
#include "normal/elasticity/contact_condition.hpp"
#include "normal/elasticity/hertz_theory.hpp"
#include "normal/penetration/load_search.hpp"
#include "normal/penetration/penetration.hpp"

namespace wrc {
namespace {

/// Gives the strips the axis ratio of Hertz's ellipse, keeping area and the place of the contact point.
void correct_shape(Strips& strips, double y_contact) {
  const double half_length = *std::max_element(strips.half_length, strips.half_length + strips.count);
  const double half_width = 0.5 * strips.width[0] * strips.count;
  const double aspect = half_length / half_width;
  const double hertz_aspect = hertz_shape(1.0 / (aspect * aspect)).axis_ratio;
  const double stretch = std::sqrt(hertz_aspect / aspect);
  for (std::int32_t j = 0; j < strips.count; ++j) {
    strips.half_length[j] *= stretch;
    strips.width[j] /= stretch;
    strips.y[j] = y_contact + (strips.y[j] - y_contact) / stretch;
  }
}

}  // namespace

Fault solve_kik_piotrowski(const NormalProblem& problem, const KikPiotrowskiOptions& options, Strips& strips,
                           NormalSolution& solution) noexcept {
  solution = {};
  const Fault fault = check_normal_problem(problem, strips);
  if (fault.status != WRC_OK) return fault;
  if (!(options.penetration_scale > 0.0 && options.penetration_scale <= 1.0))
    return {.status = WRC_ERROR_RANGE,
            .field = "penetration_scale",
            .value = options.penetration_scale,
            .low = 0.0,
            .high = 1.0};

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
    if (options.shape_correction) correct_shape(strips, lowest.y);
    return impose_approach(*problem.kernels, approach, problem.material, contact.centre, lowest.y, strips);
  };
  return solve_by_search(problem, lowest, 0.5 * contact.curvature, scale_at, force, at_edge, strips,
                         solution);
}

}  // namespace wrc
