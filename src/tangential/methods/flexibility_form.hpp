/// One flexibility for all creepages, or one for each: the forms in which FASTSIM takes the flexibilities of
/// linear theory.
///
/// Separate flexibilities give the forces of linear theory, but turn the slip of a patch that slides as a
/// whole away from the rigid slip, since each creepage is divided by its own. One flexibility does the
/// opposite. The blended form goes from the first to the second as the creepages grow.
#pragma once

#include "tangential/rolling_contact.hpp"

namespace wrc::tangential {

/// Kalker's single flexibility (1982) [m/Pa],
///     L = (|nu_x| L11 + |nu_y| L22 + c |phi| L3) / sqrt(nu_x^2 + nu_y^2 + c^2 phi^2),   c = sqrt(a b),
/// right for any one of the creepages alone. It is no mean: for mixed creepages L is up to sqrt(3) times
/// larger than each of them. For a double ellipse L3 is the mean of L23 and L13 weighted as spin makes forces
/// through them, F_y : F_x = 3 pi a / 32 : 3 b |psi| / 4 in full adhesion (own definition); psi = 0 or
/// L13 = L23 leave Kalker's.
double single_flexibility(const theory::Flexibility& separate, double a, double b, double shape_number,
                          const Creepage& creepage);

/// The common flexibility at large creepages [m/Pa] (Vollebregt and Voltr, VSD 61 (2023) 309-317; the
/// formulas are those of the reference program's public source),
///     L_c = sum of n_k^2 / sum of n_k^2 / L_k over n = nu_x, nu_y, (3 pi a / 32) phi,
/// a mean of them. For a double ellipse n has a fourth member, (3 b psi / 4) phi with L13: the creepage whose
/// longitudinal force equals that of spin in full adhesion (own definition).
double common_flexibility(const theory::Flexibility& separate, double a, double b, double shape_number,
                          const Creepage& creepage);

/// Flexibilities between separate and common (same source):
///     L_i <- (1 - w) L_i + w L_c,   w = min(1, f / 3),
///     f^2 = (nu_x^2 + nu_y^2) / (nu_x*^2 + nu_y*^2),   nu_i* = 3 mu N L_ii / (8 a^2 b).
/// limit: mu N, times the slope reduction k where `separate` is that of bodies softened by it (L_i / k): the
/// weight is that of clean bodies, as in the reference program [N].
theory::Flexibility blended_flexibility(const theory::Flexibility& separate, double a, double b,
                                        double shape_number, const Creepage& creepage, double limit);

/// The flexibilities of linear theory, separate, of the shape the contact's patch model has.
theory::Flexibility linear_flexibility(const RollingContact& contact, Fault& fault);

/// `separate`, those of linear_flexibility(), in the form the contact asks for.
theory::Flexibility in_form(const theory::Flexibility& separate, const RollingContact& contact);

}  // namespace wrc::tangential
