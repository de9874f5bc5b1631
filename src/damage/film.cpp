#include "damage/film.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/elementary.hpp"

namespace wrc::damage {
namespace {

/// 1 - exp(-x) for x >= 0. A series keeps the last digits where x is small; most steps need only the series.
double spent(double x) {
  if (!(x < 0.02)) return 1.0 - natural_exp(-x);
  constexpr double c2 = 1.0 / 2, c3 = 1.0 / 3, c4 = 1.0 / 4, c5 = 1.0 / 5, c6 = 1.0 / 6, c7 = 1.0 / 7;
  return x *
         (1.0 - c2 * x * (1.0 - c3 * x * (1.0 - c4 * x * (1.0 - c5 * x * (1.0 - c6 * x * (1.0 - c7 * x))))));
}

bool less(const WholeNumber& a, const WholeNumber& b) {  // amounts, not below 0
  return a.high < b.high || (a.high == b.high && a.low < b.low);
}

bool nothing(const WholeNumber& all) { return all.low == 0 && all.high == 0; }

/// A share, 0 .. 1, of an amount; never more than that.
WholeNumber part_of(const WholeNumber& all, double share) {
  if (nothing(all)) return {};
  if (all.high >> 62 != 0) return {};  // the sum passed its range, or was never zeroed
  const WholeNumber part = whole(number(all) * share);
  return less(all, part) ? all : part;
}

double stored(const FilmBin& bin, std::int32_t quantity) {
  return std::max(0.0, number(bin.sum[amount][quantity]) / film_scale(quantity));
}

/// Adds to a sum of a bin, and marks a sum that passes its range.
void add(FilmBin& bin, std::int32_t book, std::int32_t quantity, const WholeNumber& more, bool& in_range) {
  WholeNumber& sum = bin.sum[book][quantity];
  const WholeNumber before = sum;
  sum = plus(before, more);
  if (!left_range(before, more, sum)) return;
  bin.overflow |= std::uint64_t{1} << (book * quantity_places + quantity);
  in_range = false;
}

/// Brings an amount onto a bin, by a source.
void bring(FilmBin& bin, std::int32_t quantity, const WholeNumber& more, bool& in_range) {
  add(bin, amount, quantity, more, in_range);
  add(bin, put_on, quantity, more, in_range);
}

/// Takes an amount off a bin, and books it in the column that says why.
void take(FilmBin& bin, std::int32_t quantity, Book where, const WholeNumber& less_by, bool& in_range) {
  add(bin, amount, quantity, minus({}, less_by), in_range);
  add(bin, where, quantity, less_by, in_range);
}

/// Two neighbouring bins and their parts at a place between their middles. Beyond an end both are the bin at
/// the end.
struct Neighbours {
  std::int64_t bin[2];
  double part[2];
};

std::int64_t wrapped(std::int64_t k, std::int64_t count) { return ((k % count) + count) % count; }

/// `middle`: index of the bin whose middle lies before the place. `beyond`: share of the distance from there
/// to the next middle.
Neighbours neighbours(const Band& band, std::int64_t middle, double beyond) {
  const std::int64_t last = band.count - 1;
  const double part = std::clamp(beyond, 0.0, 1.0);
  if (band.closed)
    return {{wrapped(middle, band.count), wrapped(middle + 1, band.count)}, {1.0 - part, part}};
  return {{std::clamp<std::int64_t>(middle, 0, last), std::clamp<std::int64_t>(middle + 1, 0, last)},
          {1.0 - part, part}};
}

/// Splits an amount between neighbours to the last unit.
void split(const WholeNumber& all, const Neighbours& of, WholeNumber parts[2]) {
  parts[0] = part_of(all, of.part[0]);
  parts[1] = minus(all, parts[0]);
}

/// The way of a passage over one band, in pieces within which the parts of two neighbours change in straight
/// lines. Pieces end at the middles of bins, and on a band with ends also at their borders.
class Way {
 public:
  Way(const Band& band, double from, double to)
      : per_bin_(band.closed ? 1 : 2),
        start_(static_cast<double>(per_bin_) * ((from - band.first) / band.length - 0.5)),
        change_(static_cast<double>(per_bin_) * ((to - from) / band.length)),
        length_(std::abs(to - from)),
        cell_(static_cast<std::int64_t>(std::floor(start_))),
        band_(&band) {
    if (change_ < 0.0 && start_ == static_cast<double>(cell_)) --cell_;
  }
  /// Share of the way at which the present piece ends; above 1 where the way ends first.
  double next() const {
    if (change_ == 0.0) return std::numeric_limits<double>::infinity();
    return (static_cast<double>(change_ > 0.0 ? cell_ + 1 : cell_) - start_) / change_;
  }
  void step() { cell_ += change_ > 0.0 ? 1 : -1; }
  bool beside() const { return !band_->closed && (cell_ < -1 || cell_ >= 2 * band_->count - 1); }
  /// At the middle of the piece from share `a` to share `b`.
  Neighbours at(double a, double b) const {
    const std::int64_t middle = (cell_ >= 0 ? cell_ : cell_ - (per_bin_ - 1)) / per_bin_;
    const double place = (start_ + 0.5 * (a + b) * change_) / static_cast<double>(per_bin_);
    return neighbours(*band_, middle, place - static_cast<double>(middle));
  }
  double length() const { return length_; }

 private:
  std::int64_t per_bin_;
  double start_, change_;  ///< in pieces, from the middle of the first bin
  double length_;          ///< [m]
  std::int64_t cell_;      ///< the present piece
  const Band* band_;
};

/// A piece of a passage on one body.
struct Piece {
  const Band* band;
  Neighbours of;
  double way;      ///< the body's, through the contact [m]
  double touched;  ///< share of the band's width that the contact covers
};

/// Does the substance lie on a bin of the piece?
bool lies(std::int32_t quantity, const Piece& piece) {
  return !nothing(piece.band->bin(piece.of.bin[0]).sum[amount][quantity]) ||
         !nothing(piece.band->bin(piece.of.bin[1]).sum[amount][quantity]);
}

/// Carries substances to the other body: each body gives a share and receives that of the other.
void exchange(const FilmLaws& laws, const Piece (&piece)[2], FilmOutcome& outcome) {
  const double way = std::max(piece[0].way, piece[1].way);
  for (std::int32_t q = 0; q < substances; ++q) {
    if (laws.of[q].carry == 0.0 || !(lies(q, piece[0]) || lies(q, piece[1]))) continue;
    // shares that each body gives from both of its bins, before it receives [kg]
    WholeNumber given[2];
    for (int body = 0; body < 2; ++body) {
      const Piece& mine = piece[body];
      for (int i = 0; i < 2; ++i) {
        FilmBin& bin = mine.band->bin(mine.of.bin[i]);
        const double passed = mine.of.part[i] * way / mine.band->length * mine.touched;
        const WholeNumber part = part_of(bin.sum[amount][q], spent(0.5 * laws.of[q].carry * passed));
        take(bin, q, carried, part, outcome.in_range);
        given[body] = plus(given[body], part);
      }
    }
    // shares that each body receives [kg]
    for (int body = 0; body < 2; ++body) {
      WholeNumber parts[2];
      split(given[1 - body], piece[body].of, parts);
      for (int i = 0; i < 2; ++i)
        take(piece[body].band->bin(piece[body].of.bin[i]), q, carried, minus({}, parts[i]), outcome.in_range);
    }
    outcome.carried[q] = plus(outcome.carried[q], minus(given[0], given[1]));
  }
}

/// Losses of a bin: removal by the dose of frictional energy over its area [J/m^2], squeezing by rolling.
void wear_off(const FilmLaws& laws, const Band& band, FilmBin& bin, double dose, double passed,
              bool& in_range) {
  for (std::int32_t q = 0; q < substances; ++q) {
    const Substance& law = laws.of[q];
    const WholeNumber& there = bin.sum[amount][q];
    if (nothing(there)) continue;
    if (law.removal > 0.0) take(bin, q, removed, part_of(there, spent(law.removal * dose)), in_range);
    if (!(law.squeeze_rate > 0.0)) continue;
    const WholeNumber kept = whole(law.kept * band.area() * film_scale(q));
    if (less(kept, there))
      take(bin, q, squeezed, part_of(minus(there, kept), spent(law.squeeze_rate * passed)), in_range);
  }
}

/// Heats a bin. Of the heat q the part eta q m / (m + m_half) evaporates water, never more than there is.
void heat_up(const FilmLaws& laws, const Band& band, FilmBin& bin, const WholeNumber& energy,
             bool& in_range) {
  bring(bin, heat, energy, in_range);
  const double wet = stored(bin, water);
  if (!(wet > 0.0) || laws.evaporation_share == 0.0) return;
  const double could = laws.evaporation_share * number(energy) / film_scale(heat) / laws.latent_heat;
  const WholeNumber gone =
      part_of(bin.sum[amount][water], spent(could / (wet + laws.evaporation_amount * band.area())));
  take(bin, water, evaporated, gone, in_range);
  const double took = number(gone) / film_scale(water) * laws.latent_heat;
  const WholeNumber cooled = whole(took * film_scale(heat));
  take(bin, heat, evaporated, less(energy, cooled) ? energy : cooled, in_range);
}

/// One body of a piece: frictional energy acts on its bins.
void act(const FilmLaws& laws, const Piece& piece, double energy, const WholeNumber& own, bool& in_range) {
  const Band& band = *piece.band;
  WholeNumber parts[2];
  split(own, piece.of, parts);
  for (int i = 0; i < 2; ++i) {
    FilmBin& bin = band.bin(piece.of.bin[i]);
    const double part = piece.of.part[i];
    wear_off(laws, band, bin, energy * part / band.area(), piece.way * part / band.length * piece.touched,
             in_range);
    heat_up(laws, band, bin, parts[i], in_range);
  }
}

/// Puts a quantity on one row of a band [kg/m^2, J/m^2].
void put_on_row(const Band& band, std::int32_t quantity, double per_area, double from, double to,
                FilmOutcome& outcome) {
  Way way(band, from, to);
  const double scaled = per_area * band.width * (to - from) * film_scale(quantity);
  for (double at = 0.0; at < 1.0;) {
    // pieces in which the parts of two neighbours change in straight lines: their middle has the mean
    const double end = std::clamp(way.next(), at, 1.0);
    outcome.beside = outcome.beside || (way.beside() && end > at);
    if (!way.beside()) {
      const Neighbours of = way.at(at, end);
      WholeNumber parts[2];
      split(whole(scaled * (end - at)), of, parts);
      for (int i = 0; i < 2; ++i) bring(band.bin(of.bin[i]), quantity, parts[i], outcome.in_range);
    }
    at = end;
    way.step();
  }
}

/// Passage of one row of the wheel over one row of the rail.
void pass_rows(const Band& rail, const Band* wheel, const FilmLaws& laws, const Passage& passage,
               FilmOutcome& outcome) {
  const Band none{.count = 1};
  const Band& round = wheel != nullptr ? *wheel : none;
  Way along(rail, passage.from[0], passage.to[0]), about(round, passage.from[1], passage.to[1]);
  const double scale = film_scale(heat);
  WholeNumber booked;
  for (double at = 0.0; at < 1.0;) {
    // a piece ends at the next middle or border of a bin of either body
    const double of_rail = along.next(), of_wheel = wheel != nullptr ? about.next() : 2.0;
    const double end = std::clamp(std::min(of_rail, of_wheel), at, 1.0), share = end - at;
    const Piece piece[2] = {{&rail, along.at(at, end), along.length() * share, passage.touched[0]},
                            {wheel, wheel != nullptr ? about.at(at, end) : Neighbours{},
                             about.length() * share, passage.touched[1]}};
    const bool there[2] = {!along.beside(), wheel != nullptr && !about.beside()};
    outcome.beside = outcome.beside || along.beside() || (wheel != nullptr && about.beside());
    if (there[0] && there[1]) exchange(laws, piece, outcome);
    // energy up to here less that booked before: the sum over all pieces is exact
    const WholeNumber until = whole(passage.energy * end * scale), energy = minus(until, booked);
    booked = until;
    WholeNumber own[2];
    own[0] = part_of(energy, laws.rail_share);
    own[1] = minus(energy, own[0]);
    for (int body = 0; body < 2; ++body) {
      WholeNumber& sum = there[body] ? outcome.energy[body] : outcome.energy_beside;
      sum = plus(sum, own[body]);
      if (there[body]) act(laws, piece[body], passage.energy * share, own[body], outcome.in_range);
    }
    if (of_rail <= end) along.step();
    if (of_wheel <= end) about.step();
    at = end;
  }
}

constexpr std::int32_t most_rows = tangential::most_film_rows;

/// Sums over strips, for each pair of a rail's and a wheel's row: share of the energy [-], width [m].
struct Touching {
  double energy[most_rows][most_rows] = {}, width[most_rows][most_rows] = {};

  double all() const {
    double sum = 0.0;
    for (const auto& row : width)
      for (const double one : row) sum += one;
    return sum;
  }
};

void touch(const tangential::RowsAcross (&rows)[2], const TouchingStrip* strips, std::int32_t count,
           Touching& touching) {
  for (std::int32_t k = 0; k < count; ++k) {
    const TouchingStrip& strip = strips[k];
    const tangential::RowShares rail = tangential::row_shares(rows[0], strip.y[0], strip.half_width);
    const tangential::RowShares wheel = tangential::row_shares(rows[1], strip.y[1], strip.half_width);
    for (std::int32_t r = 0; r < rail.count; ++r)
      for (std::int32_t w = 0; w < wheel.count; ++w) {
        const double part = rail.share[r] * wheel.share[w];
        touching.energy[rail.first + r][wheel.first + w] += part * strip.energy;
        touching.width[rail.first + r][wheel.first + w] += part * strip.share * 2.0 * strip.half_width;
      }
  }
}

}  // namespace

tangential::RowsAcross rows_across(const Band& band) {
  return {static_cast<double>(band.rows), band.row_first + 0.5 * band.width, band.width};
}

FilmOutcome put(const Band& band, std::int32_t quantity, double per_area, double from, double to) {
  FilmOutcome outcome;
  for (std::int32_t k = 0; k < band.rows; ++k) put_on_row(band.row(k), quantity, per_area, from, to, outcome);
  return outcome;
}

FilmOutcome pass(const Band& rail, const Band* wheel, const FilmLaws& laws, const Passage& passage,
                 const TouchingStrip* strips, std::int32_t count) {
  FilmOutcome outcome;
  const std::int32_t across = wheel != nullptr ? wheel->rows : 1;
  if (rail.rows == 1 && across == 1) {
    pass_rows(rail, wheel, laws, passage, outcome);
    return outcome;
  }
  // each pair of rows, by place, is a passage of bands of which the strips cover their own width
  Touching touching;
  touch({rows_across(rail), wheel != nullptr ? rows_across(*wheel) : tangential::RowsAcross{}}, strips, count,
        touching);
  const double whole_width = touching.all();
  const auto covered = [&](const Band& band, double width) {
    return band.rows == 1 ? width / whole_width : std::min(1.0, width / band.width);
  };
  double booked = 0.0;
  for (std::int32_t r = 0; r < rail.rows; ++r)
    for (std::int32_t w = 0; w < across; ++w) {
      const double width = touching.width[r][w];
      if (!(width > 0.0)) continue;
      const Band of_rail = rail.row(r), of_wheel = wheel != nullptr ? wheel->row(w) : Band{};
      Passage part = passage;
      part.energy = passage.energy * touching.energy[r][w];
      part.touched[0] = covered(rail, width);
      part.touched[1] = wheel != nullptr ? covered(*wheel, width) : 0.0;
      pass_rows(of_rail, wheel != nullptr ? &of_wheel : nullptr, laws, part, outcome);
      booked += touching.energy[r][w];
    }
  // without strips that dissipate, no row has the energy
  const WholeNumber beside = whole(passage.energy * std::max(0.0, 1.0 - booked) * film_scale(heat));
  outcome.energy_beside = plus(outcome.energy_beside, beside);
  return outcome;
}

bool rest(const Band& band, const FilmLaws& laws, double duration) {
  bool in_range = true;
  const double cools = spent(duration / laws.cooling_time), dries = spent(duration / laws.drying_time);
  for (std::int64_t k = 0; k < band.all(); ++k) {
    FilmBin& bin = band.bin(k);
    take(bin, heat, removed, part_of(bin.sum[amount][heat], cools), in_range);
    take(bin, water, evaporated, part_of(bin.sum[amount][water], dries), in_range);
  }
  return in_range;
}

bool merge(const Band& into, const Band& from) {
  bool in_range = true;
  for (std::int64_t k = 0; k < into.all(); ++k) {
    FilmBin& bin = into.bin(k);
    const FilmBin& other = from.bin(k);
    bin.overflow |= other.overflow;
    for (std::int32_t book = 0; book < books; ++book)
      for (std::int32_t q = 0; q < quantities; ++q) add(bin, book, q, other.sum[book][q], in_range);
    in_range = in_range && bin.overflow == 0;
  }
  return in_range;
}

FilmsAt films_at(const Band& band, double place) {
  FilmsAt at;
  at.rows = band.rows;
  const Way way(band, place, place);
  const Neighbours of = way.at(0.0, 0.0);
  at.beside = way.beside();
  for (std::int32_t row = 0; row < band.rows; ++row)
    for (std::int32_t q = 0; q < quantities; ++q) at.per_area[q][row] = 0.0;
  for (int i = 0; i < 2; ++i)
    for (std::int32_t row = 0; row < band.rows; ++row) {
      const FilmBin& bin = band.bin(row * band.count + of.bin[i]);
      at.in_range = at.in_range && bin.overflow == 0;
      for (std::int32_t q = 0; q < quantities; ++q)
        if (!nothing(bin.sum[amount][q])) {
          at.per_area[q][row] += of.part[i] * stored(bin, q) / band.area();
          at.lies[q] = true;
        }
    }
  return at;
}

bool layered(const FilmLaws& laws) {
  bool any = false;
  for (std::int32_t q = water + 1; q < substances; ++q)
    any = any || laws.of[q].modulus > 0.0 || laws.of[q].yield > 0.0;
  return any;
}

void mix(const FilmLaws& laws, const FilmsAt& rail, std::int32_t row, const FilmsAt& wheel,
         FilmFriction* mixed) {
  // arrays over the rows of the wheel, for loops in vectors
  const std::int32_t across = wheel.rows;
  double wet[most_rows] = {}, bare[most_rows], weights[most_rows] = {}, friction[most_rows] = {},
         softness[most_rows] = {}, hardening[most_rows] = {}, thickness[most_rows] = {},
         flexibility[most_rows] = {};
  const auto each = [&](const auto& work) {
    for (std::int32_t w = 0; w < across; ++w) work(w);
  };
  const auto lies = [&](std::int32_t q) { return rail.lies[q] || wheel.lies[q]; };
  const auto between = [&](std::int32_t q, std::int32_t w) {
    return rail.per_area[q][row] + wheel.per_area[q][w];
  };
  const auto covered = [&](std::int32_t q, std::int32_t w) {
    return std::min(1.0, between(q, w) / laws.of[q].cover);
  };
  // Water wets bare steel and the substances on it.
  if (lies(water) && laws.of[water].cover > 0.0) each([&](std::int32_t w) { wet[w] = covered(water, w); });
  each([&](std::int32_t w) { bare[w] = 1.0; });
  // Means over the substances that cover: friction, softness and hardening, each substance by its share times
  // its weight. Layers in series.
  for (std::int32_t q = water + 1; q < substances; ++q) {
    const Substance& law = laws.of[q];
    if (!lies(q) || !(law.cover > 0.0)) continue;
    each([&](std::int32_t w) {
      const double share = covered(q, w), weight = share * law.weight;
      bare[w] *= 1.0 - share;
      weights[w] += weight;
      friction[w] += weight * (law.friction + (law.wet_friction - law.friction) * wet[w]);
    });
    if (law.yield > 0.0)
      each([&](std::int32_t w) {
        const double weight = covered(q, w) * law.weight;
        softness[w] += weight / law.yield;
        hardening[w] += weight * law.hardening;
      });
    if (!(law.modulus > 0.0)) continue;
    each([&](std::int32_t w) {
      const double thick = between(q, w) / law.density;
      thickness[w] += thick;
      flexibility[w] += thick / law.modulus;
    });
  }
  for (std::int32_t w = 0; w < across; ++w) {
    const double film = weights[w] > 0.0 ? (1.0 - bare[w]) / weights[w] : 0.0;
    mixed[w] = {bare[w],
                wet[w],
                film * friction[w],
                thickness[w],
                flexibility[w],
                film * softness[w],
                film * hardening[w]};
  }
}

double temperature(const FilmLaws& laws, const FilmsAt& at, int body) {
  double most = 0.0;
  for (std::int32_t row = 0; row < at.rows; ++row) most = std::max(most, at.per_area[heat][row]);
  return std::min(laws.ambient + most / laws.capacity[body], 2000.0);
}

}  // namespace wrc::damage
