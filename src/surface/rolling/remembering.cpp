#include "surface/rolling/remembering.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "surface/pressure/pressure.hpp"
#include "surface/rolling/strip_parts.hpp"

namespace wrc::surface {
namespace {

using tangential::memory_cells;
using tangential::PastStrip;

constexpr double least_force = 1e-290;  // [N]

// Tractions settle to steady rolling where conditions stay: the rate over a length of the contact, and the
// factor on changes, over the largest traction, that shorten the way under the same conditions [-].
constexpr double settles = 100.0, change_counts = 400.0;

// A strip's only place in both steps is the same one within this, and half the distance rolled [m].
constexpr double same_place = 4e-3;

/// Numbers of strips that are remembered.
struct PastNumbers {
  const PastStrip* past;
  double operator[](std::int64_t k) const { return past[k].y; }
};

/// Half-spaces yield beside a patch, too: humps that have met yield together, but for a neck between them.
constexpr LobeLimits joint{0.0, 0.3, true};

struct Scratch {
  double *line_load, *load;                ///< StripsInParts
  double *shares, *number, *inside;        ///< part: friction over its mean, PatchStrips
  double *ahead_x, *ahead_y, *ahead_turn;  ///< displacements by the yield, taken ahead [m], [rad]
  double *cells_x, *cells_y, *cells_turn;  ///< the same of the cells, with their arms
  double *lever_x, *lever_y;               ///< arms less distances from the parts' middles [m]
  double *asked_x, *asked_y, *asked_spin;  ///< slips that the steady force is asked for
  double *follows, *within;                ///< share of the steady force that follows; friction's
  double* rolling;       ///< surface_rolling_workspace(), in the memory of `strips` and `written`
  patch::Strips region;  ///< part
  tangential::RememberingStrip *shared, *strips;  ///< all strips; part: PatchStrips
  const tangential::RememberingStrip** of_part;   ///< part: those of all strips
  PastStrip *written, *steady;                    ///< part; all strips in steady rolling
  const PastStrip **past, **past_of_part;         ///< those of all strips; PatchStrips
};

Scratch cut(Arena& arena, std::int32_t most) {
  Scratch s{};
  arena.each(most, s.line_load, s.load, s.shares, s.number, s.inside, s.ahead_x, s.ahead_y, s.ahead_turn,
             s.cells_x, s.cells_y, s.cells_turn, s.lever_x, s.lever_y, s.asked_x, s.asked_y, s.asked_spin,
             s.follows, s.within, s.region.y, s.region.width, s.region.centre, s.region.half_length,
             s.region.peak);
  s.region.capacity = most;
  arena.each(most, s.shared, s.of_part, s.steady, s.past, s.past_of_part);
  // steady forces are asked for when all parts are solved
  Arena asked = arena;
  s.rolling = asked.take(static_cast<std::int64_t>(surface_rolling_workspace(most)));
  arena.each(most, s.strips, s.written);
  arena.go_behind(asked);
  return s;
}

class Rememberer {
 public:
  Rememberer(const RememberingInput& in, Arena& arena, const SurfaceRollingForces& forces)
      : in_(in),
        strips_(in.strips),
        forces_(forces),
        scratch_(cut(arena, in.strips.count)),
        parts_{in.strips, in.along, scratch_.line_load, scratch_.load, joint} {
    contact_.shear_modulus = strips_.shear_modulus;
    contact_.linear_theory = &in.linear_theory;
    contact_.grid = strips_.grid;
    contact_.memory.direction = in.direction;
  }

  RememberingResult roll() {
    begin();
    for_each_part([&](const Part& part) { share_numbers(part); });
    for_each_part([&](const Part& part) { roll_part(part); });
    add_steady();
    return {fault_, finish()};
  }

 private:
  struct Part {
    std::int32_t first = 0, end = 0;
    double share = 0.0;
    bool cut_at_valley = false;
    PartMeans means;
    std::int32_t number = 0;
  };

  /// Parts that carry load and have friction. One that is alone is found once: `scratch_.load`, which has the
  /// loads of the part found last, stays its own.
  template <class Take>
  void for_each_part(Take&& take) {
    if (alone_.end > 0) return take(alone_);
    std::int32_t all = 0;  // those without load or friction, too
    Part part;
    parts_.for_each(
        [&](std::int32_t first, std::int32_t end, double share, const LobeCut* low, const LobeCut* high) {
          const PartMeans m = parts_.take_part(first, end, low, high);
          ++all;
          if (!(m.load > 0.0 && m.friction > 0.0)) return;
          part = {first, end, share, low || high, m, part.end > 0 ? part.number + 1 : 0};
          take(part);
        });
    if (all == 1) alone_ = part;
  }

  /// Calls take(j, k) for each strip j of the part, its k-th.
  template <class Take>
  void for_each_strip(const Part& part, Take&& take) const {
    std::int32_t k = 0;
    for (std::int32_t j = part.first; j < part.end; ++j)
      if (scratch_.load[j] > 0.0) take(j, k++);
  }

  /// Sums over parts begin at zero.
  void begin() {
    const std::int32_t count = strips_.count;
    for (double* const sum :
         {scratch_.ahead_x, scratch_.ahead_y, scratch_.ahead_turn, scratch_.cells_x, scratch_.cells_y,
          scratch_.cells_turn, scratch_.lever_x, scratch_.lever_y, scratch_.follows, scratch_.within})
      std::fill_n(sum, count, 0.0);
    find_past();
    for (std::int32_t j = 0; j < count; ++j) {
      PastStrip& strip = written()[j];
      strip = {};
      strip.y = in_.number[j];
      strip.centre = in_.along[j];
      strip.half_length = strips_.half_length[j];
      longest_ = std::max(longest_, 2.0 * strip.half_length);
      tangential::RememberingStrip& cells = scratch_.shared[j];
      std::fill_n(cells.bound, memory_cells, 0.0);
      cells.bounds = cells.growth_x = cells.growth_y = cells.turns = cells.arm = 0.0;
      cells.own_x = cells.own_y = cells.own_turn = 0.0;
    }
    for (std::int64_t k = 0; k < in_.past_count; ++k) energy_ += in_.past[k].energy;
    rests_ = tangential::hardly_rolls(in_.rolled, longest_);
    takes_over_ = tangential::forgotten(in_.rolled, longest_);
    from_now_ = takes_over_ == 1.0;
  }

  static std::int32_t rail_strip(double number) { return on_rail(static_cast<std::int32_t>(number)); }
  static bool is_second(double number) { return number >= second_places; }

  /// The past of each strip, by its number. Rows of places along the track (second_place.hpp) end and begin:
  /// where either step has second places, a place's past is one of the same strip of the rail, in any row.
  void find_past() {
    const std::int32_t count = strips_.count;
    const PastNumbers then{in_.past};
    std::fill_n(scratch_.past, count, nullptr);
    two_rows_ = (count > 0 && is_second(in_.number[count - 1])) ||
                (in_.past_count > 0 && is_second(then[in_.past_count - 1]));
    if (!two_rows_)
      return for_shared_strips(count, in_.number, in_.past_count, then,
                               [&](std::int32_t j, std::int64_t k) { scratch_.past[j] = in_.past + k; });
    // both rows of both steps, strip by strip of the rail
    std::int64_t j[2] = {0, 0}, k[2] = {0, 0};
    while (j[1] < count && !is_second(in_.number[j[1]])) ++j[1];
    while (k[1] < in_.past_count && !is_second(then[k[1]])) ++k[1];
    const std::int64_t j_end[2] = {j[1], count}, k_end[2] = {k[1], in_.past_count};
    while (j[0] < j_end[0] || j[1] < j_end[1]) {
      // number of the next strip with a place now, and its places of both steps
      std::int32_t strip = second_places;
      for (int r = 0; r < 2; ++r)
        if (j[r] < j_end[r]) strip = std::min(strip, rail_strip(in_.number[j[r]]));
      std::int64_t now[2], past[2];
      for (int r = 0; r < 2; ++r) {
        now[r] = j[r] < j_end[r] && rail_strip(in_.number[j[r]]) == strip ? j[r]++ : -1;
        while (k[r] < k_end[r] && rail_strip(then[k[r]]) < strip) ++k[r];
        past[r] = k[r] < k_end[r] && rail_strip(then[k[r]]) == strip ? k[r] : -1;
      }
      pair_places(now, past, heirs_[face_of(strip)]);
    }
  }

  /// How far a place is from one of the committed step [m]. Places on a ramp have gone with the wheel, those
  /// at its end have stayed on the rail: half the distance rolled lies between.
  double apart(double along, std::int64_t past) const {
    return std::abs(along - in_.direction * in_.past[past].centre + 0.5 * in_.rolled);
  }

  /// Places of a face by their row in the committed step, then by that of now.
  using Heirs = std::int32_t[2][2];

  /// The past of a strip's places in both rows, -1 where there is none: of two ways to pair them the one of
  /// less distance along the track. One place then and one now, farther apart, are two.
  void pair_places(const std::int64_t (&now)[2], const std::int64_t (&past)[2], Heirs& heirs) {
    const auto has = [&](int a, int b) { return now[a] >= 0 && past[b] >= 0; };
    const auto off = [&](int a, int b) { return has(a, b) ? apart(in_.along[now[a]], past[b]) : 0.0; };
    const double most = same_place + 0.5 * in_.rolled;
    const bool two_now = now[0] >= 0 && now[1] >= 0, two_past = past[0] >= 0 && past[1] >= 0;
    // the sum of both distances, or which is nearer to the one place of the other step
    bool crossed = !has(0, 0) && !has(1, 1);
    if (two_now && two_past)
      crossed = off(0, 1) + off(1, 0) < off(0, 0) + off(1, 1);
    else if (two_now)
      crossed = past[0] >= 0 ? off(1, 0) < off(0, 0) : off(0, 1) < off(1, 1);
    else if (two_past)
      crossed = now[0] >= 0 ? off(0, 1) < off(0, 0) : off(1, 0) < off(1, 1);
    for (int a = 0; a < 2; ++a) {
      const int b = crossed ? 1 - a : a;
      if (!has(a, b) || (!two_now && !two_past && off(a, b) > most)) continue;
      scratch_.past[now[a]] = in_.past + past[b];
      ++heirs[b][a];
    }
  }

  /// The row that a row of the committed step is now, by most of its places; -1: all have left, and other
  /// places are in that row. Strips that left belong to it. Faces renumber their rows by themselves.
  static int row_now(int row, const Heirs& heirs) {
    const int other = 1 - row;
    if (heirs[row][0] + heirs[row][1] == 0) return heirs[other][row] > 0 ? -1 : row;
    return heirs[row][other] > heirs[row][row] ? other : row;
  }

  /// Number of the face that a strip of the rail belongs to.
  std::int32_t face_of(std::int32_t strip) const {
    std::int32_t face = 0;
    while (face + 1 < in_.rail.ranges && strip >= in_.rail.range[face].first + in_.rail.range[face].count)
      ++face;
    return face;
  }

  /// The strip in contact that a strip of the committed step is the past of, or -1. `from`: the first one
  /// with its number or a larger one.
  std::int32_t heir_of(std::int64_t k, std::int32_t from) const {
    const double number = in_.past[k].y;
    if (!two_rows_) return from < strips_.count && in_.number[from] == number ? from : -1;
    // a place may have changed its row
    for (const std::int32_t row : {0, second_places}) {
      const double *const end = in_.number + strips_.count, *const at = std::lower_bound(
                                                                in_.number, end,
                                                                1.0 * (rail_strip(number) + row));
      if (at != end && scratch_.past[at - in_.number] == in_.past + k)
        return static_cast<std::int32_t>(at - in_.number);
    }
    return -1;
  }

  /// Friction limit of a strip [N].
  double limit_of(std::int32_t j) const {
    return strips_.friction[j] * (0.5 * pi) * strips_.peak[j] * strips_.half_length[j] * strips_.width[j];
  }

  /// Largest force that the cells of a strip bear, whose bounds have another form than its pressure [N].
  double borne_by_cells(std::int32_t j) const {
    return scratch_.shared[j].bounds * (strips_.width[j] * strips_.half_length[j] * (2.0 / memory_cells));
  }

  /// Share of a strip's width within the part taken last.
  double inside(std::int32_t j) const { return parts_.width_inside(j) / strips_.width[j]; }

  /// Forces beside a part, on its face, that strips no longer bear. At a distance r beyond the half width b a
  /// force displaces the half-space as b / r, and turns it as (b / r)^2.
  tangential::LeftStrips left_beside(const Part& part) const {
    // b^2: twice that of the ellipse with the load's second moment, so no strip of the part lies beyond [m^2]
    double square = 0.0;
    for (std::int32_t j = part.first; j < part.end; ++j) {
      const double y = strips_.place[j] - part.means.place, own = strips_.width[j];
      square += 10.0 * (scratch_.load[j] / part.means.load) * (y * y + own * own / 12.0);
    }
    tangential::LeftStrips left;
    const std::int32_t number = face_of(rail_strip(in_.number[part.first]));
    const FaceStrips& face = in_.rail.range[number];
    const int row = is_second(in_.number[part.first]) ? 1 : 0;
    const int row_of[2] = {row_now(0, heirs_[number]), row_now(1, heirs_[number])};
    std::int32_t from = 0;  // the first strip in contact with that number or a larger one
    for (std::int64_t k = 0; k < in_.past_count; ++k) {
      const PastStrip& strip = in_.past[k];
      const std::int32_t of_rail = rail_strip(strip.y);
      if (!face.has(of_rail)) continue;
      while (from < strips_.count && in_.number[from] < strip.y) ++from;
      double lost = 1.0;
      if (const std::int32_t j = heir_of(k, from); j >= 0) {
        if (is_second(in_.number[j]) != (row > 0)) continue;
        // share of the force outside the part, and beyond the bounds of the strip's cells
        lost = j >= part.first && j < part.end ? 1.0 - inside(j) : 1.0;
        if (!(lost > 0.0)) continue;
        const double had = std::sqrt(strip.force[0] * strip.force[0] + strip.force[1] * strip.force[1]);
        lost *= 1.0 - std::min(1.0, borne_by_cells(j) / std::max(had, least_force));
      } else if (row_of[is_second(strip.y) ? 1 : 0] != row) {
        continue;
      }
      const double y = row_place(in_.rail, of_rail + row * second_places) - part.means.place;
      const double near = y * y > square ? std::sqrt(square / (y * y)) : 1.0;
      const double fx = lost * near * in_.direction * strip.force[0], fy = lost * near * strip.force[1];
      left.fx += fx;
      left.fy += fy;
      left.mz += lost * near * in_.direction * strip.force[2];
      left.turn += near * near * (in_.direction * strip.centre * fy - y * fx);
    }
    return left;
  }

  /// The part as a patch, in `contact_`.
  void fill_region(const Part& part) {
    if (part.number == filled_) return;
    filled_ = part.number;
    const PartMeans& m = part.means;
    patch::Strips& region = scratch_.region;
    region.count = 0;
    for_each_strip(part, [&](std::int32_t j, std::int32_t k) {
      region.y[k] = strips_.place[j] - m.place;
      region.width[k] = parts_.width_inside(j);
      region.centre[k] = in_.along[j];
      region.half_length[k] = strips_.half_length[j];
      region.peak[k] = strips_.peak[j];
      scratch_.shares[k] = strips_.friction[j] / m.friction;
      scratch_.number[k] = in_.number[j];
      scratch_.past_of_part[k] = scratch_.past[j];
      scratch_.inside[k] = region.width[k] / strips_.width[j];
      scratch_.of_part[k] = scratch_.shared + j;
      region.count = k + 1;
    });
    contact_.region = region;
    contact_.friction = {m.friction, scratch_.shares};
  }

  /// Numbers of the part, which is the one in `contact_`. The first ones' are kept.
  const tangential::PatchNumbers& numbers_of(const Part& part) {
    // those behind share the last place, and are found at each call
    constexpr std::int32_t last = kept_parts - 1;
    tangential::PatchNumbers& numbers = numbers_[std::min(part.number, last)];
    if (part.number >= numbered_ || part.number >= last)
      numbers = tangential::patch_numbers(contact_, fault_);
    numbered_ = std::max(numbered_, part.number + 1);
    return numbers;
  }

  /// Does a part, the one in `contact_`, have all of all strips? Then theirs are written in place.
  bool is_whole(const Part& part) const {
    return part.share == 1.0 && !part.cut_at_valley && contact_.region.count == strips_.count;
  }

  /// The part's step, before it. One that is alone begins once.
  tangential::PatchStep& begin_part(const Part& part) {
    if (patch_ && part.number == filled_) return *patch_;
    fill_region(part);
    patch_.emplace(contact_,
                   tangential::PatchStrips{in_.past, in_.past_count,
                                           is_whole(part) ? written() : scratch_.written, scratch_.strips,
                                           scratch_.number, scratch_.past_of_part, scratch_.inside, longest_},
                   numbers_of(part));
    return *patch_;
  }

  /// Adds a part's bounds, growths and displacements to those of its strips, by its share. Strips of two
  /// partitions then roll alike in both, but for the yield.
  void share_numbers(const Part& part) {
    tangential::PatchStep& patch = begin_part(part);
    patch.set_bounds();
    const tangential::PatchNumbers& numbers = numbers_of(part);
    const tangential::Creepage& c = part.means.creepage;
    const double arm = numbers.arm, follows = patch.follows(in_.rolled);
    for_each_strip(part, [&](std::int32_t j, std::int32_t k) {
      const double weight = part.share * scratch_.inside[k];
      const tangential::RememberingStrip& from = scratch_.strips[k];
      tangential::RememberingStrip& to = scratch_.shared[j];
      tangential::add_cells(weight, from.bound, to.bound);
      to.bounds += weight * from.bounds;
      to.growth_x += weight * from.growth_x;
      to.growth_y += weight * from.growth_y;
      to.turns += weight * from.turns;
      to.arm += weight * arm;
      // slips of the strip; beside the part's mean along x, and by spin, with the factor on arms
      const double x = in_.along[j] - numbers.centre_x, y = contact_.region.y[k];
      to.own_x += weight * (c.longitudinal + arm * (strips_.slip_x[j] - c.longitudinal));
      to.own_y += weight * (strips_.slip_y[j] + (arm - 1.0) * c.spin * x);
      to.own_turn = strips_.spin[j];
      scratch_.lever_x[j] += weight * (arm - 1.0) * x;
      scratch_.lever_y[j] += weight * (arm - 1.0) * y;
      scratch_.follows[j] += weight * follows;
    });
  }

  /// Solves the step of one part, and adds its strips, by its share, to those of the contact.
  void roll_part(const Part& part) {
    if (from_now_) return;
    tangential::PatchStep& patch = begin_part(part);
    patch.take_shared(scratch_.of_part, left_beside(part));
    const tangential::PatchNumbers& numbers = numbers_of(part);
    // how much further than the bodies it takes the steady force, over the step
    constexpr double none[3] = {};
    double local[3], of_part[3], last = 0.0;
    patch.go(none, in_.travel, rests_ ? 0.0 : in_.rolled, local, of_part, last);
    const double factor = tangential::fitted_memory.ahead * (rests_ ? 0.0 : in_.rolled / last);
    const double ahead[3] = {factor * local[0], factor * local[1], factor * local[2]}, arm = numbers.arm;
    last_ = last;
    if (takes_over_ == 0.0) stored_ += part.share * patch.stored();
    const bool whole = is_whole(part);
    for_each_strip(part, [&](std::int32_t j, std::int32_t k) {
      const double weight = part.share * scratch_.inside[k];
      PastStrip& to = written()[j];
      const PastStrip& from = whole ? to : scratch_.written[k];
      const double fx = from.force[0], fy = from.force[1], mz = from.force[2];
      if (whole) {
        std::fill_n(to.force, 3, 0.0);
      } else {
        tangential::add_cells(weight, from.px, to.px);
        tangential::add_cells(weight, from.py, to.py);
      }
      // moments about the strip's own middle
      const double x = in_.along[j] - numbers.centre_x, y = contact_.region.y[k] - numbers.centre_y;
      to.force[0] += part.share * fx;
      to.force[1] += part.share * fy;
      to.force[2] += part.share * (mz - arm * (x * fy - y * fx)) * (scratch_.shared[j].arm / arm);
      scratch_.ahead_x[j] += weight * (ahead[0] - ahead[2] * y);
      scratch_.ahead_y[j] += weight * (ahead[1] + ahead[2] * x);
      scratch_.ahead_turn[j] += weight * ahead[2];
      scratch_.cells_x[j] += weight * (ahead[0] - ahead[2] * arm * y);
      scratch_.cells_y[j] += weight * (ahead[1] + ahead[2] * arm * x);
      scratch_.cells_turn[j] += weight * ahead[2] * (arm / scratch_.shared[j].arm);
    });
  }

  /// Way of a strip under the same conditions before this step, over the contact's length [-].
  double way_before(std::int32_t j) const {
    const PastStrip* const past = scratch_.past[j];
    return past ? std::max(0.0, in_.direction * past->way) : 0.0;
  }

  /// Share of steady rolling in the way under the same conditions, as long as it will be in the next step.
  double settled(double before) const {
    const double step = in_.rolled / longest_;
    return tangential::forgotten(before + step + std::min(step, 0.5 * before), 1.0);
  }

  /// Slips at which the steady forces of the strips are asked, those of the bodies and of the yield, and the
  /// cells in steady rolling at the same.
  void march_cells() {
    for (std::int32_t j = 0; j < strips_.count; ++j) {
      // changes in this step do not count: the force has no steep place where conditions begin to change
      const double ahead = 1.0 - settled(way_before(j));
      const double x = in_.travel * strips_.slip_x[j] + ahead * scratch_.ahead_x[j];
      const double y = in_.travel * strips_.slip_y[j] + ahead * scratch_.ahead_y[j];
      const double turn = in_.travel * strips_.spin[j] + ahead * scratch_.ahead_turn[j];
      const double size = std::max({std::abs(x), std::abs(y), std::abs(turn) * strips_.half_length[j]});
      const double per = tangential::PatchStep::per_length(size, in_.rolled);
      scratch_.asked_x[j] = per * x;
      scratch_.asked_y[j] = per * y;
      scratch_.asked_spin[j] = per * turn;
      // seen from the strip's own middle
      tangential::RememberingStrip& cells = scratch_.shared[j];
      cells.centre = in_.along[j];
      cells.half_length = strips_.half_length[j];
      cells.area = strips_.width[j] * cells.half_length * (2.0 / memory_cells);
      cells.x = cells.y = 0.0;
      cells.reach = cells.arm * cells.half_length;
      cells.own_x = per * (in_.travel * cells.own_x + ahead * scratch_.cells_x[j]);
      cells.own_y = per * (in_.travel * cells.own_y + ahead * scratch_.cells_y[j]);
      cells.own_turn = per * (in_.travel * cells.own_turn + ahead * scratch_.cells_turn[j]);
    }
    constexpr double none[3] = {};
    const double h = from_now_ ? tangential::last_part(longest_) : last_;
    tangential::march_steadily(contact_, scratch_.shared, strips_.count, none, h, scratch_.steady);
  }

  /// Moment of a strip's cells about its own middle as the host adds it to that of its force [N m].
  double moment_of(std::int32_t j, const double (&force)[3]) const {
    return force[2] + scratch_.lever_x[j] * force[1] - scratch_.lever_y[j] * force[0];
  }

  /// Forces of the strips: cells and the difference to the steady force, which follows; within friction.
  void add_steady() {
    if (!rests_) {
      march_cells();
      SurfaceRollingInput asked = strips_;
      if (!(from_now_ && in_.travel == in_.rolled)) {
        asked.slip_x = scratch_.asked_x;
        asked.slip_y = scratch_.asked_y;
        asked.spin = scratch_.asked_spin;
      }
      roll_on_surface(asked, scratch_.rolling, {}, forces_);
    }
    if (takes_over_ > 0.0) take_steady_cells();
    for (std::int32_t j = 0; j < strips_.count; ++j) {
      PastStrip& strip = written()[j];
      const double of_cells[3] = {strip.force[0], strip.force[1], moment_of(j, strip.force)};
      const auto& steady = scratch_.steady[j].force;
      const double of_steady_cells[3] = {steady[0], steady[1], moment_of(j, steady)};
      const PastStrip* const past = scratch_.past[j];
      // a strip about to leave keeps no more of it than its friction
      const double kept =
          past ? std::sqrt(past->added[0] * past->added[0] + past->added[1] * past->added[1]) : 0.0;
      const double held = std::min(1.0, limit_of(j) / std::max(kept, least_force));
      double* const force[3] = {forces_.fx + j, forces_.fy + j, forces_.mz + j};
      for (int i = 0; i < 3; ++i) {
        double& added = strip.added[i];
        double& steadily = scratch_.steady[j].added[i];
        steadily = *force[i] - of_steady_cells[i];
        added = past ? (held * (i == 1 ? 1.0 : in_.direction)) * past->added[i] : 0.0;
        if (!rests_) added += scratch_.follows[j] * (steadily - added);
        if (from_now_) continue;  // the steady force itself
        *force[i] = of_cells[i] + added;
      }
    }
    if (!from_now_) stay_within_friction();
  }

  /// Little or nothing before the step is seen: the cells tend to those of steady rolling.
  void take_steady_cells() {
    for (std::int32_t j = 0; j < strips_.count; ++j)
      tangential::tend_to(scratch_.steady[j], takes_over_, written()[j]);
    for_each_part([&](const Part& part) {
      // energy of the cells and of the half-spaces, whose moment is about the part's centre
      fill_region(part);
      const tangential::PatchNumbers& numbers = numbers_of(part);
      double force[3] = {}, stored = 0.0;
      for_each_strip(part, [&](std::int32_t j, std::int32_t k) {
        const PastStrip& strip = written()[j];
        const tangential::RememberingStrip& cells = scratch_.shared[j];
        const double x = in_.along[j] - numbers.centre_x, y = contact_.region.y[k] - numbers.centre_y;
        const double turn = strip.force[2] / cells.arm + (x * strip.force[1] - y * strip.force[0]);
        force[0] += scratch_.inside[k] * strip.force[0];
        force[1] += scratch_.inside[k] * strip.force[1];
        force[2] += scratch_.inside[k] * numbers.arm * turn;
        const double area = contact_.region.width[k] * strips_.half_length[j] * (2.0 / memory_cells);
        stored += tangential::stored_in(strip, area, cells.growth_x, cells.growth_y);
      });
      stored_ += part.share * (stored + tangential::stored_by(numbers.yield, force));
    });
  }

  /// Lowers the forces of each part to its friction limit.
  void stay_within_friction() {
    for_each_part([&](const Part& part) {
      fill_region(part);
      double fx = 0.0, fy = 0.0;
      for_each_strip(part, [&](std::int32_t j, std::int32_t k) {
        fx += scratch_.inside[k] * forces_.fx[j];
        fy += scratch_.inside[k] * forces_.fy[j];
      });
      const double size = std::max(std::sqrt(fx * fx + fy * fy), least_force);
      const double within = std::min(1.0, part.means.friction * part.means.load / size);
      for_each_strip(part, [&](std::int32_t j, std::int32_t k) {
        scratch_.within[j] += part.share * scratch_.inside[k] * within;
      });
    });
    for (std::int32_t j = 0; j < strips_.count; ++j) {
      forces_.fx[j] *= scratch_.within[j];
      forces_.fy[j] *= scratch_.within[j];
    }
  }

  /// Change of a strip's conditions since the committed step: tractions by its slips over the largest, bound
  /// and outline [-].
  double change_of(std::int32_t j) const {
    const PastStrip &strip = written()[j], &past = *scratch_.past[j];
    const tangential::RememberingStrip& cells = scratch_.shared[j];
    const double length = 2.0 * strip.half_length,
                 stiff[3] = {cells.growth_x * length, cells.growth_y * length,
                             cells.growth_y * length * strip.half_length};
    double change = 0.0, size = cells.bound[memory_cells / 2];
    for (int i = 0; i < 3; ++i) {
      change += stiff[i] * std::abs(strip.slip[i] - past.slip[i]);
      size += stiff[i] * std::abs(strip.slip[i]);
    }
    const double bound = cells.bound[memory_cells / 2], had = past.bound[memory_cells / 2 - 1];
    return change / std::max(size, least_force) +
           std::abs(bound - had) / std::max({bound, had, least_force}) +
           (std::abs(strip.half_length - past.half_length) +
            std::abs(strip.centre - in_.direction * past.centre)) /
               strip.half_length;
  }

  /// Under conditions that stay, tractions settle to those of steady rolling. The next step begins from them;
  /// this one's forces stay, so trials are as smooth as ever.
  void settle(std::int32_t j) {
    PastStrip& strip = written()[j];
    const double step = in_.rolled / longest_, per = in_.travel / in_.rolled;
    strip.slip[0] = per * strips_.slip_x[j];
    strip.slip[1] = per * strips_.slip_y[j];
    strip.slip[2] = per * strips_.spin[j];
    double before = way_before(j);
    if (before > 0.0) before /= 1.0 + change_counts * change_of(j);
    strip.way = std::min(before + step, tangential::all_forgotten);
    const double rate = settles * step * settled(before), share = rate / (1.0 + rate);
    if (!(share > 0.0)) return;
    const PastStrip& steady = scratch_.steady[j];
    tangential::tend_to(steady, share, strip);
    for (int i = 0; i < 3; ++i) strip.added[i] += share * (steady.added[i] - strip.added[i]);
  }

  /// Counts the energy, lowers forces to it, and completes the strips written. Returns the dissipated work
  /// [J].
  double finish() {
    const std::int32_t count = strips_.count;
    double work = 0.0;
    for (std::int32_t j = 0; j < count; ++j)
      work -= in_.travel * work_by_slips(forces_, strips_.slip_x, strips_.slip_y, strips_.spin, j);
    const tangential::EnergyLeft energy = tangential::count_energy(energy_, work, stored_);
    for (std::int32_t j = 0; j < count; ++j) {
      PastStrip& strip = written()[j];
      strip.added[0] = forces_.fx[j] - strip.force[0];
      strip.added[1] = forces_.fy[j] - strip.force[1];
      strip.added[2] = forces_.mz[j] - moment_of(j, strip.force);
      if (!rests_) settle(j);
      if (energy.scale < 1.0) {
        for (double* const f : {forces_.fx, forces_.fy, forces_.mz}) f[j] *= energy.scale;
        tangential::lower(energy.scale, strip);
        for (double& f : strip.added) f *= energy.scale;
      }
      if (scratch_.shared[j].arm > 0.0) strip.force[2] /= scratch_.shared[j].arm;
      strip.energy = energy.left / count;
      std::copy_n(scratch_.shared[j].bound, std::size(strip.bound), strip.bound);
      if (in_.direction < 0.0) strip = tangential::turned(strip, in_.direction);
    }
    return energy.dissipated;
  }

  PastStrip* written() const { return in_.written; }

  const RememberingInput& in_;
  const SurfaceRollingInput& strips_;
  const SurfaceRollingForces& forces_;
  Scratch scratch_;
  StripsInParts parts_;
  tangential::RollingContact contact_;
  static constexpr std::int32_t kept_parts = 8;
  tangential::PatchNumbers numbers_[kept_parts];
  std::int32_t numbered_ = 0;                   // parts that have had their numbers
  std::int32_t filled_ = -1;                    // the part in contact_
  Part alone_;                                  // end > 0: the only one
  std::optional<tangential::PatchStep> patch_;  // that of the part in contact_
  double longest_ = 0.0;                        // strip [m]
  double last_ = 0.0;                           // length of the step's last part [m]
  double energy_ = 0.0;                         // could be given back before the step [J]
  double stored_ = 0.0;                         // in the tractions of its end [J]
  double takes_over_ = 0.0;                     // share of steady rolling in it [-]
  bool rests_ = false, from_now_ = false;
  bool two_rows_ = false;              // has either step second places along the track?
  Heirs heirs_[most_rail_faces] = {};  // with two rows
  Fault fault_;
};

}  // namespace

void count_remembering(Arena& arena, std::int32_t most) { cut(arena, most); }

RememberingResult roll_remembering(const RememberingInput& in, Arena arena,
                                   const SurfaceRollingForces& forces) noexcept {
  return Rememberer(in, arena, forces).roll();
}

}  // namespace wrc::surface
