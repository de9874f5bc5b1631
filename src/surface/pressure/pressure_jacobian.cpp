#include "surface/pressure/pressure_jacobian.hpp"

#include <algorithm>

#include "base/arena.hpp"
#include "base/number.hpp"
#include "surface/pressure/smoothing.hpp"
#include "surface/simd/tasks.hpp"

namespace wrc::surface {
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

/// Arrays over the strips but for the first three.
struct Scratch {
  double *matrix, *x;  ///< rows with right-hand sides; solutions
  double* kept_rows;   ///< ring of rows as they were before they were blended with their neighbours'
  double *place, *centre, *inverse_length, *half_width, *factor, *ny, *nz;  ///< sources
  double* direction;                                  ///< ny, nz, and their derivatives by the inputs; zeros
  double *l, *dl_dL;                                  ///< [m], [1/m]; 0 where l is the least one
  double* q_dl_dL;                                    ///< [Pa]
  double *edge_lambda, *edge_shift, *lambda, *shift;  ///< asked for by edges; smoothed [Pa/m], [m]
  simd::SurfaceSlopes seen;                           ///< influence at a point, and its derivatives
};

Scratch cut(Arena& arena, std::int32_t most) {
  Scratch w;
  // Three rows a strip, and a ring of rows for the neighbours on one side.
  const Size size = size_of(most);
  const std::int64_t padded = simd::whole_packs(most);
  w.matrix = arena.take(size.rows * size.stride);
  w.x = arena.take(static_cast<std::int64_t>(size.rows) * inputs);
  w.kept_rows = arena.take(most_within_reach * size.stride);
  w.direction = arena.take(padded * directions);
  arena.each(padded, w.place, w.centre, w.inverse_length, w.half_width, w.factor, w.ny, w.nz, w.l, w.dl_dL,
             w.q_dl_dL, w.lambda, w.edge_lambda, w.edge_shift, w.shift, w.seen.value, w.seen.by_length,
             w.seen.by_x);
  return w;
}

/// The sources of a solution, their derivatives by L, and their directions with derivatives.
void list_sources(const PressureModel& model, const PressedStrips& s, Scratch& w) {
  const std::int32_t n = s.count;
  const std::int64_t end = simd::whole_packs(n);
  for (std::int64_t a = 0; a < end; ++a) {
    // Behind the last strip whole packs of sources that displace nothing.
    const bool pads = a >= n;
    const double width = pads ? 0.0 : s.width[a];
    // The half length is limited as evaluate() of iteration.cpp does; then it does not change with L.
    const double least = least_half_length * width, L = pads ? 1.0 : s.length_squared[a];
    const double l = root(larger(L, least * least)), inverse = pads ? 0.0 : 1.0 / l;
    w.l[a] = l;
    w.dl_dL[a] = L > least * least ? 0.5 / l : 0.0;
    w.place[a] = pads ? 0.0 : s.place[a];
    w.centre[a] = pads ? 0.0 : s.centre[a];
    w.inverse_length[a] = inverse;
    w.half_width[a] = 0.5 * width * inverse;
    w.factor[a] = model.compliance * width * inverse;
    w.ny[a] = pads ? 0.0 : s.overlap[a].ny.value;
    w.nz[a] = pads ? 0.0 : s.overlap[a].nz.value;
  }
  // Directions with their derivatives side by side, as slopes_row sums them.
  for (std::int32_t a = 0; a < n; ++a) {
    w.q_dl_dL[a] = w.dl_dL[a] * s.line_load[a];
    const OverlapSlopes& o = s.overlap[a];
    double* const direction = w.direction + a * directions;
    direction[0] = w.ny[a];
    direction[1] = w.nz[a];
    std::copy_n(o.ny.d.begin(), inputs, direction + 2);
    std::copy_n(o.nz.d.begin(), inputs, direction + 2 + inputs);
    std::fill(direction + 2 + 2 * inputs, direction + directions, 0.0);
  }
}

/// Displacement of a point by all strips.
struct Displacement {
  double value = 0.0;          ///< [m]
  double by_x = 0.0;           ///< derivative by the point's own x [-]
  double turned[inputs] = {};  ///< derivatives by the inputs, through the strips' directions alone
};

/// Fills the row of the displacement's derivatives by q, L and c, seen from a point that belongs to strip a;
/// w.seen holds the influences there.
///
///     u = sum_b J_b q_b (n_a . n_b),   J_b of l_b and x - c_b
Displacement fill_row(const Kernels& kernels, const PressedStrips& s, const Scratch& w, std::int32_t a,
                      double* row) {
  Displacement u;
  const std::int32_t n = s.count;
  const double ny = w.ny[a], nz = w.nz[a];
  double sum[directions];  // sums of J q times each element of `direction`
  kernels.surface.slopes_row({n, w.seen, ny, nz, w.ny, w.nz, s.line_load, w.q_dl_dL, w.direction, row, sum});
  // Influences depend on x - c alone: the point's own x has the opposite of all centres' derivatives. The
  // point moves with the centre of strip a.
  double* const by_c = row + 2 * n;
  for (std::int32_t b = 0; b < n; ++b) u.by_x -= by_c[b];
  by_c[a] += u.by_x;
  // n_a . sum of J q n_b, and the product rule for its directions.
  const double *const turned_y = sum + 2, *const turned_z = turned_y + inputs;
  const double *const own_y = w.direction + a * directions + 2, *const own_z = own_y + inputs;
  u.value = ny * sum[0] + nz * sum[1];
  for (std::int32_t k = 0; k < inputs; ++k)
    u.turned[k] = ny * turned_y[k] + nz * turned_z[k] + (sum[0] * own_y[k] + sum[1] * own_z[k]);
  return u;
}

/// Strip a's rows: of contact, and of the lambda and shift its own edges ask for, which smooth() blends with
/// its neighbours'. They hold derivatives by the unknowns, and on the right those by the inputs at fixed
/// unknowns, with the sign of the other side.
void fill_strip(const PressureModel& model, const PressedStrips& s, const Size& size, std::int32_t a,
                Scratch& w) {
  const std::int32_t n = s.count;
  const Kernels& kernels = model.kernels;
  const simd::SurfaceTables tables{model.influence.tables(), model.influence.mean_under.data()};
  const simd::SurfaceSources sources{n, w.place, w.centre, w.inverse_length, w.half_width, w.factor};
  double* const contact = w.matrix + a * size.stride;
  double* const lambda = w.matrix + (n + a) * size.stride;
  double* const shift = w.matrix + (2 * n + a) * size.stride;
  for (double* row : {contact, lambda, shift}) std::fill_n(row + 3 * n, size.stride - 3 * n, 0.0);
  const OverlapSlopes& o = s.overlap[a];
  const double q = s.line_load[a], l = w.l[a], kappa = o.curvature.value;
  const double aside = s.centre[a] - o.centre.value;
  const double depth = o.depth.value - 0.5 * kappa * aside * aside;  // at the centre
  const double depth_by_c = -kappa * aside;
  const auto point = [&](double x) { return simd::SurfacePoint{w.place[a], x}; };

  // Contact: u(c) - depth(c) = 0.
  kernels.surface.influence_slopes(tables, sources, point(w.centre[a]), w.seen);
  const Displacement middle = fill_row(kernels, s, w, a, contact);
  contact[2 * n + a] -= depth_by_c;

  // Rows of u+ at c + l and u- at c - l; these points move with L, too.
  kernels.surface.edge_slopes(tables, sources, point(w.centre[a] + l), w.seen);
  const Displacement leading = fill_row(kernels, s, w, a, lambda);
  lambda[n + a] += leading.by_x * w.dl_dL[a];
  kernels.surface.edge_slopes(tables, sources, point(w.centre[a] - l), w.seen);
  const Displacement trailing = fill_row(kernels, s, w, a, shift);
  shift[n + a] -= trailing.by_x * w.dl_dL[a];

  // lambda* = q kappa / (2 drop) and shift* = (u- - u+) / (2 l kappa), as read_edges() of edge_condition.cpp
  // has them. At a limit of the ratio lambda* = q / (l^2 ratio) does not change with the drop.
  const double drop = depth - 0.5 * (leading.value + trailing.value);
  const double ratio = drop / (0.5 * kappa * l * l);
  const double kept = smaller(larger(ratio, least_edge_ratio), most_edge_ratio);
  const bool free = kept == ratio;
  w.edge_lambda[a] = q / (l * l * kept);
  w.edge_shift[a] = (trailing.value - leading.value) / (2.0 * l * kappa);
  const double by_drop = free ? w.edge_lambda[a] / drop : 0.0;  // minus d lambda* / d drop
  const double by_edges = 1.0 / (2.0 * l * kappa);

  // Rows of u+ and u- become rows of lambda* and shift*.
  for (std::int64_t c = 0; c < size.rows; ++c) {
    const double at_leading = lambda[c], at_trailing = shift[c];
    lambda[c] = 0.5 * by_drop * (at_leading + at_trailing);
    shift[c] = by_edges * (at_trailing - at_leading);
  }
  lambda[2 * n + a] -= by_drop * depth_by_c;
  lambda[a] += 1.0 / (l * l * kept);
  if (!free) lambda[n + a] -= 2.0 * w.edge_lambda[a] / l * w.dl_dL[a];
  shift[n + a] -= w.edge_shift[a] / l * w.dl_dL[a];

  // Right-hand sides: the inputs change depth, curvature, deepest point and directions.
  for (std::int32_t k = 0; k < inputs; ++k) {
    const auto d = static_cast<std::size_t>(k);
    const double bent = o.curvature.d[d] / kappa;
    const double edges = 0.5 * (leading.turned[k] + trailing.turned[k]);
    const double deeper = o.depth.d[d] - 0.5 * o.curvature.d[d] * aside * aside - depth_by_c * o.centre.d[d];
    contact[size.rows + k] = deeper - middle.turned[k];
    lambda[size.rows + k] = -(free ? w.edge_lambda[a] * bent - by_drop * (deeper - edges) : 0.0);
    shift[size.rows + k] = -(by_edges * (trailing.turned[k] - leading.turned[k]) - w.edge_shift[a] * bent);
  }
}

/// A smoothed number at a strip, and its derivatives by the numbers of the strips `from` .. `from` + count -
/// 1 and by their line loads, which weigh them.
struct Smoothed {
  double value;
  std::int32_t from, count;
  double by_value[2 * most_within_reach], by_load[2 * most_within_reach];
};

/// Weighted mean of `edge` over strip a's neighbours (lambda_reach), or the line of least squares through
/// them at its place (shift_reach, SurfaceKernels::near_lines).
///
///     weight_b = (1 - y_b^2)^3 w_b q_b,  y_b = (s_b - s_a) / reach
///     mean: value = <v>     line: value = <v> - <y> slope,  slope = (<y v> - <y> <v>) / spread
template <bool line>
void smooth_at(const PressedStrips& s, const Scratch& w, std::int32_t a, const double* edge, Smoothed& r) {
  const double reach = line ? shift_reach(s.width[a]) : lambda_reach(s.width[a]);
  r.from = a;
  while (r.from > 0 && a - r.from < most_within_reach && w.place[a] - w.place[r.from - 1] < reach) --r.from;

  // Moments of the neighbours.
  double y[2 * most_within_reach], near[2 * most_within_reach];
  double weights = 0.0, y1 = 0.0, y2 = 0.0, v = 0.0, yv = 0.0;
  r.count = 0;
  for (std::int32_t b = r.from; b < s.count && r.count < 2 * most_within_reach; ++b, ++r.count) {
    const double at = (w.place[b] - w.place[a]) / reach;
    if (at >= 1.0) break;
    y[r.count] = at;
    near[r.count] = smoothing_weight(at) * s.width[b];
    const double weight = near[r.count] * s.line_load[b];
    weights += weight;
    v += weight * edge[b];
    if constexpr (line) {
      y1 += weight * at;
      y2 += weight * at * at;
      yv += weight * at * edge[b];
    }
  }
  // Nothing presses within reach: lambda is the strip's own, and there is no line.
  if (!(weights > 0.0)) {
    r.value = line ? 0.0 : edge[a];
    for (std::int32_t i = 0; i < r.count; ++i) {
      r.by_value[i] = !line && r.from + i == a ? 1.0 : 0.0;
      r.by_load[i] = 0.0;
    }
    return;
  }

  // Derivatives: by a value its share of the weights times its lever, by a load how far its value is off the
  // mean or line; the least spread, which does not grow with the weights, adds a term.
  const double per = 1.0 / weights, mean = v * per, mean_y = y1 * per;
  const double spread = y2 * per - mean_y * mean_y + least_line_spread;
  const double slope = line ? (yv * per - mean_y * mean) / spread : 0.0;
  r.value = mean - mean_y * slope;
  for (std::int32_t i = 0; i < r.count; ++i) {
    const double aside = y[i] - mean_y, lever = line ? 1.0 - mean_y * aside / spread : 1.0;
    const double off = edge[r.from + i] - mean - slope * aside;
    r.by_value[i] = near[i] * s.line_load[r.from + i] * per * lever;
    r.by_load[i] = near[i] * per * (off * lever + mean_y * slope * least_line_spread / spread);
  }
}

/// Replaces the rows of a number that edges ask for, which begin at `first`, by `factor_of` times those of
/// its smoothed value: by the chain rule sums of the neighbours' rows. A row that is replaced is kept as long
/// as strips behind it need it.
template <bool line, class Factor>
void smooth_rows(const Kernels& kernels, const PressedStrips& s, const Size& size, std::int32_t first,
                 const double* edge, double* value, const Factor& factor_of, Scratch& w) {
  const std::int64_t stride = size.stride;
  double* const rows = w.matrix + first * stride;
  Smoothed r;
  for (std::int32_t a = 0; a < s.count; ++a) {
    // The value, its derivatives by the neighbours' values and loads, and the factor of the equation.
    smooth_at<line>(s, w, a, edge, r);
    value[a] = r.value;
    const double factor = factor_of(a, r.value);
    double* const row = rows + a * stride;
    // Rows before this one are replaced already: theirs come from the ring.
    std::copy_n(row, stride, w.kept_rows + a % most_within_reach * stride);
    const double* of[2 * most_within_reach];
    for (std::int32_t i = 0; i < r.count; ++i) {
      const std::int32_t b = r.from + i;
      of[i] = b <= a ? w.kept_rows + b % most_within_reach * stride : rows + b * stride;
      r.by_value[i] *= factor;
    }
    kernels.surface.blend_rows({r.count, stride, r.by_value, of, row});
    // The weights' part: line loads are the first unknowns.
    for (std::int32_t i = 0; i < r.count; ++i) row[r.from + i] += factor * r.by_load[i];
  }
}

/// Turns the rows of lambda* and shift* into the equations of L and c.
void smooth(const Kernels& kernels, const PressedStrips& s, const Size& size, Scratch& w) {
  const std::int32_t n = s.count;
  // L lambda - q = 0 over lambda: dL + L / lambda dlambda - dq / lambda = 0.
  smooth_rows<false>(
      kernels, s, size, n, w.edge_lambda, w.lambda,
      [&w](std::int32_t a, double lambda) { return w.l[a] * w.l[a] / lambda; }, w);
  // c - shift = W; a shift at its limit does not change.
  smooth_rows<true>(
      kernels, s, size, 2 * n, w.edge_shift, w.shift,
      [](std::int32_t, double shift) { return magnitude(shift) < longest_shift ? -1.0 : 0.0; }, w);
  // The equations' own terms, and W on the right.
  for (std::int32_t a = 0; a < n; ++a) {
    double* const lambda_row = w.matrix + (n + a) * size.stride;
    double* const shift_row = w.matrix + (2 * n + a) * size.stride;
    lambda_row[n + a] += 1.0;
    lambda_row[a] -= 1.0 / w.lambda[a];
    shift_row[2 * n + a] += 1.0;
    for (std::int32_t k = 0; k < inputs; ++k)
      shift_row[size.rows + k] += s.overlap[a].centre.d[static_cast<std::size_t>(k)];
  }
}

/// Back substitution for all right-hand sides, after the elimination has left a triangle with the inverses of
/// its pivots on the diagonal.
void substitute(const Size& size, Scratch& w) {
  // x_i = (r_i - sum of a_ic x_c) / a_ii, all inputs at once.
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
  Arena counted;
  cut(counted, most);
  return counted.doubles();
}

void differentiate_pressures(const PressureModel& model, double* workspace, const PressedStrips& s) noexcept {
  const std::int32_t n = s.count;
  if (n == 0) return;
  // Equations of all unknowns: contact, lambda and shift of every strip.
  Arena arena(workspace);
  Scratch w = cut(arena, n);
  const Size size = size_of(n);
  list_sources(model, s, w);
  for (std::int32_t a = 0; a < n; ++a) fill_strip(model, s, size, a, w);
  smooth(model.kernels, s, size, w);
  // Rows of the unit matrix up to a multiple of four.
  for (std::int32_t a = 3 * n; a < size.rows; ++a) {
    std::fill_n(w.matrix + a * size.stride, size.stride, 0.0);
    w.matrix[a * size.stride + a] = 1.0;
  }
  model.kernels.normal.eliminate({size.rows, size.stride, w.matrix, nullptr, nullptr});
  substitute(size, w);
  // Solutions in the order of the unknowns: q, L, c.
  const auto dual = [&](std::int32_t row, double value) {
    PlaceDual number = value;
    std::copy_n(w.x + static_cast<std::int64_t>(row) * inputs, inputs, number.d.begin());
    return number;
  };
  for (std::int32_t a = 0; a < n; ++a) {
    s.line_load_dual[a] = dual(a, s.line_load[a]);
    s.length_squared_dual[a] = dual(n + a, s.length_squared[a]);
    s.centre_dual[a] = dual(2 * n + a, s.centre[a]);
  }
}

}  // namespace wrc::surface
