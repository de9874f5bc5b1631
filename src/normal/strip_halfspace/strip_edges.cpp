#include "normal/strip_halfspace/strip_edges.hpp"

#include <algorithm>
#include <cmath>

#include "normal/simd/tasks.hpp"

namespace wrc::normal {
namespace {

/// Lists the active strips as sources of displacement.
void list_sources(StripSystem& s) {
  for (std::int32_t a = 0; a < s.active_count; ++a) {
    const std::int32_t j = s.active[a];
    s.sources.y[a] = s.grid.y[j];
    s.sources.centre[a] = s.centre[j];
    s.sources.inverse_length[a] = s.inverse_length[j];
    s.sources.line_load[a] = s.peak[j] * s.grid.width[j];
    s.half_width[a] = 0.5 * s.grid.width[j] * s.inverse_length[j];
  }
}

/// Joins neighbouring active strips two by two, at the centroid of their load, for edges that see them from
/// afar. All pairs, overlapping: which of them an edge takes follows from where it is, so that a mirrored
/// patch is seen mirrored. An edge that is left with one strip at the patch's end finds it there alone.
void join_pairs(StripSystem& s) {
  const std::int32_t last = s.active_count - 1;
  const auto alone = [&](std::int32_t k, std::int32_t a) {
    s.pairs.y[k] = s.sources.y[a];
    s.pairs.centre[k] = s.sources.centre[a];
    s.pairs.inverse_length[k] = s.sources.inverse_length[a];
    s.pairs.line_load[k] = s.sources.line_load[a];
  };
  alone(-1, 0);
  alone(last, last);
  for (std::int32_t k = 0; k < last; ++k) {
    const std::int32_t i = s.active[k], j = s.active[k + 1];
    // Loads over pi / 2 as weights [N].
    const double area_i = s.half_length[i] * s.grid.width[i], area_j = s.half_length[j] * s.grid.width[j];
    const double load = s.peak[i] * area_i + s.peak[j] * area_j;
    // A pair that carries nothing yet, or pulls and is about to leave, has no centroid of load: then of area.
    const bool presses = load > 0.0;
    const double part_i = presses ? s.peak[i] * area_i : area_i;
    const double part_j = presses ? s.peak[j] * area_j : area_j;
    const double inverse = 1.0 / (part_i + part_j);
    // Weighted means of place and half length; the line load keeps the pair's load, line_load l.
    s.pairs.y[k] = (part_i * s.grid.y[i] + part_j * s.grid.y[j]) * inverse;
    s.pairs.centre[k] = (part_i * s.centre[i] + part_j * s.centre[j]) * inverse;
    s.pairs.inverse_length[k] = (part_i + part_j) / (part_i * s.half_length[i] + part_j * s.half_length[j]);
    s.pairs.line_load[k] = load * s.pairs.inverse_length[k];
  }
}

/// Nothing behind the last source.
void end_sources(StripSystem& s) {
  for (const simd::Sources& sources : {s.sources, s.pairs})
    for (double* const field : {sources.y, sources.centre, sources.inverse_length, sources.line_load})
      std::fill_n(field + s.active_count, simd::beyond_sources, 0.0);
}

/// Displacements at the edges of the active strips towards +x (side = 1) or -x (side = -1), over the
/// compliance [m Pa].
void find_edge_displacements(const Kernels& kernels, const InfluenceTables& influence, const StripSystem& s,
                             double side, double* displacement) {
  for (std::int32_t a = 0; a < s.active_count; ++a)
    s.edge[a] = s.sources.centre[a] + side * s.half_length[s.active[a]];
  kernels.normal.edge_displacements({influence.tables(), s.active_count, s.sources, s.pairs, s.edge,
                                     s.sources.y, s.half_width, displacement});
}

/// Means of three neighbours, 1/4 1/2 1/4, within each patch. The outermost strips of a patch take the value
/// of their inner neighbours; two strips alone their mean.
void smooth(const StripSystem& s, double* value) {
  for (std::int32_t first = 0, end = 0; first < s.active_count; first = end) {
    end = run_end(s, first);
    const std::int32_t last = end - 1;
    // Two strips alone.
    if (last == first + 1) value[first] = value[last] = 0.5 * (value[first] + value[last]);
    if (last < first + 2) continue;
    // In place: the unsmoothed neighbour is kept in `before`.
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

}  // namespace

double move_edges(const NormalProblem& problem, const InfluenceTables& influence, double approach,
                  StripSystem& s) noexcept {
  const double compliance = problem.material.normal_compliance();
  // u at the leading edges; at the trailing ones too where the gap's centre line bends.
  list_sources(s);
  join_pairs(s);
  end_sources(s);
  find_edge_displacements(*problem.kernels, influence, s, 1.0, s.leading);
  if (s.skewed) find_edge_displacements(*problem.kernels, influence, s, -1.0, s.trailing);
  for (std::int32_t a = 0; a < s.active_count; ++a) {
    const std::int32_t j = s.active[a];
    // u should fall from centre to edge as the gap rises, by curvature l^2 / 2; it falls by `drop` [m].
    const double l = s.half_length[j];
    const double leading = compliance * s.leading[a];
    const double trailing = s.skewed ? compliance * s.trailing[a] : leading;
    const double drop = approach - height_at_centre(s, j) - 0.5 * (leading + trailing);
    const double ratio = std::clamp(drop / (0.5 * s.curvature[j] * l * l), 0.25, 4.0);
    s.peak_per_length[a] = s.peak[j] * s.inverse_length[j] / ratio;
    // h(leading edge) - h(trailing edge) = 2 curvature l (x_c - gap_centre); half the way there.
    const double wanted = (trailing - leading) / (2.0 * l * s.curvature[j]);
    s.shift[a] = 0.5 * (wanted + s.centre[j] - s.gap_centre[j]);
  }
  smooth(s, s.peak_per_length);
  if (s.skewed) smooth(s, s.shift);

  // New lengths at constant p l, hence constant load: l^2 by the ratio of p / l to its target.
  double moved = 0.0, area = 0.0;
  for (std::int32_t a = 0; a < s.active_count; ++a) {
    const std::int32_t j = s.active[a];
    const double ratio = s.peak[j] * s.inverse_length[j];
    const double wanted =
        s.peak_per_length[a] > 0.0 ? ratio / s.peak_per_length[a] : 1.0;  // l_new^2 / l^2; 1 without load
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

void fit_ends(const patch::GapRows& rows, double lowest_height, StripSystem& s) noexcept {
  patch::GapReader gap(rows);
  const auto refit = [&](std::int32_t j, double y, double width, double half_length) {
    // The strip at its new place and width; its shift against the gap's centre stays.
    const double centre_before = s.gap_centre[j];
    s.peak[j] *= s.half_length[j] * s.grid.width[j] / (half_length * width);  // the strip's load stays
    s.half_length[j] = half_length;
    put(gap, lowest_height, j, y, width, s);
    s.centre[j] += s.gap_centre[j] - centre_before;
  };
  const auto fit = [&](std::int32_t j, std::int32_t inner) {
    const double side = j > inner ? 1.0 : -1.0;  // where the border is, seen from the strip
    // l^2 falls by `slope` per length towards the border [m].
    const double l2 = s.half_length[j] * s.half_length[j];
    const double inner_l2 = s.half_length[inner] * s.half_length[inner];
    const double slope = std::max(inner_l2 - l2, 0.0) / std::abs(s.grid.y[inner] - s.grid.y[j]);
    const double inner_border = s.cell_y[j] - side * 0.5 * s.cell_width[j];
    const std::int32_t beyond = std::clamp(2 * j - inner, 0, s.grid.count - 1);
    const double most = s.cell_width[j] + 0.5 * s.cell_width[beyond];
    // From the inner border to where l^2 vanishes; a blunt patch ends before.
    const double in_cell = side * (s.grid.y[j] - inner_border);
    const bool blunt = l2 >= slope * (most - in_cell);
    const double reach = blunt ? most : in_cell + l2 / slope;
    const double extent = std::max(reach, 0.1 * s.cell_width[j]);
    // The strip from its inner border to there, l^2 at its new middle.
    const double middle_l2 = blunt ? l2 + slope * (in_cell - 0.5 * extent) : 0.5 * slope * extent;
    refit(j, inner_border + side * 0.5 * extent, extent, std::sqrt(middle_l2));
  };
  for (std::int32_t first = 0, end = 0; first < s.active_count; first = end) {
    end = run_end(s, first);
    // Strips that are outermost no more get their cells back.
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

}  // namespace wrc::normal
