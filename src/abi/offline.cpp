/// wrc_offline.h: the exact half-space solver behind the C interface. Offline: it allocates.
#include "abi/offline.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "abi/friction.hpp"
#include "abi/guarded.hpp"
#include "abi/prescribed.hpp"
#include "abi/stresses.hpp"
#include "abi/structs.hpp"
#include "abi/wheel.hpp"
#include "contact/methods.hpp"
#include "halfspace/exact_wheel.hpp"
#include "halfspace/normal.hpp"
#include "halfspace/planar_contact.hpp"
#include "halfspace/subsurface.hpp"
#include "halfspace/tangential.hpp"
#include "halfspace/transient.hpp"
#include "wrc/wrc_offline.h"

/// Bodies with their rolling history, grid and materials.
struct wrc_exact_transient {
  std::uint64_t tag;
  wrc_grid grid;
  wrc_material wheel, rail;
  wrc::halfspace::TransientSolver solver;
};

namespace wrc::abi {

namespace {

constexpr std::uint64_t transient_tag = 0x736e6172746378;  // "xctrans"

bool is_transient(const wrc_exact_transient* handle) {
  return handle != nullptr && handle->tag == transient_tag;
}

halfspace::Grid grid_of(const wrc_grid& checked) {
  return {.nx = static_cast<int>(checked.nx),
          .ny = static_cast<int>(checked.ny),
          .dx = checked.dx,
          .dy = checked.dy,
          .x0 = checked.x0,
          .y0 = checked.y0};
}

patch::Material elastic(const wrc_material& checked) { return {checked.shear_modulus, checked.poisson}; }

/// Elastic constants of both bodies together, and Kalker's coupling K of normal and tangential contact.
struct PressedBodies {
  patch::Material material;
  double coupling = 0.0;
};

PressedBodies bodies_of(const wrc_material& wheel, const wrc_material& rail) {
  return {patch::combined(elastic(wheel), elastic(rail)), patch::coupling(elastic(wheel), elastic(rail))};
}

/// A field of one number per cell.
Fault read_field(const Member& member, const double* theirs, std::size_t cells, halfspace::Field& field) {
  const Fault fault = check_all(member, "problem", theirs, cells);
  if (!fault.failed()) field.assign(theirs, theirs + cells);
  return fault;
}

void copy_field(const halfspace::Field& field, double* theirs) {
  if (theirs != nullptr) std::copy(field.begin(), field.end(), theirs);
}

/// A field of the caller as soon as its size is known: on failure it stays zero.
void zero_field(double* theirs, std::size_t cells) {
  if (theirs != nullptr) std::fill_n(theirs, cells, 0.0);
}

Fault solve_normal_problem(const wrc_exact_normal_problem* theirs, wrc_exact_normal_solution& solution) {
  wrc_exact_normal_problem ours;
  Fault fault = read(theirs, "problem", ours);
  if (!fault.failed()) fault = check_prescribed_of_plane(ours.prescribed, "problem");
  if (fault.failed()) return fault;
  const halfspace::Grid grid = grid_of(ours.grid);
  zero_field(solution.pressure, grid.cells());
  const patch::Material material = bodies_of(ours.wheel_material, ours.rail_material).material;
  halfspace::GapProblem problem;
  fault = read_field(MEMBER(wrc_exact_normal_problem, "gap"), ours.gap, grid.cells(), problem.gap);
  if (fault.failed()) return fault;
  problem.prescribed =
      ours.prescribed == WRC_PRESCRIBE_NORMAL_FORCE ? normal::Prescribed::load : normal::Prescribed::approach;
  problem.normal_force = ours.normal_force;
  problem.approach = ours.approach;
  problem.tolerance = ours.tolerance;
  problem.max_iterations = ours.max_iterations;
  Reporter reporter{.progress = ours.progress, .user = ours.user};
  problem.progress = reporter.callback();

  const halfspace::GapSolution found = halfspace::NormalSolver(grid, material).solve(problem);
  if (found.fault.failed()) return found.fault;
  solution.iterations = found.iterations;
  solution.approach = found.approach;
  solution.normal_force = found.normal_force;
  solution.peak_pressure = found.peak_pressure;
  solution.area = found.area;
  solution.residual = found.residual;
  copy_field(found.pressure, solution.pressure);
  return found.fault;
}

/// Steady rolling goes along x, steps go both ways and stand still.
enum class Ways { along_x, all };

/// A rolling problem as the solver takes it, `grid` being that of `ours`. The reporter must outlive it.
Fault rolling_problem(const wrc_exact_rolling_problem& ours, const halfspace::Grid& grid, Ways ways,
                      Reporter& reporter, halfspace::RollingProblem& problem) {
  const std::size_t cells = grid.cells();
  const wrc_creepage& creepage = ours.creepage;
  Fault fault = first_of(
      {read_field(MEMBER(wrc_exact_rolling_problem, "pressure"), ours.pressure, cells, problem.pressure),
       check(creepage.speed, "problem.creepage.speed", "m/s",
             ways == Ways::all ? -geometry::fastest_rolling : 0.0, geometry::fastest_rolling,
             "steady rolling is solved along x: mirror the problem"),
       check(creepage.reverse_share, "problem.creepage.reverse_share", "", 0.0, 0.0, nullptr,
             "the exact solver rolls one way only")});
  if (fault.failed()) return fault;
  if (ours.adhesion == WRC_ADHESION_FULL) {
    problem.friction.assign(1, 0.0);  // unused: no traction bound
  } else if (ours.friction != nullptr) {
    fault = read_field(MEMBER(wrc_exact_rolling_problem, "friction"), ours.friction, cells, problem.friction);
    if (fault.failed()) return fault;
  } else {
    fault = check(MEMBER(wrc_exact_rolling_problem, "coefficient"), "problem", ours.coefficient);
    if (fault.failed()) return fault;
    problem.friction.assign(1, ours.coefficient);
  }
  RETURN_IF_FAILED(read_layer(ours, "problem", problem.layer));
  if (ways == Ways::all && problem.layer.present()) {
    return Fault::unsupported("problem.layer_thickness, layer_yield",
                              "steps of rolling do not carry a layer: only steady rolling does");
  }
  if (ours.adhesion == WRC_ADHESION_FULL && ours.layer_yield > 0.0) {
    return Fault::unsupported("problem.layer_yield", {ours.layer_yield, "Pa"},
                              "with WRC_ADHESION_FULL nothing slides or flows");
  }
  problem.creepage = {creepage.longitudinal, creepage.lateral, creepage.spin};
  problem.adhesion =
      ours.adhesion == WRC_ADHESION_FULL ? halfspace::Adhesion::full : halfspace::Adhesion::coulomb;
  problem.collocation = ours.collocation == WRC_COLLOCATION_REFERENCE
                            ? halfspace::Collocation::reference_program
                            : halfspace::Collocation::quarter_point;
  problem.tolerance = ours.tolerance;
  problem.max_iterations = ours.max_iterations;
  problem.progress = reporter.callback();
  return {};
}

bool touching(const halfspace::RollingProblem& problem) {
  return std::any_of(problem.pressure.begin(), problem.pressure.end(), [](double p) { return p > 0.0; });
}

/// Reads a rolling problem, has it solved and fills in the solution; solve(ours, problem).
template <typename Solve>
Fault solve_rolling(const wrc_exact_rolling_problem* theirs, Ways ways, wrc_exact_rolling_solution& solution,
                    Solve&& solve) {
  wrc_exact_rolling_problem ours;
  Fault fault = read(theirs, "problem", ours);
  if (fault.failed()) return fault;
  const halfspace::Grid grid = grid_of(ours.grid);
  for (double* each : {solution.traction_x, solution.traction_y, solution.slip_x, solution.slip_y}) {
    zero_field(each, grid.cells());
  }
  Reporter reporter{.progress = ours.progress, .user = ours.user};
  halfspace::RollingProblem problem;
  fault = rolling_problem(ours, grid, ways, reporter, problem);
  if (fault.failed()) return fault;

  const halfspace::RollingSolution found = solve(ours, problem);
  if (found.fault.failed() || found.fault.status == WRC_FLAG_NO_CONTACT) return found.fault;
  const double speed = std::fabs(ours.creepage.speed);
  solution.iterations = found.iterations;
  solution.fx = found.forces.fx;
  solution.fy = found.forces.fy;
  solution.mz = found.forces.mz;
  solution.power = found.forces.power_per_speed * speed;
  solution.power_by_balance = found.power_by_balance * speed;
  solution.adhesion_fraction = found.forces.adhesion_fraction;
  solution.residual = found.residual;
  copy_field(found.traction_x, solution.traction_x);
  copy_field(found.traction_y, solution.traction_y);
  copy_field(found.slip_x, solution.slip_x);
  copy_field(found.slip_y, solution.slip_y);
  return found.fault;
}

/// Loads on one body: the pressure as it is; on the rail tractions are minus those on the wheel, which is
/// the rail's mirror image.
Fault read_loads(const wrc_exact_loads* theirs, halfspace::BodyLoads& loads, std::int32_t& body) {
  wrc_exact_loads ours;
  Fault fault = read(theirs, "loads", ours);
  if (fault.failed()) return fault;
  loads.grid = grid_of(ours.grid);
  loads.poisson = ours.poisson;
  body = ours.body;
  const std::size_t cells = loads.grid.cells();
  const auto read_one = [&](const Member& member, const double* values, halfspace::Field& field) {
    field.assign(cells, 0.0);
    if (values == nullptr) return Fault{};
    const Fault of_field = check_all(member, "loads", values, cells);
    if (!of_field.failed()) field.assign(values, values + cells);
    return of_field;
  };
  fault = first_of({read_one(MEMBER(wrc_exact_loads, "pressure"), ours.pressure, loads.pressure),
                    read_one(MEMBER(wrc_exact_loads, "traction_x"), ours.traction_x, loads.traction_x),
                    read_one(MEMBER(wrc_exact_loads, "traction_y"), ours.traction_y, loads.traction_y)});
  if (ours.body == WRC_BODY_RAIL) {
    for (halfspace::Field* field : {&loads.traction_x, &loads.traction_y})
      for (double& traction : *field) traction = 0.0 - traction;
  }
  return fault;
}

Fault find_stresses(const wrc_exact_loads* theirs, const double* points, std::uint32_t count,
                    double* stresses) {
  constexpr double most_points = 1e6, farthest = 1.0;
  Fault fault = check(count, "count", "", 1.0, most_points);
  if (fault.failed()) return fault;
  zero_field(stresses, 6 * static_cast<std::size_t>(count));
  if (points == nullptr) return Fault::null("points");
  if (stresses == nullptr) return Fault::null("stresses");
  halfspace::BodyLoads loads;
  std::int32_t body = WRC_BODY_RAIL;
  fault = read_loads(theirs, loads, body);
  for (std::uint32_t k = 0; k < 3 * count && !fault.failed(); ++k) {
    fault = check(points[k], "points", "m", k % 3 == 2 ? 0.0 : -farthest, farthest,
                  k % 3 == 2 ? "depths are positive in both bodies" : "did you pass mm?", "did you pass mm?");
    fault.index = static_cast<std::int32_t>(k);
  }
  if (fault.failed()) return fault;
  for (std::uint32_t k = 0; k < count; ++k) {
    const double* const point = points + 3 * std::size_t{k};
    const damage::Stress stress = halfspace::stress_at(loads, point[0], point[1], point[2]);
    const double six[6] = {stress.xx, stress.yy, stress.zz, stress.xy, stress.yz, stress.zx};
    std::copy_n(six, 6, stresses + 6 * std::size_t{k});
  }
  return {};
}

Fault find_largest_stresses(const wrc_exact_loads* theirs, const double* depths, std::uint32_t count,
                            wrc_stress_peaks* levels, wrc_stresses& stresses, Reporter& reporter) {
  constexpr double most_depths = 1000.0, deepest = 1.0;
  Fault fault = check(count, "count", "", 0.0, most_depths);
  if (fault.failed()) return fault;
  if (levels != nullptr) std::fill_n(levels, count, wrc_stress_peaks{});
  if (count > 0 && depths == nullptr) return Fault::null("depths");
  halfspace::BodyLoads loads;
  std::int32_t body = WRC_BODY_RAIL;
  fault = first_of(
      {read_loads(theirs, loads, body), check_all(depths, count, "depths", "m", 0.0, deepest,
                                                  "depths are positive in both bodies", "did you pass mm?")});
  if (fault.failed()) return fault;
  const halfspace::SubsurfaceSolution found =
      halfspace::search_stresses(loads, std::vector<double>(depths, depths + count), reporter.callback());
  if (found.fault.failed()) return found.fault;
  if (levels != nullptr) {
    for (std::size_t k = 0; k < count; ++k) levels[k] = peaks_of(found.levels[k]);
  }
  fill(found.surface, found.below, body, stresses);
  return found.fault;
}

Fault solve_rolling_problem(const wrc_exact_rolling_problem* theirs, wrc_exact_rolling_solution& solution) {
  return solve_rolling(theirs, Ways::along_x, solution,
                       [](const wrc_exact_rolling_problem& ours, const halfspace::RollingProblem& problem) {
                         halfspace::RollingSolution found;
                         found.fault = Fault::no_contact();
                         if (!touching(problem)) return found;
                         const PressedBodies bodies = bodies_of(ours.wheel_material, ours.rail_material);
                         return halfspace::RollingSolver(grid_of(ours.grid), bodies.material, {},
                                                         bodies.coupling)
                             .solve(problem);
                       });
}

/// The contact's own problem, exactly: all its strips with their pressure on one grid.
Fault check_contact(contact::Contact& contact, const wrc_exact_check_options& options,
                    wrc_exact_check_result& result) {
  if (contact.reached < contact::Stage::tangential) {
    return Fault::sequence("contact", "call wrc_planar_tangential or wrc_planar_step first");
  }
  if (!contact.touching) return Fault::no_contact();
  if (contact.rolling.reverse_share > 0.0) {
    return Fault::unsupported(
        "creepage.reverse_share", {contact.rolling.reverse_share, ""},
        "near standstill a contact rolls both ways: there is no exact solution of that");
  }
  Reporter reporter{.progress = options.progress, .user = options.user};
  halfspace::PlanarCheck found;
  const Fault fault = halfspace::check_planar_contact(
      contact, static_cast<int>(options.nx), static_cast<int>(options.ny), reporter.callback(), found);
  if (fault.failed()) return fault;
  result.fx = found.fx;
  result.fy = found.fy;
  result.mz = found.mz;
  result.power = found.power;
  result.adhesion_fraction = found.adhesion_fraction;
  result.force_error = found.force_error;
  result.power_error = found.power_error;
  return fault;
}

Fault read_options(const wrc_exact_wrench_options* theirs, halfspace::SurfaceOptions& options,
                   Reporter& reporter) {
  wrc_exact_wrench_options ours;
  const Fault fault = read_or_defaults(theirs, "options", ours);
  reporter.progress = ours.progress;
  reporter.user = ours.user;
  options.cell_x = ours.cell_x;
  options.cell_s = ours.cell_s;
  options.collocation = ours.collocation == WRC_COLLOCATION_REFERENCE
                            ? halfspace::Collocation::reference_program
                            : halfspace::Collocation::quarter_point;
  options.turned = ours.influence == WRC_INFLUENCE_TURNED;
  return fault;
}

Fault solve_exact_wheel(const contact::Contact& contact, const wrc_wheel_input* input,
                        const wrc_exact_wrench_options* options, wrc_wrench& ours) {
  contact::HostWheel hosted;
  halfspace::SurfaceOptions solver;
  Reporter reporter;
  const Fault reading = read_hosted(input, *contact::tangential_method(WRC_TANGENTIAL_STRIP_FASTSIM), hosted);
  Fault fault = first_of({reading, read_options(options, solver, reporter)});
  if (fault.failed()) return fault;
  if (hosted.friction.law.heated()) {
    return Fault::unsupported("input.friction.temperature_law", {WRC_TEMPERATURE_LAW_LINEAR, ""},
                              "the exact solution has no temperatures: set WRC_TEMPERATURE_LAW_NONE");
  }
  if (hosted.films.cells != nullptr) {
    return Fault::unsupported("input.friction.film_rows",
                              "films in rows are those of wrc_contact_wrench(): set film_numbers to 0");
  }
  contact::HostWrench result;
  std::int32_t regions = 0;
  fault = halfspace::solve_exact_wheel(contact, hosted, solver, reporter.callback(), result, regions);
  if (fault.failed()) return fault;
  keep_worst(fault, reading);
  ours = wrench_of(result);
  ours.region_count = regions;
  if (!hosted.load_prescribed) ours.z = hosted.z;
  return fault;
}

bool equal(const wrc_grid& a, const wrc_grid& b) {
  return a.nx == b.nx && a.ny == b.ny && a.dx == b.dx && a.dy == b.dy && a.x0 == b.x0 && a.y0 == b.y0;
}

bool equal(const wrc_material& a, const wrc_material& b) {
  return a.shear_modulus == b.shear_modulus && a.poisson == b.poisson;
}

Fault create_transient(const wrc_grid* grid, const wrc_material* wheel, const wrc_material* rail,
                       wrc_exact_transient*& handle) {
  wrc_grid cells;
  wrc_material of_wheel, of_rail;
  const Fault fault = first_of({read(grid, "grid", cells), read_or_defaults(wheel, "wheel", of_wheel),
                                read_or_defaults(rail, "rail", of_rail)});
  if (fault.failed()) return fault;
  const PressedBodies bodies = bodies_of(of_wheel, of_rail);
  handle =
      new wrc_exact_transient{transient_tag, cells, of_wheel, of_rail,
                              halfspace::TransientSolver(grid_of(cells), bodies.material, bodies.coupling)};
  return {};
}

Fault step_transient(wrc_exact_transient& handle, const wrc_exact_rolling_problem* theirs,
                     wrc_exact_rolling_solution& solution) {
  return solve_rolling(theirs, Ways::all, solution,
                       [&](const wrc_exact_rolling_problem& ours, const halfspace::RollingProblem& problem) {
                         const bool other_grid = !equal(ours.grid, handle.grid);
                         halfspace::RollingSolution found;
                         if (other_grid || !equal(ours.wheel_material, handle.wheel) ||
                             !equal(ours.rail_material, handle.rail)) {
                           found.fault = Fault::range(
                               other_grid ? "problem.grid" : "problem.wheel_material or rail_material",
                               "other than the handle was made with: its history does not fit");
                           return found;
                         }
                         // the way of rolling, as the sign of the speed has it
                         const double speed = ours.creepage.speed;
                         using halfspace::Rolled;
                         found = handle.solver.step(problem, speed > 0.0   ? Rolled::forwards
                                                             : speed < 0.0 ? Rolled::backwards
                                                                           : Rolled::at_rest);
                         if (!found.fault.failed() && !touching(problem)) found.fault = Fault::no_contact();
                         return found;
                       });
}

/// Only where the caller wants the fields; every number zero.
wrc_exact_normal_solution emptied(const wrc_exact_normal_solution& theirs) {
  wrc_exact_normal_solution ours = defaults<wrc_exact_normal_solution>();
  ours.pressure = theirs.pressure;
  return ours;
}
wrc_exact_rolling_solution emptied(const wrc_exact_rolling_solution& theirs) {
  wrc_exact_rolling_solution ours = defaults<wrc_exact_rolling_solution>();
  ours.traction_x = theirs.traction_x;
  ours.traction_y = theirs.traction_y;
  ours.slip_x = theirs.slip_x;
  ours.slip_y = theirs.slip_y;
  return ours;
}

/// `function`: the call's name, for the sentence.
template <typename Problem, typename Solution, typename Solve>
int32_t solve_into(const char* function, const Problem* problem, Solution* solution, char* text,
                   std::uint64_t size, Solve&& solve) {
  const Fault fault = guarded([&]() -> Fault {
    Solution theirs;
    Fault found = read(solution, "solution", theirs);
    if (found.failed()) return found;
    Solution ours = emptied(theirs);
    write(ours, solution);
    found = solve(problem, ours);
    ours.flags = found.all_flags();
    if (!found.failed()) write(ours, solution);
    return found;
  });
  return finish(function, fault, text, size);
}

}  // namespace
}  // namespace wrc::abi

namespace abi = wrc::abi;
using wrc::Fault;

extern "C" {

int32_t wrc_exact_gap(wrc_contact* contact, const wrc_grid* grid, double* gap) {
  wrc_grid theirs;
  const Fault fault = abi::read(grid, "grid", theirs);
  const wrc::halfspace::Grid ours = abi::grid_of(theirs);
  if (!fault.failed()) abi::zero_field(gap, ours.cells());
  if (!abi::valid(contact)) return WRC_ERROR_NULL;
  const wrc::contact::Contact& inside = *contact->contact;
  const Fault outcome = abi::guarded([&]() -> Fault {
    if (fault.failed()) return fault;
    if (gap == nullptr) return Fault::null("gap");
    if (inside.gap_rows == 0) {
      return Fault::sequence("gap", "call wrc_planar_geometry first, or hand over a gap");
    }
    wrc::halfspace::sample_gap(inside, ours, gap);
    return fault;
  });
  return abi::keep(*contact, __func__, outcome);
}

int32_t wrc_exact_normal(const wrc_exact_normal_problem* problem, wrc_exact_normal_solution* solution,
                         char* text, uint64_t size) {
  return abi::solve_into(__func__, problem, solution, text, size, abi::solve_normal_problem);
}

int32_t wrc_exact_rolling(const wrc_exact_rolling_problem* problem, wrc_exact_rolling_solution* solution,
                          char* text, uint64_t size) {
  return abi::solve_into(__func__, problem, solution, text, size, abi::solve_rolling_problem);
}

int32_t wrc_exact_stress(const wrc_exact_loads* loads, const double* points, uint32_t count, double* stresses,
                         char* text, uint64_t size) {
  const Fault fault = abi::guarded([&] { return abi::find_stresses(loads, points, count, stresses); });
  return abi::finish(__func__, fault, text, size);
}

int32_t wrc_exact_largest_stresses(const wrc_exact_loads* loads, const double* depths, uint32_t count,
                                   wrc_stress_peaks* levels, wrc_stresses* stresses, wrc_progress progress,
                                   void* user, char* text, uint64_t size) {
  const Fault cleared = abi::clear(stresses);
  const Fault fault = abi::guarded([&]() -> Fault {
    if (cleared.failed()) return cleared;
    abi::Reporter reporter{.progress = progress, .user = user};
    wrc_stresses ours = abi::empty<wrc_stresses>();
    const Fault found = abi::find_largest_stresses(loads, depths, count, levels, ours, reporter);
    if (!found.failed()) abi::write(ours, stresses);
    return found;
  });
  return abi::finish(__func__, fault, text, size);
}

int32_t wrc_exact_transient_create(const wrc_grid* grid, const wrc_material* wheel, const wrc_material* rail,
                                   wrc_exact_transient** transient, char* text, uint64_t size) {
  if (transient != nullptr) *transient = nullptr;
  const Fault fault = abi::guarded([&]() -> Fault {
    if (transient == nullptr) return Fault::null("transient");
    return abi::create_transient(grid, wheel, rail, *transient);
  });
  return abi::finish(__func__, fault, text, size);
}

int32_t wrc_exact_transient_step(wrc_exact_transient* transient, const wrc_exact_rolling_problem* problem,
                                 wrc_exact_rolling_solution* solution, char* text, uint64_t size) {
  return abi::solve_into(
      __func__, problem, solution, text, size,
      [&](const wrc_exact_rolling_problem* theirs, wrc_exact_rolling_solution& ours) -> Fault {
        if (!abi::is_transient(transient)) return Fault::null("transient");
        return abi::step_transient(*transient, theirs, ours);
      });
}

void wrc_exact_transient_destroy(wrc_exact_transient* transient) {
  if (!abi::is_transient(transient)) return;
  transient->tag = 0;
  delete transient;
}

int32_t wrc_exact_check(wrc_contact* contact, const wrc_exact_check_options* options,
                        wrc_exact_check_result* result) {
  return abi::solve_exactly(__func__, contact, result, "result",
                            [&](wrc::contact::Contact& of, wrc_exact_check_result& ours) -> Fault {
                              wrc_exact_check_options how;
                              const Fault fault = abi::read_or_defaults(options, "options", how);
                              if (fault.failed()) return fault;
                              return abi::check_contact(of, how, ours);
                            });
}

int32_t wrc_exact_wrench(wrc_contact* contact, const wrc_wheel_input* input,
                         const wrc_exact_wrench_options* options, wrc_wrench* wrench) {
  return abi::solve_exactly(__func__, contact, wrench, "wrench",
                            [&](const wrc::contact::Contact& of, wrc_wrench& ours) {
                              return abi::solve_exact_wheel(of, input, options, ours);
                            });
}

}  // extern "C"
