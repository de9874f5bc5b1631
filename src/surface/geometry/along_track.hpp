/// Changes of a strip's overlap (overlap.hpp) by a rail that varies along the track and by a wheel that is
/// not round. The overlap is found as if neither were so: the rail as it is below the wheel's reference
/// point.
///
/// The overlap over x is then d - kappa/2 (x - W_x)^2 less the fall of the rail's surface along its normal,
/// n.(P(X + x) - P(X)). Its largest value gives depth, place and curvature; the grade there is n.P'. The
/// wheel's reach (out_of_round.hpp) at the angle that lies there is added.
/// Number is double, or one that carries derivatives.
#pragma once

#include "base/number.hpp"
#include "surface/geometry/out_of_round.hpp"
#include "surface/geometry/overlap.hpp"
#include "surface/geometry/varying_rail.hpp"

namespace wrc::surface {

/// A concave rail is curved less than the wheel by this at least, else both would touch twice along x.
inline constexpr double least_curvature_left = 0.2;

/// Adds the rail's change. `distance`: of the wheel's reference point, as far as there are sections [m];
/// `blend`: of each face there.
template <class Number>
void follow_rail(const VaryingRail& rail, std::int32_t strip, const Number& distance,
                 const SectionBlend* blend, StripOverlap<Number>& o) {
  const std::int32_t face = face_of(rail, strip);
  const double kappa = value_of(o.curvature), middle = value_of(o.centre);
  const auto grade_at = [&](const StripAlongTrack<Number>& s) { return o.ny * s.slope_y + o.nz * s.slope_z; };
  const auto bend_at = [&](const StripAlongTrack<Number>& s) {
    return o.ny * s.curvature_y + o.nz * s.curvature_z;
  };
  const auto curvature_left = [&](double bend) { return larger(kappa + bend, least_curvature_left * kappa); };
  // Newton's step to the place of the largest overlap, kappa (x - W_x) + n.P'(X + x) = 0, from the rail's
  // slope and curvature below the wheel, in plain numbers.
  const StripAlongTrack<Number> here = strip_at(rail, blend[face], strip, distance);
  constexpr double furthest = 0.05;  // [m]: a slope of 1:9
  const double here_bend = value_of(bend_at(here)), here_grade = value_of(grade_at(here));
  const double shift = (here_grade + here_bend * middle) / curvature_left(here_bend);
  const double x = middle - smaller(larger(shift, -furthest), furthest);
  // One more step, from the rail as it is there, whose derivatives are those of the place that is sought.
  const Number there = distance + Number(x);
  const SectionBlend near_blend = blend_at(rail, rail.face[face], value_of(there), blend[face]);
  const StripAlongTrack<Number> near = strip_at(rail, near_blend, strip, there);
  const Number grade = grade_at(near), bend = bend_at(near);
  const double stiff = curvature_left(value_of(bend));
  const Number further = -((o.curvature * (Number(x) - o.centre) + grade) * Number(1.0 / stiff));
  const Number at = Number(x) + further, from_middle = at - o.centre;
  // Overlap there: d less the wheel's rise and the rail's fall. The wheel's point moves up by its rise.
  const Number rounded = 0.5 * o.curvature * from_middle * from_middle;
  const Number fallen =
      o.ny * (near.y - here.y) + o.nz * (near.z - here.z) + further * (grade + 0.5 * bend * further);
  o.depth = o.depth - rounded - fallen;
  o.wy = o.wy - o.ny * rounded;
  o.wz = o.wz - o.nz * rounded;
  o.grade = grade + bend * further;
  o.curvature = larger(o.curvature + bend, least_curvature_left * o.curvature);
  o.centre = at;
}

/// Adds the fall of a roller whose radius is 1 / curvature at the profile's origin, to a strip at the height
/// z below that. `distance`: of the wheel's reference point from above its axle [m]. Its surface falls like
/// x^2 / (2 radius).
template <class Number>
void follow_roller(double curvature, double z, const Number& distance, StripOverlap<Number>& o) {
  constexpr double least_radius = 0.02;  // [m]: of faces that no wheel reaches
  const double radius = larger(1.0 / curvature - z, least_radius);
  // d - kappa/2 (x - W_x)^2 - bend/2 (x + X)^2, largest at x = W_x - off
  const Number bend = larger(o.nz, Number(0.0)) * (1.0 / radius);  // along the normal
  const Number sum = o.curvature + bend;
  const Number off = bend * (o.centre + distance) / sum;  // from the wheel's own middle, backwards
  const Number at = o.centre - off, from_axle = at + distance;
  const Number rounded = 0.5 * o.curvature * off * off;
  o.depth = o.depth - rounded - 0.5 * bend * from_axle * from_axle;
  o.wy = o.wy - o.ny * rounded;
  o.wz = o.wz - o.nz * rounded;
  o.grade = bend * from_axle;
  o.curvature = sum;
  o.centre = at;
}

/// Adds the wheel's deviation from round. `y`: on its profile [m]; `angle`: about its axle [rad].
template <class Number>
void follow_wheel(const OutOfRound& wheel, const RelativePoseOf<Number>& pose, const Number& y,
                  const Number& angle, StripOverlap<Number>& o) {
  constexpr double looked_over = 3e-3, least = 0.2, most = 10.0;
  const auto& R = pose.rotation;
  // the radius to the place, in the rail's axes
  const Number along = R[0][1] * o.centre + R[1][1] * o.wy + R[2][1] * o.wz;
  const Number ry = o.wy - along * R[1][1], rz = o.wz - along * R[2][1];
  // angle of the place before the lowest point: its sine to the third order, less the wheel's angle
  const Number before = R[0][0] * o.centre + R[1][0] * o.wy + R[2][0] * o.wz;  // along the body's x
  const Number below = R[0][2] * o.centre + R[1][2] * o.wy + R[2][2] * o.wz;
  const Number per_radius = Number(1.0) / root(before * before + below * below);
  const Number sine = before * per_radius;
  const Number turned = sine * (1.0 + sine * sine / 6.0) - angle;
  const Number outwards = (ry * o.ny + rz * o.nz) * per_radius;
  // D, D' there, and D'' over 3 mm to both sides, which bends the wheel's circle
  const double step = looked_over / wheel.radius;
  const Reach<Number> here = reach_at(wheel, y, turned);
  const Reach<Number> front = reach_at(wheel, y, turned + Number(step)),
                      back = reach_at(wheel, y, turned - Number(step));
  const Number bend = (front.depth - here.depth - (here.depth - back.depth)) / (step * step * wheel.radius);
  // the reach acts along the radius: its part along the strip's normal deepens the overlap
  const Number deeper = outwards * here.depth;
  o.depth = o.depth + deeper;
  o.wy = o.wy + o.ny * deeper;
  o.wz = o.wz + o.nz * deeper;
  o.centre = o.centre + R[0][0] * here.slope;
  o.curvature = o.curvature / smaller(larger(1.0 + bend, Number(least)), Number(most));
}

}  // namespace wrc::surface
