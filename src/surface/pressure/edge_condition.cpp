#include "surface/pressure/edge_condition.hpp"

#include <algorithm>

#include "base/number.hpp"
#include "surface/pressure/active_set.hpp"
#include "surface/pressure/smoothing.hpp"

namespace wrc::surface {
namespace {

/// Displacements at both edges of the active strips under their loads: w.u_leading, w.u_trailing [m].
void displace_edges(const PressureProblem& problem, const StripSet& s, PressureScratch& w) {
  ActiveStrips& active = w.active;
  const std::int32_t n = active.count;
  // Sources by their loads in place of unit ones, so that the kernel's sums are displacements.
  const std::int64_t end = simd::whole_packs(n);
  for (std::int64_t a = 0; a < end; ++a) active.load_factor[a] = a < n ? active.factor[a] * active.q[a] : 0.0;
  simd::SurfaceSources sources = sources_of(active);
  sources.factor = active.load_factor;
  w.work += work_of_pass(n);
  // Without yaw both edges are alike, and half of them are looked at.
  problem.kernels.surface.edges(problem.tables, sources, faces_of(active),
                                {active.half_length, w.u_leading, s.skewed ? w.u_trailing : nullptr});
}

/// Peaks per length and shifts that each active strip's own edges ask for.
///
/// Overlap is d_c at the centre and d_c - kappa/2 l^2 + (-+ kappa l shift) at the edges c +- l. Where it is
/// met at both, drop = d_c - (u+ + u-)/2 = kappa/2 l^2 and u- - u+ = 2 kappa l shift. The drop is
/// proportional to lambda at a given length, so that lambda* = lambda kappa/2 l^2 / drop, with lambda = q /
/// l^2.
void read_edges(const StripSet& s, PressureScratch& w) {
  const double *const leading = w.u_leading, *const trailing = s.skewed ? w.u_trailing : leading;
  for (std::int32_t a = 0; a < w.active.count; ++a) {
    const std::int32_t i = w.active.index[a];
    const double inverse = w.active.inverse_length[a], per_L = inverse * inverse;
    const double per_curvature = 1.0 / s.curvature[i];
    // Drop from the overlap at the centre to the mean displacement at the edges.
    const double drop = overlap_at_centre(s, i) - 0.5 * (leading[a] + trailing[a]);
    // Far from a solution a drop may vanish or change its sign: limits keep lengths finite.
    const double ratio =
        smaller(larger(2.0 * drop * per_L * per_curvature, least_edge_ratio), most_edge_ratio);
    w.edge_lambda[a] = w.active.q[a] * per_L / ratio;
    w.edge_shift[a] = 0.5 * (trailing[a] - leading[a]) * inverse * per_curvature;
  }
}

/// lambda of the active strips `first` .. `end` - 1, a row of places: means of edge_lambda over the strips
/// within reach, weighted by their loads, so that a strip that enters changes nothing yet. Adds the lengths q
/// / lambda to the residual.
void smooth_lambda(std::int32_t first, std::int32_t end, PressureScratch& w) {
  const ActiveStrips& active = w.active;
  for (std::int32_t a = first, from = first; a < end; ++a) {
    const std::int32_t i = active.index[a];
    // A window that moves along: places increase.
    const double per_reach = active.per_lambda_reach[a];
    while ((active.place[a] - active.place[from]) * per_reach >= 1.0) ++from;
    double weights = 0.0, sum = 0.0;
    for (std::int32_t b = from; b < end; ++b) {
      const double t = (active.place[b] - active.place[a]) * per_reach;
      if (t >= 1.0) break;
      const double weight = smoothing_weight(t) * active.load[b];
      weights += weight;
      sum += weight * w.edge_lambda[b];
    }
    // The next length: L = q / lambda. Without load anywhere near the strip's own edges decide.
    if (!(weights > 0.0)) {
      weights = 1.0;
      sum = w.edge_lambda[a];
    }
    if (sum > 0.0) w.residual[i] += active.q[a] * weights / sum;
  }
}

}  // namespace

void edge_residual(const PressureProblem& problem, const StripSet& s, PressureScratch& w) {
  ActiveStrips& active = w.active;
  const std::int32_t n = active.count;
  // Line loads. Where rounds of the active set were used up some may pull; they count as nothing.
  std::fill_n(s.q, s.count, 0.0);
  for (std::int32_t a = 0; a < n; ++a) s.q[active.index[a]] = active.q[a] = larger(w.solution[a], 0.0);
  displace_edges(problem, s, w);
  read_edges(s, w);

  // Residuals of the lengths: L is to become q / lambda, and 0 where a strip is not in contact.
  double* const shift_residual = w.residual + s.count;
  for (std::int32_t i = 0; i < s.count; ++i) {
    w.residual[i] = -s.L[i];
    shift_residual[i] = 0.0;
  }
  for (std::int32_t a = 0; a < n; ++a) active.load[a] = active.q[a] * s.width[active.index[a]];
  smooth_lambda(0, active.behind, w);
  smooth_lambda(active.behind, n, w);
  if (!s.skewed) return;

  // Residuals of the shifts, which are to lie on lines through those that edges ask for. Strips that are not
  // in contact have the shift they would enter with.
  const auto lines = [&](std::int32_t first, std::int32_t count, std::int32_t from, std::int32_t sources) {
    problem.kernels.surface.near_lines({count, s.place + first, w.inverse_reach + first, least_line_spread,
                                        sources, active.place + from, active.load + from, w.edge_shift + from,
                                        shift_residual + first});
  };
  lines(0, s.behind, 0, active.behind);
  if (s.behind < s.count) lines(s.behind, s.count - s.behind, active.behind, n - active.behind);
  for (std::int32_t i = 0; i < s.count; ++i)
    shift_residual[i] = smaller(larger(shift_residual[i], -longest_shift), longest_shift) - s.shift[i];
}

}  // namespace wrc::surface
