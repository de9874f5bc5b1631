#include "surface/pressure/pressure_jacobian.hpp"

#include <algorithm>

#include "base/arena.hpp"
#include "base/number.hpp"
#include "surface/pressure/smoothing.hpp"
#include "surface/simd/tasks.hpp"

namespace wrc::surface {
namespace {

constexpr std::int32_t inputs = place_inputs;
static_assert(simd::SlopesRowTask::inputs == inputs);
/// Fewest columns of the equations that are smoothed at a time: all where memory holds them (smooth_rows()).
constexpr std::int64_t fewest_columns = 16;

/// Sizes for a number of strips: of the equations with all unknowns, and of those left for L and c.
struct Size {
  std::int32_t strips;
  std::int32_t contact;  ///< rows of the contact condition: rows of the unit matrix, then one for each strip
  std::int32_t first;    ///< row and column of the first strip there
  std::int32_t rows;     ///< for L and c: two for each strip, then rows of the unit matrix
  std::int64_t reduced;  ///< from row to row of those: by L, by c, and the right-hand sides behind `rows`
  std::int64_t stride;   ///< from row to row with all unknowns: by q, up to `contact`, and the same

  std::int64_t doubles() const {
    return std::max(contact * stride, (static_cast<std::int64_t>(strips) + rows) * reduced);
  }
};

Size size_of(std::int32_t strips) {
  const auto fours = [](std::int32_t n) { return (n + 3) / 4 * 4; };
  const std::int32_t contact = fours(strips), rows = fours(2 * strips);
  const std::int64_t reduced = (rows + inputs + 7) / 8 * 8;
  return {strips, contact, contact - strips, rows, reduced, (contact + reduced + 7) / 8 * 8};
}

/// Arrays over the strips but for the first block.
struct Scratch {
  /// Equations of contact; then, in the same memory, line loads by L and c (loads_by_lengths()), and behind
  /// them the equations of L and c.
  double* matrix;
  double *by_lengths, *lengths;  ///< these two in it
  double* share;                 ///< shares of rows in a sum
  const double** row;
  double *place, *l;                 ///< [m]
  double *edge_lambda, *edge_shift;  ///< asked for by edges [Pa/m], [m]
  // until the equations of all strips are there:
  double *leading, *trailing;                                       ///< rows of edges, with all unknowns
  double *centre, *inverse_length, *half_width, *factor, *ny, *nz;  ///< sources
  double* turned[inputs];       ///< angle by which directions turn, by each input
  double* line_load;            ///< [N/m]
  double* dl_dL;                ///< [1/m]; 0 where l is the least one
  double* q_dl_dL;              ///< [Pa]
  simd::SurfaceSlopes seen[2];  ///< influence at points, and its derivatives
  // in the same memory, while they are smoothed:
  double *by_value, *by_load;  ///< derivatives by strips within reach: smooth_at()
  double* kept;                ///< some columns of all rows before they are blended with their neighbours'
  std::int64_t kept_columns;   ///< as many as memory holds
  // and then:
  double* x;             ///< changes of L and c
  double lambda_length;  ///< as PressureModel
};

/// `doubles`: of the memory, which kept columns fill; 0 while it is counted.
Scratch cut(Arena& arena, std::int32_t most, std::int64_t doubles) {
  Scratch w{};
  const Size size = size_of(most);
  const std::int64_t padded = simd::whole_packs(most);
  w.matrix = w.by_lengths = arena.take(size.doubles());
  w.lengths = w.by_lengths + most * size.reduced;
  // two edges and all of contact, or all strips with their loads
  const std::int32_t summands = 2 * most + 2;
  w.share = arena.take(summands);
  w.row = arena.take<const double*>(summands);
  arena.each(padded, w.place, w.l, w.edge_lambda, w.edge_shift);
  // equations, smoothing and solution one after the other in the same memory
  Arena smoothing = arena, solution = arena;
  arena.each(size.stride, w.leading, w.trailing);
  for (double*& turned : w.turned) turned = arena.take(padded);
  arena.each(padded, w.line_load, w.centre, w.inverse_length, w.half_width, w.factor, w.ny, w.nz, w.dl_dL,
             w.q_dl_dL);
  for (simd::SurfaceSlopes& seen : w.seen) arena.each(padded, seen.value, seen.by_length, seen.by_x);
  smoothing.each(padded, w.by_value, w.by_load);
  w.kept_columns = std::max(fewest_columns, (doubles - smoothing.doubles()) / most / 8 * 8);
  w.kept = smoothing.take(most * w.kept_columns);
  w.x = solution.take(static_cast<std::int64_t>(size.rows) * inputs);
  arena.go_behind(smoothing);
  arena.go_behind(solution);
  return w;
}

/// The sources of a solution, their derivatives by L, and how their directions turn.
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
    w.line_load[a] = pads ? 0.0 : s.line_load[a];
    w.q_dl_dL[a] = w.dl_dL[a] * w.line_load[a];
    // a unit vector (ny, nz) turns towards (-nz, ny)
    for (std::size_t k = 0; k < inputs; ++k)
      w.turned[k][a] = pads ? 0.0 : w.ny[a] * s.overlap[a].nz.d[k] - w.nz[a] * s.overlap[a].ny.d[k];
  }
}

/// Displacement of a point by all strips.
struct Displacement {
  double value = 0.0;          ///< [m]
  double by_x = 0.0;           ///< derivative by the point's own x [-]
  double turned[inputs] = {};  ///< derivatives by the inputs, through the strips' directions alone
};

/// Fills the row of the displacement's derivatives by q, L and c, seen from a point that belongs to strip a;
/// `seen`: the influences at these points.
///
///     u = sum_b J_b q_b (n_a . n_b),   J_b of l_b and x - c_b
Displacement fill_row(const Kernels& kernels, const PressedStrips& s, const Scratch& w, std::int32_t a,
                      const simd::SurfaceSlopes& seen, double* row) {
  Displacement u;
  const std::int32_t n = s.count;
  simd::SlopesRowTask::Sums sums;
  simd::SlopesRowTask task{n, seen, w.ny[a], w.nz[a], w.ny, w.nz, w.line_load, w.q_dl_dL, {}, row, &sums};
  std::copy_n(w.turned, inputs, task.turned);
  kernels.surface.slopes_row(task);
  // Influences depend on x - c alone: the point's own x has the opposite of all centres' derivatives. The
  // point moves with the centre of strip a.
  u.value = sums.value;
  u.by_x = sums.by_x;
  row[2 * n + a] += u.by_x;
  for (std::int32_t k = 0; k < inputs; ++k) u.turned[k] = sums.turned[k] + sums.by_own * w.turned[k][a];
  return u;
}

/// A strip with its equations, as it is seen by all.
struct SeenStrip {
  const OverlapSlopes& o;
  double q, l, kappa;
  double aside;              ///< centre of the pressure from that of the overlap [m]
  double depth, depth_by_c;  ///< overlap at the centre; by the centre
  double deeper[inputs];     ///< the same by the inputs

  SeenStrip(const PressedStrips& s, const Scratch& w, std::int32_t a)
      : o(s.overlap[a]),
        q(s.line_load[a]),
        l(w.l[a]),
        kappa(o.curvature.value),
        aside(s.centre[a] - o.centre.value),
        depth(o.depth.value - 0.5 * kappa * aside * aside),
        depth_by_c(-kappa * aside) {
    for (std::size_t k = 0; k < inputs; ++k)
      deeper[k] = o.depth.d[k] - 0.5 * o.curvature.d[k] * aside * aside - depth_by_c * o.centre.d[k];
  }
};

/// Widths of the sources as a strip's points see them: beyond the ends of lines, from the other row of
/// places, there is no width.
void see_from(const PressedStrips& s, std::int32_t a, const Scratch& w) {
  if (s.behind == s.count) return;
  for (std::int32_t b = 0; b < s.count; ++b)
    w.half_width[b] = (a < s.behind) == (b < s.behind) ? 0.5 * s.width[b] * w.inverse_length[b] : 0.0;
}

/// Sources and tables that rows are filled from.
struct Seeing {
  const Kernels& kernels;
  simd::SurfaceTables tables;
  simd::SurfaceSources sources;

  Seeing(const PressureModel& model, const PressedStrips& s, const Scratch& w)
      : kernels(model.kernels),
        tables{model.influence.tables(), model.influence.mean_under.data()},
        sources{s.count, w.place, w.centre, w.inverse_length, w.half_width, w.factor} {}
};

/// Strip a's equation of contact, u(c) - depth(c) = 0: derivatives by the unknowns, and on the right those by
/// the inputs at fixed unknowns, with the sign of the other side.
void fill_contact(const Seeing& seeing, const PressedStrips& s, const Size& size, std::int32_t a,
                  const Scratch& w) {
  const SeenStrip strip(s, w, a);
  double* const row = w.matrix + (size.first + a) * size.stride;
  std::fill_n(row, size.stride, 0.0);
  double* const by_q = row + size.first;
  see_from(s, a, w);
  seeing.kernels.surface.influence_slopes(seeing.tables, seeing.sources, {w.place[a], w.centre[a]},
                                          w.seen[0]);
  const Displacement middle = fill_row(seeing.kernels, s, w, a, w.seen[0], by_q);
  by_q[2 * s.count + a] -= strip.depth_by_c;
  double* const right = row + size.contact + size.rows;
  for (std::int32_t k = 0; k < inputs; ++k) right[k] = strip.deeper[k] - middle.turned[k];
}

/// dq = r - G (dL, dc): solves the equations of contact for the line loads. Leaves rows (G | r) in
/// w.by_lengths.
void loads_by_lengths(const Kernels& kernels, const Size& size, const Scratch& w) {
  const std::int64_t stride = size.stride;
  // Rows of the unit matrix before those of the strips, up to a multiple of four.
  for (std::int32_t i = 0; i < size.first; ++i) {
    std::fill_n(w.matrix + i * stride, stride, 0.0);
    w.matrix[i * stride + i] = 1.0;
  }
  kernels.normal.eliminate({size.contact, stride, w.matrix, nullptr, nullptr});
  // Back substitution, upwards, of all right-hand sides: (row - sum of row_c x_c) / pivot.
  for (std::int32_t i = size.contact - 1; i >= size.first; --i) {
    double* const row = w.matrix + i * stride;
    std::int32_t count = 0;
    for (std::int32_t c = i; c < size.contact; ++c, ++count) {
      w.share[count] = c == i ? row[i] : -row[i] * row[c];
      w.row[count] = w.matrix + c * stride + size.contact;
    }
    kernels.surface.blend_rows({count, size.reduced, w.share, w.row, row + size.contact});
  }
  // Closed up: the memory behind them is that of the equations of L and c.
  for (std::int32_t a = 0; a < size.strips; ++a) {
    const double* const row = w.matrix + (size.first + a) * stride + size.contact;
    std::copy(row, row + size.reduced, w.by_lengths + a * size.reduced);
  }
}

/// Lists the rows that blend_edges() sums, those of the edges first.
void list_rows(const Size& size, const Scratch& w) {
  w.row[0] = w.leading + size.contact;
  w.row[1] = w.trailing + size.contact;
  for (std::int32_t b = 0; b < size.strips; ++b) w.row[b + 2] = w.by_lengths + b * size.reduced;
}

/// A row of L and c from shares of the rows of strip a's edges, which have all unknowns: less its derivatives
/// by q, that by the strip's own with `own` more, times those of q.
void blend_edges(const Kernels& kernels, const Size& size, std::int32_t a, double of_leading,
                 double of_trailing, double own, const Scratch& w, double* to) {
  w.share[0] = of_leading;
  w.share[1] = of_trailing;
  const double *const leading = w.leading + size.first, *const trailing = w.trailing + size.first;
  double* const by_load = w.share + 2;
  for (std::int32_t b = 0; b < size.strips; ++b)
    by_load[b] = -(of_leading * leading[b] + of_trailing * trailing[b]);
  by_load[a] -= own;
  kernels.surface.blend_rows({size.strips + 2, size.reduced, w.share, w.row, to});
}

/// Strip a's rows of the lambda and shift that its own edges ask for, which smooth() blends with its
/// neighbours'. They hold derivatives by L and c, and on the right those by the inputs at fixed L and c, with
/// the sign of the other side.
void fill_edges(const Seeing& seeing, const PressedStrips& s, const Size& size, std::int32_t a,
                const Scratch& w) {
  const std::int32_t n = s.count;
  const Kernels& kernels = seeing.kernels;
  const SeenStrip strip(s, w, a);
  const OverlapSlopes& o = strip.o;
  const double q = strip.q, l = strip.l, kappa = strip.kappa;
  for (double* const row : {w.leading, w.trailing}) std::fill_n(row, size.stride, 0.0);

  see_from(s, a, w);
  // Rows of u+ at c + l and u- at c - l; these points move with L, too.
  const double x[2] = {w.centre[a] + l, w.centre[a] - l};
  kernels.surface.edge_slopes(seeing.tables, seeing.sources, w.place[a], x, w.seen);
  const Displacement leading = fill_row(kernels, s, w, a, w.seen[0], w.leading + size.first);
  w.leading[size.contact + a] += leading.by_x * w.dl_dL[a];
  const Displacement trailing = fill_row(kernels, s, w, a, w.seen[1], w.trailing + size.first);
  w.trailing[size.contact + a] -= trailing.by_x * w.dl_dL[a];

  // lambda* = q kappa / (2 drop) and shift* = (u- - u+) / (2 l kappa), as read_edges() of edge_condition.cpp
  // has them. At a limit of the ratio lambda* = q / (l^2 ratio) does not change with the drop.
  const double drop = strip.depth - 0.5 * (leading.value + trailing.value);
  const double ratio = drop / (0.5 * kappa * l * l);
  const double kept = smaller(larger(ratio, least_edge_ratio), most_edge_ratio);
  const bool free = kept == ratio;
  w.edge_lambda[a] = q / (l * l * kept);
  w.edge_shift[a] = (trailing.value - leading.value) / (2.0 * l * kappa);
  const double by_drop = free ? w.edge_lambda[a] / drop : 0.0;  // minus d lambda* / d drop
  const double by_edges = 1.0 / (2.0 * l * kappa);

  // Rows of u+ and u- become rows of lambda* and shift*.
  double *const lambda = w.lengths + a * size.reduced, *const shift = w.lengths + (n + a) * size.reduced;
  blend_edges(kernels, size, a, 0.5 * by_drop, 0.5 * by_drop, 1.0 / (l * l * kept), w, lambda);
  blend_edges(kernels, size, a, -by_edges, by_edges, 0.0, w, shift);
  lambda[n + a] -= by_drop * strip.depth_by_c;
  if (!free) lambda[a] -= 2.0 * w.edge_lambda[a] / l * w.dl_dL[a];
  shift[a] -= w.edge_shift[a] / l * w.dl_dL[a];

  // Right-hand sides: the inputs change depth, curvature, deepest point and directions.
  double *const lambda_right = lambda + size.rows, *const shift_right = shift + size.rows;
  for (std::int32_t k = 0; k < inputs; ++k) {
    const double bent = o.curvature.d[static_cast<std::size_t>(k)] / kappa;
    const double edges = 0.5 * (leading.turned[k] + trailing.turned[k]);
    lambda_right[k] -= free ? w.edge_lambda[a] * bent - by_drop * (strip.deeper[k] - edges) : 0.0;
    shift_right[k] -= by_edges * (trailing.turned[k] - leading.turned[k]) - w.edge_shift[a] * bent;
  }
}

/// A smoothed number at a strip, and the strips within reach, `from` .. `from` + count - 1. A wide strip
/// beside narrow ones may reach over all of them.
struct Smoothed {
  double value;
  std::int32_t from, count;
};

/// Weighted mean of `edge` over strip a's neighbours (lambda_reach), or the line of least squares through
/// them at its place (shift_reach, SurfaceKernels::near_lines). Derivatives by the neighbours' numbers are in
/// w.by_value, those by their line loads, which weigh them, in w.by_load.
///
///     weight_b = (1 - y_b^2)^3 w_b q_b,  y_b = (s_b - s_a) / reach
///     mean: value = <v>     line: value = <v> - <y> slope,  slope = (<y v> - <y> <v>) / spread
template <bool line>
Smoothed smooth_at(const Kernels& kernels, const PressedStrips& s, const Scratch& w, std::int32_t a,
                   const double* edge) {
  const double reach = line ? shift_reach(s.width[a]) : lambda_reach(s.width[a], w.lambda_length);
  Smoothed r{0.0, a, 0};
  const std::int32_t first = a < s.behind ? 0 : s.behind, end = a < s.behind ? s.behind : s.count;
  while (r.from > first && w.place[a] - w.place[r.from - 1] < reach) --r.from;
  r.count = a - r.from;
  while (r.from + r.count < end && w.place[r.from + r.count] - w.place[a] < reach) ++r.count;
  // weights, moments and derivatives
  r.value = kernels.surface.smoothed_slopes({r.count, line, w.place[a], 1.0 / reach, least_line_spread,
                                             w.place + r.from, s.width + r.from, s.line_load + r.from,
                                             edge + r.from, w.by_value, w.by_load});
  // Nothing presses within reach: lambda is the strip's own, and there is no line.
  if (!line && r.value == 0.0) {
    r.value = edge[a];
    w.by_value[a - r.from] = 1.0;
  }
  return r;
}

/// Replaces the rows of lambda*, or with `line` of shift*, by `factor_of` times those of the smoothed value,
/// for lambda less dq / lambda: by the chain rule sums of the neighbours' rows and of their loads. All rows
/// are kept until they are replaced, some columns of them at a time.
template <bool line, class Factor>
void smooth_rows(const Kernels& kernels, const PressedStrips& s, const Size& size, const double* edge,
                 const Factor& factor_of, const Scratch& w) {
  const std::int64_t stride = size.reduced;
  double* const rows = w.lengths + (line ? s.count * stride : 0);
  for (std::int64_t first = 0; first < stride; first += w.kept_columns) {
    const std::int64_t columns = std::min(w.kept_columns, stride - first);
    // each strip's own row, then that of its load
    for (std::int32_t a = 0; a < s.count; ++a) {
      std::copy_n(rows + a * stride + first, columns, w.kept + a * columns);
      w.row[2 * a] = w.kept + a * columns;
      w.row[2 * a + 1] = w.by_lengths + a * stride + first;
    }
    for (std::int32_t a = 0; a < s.count; ++a) {
      // The value, its derivatives by the neighbours' values and loads, and the factor of the equation.
      const Smoothed r = smooth_at<line>(kernels, s, w, a, edge);
      const double factor = factor_of(a, r.value);
      for (std::int32_t i = 0; i < r.count; ++i) {
        w.share[2 * i] = factor * w.by_value[i];
        w.share[2 * i + 1] = -(factor * w.by_load[i]);
      }
      if (!line) w.share[2 * (a - r.from) + 1] += 1.0 / r.value;
      kernels.surface.blend_rows(
          {2 * r.count, columns, w.share, w.row + 2 * r.from, rows + a * stride + first});
    }
  }
}

/// Turns the rows of lambda* and shift* into the equations of L and c.
void smooth(const Kernels& kernels, const PressedStrips& s, const Size& size, const Scratch& w) {
  const std::int32_t n = s.count;
  // L lambda - q = 0 over lambda: dL + L / lambda dlambda - dq / lambda = 0.
  smooth_rows<false>(
      kernels, s, size, w.edge_lambda,
      [&w](std::int32_t a, double lambda) { return w.l[a] * w.l[a] / lambda; }, w);
  // c - shift = W; a shift at its limit does not change.
  smooth_rows<true>(
      kernels, s, size, w.edge_shift,
      [](std::int32_t, double shift) { return magnitude(shift) < longest_shift ? -1.0 : 0.0; }, w);
  // The equations' own terms, and W on the right.
  for (std::int32_t a = 0; a < n; ++a) {
    double* const shift_row = w.lengths + (n + a) * size.reduced;
    w.lengths[a * size.reduced + a] += 1.0;
    shift_row[n + a] += 1.0;
    for (std::int32_t k = 0; k < inputs; ++k)
      shift_row[size.rows + k] += s.overlap[a].centre.d[static_cast<std::size_t>(k)];
  }
}

/// Right-hand sides of a row less its derivatives by L and c, from a column on, times their changes.
void take_known(const Kernels& kernels, const double* row, std::int32_t from, const Size& size,
                const Scratch& w, double (&sum)[inputs]) {
  static_assert(inputs == 4, "as the kernel takes them");
  std::copy_n(row + size.rows, inputs, sum);
  kernels.surface.take_known(row, from, 2 * size.strips, w.x, sum);
}

/// Solves the equations of L and c for all inputs: w.x.
void solve_lengths(const Kernels& kernels, const Size& size, const Scratch& w) {
  // Rows of the unit matrix up to a multiple of four.
  for (std::int32_t i = 2 * size.strips; i < size.rows; ++i) {
    std::fill_n(w.lengths + i * size.reduced, size.reduced, 0.0);
    w.lengths[i * size.reduced + i] = 1.0;
  }
  kernels.normal.eliminate({size.rows, size.reduced, w.lengths, nullptr, nullptr});
  // x_i = (r_i - sum of a_ic x_c) / a_ii, all inputs at once; inverses of the pivots are on the diagonal.
  for (std::int32_t i = size.rows - 1; i >= 0; --i) {
    const double* const row = w.lengths + i * size.reduced;
    double sum[inputs];
    take_known(kernels, row, i + 1, size, w, sum);
    double* const x = w.x + static_cast<std::int64_t>(i) * inputs;
    for (std::int32_t k = 0; k < inputs; ++k) x[k] = sum[k] * row[i];
  }
}

}  // namespace

std::int64_t pressure_jacobian_doubles(std::int32_t most) {
  Arena counted;
  cut(counted, most, 0);
  return counted.doubles();
}

void differentiate_pressures(const PressureModel& model, double* workspace, std::int64_t doubles,
                             const PressedStrips& s) noexcept {
  const std::int32_t n = s.count;
  if (n == 0) return;
  Arena arena(workspace);
  Scratch w = cut(arena, n, doubles);
  w.lambda_length = model.lambda_length;
  const Size size = size_of(n);
  list_sources(model, s, w);
  const Seeing seeing(model, s, w);
  // Contact gives the loads by L and c, then lambda and shift of every strip give these.
  for (std::int32_t a = 0; a < n; ++a) fill_contact(seeing, s, size, a, w);
  loads_by_lengths(model.kernels, size, w);
  list_rows(size, w);
  for (std::int32_t a = 0; a < n; ++a) fill_edges(seeing, s, size, a, w);
  smooth(model.kernels, s, size, w);
  solve_lengths(model.kernels, size, w);

  const auto dual = [](double value, const double* d) {
    PlaceDual number = value;
    std::copy_n(d, inputs, number.d.begin());
    return number;
  };
  for (std::int32_t a = 0; a < n; ++a) {
    double load[inputs];
    take_known(model.kernels, w.by_lengths + a * size.reduced, 0, size, w, load);
    s.line_load_dual[a] = dual(s.line_load[a], load);
    s.length_squared_dual[a] = dual(s.length_squared[a], w.x + static_cast<std::int64_t>(a) * inputs);
    s.centre_dual[a] = dual(s.centre[a], w.x + (static_cast<std::int64_t>(n) + a) * inputs);
  }
}

}  // namespace wrc::surface
