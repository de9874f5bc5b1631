/// The approach under which a method's patch carries a prescribed load.
#pragma once

#include <algorithm>
#include <cmath>

#include "normal/problem.hpp"

namespace wrc {

/// First guess of the approach for a load: the sphere of curvature 2 A [1/m] in x, Hertz's
/// delta^3 = (3 pi c N / 4)^2 2 A with the pair's compliance c; wheel and rail lie within a factor of two of
/// it [m].
double first_guess(const NormalProblem& problem, double coefficient_x) noexcept;

/// Fills what follows from the strips (peak, area), notes where the gap was lowest, and flags a patch at the
/// edge.
void complete_solution(const Strips& strips, const GapMinimum& lowest, bool at_edge, NormalSolution& solution,
                       Fault& fault) noexcept;

/// A straightened measure of the load: N grows like approach^1.5 on elliptic gaps and like approach^1.4 on
/// worn ones, so N^{11/16} grows almost like the approach itself and the secant rule on it needs four
/// evaluations.
inline double straightened(double normal_force) noexcept {
  const double half = std::sqrt(normal_force);
  const double eighth = std::sqrt(std::sqrt(half));
  return half * eighth * std::sqrt(eighth);
}

/// Runs `force` (approach [m] -> normal force [N], increasing) at the prescribed approach, or searches the
/// approach for the prescribed load: secant steps kept inside the bracket of what is known, bisection where
/// they leave it. The last call of `force` is at the approach returned. Fills approach, normal_force,
/// stiffness and iterations of the solution. `start` > 0: first guess of the approach; `ceiling`: the deepest
/// the gap describes.
///
/// WRC_ERROR_LOAD when the ceiling cannot carry the load, WRC_FLAG_ITERATION_CAP when the cap ended the
/// search: the patch is then that of the last trial.
template <class Force>
Fault search_approach(const NormalProblem& problem, double start, double ceiling, Force&& force,
                      NormalSolution& solution) noexcept {
  constexpr double probe = 1e-4;  // relative step of a stiffness that no two iterates give
  const bool load = problem.prescribed == Prescribed::load;
  const auto settle = [&](double approach) {
    const double beside = force(approach * (1.0 - probe));
    const double here = force(approach);
    solution.approach = approach;
    solution.normal_force = here;
    solution.stiffness = (here - beside) / (approach * probe);
    solution.iterations += 2;
  };

  if (!load) {
    if (problem.approach > ceiling)
      return {.status = WRC_ERROR_LOAD,
              .field = "approach",
              .value = problem.approach,
              .unit = "m",
              .low = 0.0,
              .high = ceiling,
              .cause = "the gap given is too narrow"};
    settle(problem.approach);
    return {};
  }

  const double target = problem.normal_force;
  const double x_target = straightened(target);
  double low = 0.0, high = ceiling;
  bool bracketed = false;
  double approach = std::min(start, ceiling);
  double previous = 0.0, x_previous = 0.0;  // the unloaded state is a point of the curve
  for (std::int32_t i = 0; i < problem.max_iterations; ++i) {
    const double normal_force = force(approach);
    ++solution.iterations;
    const double x = straightened(normal_force);
    double slope = approach != previous ? (x - x_previous) / (approach - previous) : 0.0;
    if (!(slope > 0.0)) slope = x / approach;  // a step across a merging patch may have misled the secant
    if (std::abs(normal_force - target) <= problem.force_tolerance * target) {
      const bool slope_usable = i > 0 && std::abs(approach - previous) > 1e-6 * approach;
      solution.approach = approach;
      solution.normal_force = normal_force;
      // dN/d(approach) = (16/11) (N / x) dx/d(approach)
      solution.stiffness = 16.0 / 11.0 * normal_force / x * slope;
      if (!slope_usable) settle(approach);
      return {};
    }
    if (normal_force < target) {
      if (approach >= ceiling)
        return {.status = WRC_ERROR_LOAD,
                .field = "normal_force",
                .value = target,
                .unit = "N",
                .low = 0.0,
                .high = normal_force,
                .cause = "the gap given is too narrow to carry it"};
      low = approach;
    } else {
      high = approach;
      bracketed = true;
    }
    double next = approach + (x_target - x) / slope;
    if (!bracketed) next = std::min(std::max(next, 1.001 * approach), 10.0 * approach);
    if (!bracketed && next >= ceiling) next = ceiling;
    if (bracketed && !(next > low && next < high)) next = 0.5 * (low + high);
    previous = approach;
    x_previous = x;
    approach = next;
  }
  // Where a second region joins the patch, the load jumps past the target: then the larger patch is the
  // answer.
  settle(bracketed ? high : approach);
  return {.status = WRC_FLAG_ITERATION_CAP,
          .field = "max_iterations",
          .value = static_cast<double>(problem.max_iterations)};
}

}  // namespace wrc
