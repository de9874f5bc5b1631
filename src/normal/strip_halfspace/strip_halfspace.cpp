#include "normal/strip_halfspace/strip_halfspace.hpp"

#include <algorithm>
#include <cmath>

#include "base/elementary.hpp"
#include "normal/check.hpp"
#include "normal/penetration/load_search.hpp"
#include "normal/penetration/penetration.hpp"
#include "normal/strip_halfspace/resample_strips.hpp"
#include "normal/strip_halfspace/strip_edges.hpp"
#include "normal/strip_halfspace/strip_pressures.hpp"
#include "normal/strip_halfspace/strip_system.hpp"

namespace wrc::normal {
namespace {

/// Contact lies where the height is below about 0.73 approach (eps_y of Hertz for a / b = 0.1); the rest is
/// margin.
constexpr double depth_per_approach = 0.85;

/// If another spot has its lowest point near the end of the margin, or beyond it, the grid covers the whole
/// approach: far from the load the surface sinks by a tenth of it only.
constexpr double depth_with_spots = 0.95, near_the_margin = 0.9;

/// A cold start begins on half the strips, if those are not too few, and is as good as the fine solution can
/// use when less than this part of the area moves.
constexpr std::int32_t fewest_coarse_strips = 8;
constexpr double coarse_tolerance = 3e-2;

/// Strips of the solver for strips of the result: the solver's stand where they are needed.
std::int32_t collocation_strips(std::int32_t strips) { return std::max((7 * strips) / 10, std::int32_t{4}); }

/// The start's l^2 [m^2] and shift [m] at y, linear between its strips.
struct Started {
  bool in_contact = false;  ///< the start had contact there
  double length_squared = 0.0, shift = 0.0;
};
Started started(const StripHalfspaceStart& start, double y) {
  if (start.count == 0) return {};
  // The start's strips on both sides of y.
  const auto above = static_cast<std::int32_t>(std::upper_bound(start.y, start.y + start.count, y) - start.y);
  const std::int32_t right = std::min(above, start.count - 1);
  const std::int32_t left = std::max(above - 1, 0);
  // A patch's last strip may end on the middle of the grid's next: rounding must not decide.
  constexpr double half = 0.5 * (1.0 - 1e-9);
  const bool in_left = std::abs(y - start.y[left]) <= half * start.width[left];
  const bool in_right = std::abs(y - start.y[right]) <= half * start.width[right];
  if (!in_left && !in_right) return {};
  // Linear between two that touch; across a gap the strip that holds y alone.
  const double apart = start.y[right] - start.y[left];
  const double touching = 0.5 * (start.width[left] + start.width[right]);
  double t = in_left ? 0.0 : 1.0;
  if (left != right && apart < 1.01 * touching) t = (y - start.y[left]) / apart;
  return {true, start.length_squared[left] + t * (start.length_squared[right] - start.length_squared[left]),
          start.shift[left] + t * (start.shift[right] - start.shift[left])};
}

/// Places the strips and gives them a first half length: that of the last solution where it had contact, half
/// the virtual penetration elsewhere.
void place(const NormalProblem& problem, const patch::GapMinimum& lowest, double approach, double depth,
           std::int32_t count, const StripHalfspaceStart& start, StripSystem& s) {
  build_collocation_grid(problem.gap, lowest, depth, count, s.grid);
  s.skewed = false;
  patch::GapReader gap(problem.gap);
  s.active_count = 0;
  for (std::int32_t j = 0; j < s.grid.count; ++j) {
    s.cell_y[j] = s.grid.y[j];
    s.cell_width[j] = s.grid.width[j];
    put(gap, lowest.height, j, s.cell_y[j], s.cell_width[j], s);
    s.skewed = s.skewed || s.gap_centre[j] != s.gap_centre[0];
    // Cold: l^2 = 2 g / curvature, g half the approach less the height, with a floor for strips at the
    // border.
    const double overlap = approach - 2.0 * s.height[j];
    s.peak[j] = 0.0;
    s.half_length[j] = std::sqrt(std::max(overlap, 0.06 * approach) / s.curvature[j]);
    s.centre[j] = s.gap_centre[j];
    bool in_contact = start.count == 0 && s.height[j] < 0.7 * approach;
    if (const Started warm = started(start, s.grid.y[j]); warm.in_contact) {
      // u > 0 at the edges bounds l; the approach is an estimate if the load is given.
      const double most = std::max(3.0 * (approach - s.height[j]), 0.06 * approach) / s.curvature[j];
      s.half_length[j] = std::sqrt(std::min(warm.length_squared, most));
      s.centre[j] += warm.shift;
      in_contact = true;
    }
    if (in_contact) s.active[s.active_count++] = j;
  }
  // A start that lies elsewhere is no start.
  for (std::int32_t j = 0; j < s.grid.count && s.active_count == 0; ++j)
    if (s.height[j] < 0.1 * approach) s.active[s.active_count++] = j;
  if (s.active_count == 0 && s.grid.count > 0) s.active[s.active_count++] = 0;
}

/// dN / d(approach) is the load of a flat punch on the contact area, whose pressure is singular at the edge.
/// The derivative of the strips' own, semi-elliptic pressure comes out smaller, on Hertz's ellipse by the
/// factor fitted here in z = ln(a / b), a / b = 0.1 .. 18, to 1 %; on S1002/UIC60 patches it holds to 3 %.
double punch_stiffness(double stiffness, const patch::StripTotals& sum) {
  const double z = natural_log(pi * sum.length * sum.length / (4.0 * sum.area));
  return stiffness * (1.27 + z * (0.0777 + 0.0078 * z));
}

/// The outermost strips of the grid are in contact: the margin was too small.
bool touches_the_grids_end(const StripSystem& s) {
  return s.active_count > 0 && (s.active[0] == 0 || s.active[s.active_count - 1] == s.grid.count - 1);
}

/// A spot where the undeformed bodies overlap has its lowest point too high for a grid of that depth to give
/// it strips.
bool spot_above(const patch::GapRows& rows, const patch::GapMinimum& lowest, double depth, double approach) {
  for (std::int32_t j = 1; j + 1 < rows.count; ++j) {
    const double height = rows.height[j] - lowest.height;
    const bool lower = rows.height[j] < rows.height[j - 1] && rows.height[j] <= rows.height[j + 1];
    if (lower && height >= near_the_margin * depth && height < approach) return true;
  }
  return false;
}

/// Unknowns and progress of a solve.
struct State {
  double approach = 0.0;   ///< an estimate at first [m]
  double stiffness = 0.0;  ///< dN / d(approach) at the present lengths [N/m]
  std::int32_t iterations = 0;
  bool converged = false;
};

/// Iterates on a grid of `count` strips, from `start` if that has any, until less of the area moves than the
/// tolerance. The grid is widened if contact reaches its end.
void solve_on_grid(const NormalProblem& problem, const StripHalfspaceOptions& options,
                   const InfluenceTables& influence, const patch::GapMinimum& lowest, std::int32_t count,
                   StripHalfspaceStart& start, StripSystem& s, State& state) {
  const double guess = state.approach;
  // Depth of the grid below the surface of first touch [m].
  double depth = depth_per_approach * guess;
  if (spot_above(problem.gap, lowest, depth, guess)) depth = guess;
  constexpr int widenings = 3;
  for (int attempt = 0; attempt < widenings; ++attempt) {
    place(problem, lowest, state.approach, depth, count, start, s);
    if (start.count > 0) fit_ends(problem.gap, lowest.height, s);
    state.converged = false;
    double moved_before = 0.0;
    Search search = Search::everywhere;
    for (std::int32_t i = 0; i < options.max_sweeps && !state.converged && s.active_count > 0; ++i) {
      state.approach = solve_pressures(problem, influence, search, s, state.stiffness);
      ++state.iterations;
      if (s.active_count == 0) break;
      // Steps shrink geometrically, and slowly in slender patches. The rest of their series, r = m /
      // m_before: m (r + r^2 + ...) = m^2 / (m_before - m).
      const double moved = move_edges(problem, influence, state.approach, s);
      const double left = moved < moved_before ? moved * moved / (moved_before - moved) : moved;
      state.converged = std::max(moved, left) <= options.tolerance;
      moved_before = moved;
      // A region that the first guess of the approach did not show: the iteration that takes it in is not the
      // last.
      const bool more = state.converged && search == Search::beside_contact &&
                        overlap_elsewhere(problem, influence, state.approach, s);
      search = more ? Search::everywhere : Search::beside_contact;
      if (more) state.converged = false;
      fit_ends(problem.gap, lowest.height, s);
    }
    if (s.active_count == 0 && start.count > 0) {
      start.count = 0;  // a start that far off is worse than none, and so is where it led
      state.approach = guess;
      continue;
    }
    if (!(state.approach > 0.0)) break;  // the gap dips below its rows: no depth to widen
    // A deeper grid where contact reached its end, or another spot may be in contact; else done.
    if (touches_the_grids_end(s) && !s.grid.at_edge)
      depth *= 1.4;
    else if (depth < depth_with_spots * state.approach &&
             spot_above(problem.gap, lowest, depth, state.approach))
      depth = state.approach;
    else
      break;
  }
}

/// Keeps the solution as the next start.
void remember(const StripSystem& s, StripHalfspaceStart& start) {
  start.count = s.active_count;
  for (std::int32_t a = 0; a < s.active_count; ++a) {
    const std::int32_t j = s.active[a];
    start.y[a] = s.grid.y[j];
    start.width[a] = s.grid.width[j];
    start.length_squared[a] = s.half_length[j] * s.half_length[j];
    start.shift[a] = s.centre[j] - s.gap_centre[j];
  }
}

/// Cuts the strips in contact into the caller's strips; returns their load [N].
double hand_out(StripSystem& s, std::int32_t count, patch::Strips& strips) {
  for (std::int32_t a = 0; a < s.active_count; ++a) {
    const std::int32_t j = s.active[a];
    // Moved to the front, in order: a <= j.
    s.grid.y[a] = s.grid.y[j];
    s.grid.width[a] = s.grid.width[j];
    s.grid.region[a] =
        s.grid.region[j] + (j - a) * most_regions;  // strips left out in between part the regions
    s.centre[a] = s.centre[j];
    s.half_length[a] = s.half_length[j];
    s.peak[a] = s.peak[j];
  }
  return resample_strips(
      {s.active_count, s.grid.y, s.grid.width, s.centre, s.half_length, s.peak, s.grid.region}, count,
      strips);
}

}  // namespace

std::int64_t strip_halfspace_workspace(std::int32_t strips) noexcept { return strip_system_bytes(strips); }

Fault solve_strip_halfspace(const NormalProblem& problem, const StripHalfspaceOptions& options,
                            const InfluenceTables& influence, NormalWorkspace& workspace,
                            StripHalfspaceStart& start, patch::Strips& strips,
                            NormalSolution& solution) noexcept {
  solution = {};
  Fault fault = check_normal_problem(problem, strips);
  if (fault.status != WRC_OK) return fault;
  if (workspace.bytes < strip_halfspace_workspace(problem.strips) || start.capacity < problem.strips)
    return Fault::buffer("workspace", {workspace.bytes});

  // Lowest point, and the deepest approach the rows describe [m].
  const patch::GapRows& rows = problem.gap;
  const patch::GapMinimum lowest = patch::minimum(rows);
  const double ceiling = deepest_approach(rows, lowest);
  const bool load = problem.prescribed == Prescribed::load;
  // First guess of the approach: prescribed, or that of an elastic foundation under the load.
  State state;
  state.approach = problem.approach;
  if (load)
    state.approach =
        foundation_approach(rows, lowest.height, problem.material.normal_compliance(), problem.normal_force,
                            first_guess(problem, 0.5 * rows.curvature[patch::lowest_row(rows)]));
  StripSystem s = lay_out_strips(workspace.memory, problem.strips);
  const std::int32_t count = collocation_strips(problem.strips);
  if (start.count == 0 && count >= 2 * fewest_coarse_strips) {
    // A cold start finds its way on half the strips, at a sixth of the cost.
    const StripHalfspaceOptions coarse{options.max_sweeps, std::max(coarse_tolerance, options.tolerance)};
    solve_on_grid(problem, coarse, influence, lowest, count / 2, start, s, state);
    if (state.approach > 0.0) remember(s, start);
  }
  if (state.approach > 0.0) solve_on_grid(problem, options, influence, lowest, count, start, s, state);
  const double approach = state.approach;
  solution.iterations = state.iterations;
  if (!(approach > 0.0))
    return Fault::gap("gap.height", {approach, "m"},
                      "heights leap from row to row: the gap between them dips below the rows");
  // The rows do not describe the gap that deep: nothing is extrapolated.
  if (approach > ceiling || s.active_count == 0)
    return Fault::load(load ? "load.normal_force" : "load.approach",
                       {load ? problem.normal_force : problem.approach, load ? "N" : "m"},
                       load ? "the gap given, or the profiles, are too narrow to carry it; did you pass kN?"
                            : "the gap given, or the profiles, are too narrow for it; did you pass mm?");

  remember(s, start);
  solution.normal_force = hand_out(s, problem.strips, strips);
  solution.approach = approach;
  if (load) {
    // Equal already, unless the cap cut the last exchange of strips short.
    for (std::int32_t j = 0; j < strips.count; ++j)
      strips.peak[j] *= problem.normal_force / solution.normal_force;
    solution.normal_force = problem.normal_force;
  }
  // Peak, area and stiffness follow from the strips handed out.
  const bool at_edge = s.grid.at_edge && touches_the_grids_end(s);
  complete_solution(strips, lowest, at_edge, solution, fault);
  solution.stiffness = punch_stiffness(state.stiffness, patch::totals(strips));
  if (!state.converged)
    keep_worst(fault, Fault::iteration_cap("config.planar.max_sweeps", {options.max_sweeps, "sweeps"}));
  return fault;
}

}  // namespace wrc::normal
