#include "normal/check.hpp"

#include <algorithm>
#include <cmath>

namespace wrc::normal {
namespace {

Fault check_rows(const patch::GapRows& rows) {
  if (rows.y == nullptr || rows.height == nullptr || rows.centre == nullptr || rows.curvature == nullptr)
    return Fault::null("gap");
  if (rows.count < 4) return Fault::gap("gap.count", {rows.count}, "at least four rows are needed");
  // Finiteness first, by bits: a comparison with a NaN would raise a trap that the host may have armed.
  if (!std::isfinite(rows.height[0])) return Fault::not_finite({"gap", 0});
  double lowest = rows.height[0], highest = rows.height[0];
  for (std::int32_t j = 0; j < rows.count; ++j) {
    for (const double value : {rows.y[j], rows.height[j], rows.centre[j], rows.curvature[j]})
      if (!std::isfinite(value)) return Fault::not_finite({"gap", j});
    // Range of heights, to tell a flat gap below.
    lowest = std::min(lowest, rows.height[j]);
    highest = std::max(highest, rows.height[j]);
    if (j > 0 && rows.y[j] <= rows.y[j - 1])
      return Fault::gap({"gap.y", j}, {rows.y[j], "m"}, "rows must be ordered by increasing y");
    if (rows.curvature[j] <= 0.0)
      return Fault::gap({"gap.curvature", j}, {rows.curvature[j], "1/m"},
                        "bodies that conform along the rolling direction are no rolling contact");
  }
  // Rows of one height have no lowest point to start from.
  constexpr double least_range = 1e-12;  // [m]
  if (!(highest - lowest > least_range))
    return Fault::gap("gap.height", {lowest, "m"}, "all rows are of the same height");
  return {};
}

}  // namespace

Fault check_normal_problem(const NormalProblem& problem, patch::Strips& output) noexcept {
  output.count = 0;
  if (Fault fault = check_rows(problem.gap); fault.failed()) return fault;
  // Material: G > 0 [Pa], 0 <= nu <= 0.5.
  const patch::Material& material = problem.material;
  if (!std::isfinite(material.shear_modulus) || !std::isfinite(material.poisson))
    return Fault::not_finite("material");
  if (!(material.shear_modulus > 0.0) || !(material.poisson >= 0.0 && material.poisson <= 0.5))
    return Fault::range("material", {material.shear_modulus, "Pa"});
  // The prescribed quantity: load [N] or approach [m].
  const bool load = problem.prescribed == Prescribed::load;
  const double given = load ? problem.normal_force : problem.approach;
  const char* const field = load ? "load.normal_force" : "load.approach";
  if (!std::isfinite(given)) return Fault::not_finite(field);
  if (load && given < 0.0) return Fault::range(field, {given, "N"}, "a contact cannot pull");
  // Memory for the result.
  if (problem.strips < 4) return Fault::range("strips", {problem.strips});
  if (output.capacity < problem.strips) return Fault::buffer("strips.capacity", {output.capacity});
  // Zero load, or bodies apart: nothing to solve, and no fault.
  if (given <= 0.0) return Fault::no_contact(field);
  return {};
}

Fault begin_solution(const NormalProblem& problem, patch::Strips& output, NormalSolution& solution,
                     FirstTouch& touch) noexcept {
  solution = {};
  const Fault fault = check_normal_problem(problem, output);
  if (fault.status != WRC_OK) return fault;
  // The first touch: lowest point of the gap, or of the patch that the caller asks for.
  touch.lowest = problem.touch ? *problem.touch : patch::minimum(problem.gap);
  touch.row = patch::interpolate(problem.gap, touch.lowest.y);
  return {};
}

}  // namespace wrc::normal
