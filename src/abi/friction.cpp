#include "abi/friction.hpp"

#include <cmath>
#include <cstring>

#include "abi/structs.hpp"

namespace wrc::abi {
namespace {

Fault read_zones(const wrc_friction& theirs, const char* of, contact::Friction& friction) {
  if (theirs.zone_count == 0) return {};
  for (std::uint32_t k = 1; k < theirs.zone_count; ++k) {
    if (theirs.zone_y[k] >= theirs.zone_y[k - 1]) continue;
    return Fault::range({of, "zone_y", k}, {theirs.zone_y[k], "m"},
                        "breakpoints must be in order of increasing y");
  }
  friction.law.zones = {theirs.zone_count, theirs.zone_y, theirs.zone_coefficients};
  static_assert(same<WRC_ZONES_CONTACT_FRAME>(contact::ZoneFrame::contact) &&
                same<WRC_ZONES_RAIL_PROFILE>(contact::ZoneFrame::rail) &&
                same<WRC_ZONES_WHEEL_PROFILE>(contact::ZoneFrame::wheel));
  friction.zone_frame = static_cast<contact::ZoneFrame>(theirs.zone_frame);
  return {};
}

static_assert(MEMBER(wrc_friction, "zone_count").high == contact::zone_capacity);

/// Friction over temperature needs tractions to heat with, and room to fall in.
Fault check_temperature_law(const wrc_friction& ours, const char* of,
                            const contact::TangentialMethod& method) {
  if (ours.temperature_law != WRC_TEMPERATURE_LAW_LINEAR) return {};
  if (!method.gives_tractions) {
    return Fault::unsupported(
        {of, "temperature_law"}, {ours.temperature_law, ""},
        "this tangential method has no tractions that heat: choose another, or WRC_TEMPERATURE_LAW_NONE");
  }
  constexpr double least_range = 1.0;
  Member above = MEMBER(wrc_friction, "hot_temperature");
  above.low = ours.cold_temperature + least_range;
  above.too_small = "it must be at least 1 degC above cold_temperature";
  return check(above, of, ours.hot_temperature);
}

/// Refuses a layer with a method that rolls none, or beside another layer. `where`: members for the message.
Fault check_layer_of(const wrc_friction& ours, const char* of, const char* where,
                     const contact::TangentialMethod& method) {
  if (!method.takes_layer) {
    return Fault::unsupported(
        {of, where},
        "this tangential method has no march along the strips that could carry a layer: "
        "choose WRC_TANGENTIAL_STRIP_FASTSIM or WRC_TANGENTIAL_FASTSIM");
  }
  if (ours.slope_reduction < 1.0 ||
      (method.reads.has(contact::Option::slope_fall) && ours.slope_fall > 0.0)) {
    return Fault::unsupported(
        {of, "slope_reduction, slope_fall"},
        "these are layers, too: with another layer let slope_reduction be 1 and slope_fall 0");
  }
  return {};
}

/// Polach's law wants both of its factors, that of slip not above that of adhesion.
Fault check_reduction(const wrc_friction& ours, const char* of, const contact::TangentialMethod& method) {
  if (!method.reads.has(contact::Option::reduction_factors)) return {};
  Member adhesion = MEMBER(wrc_friction, "adhesion_reduction");
  Member slip = MEMBER(wrc_friction, "slip_reduction");
  adhesion.or_zero = slip.or_zero = false;
  slip.high = ours.adhesion_reduction;
  slip.too_large = "Polach's k_S is at most his k_A, friction.adhesion_reduction";
  return first_of({check(adhesion, of, ours.adhesion_reduction), check(slip, of, ours.slip_reduction)});
}

/// Films in rows need both profiles, which planar and exact problems lack.
Fault check_films(const wrc_friction& ours, const char* of, Films films) {
  if (films == Films::apart || ours.film_numbers == 0) return {};
  return Fault::unsupported({of, "film_numbers"}, {ours.film_numbers, ""},
                            "films in rows are those of wrc_contact_wrench(): set it to 0");
}

/// The planar problem has no use for bodies without friction: its creepages, adhesion and damage would mean
/// nothing.
Fault check_some(const wrc_friction& ours, const char* of) {
  if (ours.coefficient > 0.0 || ours.zone_count > 0 || ours.film_numbers > 0) return {};
  Member positive = MEMBER(wrc_friction, "coefficient");
  positive.or_zero = false;
  return check(positive, of, ours.coefficient);
}

}  // namespace

Fault read_friction(const wrc_friction& checked, const char* of, const contact::TangentialMethod& method,
                    contact::Friction& friction, Films films) {
  static_assert(same<WRC_SPEED_LAW_NONE>(tangential::SpeedLaw::none) &&
                same<WRC_SPEED_LAW_EXPONENTIAL>(tangential::SpeedLaw::exponential) &&
                same<WRC_SPEED_LAW_HYPERBOLIC>(tangential::SpeedLaw::hyperbolic));
  static_assert(same<WRC_TEMPERATURE_LAW_NONE>(tangential::TemperatureLaw::none) &&
                same<WRC_TEMPERATURE_LAW_LINEAR>(tangential::TemperatureLaw::linear));
  const bool layer = checked.layer_thickness > 0.0 || checked.layer_yield > 0.0;
  RETURN_IF_FAILED(first_of(
      {check_films(checked, of, films), check_some(checked, of), check_temperature_law(checked, of, method),
       layer ? check_layer_of(checked, of, "layer_thickness, layer_yield", method) : Fault{},
       check_reduction(checked, of, method), read_layer(checked, of, friction.layer)}));
  friction.law.speed_law = static_cast<tangential::SpeedLaw>(checked.speed_law);
  friction.law.temperature_law = static_cast<tangential::TemperatureLaw>(checked.temperature_law);
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
  if (method.reads.has(contact::Option::slope_fall))
    friction.slope = {checked.slope_limit, checked.slope_fall};
  friction.reduction = {checked.adhesion_reduction, checked.slip_reduction};
  return read_zones(checked, of, friction);
}

Fault read_films(const wrc_friction& checked, const char* of, const contact::TangentialMethod& method,
                 tangential::FilmRows& films) {
  films = {};
  if (checked.film_numbers == 0) return {};
  if (checked.film_rows == nullptr) return Fault::null({of, "film_rows"});
  // the head, which has the numbers of rows, then the cells
  static_assert(offsetof(tangential::FilmRows, cells) == tangential::film_head_numbers * sizeof(double));
  if (checked.film_numbers > tangential::film_head_numbers)
    std::memcpy(static_cast<void*>(&films), checked.film_rows,
                tangential::film_head_numbers * sizeof(double));
  const Fault foreign = Fault::range({of, "film_rows"}, "they are no numbers of wrc_surface_friction()");
  const double rail = films.rail.count, wheel = films.wheel.count, most = tangential::most_film_rows;
  const auto whole = [&](double rows) { return rows >= 1.0 && rows <= most && rows == std::floor(rows); };
  if (!whole(rail) || !whole(wheel) || !(films.rail.width > 0.0 && films.wheel.width > 0.0) ||
      checked.film_numbers != static_cast<std::uint32_t>(tangential::film_numbers(
                                  static_cast<std::int32_t>(rail), static_cast<std::int32_t>(wheel))))
    return foreign;
  films.cells =
      reinterpret_cast<const tangential::FilmCell*>(checked.film_rows + tangential::film_head_numbers);
  for (std::int32_t k = 0; k < static_cast<std::int32_t>(rail * wheel); ++k) {
    const tangential::FilmCell& cell = films.cells[k];
    const auto within = [](double value, double largest) { return value >= 0.0 && value <= largest; };
    if (!within(cell.share, 1.0) || !within(cell.addition, 2.0)) return foreign;
    if (films.layered == 0.0) continue;
    if (!within(cell.flexibility, 1.0) || !within(cell.softness, 1.0) ||
        !within(std::abs(cell.hardening), 1e15))
      return foreign;
  }
  if (films.layered == 0.0) return {};
  if (checked.layer_thickness > 0.0 || checked.layer_yield > 0.0)
    return Fault::unsupported({of, "layer_thickness, layer_yield"},
                              "film_rows have layers: give yours to wrc_surface_friction(), as its base");
  return check_layer_of(checked, of, "film_rows", method);
}

}  // namespace wrc::abi
