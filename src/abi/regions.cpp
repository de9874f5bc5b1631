/// Results by region of the contact's newest solution: the region itself, its fields, damage, wear,
/// temperatures and stresses.
#include <algorithm>

#include "abi/call.hpp"
#include "abi/results.hpp"
#include "abi/stresses.hpp"
#include "abi/structs.hpp"
#include "abi/temperature.hpp"
#include "abi/wear.hpp"
#include "contact/assessments.hpp"

namespace wrc::abi {
namespace {

static_assert(contact::all_regions == WRC_ALL_REGIONS);
static_assert(same<WRC_FIELD_SLIP_Y>(contact::FieldId::slip_y) &&
              same<WRC_FIELD_TEMPERATURE_RISE>(contact::FieldId::temperature_rise) &&
              same<WRC_FIELD_STRIP_WEAR>(contact::FieldId::strip_wear) &&
              same<WRC_FIELD_STRIP_ANGLE>(contact::FieldId::strip_angle) &&
              same<WRC_FIELD_GAP_CURVATURE>(contact::FieldId::gap_curvature) &&
              enumerations::wrc_field.count == static_cast<std::int32_t>(contact::FieldId::count_));

wrc_region region_of(const contact::RegionResult& found) {
  wrc_region ours = empty<wrc_region>();
  ours.available = (found.adhesion_known ? std::uint32_t{WRC_AVAILABLE_TRACTIONS} : 0U) |
                   (found.placed ? std::uint32_t{WRC_AVAILABLE_PLACE} : 0U);
  ours.strip_count = found.strips;
  ours.cell_count = found.cells;
  ours.surface = found.face;
  std::copy_n(found.point, 3, ours.point);
  std::copy_n(found.normal, 3, ours.normal);
  ours.y_wheel = found.place.y_wheel;
  ours.z_wheel = found.place.z_wheel;
  ours.y_rail = found.place.y_rail;
  ours.z_rail = found.place.z_rail;
  ours.angle = found.angle;
  ours.rolling_radius = found.rolling_radius;
  std::copy_n(found.force, 3, ours.force);
  std::copy_n(found.moment, 3, ours.moment);
  ours.normal_force = found.normal_force;
  ours.longitudinal_force = found.tangential.fx;
  ours.lateral_force = found.tangential.fy;
  ours.spin_moment = found.tangential.mz;
  ours.creepage.longitudinal = found.creepage.longitudinal;
  ours.creepage.lateral = found.creepage.lateral;
  ours.creepage.spin = found.creepage.spin;
  ours.creepage.speed = found.rolling_speed;
  ours.ellipse = ellipse_of(found.ellipse.sdec, found.ellipse.joint, found.ellipse.normal_force);
  ours.area = found.extent.area;
  ours.length = found.extent.length;
  ours.width = found.extent.y_max - found.extent.y_min;
  ours.y_min = found.extent.y_min;
  ours.y_max = found.extent.y_max;
  ours.peak_pressure = found.extent.peak_pressure;
  ours.power = found.power;
  ours.adhesion_fraction = found.tangential.adhesion_fraction;
  return ours;
}

/// A field into the caller's memory, or its counts alone.
Fault write_field(contact::Contact& contact, std::int32_t index, std::int32_t field, double* values,
                  std::uint64_t room, std::uint64_t* counts) {
  if (field < 0 || field >= static_cast<std::int32_t>(contact::FieldId::count_))
    return Fault::unsupported("field", {field, ""}, "see enum wrc_field");
  if (values == nullptr && counts == nullptr) return Fault::null("values");
  const auto which = static_cast<contact::FieldId>(field);
  contact::FieldSize size;
  const Fault fault = contact::region_field_size(contact, index, which, size);
  if (fault.failed()) return fault;
  const auto rows = static_cast<std::uint64_t>(size.rows), cells = static_cast<std::uint64_t>(size.cells);
  if (values != nullptr && room < rows * cells)
    return Fault::buffer("room", {room, "", rows * cells, 1e18}, "ask for counts first, with values NULL");
  if (counts != nullptr) {
    counts[0] = cells;
    counts[1] = rows;
  }
  if (values == nullptr) return fault;
  damage::WearLaws laws;
  RETURN_IF_FAILED(read_wear_laws(nullptr, "laws", laws));
  return contact::region_field(contact, index, which, laws.sheffield, values);
}

}  // namespace

wrc_damage damage_of(const contact::DamageNumbers& found, bool of_tractions) {
  wrc_damage ours{};
  ours.power = found.power;
  ours.t_gamma = found.t_gamma;
  ours.t_gamma_no_spin = found.t_gamma_no_spin;
  ours.utilisation = found.utilisation;
  ours.load_factor = found.load_factor;
  ours.shakedown_limit = found.shakedown_limit;
  ours.fatigue_index = found.fatigue_index;
  if (!of_tractions) return ours;
  ours.available = WRC_AVAILABLE_TRACTIONS;
  ours.peak_power_density = found.peak_power_density;
  ours.local_fatigue_index = found.local_fatigue_index;
  return ours;
}

}  // namespace wrc::abi

namespace abi = wrc::abi;
using wrc::Fault;
using wrc::contact::Contact;

extern "C" {

int32_t wrc_contact_region(wrc_contact* handle, int32_t index, wrc_region* region) {
  return abi::call(__func__, handle, abi::clear(region), [&](Contact& contact) {
    if (region == nullptr) return Fault::null("region");
    wrc::contact::RegionResult found;
    const Fault fault = wrc::contact::find_region(contact, index, found);
    if (!fault.failed()) abi::write(abi::region_of(found), region);
    return fault;
  });
}

int32_t wrc_contact_field(wrc_contact* handle, int32_t index, int32_t field, double* values, uint64_t room,
                          uint64_t* counts) {
  if (counts != nullptr) counts[0] = counts[1] = 0;
  return abi::call(__func__, handle, {}, [&](Contact& contact) {
    return abi::write_field(contact, index, field, values, room, counts);
  });
}

int32_t wrc_contact_damage(wrc_contact* handle, int32_t index, wrc_damage* damage) {
  return abi::call(__func__, handle, abi::clear(damage), [&](Contact& contact) {
    if (damage == nullptr) return Fault::null("damage");
    wrc::contact::DamageNumbers found;
    const Fault fault = wrc::contact::region_damage(contact, index, found);
    if (!fault.failed() && !fault.has(WRC_FLAG_NO_CONTACT))
      abi::write(abi::damage_of(found, wrc::contact::has_tractions(contact)), damage);
    return fault;
  });
}

int32_t wrc_contact_wear(wrc_contact* handle, int32_t index, const wrc_wear_laws* laws, wrc_wear* wear) {
  return abi::call(__func__, handle, abi::clear(wear), [&](Contact& contact) {
    if (wear == nullptr) return Fault::null("wear");
    wrc::damage::WearLaws ours;
    wrc::contact::WearNumbers numbers;
    RETURN_IF_FAILED(abi::read_wear_laws(laws, "laws", ours));
    const Fault outcome = wrc::contact::region_wear(contact, index, ours, numbers);
    if (outcome.failed()) return outcome;
    wrc_wear result = abi::defaults<wrc_wear>();
    result.worn_area_rate = numbers.worn_area_rate;
    result.largest_depth_rate = numbers.largest_depth_rate;
    result.largest_depth_velocity = numbers.largest_depth_velocity;
    result.largest_power_depth_velocity = numbers.largest_power_depth_velocity;
    abi::write(result, wear);
    return outcome;
  });
}

int32_t wrc_contact_temperature(wrc_contact* handle, int32_t index, const wrc_bulk_temperatures* bulk,
                                wrc_temperature* temperature) {
  return abi::call(__func__, handle, abi::clear(temperature), [&](Contact& contact) {
    if (temperature == nullptr) return Fault::null("temperature");
    wrc_bulk_temperatures ours;
    wrc::contact::TemperatureNumbers numbers;
    RETURN_IF_FAILED(abi::read_or_defaults(bulk, "bulk", ours));
    const Fault outcome = wrc::contact::region_temperature(contact, index, {ours.wheel, ours.rail}, numbers);
    if (!outcome.failed() && !outcome.has(WRC_FLAG_NO_CONTACT))
      abi::write(abi::temperature_of(numbers), temperature);
    return outcome;
  });
}

int32_t wrc_contact_stresses(wrc_contact* handle, int32_t index, int32_t body, const double* depths,
                             uint32_t count, wrc_stress_peaks* levels, wrc_stresses* stresses) {
  const Fault of_count = abi::check(count, "count", "", 1.0, abi::most_stress_depths);
  const std::uint32_t known = of_count.failed() ? 0 : count;
  for (std::uint32_t k = 0; levels != nullptr && k < known; ++k) levels[k] = {};
  return abi::call(__func__, handle, abi::clear(stresses), [&](Contact& contact) {
    RETURN_IF_FAILED(of_count);
    RETURN_IF_FAILED(abi::check_stress_depths(body, depths, count));
    wrc::damage::StressPeaks found[static_cast<std::size_t>(abi::most_stress_depths)];
    wrc::contact::BodyStresses of_body;
    const Fault outcome = wrc::contact::region_stresses(contact, index, body == WRC_BODY_RAIL, depths,
                                                        static_cast<std::int32_t>(count), found, of_body);
    if (outcome.failed()) return outcome;
    for (std::uint32_t k = 0; levels != nullptr && k < count; ++k) levels[k] = abi::peaks_of(found[k]);
    wrc_stresses result = abi::empty<wrc_stresses>();
    abi::fill(of_body.surface, of_body.below, body, result);
    abi::write(result, stresses);
    return outcome;
  });
}

}  // extern "C"
