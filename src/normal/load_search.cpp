#include "normal/load_search.hpp"

namespace wrc {
namespace {

/// Cube root by Newton's rule from a power of two: the C library's bits are its own, and a first guess
/// decides the path of the search.
double cube_root(double x) {
  if (!(x > 0.0)) return 0.0;
  int exponent = 0;
  std::frexp(x, &exponent);
  double root = std::ldexp(1.0, exponent / 3);
  for (int i = 0; i < 6; ++i) root = (2.0 * root + x / (root * root)) / 3.0;
  return root;
}

}  // namespace

double first_guess(const NormalProblem& problem, double coefficient_x) noexcept {
  const double force = 0.75 * pi * problem.material.normal_compliance() * problem.normal_force;
  return cube_root(force * force * 2.0 * coefficient_x);
}

void complete_solution(const Strips& strips, const GapMinimum& lowest, bool at_edge, NormalSolution& solution,
                       Fault& fault) noexcept {
  const StripTotals sum = totals(strips);
  solution.peak_pressure = sum.peak_pressure;
  solution.area = sum.area;
  solution.y_contact = lowest.y;
  if (at_edge)
    worsen(fault, {.status = WRC_FLAG_PATCH_AT_EDGE,
                   .field = "gap",
                   .value = lowest.y,
                   .unit = "m",
                   .cause = "give the gap over a wider range"});
}

}  // namespace wrc
