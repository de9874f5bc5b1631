#include "abi/friction.hpp"

#include "abi/structs.hpp"

namespace wrc::abi {
namespace {

Fault read_zones(const wrc_friction& theirs, Friction& friction) {
  if (theirs.zones == 0) return {};
  for (std::uint32_t k = 1; k < theirs.zones; ++k) {
    if (theirs.zone_y[k] >= theirs.zone_y[k - 1]) continue;
    return {.status = WRC_ERROR_RANGE,
            .index = static_cast<std::int32_t>(k),
            .of = "friction",
            .field = "zone_y",
            .value = theirs.zone_y[k],
            .unit = "m",
            .cause = "breakpoints must be in order of increasing y"};
  }
  friction.law.zones = {theirs.zones, theirs.zone_y, theirs.zone_coefficient};
  static_assert(same<WRC_ZONES_CONTACT_FRAME>(ZoneFrame::contact) &&
                same<WRC_ZONES_RAIL_PROFILE>(ZoneFrame::rail));
  friction.zone_frame = static_cast<ZoneFrame>(theirs.zone_frame);
  return {};
}

static_assert(member<wrc_friction>("zones").high == zone_capacity);

/// A number that neither the law nor the method reads must be the default, or zero: what an initializer list
/// leaves in the members it does not name.
Fault check_unread(double value, double untouched, const char* field, const char* unit, const char* reader) {
  if (value == untouched || value == 0.0) return {};
  return {.status = WRC_ERROR_UNSUPPORTED, .field = field, .value = value, .unit = unit, .cause = reader};
}

Fault check_unread(const wrc_friction& ours, const TangentialMethod& method) {
  const wrc_friction untouched = defaults<wrc_friction>();
  const bool falls = ours.kind == WRC_FRICTION_FALLING, kinetic = ours.kind == WRC_FRICTION_STATIC_KINETIC;
  Fault fault;
  if (!falls && !kinetic)
    keep_worst(fault, check_unread(ours.kinetic_ratio, untouched.kinetic_ratio, "friction.kinetic_ratio", "",
                                   "constant friction does not read it: was friction.kind set?"));
  if (!falls)
    keep_worst(fault, check_unread(ours.fall_rate, untouched.fall_rate, "friction.fall_rate", "s/m",
                                   "only WRC_FRICTION_FALLING reads it: was friction.kind set?"));
  if (!kinetic)
    keep_worst(fault, check_unread(ours.half_speed, untouched.half_speed, "friction.half_speed", "m/s",
                                   "only WRC_FRICTION_STATIC_KINETIC reads it: was friction.kind set?"));
  if (!method.reads.has(Option::slope_fall)) {
    const char* const reader = readers_of(Option::slope_fall);
    keep_worst(fault,
               check_unread(ours.slope_limit, untouched.slope_limit, "friction.slope_limit", "", reader));
    keep_worst(fault, check_unread(ours.slope_fall, untouched.slope_fall, "friction.slope_fall", "", reader));
  }
  return fault;
}

}  // namespace

Fault read_friction(const wrc_friction* theirs, const TangentialMethod& method, Friction& friction) {
  wrc_friction ours;
  const Fault fault = read(theirs, "friction", ours);
  if (fault.failed()) return fault;
  static_assert(same<WRC_FRICTION_CONSTANT>(FrictionLaw::Fall::none) &&
                same<WRC_FRICTION_FALLING>(FrictionLaw::Fall::exponential) &&
                same<WRC_FRICTION_STATIC_KINETIC>(FrictionLaw::Fall::hyperbolic));
  friction.law.fall = static_cast<FrictionLaw::Fall>(ours.kind);
  // A struct filled by an initializer list of an older header has zeros in the fields it does not know.
  if (ours.slope_reduction == 0.0) ours.slope_reduction = 1.0;
  const Fault unread = check_unread(ours, method);
  if (unread.failed()) return unread;
  friction.law.coefficient = ours.coefficient;
  friction.law.kinetic_ratio = ours.kinetic_ratio;
  friction.law.fall_rate = ours.fall_rate;
  friction.law.half_speed = ours.half_speed;
  friction.slope_reduction = ours.slope_reduction;
  friction.slope = {ours.slope_limit, ours.slope_fall};
  return read_zones(ours, friction);
}

}  // namespace wrc::abi
