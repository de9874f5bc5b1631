#include "normal/penetration/load_search.hpp"

#include <algorithm>
#include <cmath>

#include "patch/material.hpp"

namespace wrc::normal {
namespace {

/// Cube root by Newton's rule from a power of two: the C library's bits are its own, and a first guess
/// decides the path of the search.
double cube_root(double x) {
  if (!(x > 0.0)) return 0.0;
  // A power of two within about a factor of two of the root, then Newton's rule.
  int exponent = 0;
  std::frexp(x, &exponent);
  double root = std::ldexp(1.0, exponent / 3);
  for (int i = 0; i < 6; ++i) root = (2.0 * root + x / (root * root)) / 3.0;
  return root;
}

}  // namespace

double first_guess(const NormalProblem& problem, double coefficient_x) noexcept {
  // (3 pi c N / 4)^2 2 A.
  const double force = 0.75 * pi * problem.material.normal_compliance() * problem.normal_force;
  return cube_root(force * force * 2.0 * coefficient_x);
}

bool join_gradually(const BeforeJump& before, double target, patch::Strips& strips) noexcept {
  // Load [N] of the strips of the patch before the jump, and of those that join it.
  double inside = 0.0, joining = 0.0;
  const auto joins = [&](std::int32_t j) {
    return strips.y[j] < before.span.y_from || strips.y[j] > before.span.y_to;
  };
  for (std::int32_t j = 0; j < strips.count; ++j)
    (joins(j) ? joining : inside) += 0.5 * pi * strips.half_length[j] * strips.peak[j] * strips.width[j];
  if (!(joining > 0.0 && inside > 0.0)) return false;
  // With a share s of the joining strips' load, the contact condition sets the pressure to the factor
  // 1 / (1 / f0 + s (1 - 1 / f0)) of that after the jump, f0 before it.
  const double rest = inside / before.normal_force;  // 1 / f0
  const double share = std::clamp((target * rest - inside) / (joining - target * (1.0 - rest)), 1e-9, 1.0);
  if (!(share >= 0.0 && share <= 1.0)) return false;
  const double factor = target / (inside + share * joining);
  // Semi-elliptic pressure of the same p / l: load like l^2.
  const double stretch = std::sqrt(share);
  for (std::int32_t j = 0; j < strips.count; ++j) {
    // All strips by the factor; those that join, by the share of their load.
    strips.peak[j] *= factor;
    if (!joins(j)) continue;
    strips.peak[j] *= stretch;
    strips.half_length[j] *= stretch;
  }
  return true;
}

Fault continue_beyond(const NormalProblem& problem, patch::Strips& strips,
                      NormalSolution& solution) noexcept {
  const bool load = problem.prescribed == Prescribed::load;
  const double deepest = solution.approach, most = solution.normal_force;
  // Slope of the line: within 1 and steepest_power times the chord. A jump just before the end is not to be
  // continued, nor a load that falls.
  const double chord = most / deepest;
  solution.stiffness = std::clamp(solution.stiffness, chord, steepest_power * chord);
  if (load) {
    solution.normal_force = problem.normal_force;
    solution.approach = deepest + (problem.normal_force - most) / solution.stiffness;
  } else {
    solution.approach = problem.approach;
    solution.normal_force = most + solution.stiffness * (problem.approach - deepest);
  }
  // Every pressure in proportion to the load.
  const double share = solution.normal_force / most;
  for (std::int32_t j = 0; j < strips.count; ++j) strips.peak[j] *= share;
  solution.peak_pressure *= share;
  return Fault::beyond_gap(
      load ? "load.normal_force" : "load.approach",
      {load ? problem.normal_force : problem.approach, load ? "N" : "m", 0.0, load ? most : deepest},
      load ? "the gap given, or config.planar.gap_limit, carries no more: continued with the last "
             "stiffness"
           : "the gap given, or config.planar.gap_limit, ends there: continued with the last stiffness; "
             "did you pass mm?");
}

void complete_solution(const patch::Strips& strips, const patch::GapMinimum& lowest, bool at_edge,
                       NormalSolution& solution, Fault& fault) noexcept {
  const patch::StripTotals sum = patch::totals(strips);
  solution.peak_pressure = sum.peak_pressure;
  solution.area = sum.area;
  solution.y_contact = lowest.y;
  if (at_edge)
    keep_worst(fault, Fault::patch_at_edge("gap", {lowest.y, "m"}, "give the gap over a wider range"));
}

}  // namespace wrc::normal
