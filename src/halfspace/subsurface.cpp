#include "halfspace/subsurface.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "base/golden_section.hpp"

namespace wrc::halfspace {
namespace {

/// Cells beyond the border of a grid where stresses are looked for too: the tension behind the trailing edge.
int margin_of(const Grid& grid) { return 2 + std::max(grid.nx, grid.ny) / 10; }

Grid with_margin(const Grid& grid) {
  const int margin = margin_of(grid);
  return {.nx = grid.nx + 2 * margin,
          .ny = grid.ny + 2 * margin,
          .dx = grid.dx,
          .dy = grid.dy,
          .x0 = grid.x0 - margin * grid.dx,
          .y0 = grid.y0 - margin * grid.dy};
}

}  // namespace

damage::Stress stress_at(const BodyLoads& loads, double x, double y, double z) {
  damage::Stress sum;
  const Grid& grid = loads.grid;
  for (int j = 0; j < grid.ny; ++j) {
    for (int i = 0; i < grid.nx; ++i) {
      // closed forms of a uniformly loaded rectangle, times the cell's three loads
      const std::size_t k = grid.index(i, j);
      if (loads.pressure[k] == 0.0 && loads.traction_x[k] == 0.0 && loads.traction_y[k] == 0.0) continue;
      const damage::CellStress unit =
          damage::cell_stress(loads.poisson, x - grid.x(i), y - grid.y(j), z, grid.dx, grid.dy);
      damage::add(unit.of_pressure, loads.pressure[k], sum);
      damage::add(unit.of_traction_x, loads.traction_x[k], sum);
      damage::add(unit.of_traction_y, loads.traction_y[k], sum);
    }
  }
  return sum;
}

StressField::StressField(const BodyLoads& loads)
    : poisson_(loads.poisson),
      grid_(with_margin(loads.grid)),
      padded_x_(Fft::good_length(2 * grid_.nx - 1)),
      padded_y_(Fft::good_length(2 * grid_.ny - 1)),
      fft_x_(padded_x_),
      fft_y_(padded_y_) {
  // transforms long enough that images of a load do not reach the cells
  const auto nx = static_cast<std::size_t>(padded_x_), ny = static_cast<std::size_t>(padded_y_);
  for (Field* each : {&kernel_re_, &kernel_im_, &work_re_, &work_im_}) each->assign(nx * ny, 0.0);
  const Field* const fields[3] = {&loads.pressure, &loads.traction_x, &loads.traction_y};
  const auto margin = static_cast<std::size_t>(margin_of(loads.grid));
  const auto columns = static_cast<std::size_t>(loads.grid.nx);
  // loads within the margin, padded with zeros; their spectra serve all depths
  for (int f = 0; f < 3; ++f) {
    load_re_[f].assign(nx * ny, 0.0);
    load_im_[f].assign(nx * ny, 0.0);
    for (std::size_t k = 0; k < fields[f]->size(); ++k)
      load_re_[f][(margin + k % columns) * ny + margin + k / columns] = (*fields[f])[k];
    transform(load_re_[f], load_im_[f]);
    re_[f].assign(nx * ny, 0.0);
    im_[f].assign(nx * ny, 0.0);
  }
}

void StressField::transform(Field& re, Field& im) {
  const auto nx = static_cast<std::size_t>(padded_x_), ny = static_cast<std::size_t>(padded_y_);
  // along x, turned round, along y: the spectrum lies with y slow
  fft_x_.forward(re.data(), im.data(), work_re_.data(), work_im_.data(), padded_y_);
  transpose(re.data(), work_re_.data(), padded_x_, padded_y_);
  transpose(im.data(), work_im_.data(), padded_x_, padded_y_);
  std::swap(re, work_re_);
  std::swap(im, work_im_);
  fft_y_.forward(re.data(), im.data(), work_re_.data(), work_im_.data(), padded_x_);
  // the inverse's factor 1 / (nx ny), a root of it each for loads and kernel
  const double scale = 1.0 / std::sqrt(static_cast<double>(nx * ny));
  for (std::size_t k = 0; k < nx * ny; ++k) {
    re[k] *= scale;
    im[k] *= scale;
  }
}

void StressField::evaluate(double z) {
  const int reach_x = grid_.nx - 1, reach_y = grid_.ny - 1;
  const auto ny = static_cast<std::size_t>(padded_y_);
  const int corners_y = 2 * reach_y + 2;
  // Cells by their corners, two rows of them at a time: f(x1, y1) - f(x1, y0) - f(x0, y1) + f(x0, y0).
  std::vector<damage::CellStress> cells(static_cast<std::size_t>(2 * reach_x + 1) *
                                        static_cast<std::size_t>(2 * reach_y + 1));
  std::vector<damage::CellStress> before(static_cast<std::size_t>(corners_y)), here(before.size());
  for (int mx = -reach_x; mx <= reach_x + 1; ++mx) {
    for (int c = 0; c < corners_y; ++c)
      here[static_cast<std::size_t>(c)] =
          damage::corner_stress(poisson_, (mx - 0.5) * grid_.dx, (c - reach_y - 0.5) * grid_.dy, z);
    if (mx > -reach_x) {
      for (int my = -reach_y; my <= reach_y; ++my) {
        const int column = my + reach_y;
        const auto c = static_cast<std::size_t>(column);
        damage::CellStress& cell =
            cells[static_cast<std::size_t>(mx - 1 + reach_x) * static_cast<std::size_t>(2 * reach_y + 1) + c];
        damage::add(here[c + 1], 1.0, cell);
        damage::add(here[c], -1.0, cell);
        damage::add(before[c + 1], -1.0, cell);
        damage::add(before[c], 1.0, cell);
      }
    }
    std::swap(here, before);
  }
  // two components of stress travel as real and imaginary part of one transform
  struct Pair {
    double damage::Stress::*real;
    double damage::Stress::*imaginary;
  };
  constexpr Pair pairs[3] = {{&damage::Stress::xx, &damage::Stress::yy},
                             {&damage::Stress::zz, &damage::Stress::xy},
                             {&damage::Stress::yz, &damage::Stress::zx}};
  constexpr damage::Stress damage::CellStress::*units[3] = {&damage::CellStress::of_pressure,
                                                            &damage::CellStress::of_traction_x,
                                                            &damage::CellStress::of_traction_y};
  for (int pair = 0; pair < 3; ++pair) {
    std::fill(re_[pair].begin(), re_[pair].end(), 0.0);
    std::fill(im_[pair].begin(), im_[pair].end(), 0.0);
    // sum over the loads of kernel * load: as the loads are real, products of spectra keep the pair apart
    for (int f = 0; f < 3; ++f) {
      std::fill(kernel_re_.begin(), kernel_re_.end(), 0.0);
      std::fill(kernel_im_.begin(), kernel_im_.end(), 0.0);
      // offset (mx, my) of a cell from its load, wrapped round to 0 .. padded - 1
      std::size_t cell = 0;
      for (int mx = -reach_x; mx <= reach_x; ++mx) {
        const auto row = static_cast<std::size_t>((mx + padded_x_) % padded_x_) * ny;
        for (int my = -reach_y; my <= reach_y; ++my, ++cell) {
          const std::size_t k = row + static_cast<std::size_t>((my + padded_y_) % padded_y_);
          const damage::Stress& unit = cells[cell].*units[f];
          kernel_re_[k] = unit.*pairs[pair].real;
          kernel_im_[k] = unit.*pairs[pair].imaginary;
        }
      }
      transform(kernel_re_, kernel_im_);
      for (std::size_t k = 0; k < kernel_re_.size(); ++k) {
        re_[pair][k] += kernel_re_[k] * load_re_[f][k] - kernel_im_[k] * load_im_[f][k];
        im_[pair][k] += kernel_re_[k] * load_im_[f][k] + kernel_im_[k] * load_re_[f][k];
      }
    }
    backward_2d(fft_x_, fft_y_, padded_y_, {re_[pair], im_[pair], work_re_, work_im_});
  }
}

damage::Stress StressField::at(std::size_t cell) const {
  const auto columns = static_cast<std::size_t>(grid_.nx);
  // x slow, as backward_2d() leaves it
  const std::size_t k = cell % columns * static_cast<std::size_t>(padded_y_) + cell / columns;
  return {re_[0][k], im_[0][k], re_[1][k], im_[1][k], re_[2][k], im_[2][k]};
}

damage::StressPeaks StressField::peaks(double z) {
  // numbers that are compared with limits (von Mises, shear, tension) of every cell
  evaluate(z);
  damage::StressPeaks found;
  for (int j = 0; j < grid_.ny; ++j) {
    for (int i = 0; i < grid_.nx; ++i)
      found.take(damage::numbers_of(at(grid_.index(i, j))), grid_.x(i), grid_.y(j), z);
  }
  return found;
}

SubsurfaceSolution search_stresses(const BodyLoads& loads, const std::vector<double>& depths,
                                   const ProgressCallback& progress) {
  SubsurfaceSolution solution;
  const Grid& grid = loads.grid;
  // extent of the loaded cells; half of its smaller side is the depths' measure
  int first_i = grid.nx, last_i = -1, first_j = grid.ny, last_j = -1;
  for (int j = 0; j < grid.ny; ++j) {
    for (int i = 0; i < grid.nx; ++i) {
      const std::size_t k = grid.index(i, j);
      if (loads.pressure[k] == 0.0 && loads.traction_x[k] == 0.0 && loads.traction_y[k] == 0.0) continue;
      first_i = std::min(first_i, i);
      last_i = std::max(last_i, i);
      first_j = std::min(first_j, j);
      last_j = std::max(last_j, j);
    }
  }
  if (last_i < 0) {
    solution.fault = Fault::no_contact();
    solution.levels.resize(depths.size());
    return solution;
  }
  // eleven depths in shares of that, closer together where von Mises stress of a rolling contact peaks
  const double size = 0.5 * std::min((last_i - first_i + 1) * grid.dx, (last_j - first_j + 1) * grid.dy);
  constexpr double shares[] = {0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.75, 0.95, 1.2, 1.5};
  constexpr int coarse = static_cast<int>(std::size(shares)), refined = 10;
  // progress by depths: the surface, eleven coarse ones, three golden sections, the caller's
  const double work =
      static_cast<double>(1 + coarse + 3 * (refined + 1)) + static_cast<double>(depths.size());
  double done = 0.0;
  const auto goes_on = [&] {
    done += 1.0;
    if (progress.goes_on(std::min(1.0, done / work))) return true;
    solution.fault = Fault::cancelled();
    return false;
  };

  // stress at the surface, and on the coarse depths below
  StressField field(loads);
  solution.surface = field.peaks(0.0);
  if (!goes_on()) return solution;
  damage::StressPeaks at_depth[coarse];
  for (int k = 0; k < coarse; ++k) {
    at_depth[k] = field.peaks(shares[k] * size);
    solution.below.take(at_depth[k]);
    if (!goes_on()) return solution;
  }
  for (damage::StressPeak damage::StressPeaks::*which :
       {&damage::StressPeaks::von_mises, &damage::StressPeaks::shear, &damage::StressPeaks::tension}) {
    // golden sections between the neighbours of the coarse depth with the largest value
    int best = 0;
    for (int k = 1; k < coarse; ++k)
      if ((at_depth[k].*which).value > (at_depth[best].*which).value) best = k;
    double low = best > 0 ? shares[best - 1] * size : 0.0;
    double high = shares[std::min(best + 1, coarse - 1)] * size;
    const auto at = [&](double z) {
      const damage::StressPeaks found = field.peaks(z);
      solution.below.take(found);
      return (found.*which).value;
    };
    if (!narrow_to_largest(low, high, refined, at, goes_on)) return solution;
  }
  for (const double depth : depths) {
    solution.levels.push_back(field.peaks(depth));
    if (!goes_on()) return solution;
  }
  return solution;
}

}  // namespace wrc::halfspace
