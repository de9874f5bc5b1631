#include "halfspace/normal.hpp"

#include <algorithm>
#include <cmath>

#include "base/elementary.hpp"

namespace wrc::halfspace {
namespace {

// Scales a pressure to the sum given: every iterate carries the load.
void scale_to(double pressure_sum, Field& pressure) {
  double total = 0.0;
  for (const double p : pressure) total += p;
  const double factor = pressure_sum / total;
  for (double& p : pressure) p *= factor;
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

// Sum of a b over the cells in contact.
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
  // the load or the approach, whichever is prescribed; a load must press
  if (problem.prescribed == normal::Prescribed::load &&
      !(problem.normal_force > 0.0 && std::isfinite(problem.normal_force))) {
    return Fault::load("load.normal_force", {problem.normal_force, "N"});
  }
  if (problem.prescribed == normal::Prescribed::approach && !std::isfinite(problem.approach)) {
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

// Conjugate gradients over the cells in contact. e = h + u(p) - delta is the gradient, d the direction, A the
// convolution; a prescribed load takes the means of e and of A d over the contact away, which leaves its sum.
class BoundedGradients {
 public:
  // The solution's pressure is the iterate.
  BoundedGradients(const GapProblem& problem, double pressure_sum, TurnedConvolution& convolution,
                   GapSolution& solution)
      : problem_(problem),
        by_load_(problem.prescribed == normal::Prescribed::load),
        pressure_sum_(pressure_sum),
        own_influence_(convolution.planar().xx(0, 0)),
        lowest_(*std::min_element(problem.gap.begin(), problem.gap.end())),
        convolution_(convolution),
        s_(solution),
        displacement_(problem.gap.size()),
        error_(problem.gap.size()),
        direction_(problem.gap.size(), 0.0),
        image_(problem.gap.size()) {}

  void begin();
  // Updates e, delta and the residual; true: nothing is left to do.
  bool converged();
  void step();

 private:
  const GapProblem& problem_;
  bool by_load_;
  double pressure_sum_;   // sum over the cells under a prescribed load [Pa]
  double own_influence_;  // displacement of a cell under its own pressure [m/Pa]
  double lowest_;         // smallest gap [m]
  TurnedConvolution& convolution_;
  GapSolution& s_;
  Field displacement_, error_;  // u_z, e [m]
  Field direction_, image_;     // d [m], A d [m^2/Pa]
  double norm_before_ = 1.0;    // e . e of the step before [m^2]
  bool conjugate_ = false;      // the contact has not changed since the last direction
};

void BoundedGradients::begin() {
  // By load: the same pressure everywhere on the lower half of the gap; by approach: of that order of
  // magnitude that one cell's own influence suggests.
  const double highest = *std::max_element(problem_.gap.begin(), problem_.gap.end());
  Field& p = s_.pressure;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const double overlap = problem_.approach - problem_.gap[k];
    if (by_load_) {
      p[k] = problem_.gap[k] <= 0.5 * (lowest_ + highest) ? 1.0 : 0.0;
    } else {
      p[k] = overlap > 0.0 ? 0.1 * overlap / own_influence_ : 0.0;
    }
  }
  if (by_load_) scale_to(pressure_sum_, p);
  s_.approach = problem_.approach;
  convolution_.normal(p, displacement_);
}

bool BoundedGradients::converged() {
  const Field& p = s_.pressure;
  const std::size_t n = p.size();
  // e = h + u - delta; of a prescribed load delta is where e vanishes in the mean over the contact
  for (std::size_t k = 0; k < n; ++k) error_[k] = displacement_[k] + problem_.gap[k];
  if (by_load_) s_.approach = contact_mean(error_, p);
  // mean of |e| weighted by the pressure, and the largest overlap outside, over the largest displacement
  double scale = 0.0, weighted = 0.0, total = 0.0, overlap = 0.0;
  for (std::size_t k = 0; k < n; ++k) {
    error_[k] -= s_.approach;
    scale = std::max(scale, displacement_[k]);
    weighted += p[k] * std::abs(error_[k]);
    total += p[k];
    if (p[k] <= 0.0) overlap = std::max(overlap, -error_[k]);
  }
  if (total == 0.0 && overlap == 0.0) return true;
  scale = std::max(scale, std::abs(s_.approach - lowest_));
  s_.residual = std::max(total > 0.0 ? weighted / total : 0.0, overlap) / scale;
  return s_.residual <= problem_.tolerance;
}

void BoundedGradients::step() {
  Field& p = s_.pressure;
  const std::size_t n = p.size();
  // d = e + beta d, beta = (e . e) / (e . e before) (Fletcher and Reeves), 0 after a cell has come into
  // contact
  const double norm = contact_product(error_, error_, p);
  const double beta = conjugate_ ? norm / norm_before_ : 0.0;
  norm_before_ = norm;
  for (std::size_t k = 0; k < n; ++k) direction_[k] = p[k] > 0.0 ? error_[k] + beta * direction_[k] : 0.0;
  convolution_.normal(direction_, image_);
  if (by_load_) {
    const double mean = contact_mean(image_, p);
    for (double& v : image_) v -= mean;
  }
  // Step length tau = (e . d) / (d . A d). Without a descent direction in the contact (no cell, or all exact)
  // only the overlaps remain to act on.
  const double curvature = contact_product(image_, direction_, p);
  const double length =
      curvature > 0.0 ? contact_product(error_, direction_, p) / curvature : 1.0 / own_influence_;
  // p - tau d, not below zero: cells leave. Cells outside that overlap enter with -tau e.
  conjugate_ = true;
  for (std::size_t k = 0; k < n; ++k) {
    if (p[k] > 0.0) {
      p[k] = std::max(0.0, p[k] - length * direction_[k]);
    } else if (error_[k] < 0.0) {
      p[k] = -length * error_[k];
      conjugate_ = false;
    }
  }
  if (by_load_) scale_to(pressure_sum_, p);
  convolution_.normal(p, displacement_);
}

}  // namespace

NormalSolver::NormalSolver(const Grid& grid, const patch::Material& material, const Field& angles)
    : grid_(grid), convolution_(grid, material, Convolution::Kernel::normal, angles) {}

GapSolution NormalSolver::solve(const GapProblem& problem) {
  // a problem that cannot be solved leaves zero pressure
  GapSolution s;
  s.pressure.assign(grid_.cells(), 0.0);
  s.fault = check(grid_, problem);
  if (s.fault.failed()) return s;
  BoundedGradients gradients(problem, problem.normal_force / grid_.cell_area(), convolution_, s);
  gradients.begin();
  for (; !gradients.converged(); ++s.iterations) {
    if (s.iterations == problem.max_iterations) {
      s.fault = Fault::iteration_cap("solution.residual", {s.residual, "", 0.0, problem.tolerance},
                                     "problem.max_iterations ended the iteration");
      break;
    }
    // progress: decades of the residual on its way to the tolerance
    const double decades = natural_log(std::min(1.0, s.residual)) / natural_log(problem.tolerance);
    if (!problem.progress.goes_on(std::clamp(decades, 0.0, 1.0))) {
      s = {};
      s.pressure.assign(grid_.cells(), 0.0);
      s.fault = Fault::cancelled();
      return s;
    }
    gradients.step();
  }
  finish(grid_, s);
  return s;
}

}  // namespace wrc::halfspace
