#include "abi/friction.hpp"

#include "abi/structs.hpp"

namespace wrc::abi {
namespace {

Fault read_zones(const wrc_friction& theirs, const char* of, Friction& friction) {
  if (theirs.zones == 0) return {};
  for (std::uint32_t k = 1; k < theirs.zones; ++k) {
    if (theirs.zone_y[k] >= theirs.zone_y[k - 1]) continue;
    return {.status = WRC_ERROR_RANGE,
            .index = static_cast<std::int32_t>(k),
            .of = of,
            .field = "zone_y",
            .value = theirs.zone_y[k],
            .unit = "m",
            .cause = "breakpoints must be in order of increasing y"};
  }
  friction.law.zones = {theirs.zones, theirs.zone_y, theirs.zone_coefficient};
  static_assert(same<WRC_ZONES_CONTACT_FRAME>(ZoneFrame::contact) &&
                same<WRC_ZONES_RAIL_PROFILE>(ZoneFrame::rail) &&
                same<WRC_ZONES_WHEEL_PROFILE>(ZoneFrame::wheel));
  friction.zone_frame = static_cast<ZoneFrame>(theirs.zone_frame);
  return {};
}

static_assert(member<wrc_friction>("zones").high == zone_capacity);

Fault check_unread(const wrc_friction& ours, const char* of, const TangentialMethod& method) {
  const wrc_friction untouched = defaults<wrc_friction>();
  const bool falls = ours.kind == WRC_FRICTION_FALLING, kinetic = ours.kind == WRC_FRICTION_STATIC_KINETIC;
  const bool heat = ours.kind == WRC_FRICTION_TEMPERATURE;
  constexpr const char* of_heat = "only WRC_FRICTION_TEMPERATURE reads it: was friction.kind set?";
  const bool slope = method.reads.has(Option::slope_fall);
  const struct {
    bool read;
    const char* field;
    double value, untouched;
    const char *unit, *reader;
  } each[] = {
      {falls || kinetic, "kinetic_ratio", ours.kinetic_ratio, untouched.kinetic_ratio, "",
       "constant friction does not read it: was friction.kind set?"},
      {falls, "fall_rate", ours.fall_rate, untouched.fall_rate, "s/m",
       "only WRC_FRICTION_FALLING reads it: was friction.kind set?"},
      {kinetic, "half_speed", ours.half_speed, untouched.half_speed, "m/s",
       "only WRC_FRICTION_STATIC_KINETIC reads it: was friction.kind set?"},
      {heat, "hot_ratio", ours.hot_ratio, untouched.hot_ratio, "", of_heat},
      {heat, "cold_temperature", ours.cold_temperature, untouched.cold_temperature, "degC", of_heat},
      {heat, "hot_temperature", ours.hot_temperature, untouched.hot_temperature, "degC", of_heat},
      {heat, "bulk.wheel", ours.bulk.wheel, untouched.bulk.wheel, "degC", of_heat},
      {heat, "bulk.rail", ours.bulk.rail, untouched.bulk.rail, "degC", of_heat},
      {slope, "slope_limit", ours.slope_limit, untouched.slope_limit, "", readers_of(Option::slope_fall)},
      {slope, "slope_fall", ours.slope_fall, untouched.slope_fall, "", readers_of(Option::slope_fall)},
  };
  for (const auto& [read, field, value, default_value, unit, reader] : each)
    if (!read && value != default_value)
      return {.status = WRC_ERROR_UNSUPPORTED,
              .of = of,
              .field = field,
              .value = value,
              .unit = unit,
              .cause = reader};
  return {};
}

/// Friction over temperature needs tractions to heat with, and room to fall in.
Fault check_heat(const wrc_friction& ours, const char* of, const TangentialMethod& method) {
  if (ours.kind != WRC_FRICTION_TEMPERATURE) return {};
  if (!method.gives_tractions) {
    return {.status = WRC_ERROR_UNSUPPORTED,
            .of = of,
            .field = "kind",
            .value = static_cast<double>(ours.kind),
            .unit = "",
            .cause = "this tangential method has no tractions that heat: choose another, or another law"};
  }
  constexpr double least_range = 1.0;
  Member above = member<wrc_friction>("hot_temperature");
  above.low = ours.cold_temperature + least_range;
  above.too_small = "it must be at least 1 degC above cold_temperature";
  return check(above, of, ours.hot_temperature);
}

/// The planar problem has no use for bodies without friction: its creepages, adhesion and damage would mean
/// nothing.
Fault check_some(const wrc_friction& ours, const char* of) {
  if (ours.coefficient > 0.0 || ours.zones > 0) return {};
  Member positive = member<wrc_friction>("coefficient");
  positive.or_zero = false;
  return check(positive, of, ours.coefficient);
}

}  // namespace

Fault read_friction(const wrc_friction& checked, const char* of, const TangentialMethod& method,
                    Friction& friction) {
  static_assert(same<WRC_FRICTION_CONSTANT>(FrictionLaw::Fall::none) &&
                same<WRC_FRICTION_FALLING>(FrictionLaw::Fall::exponential) &&
                same<WRC_FRICTION_STATIC_KINETIC>(FrictionLaw::Fall::hyperbolic) &&
                same<WRC_FRICTION_TEMPERATURE>(FrictionLaw::Fall::heat));
  const Fault fault =
      first_of({check_some(checked, of), check_unread(checked, of, method), check_heat(checked, of, method)});
  if (fault.failed()) return fault;
  friction.law.fall = static_cast<FrictionLaw::Fall>(checked.kind);
  friction.law.coefficient = checked.coefficient;
  friction.law.kinetic_ratio = checked.kinetic_ratio;
  friction.law.fall_rate = checked.fall_rate;
  friction.law.half_speed = checked.half_speed;
  friction.law.hot_ratio = checked.hot_ratio;
  friction.law.cold_temperature = checked.cold_temperature;
  friction.law.hot_temperature = checked.hot_temperature;
  friction.law.wheel_temperature = checked.bulk.wheel;
  friction.law.rail_temperature = checked.bulk.rail;
  friction.slope_reduction = checked.slope_reduction;
  friction.slope = {checked.slope_limit, checked.slope_fall};
  return read_zones(checked, of, friction);
}

}  // namespace wrc::abi
