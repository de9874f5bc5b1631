/// Flash temperatures of the caller's power densities.
#include "abi/temperature.hpp"

#include "abi/fp_environment.hpp"

namespace wrc::abi {
namespace {

Fault find_flash_temperature(std::uint32_t count, double cell, const double* power_density, double speed,
                             const wrc_heat_properties* wheel, const wrc_heat_properties* rail,
                             double* rise) {
  constexpr double shortest_cell = 1e-7, longest_cell = 0.01, most_power = 1e18;
  constexpr double slowest = 1e-6, fastest = 200.0;
  RETURN_IF_FAILED(check(count, "count", "", 1.0, tangential::most_flash_cells));
  if (power_density == nullptr) return Fault::null("power_density");
  if (rise == nullptr) return Fault::null("rise");
  wrc_heat_properties of_wheel, of_rail;
  const Fault fault = first_of(
      {check(cell, "cell", "m", shortest_cell, longest_cell, nullptr, "did you pass mm?"),
       check(speed, "speed", "m/s", slowest, fastest, nullptr, "did you pass km/h?"),
       check_all(power_density, count, "power_density", "W/m^2", -most_power, most_power, nullptr, nullptr),
       read_or_defaults(wheel, "wheel", of_wheel), read_or_defaults(rail, "rail", of_rail)});
  if (fault.failed()) {
    for (std::uint32_t i = 0; i < count; ++i) rise[i] = 0.0;
    return fault;
  }
  // One strip, whose tractions of 1 Pa slide by -q / V.
  const auto cells = static_cast<std::int32_t>(count);
  double one[tangential::most_flash_cells], none[tangential::most_flash_cells] = {},
                                            slip[tangential::most_flash_cells],
                                            found[tangential::most_flash_cells];
  for (std::int32_t i = 0; i < cells; ++i) {
    one[i] = 1.0;
    slip[i] = -power_density[i] / speed;
  }
  double half_length = 0.5 * cell * count;
  patch::Strips strip{};
  strip.count = 1;
  strip.half_length = &half_length;
  tangential::flash_rise(strip, {one, none, slip, none}, cells, speed,
                         {effusivity_of(of_wheel), effusivity_of(of_rail)}, tangential::FlashWeights(cells),
                         found);
  for (std::int32_t i = 0; i < cells; ++i) rise[i] = found[i];
  return {};
}

}  // namespace
}  // namespace wrc::abi

extern "C" {

int32_t wrc_flash_temperature(uint32_t count, double cell, const double* power_density, double speed,
                              const wrc_heat_properties* wheel, const wrc_heat_properties* rail,
                              double* rise) {
  const wrc::abi::FloatingPointScope scope;
  return wrc::abi::find_flash_temperature(count, cell, power_density, speed, wheel, rail, rise).status;
}

}  // extern "C"
