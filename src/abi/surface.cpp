/// Films on rail and wheel behind the C interface: checks of bands and constants, friction and layer.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>

#include "abi/fp_environment.hpp"
#include "abi/friction.hpp"
#include "abi/handles.hpp"
#include "abi/message.hpp"
#include "abi/presets.hpp"
#include "abi/structs.hpp"
#include "contact/rolled_region.hpp"
#include "damage/film.hpp"
#include "wrc/wrc_surface.h"

namespace wrc::abi {
namespace {

static_assert(sizeof(damage::FilmBin) <= Description<wrc_surface_bin>::first &&
              offsetof(damage::FilmBin, overflow) == offsetof(wrc_surface_bin, overflow));
static_assert(int{damage::quantities} == WRC_SURFACE_QUANTITIES && int{damage::heat} == WRC_SURFACE_HEAT &&
              int{damage::books} == WRC_SURFACE_BOOKS && int{damage::carried} == WRC_SURFACE_CARRIED);

/// A band of the caller, whose bins have the size of the caller's header.
Fault read_surface(const wrc_surface* theirs, const char* name, damage::Band& band) {
  wrc_surface ours;
  RETURN_IF_FAILED(read(theirs, name, ours));
  RETURN_IF_FAILED(
      check_bins<damage::FilmBin>(ours, name, MEMBER(wrc_surface, "bin_size"),
                                  "it is the size of one of the bins: set it to sizeof(wrc_surface_bin)"));
  band = {.first = ours.first,
          .length = ours.length,
          .width = ours.width,
          .count = static_cast<std::int64_t>(ours.count),
          .closed = ours.closed != 0,
          .rows = std::max(1, static_cast<std::int32_t>(ours.rows)),
          .row_first = ours.row_first,
          .bins = reinterpret_cast<damage::FilmBin*>(ours.bins),
          .stride = static_cast<std::int64_t>(ours.bin_size)};
  return {};
}

/// Members of friction are in use where a substance covers, and zero elsewhere. Water covers without hiding
/// the wetted substances: it has neither weight nor layer.
Fault check_cover(const wrc_substance& checked, const char* of, bool is_water) {
  const bool covers = checked.cover > 0.0, hides = covers && !is_water;
  const char* const needed = "a substance that covers needs its weight and its friction, dry and wet";
  const char* const unused = is_water ? "water wets what it covers: wet_friction alone is read"
                                      : "cover is 0: the substance has no effect on friction and layer";
  const auto used = [&](const char* field, double value, bool is_used) {
    if ((value != 0.0) == is_used) return Fault{};
    return Fault::range({of, field}, {value, ""}, is_used ? needed : unused);
  };
  const auto allowed = [&](const char* field, double value) {
    return hides ? Fault{} : used(field, value, false);
  };
  return first_of({used("weight", checked.weight, hides), used("friction", checked.friction, hides),
                   used("wet_friction", checked.wet_friction, covers),
                   allowed("layer_modulus", checked.layer_modulus),
                   allowed("layer_yield", checked.layer_yield)});
}

Fault read_substance(const wrc_substance& checked, const char* of, bool is_water,
                     damage::Substance& substance) {
  RETURN_IF_FAILED(check_cover(checked, of, is_water));
  if (checked.layer_hardening != 0.0 && checked.layer_yield == 0.0)
    return Fault::range({of, "layer_hardening"}, {checked.layer_hardening, "Pa/m"},
                        "layer_yield is 0: a layer that does not yield cannot harden");
  substance = {.cover = checked.cover,
               .weight = checked.weight,
               .friction = checked.friction,
               .wet_friction = checked.wet_friction,
               .removal = checked.removal,
               .kept = checked.kept,
               .squeeze_rate = checked.squeeze > 0.0 ? -natural_log(1.0 - checked.squeeze) : 0.0,
               .carry = checked.carry,
               .density = checked.density,
               .modulus = checked.layer_modulus,
               .yield = checked.layer_yield,
               .hardening = checked.layer_hardening};
  return {};
}

Fault read_laws(const wrc_surface_laws* theirs, damage::FilmLaws& laws) {
  wrc_surface_laws ours;
  RETURN_IF_FAILED(read(theirs, "laws", ours));
  laws.rail_share = ours.rail_share;
  laws.capacity[0] = ours.rail_heat_capacity;
  laws.capacity[1] = ours.wheel_heat_capacity;
  laws.cooling_time = ours.cooling_time;
  laws.drying_time = ours.drying_time;
  laws.evaporation_share = ours.evaporation_share;
  laws.evaporation_amount = ours.evaporation_amount;
  laws.latent_heat = ours.latent_heat;
  laws.ambient = ours.ambient;
  return first_of({read_substance(ours.water, "laws.water", true, laws.of[damage::water]),
                   read_substance(ours.oxide, "laws.oxide", false, laws.of[damage::oxide]),
                   read_substance(ours.film, "laws.film", false, laws.of[damage::organic]),
                   read_substance(ours.sand, "laws.sand", false, laws.of[damage::sand]),
                   read_substance(ours.lubricant, "laws.lubricant", false, laws.of[damage::lubricant])});
}

/// A stretch of a band that one call passes.
Fault check_stretch(const damage::Band& band, const char* field, double from, double to) {
  const double passed = std::abs(to - from) / band.length;
  if (passed <= damage::most_passed) return {};
  return Fault::range(field, {passed, "bins", 0.0, damage::most_passed},
                      "one call passes no more bins: divide the stretch");
}

/// Both bodies and the passage between them. A wheel may be NULL.
struct Meeting {
  damage::Band rail, wheel;
  damage::FilmLaws laws;
  damage::Passage passage;
  double* film_rows = nullptr;
  std::uint32_t film_numbers = 0;
  const wrc_contact* contact = nullptr;

  bool in_rows() const { return rail.rows > 1 || wheel.rows > 1; }
};

Fault read_meeting(const wrc_surface* rail, const wrc_surface* wheel, const wrc_surface_laws* laws,
                   const wrc_surface_passage* passage, Meeting& meeting) {
  wrc_surface_passage ours;
  RETURN_IF_FAILED(read_surface(rail, "rail", meeting.rail));
  if (wheel != nullptr) RETURN_IF_FAILED(read_surface(wheel, "wheel", meeting.wheel));
  if (wheel != nullptr && meeting.wheel.bins == meeting.rail.bins)
    return Fault::range("wheel.bins", "they are the rail's: each body needs bins of its own");
  RETURN_IF_FAILED(read_laws(laws, meeting.laws));
  RETURN_IF_FAILED(read(passage, "passage", ours));
  meeting.passage = {{ours.rail_from, ours.wheel_from}, {ours.rail_to, ours.wheel_to}, ours.energy};
  meeting.film_rows = ours.film_rows;
  meeting.film_numbers = ours.film_rows != nullptr ? ours.film_numbers : 0;
  meeting.contact = ours.contact;
  RETURN_IF_FAILED(check_stretch(meeting.rail, "passage.rail_to", ours.rail_from, ours.rail_to));
  if (wheel == nullptr) return {};
  return check_stretch(meeting.wheel, "passage.wheel_to", ours.wheel_from, ours.wheel_to);
}

/// Flags of a call that was done.
Fault flags_of(bool beside, bool in_range) {
  Fault fault;
  if (beside) keep_worst(fault, Fault::beyond_sections("rail", "part of the stretch lies beyond the bins"));
  if (!in_range) keep_worst(fault, Fault::sum_overflow());
  return fault;
}

Fault check_quantity(std::int32_t quantity) {
  if (quantity >= 0 && quantity < WRC_SURFACE_QUANTITIES) return {};
  return Fault::unsupported("quantity", {quantity, ""}, enumerations::wrc_surface_quantity.names);
}

double flexibility_of(const wrc_friction& friction) {
  return friction.layer_modulus > 0.0 ? friction.layer_thickness / friction.layer_modulus : 0.0;
}

double softness_of(const wrc_friction& friction) {
  return friction.layer_yield > 0.0 ? 1.0 / friction.layer_yield : 0.0;
}

/// Layer of the base and of films in series, within the ranges of friction.
void put_layer(const damage::FilmFriction& mixed, wrc_friction& friction) {
  constexpr double hardest = 1e11, softest = 1e3, thickest = 0.01;
  const double flexibility = flexibility_of(friction) + mixed.flexibility;
  // the modulus is that of the whole thickness and the whole flexibility [Pa]
  friction.layer_thickness = std::min(friction.layer_thickness + mixed.thickness, thickest);
  friction.layer_modulus =
      flexibility > 0.0 ? std::clamp(friction.layer_thickness / flexibility, 1e3, 1e12) : 0.0;
  if (!(flexibility > 0.0)) friction.layer_thickness = 0.0;
  // one over the traction at which the layers yield; 0 without films: the layer does not yield
  const double softness = mixed.softness + softness_of(friction);
  friction.layer_yield = softness * hardest > 1.0 ? std::max(1.0 / softness, softest) : hardest;
  friction.layer_hardening += mixed.hardening;
  if (flexibility > 0.0)  // wrc_contact_wrench() refuses -0.5 and less: tractions would jump
    friction.layer_hardening = std::max(friction.layer_hardening, -0.49 / flexibility);
}

/// Fills the caller's numbers of films in rows. The base's layer lies in series with the films' layers.
Fault fill_rows(const Meeting& meeting, const damage::FilmsAt& rail, const damage::FilmsAt& wheel,
                wrc_friction& found) {
  const auto needed = static_cast<std::uint32_t>(tangential::film_numbers(rail.rows, wheel.rows));
  if (meeting.film_numbers < needed)
    return Fault::range("passage.film_numbers", {meeting.film_numbers, "", 1.0 * needed, 1288.0},
                        "rows across need WRC_FILM_NUMBERS(rail.rows, wheel.rows) numbers at film_rows");
  const bool layered = damage::layered(meeting.laws);
  const tangential::FilmRows head{.rail = damage::rows_across(meeting.rail),
                                  .wheel = damage::rows_across(meeting.wheel),
                                  .layered = layered ? 1.0 : 0.0};
  std::memcpy(meeting.film_rows, &head, tangential::film_head_numbers * sizeof(double));
  const double wet_steel = meeting.laws.of[damage::water].wet_friction;
  const double flexibility = flexibility_of(found), softness = softness_of(found);
  auto* cell = reinterpret_cast<tangential::FilmCell*>(meeting.film_rows + tangential::film_head_numbers);
  for (std::int32_t r = 0; r < rail.rows; ++r) {
    damage::FilmFriction mixed[tangential::most_film_rows];
    mix(meeting.laws, rail, r, wheel, mixed);
    for (std::int32_t w = 0; w < wheel.rows; ++w, ++cell) {
      const damage::FilmFriction& of = mixed[w];
      *cell = {of.share(), std::min(of.addition(wet_steel), 2.0), flexibility + of.flexibility,
               softness + of.softness, found.layer_hardening + of.hardening};
    }
  }
  found.film_rows = meeting.film_rows;
  found.film_numbers = needed;
  if (layered) found.layer_thickness = found.layer_modulus = found.layer_yield = found.layer_hardening = 0.0;
  return {};
}

Fault find_friction(const Meeting& meeting, bool has_wheel, const wrc_friction* base, wrc_friction& found) {
  RETURN_IF_FAILED(read_or_defaults(base, "base", found));
  if (found.film_numbers > 0)
    return Fault::unsupported({"base", "film_numbers"}, {found.film_numbers, ""},
                              "the base is friction of clean bodies: set it to 0");
  if (found.zone_count > 0 && meeting.film_numbers == 0)
    return Fault::unsupported({"base", "zone_count"}, {found.zone_count, ""},
                              "zones stay below films that are told as rows: give passage.film_rows");
  tangential::Layer whole_or_absent;
  RETURN_IF_FAILED(read_layer(found, "base", whole_or_absent));
  const damage::FilmsAt rail = films_at(meeting.rail, meeting.passage.from[0]);
  const damage::FilmsAt wheel =
      has_wheel ? films_at(meeting.wheel, meeting.passage.from[1]) : damage::FilmsAt{};
  if (meeting.in_rows() || meeting.film_numbers > 0) {
    RETURN_IF_FAILED(fill_rows(meeting, rail, wheel, found));
  } else {
    damage::FilmFriction mixed;
    mix(meeting.laws, rail, 0, wheel, &mixed);
    const double coefficient =
        mixed.coefficient(found.coefficient, meeting.laws.of[damage::water].wet_friction);
    constexpr double least = 1e-4;  // smallest friction coefficient but 0 [-]
    found.coefficient = coefficient > 0.0 ? std::max(coefficient, least) : 0.0;
    if (damage::layered(meeting.laws)) put_layer(mixed, found);
  }
  found.bulk.rail = temperature(meeting.laws, rail, 0);
  found.bulk.wheel = temperature(meeting.laws, wheel, 1);
  return flags_of(rail.beside || wheel.beside, rail.in_range && wheel.in_range);
}

/// A wheel passes bands with rows: each strip of the contact's last wrench acts with its share of the power.
Fault pass_in_rows(const Meeting& meeting, const damage::Band* wheel, damage::FilmOutcome& outcome) {
  const char* const needed = "rows across need the contact whose wrench passes";
  if (meeting.contact == nullptr || !valid(meeting.contact))
    return Fault::sequence("passage.contact", needed);
  const contact::Contact& contact = *meeting.contact->contact;
  if (!contact.wheel_solved) return Fault::sequence("passage.contact", needed);
  damage::TouchingStrip strips[surface::most_overlapping_strips];
  const std::int32_t count = contact::touching_strips(contact, strips);
  outcome = pass(meeting.rail, wheel, meeting.laws, meeting.passage, strips, count);
  return {};
}

// ---------------------------------------------------------------------------------------------- named sets

struct NamedSet {
  const char* name;
};

constexpr NamedSet sets[] = {
#define WRC_NAME_OF(identifier, name) {name},
    WRC_SURFACE_LAWS_LIST(WRC_NAME_OF)
#undef WRC_NAME_OF
};
constexpr const char* known_sets = "no such set; there are"
#define WRC_NAME_OF(identifier, name) " \"" name "\""
    WRC_SURFACE_LAWS_LIST(WRC_NAME_OF);
#undef WRC_NAME_OF

/// docs/theory.md, "Films on rail and wheel", has the sources. Layers are those of friction by name.
void set_low_adhesion(wrc_surface_laws& laws, bool layers) {
  const auto substance = [&](double cover, double weight, double dry, double wet) {
    wrc_substance made = defaults<wrc_substance>();
    made.cover = cover;
    made.weight = weight;
    made.friction = dry;
    made.wet_friction = wet;
    return made;
  };
  laws.water.cover = 5e-3;
  laws.water.wet_friction = 0.25;
  laws.oxide = substance(5e-3, 3.0, 0.4, 0.1);
  laws.film = substance(1e-2, 10.0, 0.12, 0.03);
  laws.sand = substance(3e-2, 10.0, 0.45, 0.3);
  laws.lubricant = substance(2e-3, 10.0, 0.1, 0.08);
  // Allotta and others: 1.9e-4 m/J per energy over way, times a band 20 mm wide
  laws.film.removal = 3.8e-6;
  laws.oxide.removal = laws.lubricant.removal = 2e-7;
  // water and crushed sand leave the band fast, solid films hardly
  laws.water.kept = laws.water.cover;
  laws.water.squeeze = laws.sand.squeeze = 0.3;
  laws.film.kept = laws.film.cover;
  laws.film.squeeze = 0.1;
  laws.water.carry = laws.sand.carry = 0.05;
  laws.film.carry = 0.02;
  laws.oxide.carry = laws.lubricant.carry = 0.05;
  laws.oxide.density = 5200.0;
  laws.sand.density = 1600.0;
  laws.evaporation_share = 0.1;
  if (!layers) return;
  const auto layer = [](wrc_substance& of, const char* name) {
    wrc_friction friction = defaults<wrc_friction>();
    use_friction(&friction, name);
    of.layer_modulus = friction.layer_modulus;
    of.layer_yield = friction.layer_yield;
    of.layer_hardening = friction.layer_hardening;
  };
  layer(laws.oxide, "magnetite");
  layer(laws.film, "clay");
  layer(laws.sand, "sand");
  layer(laws.lubricant, "MoS2");
}

Fault use_set(wrc_surface_laws* laws, const char* name) {
  if (laws == nullptr) return Fault::null("laws");
  RETURN_IF_FAILED(check_size(*laws));
  if (name == nullptr) return Fault::null("name");
  const NamedSet* const found = row_of(sets, name);
  if (found == std::end(sets)) return Fault::unsupported("name", known_sets);
  wrc_surface_laws theirs = defaults<wrc_surface_laws>(), ours = theirs;
  const std::size_t known = std::min<std::size_t>(laws->struct_size, sizeof theirs);
  std::memcpy(&theirs, laws, known);
  set_low_adhesion(ours, found != std::begin(sets));
  // members that no set has, and those of a newer header, stay
  ours.struct_size = theirs.struct_size;
  ours.reserved0 = theirs.reserved0;
  ours.ambient = theirs.ambient;
  for (wrc_substance wrc_surface_laws::*const each :
       {&wrc_surface_laws::water, &wrc_surface_laws::oxide, &wrc_surface_laws::film, &wrc_surface_laws::sand,
        &wrc_surface_laws::lubricant})
    std::memcpy((ours.*each).reserved, (theirs.*each).reserved, sizeof(wrc_substance::reserved));
  std::memcpy(laws, &ours, known);
  return {};
}

// ------------------------------------------------------------------------------------------- books and bins

Fault add_source(wrc_surface* surface, std::int32_t quantity, double amount, double from, double to) {
  damage::Band band;
  RETURN_IF_FAILED(read_surface(surface, "surface", band));
  RETURN_IF_FAILED(check_quantity(quantity));
  const bool heat = quantity == WRC_SURFACE_HEAT;
  const char* cause = "a source puts on: what goes is taken by wrc_surface_pass() and wrc_surface_rest()";
  RETURN_IF_FAILED(first_of(
      {check(amount, "amount", heat ? "J/m^2" : "kg/m^2", 0.0, heat ? 1e9 : 100.0, cause, "did you pass g?"),
       check(from, "from", "m", -1e9, 1e9)}));
  RETURN_IF_FAILED(check(to, "to", "m", from, 1e9, "the stretch ends before it begins"));
  RETURN_IF_FAILED(check_stretch(band, "to", from, to));
  const damage::FilmOutcome outcome = damage::put(band, quantity, amount, from, to);
  return flags_of(outcome.beside, outcome.in_range);
}

Fault merge_surfaces(wrc_surface* into, const wrc_surface* from) {
  damage::Band ours, theirs;
  RETURN_IF_FAILED(read_surface(into, "into", ours));
  RETURN_IF_FAILED(read_surface(from, "from", theirs));
  const char* cause = "its bins lie elsewhere than those of `into`";
  const auto alike = [&](double number, double wanted, const char* field, const char* unit) {
    return check(number, field, unit, wanted, wanted, cause, cause);
  };
  RETURN_IF_FAILED(
      first_of({alike(static_cast<double>(theirs.count), static_cast<double>(ours.count), "from.count", ""),
                alike(theirs.first, ours.first, "from.first", "m"),
                alike(theirs.length, ours.length, "from.length", "m"),
                alike(theirs.width, ours.width, "from.width", "m"),
                alike(theirs.closed ? 1.0 : 0.0, ours.closed ? 1.0 : 0.0, "from.closed", ""),
                alike(theirs.rows, ours.rows, "from.rows", ""),
                alike(theirs.row_first, ours.row_first, "from.row_first", "m")}));
  return flags_of(false, damage::merge(ours, theirs));
}

Fault read_values(const wrc_surface* surface, std::int32_t quantity, std::int32_t book, double* values,
                  double* total) {
  damage::Band band;
  RETURN_IF_FAILED(read_surface(surface, "surface", band));
  RETURN_IF_FAILED(check_quantity(quantity));
  if (book < 0 || book >= WRC_SURFACE_BOOKS)
    return Fault::unsupported("book", {book, ""}, enumerations::wrc_surface_book.names);
  if (values == nullptr && total == nullptr) return Fault::null("values, total");
  // the total is a sum of whole numbers, exact in any order
  damage::WholeNumber sum;
  bool in_range = true;
  for (std::int64_t k = 0; k < band.all(); ++k) {
    const damage::FilmBin& bin = band.bin(k);
    const damage::WholeNumber& one = bin.sum[book][quantity];
    const damage::WholeNumber before = sum;
    sum = plus(sum, one);
    in_range = in_range && !left_range(before, one, sum) &&
               (bin.overflow >> (book * damage::quantity_places + quantity) & 1U) == 0;
    if (values != nullptr) values[k] = number(one) / damage::film_scale(quantity) / band.area();
  }
  if (total != nullptr) *total = number(sum) / damage::film_scale(quantity);
  return flags_of(false, in_range);
}

}  // namespace
}  // namespace wrc::abi

namespace abi = wrc::abi;
using wrc::Fault;

extern "C" {

int32_t wrc_surface_laws_use(wrc_surface_laws* laws, const char* name, char* text, uint64_t size) {
  return abi::finish(__func__, abi::use_set(laws, name), text, size);
}

int32_t wrc_surface_add(wrc_surface* surface, int32_t quantity, double amount, double from, double to,
                        char* text, uint64_t size) {
  const abi::FloatingPointScope scope;
  return abi::finish(__func__, abi::add_source(surface, quantity, amount, from, to), text, size);
}

int32_t wrc_surface_friction(const wrc_surface* rail, const wrc_surface* wheel, const wrc_surface_laws* laws,
                             const wrc_surface_passage* passage, const wrc_friction* base,
                             wrc_friction* friction, char* text, uint64_t size) {
  const abi::FloatingPointScope scope;
  abi::Meeting meeting;
  wrc_friction found = abi::defaults<wrc_friction>();
  Fault fault =
      friction == nullptr ? Fault::null("friction") : abi::read_meeting(rail, wheel, laws, passage, meeting);
  if (!fault.failed()) fault = abi::find_friction(meeting, wheel != nullptr, base, found);
  if (friction != nullptr) *friction = fault.failed() ? abi::defaults<wrc_friction>() : found;
  return abi::finish(__func__, fault, text, size);
}

int32_t wrc_surface_pass(wrc_surface* rail, wrc_surface* wheel, const wrc_surface_laws* laws,
                         const wrc_surface_passage* passage, wrc_surface_exchange* exchange, char* text,
                         uint64_t size) {
  const abi::FloatingPointScope scope;
  abi::Meeting meeting;
  Fault fault = abi::first_of({abi::clear(exchange), abi::read_meeting(rail, wheel, laws, passage, meeting)});
  const wrc::damage::Band* const round = wheel != nullptr ? &meeting.wheel : nullptr;
  wrc::damage::FilmOutcome outcome;
  if (fault.failed()) return abi::finish(__func__, fault, text, size);
  if (meeting.in_rows())
    fault = abi::pass_in_rows(meeting, round, outcome);
  else
    outcome = wrc::damage::pass(meeting.rail, round, meeting.laws, meeting.passage, nullptr, 0);
  if (fault.failed()) return abi::finish(__func__, fault, text, size);
  auto result = abi::empty<wrc_surface_exchange>();
  for (int32_t q = 0; q < WRC_SURFACE_QUANTITIES; ++q)
    result.carried[q] = number(outcome.carried[q]) / wrc::damage::film_scale(q);
  const double scale = wrc::damage::film_scale(WRC_SURFACE_HEAT);
  result.rail_energy = number(outcome.energy[0]) / scale;
  result.wheel_energy = number(outcome.energy[1]) / scale;
  result.beside_energy = number(outcome.energy_beside) / scale;
  abi::write(result, exchange);
  fault = abi::flags_of(outcome.beside, outcome.in_range);
  return abi::finish(__func__, fault, text, size);
}

int32_t wrc_surface_rest(wrc_surface* surface, const wrc_surface_laws* laws, double duration, char* text,
                         uint64_t size) {
  const abi::FloatingPointScope scope;
  wrc::damage::Band band;
  wrc::damage::FilmLaws read;
  Fault fault = abi::first_of({abi::read_surface(surface, "surface", band), abi::read_laws(laws, read),
                               abi::check(duration, "duration", "s", 0.0, 1e9, "time does not go back")});
  if (!fault.failed()) fault = abi::flags_of(false, wrc::damage::rest(band, read, duration));
  return abi::finish(__func__, fault, text, size);
}

int32_t wrc_surface_merge(wrc_surface* into, const wrc_surface* from, char* text, uint64_t size) {
  const abi::FloatingPointScope scope;
  return abi::finish(__func__, abi::merge_surfaces(into, from), text, size);
}

int32_t wrc_surface_values(const wrc_surface* surface, int32_t quantity, int32_t book, double* values,
                           double* total, char* text, uint64_t size) {
  const abi::FloatingPointScope scope;
  if (total != nullptr) *total = 0.0;
  return abi::finish(__func__, abi::read_values(surface, quantity, book, values, total), text, size);
}

}  // extern "C"
