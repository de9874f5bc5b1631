#include "halfspace/rolling_problem.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wrc::halfspace {

Fault rolling_capped(double residual, double tolerance) {
  return Fault::iteration_cap("solution.residual", {residual, "", 0.0, tolerance},
                              "the cap ended the iteration (problem.max_iterations, in wrc_exact_check 60)");
}

void find_rigid_slip(const Grid& grid, RollingProblem& problem, Rolled rolled) {
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

double traction_bound(const RollingProblem& problem, std::size_t at) {
  if (problem.adhesion == Adhesion::full) return std::numeric_limits<double>::infinity();
  return (problem.friction.size() == 1 ? problem.friction[0] : problem.friction[at]) * problem.pressure[at];
}

void sum_forces(const Grid& grid, const RollingProblem& problem, RollingSolution& s, Rolled rolled) {
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

void clear_solution(const Grid& grid, RollingSolution& s) {
  for (Field* field : {&s.traction_x, &s.traction_y, &s.slip_x, &s.slip_y}) field->assign(grid.cells(), 0.0);
  s.state.assign(grid.cells(), tangential::CellState::exterior);
}

Field compressive(const Field& pressure) {
  Field out = pressure;
  for (double& p : out) p = std::max(p, 0.0);
  return out;
}

Fault check_rolling(const Grid& grid, const RollingProblem& problem) {
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

}  // namespace wrc::halfspace
