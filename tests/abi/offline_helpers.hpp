/// What the tests of wrc_offline.h share.
#pragma once

#include <vector>

#include "not_finite.hpp"
#include "test_config.hpp"
#include "wrc/wrc_offline.h"

namespace offline_helpers {

inline constexpr double pi = 3.14159265358979323846;

/// Calls cancelled after `allowed` reports; remembers what was reported.
struct Listener {
  int allowed = 1 << 30;
  std::vector<double> fractions;
  static int32_t hear(double fraction, void* self) {
    auto& listener = *static_cast<Listener*>(self);
    listener.fractions.push_back(fraction);
    return static_cast<int>(listener.fractions.size()) > listener.allowed ? 1 : 0;
  }
};

/// n x n cells over the box [-x, x] x [-y, y].
inline wrc_grid grid_over(double x, double y, uint32_t n) {
  wrc_grid grid = sized<wrc_grid>();
  grid.nx = grid.ny = n;
  grid.dx = 2.0 * x / n;
  grid.dy = 2.0 * y / n;
  grid.x0 = -x + 0.5 * grid.dx;
  grid.y0 = -y + 0.5 * grid.dy;
  return grid;
}

}  // namespace offline_helpers
