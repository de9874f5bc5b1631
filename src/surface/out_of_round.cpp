#include "surface/out_of_round.hpp"

#include <algorithm>
#include <cmath>

namespace wrc {
namespace {

constexpr std::int32_t nodes = OutOfRound::nodes;

/// Second derivatives of the periodic spline through n values at the places x[0] < .. < x[n], of which the
/// last is the first again: a cyclic tridiagonal system by elimination with the corner carried along.
void periodic_second_derivatives(std::int32_t n, const double* x, const double* v, double* second,
                                 double* pivot, double* corner) {
  const auto width = [&](std::int32_t i) { return x[i + 1] - x[i]; };
  const auto value = [&](std::int32_t i) { return v[i % n]; };
  const auto rhs = [&](std::int32_t i) {
    const double before = i == 0 ? width(n - 1) : width(i - 1);
    const double from_before = (value(i) - value(i == 0 ? n - 1 : i - 1)) / before;
    return 6.0 * ((value(i + 1) - value(i)) / width(i) - from_before);
  };
  // Rows 0 .. n - 2, the unknown n - 1 in a column of its own; the last row at the end.
  for (std::int32_t i = 0; i + 1 < n; ++i) {
    const double before = i == 0 ? width(n - 1) : width(i - 1);
    double diagonal = 2.0 * (before + width(i)), right = rhs(i), last = 0.0;
    if (i == 0) {
      last = before;
    } else {
      const double factor = before / pivot[i - 1];
      diagonal -= factor * before;
      right -= factor * second[i - 1];
      last -= factor * corner[i - 1];
    }
    if (i + 2 == n) last += width(i);
    pivot[i] = diagonal;
    second[i] = right;
    corner[i] = last;
  }
  // unknown i = (second - corner * last - width(i) * next) / pivot, for the next but the last
  for (std::int32_t i = n - 2; i >= 0; --i) {
    if (i + 2 < n) {
      second[i] -= width(i) * second[i + 1];
      corner[i] -= width(i) * corner[i + 1];
    }
    second[i] /= pivot[i];
    corner[i] /= pivot[i];
  }
  const double w = width(n - 1), before = width(n - 2);
  second[n - 1] = (rhs(n - 1) - before * second[n - 2] - w * second[0]) /
                  (2.0 * (before + w) - before * corner[n - 2] - w * corner[0]);
  for (std::int32_t i = 0; i + 1 < n; ++i) second[i] -= corner[i] * second[n - 1];
}

/// The deviation at equal steps of the angle.
void sample(const RadiusTable& table, const double* deviation, const double* second, double* to) {
  std::int32_t k = 0;
  for (std::int32_t i = 0; i < nodes; ++i) {
    const double at = 2.0 * pi * i / nodes;
    while (k + 2 < table.angles && at >= table.angle[k + 1]) ++k;
    const double h = table.angle[k + 1] - table.angle[k], b = (at - table.angle[k]) / h, a = 1.0 - b;
    const std::int32_t next = k + 2 < table.angles ? k + 1 : 0;
    to[i] = a * deviation[k] + b * deviation[next] +
            h * h / 6.0 * ((a * a * a - a) * second[k] + (b * b * b - b) * second[next]);
  }
}

/// The envelope of its parabolas: the largest at the nodes, and the top of the parabola through it and its
/// neighbours.
void find_reach(const double* deviation, double radius, double* reach) {
  const double step = 2.0 * pi / nodes;
  double low = deviation[0], high = deviation[0];
  for (std::int32_t i = 1; i < nodes; ++i) {
    low = std::min(low, deviation[i]);
    high = std::max(high, deviation[i]);
  }
  const auto furthest =
      std::min(static_cast<std::int32_t>(std::sqrt(2.0 * (high - low) / radius) / step) + 2, nodes / 4);
  for (std::int32_t i = 0; i < nodes; ++i) {
    const auto at = [&](std::int32_t j) {
      return deviation[(i + j + nodes) % nodes] - 0.5 * radius * (step * j) * (step * j);
    };
    std::int32_t best = 0;
    for (std::int32_t j = 1; j <= furthest; ++j) {
      if (at(j) > at(best)) best = j;
      if (at(-j) > at(best)) best = -j;
    }
    const double middle = at(best), before = at(best - 1), behind = at(best + 1);
    const double bend = before - 2.0 * middle + behind, lean = 0.5 * (behind - before);
    reach[i] = bend < 0.0 ? middle - 0.5 * lean * lean / bend : middle;
  }
}

}  // namespace

std::int64_t out_of_round_doubles(const RadiusTable& table) {
  if (table.rows == 0) return 0;
  return 2 * static_cast<std::int64_t>(table.rows) * nodes + 3 * static_cast<std::int64_t>(table.angles) +
         5 * static_cast<std::int64_t>(nodes) + 1;
}

void make_out_of_round(const RadiusTable& table, double radius, double* memory, OutOfRound& wheel) {
  wheel = {};
  wheel.rows = table.rows;
  wheel.radius = radius;
  double* const value = memory;
  double* const second = value + static_cast<std::int64_t>(table.rows) * nodes;
  double* const given = second + static_cast<std::int64_t>(table.rows) * nodes;
  double *const pivot = given + table.angles, *const corner = pivot + table.angles;
  double *const sampled = corner + table.angles, *const place = sampled + nodes,
                *const scratch = place + nodes + 1;
  for (std::int32_t i = 0; i <= nodes; ++i) place[i] = i;
  for (std::int32_t r = 0; r < table.rows; ++r) {
    if (table.rows > 1) wheel.y[r] = table.y[r];
    const double* const deviation = table.deviation + static_cast<std::int64_t>(r) * table.angles;
    periodic_second_derivatives(table.angles - 1, table.angle, deviation, given, pivot, corner);
    sample(table, deviation, given, sampled);
    double* const reach = value + static_cast<std::int64_t>(r) * nodes;
    find_reach(sampled, radius, reach);
    periodic_second_derivatives(nodes, place, reach, second + static_cast<std::int64_t>(r) * nodes, scratch,
                                scratch + nodes);
    for (std::int32_t i = 0; i < nodes; ++i) wheel.largest = std::max(wheel.largest, reach[i]);
  }
  wheel.value = value;
  wheel.second = second;
}

}  // namespace wrc
