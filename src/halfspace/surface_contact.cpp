#include "halfspace/surface_contact.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/elementary.hpp"

namespace wrc::halfspace {
namespace {

/// The nearest integer, halves upwards.
double nearest_integer(double x) { return std::floor(x + 0.5); }

constexpr double apart = 1e-2;  // gap of cells without one [m]

// The cells over which contact is possible, and their gaps.
struct Cells {
  Grid grid;
  std::vector<SurfaceRow> rows;
  std::vector<SurfacePoint> points;
  double deepest = 0.0;  // overlap [m]; negative: distance
  bool too_many = false;
};

// Rows at the middles of the lattice's strips. Cells up to `margin` apart are laid as well: what the
// tractions lift may touch.
Cells lay_cells(const RollingSurfaces& surfaces, double rail_length, const SurfaceOptions& options) {
  struct Candidate {
    SurfaceRow row;
    SurfacePoint middle;
    bool found = false;
  };
  const int lattice = static_cast<int>(rail_length / options.cell_s);
  std::vector<Candidate> candidates(static_cast<std::size_t>(lattice));
  Cells cells;
  cells.deepest = -apart;
  for (int j = 0; j < lattice; ++j) {
    Candidate& c = candidates[j];
    c.row = surfaces.row((j + 0.5) * options.cell_s, options.normals, c.found);
    if (!c.found) continue;
    c.middle = surfaces.point(c.row, c.row.middle);
    c.found = c.middle.found;
    if (c.found) cells.deepest = std::max(cells.deepest, -c.middle.gap);
  }
  if (cells.deepest <= 0.0) return cells;
  const double margin = 0.05 * cells.deepest;
  constexpr int border = 2;
  constexpr double farthest = 0.1;  // from a row's middle along x [m]
  int first = lattice, last = -1;
  for (int j = 0; j < lattice; ++j) {
    if (!candidates[j].found || candidates[j].middle.gap > margin) continue;
    first = std::min(first, j);
    last = j;
  }
  double low = 1.0, high = -1.0;
  for (int j = first; j <= last && !cells.too_many; ++j) {
    const Candidate& c = candidates[j];
    if (!c.found || c.middle.gap > margin) continue;
    for (const double direction : {-1.0, 1.0}) {
      SurfacePoint p = c.middle;
      double x = c.row.middle;
      while (p.found && p.gap < margin && std::abs(x - c.row.middle) < farthest) {
        x += direction * options.cell_x;
        p = surfaces.point(c.row, x, p.wheel_s);
      }
      low = std::min(low, x);
      high = std::max(high, x);
    }
    cells.too_many =
        (high - low) / options.cell_x * (last - first + 1) > static_cast<double>(options.max_cells);
  }
  first = std::max(first - border, 0);
  last = std::min(last + border, lattice - 1);
  const int left = static_cast<int>(std::floor(low / options.cell_x)) - border;
  const int right = static_cast<int>(-std::floor(-high / options.cell_x)) + border;
  cells.grid = {.nx = right - left + 1,
                .ny = last - first + 1,
                .dx = options.cell_x,
                .dy = options.cell_s,
                .x0 = left * options.cell_x,
                .y0 = (first + 0.5) * options.cell_s};
  if (cells.too_many) return cells;
  cells.points.resize(cells.grid.cells());
  for (int j = 0; j < cells.grid.ny; ++j) {
    const Candidate& c = candidates[first + j];
    cells.rows.push_back(c.row);
    if (!c.found) continue;
    const int middle =
        std::clamp(static_cast<int>(nearest_integer((c.row.middle - cells.grid.x0) / cells.grid.dx)), 0,
                   cells.grid.nx - 1);
    for (const int direction : {1, -1}) {
      SurfacePoint p = c.middle;
      for (int i = middle; i >= 0 && i < cells.grid.nx && p.found; i += direction) {
        p = surfaces.point(c.row, cells.grid.x(i), p.wheel_s);
        cells.points[cells.grid.index(i, j)] = p;
      }
    }
  }
  return cells;
}

StripSlip slip_at(const std::vector<StripSlip>& slips, double s) {
  const auto above =
      std::lower_bound(slips.begin(), slips.end(), s, [](const StripSlip& a, double at) { return a.s < at; });
  if (above == slips.begin()) return slips.front();
  if (above == slips.end()) return slips.back();
  const StripSlip &a = *(above - 1), &b = *above;
  const double t = (s - a.s) / (b.s - a.s);
  const auto between = [&](double from, double to) { return from + t * (to - from); };
  return {s, between(a.x, b.x), between(a.lateral, b.lateral), between(a.spin, b.spin),
          between(a.middle, b.middle)};
}

// Height of a wheel whose largest radius is level with the top of its rail.
double highest_start(const WheelAndRail& bodies, const RailMotion& rail) {
  constexpr double spacing = 1e-3;
  double lowest = 0.0, top = 0.0;
  const auto on_wheel = static_cast<int>(bodies.wheel.length() / spacing);
  for (int k = 0; k <= on_wheel; ++k) lowest = std::max(lowest, bodies.wheel.at(spacing * k).z);
  const auto on_rail = static_cast<int>(bodies.rail.length() / spacing);
  for (int k = 0; k <= on_rail; ++k) {
    const SectionCurve::Point p = bodies.rail.at(spacing * k);
    const double z = std::sin(rail.roll) * p.y + std::cos(rail.roll) * p.z;
    top = k == 0 ? z : std::min(top, z);
  }
  return bodies.rail_z + rail.z + top - bodies.nominal_radius - lowest;
}

double rolling_speed(const SurfaceProblem& problem) {
  const double v = problem.state.wheel.velocity[0];
  return !problem.slips.empty() && v == 0.0 ? 1.0 : v;
}

// Rigid slip of all cells, where the collocation wants it.
void fill_rigid_slip(const RollingSurfaces& surfaces, const SurfaceProblem& problem, const Cells& cells,
                     double ahead, RollingProblem& rolling) {
  const Grid& g = cells.grid;
  rolling.rigid_slip_x.assign(g.cells(), 0.0);
  rolling.rigid_slip_y.assign(g.cells(), 0.0);
  const double v = rolling_speed(problem);
  for (int j = 0; j < g.ny; ++j) {
    const bool given = !problem.slips.empty();
    const StripSlip slip = given ? slip_at(problem.slips, g.y(j)) : StripSlip{};
    for (int i = 0; i < g.nx; ++i) {
      const std::size_t at = g.index(i, j);
      if (!cells.points[at].found) continue;
      const double x = g.x(i) + ahead;
      double &wx = rolling.rigid_slip_x[at], &wy = rolling.rigid_slip_y[at];
      if (given) {
        wx = slip.x;
        wy = slip.lateral + slip.spin * (x - slip.middle);
      } else {
        surfaces.sliding(cells.rows[j], x, surfaces.point(cells.rows[j], x, cells.points[at].wheel_s), wx,
                         wy);
        wx /= v;
        wy /= v;
      }
    }
  }
}

// A field of one piece of the lattice on another; zero where they do not overlap.
Field moved(const Grid& from, const Field& field, const Grid& to) {
  Field out(to.cells(), 0.0);
  const int di = static_cast<int>(nearest_integer((to.x0 - from.x0) / from.dx));
  const int dj = static_cast<int>(nearest_integer((to.y0 - from.y0) / from.dy));
  for (int j = std::max(0, -dj); j < to.ny && j + dj < from.ny; ++j) {
    for (int i = std::max(0, -di); i < to.nx && i + di < from.nx; ++i) {
      out[to.index(i, j)] = field[from.index(i + di, j + dj)];
    }
  }
  return out;
}

// Force, moment and sums over the rows from the fields.
void sum_up(const SurfaceProblem& problem, const Cells& cells, const RollingProblem& rolling,
            SurfaceSolution& s) {
  const Grid& g = s.grid;
  const double behind = traction_behind(rolling.collocation) * g.dx;
  const double ahead = rigid_slip_ahead(rolling.collocation) * g.dx;
  const double v = rolling_speed(problem);
  const bool rolls = !rolling.rigid_slip_x.empty();
  const WheelMotion& wheel = problem.state.wheel;
  for (int k = 0; k < 3; ++k) s.force[k] = s.moment[k] = 0.0;
  s.pressure_sum = s.area = s.peak_pressure = s.power = s.power_cells = 0.0;
  s.row_forces.clear();
  for (int j = 0; j < g.ny; ++j) {
    const SurfaceRow& place = s.rows[j];
    const double c = std::cos(place.angle), sn = std::sin(place.angle);
    RowForces row{.s = g.y(j), .y = place.y, .z = place.z, .angle = place.angle};
    double slip_moment = 0.0, inertia = 0.0;
    for (int i = 0; i < g.nx; ++i) {
      const std::size_t at = g.index(i, j);
      const double p = s.pressure[at];
      if (p <= 0.0) continue;
      const double px = s.traction_x[at], py = s.traction_y[at];
      row.normal_force += p * g.dx;
      row.middle += g.x(i) * p * g.dx;
      row.fx += px * g.dx;
      row.fy += py * g.dx;
      row.spin_moment += (g.x(i) - behind) * py * g.dx;
      row.length += g.dx;
      row.peak_pressure = std::max(row.peak_pressure, p);
      // The force acts halfway between the undeformed surfaces.
      const double half = 0.5 * cells.points[at].gap, area = g.cell_area();
      const double fx = px * area, fy = (py * c + p * sn) * area, fz = (py * sn - p * c) * area;
      const double y = place.y + half * sn - wheel.position[1], z = place.z - half * c - s.height;
      const double x_p = g.x(i), x_t = g.x(i) - behind;
      const double moment_x = y * fz - z * fy;
      const double moment_y = z * fx - (x_t * py * sn - x_p * p * c) * area;
      const double moment_z = (x_t * py * c + x_p * p * sn) * area - y * fx;
      s.force[0] += fx;
      s.force[1] += fy;
      s.force[2] += fz;
      s.moment[0] += moment_x;
      s.moment[1] += moment_y;
      s.moment[2] += moment_z;
      if (!rolls) continue;
      row.power -= (px * rolling.rigid_slip_x[at] + py * rolling.rigid_slip_y[at]) * v * g.dx;
      s.power_cells -= (px * s.slip_x[at] + py * s.slip_y[at]) * v * area;
    }
    if (row.normal_force <= 0.0) continue;
    row.middle /= row.normal_force;
    row.spin_moment -= row.middle * row.fy;
    if (rolls) {
      double weight = 0.0;
      for (int i = 0; i < g.nx; ++i) {
        const std::size_t at = g.index(i, j);
        if (s.pressure[at] <= 0.0) continue;
        const double x = g.x(i) + ahead - row.middle;
        weight += 1.0;
        row.slip_x += rolling.rigid_slip_x[at];
        row.slip_y += rolling.rigid_slip_y[at];
        slip_moment += x * rolling.rigid_slip_y[at];
        inertia += x * x;
      }
      row.slip_x /= weight;
      row.slip_y /= weight;
      const double centre = row.middle;
      double mean_x = 0.0;
      for (int i = 0; i < g.nx; ++i) {
        if (s.pressure[g.index(i, j)] > 0.0) mean_x += (g.x(i) + ahead - centre) / weight;
      }
      const double spread = inertia - weight * mean_x * mean_x;
      if (spread > 0.0) row.spin = (slip_moment - weight * mean_x * row.slip_y) / spread;
      row.slip_y -= row.spin * mean_x;
    }
    s.pressure_sum += row.normal_force * g.dy;
    s.area += row.length * g.dy;
    s.peak_pressure = std::max(s.peak_pressure, row.peak_pressure);
    s.power += row.power * g.dy;
    s.row_forces.push_back(row);
  }
}

Fault check(const SurfaceProblem& problem, const SurfaceOptions& options) {
  const WheelOnRail& state = problem.state;
  double sum = state.vertical_load + state.friction + state.rail.y + state.rail.z + state.rail.roll +
               state.rail.velocity_y + state.rail.velocity_z + state.rail.velocity_roll;
  for (int k = 0; k < 3; ++k) {
    sum += state.wheel.position[k] + state.wheel.velocity[k] + state.wheel.angular_velocity[k];
    for (const double r : state.wheel.rotation[k]) sum += r;
  }
  for (const StripSlip& slip : problem.slips) sum += slip.s + slip.x + slip.lateral + slip.spin + slip.middle;
  if (!std::isfinite(sum)) return {.status = WRC_ERROR_NOT_FINITE, .field = "state"};
  if (!(options.cell_x > 0.0 && options.cell_s > 0.0)) {
    return {.status = WRC_ERROR_RANGE, .field = "options.cell_x", .value = options.cell_x, .unit = "m"};
  }
  if (!(state.friction >= 0.0)) {
    return {.status = WRC_ERROR_RANGE, .field = "friction.coefficient", .value = state.friction};
  }
  if (state.load_prescribed && !(state.vertical_load > 0.0)) {
    return {
        .status = WRC_ERROR_LOAD, .field = "input.vertical_load", .value = state.vertical_load, .unit = "N"};
  }
  if (state.friction > 0.0 && !(rolling_speed(problem) > 0.0)) {
    return {.status = WRC_ERROR_RANGE,
            .field = "wheel.velocity[0]",
            .value = state.wheel.velocity[0],
            .unit = "m/s",
            .cause = "steady rolling goes forwards"};
  }
  return {};
}

}  // namespace

SurfaceContact::SurfaceContact(WheelAndRail bodies, const SurfaceOptions& options)
    : bodies_(std::move(bodies)), options_(options) {}

SurfaceSolution SurfaceContact::at_height(const SurfaceProblem& problem, double height, bool with_friction,
                                          const SurfaceSolution* start) const {
  SurfaceSolution s;
  s.height = height;
  WheelMotion wheel = problem.state.wheel;
  wheel.position[2] = height;
  const RollingSurfaces surfaces(bodies_, wheel, problem.state.rail);
  const Cells cells = lay_cells(surfaces, bodies_.rail.length(), options_);
  s.grid = cells.grid;
  if (cells.too_many) {
    s.grid = {};
    s.fault = {.status = WRC_ERROR_RANGE,
               .field = "cells of the exact solution",
               .value = static_cast<double>(cells.grid.cells()),
               .unit = "",
               .high = static_cast<double>(options_.max_cells),
               .cause = "an overlap of millimetres, or cells too small"};
    return s;
  }
  if (cells.deepest <= 0.0) {
    s.fault = {.status = WRC_FLAG_NO_CONTACT};
    return s;
  }
  s.rows = cells.rows;
  const std::size_t n = s.grid.cells();
  for (Field* field : {&s.traction_x, &s.traction_y, &s.slip_x, &s.slip_y}) field->assign(n, 0.0);
  for (const SurfacePoint& p : cells.points) s.gap.push_back(p.found ? std::min(p.gap, apart) : apart);

  Field angles;
  if (options_.turned) {
    for (const SurfaceRow& row : s.rows) angles.push_back(row.angle);
  }
  NormalSolver normal(s.grid, bodies_.material, angles);
  GapProblem gap;
  gap.gap = s.gap;
  gap.prescribed = Prescribed::approach;
  gap.tolerance = options_.normal_tolerance;
  RollingProblem rolling;
  rolling.friction = {problem.state.friction};
  rolling.collocation = options_.collocation;
  rolling.tolerance = options_.rolling_tolerance;
  if (!with_friction) {
    const GapSolution pressed = normal.solve(gap);
    s.pressure = pressed.pressure;
    s.fault = pressed.fault;
    s.turns = 1;
    sum_up(problem, cells, rolling, s);
    return s;
  }

  RollingSolver roller(s.grid, bodies_.material, angles);
  fill_rigid_slip(surfaces, problem, cells, rigid_slip_ahead(options_.collocation) * s.grid.dx, rolling);
  const Field slip_y = rolling.rigid_slip_y;
  TurnedConvolution lift(s.grid, bodies_.material, Convolution::Kernel::shear, angles);
  TurnedConvolution drag(s.grid, bodies_.material, Convolution::Kernel::normal_slip, angles);
  RollingSolution rolled;
  bool warm = start != nullptr && start->grid.cells() > 0;
  if (warm) {
    rolled.traction_x = moved(start->grid, start->traction_x, s.grid);
    rolled.traction_y = moved(start->grid, start->traction_y, s.grid);
  }
  Field turned(n);
  for (s.turns = 1;; ++s.turns) {
    if (warm) {
      lift.tangential_crossed(rolled.traction_x, rolled.traction_y, turned);
      for (std::size_t k = 0; k < n; ++k) gap.gap[k] = s.gap[k] + turned[k];
    }
    const GapSolution pressed = normal.solve(gap);
    s.fault = pressed.fault;
    s.pressure = pressed.pressure;
    if (pressed.normal_force <= 0.0) break;
    drag.normal_crossed(s.pressure, turned);
    for (std::size_t k = 0; k < n; ++k) rolling.rigid_slip_y[k] = slip_y[k] - turned[k];
    rolling.pressure = s.pressure;
    const RollingSolution before = std::move(rolled);
    rolling.start = warm ? &before : nullptr;
    rolled = roller.solve(rolling);
    keep_worst(s.fault, rolled.fault);
    if (s.fault.failed()) return s;
    s.traction_x = rolled.traction_x;
    s.traction_y = rolled.traction_y;
    s.slip_x = rolled.slip_x;
    s.slip_y = rolled.slip_y;
    s.adhesion_fraction = rolled.forces.adhesion_fraction;
    warm = true;
    const double force_before[3] = {s.force[0], s.force[1], s.force[2]};
    const Field effective = std::exchange(rolling.rigid_slip_y, slip_y);
    sum_up(problem, cells, rolling, s);
    rolling.rigid_slip_y = effective;
    double change = 0.0, size = 0.0;
    for (int k = 0; k < 3; ++k) {
      change += (s.force[k] - force_before[k]) * (s.force[k] - force_before[k]);
      size += s.force[k] * s.force[k];
    }
    if (change <= options_.force_tolerance * options_.force_tolerance * size) break;
    if (!options_.turned) break;  // nothing couples
    if (s.turns == options_.max_turns) {
      keep_worst(
          s.fault,
          {.status = WRC_FLAG_ITERATION_CAP, .field = "surface.turns", .value = std::sqrt(change / size)});
      break;
    }
  }
  return s;
}

// The load grows with the depth below first touch nearly with its power 3/2: secants of load^(2/3) over the
// height, inside of what brackets the load; first without friction, then with it.
SurfaceSolution SurfaceContact::solve(const SurfaceProblem& problem) const {
  SurfaceSolution s;
  s.fault = check(problem, options_);
  if (s.fault.failed()) return s;
  const bool with_friction = problem.state.friction > 0.0;
  if (!problem.state.load_prescribed) {
    return at_height(problem, problem.state.wheel.position[2], with_friction, nullptr);
  }

  // Height of first touch, from the rows' gaps, beginning with the wheel's largest radius above the rail.
  double height = highest_start(bodies_, problem.state.rail);
  for (int k = 0; k < 20; ++k) {
    WheelMotion wheel = problem.state.wheel;
    wheel.position[2] = height;
    const RollingSurfaces surfaces(bodies_, wheel, problem.state.rail);
    double nearest = apart;
    const int rows = static_cast<int>(bodies_.rail.length() / options_.cell_s);
    for (int j = 0; j < rows; ++j) {
      bool found = false;
      const SurfaceRow row = surfaces.row((j + 0.5) * options_.cell_s, options_.normals, found);
      if (!found) continue;
      const SurfacePoint p = surfaces.point(row, row.middle);
      if (p.found) nearest = std::min(nearest, p.gap / std::max(std::cos(row.angle), 0.1));
    }
    height += std::min(nearest, apart);
    if (std::abs(nearest) < 1e-7) break;
  }

  const double load = problem.state.vertical_load;
  const auto straightened = [](double force) {
    return force > 0.0 ? natural_exp(natural_log(force) * (2.0 / 3.0)) : 0.0;
  };
  double low = height, low_force = 0.0, high = 0.0, high_force = -1.0;  // bracket; high_force < 0: none yet
  double slope = 0.0;
  int heights = 0;
  height += 6e-5 * straightened(load / 8e4);
  for (const bool friction : {false, true}) {
    if (friction && !with_friction) break;
    const double tolerance = friction || !with_friction ? options_.load_tolerance : 1e-2;
    if (friction) {  // the creep forces change the load: the bracket is void
      high_force = -1.0;
      low_force = -1.0;
    }
    double before = 0.0, before_force = -1.0;
    for (;; ++heights) {
      const bool warm = s.grid.cells() > 0 && friction && !s.traction_x.empty();
      const SurfaceSolution start = std::move(s);
      s = at_height(problem, height, friction, warm ? &start : nullptr);
      if (s.fault.failed()) break;
      const double force = -s.force[2];
      if (std::abs(force - load) <= tolerance * load) break;
      if (heights == options_.max_heights) {
        keep_worst(
            s.fault,
            {.status = WRC_FLAG_ITERATION_CAP, .field = "input.vertical_load", .value = force, .unit = "N"});
        break;
      }
      if (force < load) {
        low = height;
        low_force = force;
      } else {
        high = height;
        high_force = force;
      }
      if (before_force >= 0.0 && height != before) {
        const double secant = (straightened(force) - straightened(before_force)) / (height - before);
        if (secant > 0.0) slope = secant;
      } else if (slope <= 0.0) {
        slope = straightened(force) / std::max(height - low, 1e-6);
      }
      before = height;
      before_force = std::max(force, 0.0);
      constexpr double longest_step = 2e-4;
      double step = slope > 0.0 ? (straightened(load) - straightened(force)) / slope : longest_step;
      step = std::clamp(step, -longest_step, longest_step);
      double next = height + step;
      if (high_force >= 0.0 && low_force >= 0.0 && !(next > low && next < high)) next = 0.5 * (low + high);
      height = next;
    }
    if (s.fault.failed()) break;
  }
  if (!s.fault.failed() && s.grid.cells() == 0) {
    s.fault = {.status = WRC_ERROR_LOAD,
               .field = "input.vertical_load",
               .value = load,
               .unit = "N",
               .cause = "the wheel meets no rail at this pose, whatever its height"};
  }
  s.heights = heights;
  return s;
}

}  // namespace wrc::halfspace
