#include "surface/rolling/surface_rolling.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "kernels/kernels.hpp"
#include "patch/material.hpp"
#include "surface/rolling/rolling_arrays.hpp"
#include "surface/rolling/strip_numbers.hpp"
#include "surface/simd/tasks.hpp"
#include "tangential/methods/strip_fastsim.hpp"

namespace wrc {

using namespace strip_numbers;

namespace {

void roll_by_strip_fastsim(const SurfaceRollingInput& in, const RollingArrays& a,
                           const TangentialFields& fields, SurfaceRollingForces& forces) {
  auto task = surface_task<simd::SurfaceStripsTask>(in, a, fields, forces);
  task.inverse_weight = in.grid->inverse_weight;
  task.curvature = a.curvature;
  task.slip_x = a.slip_x;
  task.slip_y = a.slip_y;
  task.spin = in.spin;
  task.elastic = a.elastic;
  task.turn_x = a.turn_x;
  task.turn_y = a.turn_y;
  task.edge_x = a.edge_x;
  task.edge_y = a.edge_y;
  task.rigid_x = in.slip_x;
  task.rigid_y = in.slip_y;
  const Kernels& kernels = *in.grid->kernels;
  run(fields.any() ? kernels.tangential.surface_strips_fields : kernels.tangential.surface_strips, task,
      forces);
}

}  // namespace

std::size_t surface_rolling_workspace(std::int32_t capacity) {
  return static_cast<std::size_t>(capacity) * RollingArrays::count;
}

void roll_on_surface(const SurfaceRollingInput& in, double* workspace, const TangentialFields& fields,
                     SurfaceRollingForces& forces) {
  const RollingArrays a = strip_numbers::arrays(workspace, in.count);
  const Shared shared = strip_numbers::shared(in);
  in.grid->kernels->surface.strip_numbers(
      {&in, &shared, &a, in.method == SurfaceRollingMethod::strip_fastsim});
  switch (in.method) {
    case SurfaceRollingMethod::strip_fastsim:
      return roll_by_strip_fastsim(in, a, fields, forces);
    case SurfaceRollingMethod::fastsim:
      return roll_by_fastsim(in, a, fields, forces);
    case SurfaceRollingMethod::fastrip:
      return roll_by_fastrip(in, a, fields, forces);
  }
}

}  // namespace wrc
