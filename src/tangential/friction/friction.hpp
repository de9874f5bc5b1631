/// The friction law: coefficient of friction over the profile, the sliding speed and the temperature.
///
/// One coefficient per strip,
///
///     mu_j = mu_0(y_j) f(w_j) g_j,
///
/// mu_0 a number, or the mean over the strip of a function of y given by breakpoints; f = 1, or falling with
/// the sliding speed w; g = 1, or falling with the temperature. mu_0 f is found before the tangential problem
/// is solved, g with it.
///
/// For w the strip's rigid slip stands, the root of its mean square along the strip, times the rolling speed:
///
///     w_j^2 = V^2 ( (nu_x - phi y_j)^2 + (nu_y + phi x_j)^2 + phi^2 l_j^2 / 3 ).
///
/// Particles of a strip that slips as a whole really slide by that, up to the elastic part, and in strips
/// that stick the bound is not felt. It takes no iteration, unlike the true slip, of which friction
/// would be a function at every point; falling friction there has several solutions. A strip's own value,
/// rather than one for the patch, because under spin the sliding speed differs between the middle and the
/// borders as much as it does between vehicles; the mean square rather than the middle's value, because that
/// would dip to zero at the spin pole. Modified FASTSIM has one sliding speed per patch,
/// V sqrt(nu_x^2 + nu_y^2), as published.
///
/// g is the mean over the strip's load of a function of the temperature T: 1 up to a temperature, a share
/// from another on, and linear between (the form of CONTACT's user guide, method L = 4). T is the temperature
/// that tractions with these coefficients make (heated_friction.hpp).
#pragma once

#include <cstdint>

#include "patch/strips.hpp"
#include "tangential/friction/strip_friction.hpp"
#include "tangential/problem.hpp"

namespace wrc::tangential {

/// Coefficient over y, linear between breakpoints and constant beyond them; two at the same y make a step.
/// Without padding, as the law: it is part of a contact's saved state.
struct FrictionZones {
  std::int64_t count = 0;               ///< 0: the same everywhere
  const double* y = nullptr;            ///< not decreasing [m]
  const double* coefficient = nullptr;  ///< >= 0 [-]
};

/// f over w.
enum class SpeedLaw : std::int32_t {
  none,         ///< 1
  exponential,  ///< (1 - A) exp(-B w) + A: Polach, Wear 258 (2005)
  hyperbolic,   ///< A + (1 - A) / (1 + w / w_half): from a static to a kinetic coefficient
};

/// The function of T whose mean is g.
enum class TemperatureLaw : std::int32_t {
  none,    ///< 1
  linear,  ///< between 1 of cold surfaces and `hot_ratio` of hot ones
};

struct FrictionLaw {
  double coefficient = 0.3;  ///< mu_0 where there are no zones [-]
  FrictionZones zones{};
  SpeedLaw speed_law = SpeedLaw::none;
  TemperatureLaw temperature_law = TemperatureLaw::none;
  double kinetic_ratio = 1.0;  ///< A: friction at high sliding speed over that at rest [-]
  double fall_rate = 0.0;      ///< B [s/m]
  double half_speed = 1.0;     ///< w_half [m/s]
  double hot_ratio = 1.0;      ///< friction of hot surfaces over that of cold ones [-]
  double cold_temperature = 0.0, hot_temperature = 1.0;    ///< where the fall begins, and ends [degC]
  double wheel_temperature = 0.0, rail_temperature = 0.0;  ///< bulk temperatures [degC]

  bool heated() const { return temperature_law != TemperatureLaw::none; }
  bool falls() const { return speed_law != SpeedLaw::none || heated(); }
  bool is_one_number() const { return zones.count == 0 && !falls(); }
};

/// f(w), 0 to 1; w >= 0 [m/s].
double speed_factor(const FrictionLaw& law, double sliding_speed);

/// f'(w) [s/m].
double speed_factor_slope(const FrictionLaw& law, double sliding_speed);

/// The function of a temperature [degC] whose mean is g; its slope at will [1/K].
double temperature_factor(const FrictionLaw& law, double temperature, double* slope = nullptr);

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
StripFriction shared_out(const patch::Strips& strips, double* coefficients);

/// Evaluates the law of cold surfaces, mu_0 f. creepage: at the origin of the contact frame; speed: V [m/s].
/// Fills `shares` (strips.count numbers, which must outlive the result); where friction is the same
/// everywhere with ones.
StripFriction evaluate(const FrictionLaw& law, const patch::Strips& strips, const FrictionFrame& frame,
                       const Creepage& creepage, double speed, SlidingSpeed sliding, double* shares);

}  // namespace wrc::tangential
