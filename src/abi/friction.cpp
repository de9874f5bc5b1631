#include "abi/friction.hpp"

#include "abi/structs.hpp"

namespace wrc::abi {
namespace {

Fault read_zones(const wrc_friction& theirs, Friction& friction) {
  if (theirs.zone_frame != WRC_ZONES_CONTACT_FRAME && theirs.zone_frame != WRC_ZONES_RAIL_PROFILE) {
    return {.status = WRC_ERROR_UNSUPPORTED,
            .field = "friction.zone_frame",
            .value = static_cast<double>(theirs.zone_frame),
            .unit = "",
            .cause = "see enum wrc_zone_frame"};
  }
  Fault fault = check(static_cast<double>(theirs.zones), "friction.zones", "breakpoints", 0.0, zone_capacity);
  if (fault.failed() || theirs.zones == 0) return fault;
  if (theirs.zone_y == nullptr) return {.status = WRC_ERROR_NULL, .field = "friction.zone_y"};
  if (theirs.zone_coefficient == nullptr)
    return {.status = WRC_ERROR_NULL, .field = "friction.zone_coefficient"};
  for (std::uint32_t k = 0; k < theirs.zones; ++k) {
    fault =
        check(theirs.zone_y[k], "friction.zone_y", "m", -1.0, 1.0, "did you pass mm?", "did you pass mm?");
    if (!fault.failed()) {
      fault = check(theirs.zone_coefficient[k], "friction.zone_coefficient", "", 0.0, 2.0,
                    "friction is not negative", "did you pass per cent?");
    }
    if (!fault.failed() && k > 0 && theirs.zone_y[k] < theirs.zone_y[k - 1]) {
      fault = {.status = WRC_ERROR_RANGE,
               .field = "friction.zone_y",
               .value = theirs.zone_y[k],
               .unit = "m",
               .cause = "breakpoints must be in order of increasing y"};
    }
    fault.index = static_cast<std::int32_t>(k);
    if (fault.failed()) return fault;
  }
  friction.law.zones = {theirs.zones, theirs.zone_y, theirs.zone_coefficient};
  friction.zone_frame = theirs.zone_frame == WRC_ZONES_RAIL_PROFILE ? ZoneFrame::rail : ZoneFrame::contact;
  return {};
}

/// A number that neither the law nor the method reads must be the default, or zero: what an initializer list
/// leaves in the members it does not name.
Fault check_unread(double value, double untouched, const char* field, const char* unit, const char* reader) {
  if (value == untouched || value == 0.0) return {};
  return {.status = WRC_ERROR_UNSUPPORTED, .field = field, .value = value, .unit = unit, .cause = reader};
}

Fault check_unread(const wrc_friction& ours, TangentialMethod method) {
  const wrc_friction untouched = defaults<wrc_friction>();
  const bool falls = ours.kind == WRC_FRICTION_FALLING, kinetic = ours.kind == WRC_FRICTION_STATIC_KINETIC;
  Fault fault;
  if (!falls && !kinetic)
    worsen(fault, check_unread(ours.kinetic_ratio, untouched.kinetic_ratio, "friction.kinetic_ratio", "",
                               "constant friction does not read it: was friction.kind set?"));
  if (!falls)
    worsen(fault, check_unread(ours.fall_rate, untouched.fall_rate, "friction.fall_rate", "s/m",
                               "only WRC_FRICTION_FALLING reads it: was friction.kind set?"));
  if (!kinetic)
    worsen(fault, check_unread(ours.half_speed, untouched.half_speed, "friction.half_speed", "m/s",
                               "only WRC_FRICTION_STATIC_KINETIC reads it: was friction.kind set?"));
  if (method != TangentialMethod::modified_fastsim) {
    constexpr const char* reader =
        "only WRC_TANGENTIAL_MODIFIED_FASTSIM reads it; every method reads slope_reduction";
    worsen(fault, check_unread(ours.slope_limit, untouched.slope_limit, "friction.slope_limit", "", reader));
    worsen(fault, check_unread(ours.slope_fall, untouched.slope_fall, "friction.slope_fall", "", reader));
  }
  return fault;
}

}  // namespace

Fault read_friction(const wrc_friction* theirs, TangentialMethod method, Friction& friction) {
  wrc_friction ours;
  const Fault fault = read(theirs, "friction", ours);
  if (fault.failed()) return fault;
  switch (ours.kind) {
    case WRC_FRICTION_CONSTANT:
      friction.law.fall = FrictionLaw::Fall::none;
      break;
    case WRC_FRICTION_FALLING:
      friction.law.fall = FrictionLaw::Fall::exponential;
      break;
    case WRC_FRICTION_STATIC_KINETIC:
      friction.law.fall = FrictionLaw::Fall::hyperbolic;
      break;
    default:
      return {.status = WRC_ERROR_UNSUPPORTED,
              .field = "friction.kind",
              .value = static_cast<double>(ours.kind),
              .unit = "",
              .cause = "see enum wrc_friction_kind"};
  }
  // A struct filled by an initializer list of an older header has zeros in the fields it does not know.
  if (ours.slope_reduction == 0.0) ours.slope_reduction = 1.0;
  const Fault checks[] = {
      check(ours.coefficient, "friction.coefficient", "", 1e-4, 2.0, "friction must be positive",
            "did you pass per cent?"),
      check(ours.kinetic_ratio, "friction.kinetic_ratio", "", 0.0, 1.0, nullptr,
            "it is a share of the coefficient at rest"),
      check(ours.fall_rate, "friction.fall_rate", "s/m", 0.0, 1e3, "friction falls with positive rates"),
      check(ours.half_speed, "friction.half_speed", "m/s",
            ours.kind == WRC_FRICTION_STATIC_KINETIC ? 1e-6 : 0.0, 1e2),
      check(ours.slope_reduction, "friction.slope_reduction", "", 1e-2, 1.0, "clean bodies have 1",
            "clean bodies have 1; did you pass per cent?"),
      check(ours.slope_limit, "friction.slope_limit", "", 0.0, 1.0),
      check(ours.slope_fall, "friction.slope_fall", "", 0.0, 1e3),
  };
  for (const Fault& each : checks) {
    if (each.failed()) return each;
  }
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
