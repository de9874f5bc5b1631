/// By how much the overlap of a strip grows along a rail that varies: a bound, for the margin of the search
/// below the axle (PlacedRail::gain).
#pragma once

#include "base/number.hpp"
#include "surface/geometry/varying_rail.hpp"

namespace wrc::surface {

/// Distance from the axle beyond which only the last place to either side lies [m].
inline constexpr double last_place = (places_to_a_side - 0.5) * place_apart;

/// Vertical part of normals [-]: steeper strips meet no wheel that far ahead, as the flange's tip has risen.
inline constexpr double steepest_far = 0.2;

/// A strip below the axle: its middle [m] and unit tangent.
template <class Number>
struct StripBelowAxle {
  Number y, z, ty, tz;
};

/// Growth of a strip's overlap [m] from below the axle to the place x [m], where its middle is at y, z [m],
/// of a wheel that may be nearest up to `askew` ahead or behind.
template <class Number>
WRC_IN_LOOP Number gain_at(const StripBelowAxle<Number>& strip, double x, const Number& there_y,
                           const Number& there_z, double wheel_radius) {
  constexpr double askew = 15e-3;  // [m]
  // far from the axle a gauge corner slides along the flange's hollow root, where overlaps grow
  constexpr double hollow = 13e-3, corner = 0.9,
                   most_hollow = 2e-3;  // radius [m]; vertical part of normals; [m]
  // a strip that moves along its tangent meets a wheel whose normal differs by up to this angle [rad] where a
  // contact ends
  constexpr double tilt = 0.15;
  // rise of the strip along its normal, less that of the wheel; its move along its tangent
  const double off = larger(magnitude(x) - askew, 0.0), raised = 0.5 * off * off / wheel_radius;
  const Number y = there_y - strip.y, z = there_z - strip.z;
  const Number &ty = strip.ty, &tz = strip.tz, none = Number(0.0);
  const Number along = ty * y + tz * (z + raised);
  Number deeper = none;
  if (magnitude(x) > last_place) {
    const Number root_deep = smaller(0.5 * along * along / hollow, Number(most_hollow));
    deeper = select(ty > Number(steepest_far), select(ty < Number(corner), root_deep, none), none);
  }
  return tz * y - ty * z - larger(ty, none) * raised + deeper + tilt * magnitude(along);
}

/// Some strips of a face, as many as the widest instruction set has lanes, and the most that their overlaps
/// grow at the places looked at first (PlacedRail).
struct StripGains {
  static constexpr std::int32_t most = 16;

  std::int32_t count;
  std::int32_t strip[most];
  double gain[most], at[most];  ///< the growth, and its place [m]
};

}  // namespace wrc::surface
