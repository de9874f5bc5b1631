/// Fields of strip FASTSIM (strip_fastsim_kernel.hpp): the slip of a cell, stored beside its traction.
#pragma once

#include "base/pack.hpp"
#include "tangential/march/stick_zone.hpp"
#include "tangential/methods/slip_across.hpp"
#include "tangential/simd/strip_fastsim_start.hpp"
#include "tangential/simd/strip_group.hpp"
#include "tangential/simd/tasks.hpp"

namespace wrc::simd {
namespace {

namespace strip {

/// Constants of the slip of a group's strips, for the fields.
struct SlipShape {
  Pack stick;                 ///< distance t at which slip begins
  Pack kappa, lambda;         ///< direction of the traction there
  Pack twice;                 ///< twice the factor across the patch (methods/slip_across.hpp); 0 without
                              ///< friction, where the slip has no direction
  Pack elastic_x, elastic_y;  ///< elastic slip at the leading edge along x and y
  Pack beside;                ///< lateral elastic slip at the middle by strips beside
  Pack per_even, per_odd;     ///< twice / (v + u_s - u) in a pair of cells, the first of even index
};

/// Sets the numbers that a task has of its strips; returns b k of methods/slip_across.hpp.
inline Pack set_slip(const StripFastsimTask& task, const Group& g, SlipShape& shape) {
  shape.elastic_x = (2.0 * task.l11) * g.slope;
  shape.elastic_y = (2.0 * task.l22) * g.slope;
  const Pack t = (g.y - task.middle) * task.per_width;
  shape.twice = 2.0 * tangential::slip_factor<Pack>(task.across_even, task.across_odd, t);
  return task.across_beside * g.curvature;
}
inline Pack set_slip(const SurfaceStripsTask& task, const Group& g, SlipShape& shape) {
  shape.elastic_x = load(task.edge_x, g.first, g.count, 0.0);
  shape.elastic_y = load(task.edge_y, g.first, g.count, 0.0);
  shape.twice = 2.0 * load(task.across, g.first, g.count, 0.0);
  return load(task.beside, g.first, g.count, 0.0);
}

template <class Task>
inline SlipShape slip_shape(const Task& task, const Group& g) {
  SlipShape shape;
  // growth (gx, gy + 2 k x) with the share b of k moved from 2 k x to the strip as a whole: gy + b k, k - b k
  const Pack moved = set_slip(task, g, shape), one = 1.0;
  const Pack curvature = g.curvature - moved;
  const tangential::AdhesionGrowth<Pack> growth{g.gx, g.gy + 2.0 * g.curvature - moved, curvature};
  const Pack end = tangential::slip_end_parabolic<Pack>(growth, one, one), per_end = one / (end + 1e-14);
  shape.stick = 2.0 - end;
  shape.kappa = -(g.gx * per_end);
  shape.lambda = -((g.gy + moved + curvature * end) * per_end);
  shape.beside = 0.5 * (moved * shape.elastic_y);
  shape.twice = select(g.bound > 0.0, shape.twice, 0.0);
  shape.per_even = shape.per_odd = 0.0;
  return shape;
}

/// Sets the inverses 2 / (v + u_s - u), times the factor across, of a pair of cells, of which `even` is the
/// first: one divide makes both.
inline void enter_pair(const Cell& even, SlipShape& shape) {
  // v + (u_s - u) with v = t and u_s - u = t - (2 - u_s), at the middles of both cells
  const double t_odd = even.t + even.h;
  const Pack of_even = even.t + larger(0.0, even.t - shape.stick);
  const Pack of_odd = t_odd + larger(0.0, t_odd - shape.stick);
  const Pack inverse = shape.twice / (of_even * of_odd);
  shape.per_even = of_odd * inverse;
  shape.per_odd = of_even * inverse;
}

/// Magnitude of the slip in a cell [-], before the scaling to the balance of power. It is the rigid slip
/// along the traction, plus the elastic slip 2 B L x of a strip that slips as a whole, plus that by strips
/// beside. Two factors follow: Carter's form where only u < u_s slips, 2 sqrt(v (u_s - u)) / (v + u_s - u),
/// and the factor by the place across.
inline Pack slip_size(const Group& g, SlipShape& shape, const Cell& cell, Pack rho_x, Pack rho_y) {
  if ((cell.index & 1) == 0) enter_pair(cell, shape);
  const Pack zero = 0.0;
  const Pack along = g.wx * rho_x + ((g.wy + g.spin * cell.x) + shape.beside * (1.0 - 2.0 * cell.x)) * rho_y;
  const Pack elastic = cell.x * (shape.elastic_y + (shape.elastic_x - shape.elastic_y) * (rho_x * rho_x));
  // the first cell whose middle slips stands for half a cell to one and a half
  const Pack behind = larger(zero, cell.t - shape.stick);
  const Pack cells = select(behind < cell.h, 0.5 + cell.per_h * behind, Pack(1.0));
  const Pack per_sum = (cell.index & 1) != 0 ? shape.per_odd : shape.per_even;
  return larger(zero, zero - (along + elastic)) * cells * (root(behind * cell.t) * per_sum);
}

/// A cell's traction, rho over the bound, and its slip against the unit vector (x, y), not yet scaled.
struct CellFields {
  Pack rho_x, rho_y, x, y, slip;
};

/// Stores them and adds to the power of the slip. A cell does not slip where its traction would aid that.
inline void store_cell(const StripFastsimMarch& task, const Group& g, const Cell& cell, const CellFields& f,
                       Sums& sums) {
  const Pack bound = cell.mean * g.bound, against = f.rho_x * f.x + f.rho_y * f.y;
  const Pack slip = select(against > 0.0, f.slip, 0.0);
  sums.power += (slip * against) * bound;
  simd::store_cell(*task.fields, g, cell.index, task.strips, bound * f.rho_x, bound * f.rho_y,
                   0.0 - slip * f.x, 0.0 - slip * f.y);
}

/// The fields of slip, whose power is known as that of their distribution only, are scaled.
inline void scale_slip(const StripFastsimMarch& task, double scale) {
  const std::int32_t cells = task.strips * task.cells;
  double* const fields[] = {task.fields->slip_x, task.fields->slip_y};
  for (double* field : fields) {
    for (std::int32_t at = 0; field != nullptr && at < cells; at += lanes) {
      const std::int32_t count = cells - at < lanes ? cells - at : lanes;
      store(scale * load(field, at, count, 0.0), field + at, count);
    }
  }
}

}  // namespace strip

}  // namespace
}  // namespace wrc::simd
