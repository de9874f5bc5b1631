/// One step of a march through the slip zone: the direction e of the traction turns against the slip w.
///
/// Over a step dv the angle from -w to e, delta, becomes 2 atan(tan(delta/2) / q) with q = 1 + z + z^2/2 and
/// z = 2 dv |w| / d (march.hpp). w, whose y part changes by -rate per length, is taken where a direction that
/// decays like 1 / q would see it: mid-step for small z, the cell itself for large z.
///
/// With z = n / d everything here is homogeneous in n and d, and the length of the turned direction is known
/// from the half angles: a step takes two roots and one divide. The second root serves lanes that stick again
/// for the length of their traction.
#pragma once

#include "tangential/simd/kernels.hpp"
#include "simd/pack.hpp"

namespace wrc::simd {
namespace {

/// What turns e, at a cell.
struct Slip {
  Pack dv;       ///< from where the last step ended (or slip set in) to the cell
  Pack wx, wy;   ///< slip at the cell; per unit of d
  Pack rate_dv;  ///< w at the last step's end is (wx, wy + rate dv)
  Pack d;        ///< what resists turning
};

/// What a step computes on its way, for its derivatives.
struct Turn {
  Pack wy_mid, w_mid;      ///< slip at mid-step and the size of that
  Pack n, Q, D, scale;     ///< z = n / d, scale = 2 d + n, D = 2 d^2, q = Q / D
  Pack Wx, Wy, R, across;  ///< slip as seen, times scale; R = |W|, across = R sin(delta); or R = |trial|
  Pack inverse;            ///< one over the length of the turned direction, T R; over |trial| where it sticks
  Mask moves;              ///< has a new direction
};

/// Turns (ex, ey), in lanes of `stick` into the direction of the traction (trial_x, trial_y).
inline Turn turn(const Slip& slip, Pack wy_mid, Mask stick, Pack trial_x, Pack trial_y, Pack trial2, Pack& ex,
                 Pack& ey) {
  const Pack zero = 0.0, d = slip.d, twice_d = d + d;
  Turn t;
  t.wy_mid = wy_mid;
  t.w_mid = root(slip.wx * slip.wx + wy_mid * wy_mid);
  t.n = (slip.dv + slip.dv) * t.w_mid;
  t.scale = twice_d + t.n;
  t.D = twice_d * d;
  t.Q = t.D + t.n * t.scale;
  t.Wx = slip.wx * t.scale;
  t.Wy = slip.wy * t.scale + slip.rate_dv * d;
  t.R = root(select(stick, trial2, t.Wx * t.Wx + t.Wy * t.Wy));
  const Pack with = ex * t.Wx + ey * t.Wy;
  t.across = t.Wy * ex - t.Wx * ey;
  const Pack ahead = larger(t.R - with, zero) * (t.Q * t.Q), behind = larger(t.R + with, zero) * (t.D * t.D);
  const Pack back = behind - ahead, aside = (t.across + t.across) * (t.Q * t.D);
  const Pack length = select(stick, t.R, (ahead + behind) * t.R);
  const Mask has_direction = length > 1e-280;  // not so where w vanishes: then the direction stays
  t.inverse = 1.0 / larger(length, 1e-280);
  const Pack x = select(stick, trial_x, aside * t.Wy + back * t.Wx) * t.inverse;
  const Pack y = select(stick, trial_y, back * t.Wy - aside * t.Wx) * t.inverse;
  // Unit length up to rounding, except where e is along W to the last digit; one step of Newton's method for
  // 1 / |e| keeps it from drifting, and never leaves it longer than one.
  const Pack unit = larger(1.5 - 0.5 * (x * x + y * y), zero);
  t.moves = has_direction;
  ex = select(has_direction, x * unit, ex);
  ey = select(has_direction, y * unit, ey);
  return t;
}

/// How the angle of e after a step of slip changes with what the step is given: with chi the angle of -W,
///     d angle' = d chi + 2 Q D R / T (d angle - d chi) - 4 across D d (d + n) / T dz,   T R the length.
struct TurnSlopes {
  Pack kept, by_z;                       ///< of the angle
  Pack chi_by_x, chi_by_y;               ///< of chi with W / scale
  Pack z_by_x, z_by_y, z_by_dv, z_by_d;  ///< of z with the slip at mid-step, dv and d
  Pack ahead, seen_by_dv, seen_by_z;     ///< W / scale is taken `ahead` of the cell
  Pack half_dv, half_rate;
};

inline TurnSlopes slopes(const Slip& slip, Pack rate, const Turn& t) {
  const Pack zero = 0.0, d = slip.d;
  TurnSlopes s;
  const Mask turns = (t.w_mid > 1e-150) & (d > zero);
  const Pack by_d = select(turns, 1.0 / select(turns, d, 1.0), zero);
  const Pack z_by_w = 2.0 * slip.dv * by_d / select(turns, t.w_mid, 1.0);
  s.z_by_x = z_by_w * slip.wx;
  s.z_by_y = z_by_w * t.wy_mid;
  s.z_by_dv = 2.0 * t.w_mid * by_d;
  s.z_by_d = -(t.n * by_d * by_d);
  const Pack d_by_scale = d / select(turns, t.scale, 1.0);
  s.ahead = slip.dv * d_by_scale;
  s.seen_by_dv = rate * d_by_scale;
  s.seen_by_z = -(rate * s.ahead * d_by_scale);
  const Pack per_T = t.R * t.inverse;
  s.kept = 2.0 * t.Q * t.D * t.R * per_T;
  s.by_z = 4.0 * t.across * t.D * d * (d + t.n) * per_T;
  const Pack square = t.R * t.R;
  const Pack to_chi = t.scale / select(square > 1e-280, square, 1.0);
  s.chi_by_x = -(to_chi * t.Wy);
  s.chi_by_y = to_chi * t.Wx;
  s.half_dv = 0.5 * slip.dv;
  s.half_rate = 0.5 * rate;
  return s;
}

/// Changes of what turns e.
struct SlipChange {
  Pack dv, wx, wy, rate, d;
};

/// d angle' from the changes of the angle and of the slip.
inline Pack turned(const TurnSlopes& s, Pack angle, const SlipChange& change) {
  const Pack wy_mid = change.wy + change.rate * s.half_dv + s.half_rate * change.dv;
  const Pack z = s.z_by_x * change.wx + s.z_by_y * wy_mid + s.z_by_dv * change.dv + s.z_by_d * change.d;
  const Pack wy = change.wy + change.rate * s.ahead + s.seen_by_dv * change.dv + s.seen_by_z * z;
  const Pack chi = s.chi_by_x * change.wx + s.chi_by_y * wy;
  return chi + s.kept * (angle - chi) - s.by_z * z;
}

}  // namespace
}  // namespace wrc::simd
