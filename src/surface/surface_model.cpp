#include "surface/surface_model.hpp"

#include <algorithm>
#include <cmath>
#include <new>

#include "base/number.hpp"

namespace wrc {
namespace {

constexpr std::size_t whole_lines(std::size_t bytes) { return (bytes + 63) / 64 * 64; }

}  // namespace

std::size_t surface_model_bytes(std::int32_t wheel_nodes, std::int32_t rail_nodes, std::int32_t sections,
                                std::int32_t section_nodes, const RadiusTable& radius) {
  const auto doubles = static_cast<std::size_t>(
      curve_doubles(wheel_nodes) + curve_doubles(rail_nodes) +
      wheel_knot_doubles(most_curve_pieces(wheel_nodes)) + rail_strip_doubles(most_strips_of_a_rail) +
      2 * static_cast<std::int64_t>(std::max(wheel_nodes, rail_nodes)) +
      (sections > 0 ? varying_rail_doubles(sections, section_nodes, most_strips_of_a_rail) : 0) +
      out_of_round_doubles(radius));
  return whole_lines(sizeof(SurfaceModel)) + sizeof(double) * doubles;
}

Fault make_surface_model(const SurfaceBodies& bodies, void* memory, const SurfaceModel*& made) {
  auto* const model = new (memory) SurfaceModel;
  auto* doubles = reinterpret_cast<double*>(static_cast<char*>(memory) + whole_lines(sizeof(SurfaceModel)));
  double* const wheel = doubles;
  double* const rail = wheel + curve_doubles(bodies.wheel.count);
  double* const knots = rail + curve_doubles(bodies.rail.count);
  double* const strips = knots + wheel_knot_doubles(most_curve_pieces(bodies.wheel.count));
  double* const y = strips + rail_strip_doubles(most_strips_of_a_rail);
  double* const z = y + std::max(bodies.wheel.count, bodies.rail.count);
  double* const reach = z + std::max(bodies.wheel.count, bodies.rail.count);
  double* const sections = reach + out_of_round_doubles(bodies.radius);

  for (std::int32_t i = 0; i < bodies.wheel.count; ++i) z[i] = bodies.nominal_radius + bodies.wheel.z[i];
  Fault fault = make_curve(bodies.wheel.count, bodies.wheel.y, z, wheel, model->wheel.curve);
  if (fault.failed()) return fault;
  find_knots(knots, model->wheel);
  const double c = 1.0 / std::sqrt(1.0 + bodies.rail_inclination * bodies.rail_inclination);
  const double s = bodies.rail_inclination * c;
  for (std::int32_t i = 0; i < bodies.rail.count; ++i) {
    y[i] = c * bodies.rail.y[i] + s * bodies.rail.z[i];
    z[i] = c * bodies.rail.z[i] - s * bodies.rail.y[i];
  }
  fault = make_curve(bodies.rail.count, y, z, rail, model->rail_curve);
  if (fault.failed()) return fault;
  fault = cut_rail(model->rail_curve, {}, most_strips_of_a_rail, strips, model->rail);
  if (fault.failed()) return fault;
  if (bodies.sections > 0) {
    fault = make_varying_rail(bodies.section, bodies.sections, bodies.rail_inclination, most_strips_of_a_rail,
                              sections, model->varying);
    if (fault.failed()) return fault;
  }
  if (bodies.radius.rows > 0)
    make_out_of_round(bodies.radius, bodies.nominal_radius, reach, model->out_of_round);
  model->rail_origin_y = bodies.rail_origin_y;
  model->wheel_radius = bodies.nominal_radius;
  model->rail_origin_z = bodies.rail_origin_z;
  model->roller_curvature = bodies.roller_curvature;
  model->material = bodies.material;
  model->effusivities = bodies.effusivities;
  model->influence = bodies.influence;
  model->kernels = bodies.kernels;
  model->coefficients = StripCoefficientTable(*bodies.ellipse);
  model->grid = bodies.grid;
  model->methods = bodies.methods;
  made = model;
  return {};
}

}  // namespace wrc
