/// The iteration of a pressure solve: a fixed-point map of lengths and shifts, preconditioned, accelerated by
/// Anderson's method, and kept from running away.
#pragma once

#include "base/number.hpp"
#include "surface/pressure/active_set.hpp"
#include "surface/pressure/pressure.hpp"
#include "surface/pressure/pressure_scratch.hpp"

namespace wrc::surface {

inline constexpr double any_change = 1e300;  ///< for `farthest` and `in_contact`

/// Work of so many iterations over strips in contact, times a factor by their number, for at most four times
/// the usual work of so many strips. `iterations`: any_change for no limit.
inline double work_in_contact(std::int32_t strips, double iterations) {
  const double few = strips < 5 ? 0.3 * strips + 3.2 : strips + 0.5;
  const double many = larger(0.91 * strips, 1.2 * strips - 12.0);
  const double counted = smaller(few, larger(many, 17.0));
  return iterations * 2.0 * counted * counted;
}

inline constexpr std::int32_t usual_iterations = 30;  ///< in which nearly every solve ends

/// Where iterations end.
struct IterationLimits {
  double tolerance;  ///< part of the area that the last one moves
  double farthest;   ///< part that the first one may move; beyond it is the last, without a solution
  double max_work;   ///< that w.work may reach (PressureOptions)
  double in_contact = any_change;  ///< the same in iterations over the strips in contact
  std::int32_t most = usual_iterations;
  bool accelerated = true;
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

/// Strips in contact at an iterate of `s`.
std::int32_t strips_of(const Iterate& iterate, const StripSet& s);

/// Sum of a_i b_i, in eight parts, which compilers turn into vectors of any width with the same bits.
double product(std::int32_t n, const double* a, const double* b);

/// Makes `s` and `w` ready for evaluate(), as iterate() does.
void begin_iterations(StripSet& s, PressureScratch& w);

}  // namespace wrc::surface
