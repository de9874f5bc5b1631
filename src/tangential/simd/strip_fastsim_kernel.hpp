/// Strip FASTSIM for packs of strips, and its derivatives with respect to the creepages: the march over the
/// cells of a group. Its parts: the strips' numbers in strip_fastsim_start.hpp, the first stick zone in
/// strip_fastsim_stick.hpp, a step in strip_fastsim_step.hpp, derivatives in strip_fastsim_slopes.hpp, fields
/// in strip_fastsim_fields.hpp.
///
/// As in march_kernel.hpp all is relative: t and u = 2 - t to the half length, x = 1 - t; tractions of the
/// march to the parabolic bound at the strip's middle, which makes that bound u t in every strip. rho is the
/// traction over the bound, of the march and of the result alike.
///
///     symbol (theory.md)         here                        unit
///     v, u, u_s                  t, u, slip_end              half lengths
///     (kappa, lambda), psi_k     kappa, lambda, psi          -
///     p / tau                    rho_x, rho_y                -
///     sqrt(1 - u_s / u)          StickShape::s               -
///     w                          wx, wy + spin x             -
#pragma once

#include "base/pack.hpp"
#include "tangential/simd/march_groups.hpp"
#include "tangential/simd/strip_fastsim_fields.hpp"
#include "tangential/simd/strip_fastsim_slopes.hpp"
#include "tangential/simd/strip_fastsim_start.hpp"
#include "tangential/simd/strip_fastsim_step.hpp"
#include "tangential/simd/strip_fastsim_stick.hpp"
#include "tangential/simd/strip_group.hpp"
#include "tangential/simd/tasks.hpp"

namespace wrc::simd {
namespace {

namespace strip {

/// A group of strips during the march.
struct Marching {
  Group group;
  State state;
  StickSums stick;
  Sums sums;
  SlipShape slip;  ///< for fields
};

/// The part of a cell behind the turn: rest of the step, derivatives, fields.
template <bool entering, Output output>
WRC_IN_LOOP void settle(const StripFastsimMarch& task, const Cell& cell, Mask moves, MarchStep& step,
                        Marching& m, Derivative (&derivative)[inputs]) {
  constexpr bool sensitivities = output == Output::sensitivities;
  [[maybe_unused]] State before;
  if constexpr (sensitivities) before = m.state;
  // the march's step; strips whose first stick zone reaches into the cell have that part of the closed form
  if constexpr (entering) step.shape = stick_shape<sensitivities>(m.group, cell, m.stick);
  end_step<entering>(m.group, cell, moves, step, m.state, m.sums);
  if constexpr (sensitivities)
    differentiate<entering>(m.group, cell, moves, before, m.state, step, derivative);
  [[maybe_unused]] StickCell stuck;
  if constexpr (entering)
    stuck = stick<true, sensitivities>(m.group, cell, moves, step.shape, output == Output::fields, m.stick,
                                       m.sums, derivative);
  if constexpr (output == Output::fields) {
    // Slip against the traction of the march, or where a strip has not left its first stick zone, against
    // that at which its slip begins.
    CellFields f{step.x, step.y, m.state.x(), m.state.y(), {}};
    if constexpr (entering)
      f = {select(moves, f.rho_x, stuck.x),
           select(moves, f.rho_y, stuck.y),
           select(moves, f.x, m.slip.kappa),
           select(moves, f.y, m.slip.lambda),
           {}};
    f.slip = slip_size(m.group, m.slip, cell, f.x, f.y);
    if (step.any_sticks) f.slip = select(step.stick, 0.0, f.slip);
    store_cell(task, m.group, cell, f, m.sums);
  }
}

/// A cell in the first stick zones of all strips of a group.
template <Output output>
WRC_IN_LOOP void stay(const StripFastsimMarch& task, const Cell& cell, Marching& m,
                      Derivative (&derivative)[inputs]) {
  constexpr bool fields = output == Output::fields, sensitivities = output == Output::sensitivities;
  const Mask none = Pack(0.0) < Pack(0.0);
  const StickShape shape = stick_shape<sensitivities>(m.group, cell, m.stick);
  const StickCell stuck =
      stick<false, sensitivities>(m.group, cell, none, shape, fields, m.stick, m.sums, derivative);
  if constexpr (fields) {
    CellFields f{stuck.x, stuck.y, m.slip.kappa, m.slip.lambda, 0.0};
    // no slip before the pair of cells in which a strip's slip begins
    const double end_of_pair = (cell.index & 1) == 0 ? cell.t + cell.h : cell.t;
    if (any(m.slip.stick < end_of_pair)) f.slip = slip_size(m.group, m.slip, cell, f.x, f.y);
    store_cell(task, m.group, cell, f, m.sums);
  }
}

/// Power by the balance -(Fx nu_x + Fy nu_y + Mz phi) [N].
inline double balance_of_power(const StripFastsimTask& task, const simd::Sums& total) {
  const double balance = -(total.fx * task.nu_x + total.fy * task.nu_y + total.mz * task.phi);
  return balance > 0.0 ? balance : 0.0;
}

/// Adds a group's strips to the sums.
inline void finish(const StripFastsimTask& task, const Marching& m, simd::Sums& total) {
  add_forces(m.group, task.cells, m.sums.force, total);
  add_power(m.group, task.cells, m.sums.unslid, m.group.cell * m.sums.power, total);
}

/// The same where strips have axes of their own: their forces are stored, and the balance of power is summed.
inline void finish(const SurfaceStripsTask& task, const Marching& m, simd::Sums& total) {
  store_forces(m.group, task.cells, m.sums.force, task.fx, task.fy, task.mz);
  add_power(m.group, task.cells, m.sums.unslid, m.group.cell * m.sums.power, total);
}

/// Its balance of power.
inline double balance_of_power(const SurfaceStripsTask& task, const simd::Sums&) {
  double balance = 0.0;
  for (std::int32_t j = 0; j < task.strips; ++j)
    balance -= task.fx[j] * task.rigid_x[j] + task.fy[j] * task.rigid_y[j] + task.mz[j] * task.spin[j];
  return balance > 0.0 ? balance : 0.0;
}

/// Cell i of all strips.
inline Cell cell_of(const StripFastsimMarch& task, std::int32_t i) {
  // The bound of the cell before is computed again: a strip's bits must not depend on the cell at which the
  // march of its group began.
  const double h = 2.0 / task.cells, per_h = 0.5 * task.cells;
  const double t = (i + 0.5) * h, behind = task.cells - i - 1.0, shape = t * (2.0 - t);
  const double t_before = (i - 0.5) * h;
  return {i, t,     1.0 - t, t_before * (2.0 - t_before), shape, task.shape->mean[i],
          h, per_h, behind,  task.inverse_weight[i]};
}

/// The parts of march_groups() that are strip FASTSIM's own.
template <Output output, class Task>
struct March {
  using Marching = strip::Marching;
  using Derivative = strip::Derivative;
  static constexpr std::int32_t inputs = simd::inputs, in_flight = simd::in_flight;
  static constexpr bool stays = true;
  static constexpr bool sensitivities = output == Output::sensitivities;

  const Task& task;
  simd::Sums& total;

  void prepare(std::int32_t at, std::int32_t count, Marching& m, Derivative (&derivative)[inputs]) const {
    strip::prepare(task, at, count, m.group, m.state);
    m.stick = first_stick_sums(task, m.group);
    m.sums = {};
    if constexpr (output == Output::fields) m.slip = slip_shape(task, m.group);
    if constexpr (sensitivities) differentiate(task, m.group, derivative);
  }
  Cell cell(std::int32_t i) const { return cell_of(task, i); }
  void stay(const Cell& cell, Marching& m, Derivative (&derivative)[inputs]) const {
    strip::stay<output>(task, cell, m, derivative);
  }
  void finish(Marching& m, Derivative (&derivative)[inputs]) const {
    add_stick(m.group, m.stick, m.sums);
    strip::finish(task, m, total);
    if constexpr (sensitivities) {
      for (std::int32_t n = 0; n < inputs; ++n) {
        add_stick_derivative(m.group, m.stick, derivative[n]);
        add_derivative(m.group, task.cells, derivative[n].force, n, total);
      }
    }
  }
};

}  // namespace strip

template <Output output, class Task>
void strip_fastsim_kernel(const Task& task, Sums& total) {
  total = {};
  // fields have the distribution of slip; the balance of forces and creepages gives its size
  march_groups<output>(task, strip::March<output, Task>{task, total});
  const double power = strip::balance_of_power(task, total);
  if constexpr (output == Output::fields)
    strip::scale_slip(task, total.power_per_speed > 0.0 ? power / total.power_per_speed : 0.0);
  total.power_per_speed = power;
}

}  // namespace
}  // namespace wrc::simd
