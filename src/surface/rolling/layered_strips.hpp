/// Strips on the rail's surface with a layer between the bodies
/// (tangential/layer/layer_march.hpp): the numbers of strip FASTSIM with the
/// layer's spring in series, as those of a patch have it (strip_fastsim.cpp).
#pragma once

#include "surface/rolling/rolling_arrays.hpp"
#include "tangential/layer/layered_rolling.hpp"

namespace wrc::surface {

/// Strip j by its arrays, which fill_arrays() of strip_numbers.hpp has filled.
template <class Number, class Layer>
tangential::LayeredStripAt<Number> layered_strip(const SurfaceRollingInputOf<Number>& in,
                                                 const RollingArraysOf<Number>& a, const Layer& layer,
                                                 std::int32_t j) {
  using Of = tangential::LayeredNumbers;
  const Number l = larger(in.half_length[j], Number(least_strip_length));
  tangential::LayeredStripAt<Number> strip;
  strip.bound = a.bound[j];
  auto& n = strip.numbers.of;
  // Displacements by the bound over the half length: under the parabola half
  // the slip at its edge.
  const Number spring = layer.flexibility * strip.bound / l;
  n[Of::bodies_x] = 0.5 * a.edge_x[j];
  n[Of::bodies_y] = 0.5 * a.edge_y[j];
  n[Of::spring_x] = spring;
  n[Of::spring_y] = spring;
  n[Of::turn_x] = a.turn_x[j];
  n[Of::turn_y] = a.turn_y[j];
  // slips: of linear theory and of kinematics, as bodies and layer give way;
  // along y they grow by 2 curvature
  n[Of::slip_x] = a.slip_x[j];
  n[Of::slip_y] = a.slip_y[j];
  n[Of::slip_turn] = in.spin[j] * l;
  n[Of::stick_x] = tangential::slip_in_series<Number>(n[Of::bodies_x], n[Of::bodies_x] * a.growth_x[j],
                                                      spring, in.slip_x[j]);
  n[Of::stick_y] = tangential::slip_in_series<Number>(n[Of::bodies_y], n[Of::bodies_y] * a.growth_y[j],
                                                      spring, in.slip_y[j]);
  n[Of::stick_turn] = tangential::slip_in_series<Number>(
      n[Of::bodies_y], 2.0 * (n[Of::bodies_y] * a.curvature[j]), spring, n[Of::slip_turn]);
  set_yield(layer, Number(1.0), l, strip);
  return strip;
}

/// Marches over strips that `strip_of` gives; power is that of forces and rigid
/// slips.
template <class StripOf>
SurfaceRollingTotals roll_layered(const SurfaceRollingInput& in, bool parabolic,
                                  const tangential::TangentialFields& fields,
                                  const SurfaceRollingForces& forces, const StripOf& strip_of) {
  const tangential::LayeredRun run{in.count,       in.width,
                                   in.half_length, parabolic ? in.grid->parabolic : in.grid->elliptic,
                                   *in.grid,       fields};
  double work = 0.0;
  const tangential::LayeredTotals totals =
      march_all(run, strip_of, [&](std::int32_t j, double fx, double fy, double mz) {
        forces.fx[j] = fx;
        forces.fy[j] = fy;
        forces.mz[j] = mz;
        work -= fx * in.slip_x[j] + fy * in.slip_y[j] + mz * in.spin[j];
      });
  return {balanced_power(run, totals, work), totals.adhesion_fraction()};
}

}  // namespace wrc::surface
