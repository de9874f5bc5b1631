#include "halfspace/surface_contact.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/elementary.hpp"
#include "geometry/creepages.hpp"
#include "normal/damping.hpp"
#include "tangential/friction/friction.hpp"

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

// Height of a wheel whose largest radius is level with the top of its rail.
double highest_start(const WheelAndRail& bodies, const RailMotion& rail) {
  constexpr double spacing = 1e-3;
  double lowest = 0.0, top = 0.0;
  const auto on_wheel = static_cast<int>(bodies.wheel.length() / spacing);
  for (int k = 0; k <= on_wheel; ++k) lowest = std::max(lowest, bodies.wheel.at(spacing * k).z);
  if (bodies.out_of_round != nullptr) lowest += bodies.out_of_round->largest;
  const SineCosine rolled = sine_cosine(rail.roll);
  bool first = true;
  for (const RailSurface& face : bodies.rail) {
    const auto on_rail = static_cast<int>(face.section.length() / spacing);
    for (int k = 0; k <= on_rail; ++k) {
      const SectionCurve::Point p = face.section.at(spacing * k);
      const double z = rolled.sine * p.y + rolled.cosine * p.z;
      top = first ? z : std::min(top, z);
      first = false;
    }
  }
  return bodies.rail_z + rail.z + top - bodies.nominal_radius - lowest;
}

// A way of rolling: along x, or backwards, which is along x in the mirror across the axle. The rolling
// problem and its solution are as the mirror shows them; the fields below as they are.
struct Way {
  double direction = 1.0;
  double share = 0.0;  // of the tractions
  Field sliding_x,
      sliding_y;  // rigid velocity of the wheel over the rail where the collocation wants it [m/s]
  RollingProblem problem;
  RollingSolution rolled;
  bool started = false;
  Field traction_x, traction_y;  // [Pa]

  // A field as it is to one as the mirror shows it, or back; `along_x`: components along x, which turn round.
  Field seen(const Grid& g, const Field& field, bool along_x) const {
    if (direction > 0.0) return field;
    Field out(field.size());
    for (int j = 0; j < g.ny; ++j) {
      for (int i = 0; i < g.nx; ++i) {
        const double value = field[g.index(g.nx - 1 - i, j)];
        out[g.index(i, j)] = along_x ? -value : value;
      }
    }
    return out;
  }
};

void find_sliding(const RollingSurfaces& surfaces, const Cells& cells, Collocation collocation, Way& way) {
  const Grid& g = cells.grid;
  const double ahead = way.direction * rigid_slip_ahead(collocation) * g.dx;
  way.sliding_x.assign(g.cells(), 0.0);
  way.sliding_y.assign(g.cells(), 0.0);
  for (int j = 0; j < g.ny; ++j) {
    for (int i = 0; i < g.nx; ++i) {
      const std::size_t at = g.index(i, j);
      if (!cells.points[at].found) continue;
      const double x = g.x(i) + ahead;
      surfaces.sliding(cells.rows[j], x, surfaces.point(cells.rows[j], x, cells.points[at].wheel_s),
                       way.sliding_x[at], way.sliding_y[at]);
    }
  }
}

// Damps the pressure of each row by the speed at which the surfaces near each other at its middle, and
// returns the sum of what is left [N].
double damp(const RollingSurfaces& surfaces, const Cells& cells, double damping, Field& pressure) {
  const Grid& g = cells.grid;
  double sum = 0.0;
  for (int j = 0; j < g.ny; ++j) {
    double row = 0.0, moment = 0.0;
    for (int i = 0; i < g.nx; ++i) {
      row += pressure[g.index(i, j)];
      moment += g.x(i) * pressure[g.index(i, j)];
    }
    if (row <= 0.0) continue;
    const double x = moment / row;
    const int middle = std::clamp(static_cast<int>(nearest_integer((x - g.x0) / g.dx)), 0, g.nx - 1);
    const SurfacePoint at = surfaces.point(cells.rows[j], x, cells.points[g.index(middle, j)].wheel_s);
    const double factor = damping_factor(surfaces.approach(cells.rows[j], x, at), damping);
    for (int i = 0; i < g.nx; ++i) pressure[g.index(i, j)] *= factor;
    sum += factor * row;
  }
  return sum * g.cell_area();
}

// The mean of the speeds at which wheel and rail material pass through the contact, over its pressure [m/s].
double rolling_speed(const WheelOnRail& state, const Cells& cells, const Field& pressure,
                     const Way (&ways)[2]) {
  double passing = 0.0, load = 0.0;
  const Grid& g = cells.grid;
  for (int j = 0; j < g.ny; ++j) {
    const double rail = state.rail.turning * cells.rows[j].radius;  // backwards
    for (int i = 0; i < g.nx; ++i) {
      const std::size_t k = g.index(i, j);
      passing += pressure[k] * (rail - 0.25 * (ways[0].sliding_x[k] + ways[1].sliding_x[k]));
      load += pressure[k];
    }
  }
  return state.wheel.velocity[0] + passing / load;
}

// Coefficients of all cells: of each row over its width on the profile that zones lie on, at the root mean
// square of its cells' rigid sliding velocity.
Field friction_of_rows(const WheelOnRail& state, const SectionCurve& rail, const SectionCurve& wheel,
                       const Cells& cells, const Field& pressure, const Way& way) {
  const Grid& g = cells.grid;
  if (state.law == nullptr) return {state.friction};
  const FrictionLaw& law = *state.law;
  Field friction(g.cells(), 0.0);
  for (int j = 0; j < g.ny; ++j) {
    double squares = 0.0, count = 0.0, on_wheel = 0.0;
    for (int i = 0; i < g.nx; ++i) {
      const std::size_t at = g.index(i, j);
      if (pressure[at] <= 0.0) continue;
      on_wheel += cells.points[at].wheel_s;
      squares += way.sliding_x[at] * way.sliding_x[at] + way.sliding_y[at] * way.sliding_y[at];
      count += 1.0;
    }
    if (count == 0.0) continue;
    double at_rest = law.coefficient;
    if (law.zones.count > 0) {
      const SectionCurve::Point p = state.zones_on_wheel ? wheel.at(on_wheel / count) : rail.at(g.y(j));
      const double half = 0.5 * g.dy * std::abs(p.dy) + 1e-9;
      at_rest = mean_friction(law.zones, p.y - half, p.y + half);
    }
    const double coefficient = at_rest * speed_factor(law, std::sqrt(squares / count));
    for (int i = 0; i < g.nx; ++i) friction[g.index(i, j)] = coefficient;
  }
  return friction;
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

// Does the contact reach the last cell of a profile?
Fault at_edge(const WheelAndRail& bodies, const RailSurface& face, const Cells& cells,
              const Field& pressure) {
  const Grid& g = cells.grid;
  for (int j = 0; j < g.ny; ++j) {
    for (int i = 0; i < g.nx; ++i) {
      const std::size_t at = g.index(i, j);
      if (pressure[at] <= 0.0) continue;
      const bool rail_ends = g.y(j) < g.dy || g.y(j) > face.section.length() - g.dy;
      const double on_wheel = cells.points[at].wheel_s;
      if (rail_ends || on_wheel < g.dy || on_wheel > bodies.wheel.length() - g.dy)
        return Fault::patch_at_edge(rail_ends ? "config.rail" : "config.wheel");
    }
  }
  return {};
}

// Force, moment and sums over the rows from the fields; `ways`: with friction, rolled.
void sum_up(const WheelOnRail& state, const Cells& cells, Collocation collocation, const Way* ways,
            SurfaceSolution& s) {
  const Grid& g = s.grid;
  const double behind = traction_behind(collocation) * g.dx;
  for (int k = 0; k < 3; ++k) s.force[k] = s.moment[k] = 0.0;
  s.pressure_sum = s.area = s.peak_pressure = s.power = 0.0;
  s.row_forces.clear();
  for (int j = 0; j < g.ny; ++j) {
    const SurfaceRow& place = s.rows[j];
    const auto [sn, c] = sine_cosine(place.angle);
    RowForces row{.s = g.y(j), .y = place.y, .z = place.z, .angle = place.angle};
    for (int i = 0; i < g.nx; ++i) {
      const std::size_t at = g.index(i, j);
      const double p = s.pressure[at];
      if (p <= 0.0) continue;
      const double px = s.traction_x[at], py = s.traction_y[at];
      double lag = 0.0;  // of lateral tractions behind their cells: moment
      for (const Way* way = ways; ways && way != ways + 2; ++way) {
        if (way->share <= 0.0) continue;
        lag += way->share * way->direction * behind * way->traction_y[at];
        row.power -= way->share * g.dx *
                     (way->traction_x[at] * way->sliding_x[at] + way->traction_y[at] * way->sliding_y[at]);
      }
      row.normal_force += p * g.dx;
      row.fx += px * g.dx;
      row.fy += py * g.dx;
      row.length += g.dx;
      row.peak_pressure = std::max(row.peak_pressure, p);
      // The force acts halfway between the undeformed surfaces.
      const double half = 0.5 * cells.points[at].gap, area = g.cell_area();
      const double lean = place.lean;  // tangent (1, lean n), normal (-lean, n)
      const double fx = (px + lean * p) * area, fy = (py * c + (p - lean * px) * sn) * area,
                   fz = (py * sn - (p - lean * px) * c) * area;
      const RailFall& fall = cells.points[at].fall;
      const double x = g.x(i), y = place.y + fall.y + half * sn - state.wheel.position[1],
                   z = place.z + fall.z - half * c - state.wheel.position[2];
      s.force[0] += fx;
      s.force[1] += fy;
      s.force[2] += fz;
      s.moment[0] += y * fz - z * fy;
      s.moment[1] += z * fx - x * fz + lag * sn * area;
      s.moment[2] += x * fy - lag * c * area - y * fx;
    }
    if (row.normal_force <= 0.0) continue;
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
               state.rail.slope_y + state.rail.slope_z + state.rail.velocity_y + state.rail.velocity_z +
               state.rail.velocity_roll;
  for (int k = 0; k < 3; ++k) {
    sum += state.wheel.position[k] + state.wheel.velocity[k] + state.wheel.angular_velocity[k];
    for (const double r : state.wheel.rotation[k]) sum += r;
  }
  if (!std::isfinite(sum)) return Fault::not_finite("state");
  if (!(options.cell_x > 0.0 && options.cell_s > 0.0)) {
    return Fault::range("options.cell_x", {options.cell_x, "m"});
  }
  if (!(state.friction >= 0.0)) {
    return Fault::range("friction.coefficient", {state.friction});
  }
  if (state.load_prescribed && !(state.vertical_load > 0.0)) {
    return Fault::load("input.vertical_load", {state.vertical_load, "N"});
  }
  return {};
}

}  // namespace

SurfaceContact::SurfaceContact(WheelAndRail bodies, const SurfaceOptions& options)
    : bodies_(std::move(bodies)), options_(options) {}

SurfaceSolution SurfaceContact::at_height(const WheelOnRail& in, double height, bool with_friction,
                                          const SurfaceSolution* start,
                                          const ProgressCallback& progress) const {
  SurfaceSolution s;
  s.height = height;
  WheelOnRail state = in;
  state.wheel.position[2] = height;
  const SeenAlongRail along_rail(bodies_, state);
  const TurnedAboveAxle turned_wheel(bodies_, state);
  if (bodies_.rail.size() == 1) {
    solve_face(bodies_.rail[0], state, with_friction, start, progress, s);
  } else {
    s.fault = Fault::no_contact();
    double sticking = 0.0;
    for (std::size_t f = 0; f < bodies_.rail.size() && !s.fault.failed(); ++f) {
      const double per_face = 1.0 / static_cast<double>(bodies_.rail.size()),
                   begun = per_face * static_cast<double>(f);
      PartOfProgress part(progress, begun, begun + per_face);
      SurfaceSolution& one = s.faces.emplace_back();
      solve_face(bodies_.rail[f], state, with_friction,
                 start != nullptr && start->faces.size() > f ? &start->faces[f] : nullptr, part.callback(),
                 one);
      if (one.fault.status == WRC_FLAG_NO_CONTACT) continue;
      if (s.fault.status == WRC_FLAG_NO_CONTACT) s.fault = {};
      keep_worst(s.fault, one.fault);
      for (int k = 0; k < 3; ++k) {
        s.force[k] += one.force[k];
        s.moment[k] += one.moment[k];
      }
      s.pressure_sum += one.pressure_sum;
      s.area += one.area;
      s.power += one.power;
      s.peak_pressure = std::max(s.peak_pressure, one.peak_pressure);
      s.turns = std::max(s.turns, one.turns);
      sticking += one.adhesion_fraction * one.area;
      for (RowForces& row : one.row_forces) {
        row.face = static_cast<int>(f);
        s.row_forces.push_back(row);
      }
    }
    if (s.area > 0.0) s.adhesion_fraction = sticking / s.area;
  }
  turned_wheel.turn_back(s.force);
  turned_wheel.turn_back(s.moment);
  along_rail.turn_back(s.force);
  along_rail.turn_back(s.moment);
  return s;
}

void SurfaceContact::solve_face(const RailSurface& face, const WheelOnRail& state, bool with_friction,
                                const SurfaceSolution* start, const ProgressCallback& progress,
                                SurfaceSolution& s) const {
  const RollingSurfaces surfaces(bodies_, face, state);
  const Cells cells = lay_cells(surfaces, face.section.length(), options_);
  s.grid = cells.grid;
  if (cells.too_many) {
    s.grid = {};
    s.fault = Fault::range("cells of the exact solution", {cells.grid.cells(), "", 0.0, options_.max_cells},
                           "an overlap of millimetres, or cells too small");
    return;
  }
  if (cells.deepest <= 0.0) {
    s.fault = Fault::no_contact();
    return;
  }
  s.rows = cells.rows;
  const std::size_t n = s.grid.cells();
  for (Field* field : {&s.traction_x, &s.traction_y}) field->assign(n, 0.0);
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
  if (!with_friction) {
    gap.progress = progress;
    const GapSolution pressed = normal.solve(gap);
    s.pressure = pressed.pressure;
    if (state.damping != 0.0) damp(surfaces, cells, state.damping, s.pressure);
    s.fault = pressed.fault;
    s.turns = 1;
    if (s.fault.failed()) return;
    sum_up(state, cells, options_.collocation, nullptr, s);
    keep_worst(s.fault, at_edge(bodies_, face, cells, s.pressure));
    return;
  }

  // A layer between the bodies: what tractions move the surfaces along each other, over the reduction.
  Material softer = bodies_.material;
  softer.shear_modulus *= state.slope_reduction;
  RollingSolver roller(s.grid, softer, angles, bodies_.coupling * state.slope_reduction);
  TurnedConvolution lift(s.grid, bodies_.material, Convolution::Kernel::shear, angles);
  const bool couples = bodies_.coupling != 0.0;
  std::optional<TurnedConvolution> opening;  // of unlike bodies, under tractions
  if (couples)
    opening.emplace(s.grid, bodies_.material, Convolution::Kernel::coupling, angles, bodies_.coupling);
  TurnedConvolution drag(s.grid, bodies_.material, Convolution::Kernel::normal_slip, angles);
  Way ways[2];
  ways[1].direction = -1.0;
  for (Way& way : ways) {
    find_sliding(surfaces, cells, options_.collocation, way);
    way.problem.collocation = options_.collocation;
    way.problem.tolerance = options_.rolling_tolerance;
  }
  const bool warm = start != nullptr && start->grid.cells() > 0 && !start->traction_x.empty();
  if (warm) {
    s.traction_x = moved(start->grid, start->traction_x, s.grid);
    s.traction_y = moved(start->grid, start->traction_y, s.grid);
  }
  Field turned(n);
  double left = 1.0;  // of the work, as far as is known
  for (s.turns = 1;; ++s.turns, left *= 0.5) {
    if (warm || s.turns > 1) {
      lift.tangential_crossed(s.traction_x, s.traction_y, turned);
      for (std::size_t k = 0; k < n; ++k) gap.gap[k] = s.gap[k] + turned[k];
      if (couples) {
        Field x = s.traction_x, y = s.traction_y;
        opening->tangential(x, y);
        for (std::size_t k = 0; k < n; ++k) gap.gap[k] += y[k];
      }
    }
    PartOfProgress pressing(progress, 1.0 - left, 1.0 - 0.9 * left);
    gap.progress = pressing.callback();
    const GapSolution pressed = normal.solve(gap);
    s.fault = pressed.fault;
    s.pressure = pressed.pressure;
    if (s.fault.failed()) return;
    const double normal_force =
        state.damping != 0.0 ? damp(surfaces, cells, state.damping, s.pressure) : pressed.normal_force;
    if (normal_force <= 0.0) {
      for (Field* field : {&s.traction_x, &s.traction_y}) field->assign(n, 0.0);
      sum_up(state, cells, options_.collocation, nullptr, s);
      break;
    }
    const double speed = rolling_speed(state, cells, s.pressure, ways);
    const RollingReference reference = rolling_reference(speed);
    ways[speed < 0.0 ? 1 : 0].share = 1.0 - reference.reverse_share;
    ways[speed < 0.0 ? 0 : 1].share = reference.reverse_share;
    const Field first_x = std::exchange(s.traction_x, Field(n, 0.0)),
                first_y = std::exchange(s.traction_y, Field(n, 0.0));
    s.adhesion_fraction = 0.0;
    for (Way& way : ways) {
      if (way.share <= 0.0) continue;
      RollingProblem& problem = way.problem;
      problem.pressure = way.seen(s.grid, s.pressure, false);
      const Field friction = friction_of_rows(state, face.section, bodies_.wheel, cells, s.pressure, way);
      problem.friction = friction.size() > 1 ? way.seen(s.grid, friction, false) : friction;
      problem.rigid_slip_x = way.seen(s.grid, way.sliding_x, true);
      problem.rigid_slip_y = way.seen(s.grid, way.sliding_y, false);
      drag.normal_crossed(problem.pressure, turned);
      for (std::size_t k = 0; k < n; ++k) {
        problem.rigid_slip_x[k] /= reference.divisor;
        problem.rigid_slip_y[k] = problem.rigid_slip_y[k] / reference.divisor - turned[k];
      }
      RollingSolution before = std::move(way.rolled);
      if (!way.started && warm && reference.reverse_share <= 0.0) {
        before.traction_x = way.seen(s.grid, first_x, true);
        before.traction_y = way.seen(s.grid, first_y, false);
        way.started = true;
      }
      problem.start = way.started ? &before : nullptr;
      PartOfProgress rolling(progress, 1.0 - 0.9 * left, 1.0 - 0.5 * left);
      problem.progress = rolling.callback();
      way.rolled = roller.solve(problem);
      way.started = true;
      keep_worst(s.fault, way.rolled.fault);
      if (s.fault.failed()) return;
      way.traction_x = way.seen(s.grid, way.rolled.traction_x, true);
      way.traction_y = way.seen(s.grid, way.rolled.traction_y, false);
      for (std::size_t k = 0; k < n; ++k) {
        s.traction_x[k] += way.share * way.traction_x[k];
        s.traction_y[k] += way.share * way.traction_y[k];
      }
      s.adhesion_fraction += way.share * way.rolled.forces.adhesion_fraction;
    }
    if (reference.reverse_share > 0.0) keep_worst(s.fault, Fault::creepages_limited("rolling speed"));
    const double force_before[3] = {s.force[0], s.force[1], s.force[2]};
    sum_up(state, cells, options_.collocation, ways, s);
    double change = 0.0, size = 0.0;
    for (int k = 0; k < 3; ++k) {
      change += (s.force[k] - force_before[k]) * (s.force[k] - force_before[k]);
      size += s.force[k] * s.force[k];
    }
    if (change <= options_.force_tolerance * options_.force_tolerance * size) break;
    if (!options_.turned && !couples) break;
    if (s.turns == options_.max_turns) {
      keep_worst(s.fault, Fault::iteration_cap("surface.turns", {std::sqrt(change / size)}));
      break;
    }
  }
  keep_worst(s.fault, at_edge(bodies_, face, cells, s.pressure));
}

// The load grows with the depth below first touch nearly with its power 3/2: secants of load^(2/3) over the
// height, inside of what brackets the load; first without friction, then with it.
SurfaceSolution SurfaceContact::solve(const SurfaceProblem& problem) const {
  SurfaceSolution s;
  s.fault = check(problem, options_);
  if (s.fault.failed()) return s;
  const bool with_friction = problem.state.friction > 0.0;
  if (!problem.state.load_prescribed) {
    return at_height(problem.state, problem.state.wheel.position[2], with_friction, nullptr,
                     problem.progress);
  }

  // Height of first touch, from the rows' gaps, beginning with the wheel's largest radius above the rail.
  double height = highest_start(bodies_, problem.state.rail);
  for (int k = 0; k < 20; ++k) {
    WheelOnRail state = problem.state;
    state.wheel.position[2] = height;
    const SeenAlongRail along(bodies_, state);
    const TurnedAboveAxle turned(bodies_, state);
    double nearest = apart;
    for (const RailSurface& face : bodies_.rail) {
      const RollingSurfaces surfaces(bodies_, face, state);
      const int rows = static_cast<int>(face.section.length() / options_.cell_s);
      for (int j = 0; j < rows; ++j) {
        bool found = false;
        const SurfaceRow row = surfaces.row((j + 0.5) * options_.cell_s, options_.normals, found);
        constexpr double least_down = 0.2;  // steeper faces guide
        if (!found) continue;
        const double down = sine_cosine(row.angle).cosine;
        if (down < least_down) continue;
        const SurfacePoint p = surfaces.point(row, row.middle);
        if (p.found) nearest = std::min(nearest, p.gap / down);
      }
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
    // Work done, by how near the load is: a tenth of it without friction.
    const double begun = friction ? 0.1 : 0.0, done = with_friction && !friction ? 0.1 : 1.0;
    double nearest = 1.0;
    for (;; ++heights) {
      const SurfaceSolution start = std::move(s);
      const double decades = natural_log(nearest) / natural_log(tolerance), rest = done - begun;
      PartOfProgress part(problem.progress, begun + rest * decades, begun + rest * (0.5 + 0.5 * decades));
      s = at_height(problem.state, height, friction, friction ? &start : nullptr, part.callback());
      if (s.fault.failed()) break;
      const double force = -s.force[2];
      nearest = std::clamp(std::abs(force - load) / load, tolerance, nearest);
      if (std::abs(force - load) <= tolerance * load) break;
      if (heights == options_.max_heights) {
        keep_worst(s.fault, Fault::iteration_cap("input.vertical_load", {force, "N"}));
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
  if (!s.fault.failed() && s.row_forces.empty()) {
    s.fault = Fault::load("input.vertical_load", {load, "N"},
                          "the wheel meets no rail at this pose, whatever its height");
  }
  s.heights = heights;
  return s;
}

}  // namespace wrc::halfspace
