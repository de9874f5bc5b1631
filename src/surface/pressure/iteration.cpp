#include "surface/pressure/iteration.hpp"

#include <algorithm>

#include "base/number.hpp"
#include "surface/pressure/edge_condition.hpp"
#include "surface/pressure/smoothing.hpp"

namespace wrc::surface {
namespace {

/// Preconditioner (precondition()). smooth_reach: over mean half length, the reach above which a residual is
/// smooth; length_slope, narrow_slope: part of a rough error in L that the map takes away, on strips longer
/// than wide, and the addition on short ones; smooth_length_part: part of the residual's smooth part
/// that is left out; shift_step: factor on shifts.
constexpr double smooth_reach = 0.45;
constexpr double length_slope = 0.47, narrow_slope = 0.3, smooth_length_part = 0.43;
constexpr double shift_step = 1.2;

/// Safeguard (limited()). A strip whose L the map changes by more than the part `settled` follows the map, at
/// most `farthest_step` times as far: where lobes meet or a strip at a rim grows, the residual has minima
/// that are no solutions, to which the acceleration leads and from which the map leads away.
constexpr double settled = 0.05, farthest_step = 4.0;
constexpr std::int32_t early_iterations = 6;  ///< in which L changes at most by these factors
constexpr double early_shrinking = 0.1, early_growth = 10.0;

/// Iterations that find no solution by then are late. A strip's move that changes its sign from one to the
/// next is no longer enforced: the length asked for lies between.
constexpr std::int32_t late_iterations = 20;

constexpr double asked_from = 1e-3;  ///< part of the area whose move lets strips enter
constexpr double hardly_less = 0.7;  ///< part of the last move from which on acceleration does not pay
/// Power of L that q follows over the last step: that of L growing alike on all strips, by derivatives at
/// solutions. Rough steps have 0.48, whose sum over the strips hardly matters.
constexpr double load_follows = 0.22;

/// Solves the equations of Anderson's method in place: symmetric, positive, `n` of them at most `history`.
void solve_small(std::int32_t n, double (&a)[history][history], double (&b)[history]) {
  // Pivots in order: the equations' diagonal is positive.
  for (std::int32_t k = 0; k < n; ++k)
    for (std::int32_t i = k + 1; i < n; ++i) {
      const double f = a[i][k] / a[k][k];
      for (std::int32_t c = k; c < n; ++c) a[i][c] -= f * a[k][c];
      b[i] -= f * b[k];
    }
  // Back substitution.
  for (std::int32_t k = n - 1; k >= 0; --k) {
    for (std::int32_t c = k + 1; c < n; ++c) b[k] -= a[k][c] * b[c];
    b[k] /= a[k][k];
  }
}

/// Elimination of tridiagonal equations (R + coupled + next) v - coupled v_before - next v_next = f, strip by
/// strip one way.
struct WayOfElimination {
  double coupled = 0.0, v = 0.0;  ///< coefficient to the strip before, and its element
  double held = 0.0;              ///< rest of that coefficient on the diagonal, behind the elimination

  double pull() const { return coupled * v; }
  void eliminate(double R, double f, double next, double& upper, double& element) {
    const double alone = R + held, inverse = 1.0 / (alone + next);
    upper = next * inverse;
    element = v = (f + pull()) * inverse;
    held = next * alone * inverse;
    coupled = next;
  }
};

/// Smooth part R v of the moves f in `lengths`, along each run of active strips: v in w.smooth_part, R in
/// w.rim_weight.
void find_smooth_part(const double* lengths, PressureScratch& w) {
  const ActiveStrips& active = w.active;
  const std::int32_t n = active.count;
  // R v - reach^2 (R v')' = f,   R = l^1.5, which vanishes towards the rims as errors do.
  double mean = 0.0;  // L [m^2]
  for (std::int32_t a = 0; a < n; ++a) {
    const double l = active.half_length[a];
    mean += l * l;
    w.rim_weight[a] = l * root(l);
  }
  const double reach2 = smooth_reach * smooth_reach * mean / n;  // [m^2]
  // Coupling of a strip to the one behind.
  const auto coupling = [&](std::int32_t a) {
    return reach2 * smaller(w.rim_weight[a], w.rim_weight[a + 1]) * active.per_apart_squared[a];
  };
  // Tridiagonal equations: elimination from both ends, as each division waits for the one before.
  WayOfElimination up, down;
  const std::int32_t middle = n / 2;
  const auto eliminate = [&](WayOfElimination& way, std::int32_t a, double next) {
    way.eliminate(w.rim_weight[a], lengths[active.index[a]], next, w.upper[a], w.smooth_part[a]);
  };
  for (std::int32_t a = 0, b = n - 1; a < middle; ++a, --b) {
    eliminate(up, a, coupling(a));
    if (b > middle) eliminate(down, b, coupling(b - 1));
  }
  w.smooth_part[middle] = (lengths[active.index[middle]] + up.pull() + down.pull()) /
                          (w.rim_weight[middle] + up.held + down.held);
  // Back substitution.
  for (std::int32_t a = middle - 1, b = middle + 1; a >= 0; --a, ++b) {
    w.smooth_part[a] += w.upper[a] * w.smooth_part[a + 1];
    if (b < n) w.smooth_part[b] += w.upper[b] * w.smooth_part[b - 1];
  }
}

/// Index in the ring buffer of the iterate `ago` iterations back.
std::int32_t slot_of(std::int32_t iteration, std::int32_t ago) { return (iteration - ago) % (history + 1); }

/// The part of the area that the map moves the present iterate by.
double moved_part(const PressureScratch& w) { return w.change.moved / w.change.area; }

/// Keeps the present iterate, its loads and its preconditioned step.
void remember(const StripSet& s, std::int32_t iteration, PressureScratch& w) {
  const std::int32_t n = s.count;
  Iterate& now = w.iterate[slot_of(iteration, 0)];
  std::copy_n(s.L, n, now.x);
  std::copy_n(s.shift, n, now.x + n);
  std::copy_n(s.q, n, now.q);
  now.moved = moved_part(w);
  std::copy_n(w.residual, 2 * n, now.f);
  precondition(s, now.f, w);
}

/// The iterate that a cap returns: of the last ones that the map moves least, or of those with as many strips
/// in contact as the work was allowed for, if there are any.
const Iterate& best_of(const StripSet& s, std::int32_t iterations, const IterationLimits& limits,
                       const PressureScratch& w) {
  const std::int32_t kept = std::min(iterations, history + 1);
  const Iterate* best = &w.iterate[slot_of(iterations, 1)];
  for (std::int32_t ago = 2; ago <= kept; ++ago) {
    const Iterate& earlier = w.iterate[slot_of(iterations, ago)];
    if (earlier.moved < best->moved) best = &earlier;
  }
  const auto allowed = [&](const Iterate& each) {
    return w.work <= work_in_contact(strips_of(each, s), limits.in_contact);
  };
  // Few strips may have taken the work of many: then an iterate on many is returned.
  if (allowed(*best)) return *best;
  const Iterate* other = nullptr;
  for (std::int32_t ago = 1; ago <= kept; ++ago) {
    const Iterate& earlier = w.iterate[slot_of(iterations, ago)];
    if (allowed(earlier) && (!other || earlier.moved < other->moved)) other = &earlier;
  }
  return other ? *other : *best;
}

/// Goes back to that iterate.
void take_best(const StripSet& s, const Iterate& best, PressureResult& result, PressureScratch& w) {
  const std::int32_t n = s.count;
  std::copy_n(best.x, n, s.L);
  std::copy_n(best.x + n, n, s.shift);
  std::copy_n(best.q, n, s.q);
  for (std::int32_t i = 0; i < n; ++i) {
    // A strip that entered in that iteration has a load and no length yet: its least length.
    const double least = least_half_length * s.width[i];
    w.in_contact[i] = s.q[i] > 0.0;
    if (w.in_contact[i]) s.L[i] = larger(s.L[i], least * least);
  }
  result.residual = best.moved;
  result.strips = strips_of(best, s);
}

/// Anderson's acceleration, into w.next: combines the last `used` iterates so that the step becomes smallest.
/// Shifts [m] weigh as L [m^2] by the root of `shift_weight`.
void accelerate(const StripSet& s, double shift_weight, std::int32_t iteration, std::int32_t used,
                PressureScratch& w) {
  // next = x + f - sum_a g_a ((x - x_a) + (f - f_a)),   g = argmin |f - sum_a g_a (f - f_a)|
  const std::int32_t n = s.count, unknowns = s.skewed ? 2 * n : n;
  const auto slot = [iteration](std::int32_t a) { return slot_of(iteration, a); };
  const std::int32_t now = slot(0);
  const double *const x = w.iterate[now].x, *const f = w.iterate[now].f;
  for (std::int32_t i = 0; i < unknowns; ++i) w.next[i] = x[i] + f[i];
  // Products of the new step with all that are used; those of earlier ones with each other are known.
  for (std::int32_t a = 0; a <= used; ++a) {
    const double* const other = w.iterate[slot(a)].f;
    w.products[now][slot(a)] = w.products[slot(a)][now] =
        product(n, f, other) + (s.skewed ? shift_weight * product(n, f + n, other + n) : 0.0);
  }
  if (used == 0) return;
  // Normal equations of the least squares: G_ab = (f - f_a) . (f - f_b), right-hand side f . (f - f_a).
  double G[history][history], g[history];
  const double* const own = w.products[now];
  for (std::int32_t a = 0; a < used; ++a) {
    const std::int32_t k = slot(a + 1);
    g[a] = own[now] - own[k];
    for (std::int32_t b = 0; b <= a; ++b)
      G[a][b] = G[b][a] = g[a] - own[slot(b + 1)] + w.products[k][slot(b + 1)];
  }
  // A little more on the diagonal: steps become parallel as they get small.
  for (std::int32_t a = 0; a < used; ++a) G[a][a] = G[a][a] * (1.0 + 1e-10) + 1e-300;
  solve_small(used, G, g);
  // Shares are kept: the last step mixes loads by them (extrapolate_loads()).
  std::copy_n(g, used, w.shares);
  for (std::int32_t a = 0; a < used; ++a) {
    const Iterate& earlier = w.iterate[slot(a + 1)];
    for (std::int32_t i = 0; i < unknowns; ++i)
      w.next[i] -= g[a] * ((x[i] - earlier.x[i]) + (f[i] - earlier.f[i]));
  }
}

/// Does the accelerated step lead farther than the preconditioned one should? Few strips may leave the least
/// squares nothing to choose from, where earlier steps are nearly parallel.
bool leads_astray(std::int32_t iteration, const PressureScratch& w) {
  const Iterate& now = w.iterate[slot_of(iteration, 0)];
  double accelerated = 0.0, alone = 0.0;
  for (std::int32_t a = 0; a < w.active.count; ++a) {
    const std::int32_t i = w.active.index[a];
    accelerated += magnitude(w.next[i] - now.x[i]);
    alone += magnitude(now.f[i]);
  }
  return accelerated > farthest_step * alone;
}

/// Extrapolates q over the last step, after which the contact condition is not solved again: q is mixed from
/// iterates as L is, and follows the part of L left to go with the power load_follows.
void extrapolate_loads(const StripSet& s, std::int32_t iteration, std::int32_t used, PressureScratch& w) {
  const Iterate& now = w.iterate[slot_of(iteration, 0)];
  for (std::int32_t i = 0; i < s.count; ++i) {
    if (!(s.L[i] > 0.0)) continue;
    // q and the step at the mixed iterate.
    double q = s.q[i], step = now.f[i];
    for (std::int32_t a = 0; a < used; ++a) {
      const Iterate& earlier = w.iterate[slot_of(iteration, a + 1)];
      q -= w.shares[a] * (s.q[i] - earlier.q[i]);
      step -= w.shares[a] * (now.f[i] - earlier.f[i]);
    }
    // q ~ L^load_follows along the rest of the step.
    const double part = smaller(larger(step / s.L[i], -settled), settled);
    s.q[i] = larger(q * (1.0 + load_follows * part), 0.0);
  }
}

/// Safeguard: the accelerated length `next` of a strip with length `old` and residual f, all squared, kept
/// near that of the plain map, old + f. `before`: the residual of the iteration before.
double limited(double next, double old, double f, double before, std::int32_t iteration) {
  const double plain = old + f;
  if (!(plain > 0.0)) return 0.0;
  // The map overshoots: its solution lies between both lengths.
  if (iteration > late_iterations && f * before < 0.0 && magnitude(f) > settled * old)
    return smaller(larger(next, smaller(old, plain)), larger(old, plain));
  // At most twice or half of the plain one: without, strips that enter hold up the rest.
  next = smaller(larger(next, 0.5 * plain), 2.0 * plain);
  // Strips that move much go the map's way, between the plain step and farthest_step times that.
  if (next > 0.0 && magnitude(f) > settled * old) {
    const double far = old + farthest_step * f;
    next =
        f > 0.0 ? smaller(larger(next, plain), far) : larger(smaller(larger(next, far), plain), 0.5 * plain);
  }
  // The first iterations may be far off: no strip grows or shrinks by more than ten times.
  if (old > 0.0 && next > 0.0 && iteration < early_iterations)
    next = smaller(larger(next, early_shrinking * old), early_growth * old);
  return next;
}

/// Moves L and the shifts to the accelerated iterate, strip by strip within the safeguard.
void take_step(const StripSet& s, std::int32_t iteration, PressureScratch& w) {
  const double* const shift = w.next + s.count;
  for (std::int32_t i = 0; i < s.count; ++i) {
    s.L[i] = limited(w.next[i], s.L[i], w.residual[i], w.residual_before[i], iteration);
    w.residual_before[i] = w.residual[i];
    if (s.skewed) s.shift[i] = smaller(larger(shift[i], -longest_shift), longest_shift);
  }
}

/// Clears strips that are not in contact.
void finish(const StripSet& s, const PressureScratch& w) {
  for (std::int32_t i = 0; i < s.count; ++i)
    if (w.active.count == 0 || !w.in_contact[i] || !(s.L[i] > 0.0)) s.L[i] = s.q[i] = 0.0;
}

}  // namespace

std::int32_t strips_of(const Iterate& iterate, const StripSet& s) {
  return static_cast<std::int32_t>(
      std::count_if(iterate.q, iterate.q + s.count, [](double q) { return q > 0.0; }));
}

double product(std::int32_t n, const double* a, const double* b) {
  constexpr std::int32_t parts = 8;
  double part[parts] = {};
  std::int32_t i = 0;
  for (; i + parts <= n; i += parts)
    for (std::int32_t k = 0; k < parts; ++k) part[k] += a[i + k] * b[i + k];
  for (std::int32_t k = 0; i < n; ++i, ++k) part[k] += a[i] * b[i];
  return ((part[0] + part[4]) + (part[2] + part[6])) + ((part[1] + part[5]) + (part[3] + part[7]));
}

void precondition(const StripSet& s, double* step, PressureScratch& w) {
  // The map takes away 0.45 of an error of L that is rough along the rail, more on strips shorter than wide,
  // and 0.9 of a smooth one, whatever the contact. So the step is (f - 0.43 R v) / 0.47, which leaves 0.05 to
  // 0.2 of an error.
  double *const lengths = step, *const shifts = step + s.count;
  find_smooth_part(lengths, w);
  // The slope is 0.47 + 0.3 h / (1 + h), h = w / (2 l): the map takes away more on strips shorter than wide.
  for (std::int32_t a = 0; a < w.active.count; ++a) {
    const std::int32_t i = w.active.index[a];
    const double h = w.active.half_width[a], smooth = w.rim_weight[a] * w.smooth_part[a];
    lengths[i] = (lengths[i] - smooth_length_part * smooth) * (1.0 + h) /
                 (length_slope + (length_slope + narrow_slope) * h);
  }
  // Shifts lie on lines, and the map takes away most of an error of theirs whatever its shape: one factor,
  // with which the fewest iterations are needed under yawed flanges.
  if (s.skewed)
    for (std::int32_t i = 0; i < s.count; ++i) shifts[i] *= shift_step;
}

void begin_iterations(StripSet& s, PressureScratch& w) {
  // Without yaw all overlaps are deepest at one x, and shifts are 0.
  s.skewed = false;
  for (std::int32_t i = 1; i < s.count; ++i) s.skewed = s.skewed || s.deepest_x[i] != s.deepest_x[0];
  for (std::int32_t i = 0; i < s.count; ++i) w.in_contact[i] = s.L[i] > 0.0;
  std::fill_n(w.continued, s.count, 0.0);
  w.active.count = 0;
  if (s.skewed) {
    std::fill(w.inverse_reach + s.count, w.inverse_reach + simd::whole_packs(s.count), 0.0);
    for (std::int32_t i = 0; i < s.count; ++i) w.inverse_reach[i] = 1.0 / shift_reach(s.width[i]);
  } else {
    std::fill_n(s.shift, s.count, 0.0);  // no unknowns now; a start may bring others
  }
}

void evaluate(const PressureProblem& problem, const StripSet& s, Asked asked, PressureScratch& w) {
  // A strip that enters has L = 0 but a place: its half length counts as a small part of its width.
  for (std::int32_t i = 0; i < s.count; ++i) {
    const double least = least_half_length * s.width[i];
    w.half_length[i] = root(larger(s.L[i], least * least));
  }
  solve_contact(problem, s, asked, w);
  if (w.active.count == 0) return;
  edge_residual(problem, s, w);
  // Size of the move beside the sum of w L, both [m^3]; a shift counts times l.
  w.change = {0.0, 0.0};
  const double *const f = w.residual, *const f_shift = w.residual + s.count;
  for (std::int32_t i = 0; i < s.count; ++i) {
    w.change.moved += s.width[i] * (magnitude(f[i]) + magnitude(f_shift[i]) * w.half_length[i]);
    w.change.area += s.width[i] * (s.L[i] + f[i]);
  }
}

PressureResult iterate(const PressureProblem& problem, StripSet& s, const IterationLimits& limits,
                       PressureScratch& w) {
  PressureResult result;
  begin_iterations(s, w);
  w.max_work = limits.max_work;
  std::int32_t remembered = 0, slow = 0;  // iterates to combine; iterations in a row that hardly gained
  double moved_before = any_change, shift_weight = 0.0;
  // Work after one more iteration, against the limits on all work and over the strips in contact: those of
  // the present iterate, or of the one that a cap would return if it has fewer.
  const auto affordable = [&](std::int32_t k) {
    if (k == 0) return true;
    const double next = w.work + 2.0 * work_of_pass(w.active.count);
    w.max_work = limits.max_work;
    // Work that any number of strips may take needs no count of them.
    if (next > work_in_contact(1, limits.in_contact)) {
      const std::int32_t strips = std::min(w.active.count, strips_of(best_of(s, k, limits, w), s));
      w.max_work = smaller(limits.max_work, work_in_contact(strips, limits.in_contact));
    }
    return k < limits.most && next <= w.max_work;
  };
  std::int32_t k = 0;
  for (; affordable(k); ++k) {
    ++result.iterations;
    // Active set, edges, residual f. Far strips are asked whether they enter at the beginning and at the end,
    // those beside contact while the solution moves much.
    const bool moves = moved_before > asked_from * w.change.area;
    const Asked asked = k == 0 ? Asked::all : moves ? Asked::beside : Asked::none;
    evaluate(problem, s, asked, w);
    if (w.active.count == 0) break;
    const auto [moved, area] = w.change;
    result.converged =
        moved <= limits.tolerance * area && (asked == Asked::all || !activate(problem, s, Asked::all, w));
    if (k == 0 && moved > limits.farthest * area) {
      result.strips = w.active.count;
      return result;
    }

    // Acceleration from scratch where it does not pay twice in a row, as while strips enter.
    slow = moved > hardly_less * moved_before ? slow + 1 : 0;
    if (slow == 2) remembered = slow = 0;
    moved_before = moved;

    // Preconditioned and accelerated step. Beside lengths squared [m^4], shifts squared weigh by the mean L.
    remember(s, k, w);
    if (k == 0) shift_weight = area / (s.count * s.width[0]);
    std::int32_t used = limits.accelerated ? std::min(remembered++, history) : 0;
    accelerate(s, shift_weight, k, used, w);
    if (result.converged) {
      // Behind the last step no other one puts it right.
      if (leads_astray(k, w)) accelerate(s, shift_weight, k, used = 0, w);
      extrapolate_loads(s, k, used, w);
    }
    take_step(s, k, w);
    if (result.converged) break;
  }
  if (w.active.count == 0)
    result.converged = true;  // nothing overlaps
  else if (result.converged)
    result.residual = moved_part(w);
  else
    take_best(s, best_of(s, k, limits, w), result, w);
  finish(s, w);
  return result;
}

}  // namespace wrc::surface
