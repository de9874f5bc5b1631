/// Films on rail and wheel: amounts in bins along the running band, their change by passing wheels, and the
/// friction and layer that they give. Amounts and books are whole numbers (exact_sum.hpp): nothing is lost.
#pragma once

#include <cstdint>

#include "damage/exact_sum.hpp"
#include "tangential/friction/film_rows.hpp"

namespace wrc::damage {

/// Quantities of a band, in kg or J of a whole bin: enum wrc_surface_quantity.
enum Quantity : std::int32_t { water, oxide, organic, sand, lubricant, heat, quantities };
inline constexpr std::int32_t substances = heat;

/// Columns of the books: enum wrc_surface_book.
enum Book : std::int32_t { amount, put_on, removed, squeezed, evaporated, carried, books };

/// Places for quantities in a bin: those in use and reserved ones.
inline constexpr std::int32_t quantity_places = 8;

/// Units of whole numbers: an amount times this [1/kg, 1/J].
constexpr double film_scale(std::int32_t quantity) { return quantity == heat ? 0x1p20 : 0x1p40; }

/// One bin, laid out as the caller's (wrc_surface_bin).
struct FilmBin {
  WholeNumber sum[books][quantity_places];
  std::uint64_t overflow = 0;  ///< bit i: sum i is invalid
  double reserved[7] = {};     ///< 0
};

/// The running band of a rail or a wheel, in the caller's memory.
struct Band {
  double first = 0.0, length = 1.0, width = 0.02;  ///< [m]
  std::int64_t count = 0;
  bool closed = false;     ///< the last bin is beside the first
  std::int32_t rows = 1;   ///< rows across, of `count` bins each
  double row_first = 0.0;  ///< y of the profile at which the first of several rows begins [m]
  FilmBin* bins = nullptr;
  std::int64_t stride = sizeof(FilmBin);  ///< from one bin of the caller to the next [bytes]

  double area() const { return length * width; }  ///< a bin's [m^2]
  std::int64_t all() const { return count * rows; }
  /// Row k as a band.
  Band row(std::int32_t k) const {
    Band one = *this;
    one.rows = 1;
    if (bins != nullptr) one.bins = &bin(k * count);
    return one;
  }
  FilmBin& bin(std::int64_t k) const {
    return *reinterpret_cast<FilmBin*>(reinterpret_cast<char*>(bins) + k * stride);
  }
};

/// Constants of one substance: wrc_substance.
struct Substance {
  double cover = 0.0, weight = 0.0, friction = 0.0, wet_friction = 0.0;
  double removal = 0.0;       ///< tau [m^2/J]
  double kept = 0.0;          ///< [kg/m^2]
  double squeeze_rate = 0.0;  ///< -ln(1 - share pressed out by one passage) [-]
  double carry = 0.0;         ///< rate at which amounts on both bodies become equal, by one passage [-]
  double density = 1000.0, modulus = 0.0, yield = 0.0, hardening = 0.0;
};

/// Constants of all substances: wrc_surface_laws.
struct FilmLaws {
  Substance of[substances];
  double rail_share = 0.5;
  double capacity[2] = {};  ///< rail's and wheel's [J/(m^2 K)]
  double cooling_time = 60.0, drying_time = 1800.0;
  double evaporation_share = 0.0, evaporation_amount = 5e-3, latent_heat = 2.4e6;
  double ambient = 20.0;
};

/// A step of a wheel on its rail: wrc_surface_passage.
struct Passage {
  double from[2] = {}, to[2] = {};  ///< distances along the rail and round the wheel [m]
  double energy = 0.0;              ///< frictional [J]
  double touched[2] = {1.0, 1.0};   ///< shares of the bands' widths that the contact covers
};

/// A strip in contact, by y of the profiles of rail and wheel.
struct TouchingStrip {
  double y[2] = {};         ///< places of its middle [m]
  double half_width = 0.0;  ///< in y [m]
  double energy = 0.0;      ///< its share of the frictional energy [-]
  double share = 1.0;       ///< its length over that of the longest [-]
};

/// Outcome of a source or a passage.
struct FilmOutcome {
  bool beside = false;                   ///< part lay beyond an end
  bool in_range = true;                  ///< no sum passed its range
  WholeNumber carried[quantity_places];  ///< from rail to wheel
  WholeNumber energy[2];                 ///< booked in the bins of rail and wheel
  WholeNumber energy_beside;
};

/// Places of a band's rows, for the friction of strips.
tangential::RowsAcross rows_across(const Band& band);

/// Largest number of bins that one call passes on a body.
inline constexpr double most_passed = 1e5;

/// Puts `per_area` of a quantity on a stretch of a band [kg/m^2, J/m^2].
FilmOutcome put(const Band& band, std::int32_t quantity, double per_area, double from, double to);

/// A wheel passes. `wheel`: nullptr: it carries nothing. Bands with rows need the strips in contact: parts of
/// strips that touch both rows of a pair act on it.
FilmOutcome pass(const Band& rail, const Band* wheel, const FilmLaws& laws, const Passage& passage,
                 const TouchingStrip* strips, std::int32_t count);

/// All bins cool and dry for a time [s]. False: a sum passed its range.
bool rest(const Band& band, const FilmLaws& laws, double duration);

/// Adds bins of the same band. False: a sum passed its range.
bool merge(const Band& into, const Band& from);

/// Amounts at a place of a band, row by row.
struct FilmsAt {
  std::int32_t rows = 1;
  double per_area[quantities][tangential::most_film_rows];  ///< [kg/m^2], heat [J/m^2]
  bool lies[quantities] = {};                               ///< is there any of it, on some row?
  bool beside = false, in_range = true;

  FilmsAt() {
    for (auto& amounts : per_area) amounts[0] = 0.0;
  }
};
FilmsAt films_at(const Band& band, double place);

/// Friction and layer between a row of the rail and one of the wheel.
struct FilmFriction {
  double bare = 1.0;         ///< share of steel that no substance but water covers
  double wet = 0.0;          ///< share that water covers
  double friction = 0.0;     ///< part of the substances [-]
  double thickness = 0.0;    ///< [m]
  double flexibility = 0.0;  ///< thickness over shear modulus [m/Pa]
  double softness = 0.0;     ///< 1 / traction at which it yields; 0: it does not [1/Pa]
  double hardening = 0.0;    ///< [Pa/m]

  /// Coefficient of friction, from those of clean, dry steel and of wet steel. It is share() times the dry
  /// one, plus addition().
  double coefficient(double clean, double wet_steel) const {
    return bare * (clean + (wet_steel - clean) * wet) + friction;
  }
  double share() const { return bare * (1.0 - wet); }
  double addition(double wet_steel) const { return bare * wet * wet_steel + friction; }
};

/// Has some substance a layer? Then strips have one even where nothing lies.
bool layered(const FilmLaws& laws);

/// Mixes the films of one row of the rail with those of each row of the wheel.
void mix(const FilmLaws& laws, const FilmsAt& rail, std::int32_t row, const FilmsAt& wheel,
         FilmFriction* mixed);

/// Temperature of the hottest row of a surface [degC].
double temperature(const FilmLaws& laws, const FilmsAt& at, int body);

}  // namespace wrc::damage
