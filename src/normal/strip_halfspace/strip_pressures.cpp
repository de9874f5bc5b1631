#include "normal/strip_halfspace/strip_pressures.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "kernels/kernels.hpp"
#include "normal/simd/tasks.hpp"

namespace wrc::normal {
namespace {

/// A strip enters when the bodies would overlap by this part of the approach: rounding must not decide.
constexpr double overlap_to_enter = 1e-4;

constexpr std::int32_t beside = 1;  ///< strips from the nearest in contact that still count as beside it

double* influence_row(const StripSystem& s, std::int32_t j) { return s.influence + j * s.stride; }

/// Fills row j of the influence, if it is not known yet: displacement at the middle of strip j by unit peak
/// in each of the strips.
void find_influence(const Kernels& kernels, const InfluenceTables& influence, const StripSystem& s,
                    std::int32_t j) {
  if (s.row_known[j] != 0) return;
  s.row_known[j] = 1;
  double* const row = influence_row(s, j);
  const std::int32_t first = s.in_reach.first;
  const simd::InfluenceTask task{
      influence.tables(), s.in_reach.count,         s.grid.y + first, s.grid.width + first,
      s.centre + first,   s.inverse_length + first, s.skewed};
  kernels.normal.influence_row(task, j - first, row + first);
  // A strip's effect on its own middle: the mean of J over its width.
  row[j] = s.grid.width[j] * influence.own_middle(0.5 * s.grid.width[j] * s.inverse_length[j]);
}

/// The equations A p = (delta - h) / c of the active strips, with right-hand sides 1 / c and h / c apart: the
/// approach delta may be unknown.
simd::EliminationTask gather(const StripSystem& s, double compliance) {
  const std::int32_t m = s.active_count, size = elimination_size(m);
  const std::int64_t stride = simd::elimination_stride(size);
  for (std::int32_t a = 0; a < size; ++a) {
    // Rows filled up to a multiple of four by those of the unit matrix, with right-hand sides 0.
    double* const target = s.matrix + a * stride;
    for (std::int64_t b = a < m ? m : 0; b < stride; ++b) target[b] = 0.0;
    if (a >= m) {
      target[a] = 1.0;
      continue;
    }
    target[size] = 1.0 / compliance;
    target[size + 1] = height_at_centre(s, s.active[a]) / compliance;
  }
  // Column by column is slow; strips in contact come in runs.
  for (std::int32_t first = 0, end = 0; first < m; first = end) {
    end = run_end(s, first);
    for (std::int32_t a = 0; a < m; ++a)
      std::copy_n(influence_row(s, s.active[a]) + s.active[first], end - first,
                  s.matrix + a * stride + first);
  }
  return {size, stride, s.matrix, s.by_approach, s.by_height};
}

/// The strips of an iteration: all, or those in contact and a few on both sides, in whole packs of the
/// kernels.
StripRange strips_in_reach(Search search, const StripSystem& s) {
  if (search == Search::everywhere || s.active_count == 0) return {0, s.grid.count};
  constexpr std::int32_t margin = 2;
  const std::int32_t from = std::max(s.active[0] - margin, 0);
  const std::int32_t to = std::min(s.active[s.active_count - 1] + 1 + margin, s.grid.count);
  const auto packs = static_cast<std::int32_t>(simd::whole_packs(to - from));
  const auto all_packs = static_cast<std::int32_t>(simd::whole_packs(s.grid.count));
  const std::int32_t first = std::min(from, all_packs - packs);
  return {first, std::min(packs, s.grid.count - first)};
}

/// Takes strips that pull out of contact. True if there are any.
bool deactivate_pulling(StripSystem& s) {
  std::int32_t kept = 0;
  for (std::int32_t a = 0; a < s.active_count; ++a) {
    double& peak = s.peak[s.active[a]];
    if (peak > 0.0)
      s.active[kept++] = s.active[a];
    else
      peak = 0.0;
  }
  const bool changed = kept < s.active_count;
  s.active_count = kept;
  return changed;
}

/// True if the bodies would overlap at strip j, which is not in contact.
bool overlaps(const NormalProblem& problem, const InfluenceTables& influence, double approach, std::int32_t j,
              const StripSystem& s) {
  find_influence(*problem.kernels, influence, s, j);
  const double* const row = influence_row(s, j);
  // u(x_cj, y_j) < delta - h there: the surfaces would overlap.
  double displacement = 0.0;
  for (std::int32_t b = 0; b < s.active_count; ++b) displacement += row[s.active[b]] * s.peak[s.active[b]];
  return problem.material.normal_compliance() * displacement <
         (1.0 - overlap_to_enter) * approach - height_at_centre(s, j);
}

/// Takes strips where the bodies would overlap into contact. True if there are any.
bool activate_overlapping(const NormalProblem& problem, const InfluenceTables& influence, Search search,
                          double approach, StripSystem& s) {
  std::int32_t a = 0, next_count = 0;
  const std::int32_t m = s.active_count;
  for (std::int32_t j = s.in_reach.first; j < s.in_reach.first + s.in_reach.count; ++j) {
    // A strip in contact stays; others are candidates if the undeformed bodies overlap there.
    bool in = a < m && s.active[a] == j;
    const bool near = (a < m && s.active[a] - j <= beside) || (a > 0 && j - s.active[a - 1] <= beside);
    if (in)
      ++a;
    else if (s.height[j] < approach && (near || search == Search::everywhere))
      in = overlaps(problem, influence, approach, j, s);
    if (in) s.next_active[next_count++] = j;
  }
  if (next_count == m) return false;
  std::swap(s.active, s.next_active);
  s.active_count = next_count;
  return true;
}

}  // namespace

bool overlap_elsewhere(const NormalProblem& problem, const InfluenceTables& influence, double approach,
                       const StripSystem& s) noexcept {
  const std::int32_t n = s.grid.count;
  for (std::int32_t j = 0, a = 0; j < n; ++j) {
    // Lowest strips of spots away from contact; one of a spot is enough to look everywhere again.
    while (a < s.active_count && s.active[a] + beside < j) ++a;
    const bool near = a < s.active_count && s.active[a] - beside <= j;
    const bool lowest =
        (j == 0 || s.height[j] < s.height[j - 1]) && (j + 1 == n || s.height[j] <= s.height[j + 1]);
    if (lowest && !near && s.height[j] < approach && overlaps(problem, influence, approach, j, s))
      return true;
  }
  return false;
}

double solve_pressures(const NormalProblem& problem, const InfluenceTables& influence, Search search,
                       StripSystem& s, double& stiffness) noexcept {
  const double compliance = problem.material.normal_compliance();
  for (std::int32_t i = 0; i < s.grid.count; ++i) s.inverse_length[i] = 1.0 / s.half_length[i];
  // Lengths have moved: all rows of the influence are to be found again, when they are needed.
  std::fill_n(s.row_known, s.grid.count, 0);
  s.in_reach = strips_in_reach(search, s);
  for (std::int32_t a = 0; a < s.active_count; ++a)
    find_influence(*problem.kernels, influence, s, s.active[a]);

  double approach = problem.approach;
  constexpr int rounds = 6;
  for (int round = 0; round < rounds; ++round) {
    const std::int32_t m = s.active_count;
    problem.kernels->normal.eliminate(gather(s, compliance));

    // N = delta sum(by_approach section) - sum(by_height section), section = (pi/2) l width [m^2].
    double load_by_approach = 0.0, load_by_height = 0.0;
    for (std::int32_t a = 0; a < m; ++a) {
      const std::int32_t j = s.active[a];
      const double section = 0.5 * pi * s.half_length[j] * s.grid.width[j];
      load_by_approach += section * s.by_approach[a];
      load_by_height += section * s.by_height[a];
    }
    if (problem.prescribed == Prescribed::load)
      approach = (problem.normal_force + load_by_height) / load_by_approach;
    stiffness = load_by_approach;

    // Pressures; the active set is final when no strip pulls and none outside overlaps.
    std::fill(s.peak, s.peak + s.grid.count, 0.0);
    for (std::int32_t a = 0; a < m; ++a) s.peak[s.active[a]] = approach * s.by_approach[a] - s.by_height[a];
    if (!deactivate_pulling(s) && !activate_overlapping(problem, influence, search, approach, s)) break;
    if (s.active_count == 0) break;
  }
  return approach;
}

}  // namespace wrc::normal
