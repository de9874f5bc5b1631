/// A wheel whose radius changes round it: a flat, a polygon, a measurement.
///
/// On a rail that is nearly level along the track over the length of a contact, a wheel of the deviation
/// d(theta) from its radius r touches where r(theta) reaches deepest: turned by tau its surface lies
///
///     D(tau) = max over xi of  d(tau + xi / r) - xi^2 / (2 r)
///
/// deeper than the round one's, at xi = D'(tau) before its lowest point, and is curved there by
/// (1 / r) / (1 + D''(tau) / r) (all from the envelope's condition; xi is a length, primes are by the angle).
/// So hollows that never touch are bridged as the rail does. The least surface that reaches so deep is
///
///     d*(theta) = min over tau of  D(tau) + r (theta - tau)^2 / 2:
///
/// d itself wherever the rail can touch it, and a chord over hollows. Both are found when the model is made,
/// as periodic cubic splines over equal steps of the angle. A step reads D for depth and place, and d* where
/// the contact's edges will be for the curvature there.
#pragma once

#include <cstdint>

#include "base/arena.hpp"
#include "base/elementary.hpp"
#include "base/fault.hpp"
#include "base/number.hpp"
#include "surface/geometry/varying_rail.hpp"

namespace wrc::surface {

/// Deviations as given: row by row, at angles from 0 to 2 pi.
struct RadiusTable {
  std::int32_t angles = 0, rows = 0;
  const double* angle = nullptr;      ///< [rad]
  const double* y = nullptr;          ///< place of each row on the wheel's profile [m]; not read with one row
  const double* deviation = nullptr;  ///< rows times angles [m]
};

inline constexpr std::int32_t most_radius_rows = 16;

struct OutOfRound {
  static constexpr std::int32_t nodes = 32768;
  std::int32_t rows = 0;  ///< 0: round
  double radius = 0.0;    ///< nominal [m]
  double largest = 0.0;   ///< largest D, or 0 [m]
  double y[most_radius_rows] = {};
  const double *value = nullptr, *second = nullptr;  ///< D, and its second derivative by the node's number
  const double *surface = nullptr, *surface_second = nullptr;  ///< the same of d*
};

/// Arrays of a wheel that is not round, and of its making.
struct OutOfRoundArrays {
  double *value, *second;                      ///< rows times nodes
  double *surface, *surface_second;            ///< the same
  double *given, *given_pivot, *given_corner;  ///< over the table's angles
  double *sampled, *corner;                    ///< over the nodes
  std::int32_t* place;                         ///< over the nodes
};
OutOfRoundArrays cut_out_of_round(Arena& arena, const RadiusTable& table);

/// From a table that has been checked, in arrays for it.
OutOfRound make_out_of_round(const RadiusTable& table, double radius, const OutOfRoundArrays& arrays);

/// D and its derivative by the angle at an angle, on the wheel's profile at y [m].
template <class Number>
struct Reach {
  Number depth, slope;  ///< [m], [m/rad]
};

namespace out_of_round {

/// One row of the spline of values and second derivatives.
template <class Number>
Reach<Number> spline_at(const double* value, const double* second, std::int32_t row, const Number& angle) {
  // interval of the angle between two nodes, the last of which is the first
  constexpr double per_turn = 1.0 / (2.0 * pi), n = OutOfRound::nodes;
  double turns = value_of(angle) * per_turn;
  turns -= std::floor(turns);
  double place = turns * n;
  auto i = static_cast<std::int32_t>(place);
  if (i >= OutOfRound::nodes) i = OutOfRound::nodes - 1;
  const std::int32_t next = i + 1 < OutOfRound::nodes ? i + 1 : 0;
  const std::int64_t first = static_cast<std::int64_t>(row) * OutOfRound::nodes;
  const double *const v = value + first, *const m = second + first;
  // cubic spline with weights a, b: D, dD/d(node), d2D/d(node)2
  const double b = place - i, a = 1.0 - b, per_angle = n * per_turn;
  const double depth = a * v[i] + b * v[next] + ((a * a * a - a) * m[i] + (b * b * b - b) * m[next]) / 6.0;
  const double slope = v[next] - v[i] + ((1.0 - 3.0 * a * a) * m[i] + (3.0 * b * b - 1.0) * m[next]) / 6.0;
  const double bend = a * m[i] + b * m[next];
  return {with_slope(angle, depth, slope * per_angle),
          with_slope(angle, slope * per_angle, bend * per_angle * per_angle)};
}

}  // namespace out_of_round

namespace out_of_round {

/// Slope across the tread, of the depth and of its derivative by the angle, at a row between two secants a
/// and b. Their mean m by the parabola through the three rows, times f(w), w = 2 a b / (a^2 + b^2): where
/// they agree a straight slope stays one; where one is zero a flat's rim does not overshoot.
template <class Number>
Reach<Number> slope_between(const Reach<Number>& a, const Reach<Number>& b, double share_of_a) {
  // f = 1 - (1 - w^2)^2
  const double share_of_b = 1.0 - share_of_a;
  const Reach<Number> m{share_of_a * a.depth + share_of_b * b.depth,
                        share_of_a * a.slope + share_of_b * b.slope};
  const Number squares = a.depth * a.depth + b.depth * b.depth;
  if (!(value_of(squares) > 0.0)) return {Number(0.0), Number(0.0)};
  const Number per = Number(1.0) / squares, w = 2.0 * (a.depth * b.depth) * per;
  const Number dw =
      2.0 * per * (a.slope * b.depth + a.depth * b.slope - w * (a.depth * a.slope + b.depth * b.slope));
  const Number rest = 1.0 - w * w, f = 1.0 - rest * rest;
  return {m.depth * f, m.slope * f + m.depth * (4.0 * rest * w * dw)};
}

/// Between rows by a cubic of their values and slopes: continuously differentiable across the tread, and
/// straight where the rows lie on a line. `row_at`: depth and its slope by the angle, of a row.
template <class Number, class RowAt>
Reach<Number> across_rows(const OutOfRound& wheel, const Number& y, const RowAt& row_at) {
  std::int32_t row = 0;
  while (row + 2 < wheel.rows && value_of(y) > wheel.y[row + 1]) ++row;
  const Reach<Number> here = row_at(row);
  if (wheel.rows == 1) return here;
  const Reach<Number> there = row_at(row + 1);
  const double apart = wheel.y[row + 1] - wheel.y[row], per = 1.0 / apart;
  const auto secant = [](const Reach<Number>& from, const Reach<Number>& to, double inverse) {
    return Reach<Number>{(to.depth - from.depth) * inverse, (to.slope - from.slope) * inverse};
  };
  // slopes at both rows; at the outermost the secant itself
  const Reach<Number> rise = secant(here, there, per);
  Reach<Number> left = rise, right = rise;
  if (row > 0) {
    const double before = wheel.y[row] - wheel.y[row - 1];
    left = slope_between(secant(row_at(row - 1), here, 1.0 / before), rise, apart / (apart + before));
  }
  if (row + 2 < wheel.rows) {
    const double behind = wheel.y[row + 2] - wheel.y[row + 1];
    right = slope_between(rise, secant(there, row_at(row + 2), 1.0 / behind), behind / (apart + behind));
  }
  // Hermite's cubic, constant beyond the outermost rows
  const Number t = smaller(larger((y - wheel.y[row]) * per, Number(0.0)), Number(1.0)), rest = 1.0 - t;
  const Number bent = apart * t * rest;
  const auto cubic = [&](const Number& from, const Number& r, const Number& l, const Number& to) {
    return from + apart * t * r + bent * (rest * (l - r) + t * (r - to));
  };
  return {cubic(here.depth, rise.depth, left.depth, right.depth),
          cubic(here.slope, rise.slope, left.slope, right.slope)};
}

}  // namespace out_of_round

template <class Number>
Reach<Number> reach_at(const OutOfRound& wheel, const Number& y, const Number& angle) {
  return out_of_round::across_rows(wheel, y, [&](std::int32_t row) {
    return out_of_round::spline_at(wheel.value, wheel.second, row, angle);
  });
}

/// The deviation d* at an angle of the wheel, and its slope: of the surface that a rail can touch.
template <class Number>
Reach<Number> surface_at(const OutOfRound& wheel, const Number& y, const Number& angle) {
  return out_of_round::across_rows(wheel, y, [&](std::int32_t row) {
    return out_of_round::spline_at(wheel.surface, wheel.surface_second, row, angle);
  });
}

}  // namespace wrc::surface
