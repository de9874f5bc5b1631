#include "surface/rolling/surface_rolling.hpp"

#include "kernels/kernels.hpp"
#include "surface/rolling/layered_strips.hpp"
#include "surface/rolling/rolling_arrays.hpp"
#include "surface/rolling/strip_numbers.hpp"
#include "surface/simd/tasks.hpp"

namespace wrc::surface {
namespace {

SurfaceRollingTotals roll_by_strip_fastsim(const SurfaceRollingInput& in, const RollingArrays& a,
                                           const tangential::TangentialFields& fields,
                                           const SurfaceRollingForces& forces) {
  auto task = surface_task<simd::SurfaceStripsTask>(in, a, fields, forces);
  task.inverse_weight = in.grid->inverse_weight;
  // slips that drive the march: rigid ones plus torsion and twist; and how they turn the traction
  task.curvature = a.curvature;
  task.slip_x = a.slip_x;
  task.slip_y = a.slip_y;
  task.spin = in.spin;
  task.elastic = a.elastic;
  task.turn_x = a.turn_x;
  task.turn_y = a.turn_y;
  task.edge_x = a.edge_x;
  task.edge_y = a.edge_y;
  task.across = a.across;
  task.beside = a.beside;
  // power is force times rigid slip: elastic slip from the tractions beside takes none
  task.rigid_x = in.slip_x;
  task.rigid_y = in.slip_y;
  const Kernels& kernels = *in.grid->kernels;
  return run(fields.any() ? kernels.tangential.surface_strips_fields : kernels.tangential.surface_strips,
             task);
}

}  // namespace

std::size_t surface_rolling_workspace(std::int32_t capacity) {
  return static_cast<std::size_t>(rolling_doubles<double>(capacity));
}

SurfaceRollingTotals roll_on_surface(const SurfaceRollingInput& in, void* workspace,
                                     const tangential::TangentialFields& fields,
                                     const SurfaceRollingForces& forces) {
  Arena arena(workspace);
  const RollingArrays a = cut_rolling_arrays<double>(arena, in.count, in.count);
  const strip_numbers::Shared shared = strip_numbers::shared(in);
  // Loads, coefficients and means serve all methods; the rest of the arrays strip FASTSIM alone.
  in.grid->kernels->surface.strip_numbers(
      {&in, &shared, &a, in.method == SurfaceRollingMethod::strip_fastsim});
  switch (in.method) {
    case SurfaceRollingMethod::strip_fastsim:
      break;
    case SurfaceRollingMethod::fastsim:
      return roll_by_fastsim(in, a, fields, forces);
    case SurfaceRollingMethod::fastrip:
      return roll_by_fastrip(in, a, fields, forces);
  }
  if (in.layered())
    return roll_layered(in, false, fields, forces,
                        [&](std::int32_t j) { return layered_strip(in, a, layer_of(in, j), j); });
  return roll_by_strip_fastsim(in, a, fields, forces);
}

}  // namespace wrc::surface
