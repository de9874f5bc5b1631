#include "surface/wrench/traction_differences.hpp"

#include <algorithm>

#include "base/number.hpp"
#include "surface/wrench/strip_friction.hpp"

namespace wrc::surface {
namespace {

using Number = RailFrameDual;

/// The strips moved by a step along their change by an input, for differences of tractions.
class StripsAlongInput {
 protected:
  static constexpr int results = 3, lengths = 0, slips = 3, spins = 5, places = 6;

  /// `numbers`: how many of the numbers in from_ the tractions depend on.
  StripsAlongInput(const Differentiation& d, const Number& speed, int numbers)
      : d_(d),
        s_(d.w.loaded),
        h_(d.w.differences),
        speed_(speed),
        strips_(d.solved.strips),
        numbers_(numbers) {
    // numbers that inputs change are its own; places, widths and candidates stay those of the solution
    strips_.count = s_.count;
    strips_.half_length = h_.half_length;
    strips_.solved_peak = h_.peak;
    strips_.curvature = h_.curvature;
    strips_.slip_x = h_.slip_x;
    strips_.slip_y = h_.slip_y;
    strips_.spin = h_.spin;
    strips_.x = h_.x;
    strips_.friction = h_.friction;
    strips_.flexibility = h_.flexibility;
    strips_.yield = h_.yield;
    strips_.hardening = h_.hardening;
    for (int a = 0; a < numbers; ++a)
      for (std::int32_t k = 0; k < s_.count; ++k) size_[a] = larger(size_[a], magnitude(from_[a][k].value));
    // slips and spin share a size, so that a slip of zero has one
    constexpr double least_slip = 1e-4;
    const double slip =
        larger(larger(size_[slips], size_[slips + 1]), larger(size_[spins] * size_[lengths], least_slip));
    size_[slips] = size_[slips + 1] = slip;
    size_[spins] = slip / size_[lengths];
    size_[places] = size_[lengths];
  }

  /// Largest change of any number of the strips per unit of an input, relative to the number's size.
  double largest_change(std::size_t input) const {
    double change = larger(magnitude(speed_.d[input]) / speed_.value, magnitude(s_.friction_factor.d[input]));
    for (int a = 0; a < numbers_; ++a)
      for (std::int32_t k = 0; k < s_.count; ++k)
        change = larger(change, magnitude(from_[a][k].d[input]) / size_[a]);
    return change;
  }

  /// Moves the strips by a step along an input, and fills `friction` with cold friction. Returns the speed by
  /// which slips were divided.
  double go(std::size_t input, double step, double* friction) {
    double* const to[] = {h_.half_length, h_.peak, h_.curvature, h_.slip_x, h_.slip_y, h_.spin, h_.x};
    for (std::int32_t k = 0; k < s_.count; ++k)
      for (int a = 0; a < numbers_; ++a) to[a][k] = from_[a][k].value + step * from_[a][k].d[input];
    const double speed = speed_.value + step * speed_.d[input];
    const double factor = 1.0 + step * s_.friction_factor.d[input];

    // the law at each strip's own place and sliding speed
    const WheelOnRail& in = d_.problem.in;
    for (std::int32_t k = 0; k < s_.count; ++k) {
      to[lengths][k] = larger(to[lengths][k], 0.0);
      friction[k] = in.friction * factor;
      if (in.law == nullptr) continue;
      const FrictionAtRest cold = friction_at_rest(d_.problem, d_.solved.overlaps, strips_.candidate[k]);
      const double way = moves_with_wheel(in) ? step * d_.y_on_wheel(k).d[input] : 0.0;
      const double mu = larger(cold.value + way * cold.by_wheel_y, 0.0);
      const tangential::Layer &layer = cold.layer, &slope = cold.layer_by_wheel_y;
      strips_.flexibility[k] = layer.flexibility + way * slope.flexibility;
      strips_.yield[k] = layer.yield + way * slope.yield;
      strips_.hardening[k] = layer.hardening + way * slope.hardening;
      friction[k] = mu * (strip_speed_factor(*in.law, strips_, k, speed) * factor);
    }
    return speed;
  }

  /// Derivatives of the forces that the scratch holds, by one difference along each input. A step changes
  /// some number of the strips by the part `relative_step`, and none by more. `solve`: fills the scratch with
  /// the forces a step along an input.
  template <class Solve>
  void take_differences(const DualForces& forces, double relative_step, const Solve& solve) {
    Number* const results_of[results] = {forces.fx, forces.fy, forces.mz};
    double* const base[results] = {h_.base_fx, h_.base_fy, h_.base_mz};
    for (int r = 0; r < results; ++r) std::copy_n(found_[r], s_.count, base[r]);
    for (std::size_t input = 0; input < frame_inputs; ++input) {
      const double change = largest_change(input);
      if (!(change > 0.0)) continue;
      const double step = relative_step / change;
      solve(input, step);
      for (int r = 0; r < results; ++r)
        for (std::int32_t k = 0; k < s_.count; ++k)
          results_of[r][k].d[input] = (found_[r][k] - base[r][k]) / step;
    }
  }

  /// Gives the forces their values.
  void take_values(const double* const (&values)[results], const DualForces& forces) const {
    Number* const results_of[results] = {forces.fx, forces.fy, forces.mz};
    for (int r = 0; r < results; ++r)
      for (std::int32_t k = 0; k < s_.count; ++k) results_of[r][k] = values[r][k];
  }

  const Differentiation& d_;
  const LoadedStrips& s_;
  const DifferencesScratch& h_;
  const Number& speed_;
  const double* const found_[results] = {h_.fx, h_.fy, h_.mz};
  ContactStrips strips_;  ///< those of the solution, with numbers of their own

 private:
  const Number* from_[7] = {s_.half_length, s_.peak, s_.curvature, s_.slip_x, s_.slip_y, s_.spin, s_.centre};
  double size_[7] = {};
  int numbers_;
};

/// Tractions under friction over temperature: by one difference of their solution along the change of the
/// strips with each input.
class HeatedDifferences : StripsAlongInput {
 public:
  HeatedDifferences(const Differentiation& d, const Number& speed, bool backwards)
      : StripsAlongInput(d, speed, 6), backwards_(backwards) {}

  /// Fills the forces and their derivatives.
  void differentiate(const DualForces& forces) {
    constexpr int more_solutions = 3;  // from friction found
    // values: as the solution has them, from the start
    solve(0, 0.0, 0);
    take_values(found_, forces);

    // both sides of a difference iterate equally often, from the same shares
    std::copy_n(h_.rolling.heat_share, s_.count, h_.share);
    solve(0, 0.0, more_solutions);

    constexpr double relative_step = 3e-7;
    take_differences(forces, relative_step,
                     [&](std::size_t input, double step) { solve(input, step, more_solutions); });
  }

 private:
  /// Solves the tractions of the strips a step along an input; `more` as in solve_heated_tractions().
  void solve(std::size_t input, double step, int more) {
    if (more > 0) std::copy_n(h_.share, s_.count, h_.rolling.heat_share);
    const double speed = go(input, step, h_.rolling.cold_friction);
    solve_heated_tractions(d_.problem.model, d_.problem.in, strips_, backwards_, speed, h_.rolling,
                           {h_.fx, h_.fy, h_.mz}, more);
  }

  bool backwards_;
};

/// Tractions of strips that remember: by one difference of the step along the change of the strips with each
/// input.
class RememberedDifferences : StripsAlongInput {
 public:
  RememberedDifferences(const Differentiation& d, const Number& rolling_speed, const Number& divisor)
      : StripsAlongInput(d, divisor, 7), rolling_speed_(rolling_speed), time_(d.problem.in.time) {}

  /// Fills the forces and their derivatives.
  void differentiate(const DualForces& forces) {
    const ContactStrips& solved = d_.solved.strips;
    take_values({solved.fx, solved.fy, solved.mz}, forces);
    solve(0, 0.0, time_);
    constexpr double relative_step = 3e-8, least_time = 1e-3;  // [-], [s]
    take_differences(forces, relative_step,
                     [&](std::size_t input, double step) { solve(input, step, time_); });
    if (d_.by == JacobianBy::track) return;

    // the same strips at a later time
    const double* const base[results] = {h_.base_fx, h_.base_fy, h_.base_mz};
    double* const by_time[results] = {h_.fx_by_time, h_.fy_by_time, h_.mz_by_time};
    const double change = 1.0 / larger(time_, least_time), step = relative_step / change;
    solve(0, 0.0, time_ + step);
    for (int r = 0; r < results; ++r)
      for (std::int32_t k = 0; k < s_.count; ++k) by_time[r][k] = (found_[r][k] - base[r][k]) / step;
  }

 private:
  /// Solves the rolling step of strips moved by a step along an input, at a time [s]. Its strips go to a list
  /// that no other step uses.
  void solve(std::size_t input, double step, double time) {
    const double divisor = go(input, step, h_.friction);
    solve_remembered_tractions(
        d_.problem, d_.solved.overlaps, strips_,
        {rolling_speed_.value + step * rolling_speed_.d[input], divisor, time, h_.written}, h_.remembering,
        {h_.fx, h_.fy, h_.mz});
  }

  const Number& rolling_speed_;
  double time_;
};

}  // namespace

DifferencesScratch cut_differences(Arena& arena, const WorkSizes& sizes) {
  DifferencesScratch h;
  arena.each(sizes.strips, h.half_length, h.peak, h.curvature, h.slip_x, h.slip_y, h.spin, h.x, h.friction,
             h.flexibility, h.yield, h.hardening, h.fx, h.fy, h.mz, h.share, h.base_fx, h.base_fy, h.base_mz);
  if (sizes.methods.remembers) {
    arena.each(sizes.strips, h.fx_by_time, h.fy_by_time, h.mz_by_time);
    h.written = arena.take<tangential::PastStrip>(sizes.strips);
    h.remembering = arena;
    count_remembered_tractions(arena, sizes);
  } else {
    arena.each(sizes.strips, h.other.fx, h.other.fy, h.other.mz);
    h.rolling = cut_rolling(arena, sizes);
  }
  return h;
}

void differentiate_heated(const Differentiation& d, const RailFrameDual& speed, bool backwards,
                          const DualForces& forces) {
  HeatedDifferences(d, speed, backwards).differentiate(forces);
}

void differentiate_remembered(const Differentiation& d, const RailFrameDual& rolling_speed,
                              const RailFrameDual& divisor, const DualForces& forces) {
  RememberedDifferences(d, rolling_speed, divisor).differentiate(forces);
}

}  // namespace wrc::surface
