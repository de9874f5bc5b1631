#include "halfspace/face_contact.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/elementary.hpp"
#include "geometry/creepages.hpp"
#include "halfspace/surface_cells.hpp"
#include "normal/damping.hpp"
#include "tangential/friction/friction.hpp"

namespace wrc::halfspace {
namespace {

// A direction of rolling: along x, or backwards, which is along x in the mirror across the axle. The rolling
// problem and its solution are as the mirror shows them; the fields below as they are.
struct Direction {
  double sign = 1.0;           // direction along x
  double share = 0.0;          // share of the tractions [-]
  Field sliding_x, sliding_y;  // rigid velocity of wheel over rail where the collocation wants it [m/s]
  RollingProblem problem;
  RollingSolution rolled;
  bool started = false;
  Field traction_x, traction_y;  // [Pa]

  // A field as it is to one as the mirror shows it, or back; `along_x`: components along x, which change
  // sign.
  Field seen(const Grid& g, const Field& field, bool along_x) const {
    // x -> -x: columns from the other end
    if (sign > 0.0) return field;
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

void find_sliding(const RollingSurfaces& surfaces, const SurfaceCells& cells, Collocation collocation,
                  Direction& direction) {
  const Grid& g = cells.grid;
  const double ahead = direction.sign * rigid_slip_ahead(collocation) * g.dx;
  direction.sliding_x.assign(g.cells(), 0.0);
  direction.sliding_y.assign(g.cells(), 0.0);
  for (int j = 0; j < g.ny; ++j) {
    for (int i = 0; i < g.nx; ++i) {
      const std::size_t at = g.index(i, j);
      if (!cells.points[at].found) continue;
      // ahead of the cell's centre in the direction of rolling; the cell's own point on the wheel starts the
      // search
      const double x = g.x(i) + ahead;
      surfaces.sliding(cells.rows[j], x, surfaces.point(cells.rows[j], x, cells.points[at].wheel_s),
                       direction.sliding_x[at], direction.sliding_y[at]);
    }
  }
}

// Damps the pressure of each row by the speed at which the surfaces near each other at its middle, and
// returns the sum of the damped pressures [N].
double damp(const RollingSurfaces& surfaces, const SurfaceCells& cells, double damping, Field& pressure) {
  const Grid& g = cells.grid;
  double sum = 0.0;
  for (int j = 0; j < g.ny; ++j) {
    // the row's middle: the centre of its pressure
    double row = 0.0, moment = 0.0;
    for (int i = 0; i < g.nx; ++i) {
      row += pressure[g.index(i, j)];
      moment += g.x(i) * pressure[g.index(i, j)];
    }
    if (row <= 0.0) continue;
    const double x = moment / row;
    // one factor for all of the row, as a strip of the real-time side has it
    const int middle = std::clamp(nearest_integer((x - g.x0) / g.dx), 0, g.nx - 1);
    const SurfacePoint at = surfaces.point(cells.rows[j], x, cells.points[g.index(middle, j)].wheel_s);
    const double factor = normal::damping_factor(surfaces.approach(cells.rows[j], x, at), damping);
    for (int i = 0; i < g.nx; ++i) pressure[g.index(i, j)] *= factor;
    sum += factor * row;
  }
  return sum * g.cell_area();
}

// V = mean over the pressure of the speeds at which wheel and rail material pass through the contact [m/s]:
// half the sum of both, where the wheel's is the rail's less the sliding velocity.
double rolling_speed(const surface::WheelOnRail& state, const SurfaceCells& cells, const Field& pressure,
                     const Direction (&directions)[2]) {
  double passing = 0.0, load = 0.0;
  const Grid& g = cells.grid;
  for (int j = 0; j < g.ny; ++j) {
    const double rail = state.rail.turning * cells.rows[j].radius;  // a roller's surface, backwards [m/s]
    for (int i = 0; i < g.nx; ++i) {
      const std::size_t k = g.index(i, j);
      // 1/4: half of the mean of the two directions' values, which differ by where on a cell they are taken
      passing += pressure[k] * (rail - 0.25 * (directions[0].sliding_x[k] + directions[1].sliding_x[k]));
      load += pressure[k];
    }
  }
  return state.wheel.velocity[0] + passing / load;
}

// Coefficients of all cells: of each row over its width on the profile that zones lie on, at the root mean
// square of its cells' rigid sliding velocity.
Field friction_of_rows(const FaceProblem& in, const SurfaceCells& cells, const Field& pressure,
                       const Direction& direction) {
  const Grid& g = cells.grid;
  const surface::WheelOnRail& state = in.state;
  if (state.law == nullptr) return {state.friction};
  const tangential::FrictionLaw& law = *state.law;
  Field friction(g.cells(), 0.0);
  for (int j = 0; j < g.ny; ++j) {
    // sums over the row's cells in contact: squared sliding velocity, places on the wheel's profile
    double squares = 0.0, count = 0.0, on_wheel = 0.0;
    for (int i = 0; i < g.nx; ++i) {
      const std::size_t at = g.index(i, j);
      if (pressure[at] <= 0.0) continue;
      on_wheel += cells.points[at].wheel_s;
      squares += direction.sliding_x[at] * direction.sliding_x[at] +
                 direction.sliding_y[at] * direction.sliding_y[at];
      count += 1.0;
    }
    if (count == 0.0) continue;
    // at rest: the mean of the zones over the row's width in y; never of nothing, on a vertical face neither
    double at_rest = law.coefficient;
    if (law.zones.count > 0) {
      const SectionCurve::Point p =
          state.zones_on_wheel ? in.bodies.wheel.at(on_wheel / count) : in.face.section.at(g.y(j));
      const double half = 0.5 * g.dy * std::abs(p.dy) + 1e-9;
      at_rest = tangential::mean_friction(law.zones, p.y - half, p.y + half);
    }
    const double coefficient = at_rest * tangential::speed_factor(law, std::sqrt(squares / count));
    for (int i = 0; i < g.nx; ++i) friction[g.index(i, j)] = coefficient;
  }
  return friction;
}

// A field of one piece of the lattice on another; zero where they do not overlap.
Field moved(const Grid& from, const Field& field, const Grid& to) {
  // both are pieces of one lattice: whole cells apart
  Field out(to.cells(), 0.0);
  const int di = nearest_integer((to.x0 - from.x0) / from.dx);
  const int dj = nearest_integer((to.y0 - from.y0) / from.dy);
  for (int j = std::max(0, -dj); j < to.ny && j + dj < from.ny; ++j) {
    for (int i = std::max(0, -di); i < to.nx && i + di < from.nx; ++i) {
      out[to.index(i, j)] = field[from.index(i + di, j + dj)];
    }
  }
  return out;
}

// Flags a contact that reaches the last cell of a profile, or of a face along the track.
Fault at_edge(const FaceProblem& in, const SurfaceCells& cells, const Field& pressure) {
  const Grid& g = cells.grid;
  for (int j = 0; j < g.ny; ++j) {
    for (int i = 0; i < g.nx; ++i) {
      const std::size_t at = g.index(i, j);
      if (pressure[at] <= 0.0) continue;
      // within a cell of either end of the rail's or the wheel's profile
      const bool rail_ends = g.y(j) < g.dy || g.y(j) > in.face.section.length() - g.dy;
      const double on_wheel = cells.points[at].wheel_s;
      if (!in.face.extent.holds(g.x(i) - g.dx) || !in.face.extent.holds(g.x(i) + g.dx))
        return Fault::patch_at_edge("config.rail_sections");
      if (rail_ends || on_wheel < g.dy || on_wheel > in.bodies.wheel.length() - g.dy)
        return Fault::patch_at_edge(rail_ends ? "config.rail" : "config.wheel");
    }
  }
  return {};
}

// Adds the force of cell (i, j) and its moment about the wheel's reference point to those of the wheel.
// `turned`: by the row's angle; `lag`: moment of the lateral traction about the cell's centre [Pa m].
void add_cell(const surface::WheelOnRail& state, const SurfaceCells& cells, const SineCosine& turned, int i,
              int j, double lag, SurfaceSolution& s) {
  const Grid& g = s.grid;
  const std::size_t at = g.index(i, j);
  const SurfaceRow& place = s.rows[j];
  const auto [sn, c] = turned;
  const double p = s.pressure[at], px = s.traction_x[at], py = s.traction_y[at], area = g.cell_area();
  // Grade n of the rail along the track: tangent (1, n e_n), normal (-n, e_n) to first order, e_n = (sin,
  // -cos) across; the lateral traction acts along (cos, sin).
  const double grade = place.grade;
  const double fx = (px + grade * p) * area, fy = (py * c + (p - grade * px) * sn) * area,
               fz = (py * sn - (p - grade * px) * c) * area;
  // The force acts halfway between the undeformed surfaces.
  const double half = 0.5 * cells.points[at].gap;
  const RailFall& fall = cells.points[at].fall;
  const double x = g.x(i), y = place.y + fall.y + half * sn - state.wheel.position[1],
               z = place.z + fall.z - half * c - state.wheel.position[2];
  s.force[0] += fx;
  s.force[1] += fy;
  s.force[2] += fz;
  // M = r x F, and the lateral tractions' lag behind their cells: -lag e_x x (cos, sin)
  s.moment[0] += y * fz - z * fy;
  s.moment[1] += z * fx - x * fz + lag * sn * area;
  s.moment[2] += x * fy - lag * c * area - y * fx;
}

// Force, moment and sums over the rows from the fields; `directions`: with friction, both, rolled.
void sum_up(const FaceProblem& in, const SurfaceCells& cells, const Direction* directions,
            SurfaceSolution& s) {
  const Grid& g = s.grid;
  const double behind = traction_behind(in.options.collocation) * g.dx;
  for (int k = 0; k < 3; ++k) s.force[k] = s.moment[k] = 0.0;
  s.pressure_sum = s.area = s.peak_pressure = s.power = 0.0;
  s.row_forces.clear();
  for (int j = 0; j < g.ny; ++j) {
    // sums per length of the row, in its own frame
    const SurfaceRow& place = s.rows[j];
    const SineCosine turned = sine_cosine(place.angle);
    RowForces row{.s = g.y(j), .y = place.y, .z = place.z, .angle = place.angle};
    for (int i = 0; i < g.nx; ++i) {
      const std::size_t at = g.index(i, j);
      const double p = s.pressure[at];
      if (p <= 0.0) continue;
      // lateral tractions lie behind their cells' centres; power: -traction * rigid sliding
      double lag = 0.0;
      for (const Direction* d = directions; d && d != directions + 2; ++d) {
        if (d->share <= 0.0) continue;
        lag += d->share * d->sign * behind * d->traction_y[at];
        row.power -=
            d->share * g.dx * (d->traction_x[at] * d->sliding_x[at] + d->traction_y[at] * d->sliding_y[at]);
      }
      row.normal_force += p * g.dx;
      row.fx += s.traction_x[at] * g.dx;
      row.fy += s.traction_y[at] * g.dx;
      row.length += g.dx;
      row.peak_pressure = std::max(row.peak_pressure, p);
      add_cell(in.state, cells, turned, i, j, lag, s);
    }
    // and over the rows in contact
    if (row.normal_force <= 0.0) continue;
    s.pressure_sum += row.normal_force * g.dy;
    s.area += row.length * g.dy;
    s.peak_pressure = std::max(s.peak_pressure, row.peak_pressure);
    s.power += row.power * g.dy;
    s.row_forces.push_back(row);
  }
}

// Normal contact and rolling of one face in turn, each under the other's tractions, until the force rests.
class RollingFace {
 public:
  RollingFace(const FaceProblem& in, const RollingSurfaces& surfaces, const SurfaceCells& cells,
              const Field& angles, SurfaceSolution& s);
  // `gap`: with its settings; its field of gaps is overwritten turn by turn.
  void solve(NormalSolver& normal, GapProblem& gap);

 private:
  void lift_gaps(GapProblem& gap);
  double press(NormalSolver& normal, const GapProblem& gap);
  bool roll(const geometry::RollingReference& reference, const ProgressCallback& progress);
  RollingSolution start_of(Direction& direction, bool both_directions);
  bool at_rest(const double (&force_before)[3]);

  const FaceProblem& in_;
  const RollingSurfaces& surfaces_;
  const SurfaceCells& cells_;
  SurfaceSolution& s_;
  RollingSolver roller_;
  TurnedConvolution lift_, drag_;             // gap under tractions; slip under pressure: of turned normals
  std::optional<TurnedConvolution> opening_;  // gap under tractions of unlike bodies
  Direction directions_[2];
  bool warm_;
  Field turned_;             // products of the turned normals
  Field first_x_, first_y_;  // tractions before this turn [Pa]
};

// A layer between the bodies (slope_reduction) makes the surfaces move further along each other under
// tractions: as if the shear modulus were lower. Gaps are those of the bodies alone.
patch::Material softened(const patch::Material& material, double slope_reduction) {
  patch::Material softer = material;
  softer.shear_modulus *= slope_reduction;
  return softer;
}

RollingFace::RollingFace(const FaceProblem& in, const RollingSurfaces& surfaces, const SurfaceCells& cells,
                         const Field& angles, SurfaceSolution& s)
    : in_(in),
      surfaces_(surfaces),
      cells_(cells),
      s_(s),
      roller_(s.grid, softened(in.bodies.material, in.state.slope_reduction), angles,
              in.bodies.coupling * in.state.slope_reduction),
      lift_(s.grid, in.bodies.material, Convolution::Kernel::shear, angles),
      drag_(s.grid, in.bodies.material, Convolution::Kernel::normal_slip, angles),
      warm_(in.start != nullptr && in.start->grid.cells() > 0 && !in.start->traction_x.empty()),
      turned_(s.grid.cells()) {
  if (in.bodies.coupling != 0.0)
    opening_.emplace(s.grid, in.bodies.material, Convolution::Kernel::coupling, angles, in.bodies.coupling);
  // rigid sliding velocities of both directions: they differ by where on a cell the collocation wants them
  directions_[1].sign = -1.0;
  for (Direction& direction : directions_) {
    find_sliding(surfaces, cells, in.options.collocation, direction);
    direction.problem.collocation = in.options.collocation;
    direction.problem.layer = in.state.layer;
    direction.problem.tolerance = in.options.rolling_tolerance;
  }
  const SurfaceSolution* const start = warm_ ? in.start : nullptr;
  if (start == nullptr) return;
  s.traction_x = moved(start->grid, start->traction_x, s.grid);
  s.traction_y = moved(start->grid, start->traction_y, s.grid);
}

// Gaps under the tractions of the turn before.
void RollingFace::lift_gaps(GapProblem& gap) {
  const std::size_t n = s_.grid.cells();
  // sum over j of sin(a_i - a_j) (K_xy p_x,j + K_yy p_y,j): normals of other rows have a part of them
  lift_.tangential_crossed(s_.traction_x, s_.traction_y, turned_);
  for (std::size_t k = 0; k < n; ++k) gap.gap[k] = s_.gap[k] + turned_[k];
  if (!opening_) return;
  // unlike bodies: tractions lift one surface further than they lower the other
  Field x = s_.traction_x, y = s_.traction_y;
  opening_->tangential(x, y);
  for (std::size_t k = 0; k < n; ++k) gap.gap[k] += y[k];
}

// Pressure over the gaps, damped; returns its sum [N].
double RollingFace::press(NormalSolver& normal, const GapProblem& gap) {
  const GapSolution pressed = normal.solve(gap);
  s_.fault = pressed.fault;
  s_.pressure = pressed.pressure;
  if (s_.fault.failed() || in_.state.damping == 0.0) return pressed.normal_force;
  return damp(surfaces_, cells_, in_.state.damping, s_.pressure);
}

// Tractions that a direction's solution begins with: its own of the turn before, in the first turn those of
// the start where one direction alone rolls. direction.started: there are some.
RollingSolution RollingFace::start_of(Direction& direction, bool both_directions) {
  RollingSolution before = std::move(direction.rolled);
  if (!direction.started && warm_ && !both_directions) {
    before.traction_x = direction.seen(s_.grid, first_x_, true);
    before.traction_y = direction.seen(s_.grid, first_y_, false);
    direction.started = true;
  }
  return before;
}

// Tractions under the pressure: the sum of both directions' by their shares. False: failed.
bool RollingFace::roll(const geometry::RollingReference& reference, const ProgressCallback& progress) {
  const Grid& g = s_.grid;
  const std::size_t n = g.cells();
  first_x_ = std::exchange(s_.traction_x, Field(n, 0.0));
  first_y_ = std::exchange(s_.traction_y, Field(n, 0.0));
  s_.adhesion_fraction = 0.0;
  for (Direction& direction : directions_) {
    if (direction.share <= 0.0) continue;
    // the problem in the mirror: w = sliding velocity / V, less the slip under pressures of turned normals
    // along y
    RollingProblem& problem = direction.problem;
    problem.pressure = direction.seen(g, s_.pressure, false);
    const Field friction = friction_of_rows(in_, cells_, s_.pressure, direction);
    problem.friction = friction.size() > 1 ? direction.seen(g, friction, false) : friction;
    problem.rigid_slip_x = direction.seen(g, direction.sliding_x, true);
    problem.rigid_slip_y = direction.seen(g, direction.sliding_y, false);
    drag_.normal_crossed(problem.pressure, turned_);
    for (std::size_t k = 0; k < n; ++k) {
      problem.rigid_slip_x[k] /= reference.divisor;
      problem.rigid_slip_y[k] = problem.rigid_slip_y[k] / reference.divisor - turned_[k];
    }
    const RollingSolution before = start_of(direction, reference.reverse_share > 0.0);
    problem.start = direction.started ? &before : nullptr;
    problem.progress = progress;
    direction.rolled = roller_.solve(problem);
    direction.started = true;
    keep_worst(s_.fault, direction.rolled.fault);
    if (s_.fault.failed()) return false;
    // back out of the mirror, and into the sum
    direction.traction_x = direction.seen(g, direction.rolled.traction_x, true);
    direction.traction_y = direction.seen(g, direction.rolled.traction_y, false);
    for (std::size_t k = 0; k < n; ++k) {
      s_.traction_x[k] += direction.share * direction.traction_x[k];
      s_.traction_y[k] += direction.share * direction.traction_y[k];
    }
    s_.adhesion_fraction += direction.share * direction.rolled.forces.adhesion_fraction;
  }
  if (reference.reverse_share > 0.0) keep_worst(s_.fault, Fault::creepages_limited("rolling speed"));
  return true;
}

// Has the force changed by less than its tolerance, |F - F_before| <= eps |F|, or can it change no more?
// Flags the last turn.
bool RollingFace::at_rest(const double (&force_before)[3]) {
  double change = 0.0, size = 0.0;
  for (int k = 0; k < 3; ++k) {
    change += (s_.force[k] - force_before[k]) * (s_.force[k] - force_before[k]);
    size += s_.force[k] * s_.force[k];
  }
  const double tolerance = in_.options.force_tolerance;
  if (change <= tolerance * tolerance * size) return true;
  // without turned normals and coupling the pressure knows of no tractions: one turn is all
  if (!in_.options.turned && !opening_) return true;
  if (s_.turns < in_.options.max_turns) return false;
  keep_worst(s_.fault, Fault::iteration_cap("surface.turns", {std::sqrt(change / size)}));
  return true;
}

void RollingFace::solve(NormalSolver& normal, GapProblem& gap) {
  // Share of the work ahead, as far as is known: each turn is taken for the first half of it, of which a
  // tenth is the normal problem's and four tenths are rolling's.
  double ahead = 1.0;
  for (s_.turns = 1;; ++s_.turns, ahead *= 0.5) {
    if (warm_ || s_.turns > 1) lift_gaps(gap);
    PartOfProgress pressing(in_.progress, 1.0 - ahead, 1.0 - 0.9 * ahead);
    gap.progress = pressing.callback();
    const double normal_force = press(normal, gap);
    gap.progress = {};
    if (s_.fault.failed()) return;
    if (normal_force <= 0.0) {
      for (Field* field : {&s_.traction_x, &s_.traction_y}) field->assign(s_.grid.cells(), 0.0);
      sum_up(in_, cells_, nullptr, s_);
      break;
    }
    // Rolling at V; below a small V both directions by shares, as in real time (rolling_reference).
    const double speed = rolling_speed(in_.state, cells_, s_.pressure, directions_);
    const geometry::RollingReference reference = geometry::rolling_reference(speed);
    directions_[speed < 0.0 ? 1 : 0].share = 1.0 - reference.reverse_share;
    directions_[speed < 0.0 ? 0 : 1].share = reference.reverse_share;
    PartOfProgress rolling(in_.progress, 1.0 - 0.9 * ahead, 1.0 - 0.5 * ahead);
    if (!roll(reference, rolling.callback())) return;
    const double force_before[3] = {s_.force[0], s_.force[1], s_.force[2]};
    sum_up(in_, cells_, directions_, s_);
    if (at_rest(force_before)) break;
  }
  keep_worst(s_.fault, at_edge(in_, cells_, s_.pressure));
}

// Pressures alone, damped.
void press_without_friction(const FaceProblem& in, const RollingSurfaces& surfaces, const SurfaceCells& cells,
                            NormalSolver& normal, const GapProblem& gap, SurfaceSolution& s) {
  // no turn follows: tractions are zero
  const GapSolution pressed = normal.solve(gap);
  s.pressure = pressed.pressure;
  if (in.state.damping != 0.0) damp(surfaces, cells, in.state.damping, s.pressure);
  s.fault = pressed.fault;
  s.turns = 1;
  if (s.fault.failed()) return;
  sum_up(in, cells, nullptr, s);
  keep_worst(s.fault, at_edge(in, cells, s.pressure));
}

}  // namespace

void solve_face(const FaceProblem& in, SurfaceSolution& s) {
  // cells where the bodies may touch; none, or too many, end it here
  const RollingSurfaces surfaces(in.bodies, in.face, in.state);
  const SurfaceCells cells = lay_cells(surfaces, in.face.section.length(), in.options);
  if (cells.too_many) {
    s.fault = Fault::range("cells of the exact solution", {cells.grid.cells(), "", 0.0, in.options.max_cells},
                           "an overlap of millimetres, or cells too small");
    return;
  }
  s.grid = cells.grid;
  if (cells.deepest <= 0.0) {
    s.fault = Fault::no_contact();
    return;
  }
  s.rows = cells.rows;
  for (Field* field : {&s.traction_x, &s.traction_y}) field->assign(s.grid.cells(), 0.0);
  for (const SurfacePoint& p : cells.points)
    s.gap.push_back(p.found ? std::min(p.gap, gap_apart) : gap_apart);

  // gaps count from touch at this height: the approach is zero, overlaps are gaps below zero
  Field angles;
  if (in.options.turned) {
    for (const SurfaceRow& row : s.rows) angles.push_back(row.angle);
  }
  NormalSolver normal(s.grid, in.bodies.material, angles);
  GapProblem gap;
  gap.gap = s.gap;
  gap.prescribed = normal::Prescribed::approach;
  gap.tolerance = in.options.normal_tolerance;
  gap.progress = in.progress;
  if (in.with_friction) {
    RollingFace(in, surfaces, cells, angles, s).solve(normal, gap);
  } else {
    press_without_friction(in, surfaces, cells, normal, gap, s);
  }
}

}  // namespace wrc::halfspace
