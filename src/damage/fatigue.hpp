/// Surface-initiated rolling-contact fatigue: fatigue indices and the shakedown map.
///
/// A point of the map is the utilised friction mu_a = sqrt(Fx^2 + Fy^2) / N against the load factor p0 / k, k
/// the yield stress in shear of the (work-hardened) material. Above the curve plastic strain accumulates with
/// every load cycle.
#pragma once

#include "tangential/problem.hpp"

namespace wrc::damage {

/// Index where next to nothing presses, or where there are no tractions: finite, and below any
/// index of a contact.
inline constexpr double no_fatigue_index = -1e30;

struct ShakedownPoint {
  double utilised_friction = 0.0;  ///< mu_a = sqrt(Fx^2 + Fy^2) / N [-]
  double load_factor = 0.0;        ///< p0 / k [-]
};

/// Both zero without load.
ShakedownPoint shakedown_point(const tangential::TangentialForces& forces, double normal_force,
                               double peak_pressure, double shear_yield);

/// FI = mu_a - k / p0 (Ekberg, Kabo, Andersson 2002; Liu, Bruni 2024, eq. 11); positive: fatigue is
/// predicted. no_fatigue_index for an unloaded contact.
double fatigue_index(const ShakedownPoint& point);

/// The shakedown limit p0 / k of a Hertzian line contact in full slip with friction coefficient mu >= 0, for
/// an elastic, perfectly plastic half-space in plane strain.
///
/// By Melan's theorem only tau_xz cannot be cancelled by residual stresses, so p0 / k = p0 / max |tau_xz|,
/// with tau_xz from the closed-form stresses under a sliding line contact. For mu >= 0.367 its maximum is the
/// traction at the surface, p0 / k = 1 / mu, the curve FI = 0; below, it lies in the depth and is fitted by
/// 1 / (0.25 + 0.3025 mu + 0.045 mu^2) within 0.1 %.
double shakedown_limit(double friction);

/// The same of a circular contact, for material that hardens kinematically. Below the surface k / p0 is the
/// radius of the smallest ball about the path of the deviatoric stress as the load rolls by, at the place
/// where that is largest. It was found numerically for nu = 0.3 (tools/calibration/shakedown_point.py: p0 / k
/// = 4.68 for mu = 0, 4.52 for mu = 0.25), and is fitted by 0.2139 + 0.1 mu^2 + 0.25 mu^4 within 0.1 %. From
/// mu = 0.22 on the surface comes first, p0 / k = 1 / mu, as for the line.
double shakedown_limit_of_point(double friction);

/// Damage of one passage by T-gamma, the Whole Life Rail Model (Burstow, RSSB T115, 2004; values from memory,
/// unconfirmed): zero up to `start`, rising to `peak` at `peak_at`, falling through zero at `end` and on.
struct WholeLifeLaw {
  double start = 0.0, peak_at = 1.0, end = 2.0;  ///< T-gamma [N]
  double peak = 0.0;                             ///< [-]; 1 is a crack
};

/// t_gamma [N], finite.
double whole_life_damage(const WholeLifeLaw& law, double t_gamma);

}  // namespace wrc::damage
