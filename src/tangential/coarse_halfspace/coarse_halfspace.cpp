#include "tangential/coarse_halfspace/coarse_halfspace.hpp"

#include <algorithm>
#include <cmath>
#include <new>

#include "tangential/coarse_halfspace/coarse_rolling.hpp"

namespace wrc {
namespace {

constexpr int fine_cells = 16, coarse_cells = 8;

struct Work {
  CoarseRolling<fine_cells> fine;
  CoarseRolling<coarse_cells> coarse;
};

/// Box around the strips.
struct Box {
  double x0 = 0.0, x1 = 0.0, y0 = 0.0, y1 = 0.0;
};

Box box_around(const Strips& strips) {
  Box box{strips.centre[0], strips.centre[0], strips.y[0], strips.y[0]};
  for (std::int32_t j = 0; j < strips.count; ++j) {
    box.x0 = std::min(box.x0, strips.centre[j] - strips.half_length[j]);
    box.x1 = std::max(box.x1, strips.centre[j] + strips.half_length[j]);
    box.y0 = std::min(box.y0, strips.y[j] - 0.5 * strips.width[j]);
    box.y1 = std::max(box.y1, strips.y[j] + 0.5 * strips.width[j]);
  }
  return box;
}

template <int n>
void lay_over(const Box& box, CoarseGrid<n>& grid) {
  grid.dx = (box.x1 - box.x0) / n;
  grid.dy = (box.y1 - box.y0) / n;
  grid.first_x = box.x0 + 0.5 * grid.dx;
  grid.first_y = box.y0 + 0.5 * grid.dy;
}

/// Mean traction bound of every cell, from the strips' loads: each strip's cells (march grid) are dealt out
/// to the columns they overlap, the strip to the rows it overlaps, so that mu N is kept. A cell of which only
/// the share c is in contact gives way more to the same force, by 1 / sqrt(c) as the contact's own size: its
/// own coefficient is raised by that.
template <int n>
void deal_out(const RollingContact& contact, CoarseRolling<n>& rolling) {
  const CoarseGrid<n>& grid = rolling.grid;
  double* const bound = rolling.bound;
  std::fill_n(bound, n * n, 0.0);
  double area[n * n] = {};
  const Strips& strips = contact.region;
  const MarchGrid& march = *contact.grid;
  const double left = grid.first_x - 0.5 * grid.dx, low = grid.first_y - 0.5 * grid.dy;
  for (std::int32_t s = 0; s < strips.count; ++s) {
    double columns[n] = {}, covered[n] = {};
    const double length =
        2.0 * strips.half_length[s] / march.cells / grid.dx;  // of a strip's cell, in columns
    double border = (strips.centre[s] + strips.half_length[s] - left) / grid.dx;
    for (std::int32_t c = 0; c < march.cells; ++c) {
      const double front = border, back = border = front - length;
      const int from = std::clamp(static_cast<int>(back), 0, n - 1);
      const int to = std::clamp(static_cast<int>(front), 0, n - 1);
      for (int i = from; i <= to; ++i) {
        const double part = std::min(front, i + 1.0) - std::max(back, static_cast<double>(i));
        columns[i] += std::max(0.0, part) * march.elliptic.mean[c];
        covered[i] += std::max(0.0, part);
      }
    }
    const double bottom = (strips.y[s] - 0.5 * strips.width[s] - low) / grid.dy;
    const double top = bottom + strips.width[s] / grid.dy;
    const int from = std::clamp(static_cast<int>(bottom), 0, n - 1);
    const int to = std::clamp(static_cast<int>(top), 0, n - 1);
    for (int j = from; j <= to; ++j) {
      const double part = std::max(0.0, std::min(top, j + 1.0) - std::max(bottom, static_cast<double>(j)));
      for (int i = 0; i < n; ++i) {
        bound[j * n + i] += contact.friction[s] * strips.peak[s] * part * columns[i];
        area[j * n + i] += part * covered[i];
      }
    }
  }
  const double own = grid.xx[n - 1][n - 1];
  for (int at = 0; at < n * n; ++at) {
    constexpr double sliver = 1e-6;  // what rounding makes of a border that two cells share is no contact
    if (area[at] < sliver) bound[at] = 0.0;
    const double covered = std::clamp(area[at], sliver, 1.0);
    rolling.border_compliance[at] = own * (1.0 / std::sqrt(covered) - 1.0);
  }
}

/// A field of a grid at any point: bilinear between the cells in contact.
struct Sample {
  double x = 0.0, y = 0.0;  ///< traction's share of the bound
  double slip = 0.0;        ///< magnitude [-]
};

/// The four cells around a point along one axis: lower of the two, and weight of the upper.
struct Between {
  int lower = 0;
  double upper_weight = 0.0;
};

template <int n>
Between between(double position) {
  const double clipped = std::clamp(position, 0.0, n - 1.0);
  const int lower = std::min(static_cast<int>(clipped), n - 2);
  return {lower, clipped - lower};
}

/// Shares and slips of the cells in contact, so that sampling is a weighted mean.
template <int n>
struct Shares {
  double weight[n * n];  ///< 1 in contact, 0 outside
  Sample cell[n * n];
};

template <int n>
void find_shares(const CoarseRolling<n>& rolling, Shares<n>& shares) {
  for (int at = 0; at < n * n; ++at) {
    shares.weight[at] = 0.0;
    shares.cell[at] = {};
    if (rolling.bound[at] <= 0.0) continue;
    const double sx = rolling.sx[at], sy = rolling.sy[at];
    shares.weight[at] = 1.0;
    shares.cell[at] = {rolling.px[at] / rolling.bound[at], rolling.py[at] / rolling.bound[at],
                       rolling.state[at] == CellState::slip ? std::sqrt(sx * sx + sy * sy) : 0.0};
  }
}

template <int n>
Sample sample(const Shares<n>& shares, const Between& along, const Between& across) {
  Sample sum;
  double total = 0.0;
  for (int dj = 0; dj < 2; ++dj) {
    for (int di = 0; di < 2; ++di) {
      const int at = (across.lower + dj) * n + along.lower + di;
      const double w = shares.weight[at] * (di == 1 ? along.upper_weight : 1.0 - along.upper_weight) *
                       (dj == 1 ? across.upper_weight : 1.0 - across.upper_weight);
      sum.x += w * shares.cell[at].x;
      sum.y += w * shares.cell[at].y;
      sum.slip += w * shares.cell[at].slip;
      total += w;
    }
  }
  const double inverse = total > 0.0 ? 1.0 / total : 0.0;
  return {sum.x * inverse, sum.y * inverse, sum.slip * inverse};
}

/// Tractions and slip on the cells of the strips, from the samples of both grids; the power they make [N].
/// Some cell of the grids slips if `slips`; a few strips and cells may miss all of those, so the trailing
/// edges, where slip begins, keep a trace for the power of the forces to be spent in.
template <int m, int n>
double write_fields(const RollingContact& contact, const CoarseGrid<m>& coarse,
                    const Shares<m>& coarse_shares, const CoarseGrid<n>& fine, const Shares<n>& fine_shares,
                    bool slips, const TangentialFields& fields) {
  const Strips& strips = contact.region;
  const MarchGrid& march = *contact.grid;
  const Creepage& creep = contact.creepage;
  double total = 0.0;
  for (std::int32_t s = 0; s < strips.count; ++s) {
    const double y = strips.y[s], l = strips.half_length[s];
    const Between across_coarse = between<m>((y - coarse.first_y) / coarse.dy);
    const Between across_fine = between<n>((y - fine.first_y) / fine.dy);
    double power = 0.0;
    for (std::int32_t c = 0; c < march.cells; ++c) {
      const double x = strips.centre[s] + l * (1.0 - (2.0 * c + 1.0) / march.cells);
      // tractions of a grid's cell belong a quarter of a cell behind its middle
      const Sample low =
          sample(coarse_shares, between<m>((x - coarse.first_x) / coarse.dx + 0.25), across_coarse);
      Sample high = sample(fine_shares, between<n>((x - fine.first_x) / fine.dx + 0.25), across_fine);
      if (slips && c == march.cells - 1) {
        const double rigid =
            std::fabs(creep.longitudinal - creep.spin * y) + std::fabs(creep.lateral + creep.spin * x);
        high.slip = std::max(high.slip, 1e-9 * rigid);
      }
      double ex = 2.0 * high.x - low.x, ey = 2.0 * high.y - low.y;
      const double size = std::sqrt(ex * ex + ey * ey);
      const double cut = size > 1.0 ? 1.0 / size : 1.0;
      ex *= cut;
      ey *= cut;
      const double bound = contact.friction[s] * strips.peak[s] * march.elliptic.mean[c];
      const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(c) * strips.count + s;
      if (fields.traction_x) fields.traction_x[at] = bound * ex;
      if (fields.traction_y) fields.traction_y[at] = bound * ey;
      if (fields.slip_x) fields.slip_x[at] = -high.slip * ex;
      if (fields.slip_y) fields.slip_y[at] = -high.slip * ey;
      power += high.slip * bound * (ex * ex + ey * ey);
    }
    total += power * 2.0 * l / march.cells * strips.width[s];
  }
  return total;
}

}  // namespace

std::int64_t coarse_halfspace_workspace() { return static_cast<std::int64_t>(sizeof(Work)); }

TangentialForces coarse_halfspace(const RollingContact& contact, void* workspace,
                                  const TangentialFields& fields, Fault& fault) {
  const Strips& strips = contact.region;
  if (strips.count < 1) return {};
  Work& work = *new (workspace) Work;
  CoarseRolling<coarse_cells>& coarse = work.coarse;
  CoarseRolling<fine_cells>& fine = work.fine;
  const Box box = box_around(strips);
  lay_over(box, coarse.grid);
  lay_over(box, fine.grid);
  const Material material{.shear_modulus = contact.shear_modulus,
                          .poisson = contact.linear_theory->poisson()};
  fill_coefficients(material, coarse.grid);
  fill_coefficients(material, fine.grid);
  deal_out(contact, coarse);
  deal_out(contact, fine);

  constexpr double tolerance = 1e-3;
  constexpr int max_iterations = 30;
  std::fill_n(coarse.px, coarse.cell_count, 0.0);
  std::fill_n(coarse.py, coarse.cell_count, 0.0);
  bool solved = coarse.solve(contact.creepage, tolerance, max_iterations);
  Shares<coarse_cells> coarse_shares;
  find_shares(coarse, coarse_shares);
  for (int j = 0; j < fine_cells; ++j) {
    for (int i = 0; i < fine_cells; ++i) {
      const int at = j * fine_cells + i;
      const Sample start =
          sample(coarse_shares, between<coarse_cells>(0.5 * i - 0.25), between<coarse_cells>(0.5 * j - 0.25));
      fine.px[at] = start.x * fine.bound[at];
      fine.py[at] = start.y * fine.bound[at];
    }
  }
  solved = fine.solve(contact.creepage, tolerance, max_iterations) && solved;
  if (!solved)
    keep_worst(fault,
               {.status = WRC_FLAG_ITERATION_CAP,
                .field = "iterations of COARSE_HALFSPACE",
                .value = max_iterations,
                .unit = "",
                .cause = "cells at the border keep changing between adhesion and slip: forces are usable"});
  Shares<fine_cells> fine_shares;
  find_shares(fine, fine_shares);

  const TangentialForces low = coarse.forces(contact.creepage), high = fine.forces(contact.creepage);
  TangentialForces f{.fx = 2.0 * high.fx - low.fx,
                     .fy = 2.0 * high.fy - low.fy,
                     .mz = 2.0 * high.mz - low.mz,
                     .adhesion_fraction = high.adhesion_fraction};
  const double limit = contact.friction.mean * totals(strips).normal_force;
  const double size = std::sqrt(f.fx * f.fx + f.fy * f.fy);
  if (size > limit) {
    f.fx *= limit / size;
    f.fy *= limit / size;
  }
  const double local_power = write_fields(contact, coarse.grid, coarse_shares, fine.grid, fine_shares,
                                          high.adhesion_fraction < 1.0, fields);
  const Creepage& creep = contact.creepage;
  f.power_per_speed = std::max(0.0, -(f.fx * creep.longitudinal + f.fy * creep.lateral + f.mz * creep.spin));
  const double scale = local_power > 0.0 ? f.power_per_speed / local_power : 0.0;
  const std::ptrdiff_t values = static_cast<std::ptrdiff_t>(strips.count) * contact.grid->cells;
  for (double* slip : {fields.slip_x, fields.slip_y}) {
    if (slip) std::transform(slip, slip + values, slip, [scale](double v) { return v * scale; });
  }
  return f;
}

}  // namespace wrc
