#include "surface/geometry/out_of_round.hpp"

#include <algorithm>
#include <cmath>

namespace wrc::surface {
namespace {

constexpr std::int32_t nodes = OutOfRound::nodes;

/// Second derivatives of the periodic spline through n values, the next of which is width(i) further on, the
/// first again behind the last: a cyclic tridiagonal system by elimination with the corner carried along.
template <class Width>
void periodic_second_derivatives(std::int32_t n, const Width& width, const double* v, double* second,
                                 double* pivot, double* corner) {
  const auto value = [&](std::int32_t i) { return v[i % n]; };
  const auto rhs = [&](std::int32_t i) {
    const double before = i == 0 ? width(n - 1) : width(i - 1);
    const double from_before = (value(i) - value(i == 0 ? n - 1 : i - 1)) / before;
    return 6.0 * ((value(i + 1) - value(i)) / width(i) - from_before);
  };
  // Rows 0 .. n - 2 by forward elimination, the unknown n - 1 in a column of its own (`corner`):
  // before m_(i-1) + 2 (before + width) m_i + width m_(i+1) = 6 (difference of the secants).
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
  // the last row, in which both neighbours are known up to the last unknown, and that put into all others
  const double w = width(n - 1), before = width(n - 2);
  second[n - 1] = (rhs(n - 1) - before * second[n - 2] - w * second[0]) /
                  (2.0 * (before + w) - before * corner[n - 2] - w * corner[0]);
  for (std::int32_t i = 0; i + 1 < n; ++i) second[i] -= corner[i] * second[n - 1];
}

/// The deviation at equal steps of the angle.
void sample(const RadiusTable& table, const double* deviation, const double* second, double* to) {
  std::int32_t k = 0;
  for (std::int32_t i = 0; i < nodes; ++i) {
    // interval of the table that holds the angle, and the spline there
    const double at = 2.0 * pi * i / nodes;
    while (k + 2 < table.angles && at >= table.angle[k + 1]) ++k;
    const double h = table.angle[k + 1] - table.angle[k], b = (at - table.angle[k]) / h, a = 1.0 - b;
    const std::int32_t next = k + 2 < table.angles ? k + 1 : 0;
    to[i] = a * deviation[k] + b * deviation[next] +
            h * h / 6.0 * ((a * a * a - a) * second[k] + (b * b * b - b) * second[next]);
  }
}

/// Parabolas -r off^2 / 2 below each node's value: at every node, the number of the node whose is highest.
class Parabolas {
 public:
  Parabolas(const double* value, double radius) : value_(value), radius_(radius) {}

  /// The parabola of node k at node i; nodes count on round the wheel.
  double at(std::int32_t i, std::int32_t k) const {
    const double off = step * (k - i);
    return value_[(k + nodes) % nodes] - 0.5 * radius_ * off * off;
  }
  void find_highest(std::int32_t* place) const {
    // a parabola further away than sqrt(2 (high - low) / r) lies below the one of the node itself
    double low = value_[0], high = value_[0];
    for (std::int32_t i = 1; i < nodes; ++i) {
      low = std::min(low, value_[i]);
      high = std::max(high, value_[i]);
    }
    const auto furthest =
        std::min(static_cast<std::int32_t>(std::sqrt(2.0 * (high - low) / radius_) / step) + 2, nodes / 4);
    // The place of the highest never goes back as the wheel turns on: that of a node lies between those of
    // the nodes to both sides, which halves the search at each level.
    place[0] = highest(0, -furthest, furthest);
    for (std::int32_t apart = nodes / 2; apart > 0; apart /= 2)
      for (std::int32_t i = apart; i < nodes; i += 2 * apart) {
        const std::int32_t next = i + apart < nodes ? place[i + apart] : place[0] + nodes;
        place[i] = highest(i, std::max(place[i - apart], i - furthest), std::min(next, i + furthest));
      }
  }
  /// Top of the parabola through those of node k and its neighbours at node i.
  double top(std::int32_t i, std::int32_t k) const {
    const double middle = at(i, k), before = at(i, k - 1), behind = at(i, k + 1);
    const double bend = before - 2.0 * middle + behind, rise = 0.5 * (behind - before);
    return bend < 0.0 ? middle - 0.5 * rise * rise / bend : middle;
  }
  static constexpr double step = 2.0 * pi / nodes;

 private:
  std::int32_t highest(std::int32_t i, std::int32_t from, std::int32_t to) const {
    std::int32_t best = from;
    for (std::int32_t k = from + 1; k <= to; ++k)
      if (at(i, k) > at(i, best)) best = k;
    return best;
  }
  const double* value_;
  double radius_;
};

/// The reach D: the envelope of the deviation's parabolas at the nodes, and of those of the deviations given
/// between these, where an edge may stand out. `place`: scratch.
void find_reach(const RadiusTable& table, const double* given, const double* deviation, double radius,
                std::int32_t* place, double* reach) {
  constexpr double step = Parabolas::step;
  const Parabolas parabolas(deviation, radius);
  parabolas.find_highest(place);
  const double* const end = table.angle + table.angles;
  for (std::int32_t i = 0; i < nodes; ++i) {
    const std::int32_t best = place[i];
    reach[i] = parabolas.top(i, best);
    // deviations given in the two intervals beside it
    for (const std::int32_t k : {best - 1, best}) {
      const double from = step * ((k + nodes) % nodes);
      for (const double* a = std::lower_bound(table.angle, end, from); a < end && *a < from + step; ++a) {
        const double off = step * (k - i) + (*a - from);
        reach[i] = std::max(reach[i], given[a - table.angle] - 0.5 * radius * off * off);
      }
    }
  }
}

/// The least surface d* that reaches so: -d* is the envelope of the parabolas of -D. `reach` is turned over
/// and back.
void find_surface(double* reach, double radius, std::int32_t* place, double* surface) {
  for (std::int32_t i = 0; i < nodes; ++i) reach[i] = -reach[i];
  const Parabolas parabolas(reach, radius);
  parabolas.find_highest(place);
  for (std::int32_t i = 0; i < nodes; ++i) surface[i] = -parabolas.top(i, place[i]);
  for (std::int32_t i = 0; i < nodes; ++i) reach[i] = -reach[i];
}

}  // namespace

OutOfRoundArrays cut_out_of_round(Arena& arena, const RadiusTable& table) {
  OutOfRoundArrays a;
  const std::int64_t all = static_cast<std::int64_t>(table.rows) * nodes;
  arena.each(all, a.value, a.second, a.surface, a.surface_second);
  arena.each(table.angles, a.given, a.given_pivot, a.given_corner);
  arena.each(nodes, a.sampled, a.corner);
  a.place = arena.take<std::int32_t>(nodes);
  return a;
}

OutOfRound make_out_of_round(const RadiusTable& table, double radius, const OutOfRoundArrays& a) {
  OutOfRound wheel;
  wheel.rows = table.rows;
  wheel.radius = radius;
  wheel.value = a.value;
  wheel.second = a.second;
  wheel.surface = a.surface;
  wheel.surface_second = a.surface_second;
  const auto apart = [&](std::int32_t i) { return table.angle[i + 1] - table.angle[i]; };
  const auto one_apart = [](std::int32_t) { return 1.0; };
  for (std::int32_t r = 0; r < table.rows; ++r) {
    if (table.rows > 1) wheel.y[r] = table.y[r];
    // The row's deviation through a spline over the angles given, sampled at the nodes.
    const double* const deviation = table.deviation + static_cast<std::int64_t>(r) * table.angles;
    periodic_second_derivatives(table.angles - 1, apart, deviation, a.given, a.given_pivot, a.given_corner);
    sample(table, deviation, a.given, a.sampled);
    // Its reach D, and the spline through that. The samples are free then.
    const std::int64_t first = static_cast<std::int64_t>(r) * nodes;
    double *const reach = a.value + first, *const surface = a.surface + first;
    find_reach(table, deviation, a.sampled, radius, a.place, reach);
    find_surface(reach, radius, a.place, surface);
    periodic_second_derivatives(nodes, one_apart, reach, a.second + first, a.sampled, a.corner);
    periodic_second_derivatives(nodes, one_apart, surface, a.surface_second + first, a.sampled, a.corner);
    for (std::int32_t i = 0; i < nodes; ++i) wheel.largest = std::max(wheel.largest, reach[i]);
  }
  return wheel;
}

}  // namespace wrc::surface
