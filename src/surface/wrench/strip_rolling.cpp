#include "surface/wrench/strip_rolling.hpp"

#include <algorithm>
#include <cmath>

#include "surface/wrench/strip_friction.hpp"

namespace wrc::surface {
namespace {

/// Tractions by the model's method; `heat`: of methods that roll by region, to which the strips' friction is
/// cold, and hot afterwards.
Fault solve_one_way(const SurfaceModel& model, const WheelOnRail& in, const ContactStrips& strips,
                    bool backwards, const RollingScratch& scratch, const tangential::TangentialFields& fields,
                    SurfaceRollingForces forces, tangential::HeatedFriction* heat) {
  const SurfaceMethods& methods = model.methods;
  const std::int32_t count = strips.count;
  auto rolls = rolling_input<double>(model, in, strips);
  rolls.peak = strips.solved_peak;
  rolls.yield = strips.yield;
  rolls.hardening = strips.hardening;
  rolls.method = methods.strips;
  rolls.parabolic = methods.parabolic;

  // Backwards is forwards seen in a mirror across the axle: x, and with it slip along x and spin, change
  // sign, and so do their forces.
  if (backwards) {
    std::copy_n(strips.slip_x, count, scratch.slip_x);
    std::copy_n(strips.spin, count, scratch.spin);
    reverse(count, scratch.slip_x);
    reverse(count, scratch.spin);
    rolls.slip_x = scratch.slip_x;
    rolls.spin = scratch.spin;
  }

  // patch by patch, or strip by strip: FaStrip alone computes through fields
  Fault fault;
  if (rolls_by_region(model, in)) {
    for (std::int32_t k = 0; k < count; ++k) scratch.x[k] = backwards ? -strips.x[k] : strips.x[k];
    const RegionRollingInput patches{rolls,        scratch.x, in.slope,       in.slope_reduction,
                                     in.reduction, heat,      strips.friction};
    fault = roll_by_region(patches, methods.region, scratch.region, scratch.fields, forces);
  } else {
    const bool needs_fields = methods.strips == SurfaceRollingMethod::fastrip;
    roll_on_surface(rolls, scratch.rolling, needs_fields ? scratch.fields : fields, forces);
  }
  if (backwards) {
    reverse(count, forces.fx);
    reverse(count, forces.mz);
  }
  return fault;
}

}  // namespace

bool rolls_by_region(const SurfaceModel& model, const WheelOnRail& in) {
  return model.methods.region.solve && (model.methods.by_region || in.slope.falls());
}

Fault solve_tractions(const SurfaceModel& model, const WheelOnRail& in, const ContactStrips& strips,
                      bool backwards, const RollingScratch& scratch,
                      const tangential::TangentialFields& fields, const SurfaceRollingForces& forces) {
  return solve_one_way(model, in, strips, backwards, scratch, fields, forces, nullptr);
}

Fault solve_heated_tractions(const SurfaceModel& model, const WheelOnRail& in, const ContactStrips& strips,
                             bool backwards, double speed, const RollingScratch& scratch,
                             const SurfaceRollingForces& forces, int more) {
  tangential::HeatedFriction heat(*in.law, model.effusivities, model.grid->cells, speed);
  const double* const cold = scratch.cold_friction;
  if (rolls_by_region(model, in)) {  // the method itself iterates, patch by patch
    std::copy_n(cold, strips.count, strips.friction);
    return solve_one_way(model, in, strips, backwards, scratch, {}, forces, &heat);
  }
  patch::Strips lengths;
  lengths.count = strips.count;
  lengths.half_length = strips.half_length;

  // fixed point: mu = share * mu_cold gives tractions and slips, their heat the next share
  Fault fault;
  const auto solve = [&] {
    for (std::int32_t k = 0; k < strips.count; ++k) strips.friction[k] = cold[k] * scratch.heat_share[k];
    keep_worst(fault, solve_tractions(model, in, strips, backwards, scratch, scratch.fields, forces));
  };
  const Fault unsettled = tangential::solve_heated(heat, lengths, scratch.fields, scratch.fields.slip_x,
                                                   scratch.heat_share, solve, more);
  keep_worst(fault, unsettled);
  return fault;
}

namespace {

/// Strips of steps that remember, seen along the direction of rolling. The scratch of roll_remembering() lies
/// behind them.
struct RememberedScratch {
  double *slip_x, *spin;
  double* x;       ///< [m]
  double* number;  ///< numbers of the rail's strips
};

RememberedScratch cut_remembered(Arena& arena, std::int32_t strips) {
  RememberedScratch r;
  arena.each(strips, r.slip_x, r.spin, r.x, r.number);
  return r;
}

}  // namespace

void count_remembered_tractions(Arena& arena, const WorkSizes& sizes) {
  cut_remembered(arena, sizes.strips);
  count_remembering(arena, sizes.strips);
}

RememberingResult solve_remembered_tractions(const WheelProblem& problem, const Overlaps& overlaps,
                                             const ContactStrips& strips, const RememberedStep& step,
                                             Arena arena, const SurfaceRollingForces& forces) {
  const SurfaceModel& model = problem.model;
  const RememberedScratch scratch = cut_remembered(arena, strips.count);
  auto rolls = rolling_input<double>(model, problem.in, strips);
  rolls.peak = strips.solved_peak;
  const std::int32_t count = strips.count;
  const double direction = step.rolling_speed < 0.0 ? -1.0 : 1.0;
  for (std::int32_t k = 0; k < count; ++k) {
    scratch.slip_x[k] = direction * strips.slip_x[k];
    scratch.spin[k] = direction * strips.spin[k];
    scratch.x[k] = direction * strips.x[k];
    scratch.number[k] = overlaps.strip[strips.candidate[k]];
  }
  rolls.slip_x = scratch.slip_x;
  rolls.spin = scratch.spin;
  const RememberingInput in{rolls,
                            scratch.x,
                            scratch.number,
                            problem.rail,
                            *model.methods.linear_theory,
                            step.divisor * step.time,
                            std::abs(step.rolling_speed) * step.time,
                            direction,
                            problem.memory->remembered(),
                            problem.memory->count,
                            step.written};
  const RememberingResult result = roll_remembering(in, arena, forces);
  if (direction < 0.0) {
    reverse(count, forces.fx);
    reverse(count, forces.mz);
  }
  return result;
}

namespace {

/// Frictional power of the strips without memory [W], slips over `speed` [m/s].
void fill_power(const ContactStrips& strips, double speed) {
  for (std::int32_t k = 0; k < strips.count; ++k)
    strips.power[k] = -speed * work_by_slips({strips.fx, strips.fy, strips.mz}, strips.slip_x, strips.slip_y,
                                             strips.spin, k);
}

/// Divides the work that the step dissipates among the strips: by the work of their forces, where that is
/// positive, else by load.
void share_power(const ContactStrips& strips, double speed, double dissipated) {
  fill_power(strips, speed);
  double worked = 0.0, load = 0.0;
  const auto load_of = [&](std::int32_t k) {
    return strips.width[k] * strips.half_length[k] * strips.solved_peak[k];
  };
  for (std::int32_t k = 0; k < strips.count; ++k) {
    worked += std::max(strips.power[k], 0.0);
    load += load_of(k);
  }
  for (std::int32_t k = 0; k < strips.count; ++k)
    strips.power[k] =
        dissipated * (worked > 0.0 ? std::max(strips.power[k], 0.0) / worked : load_of(k) / load);
}

/// Forces and power of strips that remember, whose tractions go to the list that may be committed.
Fault remember_strips(const WheelProblem& problem, const Overlaps& overlaps, const ContactStrips& strips,
                      double rolling_speed, double divisor, Arena arena) {
  tangential::Memory& memory = *problem.memory;
  const double time = problem.in.time;
  const RememberingResult result =
      solve_remembered_tractions(problem, overlaps, strips, {rolling_speed, divisor, time, memory.other()},
                                 arena, {strips.fx, strips.fy, strips.mz});
  memory.written = strips.count;
  share_power(strips, divisor, time > 0.0 ? result.dissipated / time : 0.0);
  return result.fault;
}

}  // namespace

Fault roll_strips(const WheelProblem& problem, const Overlaps& overlaps, const ContactStrips& strips,
                  double rolling_speed, const geometry::RollingReference& reference, Arena arena) {
  const SurfaceModel& model = problem.model;
  const WheelOnRail& in = problem.in;
  const double speed = reference.divisor, reverse_share = reference.reverse_share;
  const bool backwards = rolling_speed < 0.0;
  if (in.law) set_cold_friction(problem, overlaps, speed, strips);
  if (problem.memory) return remember_strips(problem, overlaps, strips, rolling_speed, speed, arena);
  const RollingScratch scratch = cut_rolling(arena, work_sizes(model));
  const bool heated = in.law && in.law->heated();
  if (heated) std::copy_n(strips.friction, strips.count, scratch.cold_friction);
  const auto solve = [&](bool way_back, const SurfaceRollingForces& forces) {
    return heated ? solve_heated_tractions(model, in, strips, way_back, speed, scratch, forces)
                  : solve_tractions(model, in, strips, way_back, scratch, {}, forces);
  };

  // The reverse direction comes first: its own direction then leaves the strips their hot friction.
  const SurfaceRollingForces other{scratch.other_fx, scratch.other_fy, scratch.other_mz};
  Fault others, fault;
  if (reverse_share > 0.0) others = solve(!backwards, other);
  keep_worst(fault, solve(backwards, {strips.fx, strips.fy, strips.mz}));
  keep_worst(fault, others);

  // F = F_own + share (F_other - F_own): through standstill forces change over without a jump
  for (std::int32_t k = 0; k < strips.count && reverse_share > 0.0; ++k) {
    strips.fx[k] += reverse_share * (other.fx[k] - strips.fx[k]);
    strips.fy[k] += reverse_share * (other.fy[k] - strips.fy[k]);
    strips.mz[k] += reverse_share * (other.mz[k] - strips.mz[k]);
  }
  fill_power(strips, speed);
  return fault;
}

}  // namespace wrc::surface
