#include "normal/strip_halfspace.hpp"

#include <algorithm>
#include <cmath>

#include "normal/check.hpp"
#include "normal/collocation_grid.hpp"
#include "normal/linear_solve.hpp"
#include "normal/load_search.hpp"
#include "normal/penetration.hpp"
#include "normal/recut_strips.hpp"

namespace wrc {
namespace {

/// Contact lies where the height is below about 0.73 approach (eps_y of Hertz for a / b = 0.1); the rest is
/// margin.
constexpr double depth_per_approach = 0.85;

/// The solver's strips; arrays in the workspace, all `grid.count` long.
struct System {
  CollocationGrid grid;
  double* height = nullptr;     ///< over the lowest point [m]
  double* curvature = nullptr;  ///< d2h/dx2 [1/m]
  double* gap_centre = nullptr;
  double* half_length = nullptr;
  double* inverse_length = nullptr;
  double* centre = nullptr;
  double* peak = nullptr;
  double* influence =
      nullptr;  ///< count x count: u at the middle of j by unit peak in i, over the compliance [m]
  double* matrix = nullptr;  ///< of the active strips
  double* by_approach = nullptr;
  double* by_height = nullptr;
  double* length_change = nullptr;  ///< ln(l_new / l)
  double* centre_change = nullptr;  ///< [m]
  std::int32_t* active = nullptr;   ///< indices of the strips in contact
  std::int32_t active_count = 0;
  bool skewed = false;
};

constexpr std::int64_t arrays_of_doubles = 15;
constexpr std::int64_t arrays_of_indices = 2;

System lay_out(NormalWorkspace& workspace, std::int32_t n) {
  double* next = workspace.memory;
  const auto take = [&](std::int64_t size) {
    double* const block = next;
    next += size;
    return block;
  };
  System s;
  s.grid.y = take(n);
  s.grid.width = take(n);
  for (double** field : {&s.height, &s.curvature, &s.gap_centre, &s.half_length, &s.inverse_length, &s.centre,
                         &s.peak, &s.by_approach, &s.by_height, &s.length_change, &s.centre_change})
    *field = take(n);
  s.influence = take(static_cast<std::int64_t>(n) * n);
  s.matrix = take(static_cast<std::int64_t>(n) * n);
  // Indices live in doubles' places: both are plain memory of sufficient size and alignment.
  s.grid.region = reinterpret_cast<std::int32_t*>(take(n));
  s.active = reinterpret_cast<std::int32_t*>(take(n));
  return s;
}

/// Value of the start's array at y: linear between its strips, that of the end strips outside.
double start_value(const StripHalfspaceStart& start, const double* value, double y) {
  const double* const above = std::upper_bound(start.y, start.y + start.count, y);
  const auto j = static_cast<std::int32_t>(above - start.y);
  if (j == 0) return value[0];
  if (j == start.count) return value[j - 1];
  const double t = (y - start.y[j - 1]) / (start.y[j] - start.y[j - 1]);
  return value[j - 1] + t * (value[j] - value[j - 1]);
}

/// Places the strips and gives them a first half length: half the virtual penetration for a cold start.
void place(const NormalProblem& problem, const GapMinimum& lowest, double approach, double depth,
           const StripHalfspaceStart& start, System& s) {
  const GapRows& rows = problem.gap;
  build_collocation_grid(rows, lowest.height, depth, problem.strips, s.grid);
  s.skewed = false;
  s.active_count = 0;
  for (std::int32_t j = 0; j < s.grid.count; ++j) {
    const GapRow row = interpolate(rows, s.grid.y[j]);
    s.height[j] = row.height - lowest.height;
    s.curvature[j] = row.curvature;
    s.gap_centre[j] = row.centre;
    s.skewed = s.skewed || row.centre != s.gap_centre[0];
    const double smallest = 0.06 * approach / row.curvature;
    const double cold = (approach - 2.0 * s.height[j]) / row.curvature;
    const bool warm = start.count > 1;
    const double squared = warm ? start_value(start, start.length_squared, s.grid.y[j]) : cold;
    s.half_length[j] = std::sqrt(std::max(squared, smallest));
    s.centre[j] = row.centre + (warm ? start_value(start, start.shift, s.grid.y[j]) : 0.0);
    if (s.height[j] < 0.7 * approach) s.active[s.active_count++] = j;
  }
  if (s.active_count == 0) s.active[s.active_count++] = 0;
}

/// Midpoint error of the line potential's logarithm over a strip of width w at distance r, over the midpoint
/// value's own unit: see strip_displacement (contact_condition.cpp).
inline double width_correction(double w, double l, double r2) {
  const double t2 = 0.25 * w * w / r2;
  return 2.0 * t2 * (1.0 / 6.0 + t2 * (1.0 / 20.0 + t2 / 42.0)) * l / std::sqrt(l * l + r2);
}

void build_influence(const StripKernel& kernel, System& s) {
  const std::int32_t n = s.grid.count;
  for (std::int32_t i = 0; i < n; ++i) s.inverse_length[i] = 1.0 / s.half_length[i];
  for (std::int32_t j = 0; j < n; ++j) {
    double* const row = s.influence + static_cast<std::int64_t>(j) * n;
    for (std::int32_t i = 0; i < n; ++i) {
      const double dy = s.grid.y[i] - s.grid.y[j];
      const double dx = s.centre[i] - s.centre[j];
      const double r2 = dy * dy + dx * dx;
      const double w = s.grid.width[i];
      const double l = s.half_length[i];
      if (i == j)
        row[i] = w * kernel.own_middle(0.5 * w * s.inverse_length[i]);
      else
        row[i] = w * (kernel.middle_plane(std::sqrt(r2) * s.inverse_length[i]) + width_correction(w, l, r2));
    }
  }
}

/// Pressures of the active strips for the present lengths; returns the approach. Strips that pull leave and
/// strips that overlap enter, a few times at most: what is left over is settled in the next sweep.
double solve_pressures(const NormalProblem& problem, System& s, double& stiffness) {
  const std::int32_t n = s.grid.count;
  const double compliance = problem.material.normal_compliance();
  double approach = problem.approach;
  constexpr int rounds = 6;
  for (int round = 0; round < rounds; ++round) {
    const std::int32_t m = s.active_count;
    for (std::int32_t a = 0; a < m; ++a) {
      const double* const row = s.influence + static_cast<std::int64_t>(s.active[a]) * n;
      double* const target = s.matrix + static_cast<std::int64_t>(a) * m;
      for (std::int32_t b = 0; b < m; ++b) target[b] = row[s.active[b]];
      s.by_approach[a] = 1.0 / compliance;
      s.by_height[a] = s.height[s.active[a]] / compliance;
    }
    solve_two(m, s.matrix, s.by_approach, s.by_height);

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

    std::fill(s.peak, s.peak + n, 0.0);
    bool pulls = false;
    for (std::int32_t a = 0; a < m; ++a) {
      const double peak = approach * s.by_approach[a] - s.by_height[a];
      s.peak[s.active[a]] = peak;
      pulls = pulls || peak <= 0.0;
    }
    std::int32_t next_count = 0;
    bool changed = false;
    if (pulls) {
      for (std::int32_t a = 0; a < m; ++a)
        if (s.peak[s.active[a]] > 0.0) s.active[next_count++] = s.active[a];
      changed = true;
    } else {
      std::int32_t a = 0;
      for (std::int32_t j = 0; j < n; ++j) {
        bool in = a < m && s.active[a] == j;
        if (in) {
          ++a;
        } else if (s.height[j] < approach) {
          const double* const row = s.influence + static_cast<std::int64_t>(j) * n;
          double displacement = 0.0;
          for (std::int32_t i = 0; i < n; ++i) displacement += row[i] * s.peak[i];
          in = compliance * displacement < approach - s.height[j];
          changed = changed || in;
        }
        // by_height is free by now and keeps the new list until the old one has been read.
        if (in) s.length_change[next_count++] = j;
      }
      for (std::int32_t k = 0; k < next_count; ++k)
        s.active[k] = static_cast<std::int32_t>(s.length_change[k]);
    }
    s.active_count = next_count;
    if (!changed || next_count == 0) break;
  }
  return approach;
}

/// Displacement at the edge of strip j towards +x (side = 1) or -x (side = -1) [m].
double edge_displacement(const StripKernel& kernel, const System& s, std::int32_t j, double side) {
  double sum = 0.0;
  const double x = s.centre[j] + side * s.half_length[j];
  for (std::int32_t a = 0; a < s.active_count; ++a) {
    const std::int32_t i = s.active[a];
    const double inverse = s.inverse_length[i];
    const double strip = s.peak[i] * s.grid.width[i];
    if (i == j)
      sum += strip * kernel.own_edge(0.5 * s.grid.width[i] * inverse);
    else
      sum += strip *
             kernel.at(std::abs(s.grid.y[i] - s.grid.y[j]) * inverse, std::abs(x - s.centre[i]) * inverse);
  }
  return sum;
}

/// Means of three neighbours, 1/4 1/2 1/4, within each run of touching active strips.
void smooth(const System& s, double* change) {
  double before = change[0];
  for (std::int32_t a = 0; a < s.active_count; ++a) {
    const double here = change[a];
    const bool left = a > 0 && s.active[a - 1] == s.active[a] - 1 &&
                      s.grid.region[s.active[a - 1]] == s.grid.region[s.active[a]];
    const bool right = a + 1 < s.active_count && s.active[a + 1] == s.active[a] + 1 &&
                       s.grid.region[s.active[a + 1]] == s.grid.region[s.active[a]];
    double from_left = left ? before : here;
    double from_right = right ? change[a + 1] : here;
    if (!left && right) from_left = from_right;
    if (left && !right) from_right = from_left;
    change[a] = 0.25 * from_left + 0.5 * here + 0.25 * from_right;
    before = here;
  }
}

/// True if active strips number a and a + 1 touch.
bool touch(const System& s, std::int32_t a) {
  return s.active[a + 1] == s.active[a] + 1 && s.grid.region[s.active[a + 1]] == s.grid.region[s.active[a]];
}

/// The outermost strip of a patch takes its length from its load instead: p / l is smooth across the border
/// of a patch, where p and l go to zero together, and q = (pi/2) p l is what the centre condition gives. A
/// strip that has just entered so finds its length at once.
void settle_ends(System& s) {
  for (std::int32_t a = 0; a < s.active_count; ++a) {
    const bool left = a > 0 && touch(s, a - 1);
    const bool right = a + 1 < s.active_count && touch(s, a);
    if (left == right) continue;
    const std::int32_t j = s.active[a];
    const std::int32_t inner = s.active[left ? a - 1 : a + 1];
    const double level = s.peak[inner] * s.inverse_length[inner];
    const double ratio = s.peak[j] * s.inverse_length[j] / level;  // l_new^2 / l^2 at constant p l
    s.length_change[a] = (std::clamp(ratio, 0.1, 10.0) - 1.0) / (std::clamp(ratio, 0.1, 10.0) + 1.0);
  }
}

/// Moves lengths and centres towards the edge conditions.
///
/// In a long contact, q = (pi/2) p l is what the centre condition fixes and l^2 = 4 c q / curvature: the
/// length that the present displacement drop asks for is therefore l sqrt(drop / (curvature l^2 / 2)), at
/// constant q. A single thin strip hardly feels its own length, only that of its neighbourhood: changes are
/// smoothed over three strips, or the sawtooth between neighbours, which no condition holds, would grow.
void move_edges(const NormalProblem& problem, const StripKernel& kernel, double approach, System& s) {
  const double compliance = problem.material.normal_compliance();
  for (std::int32_t a = 0; a < s.active_count; ++a) {
    const std::int32_t j = s.active[a];
    const double l = s.half_length[j];
    const double leading = compliance * edge_displacement(kernel, s, j, 1.0);
    const double trailing = s.skewed ? compliance * edge_displacement(kernel, s, j, -1.0) : leading;
    const double drop = approach - s.height[j] - 0.5 * (leading + trailing);
    const double ratio = std::clamp(drop / (0.5 * s.curvature[j] * l * l), 0.25, 4.0);
    s.length_change[a] = 0.5 * (ratio - 1.0) / (0.5 + 0.5 * ratio);  // about ln(ratio) / 2
    // h(edge, leading) - h(edge, trailing) = 2 curvature l (x_c - gap_centre)
    const double wanted = s.gap_centre[j] - (leading - trailing) / (2.0 * l * s.curvature[j]);
    s.centre_change[a] = 0.5 * (wanted - s.centre[j]);
  }
  smooth(s, s.length_change);
  settle_ends(s);
  if (s.skewed) smooth(s, s.centre_change);
  for (std::int32_t a = 0; a < s.active_count; ++a) {
    const std::int32_t j = s.active[a];
    const double d = 0.5 * s.length_change[a];
    s.half_length[j] *= (1.0 + d) / (1.0 - d);  // about exp(length_change), and positive
    const double reach = 0.5 * s.half_length[j];
    s.centre[j] =
        std::clamp(s.centre[j] + s.centre_change[a], s.gap_centre[j] - reach, s.gap_centre[j] + reach);
  }
}

double active_area(const System& s) {
  double area = 0.0;
  for (std::int32_t a = 0; a < s.active_count; ++a)
    area += 2.0 * s.half_length[s.active[a]] * s.grid.width[s.active[a]];
  return area;
}

/// The outermost strips of the grid are in contact: the margin was too small.
bool touches_the_grids_end(const System& s) {
  return s.active_count > 0 && (s.active[0] == 0 || s.active[s.active_count - 1] == s.grid.count - 1);
}

}  // namespace

std::int64_t strip_halfspace_workspace(std::int32_t strips) noexcept {
  const auto n = static_cast<std::int64_t>(strips);
  return (arrays_of_doubles + arrays_of_indices) * n + 2 * n * n;
}

Fault solve_strip_halfspace(const NormalProblem& problem, const StripHalfspaceOptions& options,
                            const StripKernel& kernel, NormalWorkspace& workspace, StripHalfspaceStart& start,
                            Strips& strips, NormalSolution& solution) noexcept {
  solution = {};
  Fault fault = check_normal_problem(problem, strips);
  if (fault.status != WRC_OK) return fault;
  if (workspace.capacity < strip_halfspace_workspace(problem.strips) || start.capacity < problem.strips)
    return {
        .status = WRC_ERROR_BUFFER, .field = "workspace", .value = static_cast<double>(workspace.capacity)};

  const GapRows& rows = problem.gap;
  const GapMinimum lowest = minimum(rows);
  const double ceiling = deepest_approach(rows, lowest);
  const bool load = problem.prescribed == Prescribed::load;
  double approach = load ? foundation_approach(rows, lowest.height, problem.material.normal_compliance(),
                                               problem.normal_force)
                         : problem.approach;
  double depth = depth_per_approach * approach;

  System s = lay_out(workspace, problem.strips);
  constexpr int widenings = 3;
  bool converged = false;
  for (int attempt = 0; attempt < widenings; ++attempt) {
    place(problem, lowest, approach, depth, start, s);
    double area = 0.0;
    converged = false;
    for (std::int32_t sweep = 0; sweep < options.max_sweeps && !converged; ++sweep) {
      build_influence(kernel, s);
      const double before = approach;
      approach = solve_pressures(problem, s, solution.stiffness);
      ++solution.iterations;
      if (s.active_count == 0) break;
      const double next_area = active_area(s);
      converged = sweep > 0 && std::abs(approach - before) <= options.tolerance * approach &&
                  std::abs(next_area - area) <= options.tolerance * area;
      area = next_area;
      if (!converged) move_edges(problem, kernel, approach, s);
    }
    if (!touches_the_grids_end(s) || s.grid.at_edge) break;
    depth *= 1.4;
  }
  if (approach > ceiling || s.active_count == 0)
    return {.status = WRC_ERROR_LOAD,
            .field = load ? "normal_force" : "approach",
            .value = load ? problem.normal_force : problem.approach,
            .unit = load ? "N" : "m",
            .cause = "the gap given is too narrow"};

  // Keep the solution as the next start, drop what is not in contact, and cut it into the caller's strips.
  start.count = s.active_count;
  for (std::int32_t a = 0; a < s.active_count; ++a) {
    const std::int32_t j = s.active[a];
    s.grid.y[a] = start.y[a] = s.grid.y[j];
    s.grid.width[a] = s.grid.width[j];
    s.grid.region[a] =
        s.grid.region[j] + (j - a) * most_regions;  // strips left out in between part the regions
    start.length_squared[a] = s.half_length[j] * s.half_length[j];
    start.shift[a] = s.centre[j] - s.gap_centre[j];
    s.centre[a] = s.centre[j];
    s.half_length[a] = s.half_length[j];
    s.peak[a] = s.peak[j];
  }
  const SolvedStrips solved{s.active_count, s.grid.y, s.grid.width, s.centre,
                            s.half_length,  s.peak,   s.grid.region};
  const double carried = recut_strips(solved, problem.strips, strips);
  solution.approach = approach;
  solution.normal_force = carried;
  const bool at_edge = s.grid.at_edge && touches_the_grids_end(s);
  complete_solution(strips, lowest, at_edge, solution, fault);
  if (!converged)
    worsen(fault, {.status = WRC_FLAG_ITERATION_CAP,
                   .field = "max_sweeps",
                   .value = static_cast<double>(options.max_sweeps)});
  return fault;
}

}  // namespace wrc
