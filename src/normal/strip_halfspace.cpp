#include "normal/strip_halfspace.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "elementary.hpp"
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

/// A strip enters when the bodies would overlap by this part of the approach: rounding must not decide.
constexpr double overlap_to_enter = 1e-4;

/// Strips of the solver for strips of the result: the solver's stand where they are needed.
std::int32_t collocation_strips(std::int32_t strips) { return std::max((7 * strips) / 10, std::int32_t{4}); }

/// The solver's strips; arrays in the workspace, all `grid.count` long.
struct System {
  CollocationGrid grid;
  /// The strip as the grid has it; grid.y and grid.width of a patch's outermost strips are fitted to its
  /// border.
  double *cell_y = nullptr, *cell_width = nullptr;
  double* height = nullptr;     ///< over the lowest point [m]
  double* curvature = nullptr;  ///< d2h/dx2 [1/m]
  double* gap_centre = nullptr;
  double* half_length = nullptr;
  double* inverse_length = nullptr;
  double* centre = nullptr;
  double* peak = nullptr;
  /// count x count, row j column i: displacement at the middle of j by unit peak in i, over the compliance
  /// [m].
  double* influence = nullptr;
  double* matrix = nullptr;  ///< of the active strips
  double* by_approach = nullptr;
  double* by_height = nullptr;
  double* level = nullptr;  ///< p / l the edge conditions ask for [Pa/m]
  double* shift = nullptr;  ///< of the centre against the gap's [m]
  /// Neighbouring active strips joined two by two.
  double *pair_y = nullptr, *pair_centre = nullptr, *pair_inverse_length = nullptr, *pair_strength = nullptr;
  std::int32_t* active = nullptr;  ///< indices of the strips in contact
  std::int32_t* next_active = nullptr;
  std::int32_t active_count = 0;
  bool skewed = false;
};

constexpr std::int64_t arrays_of_doubles = 19;
constexpr std::int64_t arrays_of_indices = 3;

System lay_out(const NormalWorkspace& workspace, std::int32_t n) {
  auto* next = static_cast<double*>(workspace.memory);
  const auto take = [&](std::int64_t size) {
    double* const block = next;
    next += size;
    return block;
  };
  System s;
  for (double** field :
       {&s.grid.y, &s.grid.width, &s.cell_y, &s.cell_width, &s.height, &s.curvature, &s.gap_centre,
        &s.half_length, &s.inverse_length, &s.centre, &s.peak, &s.by_approach, &s.by_height, &s.level,
        &s.shift, &s.pair_y, &s.pair_centre, &s.pair_inverse_length, &s.pair_strength})
    *field = take(n);
  s.influence = take(static_cast<std::int64_t>(n) * n);
  s.matrix = take(static_cast<std::int64_t>(n) * n);
  auto* const indices =
      reinterpret_cast<std::int32_t*>(next);  // behind the doubles, in memory nobody has typed yet
  s.grid.region = indices;
  s.active = indices + n;
  s.next_active = indices + 2 * n;
  return s;
}

/// The start's l^2 and shift at y, linear between its strips; nothing where it had no contact.
struct Started {
  bool in_contact = false;
  double length_squared = 0.0, shift = 0.0;
};
Started started(const StripHalfspaceStart& start, double y) {
  if (start.count == 0) return {};
  const auto above = static_cast<std::int32_t>(std::upper_bound(start.y, start.y + start.count, y) - start.y);
  const std::int32_t right = std::min(above, start.count - 1);
  const std::int32_t left = std::max(above - 1, 0);
  const bool in_left = std::abs(y - start.y[left]) <= 0.5 * start.width[left];
  const bool in_right = std::abs(y - start.y[right]) <= 0.5 * start.width[right];
  if (!in_left && !in_right) return {};
  const double apart = start.y[right] - start.y[left];
  const double touching = 0.5 * (start.width[left] + start.width[right]);
  double t = in_left ? 0.0 : 1.0;
  if (left != right && apart < 1.01 * touching) t = (y - start.y[left]) / apart;
  return {true, start.length_squared[left] + t * (start.length_squared[right] - start.length_squared[left]),
          start.shift[left] + t * (start.shift[right] - start.shift[left])};
}

/// Puts strip j at y with the gap's row there.
void put(const GapRows& rows, double lowest_height, std::int32_t j, double y, double width, System& s) {
  const GapRow row = interpolate(rows, y);
  s.grid.y[j] = y;
  s.grid.width[j] = width;
  s.height[j] = row.height - lowest_height;
  s.curvature[j] = row.curvature;
  s.gap_centre[j] = row.centre;
}

/// Places the strips and gives them a first half length: that of the last solution where it had contact, half
/// the virtual penetration elsewhere.
void place(const NormalProblem& problem, const GapMinimum& lowest, double approach, double depth,
           const StripHalfspaceStart& start, System& s) {
  build_collocation_grid(problem.gap, lowest, depth, collocation_strips(problem.strips), s.grid);
  s.skewed = false;
  s.active_count = 0;
  for (std::int32_t j = 0; j < s.grid.count; ++j) {
    s.cell_y[j] = s.grid.y[j];
    s.cell_width[j] = s.grid.width[j];
    put(problem.gap, lowest.height, j, s.cell_y[j], s.cell_width[j], s);
    s.skewed = s.skewed || s.gap_centre[j] != s.gap_centre[0];
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

/// Midpoint error of the line potential's logarithm over a strip of width w at distance r, over the midpoint
/// value's own unit: see strip_displacement (contact_condition.cpp).
inline double width_correction(double w, double l, double r2) {
  const double t2 = 0.25 * w * w / r2;
  return 2.0 * t2 * (1.0 / 6.0 + t2 * (1.0 / 20.0 + t2 / 42.0)) * l / std::sqrt(l * l + r2);
}

/// J(tau, xi) for xi mostly near 0: the middle plane's with the leading effect of xi, which is right both
/// near the line, sqrt(1 - xi^2), and far from it, 1 / sqrt(tau^2 + xi^2).
inline double seen_from(const StripKernel& kernel, double tau, double xi) {
  const double xi2 = xi * xi;
  if (xi2 > 0.09) return kernel.at(tau, std::abs(xi));
  return kernel.middle_plane(tau) * (1.0 - 0.5 * xi2 / (1.0 + tau * tau));
}

void build_influence(const StripKernel& kernel, System& s) {
  constexpr std::int32_t near = 8;  // strips away: beyond, the correction is below 2e-3 of an entry
  const std::int32_t n = s.grid.count;
  for (std::int32_t i = 0; i < n; ++i) s.inverse_length[i] = 1.0 / s.half_length[i];
  for (std::int32_t j = 0; j < n; ++j) {
    double* const row = s.influence + static_cast<std::int64_t>(j) * n;
    for (std::int32_t i = 0; i < n; ++i) {
      const double tau = std::abs(s.grid.y[i] - s.grid.y[j]) * s.inverse_length[i];
      row[i] = s.grid.width[i] * seen_from(kernel, tau, (s.centre[i] - s.centre[j]) * s.inverse_length[i]);
    }
    for (std::int32_t i = std::max(j - near, 0); i < std::min(j + near + 1, n); ++i) {
      if (i == j) continue;
      const double distance = s.grid.y[i] - s.grid.y[j];
      row[i] += s.grid.width[i] * width_correction(s.grid.width[i], s.half_length[i], distance * distance);
    }
    row[j] = s.grid.width[j] * kernel.own_middle(0.5 * s.grid.width[j] * s.inverse_length[j]);
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
      for (std::int32_t a = 0; a < m; ++a) {
        double& peak = s.peak[s.active[a]];
        if (peak > 0.0)
          s.active[next_count++] = s.active[a];
        else
          peak = 0.0;
      }
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
          in = compliance * displacement < (1.0 - overlap_to_enter) * approach - s.height[j];
          changed = changed || in;
        }
        if (in) s.next_active[next_count++] = j;
      }
      std::swap(s.active, s.next_active);
    }
    s.active_count = next_count;
    if (!changed || next_count == 0) break;
  }
  return approach;
}

/// Joins neighbouring active strips two by two, at the centroid of their load, for edges that see them from
/// afar.
void join_pairs(System& s) {
  for (std::int32_t k = 0; 2 * k < s.active_count; ++k) {
    const std::int32_t end = std::min(2 * k + 2, s.active_count);
    const auto area = [&](std::int32_t i) { return s.half_length[i] * s.grid.width[i]; };
    double load = 0.0;
    for (std::int32_t a = 2 * k; a < end; ++a) load += s.peak[s.active[a]] * area(s.active[a]);
    // A pair that carries nothing yet, or pulls and is about to leave, has no centroid of load: then of area.
    const bool presses = load > 0.0;
    double sum = 0.0, y = 0.0, centre = 0.0, length = 0.0;
    for (std::int32_t a = 2 * k; a < end; ++a) {
      const std::int32_t i = s.active[a];
      const double part = presses ? s.peak[i] * area(i) : area(i);
      sum += part;
      y += part * s.grid.y[i];
      centre += part * s.centre[i];
      length += part * s.half_length[i];
    }
    s.pair_y[k] = y / sum;
    s.pair_centre[k] = centre / sum;
    s.pair_inverse_length[k] = sum / length;
    s.pair_strength[k] = load * s.pair_inverse_length[k];
  }
}

/// Displacement at the edge of active strip number a towards +x (side = 1) or -x (side = -1), over the
/// compliance [m Pa].
double edge_displacement(const StripKernel& kernel, const System& s, std::int32_t a, double side) {
  constexpr std::int32_t near = 2;  // pairs to each side whose strips are taken one by one
  const std::int32_t j = s.active[a];
  const double x = s.centre[j] + side * s.half_length[j];
  const double y = s.grid.y[j];
  const std::int32_t pairs = (s.active_count + 1) / 2;
  const std::int32_t first_near = std::max(a / 2 - near, 0);
  const std::int32_t end_near = std::min(a / 2 + near + 1, pairs);
  double sum = 0.0;
  const auto add_pair = [&](std::int32_t k) {
    const double inverse = s.pair_inverse_length[k];
    sum += s.pair_strength[k] *
           kernel.at(std::abs(s.pair_y[k] - y) * inverse, std::abs(x - s.pair_centre[k]) * inverse);
  };
  for (std::int32_t k = 0; k < first_near; ++k) add_pair(k);
  for (std::int32_t b = 2 * first_near; b < std::min(2 * end_near, s.active_count); ++b) {
    const std::int32_t i = s.active[b];
    const double inverse = s.inverse_length[i];
    sum += s.peak[i] * s.grid.width[i] *
           (i == j ? kernel.own_edge(0.5 * s.grid.width[i] * inverse)
                   : kernel.at(std::abs(s.grid.y[i] - y) * inverse, std::abs(x - s.centre[i]) * inverse));
  }
  for (std::int32_t k = end_near; k < pairs; ++k) add_pair(k);
  return sum;
}

/// True if active strips number a and a + 1 touch.
bool touch(const System& s, std::int32_t a) {
  return s.active[a + 1] == s.active[a] + 1 && s.grid.region[s.active[a + 1]] == s.grid.region[s.active[a]];
}

/// One past the last active strip of the patch that active strip `first` opens.
std::int32_t run_end(const System& s, std::int32_t first) {
  std::int32_t a = first;
  while (a + 1 < s.active_count && touch(s, a)) ++a;
  return a + 1;
}

/// Means of three neighbours, 1/4 1/2 1/4, within each patch. The outermost strips of a patch take the value
/// of their inner neighbours; two strips alone their mean.
void smooth(const System& s, double* value) {
  for (std::int32_t first = 0, end = 0; first < s.active_count; first = end) {
    end = run_end(s, first);
    const std::int32_t last = end - 1;
    if (last == first + 1) value[first] = value[last] = 0.5 * (value[first] + value[last]);
    if (last < first + 2) continue;
    double before = value[first];
    value[first] = value[first + 1];
    const double last_inner = value[last - 1];
    for (std::int32_t a = first + 1; a < last; ++a) {
      const double here = value[a];
      value[a] = 0.25 * before + 0.5 * here + 0.25 * value[a + 1];
      before = here;
    }
    value[last] = last_inner;
  }
}

/// Moves lengths and centres towards the edge conditions; returns how much area moved, over the area [-].
///
/// In a long contact, q = (pi/2) p l is what the centre condition fixes and l^2 = 4 c q / curvature: the
/// displacement drop from centre to edge therefore asks for a level p / l that is smaller by drop /
/// (curvature l^2 / 2), at constant q. A single thin strip hardly feels its own length, only that of its
/// neighbourhood: a sawtooth of lengths meets every condition. The level is smooth along y, also at the ends
/// of a patch where p and l vanish together, so it is the level that is averaged over three strips.
double move_edges(const NormalProblem& problem, const StripKernel& kernel, double approach, System& s) {
  const double compliance = problem.material.normal_compliance();
  join_pairs(s);
  for (std::int32_t a = 0; a < s.active_count; ++a) {
    const std::int32_t j = s.active[a];
    const double l = s.half_length[j];
    const double leading = compliance * edge_displacement(kernel, s, a, 1.0);
    const double trailing = s.skewed ? compliance * edge_displacement(kernel, s, a, -1.0) : leading;
    const double drop = approach - s.height[j] - 0.5 * (leading + trailing);
    const double ratio = std::clamp(drop / (0.5 * s.curvature[j] * l * l), 0.25, 4.0);
    s.level[a] = s.peak[j] * s.inverse_length[j] / ratio;
    // h(leading edge) - h(trailing edge) = 2 curvature l (x_c - gap_centre); half the way there.
    const double wanted = (trailing - leading) / (2.0 * l * s.curvature[j]);
    s.shift[a] = 0.5 * (wanted + s.centre[j] - s.gap_centre[j]);
  }
  smooth(s, s.level);
  if (s.skewed) smooth(s, s.shift);

  double moved = 0.0, area = 0.0;
  for (std::int32_t a = 0; a < s.active_count; ++a) {
    const std::int32_t j = s.active[a];
    const double level = s.peak[j] * s.inverse_length[j];
    const double wanted =
        s.level[a] > 0.0 ? level / s.level[a] : 1.0;  // l_new^2 / l^2; as it is without load
    const double stretch = std::sqrt(std::clamp(wanted, 0.1, 10.0));
    moved += std::abs(stretch - 1.0) * s.half_length[j] * s.grid.width[j];
    area += s.half_length[j] * s.grid.width[j];
    s.half_length[j] *= stretch;
    s.peak[j] /= stretch;
    const double reach = 0.5 * s.half_length[j];
    if (s.skewed) s.centre[j] = s.gap_centre[j] + std::clamp(s.shift[a], -reach, reach);
  }
  return moved / area;
}

/// Fits the outermost strips of every patch of three or more to its border, where l^2, linear through the
/// last two strips, vanishes. The outermost strip may stretch to one and a half of its cell: beyond, the next
/// one is in contact. Without it a strip the border runs through counts as wholly in contact, and area jumps
/// by cells.
void fit_ends(const GapRows& rows, double lowest_height, System& s) {
  const auto refit = [&](std::int32_t j, double y, double width, double half_length) {
    const double centre_before = s.gap_centre[j];
    s.peak[j] *= s.half_length[j] * s.grid.width[j] / (half_length * width);  // the strip's load stays
    s.half_length[j] = half_length;
    put(rows, lowest_height, j, y, width, s);
    s.centre[j] += s.gap_centre[j] - centre_before;
  };
  const auto fit = [&](std::int32_t j, std::int32_t inner) {
    const double side = j > inner ? 1.0 : -1.0;  // where the border is, seen from the strip
    const double l2 = s.half_length[j] * s.half_length[j];
    const double inner_l2 = s.half_length[inner] * s.half_length[inner];
    const double slope = (inner_l2 - l2) / std::abs(s.grid.y[inner] - s.grid.y[j]);
    if (!(slope > 0.0)) return;
    const double inner_border = s.cell_y[j] - side * 0.5 * s.cell_width[j];
    const double reach = side * (s.grid.y[j] - inner_border) + l2 / slope;
    const std::int32_t beyond = std::clamp(2 * j - inner, 0, s.grid.count - 1);
    const double most = s.cell_width[j] + 0.5 * s.cell_width[beyond];
    const double extent = std::clamp(reach, 0.1 * s.cell_width[j], most);
    refit(j, inner_border + side * 0.5 * extent, extent, std::sqrt(0.5 * slope * extent));
  };
  for (std::int32_t first = 0, end = 0; first < s.active_count; first = end) {
    end = run_end(s, first);
    const bool fitted = end - first >= 3;
    for (std::int32_t a = first; a < end; ++a) {
      const std::int32_t j = s.active[a];
      const bool outermost = a == first || a == end - 1;
      if (s.grid.width[j] != s.cell_width[j] && !(fitted && outermost))
        refit(j, s.cell_y[j], s.cell_width[j], s.half_length[j]);
    }
    if (!fitted) continue;
    fit(s.active[first], s.active[first + 1]);
    fit(s.active[end - 1], s.active[end - 2]);
  }
}

/// dN / d(approach) is the load of a flat punch on the contact area, whose pressure is singular at the edge.
/// The derivative of the strips' own, semi-elliptic pressure comes out smaller, on Hertz's ellipse by the
/// factor fitted here in z = ln(a / b), a / b = 0.1 .. 18, to 1 %; on S1002/UIC60 patches it holds to 3 %.
double punch_stiffness(double stiffness, const StripTotals& sum) {
  const double z = natural_log(pi * sum.length * sum.length / (4.0 * sum.area));
  return stiffness * (1.27 + z * (0.0777 + 0.0078 * z));
}

/// The outermost strips of the grid are in contact: the margin was too small.
bool touches_the_grids_end(const System& s) {
  return s.active_count > 0 && (s.active[0] == 0 || s.active[s.active_count - 1] == s.grid.count - 1);
}

}  // namespace

std::int64_t strip_halfspace_workspace(std::int32_t strips) noexcept {
  const auto n = static_cast<std::int64_t>(strips);
  constexpr auto real = static_cast<std::int64_t>(sizeof(double));
  constexpr auto index = static_cast<std::int64_t>(sizeof(std::int32_t));
  return (arrays_of_doubles * n + 2 * n * n) * real + arrays_of_indices * n * index;
}

Fault solve_strip_halfspace(const NormalProblem& problem, const StripHalfspaceOptions& options,
                            const StripKernel& kernel, NormalWorkspace& workspace, StripHalfspaceStart& start,
                            Strips& strips, NormalSolution& solution) noexcept {
  solution = {};
  Fault fault = check_normal_problem(problem, strips);
  if (fault.status != WRC_OK) return fault;
  if (workspace.bytes < strip_halfspace_workspace(problem.strips) || start.capacity < problem.strips)
    return {.status = WRC_ERROR_BUFFER, .field = "workspace", .value = static_cast<double>(workspace.bytes)};

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
    if (start.count > 0) fit_ends(rows, lowest.height, s);
    converged = false;
    for (std::int32_t sweep = 0; sweep < options.max_sweeps && !converged && s.active_count > 0; ++sweep) {
      build_influence(kernel, s);
      approach = solve_pressures(problem, s, solution.stiffness);
      ++solution.iterations;
      if (s.active_count == 0) break;
      converged = move_edges(problem, kernel, approach, s) <= options.tolerance;
      fit_ends(rows, lowest.height, s);
    }
    if (s.active_count == 0 && start.count > 0) {
      start.count = 0;  // a start that far off is worse than none
      continue;
    }
    if (!touches_the_grids_end(s) || s.grid.at_edge) break;
    depth *= 1.4;
  }
  if (!(approach > 0.0))
    return {.status = WRC_ERROR_GAP,
            .field = "gap.height",
            .value = approach,
            .unit = "m",
            .cause = "heights leap from row to row: the gap between them dips below the rows"};
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
    start.width[a] = s.grid.width[j];
    start.length_squared[a] = s.half_length[j] * s.half_length[j];
    start.shift[a] = s.centre[j] - s.gap_centre[j];
    s.centre[a] = s.centre[j];
    s.half_length[a] = s.half_length[j];
    s.peak[a] = s.peak[j];
  }
  const SolvedStrips solved{s.active_count, s.grid.y, s.grid.width, s.centre,
                            s.half_length,  s.peak,   s.grid.region};
  solution.normal_force = recut_strips(solved, problem.strips, strips);
  solution.approach = approach;
  if (load) {
    // Equal already, unless the cap cut the last exchange of strips short.
    for (std::int32_t j = 0; j < strips.count; ++j)
      strips.peak[j] *= problem.normal_force / solution.normal_force;
    solution.normal_force = problem.normal_force;
  }
  const bool at_edge = s.grid.at_edge && touches_the_grids_end(s);
  complete_solution(strips, lowest, at_edge, solution, fault);
  solution.stiffness = punch_stiffness(solution.stiffness, totals(strips));
  if (!converged)
    worsen(fault, {.status = WRC_FLAG_ITERATION_CAP,
                   .field = "max_sweeps",
                   .value = static_cast<double>(options.max_sweeps)});
  return fault;
}

}  // namespace wrc
