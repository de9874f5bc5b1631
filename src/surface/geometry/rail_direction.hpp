/// A rail that runs aslant of the track: axes along it, and the track's in these.
///
/// T is the smallest rotation that takes x into the rail's direction d, so that the rail does not roll:
///
///     T v = (d_x v_x - a, v_y + d_y f, v_z + d_z f),    a = d_y v_y + d_z v_z,    f = v_x - a / (1 + d_x).
///
/// A section of a rail that stands square to the track, seen along d, is that section shortened towards d
/// and not rolled: T is the rotation in the polar decomposition of that shear. Number is double, or one that
/// carries derivatives.
#pragma once

#include "base/number.hpp"

namespace wrc::surface {

/// A unit vector, track axes.
template <class Number>
struct RailDirection {
  Number x = 1.0, y = 0.0, z = 0.0;
};

/// From the rail's slopes dy/dx and dz/dx [-].
template <class Number>
RailDirection<Number> direction_of(const Number& slope_y, const Number& slope_z) {
  const Number x = Number(1.0) / root(1.0 + slope_y * slope_y + slope_z * slope_z);
  return {x, slope_y * x, slope_z * x};
}

/// Replaces v by T v: from axes along the rail to those of the track.
template <class Number>
void turn_into_track(const RailDirection<Number>& d, Number* v) {
  const Number aside = d.y * v[1] + d.z * v[2], ahead = v[0] - aside / (1.0 + d.x);
  v[0] = d.x * v[0] - aside;
  v[1] = v[1] + d.y * ahead;
  v[2] = v[2] + d.z * ahead;
}

/// Replaces v by the inverse of T times v: from track axes to those along the rail.
template <class Number>
void turn_along_rail(const RailDirection<Number>& d, Number* v) {
  turn_into_track({d.x, -d.y, -d.z}, v);
}

}  // namespace wrc::surface
