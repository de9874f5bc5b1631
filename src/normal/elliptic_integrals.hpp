/// Complete elliptic integrals by the arithmetic-geometric mean.
///
/// Hertz's ellipse and the closed inner integral of the Kik-Piotrowski condition need K and E thousands of
/// times per second. std::comp_ellint_1 may throw, is absent from some standard libraries and is several
/// times slower; the mean needs a handful of square roots, gives the same bits on every instruction set, and
/// yields K - E without the cancellation of computing it as a difference.
#pragma once

namespace wrc {

/// K, E and D of one modulus k:
///   K = Int_0^{pi/2} (1 - k^2 sin^2 t)^{-1/2} dt,  E = Int (1 - k^2 sin^2 t)^{1/2} dt,  D = (K - E) / k^2 .
struct CompleteElliptic {
  double k = 0.0;
  double e = 0.0;
  double d = 0.0;
};

/// All three from the complementary modulus k' = sqrt(1 - k^2), 0 < k' <= 1. The complement is the argument
/// because slender ellipses and points close to a strip have k -> 1, where k itself has lost its digits;
/// there K ~ ln(4 / k'). k' below the smallest normal number counts as that number. Abramowitz and Stegun,
/// Handbook of Mathematical Functions, 17.6.
CompleteElliptic complete_elliptic(double complementary_modulus) noexcept;

}  // namespace wrc
