#include "normal/elasticity/influence_tables.hpp"

#include <algorithm>
#include <cmath>

#include "base/elementary.hpp"
#include "normal/elasticity/contact_condition.hpp"
#include "patch/material.hpp"

namespace wrc::normal {
namespace {

/// asinh, odd.
double area_sinh(double x) {
  const double value = natural_log(std::abs(x) + std::sqrt(x * x + 1.0));
  return x < 0.0 ? -value : value;
}

/// Mean of J(s, 1) over |s| < tau.
double mean_at_edge(double tau) {
  // J(s, 1) bends like sqrt(s): Gauss's three points in u, s = tau u^2.
  constexpr double u[] = {0.11270166537925831, 0.5, 0.88729833462074169};
  constexpr double weight[] = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
  double mean = 0.0;
  for (int n = 0; n < 3; ++n) mean += weight[n] * 2.0 * u[n] * line_potential(tau * u[n] * u[n], 1.0);
  return mean;
}

/// A row of J's table, before its nodes are lowered: one node more than its columns on each side.
struct LineRow {
  double outside[InfluenceTables::inside + 1], inside[InfluenceTables::nodes_inside + 1];
};

/// |xi - 1| at a node of the columns' axis.
double from_end(int node) { return InfluenceTables::from_end.node(node) - InfluenceTables::from_end.node(0); }

void find_row(int row, LineRow& found) {
  const double tau = InfluenceTables::line_rows.node(row);
  for (int k = 0; k <= InfluenceTables::inside; ++k)
    found.outside[k] = line_potential(tau, 1.0 + from_end(k));
  for (int k = 0; k <= InfluenceTables::nodes_inside; ++k)
    found.inside[k] = line_potential(tau, std::abs(1.0 - from_end(k)));
}

/// Nodes of a row between two others, on one side of the line's end, each lowered by a twelfth of the second
/// differences in both directions: straight lines between the nodes are too high by that in the mean. At
/// uneven distances the second difference is that of a parabola. `across`: the neighbour beyond the end.
template <std::size_t nodes>
void level_side(const double (&before)[nodes], const double (&row)[nodes], const double (&behind)[nodes],
                double across, double* levelled) {
  for (int k = 0; k + 1 < static_cast<int>(nodes); ++k) {
    // Distances to both neighbours, and the second difference along the row.
    const double here = row[k], low = from_end(k) - (k > 0 ? from_end(k - 1) : -from_end(1));
    const double high = from_end(k + 1) - from_end(k);
    const double steeper = (row[k + 1] - here) / high - (here - (k > 0 ? row[k - 1] : across)) / low;
    const double bend = steeper * (low * low + high * high) / (low + high);
    levelled[k] = here - (bend + before[k] + behind[k] - 2.0 * here) / 12.0;
  }
}

void level_row(const LineRow& before, const LineRow& row, const LineRow& behind, double* levelled) {
  level_side(before.outside, row.outside, behind.outside, row.inside[1], levelled);
  level_side(before.inside, row.inside, behind.inside, row.outside[1], levelled + InfluenceTables::inside);
}

void tabulate_anywhere(InfluenceTables& influence) {
  constexpr int columns = InfluenceTables::columns;
  // Three rows at a time: a row is lowered by its neighbours, and a cell holds two lowered rows as twins.
  LineRow rows[3];
  double levelled[2][columns];
  find_row(-1, rows[0]);
  find_row(0, rows[1]);
  for (int row = 0; row <= InfluenceTables::line_rows.intervals(); ++row) {
    LineRow& behind = rows[(row + 2) % 3];
    find_row(row + 1, behind);
    level_row(rows[row % 3], rows[(row + 1) % 3], behind, levelled[row % 2]);
    if (row == 0) continue;
    double* const cells = influence.anywhere.data() + (row - 1) * columns;
    for (int k = 0; k < columns; ++k) cells[k] = twin(levelled[(row - 1) % 2][k], levelled[row % 2][k]);
  }
}

}  // namespace

double line_potential(double tau, double xi) noexcept {
  // t = xi + tau sinh v makes dt / r = dv; v = middle + half sin(phi) then makes the square root at the ends
  // analytic and periodic in phi, where the midpoint rule converges geometrically.
  const double v_trailing = area_sinh((-1.0 - xi) / tau);
  const double v_leading = area_sinh((1.0 - xi) / tau);
  const double middle = 0.5 * (v_trailing + v_leading);
  const double half = 0.5 * (v_leading - v_trailing);
  const int halvings = tau < 0.3 ? 3 : 2;  // to 1e-9; nearer than 1e-4 to 2e-7
  const int pairs = 1 << halvings;         // pairs of points at sin(phi) and -sin(phi)
  // sin and cos of the step pi / (2 pairs) by halving the angle pi / 2.
  double cosine_step = 0.0, sine_step = 1.0;
  for (int n = 0; n < halvings; ++n) {
    sine_step = std::sqrt(0.5 * (1.0 - cosine_step));
    cosine_step = std::sqrt(0.5 * (1.0 + cosine_step));
  }
  double sine = std::sqrt(0.5 * (1.0 - cosine_step)), cosine = std::sqrt(0.5 * (1.0 + cosine_step));
  // tau sinh(middle +- half sin(phi)) = up e - down / e and up / e - down e, with e = exp(half sin(phi)).
  const double e_middle = natural_exp(middle);
  const double up = 0.5 * tau * e_middle, down = 0.5 * tau / e_middle;
  const auto pressure = [xi](double from_xi) {
    const double t = xi + from_xi;
    return std::sqrt(std::max(0.0, 1.0 - t * t));
  };
  double sum = 0.0;
  for (int n = 0; n < pairs; ++n) {
    const double e = natural_exp(half * sine), inverse = 1.0 / e;
    sum += (pressure(up * e - down * inverse) + pressure(up * inverse - down * e)) * cosine;
    // On by one step of phi: the angle's sum formulas, no trigonometric function of the C library.
    const double next = cosine * cosine_step - sine * sine_step;
    sine = sine * cosine_step + cosine * sine_step;
    cosine = next;
  }
  return 0.5 * sum * half * pi / pairs;
}

void tabulate(InfluenceTables& influence) noexcept {
  // The integral under the mean grows from node to node by Simpson's rule; before the first node it is the
  // logarithm's alone.
  double node = InfluenceTables::distance_axis.node(0);
  double integral = 0.5 * strip_displacement(1.0, -node, node);
  for (int i = 0; i <= InfluenceTables::distance_axis.intervals(); ++i) {
    // Int_0^node J(s, 0) ds / node is the mean that a strip sees at its own middle.
    const double next = InfluenceTables::distance_axis.node(i + 1);
    const double here = line_displacement(1.0, node);
    influence.on_middle_plane[static_cast<std::size_t>(i)] = twin(here, 1.0 / std::sqrt(1.0 + node * node));
    influence.mean_under[static_cast<std::size_t>(i)] = integral / node;
    integral += (next - node) / 6.0 *
                (here + 4.0 * line_displacement(1.0, 0.5 * (node + next)) + line_displacement(1.0, next));
    node = next;
  }
  for (int i = 0; i <= InfluenceTables::distance_axis.intervals(); ++i)
    influence.edge_under[static_cast<std::size_t>(i)] = mean_at_edge(InfluenceTables::distance_axis.node(i));
  tabulate_anywhere(influence);
}

}  // namespace wrc::normal
