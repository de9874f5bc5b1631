/// Tractions of the strips in contact from their slips, by the model's method, in both directions of rolling.
#pragma once

#include "geometry/creepages.hpp"
#include "surface/rolling/remembering.hpp"
#include "surface/wrench/wheel_solution.hpp"
#include "tangential/friction/heated_friction.hpp"

namespace wrc::surface {

/// Input of rolling: the arrays of these names in `strips` but for the peaks, and the model's numbers.
template <class Number, class Strips>
SurfaceRollingInputOf<Number> rolling_input(const SurfaceModel& model, const WheelOnRail& in,
                                            const Strips& strips) {
  SurfaceRollingInputOf<Number> rolls;
  rolls.count = strips.count;
  rolls.place = strips.place;
  rolls.width = strips.width;
  rolls.half_length = strips.half_length;
  rolls.curvature = strips.curvature;
  rolls.slip_x = strips.slip_x;
  rolls.slip_y = strips.slip_y;
  rolls.spin = strips.spin;
  rolls.friction = strips.friction;
  rolls.normal_shear_modulus = model.material.shear_modulus;
  rolls.shear_modulus = model.material.shear_modulus * in.slope_reduction;
  rolls.coupling = model.coupling;
  rolls.layer = in.layer;
  if (in.layer_of_strips) rolls.flexibility = strips.flexibility;
  rolls.coefficients = &model.coefficients;
  rolls.grid = model.grid;
  return rolls;
}

/// Changes the sign of so many numbers: x of rolling backwards.
template <class Number>
void reverse(std::int32_t count, Number* a) {
  for (std::int32_t k = 0; k < count; ++k) a[k] = -a[k];
}

/// Do whole patches roll at a time?
bool rolls_by_region(const SurfaceModel& model, const WheelOnRail& in);

/// Tractions of the strips, cold. `fields`: over the cells, or without pointers.
Fault solve_tractions(const SurfaceModel& model, const WheelOnRail& in, const ContactStrips& strips,
                      bool backwards, const RollingScratch& scratch,
                      const tangential::TangentialFields& fields, const SurfaceRollingForces& forces);

/// The same under friction over temperature, `speed` that of rolling [m/s], from scratch.cold_friction;
/// leaves the hot coefficients in the strips. `more`: number of further fixed-point iterations, from
/// scratch.heat_share on; 0: all, from the start.
Fault solve_heated_tractions(const SurfaceModel& model, const WheelOnRail& in, const ContactStrips& strips,
                             bool backwards, double speed, const RollingScratch& scratch,
                             const SurfaceRollingForces& forces, int more = 0);

/// A step of strips that remember: speed of rolling, speed that slips are over [m/s], time since the
/// committed step [s], and where its tractions go.
struct RememberedStep {
  double rolling_speed, divisor, time;
  tangential::PastStrip* written;
};

/// Counts the scratch of solve_remembered_tractions().
void count_remembered_tractions(Arena& arena, const WorkSizes& sizes);

/// Forces of strips that remember at the end of the step, with friction as it is.
RememberingResult solve_remembered_tractions(const WheelProblem& problem, const Overlaps& overlaps,
                                             const ContactStrips& strips, const RememberedStep& step,
                                             Arena arena, const SurfaceRollingForces& forces);

/// Forces and power of the strips, with slips over the reference's divisor: those of their own direction of
/// rolling, and near standstill of both, blended. Of a model that remembers those at the end of the step.
Fault roll_strips(const WheelProblem& problem, const Overlaps& overlaps, const ContactStrips& strips,
                  double rolling_speed, const geometry::RollingReference& reference, Arena arena);

}  // namespace wrc::surface
