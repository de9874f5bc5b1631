#include "surface/pressure/pressure_jacobian.hpp"

#include <algorithm>

#include "base/cutter.hpp"
#include "base/number.hpp"
#include "surface/pressure/smoothing.hpp"
#include "surface/simd/tasks.hpp"

namespace wrc {
namespace {

constexpr std::int32_t inputs = place_inputs;
constexpr std::int32_t directions = simd::SlopesRowTask::directions;
static_assert(directions >= 2 + 2 * inputs);
/// No strip has more others within its reach on one side.
constexpr std::int32_t most_within_reach = 36;

struct Size {
  std::int32_t rows;    ///< three for each strip, a multiple of four
  std::int64_t stride;  ///< with the right-hand sides behind
};

Size size_of(std::int32_t strips) {
  const std::int32_t rows = (3 * strips + 3) / 4 * 4;
  return {rows, (rows + inputs + 7) / 8 * 8};
}

struct Scratch {
  double *matrix, *x;
  double* earlier;  ///< rows before means were taken of them
  double *place, *centre, *inverse_length, *half_width, *factor, *ny, *nz;
  double* growing;    ///< growth times strength
  double* direction;  ///< of each strip: ny, nz, and how they change with the inputs; zeros
  double *l, *growth, *level, *wanted_level, *wanted_shift, *shift;  ///< growth: of l with L
  simd::SurfaceSlopes seen;
};

std::int64_t cut(double* memory, std::int32_t most, Scratch& w) {
  Cutter take{memory};
  const Size size = size_of(most);
  const std::int64_t padded = simd::whole_packs(most);
  w.matrix = take(size.rows * size.stride);
  w.x = take(static_cast<std::int64_t>(size.rows) * inputs);
  w.earlier = take(most_within_reach * size.stride);
  double** const of_strips[] = {
      &w.place,        &w.centre, &w.inverse_length, &w.half_width,     &w.factor,   &w.ny,
      &w.nz,           &w.l,      &w.growth,         &w.growing,        &w.level,    &w.wanted_level,
      &w.wanted_shift, &w.shift,  &w.seen.value,     &w.seen.by_length, &w.seen.by_x};
  for (double** a : of_strips) *a = take(padded);
  w.direction = take(padded * directions);
  return take.at - memory;
}

/// A point's displacement, and what turning adds to it.
struct Displacement {
  double value = 0.0;
  double by_x = 0.0;           ///< by the point's own x
  double turned[inputs] = {};  ///< by the directions
};

/// Fills the row of the displacement in strip a's direction, of what is seen, over the unknowns.
Displacement fill_row(const Kernels& kernels, const PressedStrips& s, const Scratch& w, std::int32_t a,
                      double* row) {
  Displacement u;
  const std::int32_t n = s.count;
  const double ny = w.ny[a], nz = w.nz[a];
  double sum[directions];
  kernels.surface.slopes_row({n, w.seen, ny, nz, w.ny, w.nz, s.line_load, w.growing, w.direction, row, sum});
  double* const by_c = row + 2 * n;
  for (std::int32_t b = 0; b < n; ++b) u.by_x -= by_c[b];
  const double *const turned_y = sum + 2, *const turned_z = turned_y + inputs;
  const double *const own_y = w.direction + a * directions + 2, *const own_z = own_y + inputs;
  u.value = ny * sum[0] + nz * sum[1];
  for (std::int32_t k = 0; k < inputs; ++k)
    u.turned[k] = ny * turned_y[k] + nz * turned_z[k] + (sum[0] * own_y[k] + sum[1] * own_z[k]);
  by_c[a] += u.by_x;
  return u;
}

/// The rows of contact, and those of levels and shifts before the means over neighbours are taken.
void fill(const PressureModel& model, const PressedStrips& s, const Size& size, Scratch& w) {
  const std::int32_t n = s.count;
  const simd::SurfaceTables tables{model.influence.tables(), model.influence.mean_under.data()};
  const simd::SurfaceSources sources{n, w.place, w.centre, w.inverse_length, w.half_width, w.factor};
  for (std::int32_t a = 0; a < n; ++a) {
    double* const contact = w.matrix + a * size.stride;
    double* const level = w.matrix + (n + a) * size.stride;
    double* const shift = w.matrix + (2 * n + a) * size.stride;
    for (double* row : {contact, level, shift}) std::fill_n(row + 3 * n, size.stride - 3 * n, 0.0);
    const OverlapSlopes& o = s.overlap[a];
    const double q = s.line_load[a], l = w.l[a], kappa = o.curvature.value;
    const double aside = s.centre[a] - o.centre.value;
    const double depth = o.depth.value - 0.5 * kappa * aside * aside;  // at the centre
    const double by_centre = -kappa * aside;
    const auto point = [&](double x) { return simd::SurfacePoint{w.place[a], x}; };

    model.kernels.surface.influence_slopes(tables, sources, point(w.centre[a]), w.seen);
    const Displacement middle = fill_row(model.kernels, s, w, a, contact);
    contact[2 * n + a] -= by_centre;

    // Rows of u+ and u-, then of what they mean for level and shift: level = q kappa / (2 drop).
    model.kernels.surface.edge_slopes(tables, sources, point(w.centre[a] + l), w.seen);
    const Displacement leading = fill_row(model.kernels, s, w, a, level);
    level[n + a] += leading.by_x * w.growth[a];
    model.kernels.surface.edge_slopes(tables, sources, point(w.centre[a] - l), w.seen);
    const Displacement trailing = fill_row(model.kernels, s, w, a, shift);
    shift[n + a] -= trailing.by_x * w.growth[a];

    const double drop = depth - 0.5 * (leading.value + trailing.value);
    const double ratio = drop / (0.5 * kappa * l * l);
    const double kept = smaller(larger(ratio, least_edge_ratio), most_edge_ratio);
    const bool free = kept == ratio;
    w.wanted_level[a] = q / (l * l * kept);
    w.wanted_shift[a] = (trailing.value - leading.value) / (2.0 * l * kappa);
    const double by_drop = free ? w.wanted_level[a] / drop : 0.0;
    const double by_edges = 1.0 / (2.0 * l * kappa);
    for (std::int64_t c = 0; c < size.rows; ++c) {
      const double at_leading = level[c], at_trailing = shift[c];
      level[c] = 0.5 * by_drop * (at_leading + at_trailing);
      shift[c] = by_edges * (at_trailing - at_leading);
    }
    level[2 * n + a] -= by_drop * by_centre;
    level[a] += 1.0 / (l * l * kept);
    if (!free) level[n + a] -= 2.0 * w.wanted_level[a] / l * w.growth[a];
    shift[n + a] -= w.wanted_shift[a] / l * w.growth[a];
    // right-hand sides: what of the changes is known
    for (std::int32_t k = 0; k < inputs; ++k) {
      const auto d = static_cast<std::size_t>(k);
      const double bent = o.curvature.d[d] / kappa;
      const double edges = 0.5 * (leading.turned[k] + trailing.turned[k]);
      const double deeper = o.depth.d[d] - 0.5 * o.curvature.d[d] * aside * aside - by_centre * o.centre.d[d];
      contact[size.rows + k] = deeper - middle.turned[k];
      level[size.rows + k] = -(free ? w.wanted_level[a] * bent - by_drop * (deeper - edges) : 0.0);
      shift[size.rows + k] =
          -(by_edges * (trailing.turned[k] - leading.turned[k]) - w.wanted_shift[a] * bent);
    }
  }
}

/// A number read off those of the strips from `from` on: how it changes with them, and with the weights their
/// strengths give them.
struct Reading {
  double value;
  std::int32_t from, several;
  double by_value[2 * most_within_reach], by_strength[2 * most_within_reach];
};

/// Mean of strip a's neighbours (lambda_reach), or their line (shift_reach, SurfaceKernels::near_lines).
template <bool line>
void read_near(const PressedStrips& s, const Scratch& w, std::int32_t a, const double* wanted, Reading& r) {
  const double reach = line ? shift_reach(s.width[a]) : lambda_reach(s.width[a]);
  r.from = a;
  while (r.from > 0 && a - r.from < most_within_reach && w.place[a] - w.place[r.from - 1] < reach) --r.from;
  double y[2 * most_within_reach], near[2 * most_within_reach];
  double weights = 0.0, y1 = 0.0, y2 = 0.0, v = 0.0, yv = 0.0;
  r.several = 0;
  for (std::int32_t b = r.from; b < s.count && r.several < 2 * most_within_reach; ++b, ++r.several) {
    const double at = (w.place[b] - w.place[a]) / reach;
    if (at >= 1.0) break;
    y[r.several] = at;
    near[r.several] = smoothing_weight(at) * s.width[b];
    const double weight = near[r.several] * s.line_load[b];
    weights += weight;
    v += weight * wanted[b];
    if constexpr (line) {
      y1 += weight * at;
      y2 += weight * at * at;
      yv += weight * at * wanted[b];
    }
  }
  if (!(weights > 0.0)) {
    r.value = line ? 0.0 : wanted[a];
    for (std::int32_t i = 0; i < r.several; ++i) {
      r.by_value[i] = !line && r.from + i == a ? 1.0 : 0.0;
      r.by_strength[i] = 0.0;
    }
    return;
  }
  const double per = 1.0 / weights, mean = v * per, mean_y = y1 * per;
  const double spread = y2 * per - mean_y * mean_y + least_line_spread;
  const double slope = line ? (yv * per - mean_y * mean) / spread : 0.0;
  r.value = mean - mean_y * slope;
  for (std::int32_t i = 0; i < r.several; ++i) {
    const double aside = y[i] - mean_y, lever = line ? 1.0 - mean_y * aside / spread : 1.0;
    const double off = wanted[r.from + i] - mean - slope * aside;  // the line
    r.by_value[i] = near[i] * s.line_load[r.from + i] * per * lever;
    r.by_strength[i] = near[i] * per * (off * lever + mean_y * slope * least_line_spread / spread);
  }
}

/// Makes of a number's rows of the matrix, which begin at `first`, those of what is read off its neighbours,
/// times a factor of that.
template <bool line, class Factor>
void read_rows(const Kernels& kernels, const PressedStrips& s, const Size& size, std::int32_t first,
               const double* wanted, double* value, const Factor& factor_of, Scratch& w) {
  const std::int64_t stride = size.stride;
  double* const rows = w.matrix + first * stride;
  Reading r;
  for (std::int32_t a = 0; a < s.count; ++a) {
    read_near<line>(s, w, a, wanted, r);
    value[a] = r.value;
    const double factor = factor_of(a, r.value);
    double* const row = rows + a * stride;
    std::copy_n(row, stride, w.earlier + a % most_within_reach * stride);
    const double* of[2 * most_within_reach];
    for (std::int32_t i = 0; i < r.several; ++i) {
      const std::int32_t b = r.from + i;
      of[i] = b <= a ? w.earlier + b % most_within_reach * stride : rows + b * stride;
      r.by_value[i] *= factor;
    }
    kernels.surface.blend_rows({r.several, stride, r.by_value, of, row});
    for (std::int32_t i = 0; i < r.several; ++i) row[r.from + i] += factor * r.by_strength[i];
  }
}

/// Makes the rows of levels and shifts the equations of L and c.
void smooth(const Kernels& kernels, const PressedStrips& s, const Size& size, Scratch& w) {
  const std::int32_t n = s.count;
  // L level - q = 0, over the level
  read_rows<false>(
      kernels, s, size, n, w.wanted_level, w.level,
      [&w](std::int32_t a, double level) { return w.l[a] * w.l[a] / level; }, w);
  read_rows<true>(
      kernels, s, size, 2 * n, w.wanted_shift, w.shift,
      [](std::int32_t, double shift) { return magnitude(shift) < longest_shift ? -1.0 : 0.0; }, w);
  for (std::int32_t a = 0; a < n; ++a) {
    double* const level_row = w.matrix + (n + a) * size.stride;
    double* const shift_row = w.matrix + (2 * n + a) * size.stride;
    level_row[n + a] += 1.0;
    level_row[a] -= 1.0 / w.level[a];
    shift_row[2 * n + a] += 1.0;
    for (std::int32_t k = 0; k < inputs; ++k)
      shift_row[size.rows + k] += s.overlap[a].centre.d[static_cast<std::size_t>(k)];
  }
}

/// Back substitution for all right-hand sides.
void substitute(const Size& size, Scratch& w) {
  for (std::int32_t i = size.rows - 1; i >= 0; --i) {
    const double* const row = w.matrix + i * size.stride;
    double sum[inputs];
    for (std::int32_t k = 0; k < inputs; ++k) sum[k] = row[size.rows + k];
    for (std::int32_t c = i + 1; c < size.rows; ++c) {
      const double* const x = w.x + static_cast<std::int64_t>(c) * inputs;
      pairwise::add<inputs>(-row[c], x, sum);
    }
    double* const x = w.x + static_cast<std::int64_t>(i) * inputs;
    for (std::int32_t k = 0; k < inputs; ++k) x[k] = sum[k] * row[i];
  }
}

}  // namespace

std::int64_t pressure_jacobian_doubles(std::int32_t most) {
  Scratch w;
  double nothing = 0.0;
  return cut(&nothing, most, w);
}

void differentiate_pressures(const PressureModel& model, double* memory, const PressedStrips& s) noexcept {
  const std::int32_t n = s.count;
  if (n == 0) return;
  Scratch w;
  cut(memory, n, w);
  const Size size = size_of(n);
  const std::int64_t end = simd::whole_packs(n);
  for (std::int64_t a = 0; a < end; ++a) {
    const bool pads = a >= n;
    const double width = pads ? 0.0 : s.width[a];
    const double least = least_half_length * width, L = pads ? 1.0 : s.length_squared[a];
    const double l = root(larger(L, least * least)), inverse = pads ? 0.0 : 1.0 / l;
    w.l[a] = l;
    w.growth[a] = L > least * least ? 0.5 / l : 0.0;
    w.place[a] = pads ? 0.0 : s.place[a];
    w.centre[a] = pads ? 0.0 : s.centre[a];
    w.inverse_length[a] = inverse;
    w.half_width[a] = 0.5 * width * inverse;
    w.factor[a] = model.compliance * width * inverse;
    w.ny[a] = pads ? 0.0 : s.overlap[a].ny.value;
    w.nz[a] = pads ? 0.0 : s.overlap[a].nz.value;
  }
  for (std::int32_t a = 0; a < n; ++a) {
    w.growing[a] = w.growth[a] * s.line_load[a];
    const OverlapSlopes& o = s.overlap[a];
    double* const direction = w.direction + a * directions;
    direction[0] = w.ny[a];
    direction[1] = w.nz[a];
    std::copy_n(o.ny.d.begin(), inputs, direction + 2);
    std::copy_n(o.nz.d.begin(), inputs, direction + 2 + inputs);
    std::fill(direction + 2 + 2 * inputs, direction + directions, 0.0);
  }
  fill(model, s, size, w);
  smooth(model.kernels, s, size, w);
  for (std::int32_t a = 3 * n; a < size.rows; ++a) {
    std::fill_n(w.matrix + a * size.stride, size.stride, 0.0);
    w.matrix[a * size.stride + a] = 1.0;
  }
  model.kernels.normal.eliminate({size.rows, size.stride, w.matrix, nullptr, nullptr});
  substitute(size, w);
  const auto changed = [&](std::int32_t row, double value) {
    PlaceDual number = value;
    for (std::size_t k = 0; k < place_inputs; ++k)
      number.d[k] = w.x[static_cast<std::int64_t>(row) * inputs + static_cast<std::int64_t>(k)];
    return number;
  };
  for (std::int32_t a = 0; a < n; ++a) {
    s.line_load_dual[a] = changed(a, s.line_load[a]);
    s.length_squared_dual[a] = changed(n + a, s.length_squared[a]);
    s.centre_dual[a] = changed(2 * n + a, s.centre[a]);
  }
}

}  // namespace wrc
