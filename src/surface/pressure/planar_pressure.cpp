#include "surface/pressure/planar_pressure.hpp"

#include <algorithm>
#include <array>

#include "base/arena.hpp"
#include "base/number.hpp"
#include "surface/pressure/lobes.hpp"

namespace wrc::surface {
namespace {

constexpr std::int32_t beyond = 3;  // rows added behind either end of a run, in which its patch ends

struct Memory {
  double* place;                            ///< arc length of each candidate [m]
  double *y, *height, *centre, *curvature;  ///< rows of the gap
  patch::Strips strips;                     ///< the method's, of one patch
};

Memory cut(Arena& arena, std::int32_t most, std::int32_t strips) {
  Memory m;
  m.place = arena.take(most);
  arena.each(most + 2 * beyond, m.y, m.height, m.centre, m.curvature);
  m.strips.capacity = strips;
  arena.each(strips, m.strips.y, m.strips.width, m.strips.half_length, m.strips.peak, m.strips.centre);
  return m;
}

/// Candidates first .. end - 1, strips of the rail side by side.
struct Run {
  std::int32_t first = 0, end = 0;
};

/// A part of a run as the method sees it.
struct Part {
  double share = 1.0;
  const LobeCut *low = nullptr, *high = nullptr;
};

class Solver {
 public:
  Solver(const RailStrips& rail, const Overlaps& overlaps, const PlanarMethod& method,
         const patch::Material& material, const Kernels& kernels, Arena arena, const StripPressure& pressure)
      : rail_(rail),
        overlaps_(overlaps),
        method_(method),
        material_(material),
        kernels_(kernels),
        pressure_(pressure),
        memory_(cut(arena, overlaps.capacity, method.strips)) {}

  PlanarResult solve() {
    const std::int32_t n = overlaps_.count;
    for (double* const a :
         {pressure_.length_squared, pressure_.peak_per_length, pressure_.centre, pressure_.line_load})
      std::fill_n(a, n, 0.0);
    for (std::int32_t i = 0; i < n; ++i) memory_.place[i] = rail_.s[overlaps_.strip[i]];
    // Runs of strips side by side, each cut into lobes; parts of several lobes count by their shares.
    for (Run run; run.end < n && !result_.fault.failed();) {
      run.first = run.end++;
      while (run.end < n && overlaps_.strip[run.end] == overlaps_.strip[run.end - 1] + 1) ++run.end;
      const LobeCuts cuts = find_lobes(memory_.place, overlaps_.depth, run.first, run.end);
      if (cuts.more) result_.jumps = true;
      for_each_part(cuts, [&](double share, const LobeCut* low, const LobeCut* high) {
        if (!result_.fault.failed()) solve_part(run, {share, low, high});
      });
    }
    // Centres were summed by line load; lambda = q / L.
    for (std::int32_t i = 0; i < n; ++i) {
      if (!(pressure_.line_load[i] > 0.0 && pressure_.length_squared[i] > 0.0)) continue;
      pressure_.peak_per_length[i] = pressure_.line_load[i] / pressure_.length_squared[i];
      pressure_.centre[i] /= pressure_.line_load[i];
    }
    return result_;
  }

 private:
  static constexpr double least_curvature = 0.01;  // [1/m]: along x a wheel is a parabola
  static constexpr double steps_down = 0.1e-3;     // from row to row behind the ends [m]
  static constexpr double fall = 5.0;              // beyond a border, that of a cylinder of 0.1 m [1/m]

  /// Rows of the gap: the run, turned over and bent away beyond the part's borders, and a few rows that fall
  /// away behind it.
  patch::GapRows rows_of(const Run& run, const Part& part) {
    // Heights are negative overlaps [m].
    const std::int32_t n = run.end - run.first;
    double* const height = memory_.height + beyond;
    const auto place = [&](std::int32_t k) { return memory_.place[run.first + k]; };
    for (std::int32_t k = 0; k < n; ++k) height[k] = -overlaps_.depth[run.first + k];
    // Beyond a border the gap is mirrored at the valley's height, so that it opens there, and bent away like
    // a cylinder; it never falls again.
    const auto turn = [&](const LobeCut& cut, std::int32_t from, std::int32_t end, std::int32_t step) {
      double nearest = -cut.value;
      for (std::int32_t k = from; k != end; k += step) {
        nearest = larger(nearest, -2.0 * cut.value - height[k]);
        const double away = place(k) - cut.place;
        height[k] = nearest + fall * away * away;
      }
    };
    // Rows of the part itself, between its borders.
    std::int32_t low = 0, high = n - 1;
    while (part.low && low < n && place(low) < part.low->place) ++low;
    while (part.high && high >= 0 && place(high) > part.high->place) --high;
    if (part.low) turn(*part.low, low - 1, -1, -1);
    if (part.high) turn(*part.high, high + 1, n, 1);
    // Rows behind the ends go on with the last strip's centre and curvature, each a little higher.
    for (std::int32_t k = -beyond; k < n + beyond; ++k) {
      const std::int32_t inside = std::clamp(k, 0, n - 1), i = run.first + inside, away = k - inside;
      memory_.y[k + beyond] = memory_.place[i] + away * rail_.width[overlaps_.strip[i]];
      if (away != 0) height[k] = height[inside] + (away < 0 ? -away : away) * steps_down;
      memory_.centre[k + beyond] = overlaps_.centre[i];
      memory_.curvature[k + beyond] = larger(overlaps_.curvature[i], least_curvature);
    }
    return {n + 2 * beyond, memory_.y, memory_.height, memory_.centre, memory_.curvature};
  }

  static constexpr std::int32_t most_points = 4;

  /// Lowest points of a patch as deep as its deepest but for 10 % of the overlap, and their weights.
  struct Points {
    std::array<patch::GapMinimum, most_points> of{};
    std::array<double, most_points> weight{};
    std::int32_t count = 0;
    double sum = 0.0;
  };
  Points lowest_points(const patch::GapRows& rows, double deepest) {
    Points points;
    // Weights go to 0 at 90 % of the deepest overlap, smoothly: a lowest point comes and goes unnoticed.
    for (std::int32_t j = 1; j + 1 < rows.count; ++j) {
      const double* const h = rows.height + j;
      if (!(h[0] < h[-1] && h[0] <= h[1])) continue;
      const patch::GapMinimum point = patch::minimum(rows, rows.y[j - 1], rows.y[j + 1]);
      const double t = 10.0 * (-point.height / deepest - 0.9);
      if (!(t > 0.0)) continue;
      if (points.count == most_points) {
        result_.jumps = true;
        break;
      }
      const auto k = static_cast<std::size_t>(points.count++);
      points.of[k] = point;
      points.weight[k] = smooth_step(t);
      points.sum += points.weight[k];
    }
    return points;
  }

  void solve_part(const Run& run, const Part& part) {
    // The patch as a problem over its unrolled plane, down to its deepest overlap.
    normal::NormalProblem problem;
    problem.gap = rows_of(run, part);
    const patch::GapMinimum lowest = patch::minimum(problem.gap);
    if (!(lowest.height < 0.0)) return;
    problem.prescribed = normal::Prescribed::approach;
    problem.material = material_;
    problem.strips = method_.strips;
    problem.max_iterations = method_.max_iterations;
    problem.force_tolerance = method_.force_tolerance;
    problem.kernels = &kernels_;
    // The method solves a patch about its lowest point; of several as deep the mean is taken.
    const Points points = lowest_points(problem.gap, -lowest.height);
    for (std::int32_t k = 0; k < points.count; ++k) {
      const patch::GapMinimum& touch = points.of[static_cast<std::size_t>(k)];
      problem.touch = &touch;
      problem.approach = -touch.height;
      solve_about(problem, run, part.share * points.weight[static_cast<std::size_t>(k)] / points.sum);
    }
  }

  void solve_about(const normal::NormalProblem& problem, const Run& run, double share) {
    // A method that finds no contact about this point adds nothing, and nothing is wrong.
    normal::NormalSolution solution;
    const Fault fault = method_.solve(problem, memory_.strips, solution);
    result_.iterations += static_cast<std::int32_t>(solution.iterations);
    if (fault.status == WRC_FLAG_NO_CONTACT) return;
    keep_worst(result_.fault, fault);
    if (!fault.failed()) lay_over(run, share);
  }

  /// Lays the method's strips over the rail's: of each q = l peak [N/m] and l^2 by the part of a rail strip's
  /// width it covers, times `share`. Sums q c for the centres.
  void lay_over(const Run& run, double share) {
    const patch::Strips& patch = memory_.strips;
    std::int32_t from = run.first;
    double lost = 0.0, all = 0.0;
    for (std::int32_t k = 0; k < patch.count; ++k) {
      // Borders of the method's strip along the rail, and its line load.
      const double low = patch.y[k] - 0.5 * patch.width[k], high = patch.y[k] + 0.5 * patch.width[k];
      const double l = patch.half_length[k], q = l * patch.peak[k];
      all += q * patch.width[k];
      lost += q * patch.width[k];
      const auto border = [&](std::int32_t i) {
        return memory_.place[i] + 0.5 * rail_.width[overlaps_.strip[i]];
      };
      // Both lists increase: strips of the rail before this one are done with.
      while (from < run.end && border(from) <= low) ++from;
      for (std::int32_t i = from; i < run.end; ++i) {
        const double width = rail_.width[overlaps_.strip[i]], begin = border(i) - width;
        if (!(begin < high)) break;
        const double covered = smaller(high, border(i)) - larger(low, begin);
        if (!(covered > 0.0)) continue;
        const double part = share * covered / width;
        pressure_.length_squared[i] += part * l * l;
        pressure_.line_load[i] += part * q;
        pressure_.centre[i] += part * q * patch.centre[k];
        lost -= q * covered;
      }
    }
    // Load outside all candidates belongs to no strip of the rail.
    if (lost > 1e-6 * all)
      keep_worst(result_.fault,
                 Fault::patch_at_edge("load beyond the strips that may touch, share", {lost / all, ""},
                                      "the method's patch is wider than the overlap it stands for"));
  }

  const RailStrips& rail_;
  const Overlaps& overlaps_;
  const PlanarMethod& method_;
  const patch::Material& material_;
  const Kernels& kernels_;
  const StripPressure& pressure_;
  Memory memory_;
  PlanarResult result_;
};

}  // namespace

std::int64_t planar_pressure_doubles(std::int32_t most, const PlanarMethod& method) {
  Arena counted;
  cut(counted, most, method.strips);
  return counted.doubles();
}

PlanarResult solve_planar_pressure(const RailStrips& rail, const Overlaps& overlaps,
                                   const PlanarMethod& method, const patch::Material& material,
                                   const Kernels& kernels, double* workspace,
                                   const StripPressure& pressure) noexcept {
  return Solver(rail, overlaps, method, material, kernels, Arena(workspace), pressure).solve();
}

}  // namespace wrc::surface
