#include "tangential/force_table/force_table.hpp"

#include <algorithm>
#include <cmath>

#include "patch/material.hpp"
#include "theory/sdec.hpp"

namespace wrc::tangential {
namespace {

/// Variable of the axis ratio: tanh(log(ratio) / 8), next to linear in the logarithm, without computing one.
double ratio_variable(double ratio) {
  const double fourth_root = std::sqrt(std::sqrt(ratio));
  return (fourth_root - 1.0) / (fourth_root + 1.0);
}

/// Three neighbouring nodes and the quadratic B-spline's weights on them.
struct Stencil {
  std::int32_t first = 0;
  std::array<double, 3> weight{};
};

/// At `place`, in nodes from the first one and not negative. About the nearest node, not before `lowest` and
/// not after `highest`.
Stencil stencil(double place, std::int32_t lowest, std::int32_t highest) {
  const std::int32_t nearest = (static_cast<std::int32_t>(2.0 * place) + 1) / 2;
  const std::int32_t middle = std::clamp(nearest, lowest, highest);
  const double u = place - middle;
  return {middle - 1, {0.5 * (0.5 - u) * (0.5 - u), 0.75 - u * u, 0.5 * (0.5 + u) * (0.5 + u)}};
}

/// Between the first and last of `nodes`; the outermost pieces of the spline reach half an interval further.
Stencil open_stencil(double place, std::int32_t nodes) { return stencil(place, 1, nodes - 2); }

/// Polar angle of a point of the first quadrant, 0 to pi/2: the quarter of it by half-angle formulas, then
/// the series of the arc tangent, |error| < 5e-7.
double quadrant_angle(double x, double y) {
  const double half = y / (x + std::sqrt(x * x + y * y));
  const double quarter = half / (1.0 + std::sqrt(1.0 + half * half));
  const double z = quarter * quarter;
  const double series =
      1.0 + z * (-1.0 / 3.0 +
                 z * (1.0 / 5.0 + z * (-1.0 / 7.0 + z * (1.0 / 9.0 + z * (-1.0 / 11.0 + z * (1.0 / 13.0))))));
  return 4.0 * quarter * series;
}

double circle_angle(double x, double y) {
  const double angle = quadrant_angle(std::abs(x), std::abs(y));
  const double upper = x < 0.0 ? pi - angle : angle;
  return y < 0.0 ? 2.0 * pi - upper : upper;
}

/// A row of nodes of one elevation; beyond 0 and 90 degrees the sphere goes on at the opposite azimuth,
/// below 0 with the signs of creepages and forces changed.
struct Row {
  std::int32_t elevation = 0, turn = 0;
  double sign = 1.0;
};
Row row_at(const ForceTableAxes& axes, std::int32_t elevation) {
  const std::int32_t last = axes.elevations - 1, half_turn = axes.azimuths / 2;
  if (elevation < 0) return {-elevation, half_turn, -1.0};
  if (elevation > last) return {2 * last - elevation, half_turn, 1.0};
  return {elevation, 0, 1.0};
}

/// Azimuth -n to 2 n - 1, brought to 0 to n - 1.
std::int32_t wrapped(std::int32_t azimuth, std::int32_t n) {
  return azimuth < 0 ? azimuth + n : azimuth < n ? azimuth : azimuth - n;
}

using Values = std::array<double, force_table_values>;

/// Where to read: spin >= 0 in the direction.
struct Place {
  Stencil ratio, shape;
  CreepageScale direction;  // any length but zero
  double saturation = 0.0;
};

Values interpolate(const ForceTable& table, const Place& at) {
  // Stencils of the axes: elevation over the plane without spin, azimuth round the circle, saturation.
  const ForceTableAxes& axes = table.axes;
  const CreepageScale& d = at.direction;
  const double in_plane = std::sqrt(d.longitudinal * d.longitudinal + d.lateral * d.lateral);
  const double elevation = quadrant_angle(in_plane, d.spin);
  const double azimuth = in_plane > 0.0 ? circle_angle(d.longitudinal, d.lateral) : 0.0;
  const std::int32_t n = axes.azimuths;
  const Stencil up = stencil(elevation * (2.0 / pi) * (axes.elevations - 1), 0, axes.elevations - 1);
  const Stencil around = stencil(azimuth * (0.5 / pi) * n, 0, n);
  const Stencil along = open_stencil(at.saturation * (axes.saturations - 1), axes.saturations);

  // Neighbours in saturation and shape lie side by side, so that a patch touches few cache lines.
  const std::ptrdiff_t stride_saturation = std::ptrdiff_t{force_table_values} * axes.shapes;
  const std::ptrdiff_t stride_ratio = stride_saturation * axes.saturations;
  const std::ptrdiff_t stride_azimuth = stride_ratio * axes.ratios;
  const std::ptrdiff_t stride_elevation = stride_azimuth * n;
  const float* const corner = table.coefficients + at.ratio.first * stride_ratio +
                              along.first * stride_saturation + at.shape.first * force_table_values;

  // Tensor product of the B-splines, shape last. Beyond a pole of the sphere a row lies half a turn on; below
  // the plane forces and moment change their signs, the share that sticks does not.
  constexpr int width = 3 * force_table_values;  // numbers of three neighbouring shapes
  std::array<double, width> sum{};
  for (int i = 0; i < 3; ++i) {
    const Row row = row_at(axes, up.first + i);
    std::array<double, width> row_sum{};
    for (int j = 0; j < 3; ++j) {
      const float* const here = corner + row.elevation * stride_elevation +
                                wrapped(around.first + j + row.turn, n) * stride_azimuth;
      for (int k = 0; k < 3; ++k) {
        for (int l = 0; l < 3; ++l) {
          const float* const nodes = here + k * stride_ratio + l * stride_saturation;
          const double weight = around.weight[j] * at.ratio.weight[k] * along.weight[l];
          for (int m = 0; m < width; ++m) row_sum[m] += weight * static_cast<double>(nodes[m]);
        }
      }
    }
    for (int m = 0; m < width; ++m) {
      const bool odd = m % force_table_values != force_table_values - 1;
      sum[m] += up.weight[i] * (odd ? row.sign : 1.0) * row_sum[m];
    }
  }
  Values values{};
  for (int k = 0; k < 3; ++k) {
    for (int m = 0; m < force_table_values; ++m)
      values[m] += at.shape.weight[k] * sum[k * force_table_values + m];
  }
  return values;
}

CreepageScale weighted(const std::array<CreepageScale, force_table_nodes>& nodes, const Stencil& stencil) {
  CreepageScale sum;
  for (std::size_t k = 0; k < 3; ++k) {
    const CreepageScale& node = nodes[static_cast<std::size_t>(stencil.first) + k];
    sum.longitudinal += stencil.weight[k] * node.longitudinal;
    sum.lateral += stencil.weight[k] * node.lateral;
    sum.spin += stencil.weight[k] * node.spin;
  }
  return sum;
}

void flag(const char* field, double value, double low, double high, Fault& fault) {
  keep_worst(fault, Fault::table_range(field, {value, "", low, high}));
}

}  // namespace

std::size_t force_table_size(const ForceTableAxes& axes) {
  std::size_t size = force_table_values;
  for (const std::int32_t nodes :
       {axes.ratios, axes.shapes, axes.elevations, axes.azimuths, axes.saturations}) {
    size *= static_cast<std::size_t>(nodes);
  }
  return size;
}

/// K1 and K2 are C11 and C22 within a tenth; K3 is the root mean square, over the pressure, of the slip that
/// spin causes, weighted with them: <y^2> = b^2/5, <x^2> = a^2/5.
CreepageScale creepage_scale(double ratio) {
  const double k1 = 3.25 + 0.87 * ratio, k2 = 2.5 + 1.12 * ratio;
  return {k1, k2, std::sqrt(0.2 * (k1 * k1 / ratio + k2 * k2 * ratio))};
}

double node_ratio(const ForceTableAxes& axes, std::int32_t i) {
  const double u = ratio_variable(axes.largest_ratio) * (2.0 * i / (axes.ratios - 1) - 1.0);
  const double squared = (1.0 + u) * (1.0 + u) / ((1.0 - u) * (1.0 - u));
  return squared * squared;
}

double node_shape_number(const ForceTableAxes& axes, std::int32_t i) {
  return axes.largest_shape_number * i / (axes.shapes - 1);
}

double node_saturation(const ForceTableAxes& axes, std::int32_t i) {
  return static_cast<double>(i) / (axes.saturations - 1);
}

void adapt_to_poisson(double poisson, ForceTable& table) {
  const theory::SdecTable wanted(poisson), given(table.axes.poisson);
  for (std::int32_t i = 0; i < table.axes.ratios; ++i) {
    const double ratio = node_ratio(table.axes, i);
    Fault beyond_tables;  // dropped: only the coefficients' ratio is used
    const theory::SdecCoefficients ours = given.at(ratio, 0.0, beyond_tables);
    const theory::SdecCoefficients theirs = wanted.at(ratio, 0.0, beyond_tables);
    table.stiffness[static_cast<std::size_t>(i)] = {theirs.c11 / ours.c11, theirs.c22 / ours.c22,
                                                    theirs.c23 / ours.c23};
  }
}

TangentialForces table_forces(const ForceTable& table, const patch::Sdec& patch, double normal_force,
                              double shear_modulus, double friction, const Creepage& creepage, Fault& fault) {
  // The patch within the table: mirrored to psi >= 0, shapes beyond its ends flagged and taken as the end.
  const ForceTableAxes& axes = table.axes;
  const double mirror = patch.psi < 0.0 ? -1.0 : 1.0;
  const double largest = axes.largest_ratio, actual = patch.a / patch.b;
  const double ratio = std::clamp(actual, 1.0 / largest, largest);
  const double shape = std::min(mirror * patch.psi, axes.largest_shape_number);
  if (ratio != actual) flag("patch.a / patch.b", actual, 1.0 / largest, largest, fault);
  if (shape != mirror * patch.psi) {
    flag("patch.psi", patch.psi, -axes.largest_shape_number, axes.largest_shape_number, fault);
  }

  Place at;
  at.ratio = open_stencil(
      std::max(0.0, 0.5 * (axes.ratios - 1) * (ratio_variable(ratio) / ratio_variable(largest) + 1.0)),
      axes.ratios);
  at.shape = open_stencil((axes.shapes - 1) * (shape / axes.largest_shape_number), axes.shapes);

  // The creepages as the table counts them, without and with the stiffness of the bodies' Poisson ratio,
  // times the limit of the forces [N]: so they are numbers without friction too, where t = 1.
  const double limit = friction * normal_force, centre = pressure_centre(patch);
  const double c2 = patch.a * patch.b, c = std::sqrt(c2), stiff = shear_modulus * c2;
  const CreepageScale scale = creepage_scale(ratio), stiffness = weighted(table.stiffness, at.ratio);
  const double x = scale.longitudinal * stiff * (creepage.longitudinal - creepage.spin * centre);
  const double y = scale.lateral * stiff * creepage.lateral * mirror;
  const double s = scale.spin * stiff * c * creepage.spin * mirror;
  const double elastic_x = stiffness.longitudinal * x, elastic_y = stiffness.lateral * y,
               elastic_s = stiffness.spin * s;
  // saturation t = r / (r + r0) of v with the stiffness of the bodies' Poisson ratio; r0 times the limit, as
  // v is
  const double r = std::sqrt(elastic_x * elastic_x + elastic_y * elastic_y + elastic_s * elastic_s);
  if (!(r > 0.0)) return {.adhesion_fraction = 1.0};
  const double t = r / (r + axes.half_saturation * limit), rigid = t * t;

  // direction with that stiffness at t = 0, without it at t = 1, turned to spin >= 0
  const double sign = s < 0.0 ? -1.0 : 1.0;
  at.direction = {sign * (elastic_x + rigid * (x - elastic_x)) / r,
                  sign * (elastic_y + rigid * (y - elastic_y)) / r,
                  sign * (elastic_s + rigid * (s - elastic_s)) / r};
  at.saturation = t;
  const Values values = interpolate(table, at);

  // back from force over mu N t to forces; the moment from the centre of pressure to the joint
  const double share = std::sqrt(values[0] * values[0] + values[1] * values[1]) * t;
  const double within = sign * t * limit / std::max(1.0, share);  // |F| <= mu N whatever the spline does
  TangentialForces forces;
  forces.fx = within * values[0];
  forces.fy = within * values[1] * mirror;
  forces.mz = sign * t * limit * c * values[2] * mirror - centre * forces.fx;
  forces.power_per_speed = std::max(
      0.0, -(forces.fx * creepage.longitudinal + forces.fy * creepage.lateral + forces.mz * creepage.spin));
  forces.adhesion_fraction = std::clamp(values[3], 0.0, 1.0);
  return forces;
}

}  // namespace wrc::tangential
