#include "halfspace/normal.hpp"

#include <algorithm>
#include <cmath>

#include "base/elementary.hpp"

namespace wrc::halfspace {
namespace {

double sum(const Field& f) {
  double total = 0.0;
  for (const double v : f) total += v;
  return total;
}

// Mean of f over the cells in contact.
double contact_mean(const Field& f, const Field& pressure) {
  double total = 0.0;
  std::size_t count = 0;
  for (std::size_t k = 0; k < f.size(); ++k) {
    if (pressure[k] <= 0.0) continue;
    total += f[k];
    ++count;
  }
  return count > 0 ? total / static_cast<double>(count) : 0.0;
}

double contact_product(const Field& a, const Field& b, const Field& pressure) {
  double total = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (pressure[k] > 0.0) total += a[k] * b[k];
  }
  return total;
}

Fault check(const Grid& grid, const GapProblem& problem) {
  if (problem.gap.size() != grid.cells()) {
    return Fault::gap("halfspace.gap.size", {problem.gap.size()});
  }
  for (const double h : problem.gap) {
    if (!std::isfinite(h)) return Fault::not_finite("halfspace.gap", {h});
  }
  if (problem.prescribed == Prescribed::load &&
      !(problem.normal_force > 0.0 && std::isfinite(problem.normal_force))) {
    return Fault::load("load.normal_force", {problem.normal_force, "N"});
  }
  if (problem.prescribed == Prescribed::approach && !std::isfinite(problem.approach)) {
    return Fault::not_finite("load.approach", {problem.approach, "m"});
  }
  return {};
}

// Adds up the solution; flags a contact that reaches the border of the grid, where the gap ends.
void finish(const Grid& grid, GapSolution& s) {
  for (int j = 0; j < grid.ny; ++j) {
    for (int i = 0; i < grid.nx; ++i) {
      const double p = s.pressure[grid.index(i, j)];
      if (p <= 0.0) continue;
      s.area += grid.cell_area();
      s.normal_force += p * grid.cell_area();
      s.peak_pressure = std::max(s.peak_pressure, p);
      if (i == 0 || j == 0 || i == grid.nx - 1 || j == grid.ny - 1) {
        keep_worst(s.fault, Fault::patch_at_edge());
      }
    }
  }
  if (s.area == 0.0) keep_worst(s.fault, Fault::no_contact());
}

}  // namespace

NormalSolver::NormalSolver(const Grid& grid, const Material& material, const Field& angles)
    : grid_(grid), convolution_(grid, material, Convolution::Kernel::normal, angles) {}

GapSolution NormalSolver::solve(const GapProblem& problem) {
  GapSolution s;
  const std::size_t n = grid_.cells();
  s.pressure.assign(n, 0.0);
  s.fault = check(grid_, problem);
  if (s.fault.failed()) return s;

  const bool by_load = problem.prescribed == Prescribed::load;
  const double pressure_sum = problem.normal_force / grid_.cell_area();
  const double lowest = *std::min_element(problem.gap.begin(), problem.gap.end());
  const double highest = *std::max_element(problem.gap.begin(), problem.gap.end());
  Field& p = s.pressure;
  Field displacement(n), error(n), direction(n, 0.0), image(n);
  const double own_influence = convolution_.planar().xx(0, 0);
  // Start: the load everywhere on the lower half of the gap; by approach, the pressure of that order of
  // magnitude that one cell's own influence suggests.
  for (std::size_t k = 0; k < n; ++k) {
    const double overlap = problem.approach - problem.gap[k];
    if (by_load) {
      p[k] = problem.gap[k] <= 0.5 * (lowest + highest) ? 1.0 : 0.0;
    } else {
      p[k] = overlap > 0.0 ? 0.1 * overlap / own_influence : 0.0;
    }
  }
  if (by_load) {
    const double factor = pressure_sum / sum(p);
    for (double& v : p) v *= factor;
  }

  s.approach = problem.approach;
  double norm_before = 1.0;
  bool conjugate = false;
  convolution_.normal(p, displacement);
  for (s.iterations = 0;; ++s.iterations) {
    for (std::size_t k = 0; k < n; ++k) error[k] = displacement[k] + problem.gap[k];
    if (by_load) s.approach = contact_mean(error, p);
    double scale = 0.0, weighted = 0.0, total = 0.0, overlap = 0.0;
    for (std::size_t k = 0; k < n; ++k) {
      error[k] -= s.approach;
      scale = std::max(scale, displacement[k]);
      weighted += p[k] * std::abs(error[k]);
      total += p[k];
      if (p[k] <= 0.0) overlap = std::max(overlap, -error[k]);
    }
    if (total == 0.0 && overlap == 0.0) break;
    scale = std::max(scale, std::abs(s.approach - lowest));
    s.residual = std::max(total > 0.0 ? weighted / total : 0.0, overlap) / scale;
    if (s.residual <= problem.tolerance) break;
    if (s.iterations == problem.max_iterations) {
      s.fault = Fault::iteration_cap("solution.residual", {s.residual, "", 0.0, problem.tolerance},
                                     "problem.max_iterations ended the iteration");
      break;
    }
    const double decades = natural_log(std::min(1.0, s.residual)) / natural_log(problem.tolerance);
    if (!problem.progress.goes_on(std::clamp(decades, 0.0, 1.0))) {
      s = {};
      s.pressure.assign(n, 0.0);
      s.fault = Fault::cancelled();
      return s;
    }

    const double norm = contact_product(error, error, p);
    const double beta = conjugate ? norm / norm_before : 0.0;
    norm_before = norm;
    for (std::size_t k = 0; k < n; ++k) direction[k] = p[k] > 0.0 ? error[k] + beta * direction[k] : 0.0;
    convolution_.normal(direction, image);
    if (by_load) {
      const double mean = contact_mean(image, p);
      for (double& v : image) v -= mean;
    }
    const double curvature = contact_product(image, direction, p);
    // Without a descent direction in the contact (no cell, or all exact) only the overlaps remain to act on.
    const double length =
        curvature > 0.0 ? contact_product(error, direction, p) / curvature : 1.0 / own_influence;
    conjugate = true;
    for (std::size_t k = 0; k < n; ++k) {
      if (p[k] > 0.0) {
        p[k] = std::max(0.0, p[k] - length * direction[k]);
      } else if (error[k] < 0.0) {
        p[k] = -length * error[k];
        conjugate = false;
      }
    }
    if (by_load) {
      const double factor = pressure_sum / sum(p);
      for (double& v : p) v *= factor;
    }
    convolution_.normal(p, displacement);
  }
  finish(grid_, s);
  return s;
}

}  // namespace wrc::halfspace
