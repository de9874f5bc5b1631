/// Start of a group of strips in strip FASTSIM (strip_fastsim_kernel.hpp): the strips' numbers from either
/// task, relative, the onset of slip, the state there; and the derivatives of these.
#pragma once

#include "base/pack.hpp"
#include "tangential/march/march_grid.hpp"
#include "tangential/march/stick_zone.hpp"
#include "tangential/simd/strip_group.hpp"
#include "tangential/simd/tasks.hpp"
#include "tangential/simd/turning.hpp"

namespace wrc::simd {
namespace {

namespace strip {

constexpr double tiny_stress = 1e-6;  // [Pa]: keeps divisions finite, far below any stress of interest

/// A step of length dv to a cell at x: tractions of full adhesion grow by (gx, gy + curvature (2 x + dv));
/// the rigid slip times dv at the cell is (wx, wy + spin x), and its y part falls by `bend` along the step;
/// the elastic slip times dv there is elastic x (rho_x, -rho_y).
struct Advance {
  Pack gx, gy, curvature;
  Pack wx, wy, spin, bend, elastic;
};

/// Constants of the strips of a group.
struct Group : StripGroup {
  bool any_strong;         ///< the stick zone of a strip may reach the bound
  Pack gx, gy, curvature;  ///< growth of adhesion tractions (gx, gy + 2 curvature x)
  Pack slip_end;           ///< u_s, over the half length
  Pack end_bound;          ///< bound of the march there
  Pack kappa, lambda;      ///< direction in which slip sets in
  Pack psi;                ///< psi_k: part of spin in the traction over the bound
  Mask strong;             ///< |psi| > 1
  Pack wx, wy, spin;       ///< rigid slip (wx, wy + spin x)
  Pack elastic;            ///< part of the elastic slip that differs between x and y, at the leading edge
  Advance over_cell;       ///< step over a whole cell
  Pack centre;             ///< x of the strip's middle [m]
  Pack slope;              ///< B l [Pa/m]
  Pack near_edge;          ///< tractions of adhesion over the bound at the leading edge, squared; at most 1
  Pack form;               ///< share of FASTSIM's form 1 - t in strip theory's sqrt(1 - t)
  Pack t11, t22;           ///< flexibilities for the turning of slip, relative
  Pack scale;              ///< relative growth over growth [m/Pa]
};

struct State {
  Pack ex, ey;        ///< direction of the traction
  Pack ahead;         ///< part of a step ahead of the cell where the slip is seen (turning.hpp)
  bool stuck;         ///< in some lane the traction is below the bound:
  Pack rho_x, rho_y;  ///< then the traction over the bound in each lane, else not set

  Pack x() const { return stuck ? rho_x : ex; }
  Pack y() const { return stuck ? rho_y : ey; }
};

/// Sums over the first stick zone; those of slopes are for the derivatives.
struct StickSums {
  Pack mean, t_mean;           ///< the bound; as all that follow also times t
  Pack straight, t_straight;   ///< s times the bound
  Pack slope, t_slope;         ///< ds / du_s times the bound
  Pack form, t_form;           ///< ds / d(form) times the bound
  Pack power_near, root_near;  ///< (u / h - u_s / h)^(3/2) and ^(1/2) at the next cell's leading border
};

struct Sums {
  ForceSums force;
  Pack power, unslid;
};

struct Derivative {
  Pack gx, gy, curvature, slip_end, kappa, lambda, psi, wx, wy, spin;
  Advance over_cell;
  double turning;  ///< relative
  Pack form;
  Pack angle, ratio, ahead;  ///< state: angle of e, |rho|, ahead
  ForceSums force;
};

/// A cell, the same for all strips.
struct Cell {
  std::int32_t index;
  double t, x;                 ///< at its middle
  double shape_before, shape;  ///< the march's bound u t at the middle of the cell before and of this one
  double mean;                 ///< mean of the bound mu p, over its value at the strip's middle
  double h, per_h;
  double behind, inverse_weight;  ///< u / h at its trailing border; of the mean of sqrt(1 - t_s)
};

/// G: a group or its derivatives.
template <class G>
inline Advance advance_over(const G& g, Pack elastic, Pack dv) {
  const Pack spin = g.spin * dv;
  return {g.gx * dv, g.gy * dv, g.curvature * dv, g.wx * dv, g.wy * dv, spin, spin * dv, elastic * dv};
}

/// Reads the numbers of a group's strips from the task; returns the bound of the march at their middle [Pa].
inline Pack read_strips(const StripFastsimTask& task, std::int32_t first, std::int32_t count, Group& g) {
  // bounds: that of the result mu p [Pa], that of the march B u v by its value B l^2 at the middle [Pa]
  const patch::Strips& strips = *task.region;
  const Pack one = 1.0;
  place(strips, task.cells, first, count, g);
  g.centre = load(strips.centre, first, count, 0.0);
  const Pack share = task.shares ? load(task.shares, first, count, 0.0) : one;
  g.bound = task.friction * (share * load(strips.peak, first, count, 0.0));
  g.slope = task.B * share * g.half_length;
  const Pack middle = g.slope * g.half_length + tiny_stress;
  g.scale = g.half_length / middle;
  // growth of adhesion tractions over the march's bound / half length; slips about the strip's middle [-];
  // flexibilities that turn the slip [-]
  g.gx = (task.gx_constant.value - task.gx_by_y.value * g.y) * g.scale;
  g.gy = (task.gy_constant.value + task.gy_by_x.value * g.centre) * g.scale;
  g.curvature = 0.5 * task.gy_by_x.value * g.half_length * g.scale;
  g.wx = task.nu_x - task.phi * g.y;
  g.wy = task.nu_y + task.phi * g.centre + task.torsion.value;
  g.spin = task.phi * g.half_length;
  g.elastic = task.elastic * share * g.half_length;
  g.t11 = task.turning.value * task.t11 / g.scale;
  g.t22 = task.turning.value * task.t22 / g.scale;
  return middle;
}

/// The same of strips with numbers of their own, each about its own middle.
inline Pack read_strips(const SurfaceStripsTask& task, std::int32_t first, std::int32_t count, Group& g) {
  const auto of = [&](const double* values) { return load(values, first, count, 0.0); };
  place(task.width, task.half_length, task.cells, first, count, g);
  g.bound = of(task.bound);
  g.gx = of(task.growth_x);
  g.gy = of(task.growth_y);
  g.curvature = of(task.curvature);
  g.wx = of(task.slip_x);
  g.wy = of(task.slip_y);
  g.spin = of(task.spin) * g.half_length;
  g.elastic = of(task.elastic);
  g.t11 = of(task.turn_x);
  g.t22 = of(task.turn_y);
  return g.bound + tiny_stress;
}

/// Direction in which a strip starts to slip: 0 that of growth, 1 against the slip, between in proportion.
inline Pack start_against_slip(const StripFastsimTask&, Pack slip_end) {
  return select(slip_end >= 2.0, Pack(1.0), Pack(0.0));
}

/// From 0 to 1 as the stick zone at the leading edge shrinks from a cell to none: forces of a strip whose
/// slip reaches that edge must not jump.
inline Pack start_against_slip(const SurfaceStripsTask& task, Pack slip_end) {
  const Pack t = larger(0.0, 1.0 - (0.5 * task.cells) * (2.0 - slip_end));
  return t * t * (3.0 - 2.0 * t);
}

template <class Task>
inline void prepare(const Task& task, std::int32_t first, std::int32_t count, Group& g, State& state) {
  const double h = 2.0 / task.cells;
  const Pack zero = 0.0, one = 1.0;
  const Pack middle = read_strips(task, first, count, g);
  g.over_cell = advance_over(g, g.elastic, h);

  // A strip about to slip at the leading edge may, with |psi| > 1, have sticking material behind it, to which
  // the march gives FASTSIM's form: the closed form must arrive there too, or forces jump strip by strip.
  const Pack lead = g.gy + 2.0 * g.curvature;
  g.near_edge = smaller(one, 0.25 * (g.gx * g.gx + lead * lead));
  const Pack near2 = g.near_edge * g.near_edge;
  g.form = near2 * near2;

  const tangential::AdhesionGrowth<Pack> growth{g.gx, lead, g.curvature};
  g.slip_end = tangential::slip_end_parabolic<Pack>(growth, one, one);
  set_stick_zone((2.0 - g.slip_end) * (0.5 * task.cells), task.cells, g);

  // (kappa, lambda) = -(gx, gy + k u_s) / u_s, the march's traction over its bound where slip sets in, a unit
  // vector; psi = -k (theory.md, strip FASTSIM). The form of strip theory exceeds the bound where |psi| > 1.
  const Pack per_end = one / (g.slip_end + tiny_stress / middle);
  const Pack gy_end = g.gy + g.curvature * g.slip_end;
  g.kappa = -(g.gx * per_end);
  g.lambda = -(gy_end * per_end);
  g.psi = -g.curvature;
  g.strong = (magnitude(g.psi) > one) & (g.stick_cells > zero);
  g.any_strong = any(g.strong);

  // A strip that slips from its leading edge on starts against the slip there, whose elastic part depends on
  // the direction itself: three substitutions settle it.
  const Pack share = start_against_slip(task, g.slip_end);
  const Mask at_edge = share > zero, partly = at_edge & (share < one);
  Pack ex = g.kappa, ey = g.lambda, growth_x = ex, growth_y = ey;
  for (int n = 0; n < 4; ++n) {
    Pack wx = g.gx, wy = gy_end;  // n == 0: against the growth at u_s
    if (n > 0) {
      wx = select(at_edge, n == 1 ? g.wx : g.wx + g.elastic * ex, g.gx);
      wy = select(at_edge, n == 1 ? g.wy + g.spin : g.wy + g.spin - g.elastic * ey, gy_end);
    }
    const Pack inverse = one / (root(wx * wx + wy * wy) + 1e-100);
    ex = -(wx * inverse);
    ey = -(wy * inverse);
    if (n == 0) {
      growth_x = ex;
      growth_y = ey;
    }
  }
  // between the two directions: along the chord, made a unit vector
  if (any(partly)) {
    const Pack x = growth_x + share * (ex - growth_x), y = growth_y + share * (ey - growth_y);
    const Pack inverse = one / (root(x * x + y * y) + 1e-100);
    ex = select(partly, x * inverse, ex);
    ey = select(partly, y * inverse, ey);
  }
  state.ex = ex;
  state.ey = ey;
  state.ahead = first_ahead;
  state.stuck = false;
  g.end_bound = g.slip_end * (2.0 - g.slip_end);
}

/// Change of a vector's angle by changes of its components: turn_x dx + turn_y dy.
struct Angle {
  Pack turn_x, turn_y;

  Angle() = default;
  Angle(Pack x, Pack y) {
    const Pack square = x * x + y * y;
    const Mask turns = square > 1e-280;
    const Pack inverse = select(turns, 1.0 / select(turns, square, 1.0), 0.0);
    turn_x = -(y * inverse);
    turn_y = x * inverse;
  }
  Pack change(Pack dx, Pack dy) const { return turn_x * dx + turn_y * dy; }
};

/// Derivatives of the onset of slip: the parts that cost a root or a divide, which all inputs share.
struct Onset {
  Pack u, c;  ///< u_s: gx^2 + c^2 = u^2, c = gy + curvature u
  Pack lead, form_by_near, per_by_u, per_end;
  Angle at_end;

  explicit Onset(const Group& g) {
    // slope of form = near^4; 1 / (dF/du_s / 2) of F = u^2 - gx^2 - c^2, 0 where u_s is an end of the strip
    const Pack zero = 0.0, one = 1.0;
    lead = g.gy + 2.0 * g.curvature;
    const Pack near = select(g.near_edge < one, g.near_edge, zero);
    form_by_near = 4.0 * (near * near * near);
    u = g.slip_end;
    c = g.gy + g.curvature * u;
    const Pack by_u = u - c * g.curvature;
    const Mask inside = (u > zero) & (u < 2.0) & (magnitude(by_u) > 1e-280);
    per_by_u = select(inside, one / select(inside, by_u, one), zero);
    per_end = one / (u + 1e-14);
    at_end = Angle(g.gx, c);
  }

  /// Derivatives by the growth of adhesion tractions, whose changes are given.
  template <class Changes>
  void differentiate(const Group& g, Pack gx, Pack gy, Pack curvature, Changes& d) const {
    // du_s = (gx dgx + c dc) / (u - c k); then kappa, lambda and the angle of the traction at u_s with it
    d.form = form_by_near * (0.5 * (g.gx * gx + lead * (gy + 2.0 * curvature)));
    const Pack c_input = gy + curvature * u;
    d.slip_end = (g.gx * gx + c * c_input) * per_by_u;
    const Pack c_change = c_input + g.curvature * d.slip_end;
    d.kappa = -((gx + g.kappa * d.slip_end) * per_end);
    d.lambda = -((c_change + g.lambda * d.slip_end) * per_end);
    d.psi = -curvature;
    d.angle = at_end.change(gx, c_change);
  }
};

/// Derivatives of the direction of a strip that slips from its leading edge on, found by substitutions as in
/// prepare().
struct EdgeDirection {
  static constexpr int substitutions = 3;
  Angle angles[substitutions];
  Pack x[substitutions], y[substitutions];  ///< direction of the slip, with which the elastic slip goes

  explicit EdgeDirection(const Group& g) {
    // the slips of prepare(), against which the traction then lies
    Pack wx = g.wx, wy = g.wy + g.spin;
    for (int n = 0; n < substitutions; ++n) {
      angles[n] = Angle(wx, wy);
      const Pack inverse = 1.0 / (root(wx * wx + wy * wy) + 1e-100);
      x[n] = wx * inverse;
      y[n] = wy * inverse;
      wx = g.wx - g.elastic * x[n];
      wy = g.wy + g.spin + g.elastic * y[n];
    }
  }

  /// Change of the angle by changes of the rigid slip and of the factor `elastic` on the elastic slip.
  Pack change(const Group& g, Pack wx, Pack wy, Pack elastic) const {
    Pack angle = angles[0].change(wx, wy);
    for (int n = 1; n < substitutions; ++n)
      angle = angles[n].change((wx + (g.elastic * y[n - 1]) * angle) - elastic * x[n - 1],
                               (wy + (g.elastic * x[n - 1]) * angle) + elastic * y[n - 1]);
    return angle;
  }
};

/// Derivatives of the numbers that prepare() sets.
inline void differentiate(const StripFastsimTask& task, const Group& g, Derivative (&derivative)[inputs]) {
  const Pack zero = 0.0;
  const Onset onset(g);
  const Mask at_edge = onset.u >= 2.0;
  const bool any_at_edge = any(at_edge);
  const EdgeDirection edge(g);

  for (std::int32_t k = 0; k < inputs; ++k) {
    // growths, slips and the factor on the turning as read_strips() makes them; slips are inputs 0 to 2
    Derivative& d = derivative[k];
    d = {};
    d.gx = (task.gx_constant.d[k] - task.gx_by_y.d[k] * g.y) * g.scale;
    d.gy = (task.gy_constant.d[k] + task.gy_by_x.d[k] * g.centre) * g.scale;
    d.curvature = 0.5 * task.gy_by_x.d[k] * g.half_length * g.scale;
    if (k == 0) d.wx = 1.0;
    if (k == 1) d.wy = 1.0;
    if (k == 2) {
      d.wx = -g.y;
      d.wy = g.centre;
      d.spin = g.half_length;
    }
    d.wy += task.torsion.d[k];
    d.turning = task.turning.d[k] / task.turning.value;
    // onset; at the leading edge the direction is that of the edge, not of growth
    onset.differentiate(g, d.gx, d.gy, d.curvature, d);
    if (any_at_edge) d.angle = select(at_edge, edge.change(g, d.wx, d.wy + d.spin, zero), d.angle);
    d.over_cell = advance_over(d, zero, 2.0 / task.cells);
  }
}

}  // namespace strip

}  // namespace
}  // namespace wrc::simd
