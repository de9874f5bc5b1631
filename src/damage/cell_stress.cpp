#include "damage/cell_stress.hpp"

#include "base/elementary.hpp"
#include "damage/load_stress.hpp"

namespace wrc::damage {
namespace {

Stress plain(const StressOf<double>& s) { return {s.xx, s.yy, s.zz, s.xy, s.yz, s.zx}; }

}  // namespace

void add(const Stress& from, double factor, Stress& to) {
  to.xx += factor * from.xx;
  to.yy += factor * from.yy;
  to.zz += factor * from.zz;
  to.xy += factor * from.xy;
  to.yz += factor * from.yz;
  to.zx += factor * from.zx;
}

void add(const CellStress& from, double factor, CellStress& to) {
  add(from.of_pressure, factor, to.of_pressure);
  add(from.of_traction_x, factor, to.of_traction_x);
  add(from.of_traction_y, factor, to.of_traction_y);
}

CellStress corner_stress(double poisson, double X, double Y, double z) {
  const CellStressOf<double> share = corner_stress_of(poisson, X, Y, z);
  return {plain(share.of_pressure), plain(share.of_traction_x), plain(share.of_traction_y)};
}

CellStress cell_stress(double poisson, double x, double y, double z, double dx, double dy) {
  CellStress sum;
  for (const double side_x : {0.5, -0.5}) {
    for (const double side_y : {0.5, -0.5}) {
      add(corner_stress(poisson, x + side_x * dx, y + side_y * dy, z), side_x * side_y > 0.0 ? 1.0 : -1.0,
          sum);
    }
  }
  return sum;
}

Stress point_force_stress(double poisson, double x, double y, double z, double normal, double along,
                          double across) {
  return plain(point_force_stress_of(poisson, x, y, z, normal, along, across));
}

}  // namespace wrc::damage
