#include "halfspace/surface_contact.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/elementary.hpp"
#include "halfspace/face_contact.hpp"
#include "halfspace/surface_cells.hpp"
#include "surface/wrench/height_search.hpp"

namespace wrc::halfspace {
namespace {

// Height of a wheel whose largest radius is level with the top of its rail.
double highest_start(const WheelAndRail& bodies, const surface::RailMotion& rail) {
  constexpr double spacing = 1e-3;
  double lowest = 0.0, top = 0.0;
  // largest radius of the wheel over the nominal one [m]
  const auto on_wheel = static_cast<int>(bodies.wheel.length() / spacing);
  for (int k = 0; k <= on_wheel; ++k) lowest = std::max(lowest, bodies.wheel.at(spacing * k).z);
  if (bodies.out_of_round != nullptr) lowest += bodies.out_of_round->largest;
  // highest point of the rolled rail, z down
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

Fault check(const SurfaceProblem& problem, const SurfaceOptions& options) {
  const surface::WheelOnRail& state = problem.state;
  // one number that is not finite makes the sum so
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

// Adds the solution of face f to the sums over all faces.
void add_face(SurfaceSolution& one, std::size_t f, SurfaceSolution& s) {
  // forces act at places of their own, about one reference point: moments add up
  for (int k = 0; k < 3; ++k) {
    s.force[k] += one.force[k];
    s.moment[k] += one.moment[k];
  }
  s.pressure_sum += one.pressure_sum;
  s.area += one.area;
  s.power += one.power;
  s.peak_pressure = std::max(s.peak_pressure, one.peak_pressure);
  s.turns = std::max(s.turns, one.turns);
  for (RowForces& row : one.row_forces) {
    row.face = static_cast<int>(f);
    s.row_forces.push_back(row);
  }
}

}  // namespace

SurfaceContact::SurfaceContact(WheelAndRail bodies, const SurfaceOptions& options)
    : bodies_(std::move(bodies)), options_(options) {}

SurfaceSolution SurfaceContact::at_height(const surface::WheelOnRail& in, double height, bool with_friction,
                                          const SurfaceSolution* start,
                                          const ProgressCallback& progress) const {
  SurfaceSolution s;
  s.height = height;
  surface::WheelOnRail state = in;
  state.wheel.position[2] = height;
  // axes along the rail and above the axle of a roller, in which a rail is straight and level
  const SeenAlongRail along_rail(bodies_, state);
  const TurnedAboveAxle turned_wheel(bodies_, state);
  const auto face_problem = [&](std::size_t f, const SurfaceSolution* from, const ProgressCallback& part) {
    return FaceProblem{bodies_, bodies_.rail[f], state, options_, with_friction, from, part};
  };
  if (bodies_.rail.size() == 1) {
    solve_face(face_problem(0, start, progress), s);
  } else {
    // faces that do not press on each other: each alone, and the sums of their forces
    s.fault = Fault::no_contact();
    double sticking = 0.0;
    for (std::size_t f = 0; f < bodies_.rail.size() && !s.fault.failed(); ++f) {
      // each face takes its share of the progress, and of the start its own
      const double per_face = 1.0 / static_cast<double>(bodies_.rail.size()),
                   begun = per_face * static_cast<double>(f);
      PartOfProgress part(progress, begun, begun + per_face);
      const bool started = start != nullptr && start->faces.size() > f;
      SurfaceSolution& one = s.faces.emplace_back();
      solve_face(face_problem(f, started ? &start->faces[f] : nullptr, part.callback()), one);
      if (one.fault.status == WRC_FLAG_NO_CONTACT) continue;
      if (s.fault.status == WRC_FLAG_NO_CONTACT) s.fault = {};
      keep_worst(s.fault, one.fault);
      sticking += one.adhesion_fraction * one.area;
      add_face(one, f, s);
    }
    if (s.area > 0.0) s.adhesion_fraction = sticking / s.area;
  }
  // back to the track's axes
  turned_wheel.turn_back(s.force);
  turned_wheel.turn_back(s.moment);
  along_rail.turn_back(s.force);
  along_rail.turn_back(s.moment);
  return s;
}

// Newton's method with the slope of a wheel that goes straight down: each step is the smallest vertical
// distance of any row, to a tenth of a micrometre.
double SurfaceContact::first_touch(const surface::WheelOnRail& in) const {
  constexpr int most_steps = 20;
  constexpr double least_down = 0.2;  // cosine of the normal's angle: steeper faces guide, they do not carry
  double height = highest_start(bodies_, in.rail);
  for (int k = 0; k < most_steps; ++k) {
    surface::WheelOnRail state = in;
    state.wheel.position[2] = height;
    const SeenAlongRail along(bodies_, state);
    const TurnedAboveAxle turned(bodies_, state);
    // smallest distance of all faces, seen along the rail as in at_height()
    double nearest = gap_apart;
    for (const RailSurface& face : bodies_.rail) {
      const RollingSurfaces surfaces(bodies_, face, state);
      const int rows = static_cast<int>(face.section.length() / options_.cell_s);
      for (int j = 0; j < rows; ++j) {
        bool found = false;
        const SurfaceRow row = surfaces.row((j + 0.5) * options_.cell_s, options_.normals, found);
        // the row's gap along its normal is closed by moving down by gap / cos(angle)
        if (!found) continue;
        const double down = sine_cosine(row.angle).cosine;
        if (down < least_down) continue;
        const SurfacePoint p = surfaces.point(row, row.middle);
        if (p.found) nearest = std::min(nearest, p.gap / down);
      }
    }
    height += std::min(nearest, gap_apart);
    if (std::abs(nearest) < 1e-7) break;
  }
  return height;
}

// Heights without friction until the load is met to a hundredth, then with friction, whose vertical forces
// change the load: the first heights' loads count no more, the slope of the load over the height does.
SurfaceSolution SurfaceContact::at_load(const SurfaceProblem& problem) const {
  SurfaceSolution s;
  const double load = problem.state.vertical_load, touch = first_touch(problem.state);
  const bool with_friction = problem.state.friction > 0.0;
  // first touch carries nothing: the lower end of the bracket
  surface::HeightSearch search(load);
  search.take(touch, 0.0, 0.0);
  double height =
      touch + 6e-5 * surface::straightened(load / 8e4);  // Hertz's approach of a wheel on a rail, about
  int heights = 0;
  for (const bool friction : {false, true}) {
    if (friction && !with_friction) break;
    if (friction) search.forget_heights();
    const double tolerance = friction || !with_friction ? options_.load_tolerance : 1e-2;
    // Progress by how near the load is, in decades of the tolerance; a tenth of it without friction.
    const double begun = friction ? 0.1 : 0.0, rest = (with_friction && !friction ? 0.1 : 1.0) - begun;
    double nearest = 1.0;
    for (std::int32_t step = 0;; ++step, ++heights) {
      // tractions of the height before are the start, moved on the lattice
      const SurfaceSolution start = std::move(s);
      const double decades = natural_log(nearest) / natural_log(tolerance);
      PartOfProgress part(problem.progress, begun + rest * decades, begun + rest * (0.5 + 0.5 * decades));
      s = at_height(problem.state, height, friction, friction ? &start : nullptr, part.callback());
      if (s.fault.failed()) break;
      // met, or one more height between those known
      const double force = -s.force[2];
      nearest = std::clamp(std::abs(force - load) / load, tolerance, nearest);
      if (std::abs(force - load) <= tolerance * load) break;
      search.take(height, force, 0.0);
      if (heights == options_.max_heights || search.exhausted()) {
        keep_worst(s.fault, Fault::iteration_cap("input.vertical_load", {force, "N"}));
        break;
      }
      height = search.next(step, 0.0);
    }
    if (s.fault.failed()) break;
  }
  if (!s.fault.failed() && s.row_forces.empty()) {
    s.fault = Fault::load("input.vertical_load", {load, "N"},
                          "the wheel meets no rail at this pose, at any height");
  }
  s.heights = heights;
  return s;
}

SurfaceSolution SurfaceContact::solve(const SurfaceProblem& problem) const {
  SurfaceSolution s;
  s.fault = check(problem, options_);
  if (s.fault.failed()) return s;
  const surface::WheelOnRail& state = problem.state;
  if (state.load_prescribed) return at_load(problem);
  return at_height(state, state.wheel.position[2], state.friction > 0.0, nullptr, problem.progress);
}

}  // namespace wrc::halfspace
