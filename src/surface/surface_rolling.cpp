#include "surface/surface_rolling.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "patch/material.hpp"
#include "tangential/simd/kernels.hpp"
#include "tangential/strip_fastsim.hpp"

namespace wrc {
namespace {

constexpr double least_force2 = 1e-30;       // [N^2]: neither friction nor creepages
constexpr double least_length = 1e-9;        // [m]: shorter strips carry nothing
constexpr double largest_slenderness = 0.6;  // of the patches the calibration was fitted to
constexpr double reach2 = 10.0;              // beta^2: means reach over some three half lengths

/// Quantities of which strips take the mean over their neighbours, per unit of load.
enum Mean { longitudinal, lateral, spin, friction, slip, slender, turn, place, place2, place3, means };

struct Arrays {
  double *load, *link, *pivot;
  std::array<double*, means> mean;
  double *c11, *c22, *c23;
  double *bound, *growth_x, *growth_y, *curvature, *slip_x, *slip_y, *elastic, *turn_x, *turn_y, *edge_x,
      *edge_y;
};
constexpr std::int32_t arrays_of_workspace = 3 + means + 3 + 11;

Arrays arrays(double* workspace, std::int32_t count) {
  const auto array = [&] {
    double* const begin = workspace;
    workspace += count;
    return begin;
  };
  Arrays a{};
  for (double** p : {&a.load, &a.link, &a.pivot}) *p = array();
  for (double*& p : a.mean) p = array();
  for (double** p : {&a.c11, &a.c22, &a.c23, &a.bound, &a.growth_x, &a.growth_y, &a.curvature, &a.slip_x,
                     &a.slip_y, &a.elastic, &a.turn_x, &a.turn_y, &a.edge_x, &a.edge_y})
    *p = array();
  return a;
}

/// Replaces quantities times load by their means over neighbours: (N + K) A = N a, K the diffusion.
void take_means(const SurfaceRollingInput& in, const Arrays& a, Mean first, Mean last) {
  const std::int32_t n = in.count;
  for (std::int32_t j = 0; j < n; ++j) {
    const double before = j > 0 ? a.link[j - 1] : 0.0, behind = j + 1 < n ? a.link[j] : 0.0;
    double pivot = a.load[j] + before + behind;
    if (j > 0) pivot -= before * before * a.pivot[j - 1];
    a.pivot[j] = pivot > 0.0 ? 1.0 / pivot : 0.0;
  }
  for (int k = first; k < last; ++k) {
    double* const m = a.mean[static_cast<std::size_t>(k)];
    for (std::int32_t j = 0; j < n; ++j)
      m[j] = (m[j] + (j > 0 ? a.link[j - 1] * m[j - 1] : 0.0)) * a.pivot[j];
    for (std::int32_t j = n - 1; j-- > 0;) m[j] += a.pivot[j] * (a.link[j] * m[j + 1]);
  }
}

/// Loads of the strips and how strongly neighbours share their means.
void link(const SurfaceRollingInput& in, const Arrays& a) {
  for (std::int32_t j = 0; j < in.count; ++j) {
    const double l = in.half_length[j];
    a.load[j] = l > least_length ? 0.5 * pi * in.width[j] * in.peak[j] * l : 0.0;
  }
  for (std::int32_t j = 0; j + 1 < in.count; ++j) {
    const double apart = in.place[j + 1] - in.place[j], touching = 0.5 * (in.width[j] + in.width[j + 1]);
    const auto flow = [&](std::int32_t k) {
      return a.load[k] / in.width[k] * (in.half_length[k] * in.half_length[k]);
    };
    const double here = flow(j), there = flow(j + 1), sum = here + there;
    const bool neighbours = sum > 0.0 && apart < 1.5 * touching;
    a.link[j] = neighbours ? reach2 * 2.0 * (here * there / sum) / apart : 0.0;
  }
}

/// exp(asinh q): 1 + q for small q, positive for any, 1 / itself for -q.
double factor(double q) { return q + std::sqrt(1.0 + q * q); }

}  // namespace

std::size_t surface_rolling_workspace(std::int32_t capacity) {
  return static_cast<std::size_t>(capacity) * arrays_of_workspace;
}

void roll_on_surface(const SurfaceRollingInput& in, double* workspace, const TangentialFields& fields,
                     SurfaceRollingForces& forces) {
  const Arrays a = arrays(workspace, in.count);
  const double G = in.shear_modulus, poisson = in.coefficients->poisson();
  const double per_level = in.normal_shear_modulus / (1.0 - poisson);  // 1 / (pi C)
  link(in, a);

  for (std::int32_t j = 0; j < in.count; ++j) {
    const double l = std::max(in.half_length[j], least_length), N = a.load[j];
    const double level = std::max(in.peak[j], 1.0) / l;
    const StripCoefficients c = in.coefficients->at(in.curvature[j] * per_level / level);
    a.c11[j] = c.c11;
    a.c22[j] = c.c22;
    a.c23[j] = c.c23;
    const double area = N > 0.0 ? l * in.width[j] : 0.0;
    a.mean[lateral][j] = 2.0 / pi * G * c.c22 * in.slip_y[j] * area;
    a.mean[spin][j] = 0.75 * G * c.c23 * in.spin[j] * l * area;
    a.mean[friction][j] = in.friction[j] * N;
    a.mean[slip][j] = in.slip_x[j] * N;
    a.mean[slender][j] = c.slenderness * N;
    a.mean[turn][j] = level * in.friction[j] * l / c.c22 * N;
    a.mean[place][j] = in.place[j] * N;
  }
  take_means(in, a, lateral, place2);

  for (std::int32_t j = 0; j < in.count; ++j) {
    const double u = std::clamp(a.mean[slender][j], -largest_slenderness, largest_slenderness);
    // Spin's part of slip_x in linear theory: to what a strip differs from its neighbours it answers more.
    const double chi = neutral_line(u, poisson, 0.0);
    const double gain = 9.0 * pi / 32.0 * 2.0 / (2.0 - 0.75 * pi * chi) * (1.0 - 0.15 * u);
    a.slip_x[j] = in.slip_x[j];
    a.growth_x[j] = (gain - 1.0) * (in.slip_x[j] - a.mean[slip][j]);
    const double l = in.half_length[j];
    a.mean[longitudinal][j] =
        a.load[j] > 0.0 ? 2.0 / pi * G * a.c11[j] * (in.slip_x[j] + a.growth_x[j]) * l * in.width[j] : 0.0;
    const double d = in.place[j] - a.mean[place][j];
    a.mean[place2][j] = d * d * a.load[j];
    a.mean[place3][j] = d * d * d * a.load[j];
  }
  take_means(in, a, longitudinal, lateral);
  take_means(in, a, place2, means);

  constexpr double creepage_area = 9.0 * pi * pi / 128.0;
  const StripCalibration& calibration = *in.calibration;
  for (std::int32_t j = 0; j < in.count; ++j) {
    const double l = std::max(in.half_length[j], least_length);
    const double mu = in.friction[j], level = std::max(in.peak[j], 1.0) / l;
    const double u = std::clamp(a.mean[slender][j], -largest_slenderness, largest_slenderness);
    const double x = a.mean[longitudinal][j], e = a.mean[lateral][j], s = a.mean[spin][j];
    const double limit = a.mean[friction][j], limit2 = limit * limit + least_force2;
    const double Q = limit2 + x * x + e * e + s * s;
    const double variance = std::max(a.mean[place2][j], least_length * least_length);
    const double skew = a.mean[place3][j] / (variance * std::sqrt(variance));
    const double shape_number = std::clamp(1.79 * skew, -0.7, 0.7);

    const double xx = x * x / Q, ee = e * e / Q, ss = s * s / Q, pull = e * s / Q, pull2 = pull * pull;
    const double ratio = s * s / (limit2 + s * s), even = 4.0 * ratio * (1.0 - ratio), even2 = even * even;
    const double terms[StripCalibration::terms] = {1.0,
                                                   u,
                                                   xx,
                                                   ee,
                                                   ss,
                                                   pull,
                                                   pull2,
                                                   u * xx,
                                                   u * ee,
                                                   u * ss,
                                                   u * pull,
                                                   u * pull2,
                                                   even2 * even2 * (limit2 / (limit2 + x * x + e * e)),
                                                   shape_number * (x * s / Q)};
    const auto fitted = [&](StripCalibration::Quantity quantity) {
      double sum = 0.0;
      for (int i = 0; i < StripCalibration::terms; ++i) sum += calibration.constants[quantity][i] * terms[i];
      return sum;
    };
    const double by_x = creepage_area * factor(fitted(StripCalibration::flexibility_x));
    const double by_y = creepage_area * factor(fitted(StripCalibration::flexibility_y));
    const double by_spin_x = creepage_area * factor(fitted(StripCalibration::flexibility_spin_x));
    const double by_spin_y = factor(fitted(StripCalibration::flexibility_spin_y));
    const double turning = 1.4 * factor(fitted(StripCalibration::turning));

    // Flexibility times bound over half length, of linear theory [-].
    const double soft = 32.0 / 9.0 * level * mu * l / G;
    const double soft_x = soft / a.c11[j], soft_y = soft / a.c22[j];
    const double stiff = soft > 0.0 ? 1.0 / soft : 0.0;
    const double common = a.mean[slip][j], own = in.slip_x[j] - common + a.growth_x[j];
    a.growth_x[j] = stiff * a.c11[j] * (common / by_x + own / by_spin_x);
    a.growth_y[j] = stiff * a.c22[j] * in.slip_y[j] / by_y;
    a.curvature[j] = 16.0 / (3.0 * pi) * stiff * a.c23[j] * in.spin[j] * l / by_spin_y;
    a.slip_x[j] = in.slip_x[j];
    a.slip_y[j] = in.slip_y[j] + 32.0 / 9.0 / 0.884 * (a.mean[turn][j] / G) * (s / std::sqrt(Q)) *
                                     fitted(StripCalibration::torsion);
    a.bound[j] = a.load[j] > 0.0 ? mu * in.peak[j] : 0.0;
    a.elastic[j] = creepage_area * (soft_x - soft_y);
    a.turn_x[j] = turning * soft_x;
    a.turn_y[j] = turning * soft_y;
    a.edge_x[j] = 2.0 * by_x * soft_x;
    a.edge_y[j] = 2.0 * by_y * soft_y;
  }

  simd::SurfaceStripsTask task{};
  task.strips = in.count;
  task.cells = in.grid->cells;
  task.shape = &in.grid->elliptic;
  task.inverse_weight = in.grid->inverse_weight;
  task.fields = &fields;
  task.width = in.width;
  task.half_length = in.half_length;
  task.bound = a.bound;
  task.growth_x = a.growth_x;
  task.growth_y = a.growth_y;
  task.curvature = a.curvature;
  task.slip_x = a.slip_x;
  task.slip_y = a.slip_y;
  task.spin = in.spin;
  task.elastic = a.elastic;
  task.turn_x = a.turn_x;
  task.turn_y = a.turn_y;
  task.edge_x = a.edge_x;
  task.edge_y = a.edge_y;
  task.fx = forces.fx;
  task.fy = forces.fy;
  task.mz = forces.mz;
  task.rigid_x = in.slip_x;
  task.rigid_y = in.slip_y;
  simd::Sums sums;
  (fields.any() ? in.grid->kernels->surface_strips_fields : in.grid->kernels->surface_strips)(task, sums);
  forces.power_per_speed = sums.power_per_speed;
  forces.adhesion_fraction = sums.area > 0.0 ? 1.0 - sums.slid_area / sums.area : 0.0;
}

}  // namespace wrc
