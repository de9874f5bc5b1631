/// What sequences of steps share, whether they come from memory_kind.cpp or transient_kind.cpp: the exact
/// solver on cells, and the model of the strips that remember.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "test_config.hpp"
#include "wrc/wrc_offline.h"

namespace compare {

inline constexpr double pi = 3.14159265358979323846;

/// wrc_exact_transient_step() on a grid, with the pressure of the present load. Failures are thrown as their
/// sentence.
class TransientCells {
 public:
  TransientCells(const wrc_grid& grid, const wrc_material& either_body, double friction);
  TransientCells(const TransientCells&) = delete;
  TransientCells& operator=(const TransientCells&) = delete;
  ~TransientCells();

  const wrc_grid& grid() const { return grid_; }
  /// Presses with value(x, y) in the middle of each cell [Pa].
  template <class Value>
  void press(Value value) {
    for (std::uint32_t j = 0, k = 0; j < grid_.ny; ++j)
      for (std::uint32_t i = 0; i < grid_.nx; ++i, ++k)
        pressure_[k] = value(grid_.x0 + i * grid_.dx, grid_.y0 + j * grid_.dy);
  }
  /// Presses with Hertz's pressure of a load [N] on an ellipse.
  void press_ellipse(double a, double b, double load) {
    const double peak = 1.5 * load / (pi * a * b);
    press([&](double x, double y) {
      return peak * std::sqrt(std::fmax(0.0, 1.0 - x * x / (a * a) - y * y / (b * b)));
    });
  }
  /// Presses bodies with the gap A x^2 + B y^2 [1/m] together by a load [N].
  void press_gap(double A, double B, double load);
  /// Rolls on by a cell.
  wrc_exact_rolling_solution step(const wrc_creepage& creepage);

 private:
  wrc_grid grid_;
  wrc_material material_;
  double friction_;
  wrc_exact_transient* transient_ = nullptr;
  std::vector<double> pressure_;
  char text_[256] = "";
};

/// Cells a / n by b / n, borders on the origin; `half` of them to each side.
inline wrc_grid grid_about(double a, double b, std::uint32_t n, std::uint32_t half) {
  wrc_grid grid = sized<wrc_grid>();
  grid.nx = grid.ny = 2 * half;
  grid.dx = a / n;
  grid.dy = b / n;
  grid.x0 = -(half - 0.5) * grid.dx;
  grid.y0 = -(half - 0.5) * grid.dy;
  return grid;
}

/// A model whose strips remember, of two bodies of this material.
inline wrc_config non_steady_config(const wrc_material& either_body) {
  wrc_config config = test_config();
  config.wheel_material = config.rail_material = either_body;
  config.planar.non_steady = 1;
  return config;
}

}  // namespace compare
