/// Wear by the laws: parameters checked and translated.
#include "abi/wear.hpp"

namespace wrc::abi {
namespace {

/// A limit of a regime may not lie below that of the one before it, nor a law turn negative.
Fault check_order(const wrc_wear_laws& laws) {
  const auto at_least = [](Member member, double value, double low) {
    member.low = low;
    return check(member, "laws", value);
  };
  Member offset = MEMBER(wrc_wear_laws, "t_gamma_severe_offset");
  offset.high = laws.t_gamma_severe_slope * laws.t_gamma_severe_start;
  return first_of({at_least(MEMBER(wrc_wear_laws, "t_gamma_severe_start"), laws.t_gamma_severe_start,
                            laws.t_gamma_mild_end),
                   check(offset, "laws", laws.t_gamma_severe_offset),
                   at_least(MEMBER(wrc_wear_laws, "sheffield_severe_end"), laws.sheffield_severe_end,
                            laws.sheffield_mild_end),
                   at_least(MEMBER(wrc_wear_laws, "archard_severe_end"), laws.archard_severe_end,
                            laws.archard_severe_start)});
}

damage::WearLaws laws_of(const wrc_wear_laws& checked) {
  damage::WearLaws laws;
  laws.t_gamma.t1 = checked.t_gamma_mild_end;
  laws.t_gamma.t2 = checked.t_gamma_severe_start;
  laws.t_gamma.slope_mild = checked.t_gamma_mild_slope;
  laws.t_gamma.plateau = checked.t_gamma_plateau;
  laws.t_gamma.slope_severe = checked.t_gamma_severe_slope;
  laws.t_gamma.offset_severe = checked.t_gamma_severe_offset;
  laws.sheffield.x1 = checked.sheffield_mild_end;
  laws.sheffield.x2 = checked.sheffield_severe_end;
  laws.sheffield.slope_mild = checked.sheffield_mild_slope;
  laws.sheffield.slope_catastrophic = checked.sheffield_catastrophic_slope;
  laws.sheffield.density = checked.density;
  laws.archard.hardness = checked.hardness;
  laws.archard.mild_low_speed = checked.archard_slow;
  laws.archard.severe = checked.archard_severe;
  laws.archard.mild_high_speed = checked.archard_fast;
  laws.archard.seizure = checked.archard_seizure;
  laws.archard.v1 = checked.archard_severe_start;
  laws.archard.v2 = checked.archard_severe_end;
  laws.archard.seizure_pressure = checked.seizure_pressure;
  laws.power.coefficient = checked.power_coefficient;
  laws.power.exponent = checked.power_exponent;
  laws.power.reference = checked.power_reference;
  laws.power.density = checked.density;
  return laws;
}

}  // namespace

Fault read_wear_laws(const wrc_wear_laws* theirs, const char* name, damage::WearLaws& laws) {
  wrc_wear_laws ours;
  RETURN_IF_FAILED(read_or_defaults(theirs, name, ours));
  RETURN_IF_FAILED(check_order(ours));
  laws = laws_of(ours);
  return {};
}

}  // namespace wrc::abi
