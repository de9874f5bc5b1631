/// First stick zones of strip FASTSIM (strip_fastsim_kernel.hpp). They need no march, but per cell the mean
/// of a root. With t_s = u_s / u the traction over the bound is
///     rho = (kappa, lambda) (1 - s) + (0, psi) s,
/// s the mean of sqrt(1 - t_s) and a little of its square. So the sums, and their derivatives, are made of
/// sums of s and of its slope.
#pragma once

#include "base/pack.hpp"
#include "tangential/simd/strip_fastsim_start.hpp"

namespace wrc::simd {
namespace {

namespace strip {

/// A cell of the first stick zone: tractions over the bound are (1 - s) times the direction in which slip
/// sets in, and s (0, psi). Beyond its end s is zero; the cell in which it ends has its part.
struct StickShape {
  Pack s, by_end, by_form;  ///< slopes of s by u_s and by the form, for derivatives
};

template <bool sensitivities>
WRC_IN_LOOP StickShape stick_shape(const Group& g, const Cell& cell, StickSums& sums) {
  const Pack zero = 0.0, form = g.form;
  // The mean of sqrt(1 - t_s) = sqrt((u - u_s) / u) over the cell, weighted by the bound's sqrt(u): small
  // creepages leave a traction 1 / sqrt(u) at the trailing edge, of which the middle of a cell sees too
  // little.
  const Pack far = larger(zero, cell.behind - g.slip_end * cell.per_h);
  const Pack root_far = root(far), power_far = far * root_far;
  const Pack whole = (sums.power_near - power_far) * cell.inverse_weight;
  // from sqrt(1 - t_s) of strip theory to its square 1 - t_s of FASTSIM by the share `form`; the border
  // between two cells is read once: far here is near of the next
  StickShape shape;
  shape.s = whole * (1.0 - form + form * whole);
  if constexpr (sensitivities) {
    shape.by_end = -1.5 * cell.per_h * cell.inverse_weight * (sums.root_near - root_far) *
                   (1.0 - form + 2.0 * form * whole);
    shape.by_form = whole * whole - whole;
    sums.root_near = root_far;
  }
  sums.power_near = power_far;
  return shape;
}

/// Sums over the first stick zone that begin with its cells.
inline StickSums first_stick_sums(const StripFastsimMarch& task, const Group& g) {
  // (u / h - u_s / h) at the leading edge, u = 2
  StickSums sums = {};
  const Pack near = larger(0.0, task.cells - g.slip_end * (0.5 * task.cells));
  sums.root_near = root(near);
  sums.power_near = near * sums.root_near;
  return sums;
}

/// Factor that cuts tractions to the bound, which they could exceed where |psi| > 1.
inline Pack share_within_bound(const Group& g, Pack s, Pack x, Pack y) {
  return select(g.strong & (s > 0.0), 1.0 / root(larger(1.0, x * x + y * y)), 1.0);
}

/// The derivative (dx, dy) of a traction over the bound that is cut to (x, y): it may turn, not grow.
inline void cut_derivative(const Group& g, Pack share, Pack x, Pack y, Pack& dx, Pack& dy) {
  const Mask cut = g.strong & (share < 1.0);
  const Pack along = x * dx + y * dy;
  dx = select(cut, share * (dx - x * along), dx);
  dy = select(cut, share * (dy - y * along), dy);
}

/// Traction over bound.
struct StickCell {
  Pack x, y;
};

/// Adds a cell of the first stick zone; returns the traction if it is wanted. With `entering`, only some
/// strips are still in it.
template <bool entering, bool sensitivities, class Changes, std::int32_t count>
WRC_IN_LOOP StickCell stick(const Group& g, const Cell& cell, Mask moving, const StickShape& shape,
                            bool wanted, StickSums& sums, Sums& strong, Changes (&derivative)[count]) {
  const Pack one = 1.0, zero = 0.0;
  // Sums of s times bound, of which the forces are made at the end (add_stick), without the cut.
  const Pack s = shape.s, mean = entering ? select(moving, zero, Pack(cell.mean)) : Pack(cell.mean);
  const Pack straight = mean * s;
  sums.mean += mean;
  sums.t_mean += cell.t * mean;
  sums.straight += straight;
  sums.t_straight += cell.t * straight;
  if constexpr (sensitivities) {
    const Pack slope = mean * shape.by_end, of_form = mean * shape.by_form;
    sums.slope += slope;
    sums.t_slope += cell.t * slope;
    sums.form += of_form;
    sums.t_form += cell.t * of_form;
  }
  if (!wanted && !g.any_strong) return {};

  // The traction itself: for fields, and where |psi| > 1 for the part beyond the bound, whose forces come
  // off.
  const Pack x = g.kappa * (one - s), y = g.lambda * (one - s) + g.psi * s;
  if (!g.any_strong) return {x, y};
  const Pack share = share_within_bound(g, s, x, y), less = mean * (share - one);
  strong.force.stick_px += less * x;
  strong.force.stick_py += less * y;
  strong.force.stick_t_py += cell.t * (less * y);
  if constexpr (sensitivities) {
    for (std::int32_t k = 0; k < count; ++k) {
      Changes& d = derivative[k];
      const Pack ds = shape.by_end * d.slip_end + shape.by_form * d.form;
      const Pack dx = d.kappa * (one - s) - g.kappa * ds;
      const Pack dy = d.lambda * (one - s) + d.psi * s + (g.psi - g.lambda) * ds;
      Pack cut_x = dx, cut_y = dy;
      cut_derivative(g, share, share * x, share * y, cut_x, cut_y);
      d.force.stick_px += mean * (cut_x - dx);
      d.force.stick_py += mean * (cut_y - dy);
      d.force.stick_t_py += cell.t * (mean * (cut_y - dy));
    }
  }
  return {share * x, share * y};
}

/// The first stick zone's share of a group's sums, from the sums over s.
inline void add_stick(const Group& g, const StickSums& s, Sums& sums) {
  // sums of rho = (kappa, lambda) (1 - s) + (0, psi) s times bound
  const Pack bent = s.mean - s.straight, t_bent = s.t_mean - s.t_straight;
  sums.force.stick_px += g.kappa * bent;
  sums.force.stick_py += g.lambda * bent + g.psi * s.straight;
  sums.force.stick_t_py += g.lambda * t_bent + g.psi * s.t_straight;
}

template <class Changes>
inline void add_stick_derivative(const Group& g, const StickSums& s, Changes& d) {
  const Pack bent = s.mean - s.straight, t_bent = s.t_mean - s.t_straight;
  // change of the sum of s times bound, and the same times t
  const Pack change = d.slip_end * s.slope + d.form * s.form;
  const Pack t_change = d.slip_end * s.t_slope + d.form * s.t_form;
  d.force.stick_px += d.kappa * bent - g.kappa * change;
  d.force.stick_py += d.lambda * bent + d.psi * s.straight + (g.psi - g.lambda) * change;
  d.force.stick_t_py += d.lambda * t_bent + d.psi * s.t_straight + (g.psi - g.lambda) * t_change;
}

}  // namespace strip

}  // namespace
}  // namespace wrc::simd
