/// Terms of the fitted constants of strip FASTSIM, on a patch (strip_calibration.hpp) and on the rail's
/// surface (surface/rolling/surface_calibration.hpp): each fitted quantity is a sum of constants times terms.
///
/// x, e, s are the longitudinal force, the lateral force of lateral slip and that of spin in linear theory,
/// over the friction limit; with Q = 1 + x^2 + e^2 + s^2 every term lies between -1 and 1, vanishes with the
/// slips (but for the first two) and tends to a constant for large ones. u = (a - b) / (a + b) is the
/// slenderness. All terms stay the same when the bodies are mirrored and when all slips change sign.
///
/// tools/calibration makes the constants; its README has the commands. Zeros are terms a fit did not need.
#pragma once

#include "base/elementary.hpp"
#include "base/number.hpp"

namespace wrc::tangential {

/// Linear force of the tractions sqrt(v/u) / 2 over that of v, integrated over a double ellipse: FASTSIM's
/// flexibilities of creepages times this keep the forces of linear theory.
inline constexpr double creepage_area = 9.0 * pi * pi / 128.0;

/// exp(asinh q): 1 + q for small q, positive for any, 1 / itself for -q.
template <class Number>
Number factor(const Number& q) {
  return q + root(1.0 + q * q);
}

struct SaturationTerms {
  enum Term {
    constant,
    slender,         ///< u
    longitudinal,    ///< x^2 / Q
    lateral,         ///< e^2 / Q
    spin,            ///< s^2 / Q
    pull,            ///< e s / Q: lateral slip pulls with spin (> 0) or against it
    pull_squared,    ///< its square
    longitudinal_u,  ///< u x^2 / Q
    lateral_u,       ///< u e^2 / Q
    spin_u,          ///< u s^2 / Q
    pull_u,          ///< u e s / Q
    pull_squared_u,  ///< u times the square
    unison,  ///< 1 where s^2 = 1, where strip theory lets all strips slip at once; falls off to both sides
    saturation_terms
  };
};

}  // namespace wrc::tangential
