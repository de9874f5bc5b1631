#include "surface/pressure/surface_normal.hpp"

#include <algorithm>
#include <cmath>

#include "base/elementary.hpp"
#include "base/number.hpp"
#include "surface/pressure/surface_means.hpp"
#include "surface/simd/tasks.hpp"

namespace wrc {
namespace {

constexpr std::int32_t history = 5;       ///< earlier sweeps the acceleration looks at
constexpr std::int32_t most_rounds = 20;  ///< of strips entering and leaving within a sweep
constexpr double coarse_tolerance = 0.1;  ///< of the start on pairs of strips
/// How steps follow from what a plain sweep moves (see make_steps). Smooth: over more than this part of the
/// mean half length; shift_step: of shifts.
constexpr double smooth_reach = 0.5;
constexpr double length_slope = 0.45, narrow_slope = 0.5, smooth_length_part = 0.45;
constexpr double shift_step = 1.2;
/// Strips whose squared length a plain sweep changes by more than this part go the way of that sweep,
/// whatever the acceleration says, and at most so many times as far. Where lobes meet or a strip at a rim
/// grows, the residual has minima that are no solutions: there plain sweeps lead on, and the acceleration
/// back.
constexpr double settled = 0.05, farthest_step = 4.0;
/// Power of its squared length that a strip's strength follows where errors of lengths are left, found on
/// random poses: takes away half of what the last step does to strengths.
constexpr double strength_follows = 0.3;
constexpr std::int32_t fewest_pairs = 12;
/// Part of the area that the first sweep from an earlier solution may move, and that it may be moved by
/// before to follow the overlaps; beyond, a start from the overlaps is nearer, and leads to another solution
/// less often where there are two.
constexpr double farthest_start = 0.3, farthest_followed = 0.5;
constexpr double anywhere = 1e300;
/// Parts of the growth of an overlap, in the mean and beside that, that a solution's lengths follow.
constexpr double follows_mean = 0.9, follows_rest = 1.4;

/// StripSet a solve works on: candidates, or pairs of them.
struct StripSet {
  std::int32_t count = 0;
  double *place, *width, *depth, *curvature, *middle, *ny, *nz;  ///< given; middle: x of the largest overlap
  double *L, *shift, *level, *q;                                 ///< solution; the centre is middle + shift
};

struct Scratch {
  StripSet fine, coarse;
  double *matrix, *r, *s;  ///< the elimination's
  /// Rows of all strips over all strips, or over the `paired` first of some that are not one run.
  simd::SurfacePairs pairs;
  std::int32_t paired_count;
  double *place, *centre, *half_length, *inverse_length, *half_width, *width, *factor, *load_factor,
      *strength, *ny, *nz;                             ///< sources
  double *outside_place, *outside_x;                   ///< points that see them
  double *l, *wanted_level, *wanted_shift, *residual;  ///< residual: of L, then of the shifts
  double *load, *inverse_reach;                        ///< of means and lines: of the sources, of all strips
  double *shape, *leading, *smooth_length;             ///< of make_steps
  double *x[history + 1], *f[history + 1], *next;      ///< f: the step that a sweep asks for
  double* strengths[history + 1];                      ///< q at x
  double products[history + 1][history + 1];           ///< of the steps
  double shares[history];                              ///< of earlier sweeps in `next`
  std::int32_t *active, *outside, *paired;
  std::int32_t* in;
};

std::int64_t cut(double* memory, std::int32_t most, Scratch& w) {
  double* at = memory;
  const std::int64_t padded = simd::whole_packs(most) + simd::most_lanes;
  const auto take = [&at](std::int64_t n) {
    double* const here = at;
    at += n;
    return here;
  };
  for (StripSet* s : {&w.fine, &w.coarse})
    for (double** a : {&s->place, &s->width, &s->depth, &s->curvature, &s->middle, &s->ny, &s->nz, &s->L,
                       &s->shift, &s->level, &s->q})
      *a = take(padded);
  const std::int64_t stride = simd::elimination_stride((most + 3) / 4 * 4) + simd::most_lanes;
  w.matrix = take(stride * ((most + 3) / 4 * 4));
  w.r = take(stride);
  w.s = take(stride);
  w.pairs.stride = padded;
  for (double** a : {&w.pairs.axis_place, &w.pairs.cosine, &w.pairs.correction}) *a = take(padded * most);
  for (double** a : {&w.place,
                     &w.centre,
                     &w.half_length,
                     &w.inverse_length,
                     &w.half_width,
                     &w.width,
                     &w.factor,
                     &w.load_factor,
                     &w.strength,
                     &w.ny,
                     &w.nz,
                     &w.outside_place,
                     &w.outside_x,
                     &w.l,
                     &w.wanted_level,
                     &w.wanted_shift,
                     &w.shape,
                     &w.leading,
                     &w.smooth_length,
                     &w.load,
                     &w.inverse_reach})
    *a = take(padded);
  w.residual = take(2 * padded);
  for (double*& a : w.x) a = take(2 * padded);
  for (double*& a : w.f) a = take(2 * padded);
  w.next = take(2 * padded);
  for (double*& a : w.strengths) a = take(padded);
  w.active = reinterpret_cast<std::int32_t*>(take((padded + 1) / 2));
  w.outside = reinterpret_cast<std::int32_t*>(take((padded + 1) / 2));
  w.paired = reinterpret_cast<std::int32_t*>(take((padded + 1) / 2));
  w.in = reinterpret_cast<std::int32_t*>(take((padded + 1) / 2));
  return at - memory;
}

/// What stays the same throughout a solve.
struct Problem {
  const Kernels& kernels;
  simd::SurfaceTables tables;
  double compliance;
};

/// Least squares a sweep of `history` columns leads to: symmetric, positive, small.
void solve_small(std::int32_t n, double (&a)[history][history], double (&b)[history]) {
  for (std::int32_t k = 0; k < n; ++k)
    for (std::int32_t i = k + 1; i < n; ++i) {
      const double f = a[i][k] / a[k][k];
      for (std::int32_t c = k; c < n; ++c) a[i][c] -= f * a[k][c];
      b[i] -= f * b[k];
    }
  for (std::int32_t k = n - 1; k >= 0; --k) {
    for (std::int32_t c = k + 1; c < n; ++c) b[k] -= a[k][c] * b[c];
    b[k] /= a[k][k];
  }
}

/// Overlap where the pressure of a strip has its centre, beside the place of the largest overlap under yaw.
double overlap_at_centre(const StripSet& s, std::int32_t i) {
  return s.depth[i] - 0.5 * s.curvature[i] * s.shift[i] * s.shift[i];
}

simd::SurfaceSources sources_of(std::int32_t kept, const Scratch& w) {
  return {kept, w.place, w.centre, w.inverse_length, w.half_width, w.factor};
}

/// The active strips as sources of unit q.
simd::SurfaceSources list_sources(const Problem& problem, const StripSet& s, std::int32_t kept, Scratch& w) {
  for (std::int32_t a = 0; a < kept; ++a) {
    const std::int32_t i = w.active[a];
    const double inverse = 1.0 / w.l[i];
    w.place[a] = s.place[i];
    w.centre[a] = s.middle[i] + s.shift[i];
    w.half_length[a] = w.l[i];
    w.inverse_length[a] = inverse;
    w.half_width[a] = 0.5 * s.width[i] * inverse;
    w.factor[a] = problem.compliance * s.width[i] * inverse;
  }
  const std::int64_t end = simd::whole_packs(kept);
  for (std::int64_t a = kept; a < end; ++a)
    w.place[a] = w.centre[a] = w.inverse_length[a] = w.half_width[a] = w.factor[a] = w.strength[a] = 0.0;
  return sources_of(kept, w);
}

/// Strips with nothing behind the last.
simd::SurfaceStrips strips_of(std::int32_t count, double* place, double* width, double* ny, double* nz) {
  for (double* a : {place, width, ny, nz})
    std::fill(a + count, a + simd::whole_packs(count) + simd::most_lanes, 0.0);
  return {count, place, width, ny, nz};
}

constexpr std::int32_t all_strips = -1, no_strips = -2;  ///< of Scratch::paired_count

/// Pairs of all strips with the active ones, which stand in `pairs` from sweep to sweep.
simd::SurfacePairs pairs_of(const Problem& problem, const StripSet& s, std::int32_t kept, Scratch& w) {
  const std::int32_t first = w.active[0];
  const bool run = w.active[kept - 1] - first + 1 == kept;
  const bool known = run ? w.paired_count == all_strips
                         : w.paired_count == kept && std::equal(w.active, w.active + kept, w.paired);
  if (!known) {
    const simd::SurfaceStrips all = strips_of(s.count, s.place, s.width, s.ny, s.nz);
    if (run) {
      problem.kernels.surface.pairs(all, all, w.pairs);
    } else {
      for (std::int32_t a = 0; a < kept; ++a) {
        const std::int32_t i = w.paired[a] = w.active[a];
        w.place[a] = s.place[i];
        w.width[a] = s.width[i];
        w.ny[a] = s.ny[i];
        w.nz[a] = s.nz[i];
      }
      problem.kernels.surface.pairs(all, strips_of(kept, w.place, w.width, w.ny, w.nz), w.pairs);
    }
    w.paired_count = run ? all_strips : kept;
  }
  const std::int64_t at = run ? first : 0;
  return {w.pairs.axis_place + at, w.pairs.cosine + at, w.pairs.correction + at, w.pairs.stride};
}

/// Strips that would overlap under the strengths in w.r enter: those next to contact, or everywhere. Returns
/// whether there are any. Nothing presses where there is no overlap: displacements are never negative.
bool admit(const Problem& problem, const StripSet& s, const simd::SurfaceSources& sources, bool skewed,
           bool everywhere, Scratch& w) {
  std::int32_t count = 0;
  for (std::int32_t i = 0; i < s.count; ++i) {
    if (w.in[i] || !(overlap_at_centre(s, i) > 0.0)) continue;
    if (!everywhere && !(i > 0 && w.in[i - 1]) && !(i + 1 < s.count && w.in[i + 1])) continue;
    w.outside[count] = i;
    w.outside_place[count] = s.place[i];
    w.outside_x[count++] = s.middle[i] + s.shift[i];
  }
  if (count == 0) return false;
  const std::int64_t stride = simd::whole_packs(sources.count);
  problem.kernels.surface.influence(problem.tables, sources, pairs_of(problem, s, sources.count, w),
                                    {count, w.outside, w.outside_place, w.outside_x}, skewed, w.matrix,
                                    stride);
  bool any = false;
  for (std::int32_t b = 0; b < count; ++b) {
    const std::int32_t i = w.outside[b];
    const double* const row = w.matrix + b * stride;
    double u = 0.0;
    for (std::int32_t a = 0; a < sources.count; ++a) u += row[a] * w.r[a];
    if (u < overlap_at_centre(s, i) * (1.0 - 1e-12)) {
      w.in[i] = 1;
      any = true;
    }
  }
  return any;
}

/// Solves the contact condition at the present lengths; strips that would pull leave, strips that would
/// overlap enter. Returns how many are in contact, whose q stands in w.r.
/// `everywhere`: look at all strips that are not in contact, else at those next to contact.
std::int32_t solve_contact(const Problem& problem, const StripSet& s, bool skewed, bool everywhere,
                           Scratch& w) {
  std::int32_t kept = 0;
  for (std::int32_t round = 0; round < most_rounds; ++round) {
    kept = 0;
    for (std::int32_t i = 0; i < s.count; ++i)
      if (w.in[i]) w.active[kept++] = i;
    if (kept == 0) {
      std::int32_t deepest = 0;
      for (std::int32_t i = 1; i < s.count; ++i)
        if (s.depth[i] > s.depth[deepest]) deepest = i;
      if (!(s.depth[deepest] > 0.0)) return 0;
      w.in[deepest] = 1;
      continue;
    }
    const simd::SurfaceSources sources = list_sources(problem, s, kept, w);
    const std::int32_t size = (kept + 3) / 4 * 4;
    const std::int64_t stride = simd::elimination_stride(size);
    problem.kernels.surface.influence(problem.tables, sources, pairs_of(problem, s, kept, w),
                                      {kept, w.active, w.place, w.centre}, skewed, w.matrix, stride);
    problem.kernels.surface.own_influence(problem.tables, sources, w.matrix, stride);
    for (std::int32_t a = 0; a < size; ++a) {
      double* const row = w.matrix + a * stride;
      for (std::int64_t c = a < kept ? kept : 0; c < stride; ++c) row[c] = 0.0;
      if (a < kept)
        row[size] = overlap_at_centre(s, w.active[a]);
      else
        row[a] = 1.0;
    }
    problem.kernels.normal.eliminate({size, stride, w.matrix, w.r, w.s});
    bool changed = admit(problem, s, sources, skewed, everywhere, w);
    for (std::int32_t a = 0; a < kept; ++a)
      if (w.r[a] < 0.0) {
        w.in[w.active[a]] = 0;
        changed = true;
      }
    if (!changed) break;
  }
  return kept;
}

/// Levels and centres the edges ask for, smoothed; leaves the residuals of L and of the shifts.
void look_at_edges(const Problem& problem, const StripSet& s, std::int32_t kept, bool skewed, Scratch& w) {
  std::fill_n(s.q, s.count, 0.0);
  for (std::int32_t a = 0; a < kept; ++a) s.q[w.active[a]] = w.strength[a] = larger(w.r[a], 0.0);
  simd::SurfaceSources sources = sources_of(kept, w);
  const std::int64_t end = simd::whole_packs(kept);
  for (std::int64_t a = 0; a < end; ++a) w.load_factor[a] = a < kept ? w.factor[a] * w.strength[a] : 0.0;
  sources.factor = w.load_factor;
  double *const leading = w.wanted_level, *const trailing = skewed ? w.wanted_shift : leading;
  problem.kernels.surface.edges(problem.tables, sources, pairs_of(problem, s, kept, w),
                                {w.active, w.half_length, leading, skewed ? trailing : nullptr});
  for (std::int32_t a = 0; a < kept; ++a) {
    const std::int32_t i = w.active[a];
    const double l = w.l[i], L = l * l;
    const double ahead = leading[a], behind = trailing[a];
    const double drop = overlap_at_centre(s, i) - 0.5 * (ahead + behind);
    const double ratio =
        smaller(larger(drop / (0.5 * s.curvature[i] * L), least_edge_ratio), most_edge_ratio);
    w.wanted_level[a] = w.strength[a] / (L * ratio);
    w.wanted_shift[a] = (behind - ahead) / (2.0 * l * s.curvature[i]);
  }
  double* const residual = w.residual;
  double* const shift_residual = w.residual + s.count;
  for (std::int32_t i = 0; i < s.count; ++i) {
    residual[i] = -s.L[i];
    shift_residual[i] = 0.0;
  }
  // Levels are means over the strips within reach, weighted by their loads.
  for (std::int32_t a = 0; a < kept; ++a) w.load[a] = w.strength[a] * s.width[w.active[a]];
  for (std::int32_t a = 0, from = 0; a < kept; ++a) {
    const std::int32_t i = w.active[a];
    const double reach = level_reach(s.width[i]);
    while (w.place[a] - w.place[from] >= reach) ++from;
    double weights = 0.0, level = 0.0;
    for (std::int32_t b = from; b < kept; ++b) {
      const double t = (w.place[b] - w.place[a]) / reach;
      if (t >= 1.0) break;
      const double weight = smoothing_weight(t) * w.load[b];
      weights += weight;
      level += weight * w.wanted_level[b];
    }
    s.level[i] = weights > 0.0 ? level / weights : w.wanted_level[a];
    if (s.level[i] > 0.0) residual[i] += w.strength[a] / s.level[i];
  }
  if (!skewed) return;
  // Shifts lie on lines; strips that are not in contact have the place they would enter with.
  problem.kernels.surface.near_lines({s.count, s.place, w.inverse_reach, least_line_spread, kept, w.place,
                                      w.load, w.wanted_shift, shift_residual});
  for (std::int32_t i = 0; i < s.count; ++i)
    shift_residual[i] = smaller(larger(shift_residual[i], -longest_shift), longest_shift) - s.shift[i];
}

/// Makes steps of what a plain sweep moves. Such a sweep takes away 0.45 of an error in squared
/// lengths that is rough along the rail, more on strips shorter than wide, and 0.9 of a smooth one. What is
/// smooth, v, is read off the moves f by (v - reach^2 v'') = f along each run of strips, with weights and in
/// a scale that vanish towards the rims, as errors do. Steps so found leave 0.1 to 0.15 of the error; the
/// numbers are fitted to slopes of sweeps at 85 solutions. Of shifts, which lie on lines, a sweep takes away
/// most whatever the error's shape: one factor, with which the fewest sweeps are left under yawed flanges.
void make_steps(const StripSet& s, std::int32_t kept, bool skewed, double* steps, Scratch& w) {
  double *const lengths = steps, *const shifts = steps + s.count;
  double mean = 0.0;
  for (std::int32_t a = 0; a < kept; ++a) {
    const double l = w.half_length[a];
    mean += l * l;
    w.shape[a] = l * root(l);
  }
  const double reach2 = smooth_reach * smooth_reach * mean / kept;
  double coupled = 0.0, length = 0.0;  // to the strip before and of it
  for (std::int32_t a = 0; a < kept; ++a) {
    const std::int32_t i = w.active[a];
    double diagonal = w.shape[a] + coupled, next = 0.0;
    if (a > 0) diagonal -= coupled * w.leading[a - 1];
    if (a + 1 < kept) {
      const std::int32_t j = w.active[a + 1];
      const double apart = s.place[j] - s.place[i];
      if (apart < 0.75 * (s.width[i] + s.width[j]))
        next = reach2 * smaller(w.shape[a], w.shape[a + 1]) / (apart * apart);
    }
    const double inverse = 1.0 / (diagonal + next);
    w.leading[a] = next * inverse;
    w.smooth_length[a] = length = (lengths[i] + coupled * length) * inverse;
    coupled = next;
  }
  for (std::int32_t a = kept - 2; a >= 0; --a) w.smooth_length[a] += w.leading[a] * w.smooth_length[a + 1];
  for (std::int32_t a = 0; a < kept; ++a) {
    const std::int32_t i = w.active[a];
    const double h = w.half_width[a], smooth = w.shape[a] * w.smooth_length[a];
    lengths[i] = (lengths[i] - smooth_length_part * smooth) / (length_slope + narrow_slope * h / (1.0 + h));
  }
  if (skewed)
    for (std::int32_t i = 0; i < s.count; ++i) shifts[i] *= shift_step;
}

/// Sum of a_i b_i, in eight parts.
double product(std::int32_t n, const double* a, const double* b) {
  constexpr std::int32_t parts = 8;
  double part[parts] = {};
  std::int32_t i = 0;
  for (; i + parts <= n; i += parts)
    for (std::int32_t k = 0; k < parts; ++k) part[k] += a[i + k] * b[i + k];
  for (std::int32_t k = 0; i < n; ++i, ++k) part[k] += a[i] * b[i];
  return ((part[0] + part[4]) + (part[2] + part[6])) + ((part[1] + part[5]) + (part[3] + part[7]));
}

/// Where x, f and strengths stand that were found so many sweeps ago.
std::int32_t slot_of(std::int32_t sweep, std::int32_t ago) { return (sweep - ago) % (history + 1); }

/// Anderson's acceleration: x + f less what earlier sweeps say about how the step f changes with x, in
/// w.next.
void accelerate(std::int32_t n, std::int32_t both, double shift_weight, std::int32_t sweep, std::int32_t used,
                Scratch& w) {
  const auto slot = [sweep](std::int32_t a) { return slot_of(sweep, a); };
  const std::int32_t now = slot(0);
  const double *const x = w.x[now], *const f = w.f[now];
  for (std::int32_t i = 0; i < both; ++i) w.next[i] = x[i] + f[i];
  for (std::int32_t a = 0; a <= used; ++a) {  // those of earlier steps with each other are known
    const double* const other = w.f[slot(a)];
    w.products[now][slot(a)] = w.products[slot(a)][now] =
        product(n, f, other) + (both > n ? shift_weight * product(both - n, f + n, other + n) : 0.0);
  }
  if (used == 0) return;
  double G[history][history], g[history];
  const double* const own = w.products[now];
  for (std::int32_t a = 0; a < used; ++a) {
    const std::int32_t k = slot(a + 1);
    g[a] = own[now] - own[k];
    for (std::int32_t b = 0; b <= a; ++b)
      G[a][b] = G[b][a] = g[a] - own[slot(b + 1)] + w.products[k][slot(b + 1)];
  }
  for (std::int32_t a = 0; a < used; ++a) G[a][a] = G[a][a] * (1.0 + 1e-10) + 1e-300;
  solve_small(used, G, g);
  std::copy_n(g, used, w.shares);
  for (std::int32_t a = 0; a < used; ++a) {
    const double *const xa = w.x[slot(a + 1)], *const fa = w.f[slot(a + 1)];
    for (std::int32_t i = 0; i < both; ++i) w.next[i] -= g[a] * ((x[i] - xa[i]) + (f[i] - fa[i]));
  }
}

/// Strengths at the end of the last step, which no sweep is spent on: those at the mean of earlier sweeps
/// that the step begins at, and what strengths do along the rest of it.
void follow_last_step(const StripSet& s, std::int32_t sweep, std::int32_t used, Scratch& w) {
  const std::int32_t now = slot_of(sweep, 0);
  for (std::int32_t i = 0; i < s.count; ++i) {
    if (!(s.L[i] > 0.0)) continue;
    double q = s.q[i], step = w.f[now][i];
    for (std::int32_t a = 0; a < used; ++a) {
      const std::int32_t k = slot_of(sweep, a + 1);
      q -= w.shares[a] * (s.q[i] - w.strengths[k][i]);
      step -= w.shares[a] * (w.f[now][i] - w.f[k][i]);
    }
    const double part = smaller(larger(step / s.L[i], -settled), settled);
    s.q[i] = larger(q * (1.0 + strength_follows * part), 0.0);
  }
}

/// Sweeps from the lengths and shifts that stand in `s` to the tolerance. Ends after the first sweep where
/// that moves more than the part `farthest` of the area.
SurfaceNormalResult sweep_to(const Problem& problem, const StripSet& s, double tolerance, double farthest,
                             const SurfaceNormalOptions& options, Scratch& w) {
  SurfaceNormalResult result;
  const std::int32_t n = s.count;
  bool skewed = false;
  for (std::int32_t i = 1; i < n; ++i) skewed = skewed || s.middle[i] != s.middle[0];
  const std::int32_t both = skewed ? 2 * n : n;
  if (!skewed) std::fill_n(s.shift, n, 0.0);  // which sweeps leave alone then; a start may bring others
  for (std::int32_t i = 0; i < n; ++i) w.in[i] = s.L[i] > 0.0;
  w.paired_count = no_strips;
  if (skewed) {
    std::fill(w.inverse_reach + n, w.inverse_reach + simd::whole_packs(n), 0.0);
    for (std::int32_t i = 0; i < n; ++i) w.inverse_reach[i] = 1.0 / shift_reach(s.width[i]);
  }
  std::int32_t kept = 0, since = 0, slow = 0;
  double moved_before = 1e300, area = 1.0, shift_weight = 0.0;
  const auto affordable = [&options](std::int32_t sweep, double work) {
    return sweep < options.assured_sweeps || (sweep < options.max_sweeps && work < options.max_work);
  };
  double work = 0.0;
  for (std::int32_t sweep = 0; affordable(sweep, work); ++sweep) {
    ++result.sweeps;
    for (std::int32_t i = 0; i < n; ++i) {
      const double least = least_half_length * s.width[i];
      w.l[i] = root(larger(s.L[i], least * least));
    }
    // far strips are looked at when sweeps begin, and where they would end
    kept = solve_contact(problem, s, skewed, sweep == 0, w);
    if (kept == 0) break;
    work += 1.0 * kept * kept;
    look_at_edges(problem, s, kept, skewed, w);
    double moved = 0.0;
    area = 0.0;
    const double *const f = w.residual, *const shifted = w.residual + n;
    for (std::int32_t i = 0; i < n; ++i) {
      moved += s.width[i] * (magnitude(f[i]) + magnitude(shifted[i]) * w.l[i]);
      area += s.width[i] * (s.L[i] + f[i]);
    }
    result.converged = moved <= tolerance * area && !admit(problem, s, sources_of(kept, w), skewed, true, w);
    if (sweep == 0 && moved > farthest * area) return result;
    // where acceleration does not pay, as while strips enter, it starts anew
    slow = moved > 0.7 * moved_before ? slow + 1 : 0;
    if (slow == 2) since = slow = 0;
    moved_before = moved;
    const std::int32_t slot = slot_of(sweep, 0), used = std::min(since, history);
    std::copy_n(s.L, n, w.x[slot]);
    std::copy_n(s.shift, n, w.x[slot] + n);
    std::copy_n(s.q, n, w.strengths[slot]);
    std::copy_n(w.residual, 2 * n, w.f[slot]);
    make_steps(s, kept, skewed, w.f[slot], w);
    if (sweep == 0) shift_weight = area / (n * s.width[0]);
    accelerate(n, both, shift_weight, sweep, used, w);
    ++since;
    if (result.converged) follow_last_step(s, sweep, used, w);
    for (std::int32_t i = 0; i < n; ++i) {
      const double plain = s.L[i] + f[i], old = s.L[i];
      double next = plain > 0.0 ? smaller(larger(w.next[i], 0.5 * plain), 2.0 * plain) : 0.0;
      if (next > 0.0 && magnitude(f[i]) > settled * old) {
        const double far = old + farthest_step * f[i];
        next = f[i] > 0.0 ? smaller(larger(next, plain), far)
                          : larger(smaller(larger(next, far), plain), 0.5 * plain);
      }
      if (old > 0.0 && next > 0.0 && sweep < 6) next = smaller(larger(next, 0.1 * old), 10.0 * old);
      s.L[i] = next;
      if (skewed) s.shift[i] = smaller(larger(w.next[n + i], -longest_shift), longest_shift);
    }
    if (result.converged) break;
  }
  for (std::int32_t i = 0; i < n; ++i) {
    if (!w.in[i] || !(s.L[i] > 0.0)) s.L[i] = s.q[i] = 0.0;
    if (s.L[i] > 0.0) s.level[i] = s.q[i] / s.L[i];
  }
  if (kept == 0) {
    std::fill_n(s.L, n, 0.0);
    std::fill_n(s.q, n, 0.0);
    result.converged = true;
  }
  return result;
}

/// Pairs of neighbouring strips, a lone one where its neighbour is missing; returns for each strip its pair
/// in w.active.
void pair_up(const StripSet& s, std::int32_t* pair_of, const std::int32_t* number, StripSet& c) {
  c.count = 0;
  for (std::int32_t i = 0; i < s.count;) {
    const bool two = i + 1 < s.count && number[i + 1] == number[i] + 1;
    const std::int32_t j = two ? i + 1 : i, k = c.count++;
    const double a = s.width[i], b = two ? s.width[j] : 0.0, per = 1.0 / (a + b);
    const auto mean = [&](const double* v) { return (a * v[i] + b * v[j]) * per; };
    c.place[k] = mean(s.place);
    c.width[k] = a + b;
    c.depth[k] = mean(s.depth);
    c.curvature[k] = mean(s.curvature);
    c.middle[k] = mean(s.middle);
    c.ny[k] = mean(s.ny);
    c.nz[k] = mean(s.nz);
    c.L[k] = mean(s.L);
    c.shift[k] = mean(s.shift);
    pair_of[i] = pair_of[j] = k;
    i = j + 1;
  }
}

/// Lengths and shifts to start from where there is no earlier solution: those of the overlaps, or of a
/// solution on pairs of strips. Its sweeps are added to `result`.
void start_from_overlaps(const Problem& problem, const Overlaps& o, const SurfaceNormalOptions& options,
                         std::int32_t* pair_of, SurfaceNormalResult& result, Scratch& w) {
  const StripSet& s = w.fine;
  for (std::int32_t i = 0; i < s.count; ++i) {
    s.L[i] = larger(s.depth[i], 0.0) / s.curvature[i];
    s.shift[i] = 0.0;
  }
  if (s.count >= 2 * fewest_pairs) {
    StripSet& c = w.coarse;
    pair_up(s, pair_of, o.strip, c);
    result.sweeps += sweep_to(problem, c, coarse_tolerance, anywhere, options, w).sweeps;
    for (std::int32_t i = 0; i < s.count; ++i) {
      // along the line through this pair and the next one on the strip's side, where both are in contact
      const std::int32_t k = pair_of[i];
      const double off = s.place[i] - c.place[k];
      const std::int32_t other = off > 0.0 ? k + 1 : k - 1;
      s.L[i] = c.L[k];
      s.shift[i] = c.shift[k];
      if (off == 0.0 || other < 0 || other >= c.count) continue;
      const double apart = c.place[other] - c.place[k];
      if (magnitude(apart) > 1.5 * c.width[k]) continue;
      const double t = off / apart;
      s.L[i] = larger(c.L[k] + t * (c.L[other] - c.L[k]), 0.0);
      s.shift[i] = c.shift[k] + t * (c.shift[other] - c.shift[k]);
    }
  }
}

/// Moves the lengths of an earlier solution as its overlaps have moved since. In Hertz's contact of equal
/// curvatures squared lengths grow in proportion to a depth that grows everywhere, and twice as much with
/// what is shifted: overlaps of a pose beside the last one tell how much of either there is. The parts are
/// those that leave the fewest sweeps on poses of wheel and rail a millisecond apart. Returns whether they
/// have moved so little that the earlier solution is a start.
bool follow_overlaps(const Overlaps& o, const SurfaceStart& start, const StripSet& s) {
  double longest = 0.0, deepest = 0.0, weights = 0.0, mean = 0.0;
  for (std::int32_t i = 0; i < s.count; ++i) {
    if (!(s.L[i] > 0.0)) continue;
    const double before = start.depth[o.strip[i]], weight = s.width[i] * s.L[i];
    longest = larger(longest, s.L[i]);
    deepest = larger(deepest, before);
    weights += weight;
    mean += weight * (s.depth[i] - before);
  }
  if (!(deepest > 0.0)) return true;
  mean = mean / weights;
  const double per = longest / deepest;
  double moved = 0.0, area = 0.0;
  for (std::int32_t i = 0; i < s.count; ++i) {
    if (!(s.L[i] > 0.0)) continue;
    const double grown = s.depth[i] - start.depth[o.strip[i]];
    const double next = s.L[i] + per * (follows_mean * mean + follows_rest * (grown - mean));
    const double limited = smaller(larger(next, 0.25 * s.L[i]), 4.0 * s.L[i]);
    moved += s.width[i] * magnitude(limited - s.L[i]);
    area += s.width[i] * limited;
    s.L[i] = limited;
  }
  return moved <= farthest_followed * area;
}

}  // namespace

std::int64_t surface_normal_doubles(std::int32_t most) {
  Scratch w;
  double nothing = 0.0;
  return cut(&nothing, most, w) + 2 * most;
}

SurfaceNormalResult solve_surface_normal(const RailStrips& rail, const Overlaps& o,
                                         const InfluenceTables& influence, const Kernels& kernels,
                                         double compliance, const SurfaceNormalOptions& options,
                                         double* memory, SurfaceStart& start,
                                         const SurfacePressure& p) noexcept {
  SurfaceNormalResult result;
  Scratch w;
  auto* const pair_of = reinterpret_cast<std::int32_t*>(memory + cut(memory, o.capacity, w));
  StripSet& s = w.fine;
  s.count = o.count;
  bool started = false;
  for (std::int32_t i = 0; i < o.count; ++i) {
    const std::int32_t j = o.strip[i];
    s.place[i] = rail.s[j];
    s.width[i] = rail.width[j];
    s.depth[i] = o.depth[i];
    s.curvature[i] = o.curvature[i];
    s.middle[i] = o.centre[i];
    s.ny[i] = o.ny[i];
    s.nz[i] = o.nz[i];
    s.L[i] = start.set ? start.length_squared[j] : 0.0;
    s.shift[i] = start.set ? start.shift[j] : 0.0;
    started = started || s.L[i] > 0.0;
  }
  const Problem problem{kernels, {influence.tables(), influence.mean_under.data()}, compliance};
  if (o.count == 0) {
    result.converged = true;
  } else {
    if (started && !start.led) started = follow_overlaps(o, start, s);
    if (started) {
      result = sweep_to(problem, s, options.tolerance, farthest_start, options, w);
      started = result.converged;
    }
    if (!started) {
      start_from_overlaps(problem, o, options, pair_of, result, w);
      const std::int32_t earlier = result.sweeps;
      result = sweep_to(problem, s, options.tolerance, anywhere, options, w);
      result.sweeps += earlier;
    }
  }
  for (std::int32_t j = 0; j < rail.count; ++j)
    start.length_squared[j] = start.shift[j] = start.depth[j] = 0.0;
  for (std::int32_t i = 0; i < o.count; ++i) {
    start.length_squared[o.strip[i]] = s.L[i];
    start.shift[o.strip[i]] = s.shift[i];
    start.depth[o.strip[i]] = s.depth[i];
    p.length_squared[i] = s.L[i];
    p.level[i] = s.level[i];
    p.centre[i] = s.middle[i] + s.shift[i];
    p.strength[i] = s.q[i];
  }
  start.set = true;
  start.led = false;
  return result;
}

}  // namespace wrc
