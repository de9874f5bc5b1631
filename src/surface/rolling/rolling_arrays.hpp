/// What the methods of surface_rolling.hpp share: numbers of every strip on their way.
#pragma once

#include <cstddef>

#include "surface/rolling/surface_rolling.hpp"
#include "tangential/simd/tasks.hpp"

namespace wrc {

/// Quantities of which strips take the mean over their neighbours: first times load, then the mean.
struct RollingMeans {
  enum Mean { slip, slender, edge, lateral, spin, friction, location, longitudinal, variance, means };
};

/// One element per strip, in the caller's workspace.
template <class Number>
struct RollingArraysOf : RollingMeans {
  Number* load;          ///< [N]
  Number *link, *pivot;  ///< of the means' equations [N], [1/N]
  Number* mean[means];
  Number *c11, *c22, *c23;  ///< as StripCoefficients
  Number* own;              ///< slip along x less what neighbours share (mean[slip]), by its gain [-]
  // for the kernels' tasks
  Number *bound, *growth_x, *growth_y, *curvature, *slip_x, *slip_y, *elastic, *turn_x, *turn_y, *edge_x,
      *edge_y;

  static constexpr std::size_t count = 3 + means + 4 + 11;
};
using RollingArrays = RollingArraysOf<double>;

inline constexpr double least_strip_length = 1e-9;  ///< [m]: shorter strips carry nothing

/// A kernel's task, as far as the tasks of both kernels are alike: the strips, their bounds and growths, and
/// where the results go.
template <class Task>
Task surface_task(const SurfaceRollingInput& in, const RollingArrays& a, const TangentialFields& fields,
                  const SurfaceRollingForces& forces) {
  Task task{};
  task.strips = in.count;
  task.cells = in.grid->cells;
  task.shape = &in.grid->elliptic;
  task.fields = &fields;
  task.width = in.width;
  task.half_length = in.half_length;
  task.bound = a.bound;
  task.growth_x = a.growth_x;
  task.growth_y = a.growth_y;
  task.fx = forces.fx;
  task.fy = forces.fy;
  task.mz = forces.mz;
  return task;
}

/// Runs a kernel and takes what it sums up.
template <class Task>
void run(void (*kernel)(const Task&, simd::Sums&), const Task& task, SurfaceRollingForces& forces) {
  simd::Sums sums;
  kernel(task, sums);
  forces.power_per_speed = sums.power_per_speed;
  forces.adhesion_fraction = sums.area > 0.0 ? 1.0 - sums.slid_area / sums.area : 0.0;
}

/// Methods other than strip FASTSIM, from loads, coefficients and slips of the arrays.
void roll_by_fastsim(const SurfaceRollingInput& in, const RollingArrays& arrays,
                     const TangentialFields& fields, SurfaceRollingForces& forces);
void roll_by_fastrip(const SurfaceRollingInput& in, const RollingArrays& arrays,
                     const TangentialFields& fields, SurfaceRollingForces& forces);

}  // namespace wrc
