/// Wear by three laws: parameters checked and translated, results handed back.
#include "abi/call.hpp"

namespace wrc::abi {
namespace {

Fault read_laws(const wrc_wear_laws* theirs, WearLaws& laws) {
  if (theirs == nullptr) return {};  // the published ones
  wrc_wear_laws ours;
  const Fault fault = read(theirs, "laws", ours);
  if (fault.failed()) return fault;
  const Fault checks[] = {
      check(ours.t_gamma_mild_end, "laws.t_gamma_mild_end", "N", 0.001, 1000000000.0),
      check(ours.t_gamma_severe_start, "laws.t_gamma_severe_start", "N", ours.t_gamma_mild_end, 1000000000.0),
      check(ours.t_gamma_mild_slope, "laws.t_gamma_mild_slope", "mm^3/(km N)", 0.0, 1000000.0),
      check(ours.t_gamma_plateau, "laws.t_gamma_plateau", "mm^3/km", 0.0, 1000000000.0),
      check(ours.t_gamma_severe_slope, "laws.t_gamma_severe_slope", "mm^3/(km N)", 0.0, 1000000.0),
      check(ours.t_gamma_severe_offset, "laws.t_gamma_severe_offset", "mm^3/km", 0.0,
            ours.t_gamma_severe_slope * ours.t_gamma_severe_start),
      check(ours.sheffield_mild_end, "laws.sheffield_mild_end", "N/mm^2", 1e-06, 1000000000.0),
      check(ours.sheffield_severe_end, "laws.sheffield_severe_end", "N/mm^2", ours.sheffield_mild_end,
            1000000000.0),
      check(ours.sheffield_mild_slope, "laws.sheffield_mild_slope", "microgram/(m N)", 0.0, 1000000.0),
      check(ours.sheffield_catastrophic_slope, "laws.sheffield_catastrophic_slope", "microgram/(m N)", 0.0,
            1000000.0),
      check(ours.density, "laws.density", "kg/m^3", 100.0, 100000.0),
      check(ours.hardness, "laws.hardness", "Pa", 1000000.0, 1000000000000.0),
      check(ours.archard_slow, "laws.archard_slow", "", 0.0, 1.0),
      check(ours.archard_severe, "laws.archard_severe", "", 0.0, 1.0),
      check(ours.archard_fast, "laws.archard_fast", "", 0.0, 1.0),
      check(ours.archard_seizure, "laws.archard_seizure", "", 0.0, 1.0),
      check(ours.archard_severe_start, "laws.archard_severe_start", "m/s", 0.0, 1000.0),
      check(ours.archard_severe_end, "laws.archard_severe_end", "m/s", ours.archard_severe_start, 1000.0),
      check(ours.seizure_pressure, "laws.seizure_pressure", "", 0.0, 1000.0),
  };
  for (const Fault& each : checks) {
    if (each.failed()) return each;
  }
  laws.t_gamma.t1 = ours.t_gamma_mild_end;
  laws.t_gamma.t2 = ours.t_gamma_severe_start;
  laws.t_gamma.slope_mild = ours.t_gamma_mild_slope;
  laws.t_gamma.plateau = ours.t_gamma_plateau;
  laws.t_gamma.slope_severe = ours.t_gamma_severe_slope;
  laws.t_gamma.offset_severe = ours.t_gamma_severe_offset;
  laws.sheffield.x1 = ours.sheffield_mild_end;
  laws.sheffield.x2 = ours.sheffield_severe_end;
  laws.sheffield.slope_mild = ours.sheffield_mild_slope;
  laws.sheffield.slope_catastrophic = ours.sheffield_catastrophic_slope;
  laws.sheffield.density = ours.density;
  laws.archard.hardness = ours.hardness;
  laws.archard.mild_low_speed = ours.archard_slow;
  laws.archard.severe = ours.archard_severe;
  laws.archard.mild_high_speed = ours.archard_fast;
  laws.archard.seizure = ours.archard_seizure;
  laws.archard.v1 = ours.archard_severe_start;
  laws.archard.v2 = ours.archard_severe_end;
  laws.archard.seizure_pressure = ours.seizure_pressure;
  return {};
}

}  // namespace
}  // namespace wrc::abi

extern "C" int32_t wrc_wear_numbers(wrc_contact* handle, const wrc_wear_laws* laws, wrc_wear* wear) {
  namespace abi = wrc::abi;
  return abi::call(handle, abi::clear(wear), [&](wrc::Contact& contact) {
    wrc::WearLaws ours;
    wrc::WearNumbers numbers;
    wrc::Fault outcome = abi::read_laws(laws, ours);
    if (!outcome.failed()) outcome = wrc::assess_wear(contact, ours, numbers);
    if (outcome.failed()) return outcome;
    wrc_wear result = abi::defaults<wrc_wear>();
    result.worn_area_rate = numbers.worn_area_rate;
    result.largest_depth_rate = numbers.largest_depth_rate;
    result.largest_depth_velocity = numbers.largest_depth_velocity;
    abi::write(result, wear);
    return outcome;
  });
}
