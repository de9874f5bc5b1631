/// Arrays of strips between contact and slips, and a kernel's task: shared by the methods of
/// surface_rolling.hpp.
///
/// Symbols of the theory manual, "Strips on the rail's surface":
///
///     N                 load                         load of a strip [N]
///     A                 mean[...]                    means over neighbouring strips
///     W                 mean[slip]                   slip along x that neighbours share [-]
///     g (w_x - W)       own                          local part of the longitudinal slip times gain [-]
///     u                 mean[slender]                slenderness (a - b) / (a + b) [-]
///     x, e, s           mean[longitudinal, lateral, spin]    forces of linear theory over the load [-]
///     mu                mean[friction]               coefficient of friction [-]
///     C11, C22, C23'    c11, c22, c23                coefficients of linear theory [-]
#pragma once

#include "base/arena.hpp"
#include "surface/rolling/surface_rolling.hpp"
#include "tangential/simd/tasks.hpp"

namespace wrc::surface {

/// Quantities of which strips take the mean over their neighbours: first times load, then the mean.
struct RollingMeans {
  enum Mean {
    slender,       ///< u [-]
    location,      ///< arc length [m]
    slip,          ///< slip along x [-]
    edge,          ///< elastic slip at the edge of a strip that slips as a whole [-]
    lateral,       ///< e: lateral force of lateral slip in linear theory over the load [-]
    spin,          ///< s: lateral force of spin in linear theory over the load [-]
    friction,      ///< mu [-]
    variance,      ///< squared distance from `location` [m^2]
    longitudinal,  ///< x: longitudinal force in linear theory over the load [-]
    means
  };
};

/// One element per strip, in the caller's workspace.
template <class Number>
struct RollingArraysOf : RollingMeans {
  Number* load;   ///< [N]
  Number* link;   ///< coupling to the next strip in the means' equations [N]
  Number* pivot;  ///< inverse pivot of their elimination [1/N]; before that, load l^2 / width [N m]
  Number* mean[means];
  Number *c11, *c22, *c23;  ///< coefficients [-] (strip_coefficients.hpp)
  Number* own;              ///< local part of the longitudinal slip times gain [-]
  Number* pressed;          ///< longitudinal slip by pressure, used for unlike bodies alone [-]
  /// Members of SurfaceStripsTask of the same names (tangential/simd/tasks.hpp).
  Number *bound, *growth_x, *growth_y, *curvature, *slip_x, *slip_y, *elastic, *turn_x, *turn_y, *edge_x,
      *edge_y, *across, *beside;
};
using RollingArrays = RollingArraysOf<double>;

/// Cuts the arrays of `strips` strips, of which `at_a_time` march together, or counts them.
template <class Number>
RollingArraysOf<Number> cut_rolling_arrays(Arena& arena, std::int32_t strips, std::int32_t at_a_time) {
  RollingArraysOf<Number> a{};
  for (Number*& mean : a.mean) mean = arena.take<Number>(strips);
  arena.each(strips, a.load, a.link, a.pivot, a.c11, a.c22, a.c23, a.own, a.pressed);
  arena.each(at_a_time, a.bound, a.growth_x, a.growth_y, a.curvature, a.slip_x, a.slip_y, a.elastic, a.turn_x,
             a.turn_y, a.edge_x, a.edge_y, a.across, a.beside);
  return a;
}

/// Memory of these arrays [doubles].
template <class Number>
std::int64_t rolling_doubles(std::int32_t strips) {
  Arena arena;
  cut_rolling_arrays<Number>(arena, strips, strips);
  return arena.doubles();
}

inline constexpr double least_strip_length = 1e-9;  ///< [m]: shorter strips carry nothing

/// Those parts of a kernel's task that SurfaceMarchTask and SurfaceStripsTask have in common: the strips,
/// their bounds and growths, and the arrays of results.
template <class Task>
Task surface_task(const SurfaceRollingInput& in, const RollingArrays& a,
                  const tangential::TangentialFields& fields, const SurfaceRollingForces& forces) {
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

/// Runs a kernel on a task; returns the totals over all strips.
template <class Task>
SurfaceRollingTotals run(void (*kernel)(const Task&, simd::Sums&), const Task& task) {
  simd::Sums sums;
  kernel(task, sums);
  return {sums.power_per_speed, sums.area > 0.0 ? 1.0 - sums.slid_area / sums.area : 0.0};
}

/// FASTSIM and FaStrip, from loads, coefficients and slips of the arrays (simplified_rolling.cpp).
SurfaceRollingTotals roll_by_fastsim(const SurfaceRollingInput& in, const RollingArrays& arrays,
                                     const tangential::TangentialFields& fields,
                                     const SurfaceRollingForces& forces);
SurfaceRollingTotals roll_by_fastrip(const SurfaceRollingInput& in, const RollingArrays& arrays,
                                     const tangential::TangentialFields& fields,
                                     const SurfaceRollingForces& forces);

}  // namespace wrc::surface
