#include "surface/rolling/remembering.hpp"

#include <algorithm>
#include <cmath>

#include "surface/rolling/strip_parts.hpp"

namespace wrc::surface {
namespace {

using tangential::memory_cells;
using tangential::PastStrip;

constexpr double least_force = 1e-290;  // [N]

/// From 0 to 1 over t from 0 to 1.
double smooth_step(double t) {
  const double within = std::clamp(t, 0.0, 1.0);
  return within * within * (3.0 - 2.0 * within);
}

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
  double* rolling;                         ///< surface_rolling_workspace()
  patch::Strips region;                    ///< part
  tangential::RememberingStrip *shared, *of_part, *scratch;  ///< all strips; part: of those, PatchStrips
  PastStrip *written, *steady;                               ///< part; all strips in steady rolling
};

Scratch cut(Arena& arena, std::int32_t most) {
  Scratch s{};
  arena.each(most, s.line_load, s.load, s.shares, s.number, s.inside, s.ahead_x, s.ahead_y, s.ahead_turn,
             s.cells_x, s.cells_y, s.cells_turn, s.lever_x, s.lever_y, s.asked_x, s.asked_y, s.asked_spin,
             s.follows, s.within, s.region.y, s.region.width, s.region.centre, s.region.half_length,
             s.region.peak);
  s.region.capacity = most;
  s.rolling = arena.take(static_cast<std::int64_t>(surface_rolling_workspace(most)));
  arena.each(most, s.shared, s.of_part, s.scratch);
  arena.each(most, s.written, s.steady);
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
    std::int32_t first, end;
    double share;
    const PartMeans& means;
    bool at_low_end, at_high_end;  ///< where its run ends
  };

  /// Parts that carry load and have friction.
  template <class Take>
  void for_each_part(Take&& take) {
    parts_.for_each(
        [&](std::int32_t first, std::int32_t end, double share, const LobeCut* low, const LobeCut* high) {
          const PartMeans m = parts_.take_part(first, end, low, high);
          if (m.load > 0.0 && m.friction > 0.0) take(Part{first, end, share, m, !low, !high});
        });
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
    for (std::int32_t j = 0; j < count; ++j) {
      PastStrip& strip = written()[j];
      strip = {};
      strip.y = in_.number[j];
      strip.centre = in_.along[j];
      strip.half_length = strips_.half_length[j];
      longest_ = std::max(longest_, 2.0 * strip.half_length);
      scratch_.shared[j] = {};
    }
    for (std::int64_t k = 0; k < in_.past_count; ++k) energy_ += in_.past[k].energy;
    rests_ = tangential::hardly_rolls(in_.rolled, longest_);
    from_now_ = tangential::forgets(in_.rolled, longest_);
  }

  /// The forces of strips that left the contact beside a part. Those between two runs go over from one to the
  /// other half way.
  tangential::LeftStrips left_beside(const Part& part) const {
    tangential::LeftStrips left;
    const double* const numbers = in_.number;
    const auto beyond = [&](double number, std::int32_t before, std::int32_t behind) {
      if (before < 0 || behind == strips_.count) return before < 0 ? 1.0 : 0.0;
      const double t = (number - numbers[before]) / (numbers[behind] - numbers[before]);
      return smooth_step(2.0 * t - 0.5);
    };
    for (std::int64_t k = 0; k < in_.past_count; ++k) {
      const PastStrip& strip = in_.past[k];
      double weight = 0.0;
      if (part.at_low_end && strip.y < numbers[part.first]) {
        if (part.first > 0 && strip.y <= numbers[part.first - 1]) continue;
        weight = beyond(strip.y, part.first - 1, part.first);
      } else if (part.at_high_end && strip.y > numbers[part.end - 1]) {
        if (part.end < strips_.count && strip.y >= numbers[part.end]) continue;
        weight = 1.0 - beyond(strip.y, part.end - 1, part.end);
      }
      const double fx = weight * in_.direction * strip.force[0], fy = weight * strip.force[1];
      left.fx += fx;
      left.fy += fy;
      left.mz += weight * in_.direction * strip.force[2];
      left.turn += in_.direction * strip.centre * fy -
                   (in_.rail_place[static_cast<std::int32_t>(strip.y)] - part.means.place) * fx;
    }
    return left;
  }

  /// The part as a patch.
  tangential::PatchStrips fill_strips(const Part& part, const tangential::RememberingStrip* shared) {
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
      scratch_.inside[k] = region.width[k] / strips_.width[j];
      if (shared) scratch_.of_part[k] = shared[j];
      region.count = k + 1;
    });
    contact_.region = region;
    contact_.friction = {m.friction, scratch_.shares};
    return {in_.past,
            in_.past_count,
            scratch_.written,
            scratch_.scratch,
            scratch_.number,
            scratch_.inside,
            shared ? scratch_.of_part : nullptr,
            left_beside(part),
            longest_};
  }

  /// Adds a part's bounds, growths and displacements to those of its strips, by its share. Strips of two
  /// partitions then roll alike in both, but for the yield.
  void share_numbers(const Part& part) {
    const tangential::PatchStep patch(contact_, fill_strips(part, nullptr), fault_);
    const tangential::Creepage& c = part.means.creepage;
    for_each_strip(part, [&](std::int32_t j, std::int32_t k) {
      const double weight = part.share * scratch_.inside[k], arm = patch.arm();
      const tangential::RememberingStrip& from = scratch_.scratch[k];
      tangential::RememberingStrip& to = scratch_.shared[j];
      for (std::int32_t i = 0; i < memory_cells; ++i) to.bound[i] += weight * from.bound[i];
      to.growth_x += weight * from.growth_x;
      to.growth_y += weight * from.growth_y;
      to.turns += weight * from.turns;
      to.arm += weight * arm;
      // slips of the strip; beside the part's mean along x, and by spin, with the factor on arms
      const double x = in_.along[j] - patch.centre_x(), y = contact_.region.y[k];
      to.own_x += weight * (c.longitudinal + arm * (strips_.slip_x[j] - c.longitudinal));
      to.own_y += weight * (strips_.slip_y[j] + (arm - 1.0) * c.spin * x);
      to.own_turn = strips_.spin[j];
      scratch_.lever_x[j] += weight * (arm - 1.0) * x;
      scratch_.lever_y[j] += weight * (arm - 1.0) * y;
      scratch_.follows[j] += weight * patch.follows(in_.rolled);
    });
  }

  /// Solves the step of one part, and adds its strips, by its share, to those of the contact.
  void roll_part(const Part& part) {
    if (from_now_) return;
    tangential::PatchStep patch(contact_, fill_strips(part, scratch_.shared), fault_);
    // how much further than the bodies it takes the steady force, over the step
    constexpr double none[3] = {};
    double local[3], of_part[3], last = 0.0;
    patch.go(none, in_.travel, rests_ ? 0.0 : in_.rolled, local, of_part, last);
    const double factor = tangential::fitted_memory.ahead * (rests_ ? 0.0 : in_.rolled / last);
    const double ahead[3] = {factor * local[0], factor * local[1], factor * local[2]}, arm = patch.arm();
    last_ = last;
    stored_ += part.share * patch.stored();
    for_each_strip(part, [&](std::int32_t j, std::int32_t k) {
      const double weight = part.share * scratch_.inside[k];
      const PastStrip& from = scratch_.written[k];
      PastStrip& to = written()[j];
      for (std::int32_t i = 0; i < memory_cells; ++i) {
        to.px[i] += weight * from.px[i];
        to.py[i] += weight * from.py[i];
      }
      // moments about the strip's own middle
      const double x = in_.along[j] - patch.centre_x(), y = contact_.region.y[k];
      to.force[0] += part.share * from.force[0];
      to.force[1] += part.share * from.force[1];
      to.force[2] += part.share * (from.force[2] - arm * (x * from.force[1] - y * from.force[0])) *
                     (scratch_.shared[j].arm / arm);
      scratch_.ahead_x[j] += weight * (ahead[0] - ahead[2] * y);
      scratch_.ahead_y[j] += weight * (ahead[1] + ahead[2] * x);
      scratch_.ahead_turn[j] += weight * ahead[2];
      scratch_.cells_x[j] += weight * (ahead[0] - ahead[2] * arm * y);
      scratch_.cells_y[j] += weight * (ahead[1] + ahead[2] * arm * x);
      scratch_.cells_turn[j] += weight * ahead[2] * (arm / scratch_.shared[j].arm);
    });
  }

  /// Slips at which the steady forces of the strips are asked, those of the bodies and of the yield, and the
  /// cells in steady rolling at the same.
  void march_cells() {
    for (std::int32_t j = 0; j < strips_.count; ++j) {
      const double x = in_.travel * strips_.slip_x[j] + scratch_.ahead_x[j];
      const double y = in_.travel * strips_.slip_y[j] + scratch_.ahead_y[j];
      const double turn = in_.travel * strips_.spin[j] + scratch_.ahead_turn[j];
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
      cells.own_x = per * (in_.travel * cells.own_x + scratch_.cells_x[j]);
      cells.own_y = per * (in_.travel * cells.own_y + scratch_.cells_y[j]);
      cells.own_turn = per * (in_.travel * cells.own_turn + scratch_.cells_turn[j]);
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
    if (from_now_) take_steady_cells();
    for (std::int32_t j = 0; j < strips_.count; ++j) {
      PastStrip& strip = written()[j];
      const double of_cells[3] = {strip.force[0], strip.force[1], moment_of(j, strip.force)};
      const auto& steady = scratch_.steady[j].force;
      const double of_steady_cells[3] = {steady[0], steady[1], moment_of(j, steady)};
      const PastStrip* const past = tangential::past_of_number(in_.past, in_.past_count, strip.y);
      // a strip about to leave keeps no more of it than its friction
      const double limit =
          strips_.friction[j] * (0.5 * pi) * strips_.peak[j] * strips_.half_length[j] * strips_.width[j];
      const double kept =
          past ? std::sqrt(past->added[0] * past->added[0] + past->added[1] * past->added[1]) : 0.0;
      const double held = std::min(1.0, limit / std::max(kept, least_force));
      double* const force[3] = {forces_.fx + j, forces_.fy + j, forces_.mz + j};
      for (int i = 0; i < 3; ++i) {
        double& added = strip.added[i];
        added = past ? (held * (i == 1 ? 1.0 : in_.direction)) * past->added[i] : 0.0;
        if (!rests_) added += scratch_.follows[j] * (*force[i] - of_steady_cells[i] - added);
        if (from_now_) continue;  // the steady force itself
        *force[i] = of_cells[i] + added;
      }
    }
    if (!from_now_) stay_within_friction();
  }

  /// Nothing before the step is seen: the cells are those of steady rolling.
  void take_steady_cells() {
    for (std::int32_t j = 0; j < strips_.count; ++j) {
      PastStrip& strip = written()[j];
      const PastStrip& steady = scratch_.steady[j];
      std::copy_n(steady.px, memory_cells, strip.px);
      std::copy_n(steady.py, memory_cells, strip.py);
      std::copy_n(steady.force, 3, strip.force);
    }
    for_each_part([&](const Part& part) {
      const tangential::PatchStep patch(contact_, fill_strips(part, scratch_.shared), fault_);
      for_each_strip(part, [&](std::int32_t j, std::int32_t k) {
        PastStrip& strip = scratch_.written[k] = scratch_.steady[j];
        for (double& f : strip.force) f *= scratch_.inside[k];
      });
      stored_ += part.share * patch.stored();
    });
  }

  /// Lowers the forces of each part to its friction limit.
  void stay_within_friction() {
    for_each_part([&](const Part& part) {
      double fx = 0.0, fy = 0.0;
      const auto inside = [&](std::int32_t j) { return parts_.width_inside(j) / strips_.width[j]; };
      for_each_strip(part, [&](std::int32_t j, std::int32_t) {
        fx += inside(j) * forces_.fx[j];
        fy += inside(j) * forces_.fy[j];
      });
      const double size = std::max(std::sqrt(fx * fx + fy * fy), least_force);
      const double within = std::min(1.0, part.means.friction * part.means.load / size);
      for_each_strip(
          part, [&](std::int32_t j, std::int32_t) { scratch_.within[j] += part.share * inside(j) * within; });
    });
    for (std::int32_t j = 0; j < strips_.count; ++j) {
      forces_.fx[j] *= scratch_.within[j];
      forces_.fy[j] *= scratch_.within[j];
    }
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
      for (double* const f : {forces_.fx, forces_.fy, forces_.mz}) f[j] *= energy.scale;
      for (std::int32_t i = 0; i < memory_cells; ++i) {
        strip.px[i] *= energy.scale;
        strip.py[i] *= energy.scale;
      }
      for (double& f : strip.force) f *= energy.scale;
      strip.added[0] = forces_.fx[j] - strip.force[0];
      strip.added[1] = forces_.fy[j] - strip.force[1];
      strip.added[2] = forces_.mz[j] - moment_of(j, strip.force);
      strip.energy = energy.left / count;
      strip = tangential::turned(strip, in_.direction);
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
  double longest_ = 0.0;  // strip [m]
  double last_ = 0.0;     // length of the step's last part [m]
  double energy_ = 0.0;   // could be given back before the step [J]
  double stored_ = 0.0;   // in the tractions of its end [J]
  bool rests_ = false, from_now_ = false;
  Fault fault_;
};

}  // namespace

void count_remembering(Arena& arena, std::int32_t most) { cut(arena, most); }

RememberingResult roll_remembering(const RememberingInput& in, Arena arena,
                                   const SurfaceRollingForces& forces) noexcept {
  return Rememberer(in, arena, forces).roll();
}

}  // namespace wrc::surface
