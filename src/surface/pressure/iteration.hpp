/// The iteration of a pressure solve: a fixed-point map of lengths and shifts, preconditioned, accelerated by
/// Anderson's method, and kept from running away.
#pragma once

#include "base/number.hpp"
#include "surface/pressure/active_set.hpp"
#include "surface/pressure/pressure.hpp"
#include "surface/pressure/pressure_scratch.hpp"

namespace wrc::surface {

inline constexpr double any_change = 1e300;  ///< for `farthest` and `in_contact`

/// Strips that the limit over strips in contact counts, for at most four times the usual work of so many
/// strips. Five count as 1.25 times as many, so that they may take 1.5 times the iterations, ten as 1.15
/// times. Many, whose start is better, count as 0.92 times, for 0.85 times the iterations.
inline double budgeted_in_contact(double strips) {
  constexpr double many = 18.0;
  const double few = smaller(1.3 * strips - 0.27, 1.05 * strips + 1.0);
  return smaller(few, larger(0.92 * strips, many));
}

inline constexpr std::int32_t usual_iterations = 30;  ///< in which nearly every solve ends

/// Where iterations end.
struct IterationLimits {
  double tolerance;  ///< part of the area that the last one moves
  double farthest;   ///< part that the first one may move; beyond it is the last, without a solution
  double max_work;   ///< that w.work may reach (PressureOptions)
  double in_contact = any_change;  ///< the same in iterations over the strips in contact
  std::int32_t most = usual_iterations;
};

/// Iterates from the lengths and shifts in `s`; the solution stands in `s`, or the iterate that the map moves
/// least.
PressureResult iterate(const PressureProblem& problem, StripSet& s, const IterationLimits& limits,
                       PressureScratch& w);

/// Evaluates the fixed-point map at the lengths and shifts in `s`: w.residual and w.change; `asked` as in
/// solve_contact(). No strip is active after it where none overlaps.
void evaluate(const PressureProblem& problem, const StripSet& s, Asked asked, PressureScratch& w);

/// Preconditioner: turns the fixed-point residual in `step`, L and then shifts, into a step near that of
/// Newton's method.
void precondition(const StripSet& s, double* step, PressureScratch& w);

/// Sum of a_i b_i, in eight parts, which compilers turn into vectors of any width with the same bits.
double product(std::int32_t n, const double* a, const double* b);

/// Makes `s` and `w` ready for evaluate(), as iterate() does.
void begin_iterations(StripSet& s, PressureScratch& w);

}  // namespace wrc::surface
