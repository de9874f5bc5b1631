#include "surface/rolling/remembering.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "surface/rolling/strip_heirs.hpp"
#include "surface/rolling/strip_parts.hpp"

namespace wrc::surface {
namespace {

using tangential::memory_cells;
using tangential::PastStrip;

constexpr double least_force = 1e-290;  // [N]

// Tractions settle to steady rolling where conditions stay: the rate over a length of the contact, and the
// factor on changes, over the largest traction, that shorten the way under the same conditions [-].
constexpr double settles = 100.0, change_counts = 400.0;

// Half length of a strip without any, which carries nothing [m].
constexpr double shortest = 1e-12;

/// Half-spaces yield beside a patch, too: humps that have met yield together, but for a neck between them.
constexpr LobeLimits joint{0.0, 0.3, true};

/// A run of strips side by side, whose patches yield together.
struct Run {
  std::int32_t first, end;  ///< strips
  std::int32_t first_patch, end_patch;
};

/// A strip of the committed step, that of now whose past it is, or -1, and the share of its force that is
/// lost.
struct LostForce {
  std::int64_t past;
  std::int32_t heir;
  double share;
};

/// Where a patch lies.
struct PatchPlace {
  double at;      ///< middle of its load, arc length [m]
  double square;  ///< square of a half width beyond which strips lie beside the patch [m^2]
};

static_assert(tangential::PatchStep::most_lobes == LobeCuts::capacity + 1);

/// Patches of so many strips: each run has one, and more where valleys divide it. Of runs there are no more
/// than strips.
constexpr std::int32_t patches_of(std::int32_t strips) { return 2 * strips + 36; }

struct Scratch {
  double *line_load, *y;                   ///< StripsInParts; places from the middle of a patch's load [m]
  double *ahead_x, *ahead_y, *ahead_turn;  ///< displacements by the yield, taken ahead [m], [rad]
  double *cells_x, *cells_y, *cells_turn;  ///< the same of the cells, with their arms
  double *lever_x, *lever_y;               ///< arms less distances from the patches' middles [m]
  double *asked_x, *asked_y, *asked_spin;  ///< slips that the steady force is asked for
  double *follows, *within;                ///< share of the steady force that follows; friction's
  double* rolling;                         ///< surface_rolling_workspace()
  patch::Strips region;                    ///< all strips
  tangential::RememberingStrip* strips;
  PastStrip* steady;       ///< strips in steady rolling
  const PastStrip** past;  ///< those of the strips
  Run* runs;
  tangential::YieldingPatch* patches;
  PatchPlace* places;  ///< those of the patches
  LostForce* lost;
};

Scratch cut(Arena& arena, std::int32_t most, std::int64_t past) {
  Scratch s{};
  arena.each(most, s.line_load, s.y, s.ahead_x, s.ahead_y, s.ahead_turn, s.cells_x, s.cells_y, s.cells_turn,
             s.lever_x, s.lever_y, s.asked_x, s.asked_y, s.asked_spin, s.follows, s.within, s.region.y,
             s.region.width, s.region.centre, s.region.half_length, s.region.peak);
  s.region.capacity = most;
  arena.each(most, s.strips, s.steady, s.past, s.runs);
  arena.each(past, s.lost);
  arena.each(patches_of(most), s.patches, s.places);
  s.rolling = arena.take(static_cast<std::int64_t>(surface_rolling_workspace(most)));
  return s;
}

class Rememberer {
 public:
  Rememberer(const RememberingInput& in, Arena& arena, const SurfaceRollingForces& forces)
      : in_(in),
        strips_(in.strips),
        forces_(forces),
        scratch_(cut(arena, in.strips.count, in.past_count)),
        heirs_(in, scratch_.past),
        parts_{in.strips, in.along, scratch_.line_load, nullptr, joint} {
    contact_.shear_modulus = strips_.shear_modulus;
    contact_.linear_theory = &in.linear_theory;
    contact_.grid = strips_.grid;
    contact_.memory.direction = in.direction;
  }

  RememberingResult roll() {
    begin();
    find_patches();
    if (from_now_) {
      for (std::int32_t j = 0; j < strips_.count; ++j) tangential::complete_bounds(scratch_.strips[j]);
    } else {
      find_lost();
      for (std::int32_t k = 0; k < runs_; ++k) roll_run(scratch_.runs[k]);
    }
    add_steady();
    return {fault_, finish()};
  }

 private:
  using Patch = tangential::YieldingPatch;

  /// Calls take(j, weight) for each strip j of the patch, with its share times that of the width within.
  template <class Take>
  static void for_each_strip(const Patch& patch, Take&& take) {
    for (std::int32_t j = patch.first; j < patch.end; ++j) take(j, patch.share * patch.inside(j));
  }

  /// Sums over patches begin at zero.
  void begin() {
    const std::int32_t count = strips_.count;
    for (double* const sum :
         {scratch_.ahead_x, scratch_.ahead_y, scratch_.ahead_turn, scratch_.cells_x, scratch_.cells_y,
          scratch_.cells_turn, scratch_.lever_x, scratch_.lever_y, scratch_.follows, scratch_.within})
      std::fill_n(sum, count, 0.0);
    heirs_.find();
    for (std::int32_t j = 0; j < count; ++j) {
      PastStrip& strip = written()[j];
      strip.y = in_.number[j];
      std::fill_n(strip.slip, 3, 0.0);
      strip.way = 0.0;
      strip.centre = in_.along[j];
      strip.half_length = strips_.half_length[j];
      longest_ = std::max(longest_, 2.0 * strip.half_length);
      tangential::clear_strip(scratch_.strips[j]);
      scratch_.region.y[j] = strips_.place[j];
      scratch_.region.width[j] = strips_.width[j];
      scratch_.region.centre[j] = in_.along[j];
      scratch_.region.half_length[j] = std::max(strips_.half_length[j], shortest);
      scratch_.region.peak[j] = strips_.peak[j];
    }
    for (std::int64_t k = 0; k < in_.past_count; ++k) energy_ += in_.past[k].energy;
    rests_ = tangential::hardly_rolls(in_.rolled, longest_);
    step_ = in_.rolled / std::max(longest_, tangential::least_divisor);
    takes_over_ = tangential::forgotten(step_);
    from_now_ = takes_over_ == 1.0;
    if (from_now_) clear_cells(0, count);
  }

  /// No tractions of strips that are not rolled.
  void clear_cells(std::int32_t first, std::int32_t end) const {
    for (std::int32_t j = first; j < end; ++j) {
      PastStrip& strip = written()[j];
      std::fill_n(strip.force, 3, 0.0);
      std::fill_n(strip.px, memory_cells, 0.0);
      std::fill_n(strip.py, memory_cells, 0.0);
    }
  }

  /// Friction limit of a strip [N].
  double limit_of(std::int32_t j) const {
    return strips_.friction[j] * (0.5 * pi) * strips_.peak[j] * strips_.half_length[j] * strips_.width[j];
  }

  /// Largest force that the cells of a strip bear, whose bounds have another form than its pressure [N].
  double borne_by_cells(std::int32_t j) const {
    return scratch_.strips[j].bounds * (strips_.width[j] * strips_.half_length[j] * (2.0 / memory_cells));
  }

  /// The strips of a run or patch, in `contact_`.
  void take_region(std::int32_t first, std::int32_t end, double* y) {
    const patch::Strips& all = scratch_.region;
    contact_.region = {all.capacity,      end - first,        y,
                       all.width + first, all.centre + first, all.half_length + first,
                       all.peak + first};
    contact_.friction = {1.0, strips_.friction + first};
  }

  /// Finds runs and patches, and the numbers of their strips.
  void find_patches() {
    std::int32_t patches = 0;
    parts_.for_each_run([&](std::int32_t first, std::int32_t end, LobeCuts cuts) {
      // patches that all have their place, whatever runs are still to come
      const std::int32_t most = ((cuts.count + 1) * (cuts.count + 2)) / 2, behind = strips_.count - end;
      if (patches + most + behind > patches_of(strips_.count)) cuts.count = 0;
      const std::int32_t from = patches;
      for_each_part(cuts, [&](double share, const LobeCut* low, const LobeCut* high) {
        Patch& patch = scratch_.patches[patches] = {};
        patch.share = share;
        const auto lobe = [&](const LobeCut* cut) {
          return static_cast<std::int32_t>(cut - cuts.of.data()) + 1;
        };
        patch.first_lobe = low ? lobe(low) : 0;
        patch.end_lobe = high ? lobe(high) : cuts.count + 1;
        take_strips(first, end, low, high, patch);
        add_patch(patch, scratch_.places[patches] = {});
        ++patches;
      });
      bool carries = false;
      for (std::int32_t k = from; k < patches; ++k)
        carries = carries || scratch_.patches[k].numbers.limit > 0.0;
      // without load or friction nothing is remembered
      if (carries) {
        scratch_.runs[runs_++] = {first, end, from, patches};
      } else {
        patches = from;
        clear_cells(first, end);
      }
    });
    patches_ = patches;
  }

  /// Strips of the run between the cuts.
  void take_strips(std::int32_t first, std::int32_t end, const LobeCut* low, const LobeCut* high,
                   Patch& patch) const {
    const auto border = [&](std::int32_t j, double side) {
      return strips_.place[j] + side * strips_.width[j];
    };
    if (low)
      while (first < end - 1 && !(border(first, 0.5) > low->place)) ++first;
    if (high)
      while (end - 1 > first && !(border(end - 1, -0.5) < high->place)) --end;
    patch.first = first;
    patch.end = end;
    if (low)
      patch.inside_first = std::clamp((border(first, 0.5) - low->place) / strips_.width[first], 0.0, 1.0);
    if (high)
      patch.inside_last =
          std::clamp((high->place - border(end - 1, -0.5)) / strips_.width[end - 1], 0.0, 1.0);
  }

  /// Numbers of a patch, which it adds to those of its strips. Strips of several patches have means by
  /// shares.
  void add_patch(Patch& patch, PatchPlace& place) {
    // means over the load within
    double load = 0.0, at = 0.0, slip_x = 0.0, spin = 0.0;
    for (std::int32_t j = patch.first; j < patch.end; ++j) {
      const double own = patch.inside(j) * strips_.width[j] * scratch_.line_load[j];
      load += own;
      at += own * strips_.place[j];
      slip_x += own * strips_.slip_x[j];
      spin += own * strips_.spin[j];
    }
    if (!(load > 0.0)) return;
    place.at = at /= load;
    slip_x /= load;
    spin /= load;
    // twice the square of the half width of the ellipse with the load's second moment
    double square = 0.0;
    for (std::int32_t j = patch.first; j < patch.end; ++j) {
      const double own = patch.inside(j) * strips_.width[j] * scratch_.line_load[j];
      const double y = scratch_.y[j] = strips_.place[j] - at;
      square += own * (y * y + strips_.width[j] * strips_.width[j] / 12.0);
    }
    place.square = 10.0 * square / load;
    // the patch as a region of its own, with the widths within
    take_region(patch.first, patch.end, scratch_.y + patch.first);
    double* const width = scratch_.region.width;
    for (const std::int32_t j : {patch.first, patch.end - 1}) width[j] = patch.inside(j) * strips_.width[j];
    patch.numbers = tangential::patch_numbers(contact_, fault_);
    patch.numbers.centre_y += at;
    for (std::int32_t j = patch.first; j < patch.end; ++j)
      if (scratch_.past[j]) add_past(patch.inside(j), *scratch_.past[j], j, patch, patch.before);
    tangential::add_to_strips(contact_, patch, tangential::fitted_memory, scratch_.strips + patch.first);
    for (const std::int32_t j : {patch.first, patch.end - 1}) width[j] = strips_.width[j];
    // Slips of the strips; beside the patch's mean along x, and by spin, with the factor on arms
    const double arm = patch.numbers.arm, follows = tangential::follows(patch.numbers, in_.rolled);
    for_each_strip(patch, [&](std::int32_t j, double weight) {
      tangential::RememberingStrip& to = scratch_.strips[j];
      const double x = in_.along[j] - patch.numbers.centre_x;
      to.own_x += weight * (slip_x + arm * (strips_.slip_x[j] - slip_x));
      to.own_y += weight * (strips_.slip_y[j] + (arm - 1.0) * spin * x);
      to.own_turn += weight * (arm * strips_.spin[j]);
      scratch_.lever_x[j] += weight * (arm - 1.0) * x;
      scratch_.lever_y[j] += weight * (arm - 1.0) * scratch_.y[j];
      scratch_.follows[j] += weight * follows;
    });
  }

  /// Adds a part of the force of a strip's past to that of a patch.
  void add_past(double part, const PastStrip& past, std::int32_t j, const Patch& patch, double to[3]) const {
    const double force[3] = {in_.direction * past.force[0], past.force[1], in_.direction * past.force[2]};
    patch.add_force(part, force, in_.direction * past.centre, strips_.place[j], to);
  }

  /// Strips of the committed step whose forces, or parts of them, no strip bears any more.
  void find_lost() {
    std::int32_t from = 0;  // the first strip in contact with that number or a larger one
    for (std::int64_t k = 0; k < in_.past_count; ++k) {
      const PastStrip& strip = in_.past[k];
      while (from < strips_.count && in_.number[from] < strip.y) ++from;
      const std::int32_t heir = heirs_.heir_of(k, from);
      double share = 1.0;
      if (heir >= 0) {
        // the bounds of its cells do not bear the rest
        const double had2 = strip.force[0] * strip.force[0] + strip.force[1] * strip.force[1],
                     borne = borne_by_cells(heir);
        if (borne * borne >= had2) continue;
        share -= borne / std::sqrt(had2);
      }
      scratch_.lost[lost_++] = {k, heir, share};
    }
  }

  /// Forces beside a patch, on its face, that strips no longer bear. At a distance r beyond the half width b
  /// a force displaces the half-space as b / r, and turns it as (b / r)^2.
  void find_left(Patch& patch, const PatchPlace& place) const {
    const std::int32_t number = heirs_.face_of(StripHeirs::rail_strip(in_.number[patch.first]));
    const FaceStrips& face = in_.rail.range[number];
    const int row = StripHeirs::is_second(in_.number[patch.first]) ? 1 : 0;
    const int row_of[2] = {heirs_.row_now(0, number), heirs_.row_now(1, number)};
    double turn = 0.0;  // moment from the patch's place [N m]
    for (std::int64_t k = 0; k < lost_; ++k) {
      const LostForce& of = scratch_.lost[k];
      const PastStrip& strip = in_.past[of.past];
      const std::int32_t of_rail = StripHeirs::rail_strip(strip.y);
      if (!face.has(of_rail)) continue;
      const int row_then = StripHeirs::is_second(strip.y) ? 1 : 0;
      if ((of.heir < 0 ? row_of[row_then] : (StripHeirs::is_second(in_.number[of.heir]) ? 1 : 0)) != row)
        continue;
      // the share outside the patch
      double lost = of.share;
      if (of.heir >= patch.first && of.heir < patch.end) lost *= 1.0 - patch.inside(of.heir);
      if (!(lost > 0.0)) continue;
      const double y = row_place(in_.rail, of_rail + row * second_places) - place.at;
      const double near = y * y > place.square ? std::sqrt(place.square / (y * y)) : 1.0;
      const double fx = lost * near * in_.direction * strip.force[0], fy = lost * near * strip.force[1];
      patch.left[0] += fx;
      patch.left[1] += fy;
      turn += lost * near * in_.direction * strip.force[2] +
              near * near * (in_.direction * strip.centre * fy - y * fx);
    }
    patch.left[2] = patch.numbers.arm * (turn - patch.numbers.centre_x * patch.left[1] +
                                         (patch.numbers.centre_y - place.at) * patch.left[0]);
  }

  /// Solves the step of a run.
  void roll_run(const Run& run) {
    Patch* const patches = scratch_.patches + run.first_patch;
    const std::int32_t count = run.end_patch - run.first_patch;
    for (std::int32_t k = 0; k < count; ++k) find_left(patches[k], scratch_.places[run.first_patch + k]);
    take_region(run.first, run.end, scratch_.region.y + run.first);
    tangential::PatchStep step(contact_,
                               {in_.past, in_.past_count, written() + run.first, scratch_.strips + run.first,
                                in_.number + run.first, scratch_.past + run.first, longest_, run.first},
                               patches, count);
    constexpr double none[3] = {};
    double of_part[3];
    step.go(none, in_.travel, rests_ ? 0.0 : in_.rolled, of_part, last_);
    if (takes_over_ == 0.0) stored_ += step.stored();
    // moments about the strips' own middles
    const double centre_x = patches->numbers.centre_x, centre_y = patches->numbers.centre_y;
    for (std::int32_t j = run.first; j < run.end; ++j) {
      double* const force = written()[j].force;
      force[2] -= (in_.along[j] - centre_x) * force[1] - (strips_.place[j] - centre_y) * force[0];
    }
    // how much further than the bodies the yield takes the steady force, over the step
    const double factor = tangential::fitted_memory.ahead * (rests_ ? 0.0 : in_.rolled / last_);
    for (std::int32_t k = 0; k < count; ++k) {
      const Patch& patch = patches[k];
      const double arm = patch.numbers.arm, ahead_x = factor * patch.local[0],
                   ahead_y = factor * patch.local[1], turn = factor * patch.local[2];
      for_each_strip(patch, [&](std::int32_t j, double weight) {
        const double x = in_.along[j] - patch.numbers.centre_x, y = strips_.place[j] - patch.numbers.centre_y;
        scratch_.ahead_x[j] += weight * (ahead_x - turn * y);
        scratch_.ahead_y[j] += weight * (ahead_y + turn * x);
        scratch_.ahead_turn[j] += weight * turn;
        scratch_.cells_x[j] += weight * (ahead_x - turn * arm * y);
        scratch_.cells_y[j] += weight * (ahead_y + turn * arm * x);
        scratch_.cells_turn[j] += weight * turn * arm;
      });
    }
  }

  /// Way of a strip under the same conditions before this step, over the contact's length [-].
  double way_before(std::int32_t j) const {
    const PastStrip* const past = scratch_.past[j];
    return past ? std::max(0.0, in_.direction * past->way) : 0.0;
  }

  /// Share of steady rolling in the way under the same conditions, as long as it will be in the next step.
  double settled(double before) const {
    return tangential::forgotten(before + step_ + std::min(step_, 0.5 * before));
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
      const double per = tangential::per_length(size, in_.rolled);
      scratch_.asked_x[j] = per * x;
      scratch_.asked_y[j] = per * y;
      scratch_.asked_spin[j] = per * turn;
      // seen from the strip's own middle
      tangential::RememberingStrip& cells = scratch_.strips[j];
      cells.centre = in_.along[j];
      cells.half_length = scratch_.region.half_length[j];
      cells.area = strips_.width[j] * cells.half_length * (2.0 / memory_cells);
      cells.x = cells.y = 0.0;
      cells.own_x = per * (in_.travel * cells.own_x + ahead * scratch_.cells_x[j]);
      cells.own_y = per * (in_.travel * cells.own_y + ahead * scratch_.cells_y[j]);
      cells.own_turn = per * (in_.travel * cells.own_turn + ahead * scratch_.cells_turn[j]);
    }
    constexpr double none[3] = {};
    const double h = from_now_ ? tangential::last_part(longest_) : last_;
    tangential::march_steadily(contact_, scratch_.strips, strips_.count, none, h, scratch_.steady);
  }

  /// Moment of a strip's cells about its own middle as the host adds it to that of its force [N m].
  double moment_of(std::int32_t j, const double (&force)[3]) const {
    return scratch_.strips[j].arm * force[2] + scratch_.lever_x[j] * force[1] -
           scratch_.lever_y[j] * force[0];
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
      const double kept2 = past ? past->added[0] * past->added[0] + past->added[1] * past->added[1] : 0.0;
      const double limit = limit_of(j), held = kept2 > limit * limit ? limit / std::sqrt(kept2) : 1.0;
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
      tangential::tend_to(kernels(), scratch_.steady[j], takes_over_, written()[j]);
    // energy of the cells and of the half-spaces, whose moments are about the patches' centres
    for (std::int32_t j = 0; j < strips_.count; ++j) {
      const tangential::RememberingStrip& cells = scratch_.strips[j];
      if (cells.arm > 0.0)
        stored_ += tangential::stored_in(kernels(), written()[j], cells.area, cells.growth_x, cells.growth_y);
    }
    for (std::int32_t k = 0; k < patches_; ++k) {
      const Patch& patch = scratch_.patches[k];
      double force[3] = {};
      for (std::int32_t j = patch.first; j < patch.end; ++j)
        patch.add_force(patch.inside(j), written()[j].force, in_.along[j], strips_.place[j], force);
      stored_ += patch.share * tangential::stored_by(patch.numbers.yield, force);
    }
  }

  /// Lowers the forces of each patch to its friction limit.
  void stay_within_friction() {
    for (std::int32_t k = 0; k < patches_; ++k) {
      const Patch& patch = scratch_.patches[k];
      double fx = 0.0, fy = 0.0;
      for (std::int32_t j = patch.first; j < patch.end; ++j) {
        fx += patch.inside(j) * forces_.fx[j];
        fy += patch.inside(j) * forces_.fy[j];
      }
      const double size = std::max(std::sqrt(fx * fx + fy * fy), least_force);
      const double within = std::min(1.0, patch.numbers.limit / size);
      for_each_strip(patch, [&](std::int32_t j, double weight) { scratch_.within[j] += weight * within; });
    }
    for (std::int32_t j = 0; j < strips_.count; ++j) {
      forces_.fx[j] *= scratch_.within[j];
      forces_.fy[j] *= scratch_.within[j];
    }
  }

  /// Change of a strip's conditions since the committed step: tractions by its slips over the largest, bound
  /// and outline [-].
  double change_of(std::int32_t j) const {
    const PastStrip &strip = written()[j], &past = *scratch_.past[j];
    const tangential::RememberingStrip& cells = scratch_.strips[j];
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
    const double per = in_.travel / in_.rolled;
    strip.slip[0] = per * strips_.slip_x[j];
    strip.slip[1] = per * strips_.slip_y[j];
    strip.slip[2] = per * strips_.spin[j];
    double before = way_before(j);
    if (before > 0.0) before /= 1.0 + change_counts * change_of(j);
    strip.way = std::min(before + step_, tangential::all_forgotten);
    const double rate = settles * step_ * settled(before), share = rate / (1.0 + rate);
    if (!(share > 0.0)) return;
    const PastStrip& steady = scratch_.steady[j];
    tangential::tend_to(kernels(), steady, share, strip);
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
    const double part = 1.0 / count;
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
      strip.energy = part * energy.left;
      std::copy_n(scratch_.strips[j].bound, std::size(strip.bound), strip.bound);
      if (in_.direction < 0.0) strip = tangential::turned(strip, in_.direction);
    }
    return energy.dissipated;
  }

  PastStrip* written() const { return in_.written; }
  const simd::TangentialKernels& kernels() const { return contact_.grid->kernels->tangential; }

  const RememberingInput& in_;
  const SurfaceRollingInput& strips_;
  const SurfaceRollingForces& forces_;
  Scratch scratch_;
  StripHeirs heirs_;
  StripsInParts parts_;
  tangential::RollingContact contact_;
  std::int32_t runs_ = 0, patches_ = 0;
  std::int64_t lost_ = 0;
  double step_ = 0.0;        // distance rolled over the longest strip [-]
  double longest_ = 0.0;     // strip [m]
  double last_ = 0.0;        // length of the step's last part [m]
  double energy_ = 0.0;      // could be given back before the step [J]
  double stored_ = 0.0;      // in the tractions of its end [J]
  double takes_over_ = 0.0;  // share of steady rolling in it [-]
  bool rests_ = false, from_now_ = false;
  Fault fault_;
};

}  // namespace

void count_remembering(Arena& arena, std::int32_t most) { cut(arena, most, most); }

RememberingResult roll_remembering(const RememberingInput& in, Arena arena,
                                   const SurfaceRollingForces& forces) noexcept {
  return Rememberer(in, arena, forces).roll();
}

}  // namespace wrc::surface
