#include "transient_cells.hpp"

#include <stdexcept>

#include "library.hpp"

namespace compare {

TransientCells::TransientCells(const wrc_grid& grid, const wrc_material& either_body, double friction)
    : grid_(grid), material_(either_body), friction_(friction), pressure_(std::size_t{grid.nx} * grid.ny) {
  if (wrc_exact_transient_create(&grid_, &material_, &material_, &transient_, text_, sizeof text_) < 0)
    throw std::runtime_error(text_);
}

TransientCells::~TransientCells() { wrc_exact_transient_destroy(transient_); }

void TransientCells::press_gap(double A, double B, double load) {
  press([&](double x, double y) { return A * x * x + B * y * y; });
  const std::vector<double> gap = pressure_;
  wrc_exact_normal_problem problem = wrc_exact_normal_problem_default();
  problem.normal_force = load;
  problem.wheel_material = problem.rail_material = material_;
  problem.grid = grid_;
  problem.gap = gap.data();
  wrc_exact_normal_solution solution = sized<wrc_exact_normal_solution>();
  solution.pressure = pressure_.data();
  if (wrc_exact_normal(&problem, &solution, text_, sizeof text_) < 0) throw std::runtime_error(text_);
}

wrc_exact_rolling_solution TransientCells::step(const wrc_creepage& creepage) {
  wrc_exact_rolling_problem problem = wrc_exact_rolling_problem_default();
  problem.collocation = WRC_COLLOCATION_REFERENCE;
  problem.wheel_material = problem.rail_material = material_;
  problem.grid = grid_;
  problem.pressure = pressure_.data();
  problem.coefficient = friction_;
  problem.creepage = creepage;
  wrc_exact_rolling_solution solution = sized<wrc_exact_rolling_solution>();
  if (wrc_exact_transient_step(transient_, &problem, &solution, text_, sizeof text_) < 0)
    throw std::runtime_error(text_);
  return solution;
}

}  // namespace compare
