/// The contact condition at one point: elastic displacement under strips of semi-elliptic pressure.
#pragma once

#include "kernels/kernels.hpp"
#include "patch/material.hpp"
#include "patch/strips.hpp"

namespace wrc::normal {

/// Int sqrt(1 - (x/l)^2) / sqrt(x^2 + y^2) dx over |x| < l, y != 0: displacement at the distance y from a
/// line of semi-elliptic pressure, on its middle plane [-]. Closed: 2 l D / sqrt(l^2 + y^2), modulus
/// l / sqrt(l^2 + y^2). From a table, to a millionth; |y| < 1e-6 l counts as that.
double line_displacement(double half_length, double y) noexcept;

/// IInt sqrt(1 - (x/l)^2) / sqrt(x^2 + y^2) dx dy over |x| < l, y_from < y < y_to, seen from the origin [m].
///
/// The inner integral is closed, 2 l D / sqrt(l^2 + y^2) with the modulus l / sqrt(l^2 + y^2) (substitute
/// x = l sin t; it equals 2 sqrt(l^2 + y^2) (K - E) / l). Towards y = 0 it grows like 2 ln(4 l / |y|) - 2.
/// That logarithm is integrated over the width exactly, and only the smooth rest by the midpoint rule. So the
/// strip under the origin needs no cut-off length, and the result moves smoothly with the strip's borders.
double strip_displacement(double half_length, double y_from, double y_to) noexcept;

/// Gives every strip a pressure peak_j proportional to its half length, scaled so that the displacement at
/// the point (x, y) equals the approach: the one contact condition of the Kik-Piotrowski family. Returns the
/// load of the strips [N].
///
/// Strips whose middle is shifted in x by s count by the factor sqrt((l^2 + dy^2) / (l^2 + dy^2 + s^2)): the
/// leading effect of s both near the strip and far from it; right for the skew yaw gives a patch, s < l / 2.
double impose_approach(const Kernels& kernels, double approach, const patch::Material& material, double x,
                       double y, patch::Strips& strips) noexcept;

}  // namespace wrc::normal
