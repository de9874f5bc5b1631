#include "surface/surface_model.hpp"

#include <algorithm>
#include <cmath>
#include <new>

#include "base/arena.hpp"

namespace wrc::surface {
namespace {

/// Numbers the model's memory depends on: points of the profiles, sections, points of the longest of them,
/// faces.
struct Sizes {
  std::int32_t wheel_nodes, rail_nodes, sections, section_nodes, faces;
};

/// Memory of a model.
struct ModelArrays {
  void* model;
  CurveArrays wheel, rail;
  KnotArrays knots;
  StripArrays strips;
  double *y, *z;              ///< points of a profile while it is read
  VaryingRailArrays varying;  ///< with sections
  OutOfRoundArrays radius;    ///< if the wheel is not round
};

ModelArrays cut(Arena& arena, const Sizes& sizes, const RadiusTable& radius) {
  // the model first: its address is that of the memory
  ModelArrays a;
  a.model = arena.take<std::byte>(sizeof(SurfaceModel));
  a.wheel = cut_curve(arena, sizes.wheel_nodes);
  a.rail = cut_curve(arena, sizes.rail_nodes);
  a.knots = cut_knots(arena, most_curve_pieces(sizes.wheel_nodes));
  a.strips = cut_strips(arena, most_strips_of_a_rail);
  arena.each(std::max(sizes.wheel_nodes, sizes.rail_nodes), a.y, a.z);
  if (sizes.sections > 0)
    a.varying = cut_varying_rail(arena, sizes.sections, sizes.section_nodes, strips_of_a_rail(sizes.faces));
  if (radius.rows > 0) a.radius = cut_out_of_round(arena, radius);
  return a;
}

/// The wheel's radius over its profile, as a curve with knots.
Fault make_wheel(const SurfaceBodies& bodies, const ModelArrays& a, WheelCurve& wheel) {
  for (std::int32_t i = 0; i < bodies.wheel.count; ++i) a.z[i] = bodies.nominal_radius + bodies.wheel.z[i];
  Curve curve;
  const Fault fault = make_curve(bodies.wheel.count, bodies.wheel.y, a.z, a.wheel, curve);
  if (!fault.failed()) wheel = make_wheel_curve(curve, a.knots);
  return fault;
}

/// The rail's profile, turned by its cant about the profile's origin.
Fault make_rail(const SurfaceBodies& bodies, const ModelArrays& a, Curve& rail) {
  // cosine and sine of the cant, from its tangent
  const double c = 1.0 / std::sqrt(1.0 + bodies.rail_inclination * bodies.rail_inclination);
  const double s = bodies.rail_inclination * c;
  for (std::int32_t i = 0; i < bodies.rail.count; ++i) {
    a.y[i] = c * bodies.rail.y[i] + s * bodies.rail.z[i];
    a.z[i] = c * bodies.rail.z[i] - s * bodies.rail.y[i];
  }
  return make_curve(bodies.rail.count, a.y, a.z, a.rail, rail);
}

}  // namespace

std::size_t surface_model_bytes(std::int32_t wheel_nodes, std::int32_t rail_nodes, std::int32_t sections,
                                std::int32_t section_nodes, std::int32_t faces, const RadiusTable& radius) {
  Arena count;
  cut(count, {wheel_nodes, rail_nodes, sections, section_nodes, faces}, radius);
  return static_cast<std::size_t>(count.bytes());
}

Fault make_surface_model(const SurfaceBodies& bodies, void* memory, const SurfaceModel*& made) {
  const std::int32_t faces = bodies.sections > 0 ? bodies.section[bodies.sections - 1].face + 1 : 1;
  Sizes sizes{bodies.wheel.count, bodies.rail.count, bodies.sections, 0, faces};
  for (std::int32_t k = 0; k < bodies.sections; ++k)
    sizes.section_nodes = std::max(sizes.section_nodes, bodies.section[k].profile.count);
  Arena arena(memory);
  const ModelArrays arrays = cut(arena, sizes, bodies.radius);
  auto* const model = new (arrays.model) SurfaceModel;

  // both cross sections by arc length, and the rail's strips
  Fault fault = make_wheel(bodies, arrays, model->wheel);
  if (!fault.failed()) fault = make_rail(bodies, arrays, model->rail_curve);
  if (fault.failed()) return fault;
  model->rail = cut_rail(model->rail_curve, bodies.widths, most_strips_of_a_rail, arrays.strips);
  // a rail that changes along the track, a wheel whose radius changes round it
  if (bodies.sections > 0) {
    fault = make_varying_rail(bodies.section, bodies.sections, bodies.rail_inclination, bodies.widths,
                              strips_of_a_rail(faces), arrays.varying, model->varying);
    if (fault.failed()) {
      // A check rail's sections are not the caller's.
      if (!has_check_rail(model->varying)) fault.distance = bodies.section[fault.index].distance;
      return fault;
    }
  }
  if (bodies.radius.rows > 0)
    model->out_of_round = make_out_of_round(bodies.radius, bodies.nominal_radius, arrays.radius);
  // places of the bodies, material, tables, methods
  model->rail_origin_y = bodies.rail_origin_y;
  model->wheel_radius = bodies.nominal_radius;
  model->rail_origin_z = bodies.rail_origin_z;
  model->roller_curvature = bodies.roller_curvature;
  model->material = bodies.material;
  model->coupling = bodies.coupling;
  model->effusivities = bodies.effusivities;
  model->influence = bodies.influence;
  model->kernels = bodies.kernels;
  model->coefficients = StripCoefficientTable(*bodies.ellipse);
  model->grid = bodies.grid;
  model->methods = bodies.methods;
  model->pressure = bodies.pressure;
  // planar methods have no tolerance of the surface's: prescribed loads are searched as to this one
  if (model->methods.planar.solve) model->pressure.tolerance = 1e-7;
  model->most_overlapping = overlapping_strips(bodies.widths);
  model->rail_strips = bodies.sections > 0 ? model->varying.strips : model->rail.count;
  made = model;
  return {};
}

}  // namespace wrc::surface
