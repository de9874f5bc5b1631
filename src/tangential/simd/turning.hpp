/// One step of a march through the slip zone: the direction e of the traction turns against the slip w.
///
/// Over a step dv the angle from -w to e, delta, becomes 2 atan(tan(delta/2) / q) with q = 1 + z + z^2/2 and
/// z = 2 dv |w| / d (march.hpp). That needs no angle. With V = dv w, r = |V| and s = d + r, the vector
///     c = (d^2 + r s) e - s V
/// points half-way from e to its new direction, so that e reflected in c,
///     e' = 2 (e.c / c.c) c - e,
/// is the answer: q = (d^2 + 2 r s) / d^2 is the ratio of the two weights' sum and difference. A reflection
/// keeps the length of e to rounding, whatever c is.
///
/// w changes over the step, its y part by -rate per length. It is taken where a direction that decays like
/// 1 / q would see it, 1 / (2 + z) of the step ahead of the cell: mid-step for small z, the cell itself for
/// large z. z is that of the step before, so that a step takes one root; its change from step to step alters
/// the answer in third order. The divides for z and for e' wait for nothing of each other: one divide for
/// both takes more multiplications than it saves.
#pragma once

#include "base/pack.hpp"
#include "tangential/simd/tasks.hpp"

namespace wrc::simd {
namespace {

/// `ahead` where slip sets in: z is small there, or e is along the slip already.
constexpr double first_ahead = 0.5;

/// The packs of two groups of strips. The processor looks some hundred operations ahead, which is no more
/// than one group's step, each operation waiting for the one before: only where those of two groups alternate
/// does one group compute while the other waits for its root or divide.
struct TwoPacks {
  Pack first, second;

  TwoPacks() = default;
  TwoPacks(Pack a, Pack b) : first(a), second(b) {}
  TwoPacks(double everywhere) : first(everywhere), second(everywhere) {}  // NOLINT: as Pack

  friend TwoPacks operator+(TwoPacks x, TwoPacks y) { return {x.first + y.first, x.second + y.second}; }
  friend TwoPacks operator-(TwoPacks x, TwoPacks y) { return {x.first - y.first, x.second - y.second}; }
  friend TwoPacks operator*(TwoPacks x, TwoPacks y) { return {x.first * y.first, x.second * y.second}; }
  friend TwoPacks operator/(TwoPacks x, TwoPacks y) { return {x.first / y.first, x.second / y.second}; }
};
inline TwoPacks root(TwoPacks x) { return {root(x.first), root(x.second)}; }
inline TwoPacks larger(TwoPacks x, TwoPacks y) {
  return {larger(x.first, y.first), larger(x.second, y.second)};
}

/// A step, with the intermediate numbers that its derivatives need. P: packs of one group or of two.
template <class P>
struct TurnOf {
  P Vx, Vy;         ///< slip times dv, where it is seen
  P d;              ///< resists turning
  P ex, ey;         ///< direction before the turn, and after
  P r, s, cx, cy;   ///< r = |V|, s = d + r; c points half-way
  P ahead;          ///< 1 / (2 + z) = d / 2s, of the next step
  P per_rs, per_c;  ///< 1 / r s, 1 / c.c: for the derivatives only
};
using Turn = TurnOf<Pack>;

/// A step to be turned: slip times dv, resistance d, direction.
WRC_IN_LOOP Turn begin_turn(Pack Vx, Pack Vy, Pack d, Pack ex, Pack ey) {
  Turn t;
  t.Vx = Vx;
  t.Vy = Vy;
  t.d = d;
  t.ex = ex;
  t.ey = ey;
  return t;
}

/// Turns (ex, ey) against the slip V over a step.
template <class P>
WRC_IN_LOOP void turn(TurnOf<P>& t) {
  // r = |V|, s = d + r and the next step's `ahead` 1 / (2 + z) = d / 2s
  t.r = root(t.Vx * t.Vx + t.Vy * t.Vy);
  t.s = larger(t.d + t.r, 1e-150);
  t.ahead = (0.5 * t.d) / t.s;
  // c half-way between e and its new direction
  const P keep = t.d * t.d + t.r * t.s;
  t.cx = keep * t.ex - t.s * t.Vx;
  t.cy = keep * t.ey - t.s * t.Vy;
  // e' = 2 (e.c / c.c) c - e. c may vanish by rounding where e lies along a V far larger than d: then e is
  // turned round, as it should be.
  const P square = larger(t.cx * t.cx + t.cy * t.cy, 1e-280);
  const P along = t.ex * t.cx + t.ey * t.cy;
  const P twice = (along + along) / square;
  t.ex = twice * t.cx - t.ex;
  t.ey = twice * t.cy - t.ey;

  // for slopes(); where nobody asks for those the compiler leaves the divides out
  t.per_rs = 1.0 / larger(t.r * t.s, 1e-280);
  t.per_c = 1.0 / square;
}

/// The same for two groups at once.
WRC_IN_LOOP void turn(Turn& a, Turn& b) {
  // one text for both: operations of the two groups alternate
  TurnOf<TwoPacks> t;
  t.Vx = {a.Vx, b.Vx};
  t.Vy = {a.Vy, b.Vy};
  t.d = {a.d, b.d};
  t.ex = {a.ex, b.ex};
  t.ey = {a.ey, b.ey};
  turn(t);
  const auto part = [&](Pack TwoPacks::*of) -> Turn {
    return {t.Vx.*of, t.Vy.*of, t.d.*of,  t.ex.*of,    t.ey.*of,     t.r.*of,
            t.s.*of,  t.cx.*of, t.cy.*of, t.ahead.*of, t.per_rs.*of, t.per_c.*of};
  };
  a = part(&TwoPacks::first);
  b = part(&TwoPacks::second);
}

/// Derivatives of the angle of e after a step, and of `ahead`, by the angle before, by V and by d. From
/// angle' = angle + 2 atan2(e x c, e . c).
struct TurnSlopes {
  Pack kept, by_x, by_y, by_d;
  Pack ahead_by_x, ahead_by_y, ahead_by_d;
};

/// (ex, ey): the direction before the step.
WRC_IN_LOOP TurnSlopes slopes(const Turn& t, Pack ex, Pack ey) {
  // angle of e: kept = d^2 (d^2 + 2 r s) / c.c of it stays; by V: its turning, 2 s / c.c times c across V,
  // and its size r and d through the weights of c, times 2 (e x V) / c.c
  TurnSlopes s;
  const Pack twice = t.per_c + t.per_c, d2 = t.d * t.d, rs = t.r * t.s;
  const Pack across = twice * (ex * t.Vy - ey * t.Vx);
  s.kept = d2 * (d2 + (rs + rs)) * t.per_c;
  const Pack along = twice * t.s, by_r = across * (t.s + t.d);  // by_r: times r
  s.by_x = along * t.cy + by_r * t.Vx;
  s.by_y = by_r * t.Vy - along * t.cx;
  s.by_d = across * (t.d * (t.s + t.r));
  // ahead = d / 2s = d / (2 (d + r))
  const Pack ahead_by_r = t.ahead * t.per_rs;  // over r, less than zero
  s.ahead_by_x = -(ahead_by_r * t.Vx);
  s.ahead_by_y = -(ahead_by_r * t.Vy);
  s.ahead_by_d = (0.5 - t.ahead) * (t.r * t.per_rs);  // r / (2 s^2)
  return s;
}

}  // namespace
}  // namespace wrc::simd
