/// Spread of slip over the strips of a patch: a factor on the slip of strip FASTSIM.
///
/// In strip theory the slip of a strip that mostly sticks depends on the strip's own traction alone. In a
/// patch, strips beside it that stick hold the surfaces back, most of all towards the sides. The singular
/// traction at the end of the stick zone is smaller there than that of a strip on its own. Its square is the
/// strip's power. Along a strip the slip keeps Carter's form. So the slip of a strip is multiplied by
///
///     1 + m (1/4 - t^2) + n t,   t = distance from the patch's middle over half its width.
///
/// 1/4 is the mean of t^2 over the power of an ellipse that sticks. m and n vanish in full slip. m
/// grows with the slenderness, as the strips of a long patch lie closer to each other. n changes its sign in
/// a mirror: it needs longitudinal slip together with lateral slip or spin. The power of the whole patch is
/// that of forces and creepages.
///
/// Spin asks strips for lateral slip in proportion to x. The traction of a strip on its own then ends without
/// a singularity, so strips near the middle stick as a whole. In a patch, strips beside them carry less where
/// they slip, at the trailing end, and the middle makes up for that. So a share b of spin's lateral growth
/// acts along the whole strip, as lateral creepage does; the rest acts in proportion to x. The force of a
/// strip that sticks stays. Only the slip follows this growth: where it begins, and how large it is.
#pragma once

#include "base/elementary.hpp"
#include "base/number.hpp"

namespace wrc::tangential {

/// The factor at t.
template <class Number>
Number slip_factor(const Number& even, const Number& odd, const Number& t) {
  const Number held = smaller(larger(t, Number(-1.0)), Number(1.0));
  return larger(1.0 + even * (0.25 - held * held) + odd * held, Number(0.05));
}

template <class Number>
struct SlipAcross {
  Number even, odd;  ///< m, n [-]
  Number beside;     ///< b [-]

  /// u: slenderness; x, e, s: forces of linear theory over the root of the sum of their squares and of the
  /// friction limit's (saturation_terms.hpp).
  SlipAcross(const Number& u, const Number& x, const Number& e, const Number& s) {
    // Fitted to the power of the strips of ellipses in exact rolling (tools/calibration/slip_across.py), a/b
    // 0.35 to 2.8; c[6] to c[8], c[11] and c[12] are those of spin.
    constexpr double c[] = {0.421, -2.375, 0.461, 0.990, 0.849, 1.334, 0.525,
                            0.738, -1.658, 0.497, 0.329, 0.016, 0.373};
    const Number held = smaller(larger(u, Number(-0.5)), Number(0.5));
    const Number xx = x * x, ee = e * e, ss = s * s, S = xx + ee + ss, S2 = S * S;
    // m and n by the shares of creepages and spin in S; 0 where nothing slips
    const Number sticks = (1.0 - S) / larger(S, Number(1e-30));
    const Number creepages = xx * (c[2] + c[3] * held) + ee * (c[4] + c[5] * held);
    even = sticks * ((1.0 + c[0] * S2 + c[1] * (S2 * S2)) * creepages + ss * (c[6] + c[7] * held + c[8] * S));
    odd = sticks * (x * (e * (c[9] + c[10] * S) + s * (c[11] + c[12] * held)));
    beside = beside_at(S);
  }

  /// b: as saturation grows, strips slip as a whole and need nothing from those beside.
  static Number beside_at(const Number& S) { return 0.338 * (1.0 - S); }

  Number at(const Number& t) const { return slip_factor(even, odd, t); }
};

}  // namespace wrc::tangential
