#include "surface/pressure/start.hpp"

#include "base/number.hpp"

namespace wrc::surface {
namespace {

constexpr double coarse_tolerance = 0.1;  ///< for the solution on pairs, part of the area
constexpr std::int32_t fewest_pairs = 12;
/// Part of the area by which an earlier solution may be moved to be a start; from one farther away the
/// overlaps are nearer, and lead to another solution less often where there are two.
constexpr double farthest_followed = 0.5;
/// Parts of the growth of an overlap, in the mean and beside that, that L follows: fewest iterations on poses
/// a millisecond apart.
constexpr double follows_mean = 0.9, follows_rest = 1.4;
constexpr double farthest_extrapolated = 2.0;  ///< most times the earlier change in an extrapolation

/// Joins neighbouring strips to pairs in w.coarse, a lone one where its neighbour is missing: means by width.
void pair_up(const Overlaps& o, PressureScratch& w) {
  const StripSet& s = w.fine;
  StripSet& c = w.coarse;
  c.count = 0;
  for (std::int32_t i = 0; i < s.count;) {
    // Neighbours on the rail; at a gap between two faces or the end of the candidates a strip stays alone.
    const bool two = i + 1 < s.count && o.strip[i + 1] == o.strip[i] + 1;
    const std::int32_t j = two ? i + 1 : i, k = c.count++;
    const double a = s.width[i], b = two ? s.width[j] : 0.0, per = 1.0 / (a + b);
    const auto mean = [&](const double* v) { return (a * v[i] + b * v[j]) * per; };
    c.place[k] = mean(s.place);
    c.width[k] = a + b;
    c.depth[k] = mean(s.depth);
    c.curvature[k] = mean(s.curvature);
    c.deepest_x[k] = mean(s.deepest_x);
    c.ny[k] = mean(s.ny);
    c.nz[k] = mean(s.nz);
    c.L[k] = mean(s.L);
    c.shift[k] = mean(s.shift);
    w.pair_of[i] = w.pair_of[j] = k;
    i = j + 1;
  }
}

/// L and shifts of the strips on lines between the solved pairs.
void interpolate_pairs(PressureScratch& w) {
  const StripSet &s = w.fine, &c = w.coarse;
  for (std::int32_t i = 0; i < s.count; ++i) {
    // The line runs through the strip's pair and the next one on the strip's side, if that is next to it.
    const std::int32_t k = w.pair_of[i];
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

}  // namespace

std::int32_t start_from_overlaps(const PressureProblem& problem, const Overlaps& o, double max_work,
                                 PressureScratch& w, std::int32_t most) {
  // Half of the overlap's own squared half length, 2 d / kappa: Hertz's a^2 = R d between spheres.
  const StripSet& s = w.fine;
  for (std::int32_t i = 0; i < s.count; ++i) {
    s.L[i] = larger(s.depth[i], 0.0) / s.curvature[i];
    s.shift[i] = 0.0;
  }
  if (s.count < 2 * fewest_pairs) return 0;
  pair_up(o, w);
  // An iteration over all strips must be left.
  const IterationLimits on_pairs{coarse_tolerance, any_change, max_work - 2.0 * s.count * s.count, any_change,
                                 most};
  const std::int32_t spent = iterate(problem, w.coarse, on_pairs, w).iterations;
  interpolate_pairs(w);
  return spent;
}

void extrapolate_start(const RailStrips& rail, const Overlaps& o, PressureStart& start) {
  const SolutionChange change = start.change;
  start.change = {};
  if (!change.depth) return;
  // share of the earlier change: the overlaps' growth since, projected on their growth in it, by areas
  double along = 0.0, squared = 0.0;
  for_shared_strips(o.count, o.strip, start.count, start.strip, [&](std::int32_t i, std::int32_t b) {
    const double weight = rail.width[o.strip[i]] * start.length_squared[b] * change.depth[b];
    along += weight * (o.depth[i] - start.depth[b]);
    squared += weight * change.depth[b];
  });
  if (!(squared > 0.0)) return;
  const double share = smaller(larger(along / squared, -farthest_extrapolated), farthest_extrapolated);
  for (std::int32_t b = 0; b < start.count; ++b) {
    double& L = start.length_squared[b];
    L = smaller(larger(L + share * change.length_squared[b], 0.25 * L), 4.0 * L);
    start.shift[b] += share * change.shift[b];
    start.depth[b] += share * change.depth[b];
  }
}

bool follow_overlaps(PressureScratch& w) {
  const StripSet& s = w.fine;
  // Mean growth of the overlaps in contact [m], by the areas of their strips.
  double longest = 0.0, deepest = 0.0, weights = 0.0, mean = 0.0;
  for (std::int32_t i = 0; i < s.count; ++i) {
    if (!(s.L[i] > 0.0)) continue;
    const double before = w.depth_before[i], weight = s.width[i] * s.L[i];
    longest = larger(longest, s.L[i]);
    deepest = larger(deepest, before);
    weights += weight;
    mean += weight * (s.depth[i] - before);
  }
  if (!(deepest > 0.0)) return true;
  mean = mean / weights;

  // In Hertz's contact of equal curvatures L grows by L / d times a growth of d that is the same everywhere,
  // and twice as much with overlap that moves sideways: overlaps of a near pose tell how much of either there
  // is.
  const double per = longest / deepest;
  double moved = 0.0, area = 0.0;
  for (std::int32_t i = 0; i < s.count; ++i) {
    if (!(s.L[i] > 0.0)) continue;
    // Within a factor of four, so that strips at the rim stay in contact.
    const double grown = s.depth[i] - w.depth_before[i];
    const double next = s.L[i] + per * (follows_mean * mean + follows_rest * (grown - mean));
    const double limited = smaller(larger(next, 0.25 * s.L[i]), 4.0 * s.L[i]);
    moved += s.width[i] * magnitude(limited - s.L[i]);
    area += s.width[i] * limited;
    s.L[i] = limited;
  }
  return moved <= farthest_followed * area;
}

}  // namespace wrc::surface
