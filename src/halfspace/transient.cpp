#include "halfspace/transient.hpp"

#include <algorithm>
#include <cmath>

#include "base/elementary.hpp"
#include "tangential/exact/rolling_newton.hpp"

namespace wrc::halfspace {
namespace {

constexpr int products_of_a_step = 20;  // projected gradients' products per iteration of Newton's method

// One step of rolling that is not steady. Its slips are the gradient of
//     E(p) = 1/2 p.A p + w'.p.
// A has the displacements of tractions over dx, and is symmetric and positive. w' is the rigid slip and the
// slip from earlier displacements. The solution is where E is least with |p| <= g in every cell. Spectral
// projected gradients find it (Birgin, Martinez, Raydan, SIAM J. Optim. 10, 2000). Their steps have Barzilai
// and Borwein's length and are cut back onto the disks. An exact search shortens them where E would exceed
// its largest of the last few steps. Newton's moving adhesion area goes round in circles here, as cells act
// on their neighbours with one sign.
class TransientStep {
 public:
  // The problem's rigid slips hold the slip from earlier displacements.
  TransientStep(const Grid& grid, TurnedConvolution& displacement, const RollingProblem& problem,
                RollingSolution& solution);

  // Iterates until the convergence test holds; false if cancelled.
  bool run();

 private:
  struct Cell {
    std::size_t at;
    double wx, wy;  // rigid slip and that of earlier displacements
    double bound;   // g [Pa]
  };
  void displace(const Field& x, const Field& y);
  double residual();

  const RollingProblem& problem_;
  RollingSolution& solution_;
  TurnedConvolution& displacement_;
  double rho_;
  std::vector<Cell> cells_;
  Field change_x_, change_y_, slip_x_, slip_y_;
};

// The point of the disk of this radius nearest to (x, y).
void into_disk(double radius, double& x, double& y) {
  // g (x, y) / |(x, y)| outside of the disk
  const double length = std::sqrt(x * x + y * y);
  if (length <= radius) return;
  x *= radius / length;
  y *= radius / length;
}

TransientStep::TransientStep(const Grid& grid, TurnedConvolution& displacement, const RollingProblem& problem,
                             RollingSolution& solution)
    : problem_(problem),
      solution_(solution),
      displacement_(displacement),
      rho_(1.0 / std::max(displacement.planar().xx(0, 0), displacement.planar().yy(0, 0))),
      change_x_(grid.cells(), 0.0),
      change_y_(grid.cells(), 0.0),
      slip_x_(grid.cells(), 0.0),
      slip_y_(grid.cells(), 0.0) {
  for (std::size_t at = 0; at < grid.cells(); ++at) {
    // the start is cut back onto the disks: earlier tractions may exceed today's bounds
    if (problem.pressure[at] <= 0.0) continue;
    cells_.push_back({at, problem.rigid_slip_x[at], problem.rigid_slip_y[at], traction_bound(problem, at)});
    into_disk(cells_.back().bound, solution.traction_x[at], solution.traction_y[at]);
  }
}

// Slip that tractions cause, into slip_x_, slip_y_.
void TransientStep::displace(const Field& x, const Field& y) {
  // s = A p, A p the displacements over dx: p goes in, the slip comes out
  slip_x_ = x;
  slip_y_ = y;
  displacement_.tangential(slip_x_, slip_y_);
  ++solution_.products;
}

// |p - P(p - rho s)| over |min(g, max(|p|, rho |w'|))|, and which cells slide.
double TransientStep::residual() {
  RollingSolution& s = solution_;
  double error = 0.0, norm = 0.0;
  for (const Cell& c : cells_) {
    // p - rho s, before and after it is cut back: outside of its disk, the cell slides
    const double px = s.traction_x[c.at], py = s.traction_y[c.at];
    double x = px - rho_ * s.slip_x[c.at], y = py - rho_ * s.slip_y[c.at];
    s.state[c.at] =
        x * x + y * y > c.bound * c.bound ? tangential::CellState::slip : tangential::CellState::adhesion;
    into_disk(c.bound, x, y);
    // numerator and denominator of the test, squared
    error += (px - x) * (px - x) + (py - y) * (py - y);
    norm += tangential::asked_squared(c.bound, px, py, rho_ * c.wx, rho_ * c.wy);
  }
  return tangential::relative_residual(error, norm);
}

bool TransientStep::run() {
  RollingSolution& s = solution_;
  // slip of the start, s = w' + A p
  displace(s.traction_x, s.traction_y);
  for (const Cell& c : cells_) {
    s.slip_x[c.at] = c.wx + slip_x_[c.at];
    s.slip_y[c.at] = c.wy + slip_y_[c.at];
  }
  // E may exceed its last value, but not its largest of the last ten (Grippo, Lampariello and Lucidi's
  // search)
  constexpr int remembered = 10;
  double energies[remembered] = {};  // relative to that of the start
  double energy = 0.0, length = rho_;
  const int cap = products_of_a_step * problem_.max_iterations;
  for (s.iterations = 0;; ++s.iterations) {
    s.residual = residual();
    if (s.residual <= problem_.tolerance) return true;
    if (s.iterations == cap) break;
    const double decades =
        natural_log(std::max(s.residual, problem_.tolerance)) / natural_log(problem_.tolerance);
    if (!problem_.progress.goes_on(std::clamp(decades, 0.0, 1.0))) return false;
    // direction d = P(p - l s) - p and the slope of E along it, s . d, which is negative
    double slope = 0.0;
    for (const Cell& c : cells_) {
      double x = s.traction_x[c.at] - length * s.slip_x[c.at],
             y = s.traction_y[c.at] - length * s.slip_y[c.at];
      into_disk(c.bound, x, y);
      change_x_[c.at] = x - s.traction_x[c.at];
      change_y_[c.at] = y - s.traction_y[c.at];
      slope += s.slip_x[c.at] * change_x_[c.at] + s.slip_y[c.at] * change_y_[c.at];
    }
    displace(change_x_, change_y_);
    // d . A d, the bend of E along d; l of the next step is (d . d) / (d . A d), Barzilai and Borwein's
    double bend = 0.0, square = 0.0;
    for (const Cell& c : cells_) {
      bend += change_x_[c.at] * slip_x_[c.at] + change_y_[c.at] * slip_y_[c.at];
      square += change_x_[c.at] * change_x_[c.at] + change_y_[c.at] * change_y_[c.at];
    }
    if (!(bend > 0.0)) break;
    // the whole of d, or where E would be too large, d's exact minimum -(s . d) / (d . A d)
    double share = 1.0;
    if (energy + slope + 0.5 * bend > *std::max_element(energies, energies + remembered))
      share = -slope / bend;
    energy += share * (slope + 0.5 * share * bend);
    energies[s.iterations % remembered] = energy;
    length = square / bend;
    // slips follow tractions without another product, as they are linear
    for (const Cell& c : cells_) {
      s.traction_x[c.at] += share * change_x_[c.at];
      s.traction_y[c.at] += share * change_y_[c.at];
      s.slip_x[c.at] += share * slip_x_[c.at];
      s.slip_y[c.at] += share * slip_y_[c.at];
    }
  }
  s.fault = rolling_capped(s.residual, problem_.tolerance);
  return true;
}

// (u(x) - u(x + r dx)) / dx of fields that `forwards` gives for r = 1, in place. Backwards it is that of the
// mirror image, in which x and components along it change their signs.
void displace_by_rolling(const Grid& grid, Rolled rolled, TurnedConvolution& forwards, Field& x, Field& y) {
  if (rolled == Rolled::at_rest) {
    x.assign(grid.cells(), 0.0);
    y.assign(grid.cells(), 0.0);
    return;
  }
  const auto mirror = [&] {
    if (rolled == Rolled::forwards) return;
    for (std::size_t row = 0; row < grid.cells(); row += static_cast<std::size_t>(grid.nx)) {
      const auto first = static_cast<std::ptrdiff_t>(row), behind = first + grid.nx;
      std::reverse(x.begin() + first, x.begin() + behind);
      std::reverse(y.begin() + first, y.begin() + behind);
    }
    for (double& along : x) along = -along;
  };
  mirror();
  forwards.tangential(x, y);
  mirror();
}

}  // namespace

TransientSolver::TransientSolver(const Grid& grid, const patch::Material& material, double coupling)
    : grid_(grid),
      displacement_(grid, material, Convolution::Kernel::shear_slip),
      steady_(grid, material, Convolution::Kernel::tangential),
      traction_x_(grid.cells(), 0.0),
      traction_y_(grid.cells(), 0.0),
      pressure_(grid.cells(), 0.0) {
  using Kernel = Convolution::Kernel;
  // like bodies move along each other under pressure by the same amount
  if (coupling == 0.0) return;
  pressed_ = std::make_unique<TurnedConvolution>(grid, material, Kernel::coupling, Field{}, coupling);
  pressed_steady_ =
      std::make_unique<TurnedConvolution>(grid, material, Kernel::coupling_slip, Field{}, coupling);
}

RollingSolution TransientSolver::step(const RollingProblem& problem, Rolled rolled) {
  RollingSolution solution;
  clear_solution(grid_, solution);
  solution.fault = check_rolling(grid_, problem);
  if (solution.fault.failed()) return solution;
  // s(x) = w + u(x) / dx - u_before(x + r dx) / dx, the last term by the displacement that rolling changed
  // and u_before(x) / dx.
  RollingProblem with = problem;
  find_rigid_slip(grid_, with, rolled);
  Field earlier_x = traction_x_, earlier_y = traction_y_, own_x = traction_x_, own_y = traction_y_;
  displace_by_rolling(grid_, rolled, steady_, earlier_x, earlier_y);
  displacement_.tangential(own_x, own_y);
  for (std::size_t k = 0; k < earlier_x.size(); ++k) {
    with.rigid_slip_x[k] += earlier_x[k] - own_x[k];
    with.rigid_slip_y[k] += earlier_y[k] - own_y[k];
    if (problem.pressure[k] <= 0.0) continue;
    solution.traction_x[k] = traction_x_[k];
    solution.traction_y[k] = traction_y_[k];
  }
  if (pressed_) {  // displaced by -C p now and, r cells ahead, by -C p before
    const std::size_t n = grid_.cells();
    const Field pressure = compressive(problem.pressure);
    Field x(n, 0.0), y(n), before_x(n, 0.0), before_y = pressure_;
    for (std::size_t k = 0; k < n; ++k) y[k] = (pressure[k] - pressure_[k]) / grid_.dx;
    pressed_->tangential(x, y);
    displace_by_rolling(grid_, rolled, *pressed_steady_, before_x, before_y);
    for (std::size_t k = 0; k < n; ++k) {
      with.rigid_slip_x[k] -= x[k] + before_x[k];
      with.rigid_slip_y[k] -= y[k] + before_y[k];
    }
  }
  if (!TransientStep(grid_, displacement_, with, solution).run()) {
    clear_solution(grid_, solution);
    solution.fault = Fault::cancelled();
    return solution;
  }
  sum_forces(grid_, problem, solution, rolled);
  // the bodies' state at the next step's beginning
  traction_x_ = solution.traction_x;
  traction_y_ = solution.traction_y;
  pressure_ = compressive(problem.pressure);
  return solution;
}

}  // namespace wrc::halfspace
