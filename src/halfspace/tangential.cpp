#include "halfspace/tangential.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/elementary.hpp"
#include "halfspace/resample.hpp"

namespace wrc::halfspace {
namespace {

constexpr int products_of_a_step = 20;  // projected gradients' products per iteration of Newton's method

Fault capped(double residual, double tolerance) {
  return Fault::iteration_cap("solution.residual", {residual, "", 0.0, tolerance},
                              "the cap ended the iteration (problem.max_iterations, in wrc_exact_check 60)");
}

// Rigid slips of all cells where the collocation wants them. At rest no cell is ahead of another.
void find_rigid_slip(const Grid& grid, RollingProblem& problem, Rolled rolled = Rolled::forwards) {
  if (!problem.rigid_slip_x.empty()) return;
  const double ahead = rigid_slip_ahead(problem.collocation) * static_cast<double>(rolled) * grid.dx;
  const tangential::Creepage& c = problem.creepage;
  // w = (nu_x - phi y, nu_y + phi x), x ahead of the cell's centre
  for (int j = 0; j < grid.ny; ++j) {
    for (int i = 0; i < grid.nx; ++i) {
      problem.rigid_slip_x.push_back(c.longitudinal - c.spin * grid.y(j));
      problem.rigid_slip_y.push_back(c.lateral + c.spin * (grid.x(i) + ahead));
    }
  }
}

// Traction bound of a cell in contact [Pa].
double bound_of(const RollingProblem& problem, std::size_t at) {
  if (problem.adhesion == Adhesion::full) return std::numeric_limits<double>::infinity();
  return (problem.friction.size() == 1 ? problem.friction[0] : problem.friction[at]) * problem.pressure[at];
}

// One grid's problem, whose rigid slips are given, for RollingNewton. Tractions in `solution` are the start
// and the result.
struct OnGrid {
  static constexpr int max_products = 100;

  const Grid& grid;
  TurnedConvolution& convolution;
  const RollingProblem& problem;
  RollingSolution& solution;

  int nx = grid.nx, ny = grid.ny;
  const Field &rigid_x = problem.rigid_slip_x, &rigid_y = problem.rigid_slip_y;
  Field &px = solution.traction_x, &py = solution.traction_y, &sx = solution.slip_x, &sy = solution.slip_y;
  std::vector<tangential::CellState>& state = solution.state;
  Field bound = Field(grid.cells(), 0.0), x = bound, y = bound;
  std::vector<tangential::NewtonCell> cells = std::vector<tangential::NewtonCell>(grid.cells());
  std::vector<tangential::NewtonRow> rows =
      std::vector<tangential::NewtonRow>(static_cast<std::size_t>(grid.ny));
  std::unique_ptr<double[]> vectors = {};
  std::unique_ptr<float[]> factors = {};
  double spring = problem.layer.flexibility / grid.dx;  // slip by the layer per difference of traction [1/Pa]
  Field own_x = {}, own_y = {};                         // tractions that are turned into slips

  // the layer's spring: a cell's own traction, less that of the cell ahead
  double of_spring(int m) const { return m == 0 ? spring : m == -1 ? -spring : 0.0; }
  double xx(int m) const {
    return convolution.planar().xx(m, 0) + of_spring(m);
  }  // in a row nothing is turned
  double yy(int m) const { return convolution.planar().yy(m, 0) + of_spring(m); }
  void slip() {
    if (spring > 0.0) {
      own_x = x;
      own_y = y;
    }
    convolution.tangential(x, y);
    ++solution.products;
    if (spring > 0.0) add_spring();
  }
  void add_spring();
  double follow_flow();

  // False if cancelled. Its share of the whole work lies between `begun` and `done`.
  bool solve(double tolerance, double begun, double done);
};

// Adds the slip by the layer's spring: F (p(x) - p(x + dx)) / dx; from the leading edge to the first cell's
// place, but on the reference program's grid, over that distance.
void OnGrid::add_spring() {
  const double behind = traction_behind(problem.collocation),
               first = behind > 0.0 ? 1.0 / (0.5 + behind) : 1.0;
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) {
      const std::size_t at = grid.index(i, j);
      const bool ahead = i + 1 < nx && bound[at + 1] > 0.0;
      x[at] += spring * (ahead ? own_x[at] - own_x[at + 1] : first * own_x[at]);
      y[at] += spring * (ahead ? own_y[at] - own_y[at + 1] : first * own_y[at]);
    }
  }
}

// Bounds by the flow along each row at the present tractions and slips. Returns by how much they moved, over
// their own size (2-norms over the cells).
//
// A cell would carry z = |p - s dx / C| if it stuck, C its compliance, and more by as much as the bound of
// the cell ahead has risen: it flows by C (z - tau), less the share that the rise of tau takes. It is exact
// for springs. C of the bodies lies between that of one cell alone and that of the row; half of the latter
// makes the fixed point contract.
double OnGrid::follow_flow() {
  const tangential::Layer& layer = problem.layer;
  double moved = 0.0, all = 0.0;
  for (int j = 0; j < ny; ++j) {
    int in_contact = 0;
    for (int i = 0; i < nx; ++i) in_contact += problem.pressure[grid.index(i, j)] > 0.0 ? 1 : 0;
    const double compliance = layer.flexibility + 0.15 * in_contact * grid.dx * (xx(0) - spring);
    double yield = layer.yield,
           ahead = 0.0;  // tau of the particle, fresh at the leading edge; bound's change
    for (int i = nx; i-- > 0;) {
      const std::size_t at = grid.index(i, j);
      if (problem.pressure[at] <= 0.0) continue;
      const double most = bound_of(problem, at), per = grid.dx / compliance;
      if (yield < most) {
        const double zx = px[at] - sx[at] * per, zy = py[at] - sy[at] * per;
        const double over = std::max(0.0, std::sqrt(zx * zx + zy * zy) + ahead - yield);
        const double slope = std::max(layer.hardening, -0.5 / compliance);
        yield += slope * compliance * over / (1.0 + slope * compliance);
        yield = std::clamp(yield, std::min(most, tangential::least_yield * layer.yield), most);
      }
      const double limit = std::min(most, yield);
      ahead = limit - bound[at];
      moved += ahead * ahead;
      all += limit * limit;
      bound[at] = limit;
    }
  }
  return tangential::relative_residual(moved, all);
}

bool OnGrid::solve(double tolerance, double begun, double done) {
  // traction bounds g = mu p_n [Pa], and the sizes that Newton's method needs: cells that can carry traction,
  // and factors of each row's own equations
  const bool yields = problem.layer.yield > 0.0 && problem.adhesion == Adhesion::coulomb;
  std::size_t with_traction = 0, of_factors = 0;
  for (int j = 0; j < ny; ++j) {
    std::size_t of_row = 0;
    for (int i = 0; i < nx; ++i) {
      const std::size_t at = grid.index(i, j);
      if (problem.pressure[at] > 0.0) bound[at] = bound_of(problem, at);
      if (yields) bound[at] = std::min(bound[at], problem.layer.yield);
      if (bound[at] > 0.0) ++of_row;
    }
    with_traction += of_row;
    of_factors += tangential::newton_factors(of_row);
  }
  // Not cleared: pages that are never written take no memory.
  vectors.reset(new double[tangential::newton_vectors(with_traction, max_products)]);
  factors.reset(new float[of_factors]);
  // Coulomb: solved loosely, as the next step moves the adhesion area anyway; full adhesion is one linear
  // system.
  const double accuracy = problem.adhesion == Adhesion::full ? 0.1 * problem.tolerance : 1e-2;
  tangential::RollingNewton newton(*this, {tolerance, accuracy, problem.max_iterations, max_products});
  // progress: decades of the residual on its way to the tolerance
  const auto goes_on = [&](double residual) {
    const double decades = natural_log(std::max(residual, tolerance)) / natural_log(tolerance);
    return problem.progress.goes_on(begun + (done - begun) * std::clamp(decades, 0.0, 1.0));
  };
  // with a layer that hardens or softens also its bounds, until they stay
  tangential::NewtonEnd end = newton.solve(goes_on);
  solution.iterations = newton.iterations();
  double moved = 0.0;
  for (int n = 0; yields && end == tangential::NewtonEnd::solved; ++n) {
    moved = follow_flow();
    if (moved <= tolerance) break;
    if (n == problem.max_iterations)
      end = tangential::NewtonEnd::capped;
    else
      end = newton.solve(goes_on);
    solution.iterations += newton.iterations();
  }
  solution.residual = std::max(newton.residual(), moved);
  if (end == tangential::NewtonEnd::capped) solution.fault = capped(solution.residual, tolerance);
  // no slip where there is no contact; cells in contact without friction slip, whatever Newton's method has
  // not told
  for (std::size_t at = 0; at < bound.size(); ++at) {
    if (problem.pressure[at] <= 0.0) {
      sx[at] = sy[at] = 0.0;
    } else if (bound[at] <= 0.0) {
      state[at] = tangential::CellState::slip;
    }
  }
  return end != tangential::NewtonEnd::cancelled;
}

// One step of rolling that is not steady. Its slips are the gradient of
//     E(p) = 1/2 p.A p + w'.p,  A the displacements of tractions over dx, symmetric and positive,
// w' the rigid slip and the slip from earlier displacements, and its solution is where E is least with |p| <=
// g in every cell. Spectral projected gradients find it (Birgin, Martinez, Raydan, SIAM J. Optim. 10, 2000):
// steps of Barzilai and Borwein's length, cut back onto the disks, halved in effect by an exact search
// wherever E would exceed its largest of the last few steps. Newton's moving adhesion area goes round in
// circles here: cells act on their neighbours with one sign.
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
    cells_.push_back({at, problem.rigid_slip_x[at], problem.rigid_slip_y[at], bound_of(problem, at)});
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
  s.fault = capped(s.residual, problem_.tolerance);
  return true;
}

// Forces, moment, power and adhesion area from the fields.
void finish(const Grid& grid, const RollingProblem& problem, RollingSolution& s,
            Rolled rolled = Rolled::forwards) {
  const double shift = -traction_behind(problem.collocation) * static_cast<double>(rolled) * grid.dx;
  const bool by_cell = !problem.rigid_slip_x.empty();
  // F = sum p dA, M_z = sum (x p_y - y p_x) dA at the collocated places, P / V = -sum p . s dA
  double fx = 0.0, fy = 0.0, mz = 0.0, power = 0.0, balance = 0.0;
  std::size_t contact = 0, adhesion = 0;
  for (int j = 0; j < grid.ny; ++j) {
    for (int i = 0; i < grid.nx; ++i) {
      const std::size_t at = grid.index(i, j);
      if (problem.pressure[at] <= 0.0) continue;
      const double px = s.traction_x[at], py = s.traction_y[at];
      fx += px;
      fy += py;
      mz += (grid.x(i) + shift) * py - grid.y(j) * px;
      power -= px * s.slip_x[at] + py * s.slip_y[at];
      if (by_cell) balance -= px * problem.rigid_slip_x[at] + py * problem.rigid_slip_y[at];
      ++contact;
      if (s.state[at] == tangential::CellState::adhesion) ++adhesion;
    }
  }
  const double area = grid.cell_area();
  s.forces = {.fx = fx * area, .fy = fy * area, .mz = mz * area, .power_per_speed = power * area};
  if (contact > 0) s.forces.adhesion_fraction = static_cast<double>(adhesion) / static_cast<double>(contact);
  const tangential::Creepage& c = problem.creepage;
  // by the balance of steady rolling: the rigid slips' work, of creepages -(F_x nu_x + F_y nu_y + M_z phi)
  s.power_by_balance = by_cell
                           ? balance * area
                           : -(s.forces.fx * c.longitudinal + s.forces.fy * c.lateral + s.forces.mz * c.spin);
}

// The problem on a coarser grid: pressure and traction bound are averaged.
RollingProblem restricted(const Grid& fine, const RollingProblem& problem, const Grid& coarse) {
  RollingProblem out = problem;
  out.pressure = average(fine, problem.pressure, coarse);
  if (!problem.rigid_slip_x.empty()) {
    out.rigid_slip_x = average(fine, problem.rigid_slip_x, coarse);
    out.rigid_slip_y = average(fine, problem.rigid_slip_y, coarse);
  }
  if (problem.friction.size() > 1) {
    // mu is averaged with the pressure, so that the coarse bound is the mean of the fine ones
    Field bound = problem.pressure;
    for (std::size_t k = 0; k < bound.size(); ++k) bound[k] *= problem.friction[k];
    out.friction = average(fine, bound, coarse);
    for (std::size_t k = 0; k < out.friction.size(); ++k) {
      if (out.pressure[k] > 0.0) out.friction[k] /= out.pressure[k];
    }
  }
  return out;
}

// Start on the fine grid. Interpolated are tractions over pressures, which vary smoothly up to the edge.
void prolong(const Grid& coarse, const RollingProblem& coarse_problem, const RollingSolution& from,
             const Grid& fine, const RollingProblem& problem, RollingSolution& to) {
  // p_t / p_n on the coarse grid's contact
  Field share_x = from.traction_x, share_y = from.traction_y;
  for (std::size_t k = 0; k < share_x.size(); ++k) {
    if (coarse_problem.pressure[k] <= 0.0) continue;
    share_x[k] /= coarse_problem.pressure[k];
    share_y[k] /= coarse_problem.pressure[k];
  }
  // times the fine pressure, zero outside the fine contact
  to.traction_x = interpolate(coarse, share_x, coarse_problem.pressure, fine);
  to.traction_y = interpolate(coarse, share_y, coarse_problem.pressure, fine);
  for (std::size_t k = 0; k < to.traction_x.size(); ++k) {
    to.traction_x[k] *= std::max(problem.pressure[k], 0.0);
    to.traction_y[k] *= std::max(problem.pressure[k], 0.0);
  }
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

void clear(const Grid& grid, RollingSolution& s) {
  for (Field* field : {&s.traction_x, &s.traction_y, &s.slip_x, &s.slip_y}) field->assign(grid.cells(), 0.0);
  s.state.assign(grid.cells(), tangential::CellState::exterior);
}

// The pressure of the cells in contact.
Field compressive(const Field& pressure) {
  Field out = pressure;
  for (double& p : out) p = std::max(p, 0.0);
  return out;
}

Fault check(const Grid& grid, const RollingProblem& problem) {
  // fields over the grid, of finite numbers
  if (problem.pressure.size() != grid.cells()) {
    return Fault::range("halfspace.pressure.size", {problem.pressure.size()});
  }
  for (const double p : problem.pressure) {
    if (!std::isfinite(p)) return Fault::not_finite("halfspace.pressure", {p});
  }
  const tangential::Creepage& c = problem.creepage;
  if (!std::isfinite(c.longitudinal + c.lateral + c.spin)) {
    return Fault::not_finite("creepage");
  }
  // both or none, over the grid
  for (const Field* slip : {&problem.rigid_slip_x, &problem.rigid_slip_y}) {
    if (slip->size() != problem.rigid_slip_x.size() || (!slip->empty() && slip->size() != grid.cells())) {
      return Fault::range("halfspace.rigid_slip.size", {slip->size()});
    }
    for (const double w : *slip) {
      if (!std::isfinite(w)) return Fault::not_finite("halfspace.rigid_slip", {w});
    }
  }
  if (problem.start != nullptr && problem.start->traction_x.size() != grid.cells()) {
    return Fault::range("halfspace.start.size", {problem.start->traction_x.size()});
  }
  if (!(problem.tolerance > 0.0 && problem.tolerance < 1.0))
    return Fault::range("halfspace.tolerance", {problem.tolerance});
  if (problem.adhesion == Adhesion::full) return {};
  // one coefficient or one per cell, none of them negative
  if (problem.friction.size() != 1 && problem.friction.size() != grid.cells()) {
    return Fault::range("halfspace.friction.size", {problem.friction.size()});
  }
  for (const double mu : problem.friction) {
    if (!(mu >= 0.0 && std::isfinite(mu))) return Fault::range("halfspace.friction", {mu});
  }
  return {};
}

}  // namespace

RollingSolver::RollingSolver(const Grid& grid, const patch::Material& material, const Field& angles,
                             double coupling) {
  if (coupling != 0.0)
    pressed_ = std::make_unique<TurnedConvolution>(grid, material, Convolution::Kernel::coupling_slip, angles,
                                                   coupling);
  // grids of half as many cells each way, as long as the shorter side keeps enough of them
  constexpr int coarsest = 12;  // cells along the shorter side
  Field a = angles;
  for (Grid g = grid;;) {
    levels_.push_back({g, TurnedConvolution(g, material, Convolution::Kernel::tangential, a)});
    if (std::min(g.nx, g.ny) < 2 * coarsest) break;
    const Grid next = coarsened(g);
    a = row_values(g, a, next);
    g = next;
  }
}

RollingSolution RollingSolver::solve(const RollingProblem& problem) {
  const Grid& grid = levels_[0].grid;
  if (const Fault fault = check(grid, problem); fault.failed()) {
    RollingSolution failed;
    clear(grid, failed);
    failed.fault = fault;
    return failed;
  }
  if (!pressed_) return solve_uncoupled(problem);
  // w less the slip that the pressure causes: K/(pi G) d/dx of sum p (x, y) / r^2 (Kalker's K)
  RollingProblem with = problem;
  Field x(grid.cells(), 0.0), y = compressive(problem.pressure);
  pressed_->tangential(x, y);
  find_rigid_slip(grid, with);
  for (std::size_t k = 0; k < x.size(); ++k) {
    with.rigid_slip_x[k] -= x[k];
    with.rigid_slip_y[k] -= y[k];
  }
  return solve_uncoupled(with);
}

RollingSolution RollingSolver::solve_uncoupled(const RollingProblem& problem) {
  // the problem on ever coarser grids, where there is no start: linear theory needs none, it is one system
  std::vector<RollingProblem> problems{problem};
  if (problem.adhesion == Adhesion::coulomb && problem.start == nullptr) {
    for (std::size_t l = 1; l < levels_.size(); ++l) {
      problems.push_back(restricted(levels_[l - 1].grid, problems.back(), levels_[l].grid));
    }
  }
  RollingSolution coarse, solution;
  for (std::size_t l = problems.size(); l-- > 0;) {
    Level& level = levels_[l];
    solution = {};
    clear(level.grid, solution);
    // start: from the coarser grid, or the caller's, or zero
    if (l + 1 < problems.size()) {
      prolong(levels_[l + 1].grid, problems[l + 1], coarse, level.grid, problems[l], solution);
    } else if (problem.start != nullptr) {
      solution.traction_x = problem.start->traction_x;
      solution.traction_y = problem.start->traction_y;
    }
    constexpr double coarse_tolerance = 1e-2;
    find_rigid_slip(level.grid, problems[l]);
    // Work goes with the cells: a quarter of it on each coarser grid.
    const bool coarsest = l + 1 == problems.size();
    // progress from the coarsest grid's share to the finest's
    const double done = std::ldexp(1.0, -2 * static_cast<int>(l));
    const double begun = coarsest ? 0.0 : done / 4.0;
    if (!OnGrid{level.grid, level.convolution, problems[l], solution}.solve(
            l == 0 ? problem.tolerance : std::max(problem.tolerance, coarse_tolerance), begun, done)) {
      clear(level.grid, solution);
      solution.fault = Fault::cancelled();
      return solution;
    }
    if (l > 0) coarse = std::move(solution);
  }
  finish(levels_[0].grid, problem, solution);
  return solution;
}

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
  clear(grid_, solution);
  solution.fault = check(grid_, problem);
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
    clear(grid_, solution);
    solution.fault = Fault::cancelled();
    return solution;
  }
  finish(grid_, problem, solution, rolled);
  // the bodies' state at the next step's beginning
  traction_x_ = solution.traction_x;
  traction_y_ = solution.traction_y;
  pressure_ = compressive(problem.pressure);
  return solution;
}

}  // namespace wrc::halfspace
