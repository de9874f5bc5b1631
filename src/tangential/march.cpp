#include "tangential/march.hpp"

#include <algorithm>
#include <cmath>

#include "patch/material.hpp"
#include "tangential/lanes.hpp"
#include "tangential/stick_zone.hpp"

namespace wrc {
namespace {

/// What does not change along the strips of a group.
struct Group {
  Lane<double> lead{}, half_length{}, y{}, width{};
  Lane<double> gx{}, gy{}, gy_rate{};  ///< growth of adhesion tractions: (gx, gy - gy_rate v)
  Lane<double> bound{};                ///< traction bound at the strip's middle [Pa]
  Lane<double> onset{};                ///< v at which the first stick zone ends [m]
};

/// What the march carries from cell to cell: the traction and the bound where the last step ended.
struct State {
  Lane<double> px{}, py{}, bound{};
};

struct Sums {
  Lane<double> px{}, py{}, x_py{}, power{}, slid{};
};

struct CellRow {
  Lane<double> px{}, py{}, sx{}, sy{};
};

/// Bound at the middle of each strip, as the factors of a common part and of what differs between strips.
struct BoundScale {
  double per_pressure = 0.0;       ///< elliptic: mu
  double per_length_square = 0.0;  ///< parabolic: mu N / IInt (x_l^2 - x^2) dA
};

BoundScale bound_scale(const TangentialProblem& problem) {
  if (problem.bound == TractionBound::elliptic) return {problem.friction, 0.0};
  double integral = 0.0;
  const Strips& strips = problem.region;
  for (std::int32_t j = 0; j < strips.count; ++j) {
    const double l = strips.half_length[j];
    integral += 4.0 / 3.0 * l * l * l * strips.width[j];
  }
  return {0.0, integral > 0.0 ? problem.friction * totals(strips).normal_force / integral : 0.0};
}

Group prepare(const TangentialProblem& problem, const BoundScale& scale, std::int32_t first,
              std::int32_t count) {
  const Creepage& creep = problem.creepage;
  const Flexibility& L = problem.flexibility;
  Group g;
  g.half_length.fill(1.0);  // lanes without a strip: no creepage, no bound, but a length to divide by
  for (std::int32_t k = 0; k < count; ++k) {
    const std::int32_t j = first + k;
    const double l = problem.region.half_length[j];
    g.half_length[k] = l;
    g.lead[k] = problem.region.centre[j] + l;
    g.y[k] = problem.region.y[j];
    g.width[k] = problem.region.width[j];
    g.gx[k] = creep.longitudinal / L.l11 - creep.spin * g.y[k] / L.l13;
    g.gy[k] = creep.lateral / L.l22 + creep.spin * g.lead[k] / L.l23;
    g.gy_rate[k] = creep.spin / L.l23;
    g.bound[k] = scale.per_pressure * problem.region.peak[j] + scale.per_length_square * l * l;
    const AdhesionGrowth growth{g.gx[k], g.gy[k], 0.5 * g.gy_rate[k]};
    g.onset[k] = problem.bound == TractionBound::parabolic
                     ? onset_parabolic(growth, scale.per_length_square, l)
                     : onset_elliptic(growth, g.bound[k] / l, l);
  }
  return g;
}

/// Traction and bound at the onset of slip. Where a strip slips from its leading edge on, only the direction
/// of the (vanishing) traction matters, which is that of the adhesion tractions a little behind the edge.
State at_onset(const Group& g, TractionBound bound, std::int32_t count) {
  State s;
  for (std::int32_t k = 0; k < count; ++k) {
    const double length = 2.0 * g.half_length[k];
    const double v = g.onset[k];
    const double v_direction = std::max(v, 1e-9 * length);
    s.px[k] = -g.gx[k] * v_direction;
    s.py[k] = -(g.gy[k] - 0.5 * g.gy_rate[k] * v_direction) * v_direction;
    const double shape = 4.0 * v * (length - v) / (length * length);
    s.bound[k] = g.bound[k] * (bound == TractionBound::parabolic ? shape : std::sqrt(std::max(0.0, shape)));
  }
  return s;
}

/// One march step of a group: cell i, whose mean bound and rise of the bound relative to the strip's middle
/// are given. Written without branches; a lane computes stick and slip and selects.
inline void step(const Group& g, const Flexibility& L, std::int32_t i, std::int32_t cells, double shape_mean,
                 double shape_rise, State& state, Sums& sums, CellRow& row) {
  // Keeps divisions finite where bound, traction or creepages vanish; far below any stress of interest.
  constexpr double tiny_stress = 1e-6;  // [Pa]
  constexpr double largest_turn = 1e8;  // z beyond which the direction has long reached -g
  for (std::int32_t k = 0; k < lanes; ++k) {
    const double h = 2.0 * g.half_length[k] / cells;
    const double v = (i + 0.5) * h;
    const double gx = g.gx[k];
    const double gy = g.gy[k] - g.gy_rate[k] * v;
    const double tau = g.bound[k] * shape_mean;

    // the first stick zone: mean over the cell of p = -v (gx, gy_lead - gy_rate v / 2)
    const bool first_stick = v <= g.onset[k];
    const double stick_x = -gx * v;
    const double stick_y = -(g.gy[k] * v - 0.5 * g.gy_rate[k] * (v * v + h * h / 12.0));

    // from where the last step ended (or slip set in) to this cell
    const double dv = std::max(0.0, std::min(h, v - g.onset[k]));
    const double gy_mid = gy + 0.5 * g.gy_rate[k] * dv;
    const double px = state.px[k], py = state.py[k];
    const double trial_x = px - dv * gx, trial_y = py - dv * gy_mid;
    const bool stick = trial_x * trial_x + trial_y * trial_y <= tau * tau;

    // slip: turn p towards -g, set its magnitude to the bound. g, which itself turns under spin, is taken
    // where a direction that decays like 1 / q would see it: mid-step for small z, the cell itself for large
    // z.
    const double turn =
        2.0 * dv * std::sqrt(gx * gx + gy_mid * gy_mid) / (state.bound[k] + tau + tiny_stress);
    const double z = std::min(turn, largest_turn);
    const double q = 1.0 + z + 0.5 * z * z;
    const double gy_seen = gy + g.gy_rate[k] * dv / (2.0 + z);
    const double g2 = gx * gx + gy_seen * gy_seen;
    const double product = std::sqrt((px * px + py * py) * g2);
    const double along = -(px * gx + py * gy_seen), across = gy_seen * px - gx * py;
    const double towards = (product + along) * q * q - (product - along), aside = 2.0 * across * q;
    const double turned_x = -towards * gx + aside * gy_seen, turned_y = -towards * gy_seen - aside * gx;
    const double turned2 = turned_x * turned_x + turned_y * turned_y;
    const bool has_direction = turned2 > 0.0;  // not so where g vanishes: then the direction stays
    const bool slips = !first_stick && !stick;
    const bool turns = slips && has_direction;
    const double free_x = first_stick ? stick_x : trial_x, free_y = first_stick ? stick_y : trial_y;
    const double dir_x = turns ? turned_x : free_x, dir_y = turns ? turned_y : free_y;
    const double norm2 = turns ? turned2 : free_x * free_x + free_y * free_y;
    const double inverse = 1.0 / std::sqrt(std::max(norm2, 1e-280));
    const double ex = dir_x * inverse, ey = dir_y * inverse;
    // Where slip sets in just behind the middle of a cell, the mean of the adhesion tractions may exceed that
    // of the bound: it is cut.
    const double within = std::min(1.0, tau * inverse);
    const double excess = std::max(0.0, -(gx * ex + gy * ey) - g.bound[k] * shape_rise / h);
    const double part = dv < h ? 0.5 + dv / h : 1.0;  // of a cell that has slid since the last cell
    const double lambda = slips ? excess * part : 0.0;

    row.px[k] = slips ? tau * ex : free_x * within;
    row.py[k] = slips ? tau * ey : free_y * within;
    row.sx[k] = -lambda * L.l11 * ex;
    row.sy[k] = -lambda * L.l22 * ey;
    state.px[k] = first_stick ? px : row.px[k];
    state.py[k] = first_stick ? py : row.py[k];
    state.bound[k] = first_stick ? state.bound[k] : tau;

    sums.px[k] += row.px[k];
    sums.py[k] += row.py[k];
    sums.x_py[k] += (g.lead[k] - v) * row.py[k];
    sums.power[k] += lambda * tau * (L.l11 * ex * ex + L.l22 * ey * ey);
    sums.slid[k] += slips ? part : 0.0;
  }
}

void store(const CellRow& row, std::int32_t count, std::ptrdiff_t at, const TangentialFields& fields) {
  if (fields.traction_x) std::copy_n(row.px.data(), count, fields.traction_x + at);
  if (fields.traction_y) std::copy_n(row.py.data(), count, fields.traction_y + at);
  if (fields.slip_x) std::copy_n(row.sx.data(), count, fields.slip_x + at);
  if (fields.slip_y) std::copy_n(row.sy.data(), count, fields.slip_y + at);
}

}  // namespace

TangentialForces march(const TangentialProblem& problem, const MarchGrid& grid,
                       const TangentialFields& fields) {
  const BoundScale scale = bound_scale(problem);
  const BoundShape& shape = grid.shape(problem.bound);
  const std::int32_t strips = problem.region.count;
  TangentialForces total;
  double area = 0.0, slid_area = 0.0;
  for (std::int32_t first = 0; first < strips; first += lanes) {
    const std::int32_t count = std::min(lanes, strips - first);
    const Group group = prepare(problem, scale, first, count);
    State state = at_onset(group, problem.bound, count);
    Sums sums;
    CellRow row;
    for (std::int32_t i = 0; i < grid.cells; ++i) {
      step(group, problem.flexibility, i, grid.cells, shape.mean[i], shape.rise[i], state, sums, row);
      store(row, count, static_cast<std::ptrdiff_t>(i) * strips + first, fields);
    }
    for (std::int32_t k = 0; k < count; ++k) {
      const double cell = 2.0 * group.half_length[k] / grid.cells * group.width[k];
      total.fx += sums.px[k] * cell;
      total.fy += sums.py[k] * cell;
      total.mz += (sums.x_py[k] - group.y[k] * sums.px[k]) * cell;
      total.power_per_speed += sums.power[k] * cell;
      area += cell * grid.cells;
      slid_area += sums.slid[k] * cell;
    }
  }
  total.adhesion_fraction = area > 0.0 ? 1.0 - slid_area / area : 0.0;
  return total;
}

}  // namespace wrc
