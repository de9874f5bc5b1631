/// A wheel whose radius changes round it: a flat, a polygon, a measurement.
///
/// On a rail that is nearly level along the track over the length of a contact, a wheel of the deviation
/// d(theta) from its radius r touches where r(theta) reaches deepest: turned by tau its surface lies
///
///     D(tau) = max over xi of  d(tau + xi / r) - xi^2 / (2 r)
///
/// deeper than the round one's, at xi = D'(tau) before its lowest point, and is curved there by
/// (1 / r) / (1 + D''(tau) / r) (all from the envelope's condition; xi is a length, primes are by the angle).
/// So a step needs one reading of D, found when the model is made, and hollows that never touch are bridged
/// as the rail does. D is a periodic cubic spline over equal steps of the angle; the curvature is that of D
/// over 3 mm to both sides, which an elastic contact is long, within a tenth and five times the round one's.
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
};

/// Arrays of a wheel that is not round, and of its making.
struct OutOfRoundArrays {
  double *value, *second;                      ///< rows times nodes
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

/// Reach of one row.
template <class Number>
Reach<Number> row_at(const OutOfRound& wheel, std::int32_t row, const Number& angle) {
  // interval of the angle between two nodes, the last of which is the first
  constexpr double per_turn = 1.0 / (2.0 * pi), n = OutOfRound::nodes;
  double turns = value_of(angle) * per_turn;
  turns -= std::floor(turns);
  double place = turns * n;
  auto i = static_cast<std::int32_t>(place);
  if (i >= OutOfRound::nodes) i = OutOfRound::nodes - 1;
  const std::int32_t next = i + 1 < OutOfRound::nodes ? i + 1 : 0;
  const double *const v = wheel.value + static_cast<std::int64_t>(row) * OutOfRound::nodes,
                      *const m = wheel.second + static_cast<std::int64_t>(row) * OutOfRound::nodes;
  // cubic spline with weights a, b: D, dD/d(node), d2D/d(node)2
  const double b = place - i, a = 1.0 - b, per_angle = n * per_turn;
  const double depth = a * v[i] + b * v[next] + ((a * a * a - a) * m[i] + (b * b * b - b) * m[next]) / 6.0;
  const double slope = v[next] - v[i] + ((1.0 - 3.0 * a * a) * m[i] + (3.0 * b * b - 1.0) * m[next]) / 6.0;
  const double bend = a * m[i] + b * m[next];
  return {with_slope(angle, depth, slope * per_angle),
          with_slope(angle, slope * per_angle, bend * per_angle * per_angle)};
}

}  // namespace out_of_round

template <class Number>
Reach<Number> reach_at(const OutOfRound& wheel, const Number& y, const Number& angle) {
  std::int32_t row = 0;
  while (row + 2 < wheel.rows && value_of(y) > wheel.y[row + 1]) ++row;
  const Reach<Number> here = out_of_round::row_at(wheel, row, angle);
  if (wheel.rows == 1) return here;
  // between two rows by 3 t^2 - 2 t^3, whose slope is zero at each row
  const Reach<Number> there = out_of_round::row_at(wheel, row + 1, angle);
  const Number t =
      smaller(larger((y - wheel.y[row]) / (wheel.y[row + 1] - wheel.y[row]), Number(0.0)), Number(1.0));
  const Number part = t * t * (3.0 - 2.0 * t);
  return {here.depth + part * (there.depth - here.depth), here.slope + part * (there.slope - here.slope)};
}

}  // namespace wrc::surface
