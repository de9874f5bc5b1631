/// Kinematics and statics of one strip, in rail axes, of plain numbers and of numbers that carry derivatives.
///
/// A strip presses at r = (x, w_y, w_z) from the wheel's reference point; its mean normal n = (0, n_y, n_z)
/// points into the rail, its lateral axis is t = (0, n_z, -n_y). Where the rail has a grade g along the
/// track, its tangent is (1, g n) and its normal (-g, n), to first order in g.
///
///     velocity of the wheel over the rail   v = V + omega x r
///     slip velocities                       v_x + g v.n,  v.t;  spin omega.n
///     approach                              v.n - g v_x
///     force on the wheel                    F = f_x (1, g n) + f_y t - N (-g, n)
///     moment about the reference point      M = r x F + m_z n
#pragma once

#include "surface/geometry/overlap.hpp"
#include "surface/wrench/relative_motion.hpp"

namespace wrc::surface {

/// Velocities of the wheel over the rail at a strip: along x, along its lateral axis, towards the rail [m/s],
/// and the spin about its normal [rad/s].
template <class Number>
struct StripMotion {
  Number along, across, approach, spin;
};

/// The motion at a strip that presses at `x` [m]. `graded`: does the rail have a grade anywhere? Overlap and
/// x may have fewer derivatives than velocities.
template <class Number, class Place>
StripMotion<Number> motion_at(const RelativeVelocityOf<Number>& v, const StripOverlap<Place>& o,
                              const Place& x, bool graded) {
  const auto& omega = v.angular;
  Number vx = v.linear[0] + omega[1] * o.wz - omega[2] * o.wy;
  // a roller's own point, as the wheel's, is that of the undeformed body: the overlap nearer to its axle
  if (v.on_roller) vx += v.roller * (o.depth * o.nz);
  // v = V + omega x r, then its parts along lateral axis and normal
  const Number vy = v.linear[1] + omega[2] * x - omega[0] * o.wz;
  const Number vz = v.linear[2] + omega[0] * o.wy - omega[1] * x;
  StripMotion<Number> m{vx, vy * o.nz - vz * o.ny, vy * o.ny + vz * o.nz, omega[1] * o.ny + omega[2] * o.nz};
  if (graded) {
    m.along = vx + o.grade * m.approach;
    m.approach = m.approach - o.grade * vx;
  }
  return m;
}

/// Forces on the wheel at a strip: normal force N, tangential forces fx and fy [N], moment mz about the
/// normal [N m].
template <class Number>
struct StripForce {
  Number N, fx, fy, mz;
};

/// Adds the forces at a strip that presses at `x` [m] to force [N] and moment [N m]. `graded`: as in
/// motion_at().
template <class Number, class Place>
void add_force(const StripOverlap<Place>& o, const Place& x, bool graded, const StripForce<Number>& strip,
               Number (&force)[3], Number (&moment)[3]) {
  const auto& [N, fx, fy, mz] = strip;
  // in rail axes: tangential forces and pressure, then the parts that a grade turns into one another
  Number Fx = fx, Fy = fy * o.nz - N * o.ny, Fz = -(fy * o.ny) - N * o.nz;
  if (graded) {
    Fy += o.grade * fx * o.ny;
    Fz += o.grade * fx * o.nz;
    Fx += o.grade * N;
  }
  // sums, moments by r x F + m_z n
  force[0] += Fx;
  force[1] += Fy;
  force[2] += Fz;
  moment[0] += o.wy * Fz - o.wz * Fy;
  moment[1] += o.wz * Fx - x * Fz + mz * o.ny;
  moment[2] += x * Fy - o.wy * Fx + mz * o.nz;
}

}  // namespace wrc::surface
