/// The friction law: coefficient of friction over the profile and over the sliding speed.
///
/// One coefficient per strip, found before the tangential problem is solved:
///
///     mu_j = mu_0(y_j) f(w_j),
///
/// mu_0 a number, or the mean over the strip of a function of y given by breakpoints; f = 1, or falling with
/// the sliding speed w. For w the strip's rigid slip stands, the root of its mean square along the strip,
/// times the rolling speed:
///
///     w_j^2 = V^2 ( (nu_x - phi y_j)^2 + (nu_y + phi x_j)^2 + phi^2 l_j^2 / 3 ).
///
/// It is what particles of a strip that slips as a whole really slide by, up to the elastic part, and in
/// strips that stick the bound is not felt. It takes no iteration, unlike the true slip, of which friction
/// would be a function at every point; falling friction there has several solutions. A strip's own value,
/// rather than one for the patch, because under spin the sliding speed differs between the middle and the
/// borders as much as it does between vehicles; the mean square rather than the middle's value, because that
/// would dip to zero at the spin pole. Modified FASTSIM has one sliding speed per patch,
/// V sqrt(nu_x^2 + nu_y^2), as published.
///
/// Over temperature f is 1 up to a temperature, a share from another on, and linear between (the form of
/// CONTACT's user guide, method L = 4); of a strip the mean over its load, at the temperatures that tractions
/// with these coefficients make (damage/heated_friction.hpp). At rest, and so here, f is 1.
#pragma once

#include <cstdint>

#include "patch/strips.hpp"
#include "tangential/friction/strip_friction.hpp"
#include "tangential/problem.hpp"

namespace wrc {

/// Coefficient over y, linear between breakpoints and constant beyond them; two at the same y make a step.
/// Without padding, as the law: it is part of a contact's saved state.
struct FrictionZones {
  std::int64_t count = 0;               ///< 0: the same everywhere
  const double* y = nullptr;            ///< not decreasing [m]
  const double* coefficient = nullptr;  ///< >= 0 [-]
};

struct FrictionLaw {
  enum class Fall : std::int64_t {  // as wide as a double: see FrictionZones
    none,                           ///< f = 1
    exponential,                    ///< f = (1 - A) exp(-B w) + A: Polach, Wear 258 (2005)
    hyperbolic,  ///< f = A + (1 - A) / (1 + w / w_half): from a static to a kinetic coefficient
    heat,        ///< over temperature: friction_when_hot()
  };
  double coefficient = 0.3;  ///< mu_0 at rest, where there are no zones [-]
  FrictionZones zones{};
  Fall fall = Fall::none;
  double kinetic_ratio = 1.0;  ///< A: friction at high sliding speed over that at rest [-]
  double fall_rate = 0.0;      ///< B [s/m]
  double half_speed = 1.0;     ///< w_half [m/s]
  double hot_ratio = 1.0;      ///< f of hot surfaces
  double cold_temperature = 0.0, hot_temperature = 1.0;    ///< where f begins to fall, and ends to [degC]
  double wheel_temperature = 0.0, rail_temperature = 0.0;  ///< of the bodies [degC]
};

/// f(w), 0 to 1; w >= 0 [m/s].
double friction_fall(const FrictionLaw& law, double sliding_speed);

/// f of a temperature, its slope at will [1/K].
double friction_when_hot(const FrictionLaw& law, double temperature, double* slope = nullptr);

/// f'(w) [s/m].
double friction_fall_slope(const FrictionLaw& law, double sliding_speed);

/// Mean of the coefficient between `from` and `to` > from [m].
double mean_friction(const FrictionZones& zones, double from, double to);

/// The coefficient at y; at a step the one behind it.
double zone_friction(const FrictionZones& zones, double y);

/// Where the strips lie: their y is counted from `origin` in the contact frame, and the zones' from
/// y_zone = zone_origin + zone_slope y_contact.
struct FrictionFrame {
  double origin = 0.0;       ///< [m]
  double zone_origin = 0.0;  ///< [m]
  double zone_slope = 1.0;   ///< [-]
};

/// Whose rigid slip is the sliding speed.
enum class SlidingSpeed {
  of_strip,  ///< w_j above
  of_patch,  ///< V sqrt(nu_x^2 + nu_y^2) at `origin`, for all strips
};

/// Coefficients of strips as their mean over the load and each strip's share of it, which takes their place.
StripFriction shared_out(const Strips& strips, double* coefficients);

/// Evaluates the law. creepage: at the origin of the contact frame; speed: V [m/s]. Fills `shares`
/// (strips.count numbers, which must outlive the result); where friction is the same everywhere with ones.
StripFriction evaluate(const FrictionLaw& law, const Strips& strips, const FrictionFrame& frame,
                       const Creepage& creepage, double speed, SlidingSpeed sliding, double* shares);

}  // namespace wrc
