#include "surface/pressure/active_set.hpp"

#include <algorithm>
#include <utility>

#include "base/number.hpp"
#include "surface/pressure/smoothing.hpp"

namespace wrc::surface {
namespace {

constexpr std::int32_t most_rounds = 20;  ///< rounds of strips entering and leaving, per iteration
/// L of a strip beside contact over (overlap - displacement) / curvature there: its way into contact then
/// goes on evenly where it enters (extrapolate_start()).
constexpr double grows_faster = 4.0;

/// Makes sources of unit line load of the strips in w.in_contact, with l of w.half_length.
void list_active(const PressureProblem& problem, const StripSet& s, PressureScratch& w) {
  // By increasing place, so that kernels and sums have the order of the rail.
  ActiveStrips& active = w.active;
  const std::int32_t listed = active.count;
  bool same = true;  // strips as before
  active.count = 0;
  const auto list = [&](std::int32_t i) {
    if (!w.in_contact[i]) return;
    same = same && active.count < listed && active.index[active.count] == i;
    active.index[active.count++] = i;
  };
  for (std::int32_t i = 0; i < s.behind; ++i) list(i);
  active.behind = active.count;
  for (std::int32_t i = s.behind; i < s.count; ++i) list(i);
  // A line of half length l under unit q = lambda l^2 has the peak 1 / l: C w / l times J displaces.
  for (std::int32_t a = 0; a < active.count; ++a) {
    const std::int32_t i = active.index[a];
    const double inverse = 1.0 / w.half_length[i];
    active.centre[a] = s.deepest_x[i] + s.shift[i];
    active.half_length[a] = w.half_length[i];
    active.inverse_length[a] = inverse;
    active.half_width[a] = 0.5 * s.width[i] * inverse;
    active.factor[a] = problem.compliance * s.width[i] * inverse;
  }
  // Lengths and centres alone have changed where the strips are those of the last list.
  if (same && active.count == listed) return;
  for (std::int32_t a = 0; a < active.count; ++a) {
    const std::int32_t i = active.index[a];
    active.place[a] = s.place[i];
    active.width[a] = s.width[i];
    active.ny[a] = s.ny[i];
    active.nz[a] = s.nz[i];
    active.per_lambda_reach[a] = 1.0 / lambda_reach(s.width[i], problem.lambda_length);
    // Distance to the strip before, where both are of one region.
    if (a == 0) continue;
    const std::int32_t before = active.index[a - 1];
    const double apart = s.place[i] - s.place[before];
    const bool gap = !(apart > 0.0 && apart < 0.75 * (s.width[before] + s.width[i]));
    active.per_apart_squared[a - 1] = gap ? 0.0 : 1.0 / (apart * apart);
  }
  // Kernels read whole packs: strips behind the last displace nothing.
  const std::int64_t end = simd::whole_packs(active.count);
  for (double* const each : {active.place, active.centre, active.inverse_length, active.half_width,
                             active.factor, active.q, active.width, active.ny, active.nz})
    std::fill(each + active.count, each + end, 0.0);
  // second places that are not in contact are asked with these widths, too
  if (s.behind == s.count) return;
  // a line's ends are no nearer to points beyond them for its strip's width
  std::fill_n(active.width_behind, end, 0.0);
  for (std::int32_t a = active.behind; a < active.count; ++a)
    active.width_behind[a] = std::exchange(active.width[a], 0.0);
}

/// Rows of influence at points, those from `behind` on second places.
void fill_rows(const PressureProblem& problem, const StripSet& s, const ActiveStrips& active,
               const simd::SurfacePoints& points, std::int32_t behind, double* rows, std::int64_t stride) {
  const auto fill = [&](std::int32_t first, std::int32_t count, const double* width) {
    if (count > 0)
      problem.kernels.surface.influence(
          problem.tables, sources_of(active), {width, active.ny, active.nz},
          {count, points.place + first, points.x + first, points.ny + first, points.nz + first}, s.skewed,
          rows + first * stride, stride);
  };
  const std::int32_t before = std::min(std::max(behind, 0), points.count);
  fill(0, before, active.width);
  fill(before, points.count - before, active.width_behind);
}

/// Activates the strip with the largest overlap; false where none overlaps.
bool activate_deepest(const StripSet& s, PressureScratch& w) {
  std::int32_t deepest = 0;
  for (std::int32_t i = 1; i < s.count; ++i)
    if (s.depth[i] > s.depth[deepest]) deepest = i;
  if (!(s.depth[deepest] > 0.0)) return false;
  w.in_contact[deepest] = 1;
  return true;
}

/// Deactivates strips whose load in w.solution pulls. Returns whether there are any.
bool deactivate(PressureScratch& w) {
  bool any = false;
  for (std::int32_t a = 0; a < w.active.count; ++a)
    if (w.solution[a] < 0.0) {
      w.in_contact[w.active.index[a]] = 0;
      any = true;
    }
  return any;
}

/// Line loads of the active strips: M q = d - kappa/2 shift^2 by elimination, into w.solution. M is not
/// symmetric: a column has its strip's length and width, a row only its place.
void solve_loads(const PressureProblem& problem, const StripSet& s, PressureScratch& w) {
  const std::int32_t n = w.active.count;
  const ActiveStrips& active = w.active;
  w.work += work_of_pass(n);
  const std::int32_t size = (n + 3) / 4 * 4;
  const std::int64_t stride = simd::elimination_stride(size);
  // As many rows as have a place, then some at a time; usually all have one.
  const auto places = static_cast<std::int32_t>(w.places / stride / 8 * 8);
  for (std::int32_t first = 0; first < n;) {
    const std::int32_t end = std::min(first + (first == 0 ? places : rows_at_a_time), size);
    const std::int32_t count = std::min(n, end) - first;
    double* const rows = first == 0 ? w.matrix : w.rows;
    // Rows of M at the strips' own middles; the first kernel leaves the diagonal to the second one.
    fill_rows(problem, s, active,
              {count, active.place + first, active.centre + first, active.ny + first, active.nz + first},
              active.behind - first, rows, stride);
    problem.kernels.surface.own_influence(problem.tables, sources_of(active, first, count), rows + first,
                                          stride);
    // Behind the strips: the overlaps as right-hand side, and rows of the unit matrix up to a multiple of
    // four.
    for (std::int32_t a = first; a < end; ++a) {
      double* const row = rows + (a - first) * stride;
      for (std::int64_t c = a < n ? n : 0; c < stride; ++c) row[c] = 0.0;
      if (a < n)
        row[size] = overlap_at_centre(s, active.index[a]);
      else
        row[a] = 1.0;
    }
    problem.kernels.normal.eliminate({size, stride, w.matrix, w.solution, nullptr, rows, first, end, places});
    first = end;
  }
}

}  // namespace

simd::SurfaceSources sources_of(const ActiveStrips& active, std::int32_t first, std::int32_t count) {
  return {count,
          active.place + first,
          active.centre + first,
          active.inverse_length + first,
          active.half_width + first,
          active.factor + first};
}

simd::SurfaceSources sources_of(const ActiveStrips& active) { return sources_of(active, 0, active.count); }

simd::SurfaceFaces faces_of(const ActiveStrips& active) { return {active.width, active.ny, active.nz}; }

bool activate(const PressureProblem& problem, const StripSet& s, Asked asked, PressureScratch& w) {
  if (asked == Asked::none) return false;
  // Strips to ask. Displacements are never negative: nothing enters where there is no overlap.
  std::int32_t count = 0;
  for (std::int32_t i = 0; i < s.count; ++i) {
    if (w.in_contact[i] || !(overlap_at_centre(s, i) > 0.0)) continue;
    const bool beside = (i > 0 && w.in_contact[i - 1]) || (i + 1 < s.count && w.in_contact[i + 1]);
    if (!beside && asked == Asked::beside) continue;
    w.outside[count] = i;
    w.outside_place[count] = s.place[i];
    w.outside_ny[count] = s.ny[i];
    w.outside_nz[count] = s.nz[i];
    w.outside_x[count++] = s.deepest_x[i] + s.shift[i];
  }
  if (count == 0) return false;
  std::int32_t behind = count;  // from here on they are second places
  while (s.behind < s.count && behind > 0 && w.outside[behind - 1] >= s.behind) --behind;
  for (double* const each : {w.outside_place, w.outside_x, w.outside_ny, w.outside_nz}) each[count] = 0.0;
  // Displacement at their middles by the active strips, row by row; the system's memory is free by now.
  const std::int32_t n = w.active.count;
  const std::int64_t stride = simd::whole_packs(n);
  fill_rows(problem, s, w.active, {count, w.outside_place, w.outside_x, w.outside_ny, w.outside_nz}, behind,
            w.matrix, stride);
  // Their displacement against their overlap [m].
  bool any = false;
  for (std::int32_t b = 0; b < count; ++b) {
    const std::int32_t i = w.outside[b];
    const double* const row = w.matrix + b * stride;
    double u = 0.0;
    for (std::int32_t a = 0; a < n; ++a) u += row[a] * w.solution[a];
    // The margin of rounding keeps a strip that just touches from entering and leaving in turn.
    const double overlap = overlap_at_centre(s, i);
    const double L = (overlap - u) / s.curvature[i];
    w.continued[i] = smaller(grows_faster * L, 0.0);
    if (!(u < overlap * (1.0 - 1e-12))) continue;
    w.in_contact[i] = 1;
    any = true;
    // It begins with the length that the cold start gives to the overlap that is left: growing from L = 0
    // takes as many iterations as a solve.
    if (L > w.half_length[i] * w.half_length[i]) {
      s.L[i] = L;
      w.half_length[i] = root(L);
    }
  }
  return any;
}

void solve_contact(const PressureProblem& problem, const StripSet& s, Asked asked, PressureScratch& w) {
  // Each round solves for all loads; near a solution the first one changes nothing.
  for (std::int32_t round = 0; round < most_rounds; ++round) {
    list_active(problem, s, w);
    // Nothing presses yet, or everything has left: the deepest overlap alone begins.
    if (w.active.count == 0) {
      if (!activate_deepest(s, w)) return;
      continue;
    }
    solve_loads(problem, s, w);
    // Both are judged by the same loads: strips enter and leave in one round.
    bool changed = activate(problem, s, asked, w);
    changed = deactivate(w) || changed;
    // Another round takes the loads, and there must be work left for the edges.
    if (!changed || w.work + 2.0 * work_of_pass(w.active.count) > w.max_work) return;
  }
  // Rounds or work used up: strips may still pull. Their loads count as 0, and the next iteration goes on
  // from there.
}

}  // namespace wrc::surface
