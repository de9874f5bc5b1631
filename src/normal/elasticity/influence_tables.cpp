#include "normal/elasticity/influence_tables.hpp"

#include <algorithm>
#include <cmath>

#include "base/elementary.hpp"
#include "normal/elasticity/contact_condition.hpp"
#include "patch/material.hpp"

namespace wrc {
namespace {

/// asinh, odd.
double area_sinh(double x) {
  const double value = natural_log(std::abs(x) + std::sqrt(x * x + 1.0));
  return x < 0.0 ? -value : value;
}

/// Mean of J(s, 1) over |s| < tau.
double mean_at_edge(const InfluenceTables& influence, double tau) {
  // J(s, 1) bends like sqrt(s): Gauss's three points in u, s = tau u^2.
  constexpr double u[] = {0.11270166537925831, 0.5, 0.88729833462074169};
  constexpr double weight[] = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
  double mean = 0.0;
  for (int n = 0; n < 3; ++n) mean += weight[n] * 2.0 * u[n] * influence.at(tau * u[n] * u[n], 1.0);
  return mean;
}

}  // namespace

double line_potential(double tau, double xi) noexcept {
  // t = xi + tau sinh v makes dt / r = dv; v = middle + half sin(phi) then makes the square root at the ends
  // analytic and periodic in phi, where the midpoint rule converges geometrically.
  const double v_trailing = area_sinh((-1.0 - xi) / tau);
  const double v_leading = area_sinh((1.0 - xi) / tau);
  const double middle = 0.5 * (v_trailing + v_leading);
  const double half = 0.5 * (v_leading - v_trailing);
  const int halvings = tau < 0.05 ? 5 : (tau < 1.0 ? 4 : 3);
  const int points = 2 << halvings;
  // sin and cos of the step pi / points by halving the angle pi / 2.
  double cosine_step = 0.0, sine_step = 1.0;
  for (int n = 0; n < halvings; ++n) {
    sine_step = std::sqrt(0.5 * (1.0 - cosine_step));
    cosine_step = std::sqrt(0.5 * (1.0 + cosine_step));
  }
  const double first = std::sqrt(0.5 * (1.0 - cosine_step));  // sin of half a step
  double cosine = first, sine = -std::sqrt(0.5 * (1.0 + cosine_step));
  double sum = 0.0;
  for (int n = 0; n < points; ++n) {
    const double e = natural_exp(middle + half * sine);
    const double t = xi + 0.5 * tau * (e - 1.0 / e);
    sum += std::sqrt(std::max(0.0, 1.0 - t * t)) * cosine;
    const double next = cosine * cosine_step - sine * sine_step;
    sine = sine * cosine_step + cosine * sine_step;
    cosine = next;
  }
  return sum * half * pi / points;
}

void tabulate(InfluenceTables& influence) noexcept {
  // The integral under the mean grows from node to node by Simpson's rule; before the first node it is the
  // logarithm's alone.
  double node = InfluenceTables::distance_axis.node(0);
  double integral = 0.5 * strip_displacement(1.0, -node, node);
  for (int i = 0; i <= InfluenceTables::distance_axis.intervals(); ++i) {
    const double next = InfluenceTables::distance_axis.node(i + 1);
    const double here = line_displacement(1.0, node);
    influence.on_middle_plane[static_cast<std::size_t>(i)] = here;
    influence.mean_under[static_cast<std::size_t>(i)] = integral / node;
    integral += (next - node) / 6.0 *
                (here + 4.0 * line_displacement(1.0, 0.5 * (node + next)) + line_displacement(1.0, next));
    node = next;
  }
  for (int i = 0; i <= InfluenceTables::chi_axis.intervals(); ++i)
    for (int j = 0; j <= InfluenceTables::eta_intervals; ++j) {
      const double x = InfluenceTables::chi_axis.node(i);
      const double v = static_cast<double>(j) / InfluenceTables::eta_intervals;
      const double eta = 1.0 - v * v;
      const double tau = std::sqrt(x * (x + 2.0) * v * v * (1.0 + eta));
      influence.anywhere[i * (InfluenceTables::eta_intervals + 1) + j] =
          line_potential(std::max(tau, 1e-6), (1.0 + x) * eta);
    }
  for (int i = 0; i <= InfluenceTables::distance_axis.intervals(); ++i)
    influence.edge_under[static_cast<std::size_t>(i)] =
        mean_at_edge(influence, InfluenceTables::distance_axis.node(i));
}

}  // namespace wrc
