#include "halfspace/tangential.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/elementary.hpp"
#include "halfspace/resample.hpp"

namespace wrc::halfspace {
namespace {

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
      const double most = traction_bound(problem, at), per = grid.dx / compliance;
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
      if (problem.pressure[at] > 0.0) bound[at] = traction_bound(problem, at);
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
  if (end == tangential::NewtonEnd::capped) solution.fault = rolling_capped(solution.residual, tolerance);
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
  if (const Fault fault = check_rolling(grid, problem); fault.failed()) {
    RollingSolution failed;
    clear_solution(grid, failed);
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
    clear_solution(level.grid, solution);
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
      clear_solution(level.grid, solution);
      solution.fault = Fault::cancelled();
      return solution;
    }
    if (l > 0) coarse = std::move(solution);
  }
  sum_forces(levels_[0].grid, problem, solution);
  return solution;
}

}  // namespace wrc::halfspace
