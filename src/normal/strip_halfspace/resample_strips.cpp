#include "normal/strip_halfspace/resample_strips.hpp"

#include <algorithm>
#include <cmath>

#include "patch/material.hpp"

namespace wrc::normal {
namespace {

struct Run {
  std::int32_t first, last;  // strips of the solution
  double y_from, y_to;       // borders [m]
};

Run run_from(const SolvedStrips& solved, std::int32_t first) {
  Run run{first, first, 0.0, 0.0};
  while (run.last + 1 < solved.count && solved.region[run.last + 1] == solved.region[first]) ++run.last;
  run.y_from = solved.y[first] - 0.5 * solved.width[first];
  run.y_to = solved.y[run.last] + 0.5 * solved.width[run.last];
  return run;
}

/// Fills strips first .. first + count - 1 from the run; returns its load.
double cut(const SolvedStrips& solved, const Run& run, std::int32_t first, std::int32_t count,
           patch::Strips& strips) {
  const double width = (run.y_to - run.y_from) / count;
  // Load of the run in the solution [N]; that of the new strips is scaled to it below.
  double carried = 0.0, load = 0.0;
  for (std::int32_t i = run.first; i <= run.last; ++i)
    load += 0.5 * pi * solved.half_length[i] * solved.peak[i] * solved.width[i];

  std::int32_t i = run.first;  // the solution's strip at or below y
  for (std::int32_t j = first; j < first + count; ++j) {
    const double y = run.y_from + (j - first + 0.5) * width;
    while (i < run.last && solved.y[i + 1] <= y) ++i;
    double l2, peak_per_length, centre;
    const auto squared = [&](std::int32_t k) { return solved.half_length[k] * solved.half_length[k]; };
    // l^2, p / l and centre at y: beyond the outermost strips l^2 falls to 0 at the border, p / l stays.
    if (y < solved.y[run.first]) {
      l2 = squared(run.first) * (y - run.y_from) / (solved.y[run.first] - run.y_from);
      peak_per_length = solved.peak[run.first] / solved.half_length[run.first];
      centre = solved.centre[run.first];
    } else if (i == run.last) {
      l2 = squared(run.last) * (run.y_to - y) / (run.y_to - solved.y[run.last]);
      peak_per_length = solved.peak[run.last] / solved.half_length[run.last];
      centre = solved.centre[run.last];
    } else {
      const double t = (y - solved.y[i]) / (solved.y[i + 1] - solved.y[i]);
      const double ratio_0 = solved.peak[i] / solved.half_length[i];
      const double ratio_1 = solved.peak[i + 1] / solved.half_length[i + 1];
      l2 = squared(i) + t * (squared(i + 1) - squared(i));
      peak_per_length = ratio_0 + t * (ratio_1 - ratio_0);
      centre = solved.centre[i] + t * (solved.centre[i + 1] - solved.centre[i]);
    }
    strips.y[j] = y;
    strips.width[j] = width;
    strips.centre[j] = centre;
    strips.half_length[j] = std::sqrt(l2);
    strips.peak[j] = peak_per_length * strips.half_length[j];
    carried += 0.5 * pi * strips.half_length[j] * strips.peak[j] * width;
  }
  const double scale = load / carried;
  for (std::int32_t j = first; j < first + count; ++j) strips.peak[j] *= scale;
  return load;
}

}  // namespace

double resample_strips(const SolvedStrips& solved, std::int32_t count, patch::Strips& strips) noexcept {
  // Widths [m] of all patches.
  double total_width = 0.0;
  std::int32_t runs = 0;
  for (std::int32_t first = 0; first < solved.count; ++runs) {
    const Run run = run_from(solved, first);
    total_width += run.y_to - run.y_from;
    first = run.last + 1;
  }

  // Four strips for each patch, the others in proportion to the width, rounded from the sum so far.
  constexpr std::int32_t fewest = 4;
  const std::int32_t spare = std::max(count - fewest * runs, 0);
  double width_so_far = 0.0, load = 0.0;
  strips.count = 0;
  for (std::int32_t first = 0, n = 0; first < solved.count && strips.count < count; ++n) {
    const Run run = run_from(solved, first);
    width_so_far += run.y_to - run.y_from;
    const auto up_to =
        static_cast<std::int32_t>(std::floor(spare * (width_so_far / total_width) + 0.5)) + fewest * (n + 1);
    const std::int32_t end = std::min(up_to, count);
    load += cut(solved, run, strips.count, end - strips.count, strips);
    strips.count = end;
    first = run.last + 1;
  }
  return load;
}

}  // namespace wrc::normal
