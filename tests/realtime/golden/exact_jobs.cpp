/// The exact half-space solver behind wrc_offline.h, on coarse grids: gap, pressure, rolling, steps,
/// stresses, the check of a contact, a wheel on a rail. Fractions of progress are hashed, too.
#include <functional>
#include <string>
#include <vector>

#include "along_track.hpp"
#include "check_rail_points.hpp"
#include "golden/plan.hpp"

namespace {

using Field = std::vector<double>;

int32_t hash_progress(double fraction, void* hash) {
  static_cast<Hash*>(hash)->add(fraction);
  return 0;
}

void hash_field(const Field& field, Hash& hash) {
  for (const double value : field) hash.add(value);
}

/// Materials of one problem: alike, or a softer rail, so that normal and tangential problem are coupled.
template <typename Problem>
Problem problem_of(Problem problem, bool unlike, const wrc_grid& grid, Hash& hash) {
  problem = of_the_papers_steel(problem);
  if (unlike) problem.rail_material.shear_modulus = 5e10;
  problem.grid = grid;
  problem.progress = hash_progress;
  problem.user = &hash;
  return problem;
}

/// Rectangular cells around a contact of 12 x 10 mm; numbers of cells with the factors 2, 3 and 5.
wrc_grid cells_of(uint32_t nx, uint32_t ny) {
  wrc_grid grid = sized<wrc_grid>();
  grid.nx = nx;
  grid.ny = ny;
  grid.dx = 18e-3 / nx;
  grid.dy = 15e-3 / ny;
  grid.x0 = -9e-3 + 0.5 * grid.dx;
  grid.y0 = -7.5e-3 + 0.5 * grid.dy;
  return grid;
}

/// A paraboloid with a ripple across.
Field gap_of(const wrc_grid& grid) {
  Field gap;
  for (uint32_t j = 0; j < grid.ny; ++j) {
    for (uint32_t i = 0; i < grid.nx; ++i) {
      const double x = grid.x0 + i * grid.dx, y = grid.y0 + j * grid.dy;
      gap.push_back(x * x / 0.92 + y * y * (1.5 + 1e5 * y * y) + (j % 3 == 0 ? 2e-6 : 0.0));
    }
  }
  return gap;
}

/// Pressure of the gap's contact under a load.
Field pressure_on(const wrc_grid& grid, bool unlike, double load, Hash& hash) {
  const Field gap = gap_of(grid);
  Field pressure(gap.size());
  wrc_exact_normal_problem problem = problem_of(wrc_exact_normal_problem_default(), unlike, grid, hash);
  problem.gap = gap.data();
  problem.normal_force = load;
  wrc_exact_normal_solution solution = sized<wrc_exact_normal_solution>();
  solution.pressure = pressure.data();
  hash.add(wrc_exact_normal(&problem, &solution, nullptr, 0));
  hash.add(solution.approach);
  return pressure;
}

void run_normal(wrc_contact*, Hash& hash) {
  for (int i = 0; i < 6; ++i) {
    const wrc_grid grid = cells_of(20 + static_cast<uint32_t>(5 * (i % 3)), i == 5 ? 9 : 24);
    const Field gap = gap_of(grid);
    Field pressure(gap.size());
    wrc_exact_normal_problem problem = problem_of(wrc_exact_normal_problem_default(), i % 2 == 1, grid, hash);
    problem.gap = gap.data();
    problem.normal_force = 7e4 + 3e4 * i;  // the last flow over the grid's border
    if (i == 2) {
      problem.prescribed = WRC_PRESCRIBE_APPROACH;
      problem.normal_force = 0.0;
      problem.approach = 6e-5;
    }
    if (i == 3) problem.max_iterations = 5;
    wrc_exact_normal_solution solution = sized<wrc_exact_normal_solution>();
    solution.pressure = pressure.data();
    hash.add(wrc_exact_normal(&problem, &solution, nullptr, 0));
    hash.add(solution.iterations);
    for (double number :
         {solution.approach, solution.normal_force, solution.peak_pressure, solution.area, solution.residual})
      hash.add(number);
    hash_field(pressure, hash);
  }
}

/// Results of rolling with their fields.
class Rolled {
 public:
  explicit Rolled(const wrc_grid& grid) {
    double** const theirs[] = {&solution.traction_x, &solution.traction_y, &solution.slip_x,
                               &solution.slip_y};
    for (int k = 0; k < 4; ++k) {
      fields_[k].resize(std::size_t{grid.nx} * grid.ny);
      *theirs[k] = fields_[k].data();
    }
  }
  void add(int32_t status, Hash& hash) const {
    hash.add(status);
    hash.add(solution.iterations);
    for (double number : {solution.fx, solution.fy, solution.mz, solution.power, solution.power_by_balance,
                          solution.adhesion_fraction, solution.residual})
      hash.add(number);
    for (const Field& field : fields_) hash_field(field, hash);
  }
  const Field& traction_x() const { return fields_[0]; }
  const Field& traction_y() const { return fields_[1]; }

  wrc_exact_rolling_solution solution = sized<wrc_exact_rolling_solution>();

 private:
  Field fields_[4];
};

/// Both laws of adhesion and places of collocation, friction that changes across the cells, unlike materials.
void run_rolling(wrc_contact*, Hash& hash) {
  for (int i = 0; i < 6; ++i) {
    const wrc_grid grid = cells_of(i == 5 ? 48 : 22, i == 5 ? 40 : 18);
    const bool unlike = i % 2 == 1;
    const Field pressure = pressure_on(grid, unlike, 8e4, hash);
    Field friction;
    for (std::size_t k = 0; k < pressure.size(); ++k) friction.push_back(k % grid.nx < 9 ? 0.35 : 0.25);
    wrc_exact_rolling_problem problem = problem_of(wrc_exact_rolling_problem_default(), unlike, grid, hash);
    problem.pressure = pressure.data();
    if (i == 2 || i == 3) problem.adhesion = WRC_ADHESION_FULL;
    if (i >= 3) problem.collocation = WRC_COLLOCATION_REFERENCE;
    if (i == 1 || i == 4) problem.friction = friction.data();
    if (i == 4) problem.max_iterations = 2;
    problem.creepage.longitudinal = 1e-3 * (i - 2);
    problem.creepage.lateral = 0.6e-3;
    problem.creepage.spin = -0.3;
    problem.creepage.speed = 30.0;
    Rolled rolled(grid);
    const int32_t status = wrc_exact_rolling(&problem, &rolled.solution, nullptr, 0);
    rolled.add(status, hash);
  }
}

/// Step by step: from nothing, under a load that changes, out of contact and into it again.
void run_steps(wrc_contact*, Hash& hash) {
  for (const bool unlike : {false, true}) {
    const wrc_grid grid = cells_of(20, 15);
    const Field pressure = pressure_on(grid, unlike, 8e4, hash), none(pressure.size(), 0.0);
    wrc_exact_rolling_problem problem = problem_of(wrc_exact_rolling_problem_default(), unlike, grid, hash);
    wrc_exact_transient* bodies = nullptr;
    hash.add(wrc_exact_transient_create(&grid, &problem.wheel_material, &problem.rail_material, &bodies,
                                        nullptr, 0));
    for (int k = 0; k < 4; ++k) {
      problem.pressure = k == 2 ? none.data() : pressure.data();
      problem.coefficient = k == 3 ? 0.2 : 0.3;
      problem.creepage.longitudinal = 1.2e-3;
      problem.creepage.spin = k == 1 ? 0.4 : 0.1;
      problem.creepage.speed = 10.0;
      Rolled rolled(grid);
      const int32_t status = wrc_exact_transient_step(bodies, &problem, &rolled.solution, nullptr, 0);
      rolled.add(status, hash);
    }
    wrc_exact_transient_destroy(bodies);
  }
}

void hash_peaks(const wrc_stress_peaks& peaks, Hash& hash) {
  for (const wrc_stress_peak& peak : {peaks.von_mises, peaks.shear, peaks.tension})
    for (double number : {peak.stress, peak.x, peak.y, peak.depth}) hash.add(number);
}

/// In both bodies, at points and over depths.
void run_exact_stresses(wrc_contact*, Hash& hash) {
  const wrc_grid grid = cells_of(12, 10);
  const Field pressure = pressure_on(grid, false, 6e4, hash);
  wrc_exact_rolling_problem problem = problem_of(wrc_exact_rolling_problem_default(), false, grid, hash);
  problem.pressure = pressure.data();
  problem.creepage.longitudinal = 2e-3;
  problem.creepage.speed = 20.0;
  Rolled rolled(grid);
  const int32_t status = wrc_exact_rolling(&problem, &rolled.solution, nullptr, 0);
  rolled.add(status, hash);
  wrc_exact_loads loads = wrc_exact_loads_default();
  loads.grid = grid;
  loads.pressure = pressure.data();
  loads.traction_x = rolled.traction_x().data();
  loads.traction_y = rolled.traction_y().data();
  const double points[] = {1e-3, 2e-3, 0.0, -3e-3, 0.5e-3, 1e-3, 0.3e-3, -2e-3, 4e-3};
  const double depths[] = {0.0, 1e-3, 5e-3};
  for (const int32_t body : {WRC_BODY_RAIL, WRC_BODY_WHEEL}) {
    loads.body = body;
    double stresses[3 * 6] = {};
    hash.add(wrc_exact_stress(&loads, points, 3, stresses, nullptr, 0));
    for (double number : stresses) hash.add(number);
    wrc_stress_peaks levels[3] = {};
    wrc_stresses found = sized<wrc_stresses>();
    hash.add(wrc_exact_largest_stresses(&loads, depths, 3, levels, &found, hash_progress, &hash, nullptr, 0));
    for (const wrc_stress_peaks& level : levels) hash_peaks(level, hash);
    hash_peaks(found.surface, hash);
    hash_peaks(found.below, hash);
  }
}

/// A contact's true gap, and its forces against the exact ones of the same pressure.
void run_check(wrc_contact* contact, Hash& hash) {
  const wrc_grid grid = cells_of(9, 11);
  Field gap(std::size_t{grid.nx} * grid.ny);
  for (int i = 0; i < 4; ++i) {
    wrc_planar_input input = wrc_planar_input_default();
    input.pose.lateral = 2.2e-3 * i;
    input.pose.yaw = 5e-3 * (i - 1);
    input.load.normal_force = 9e4;
    input.creepage.longitudinal = 1.5e-3;
    input.creepage.lateral = -0.4e-3;
    input.creepage.spin = -0.4;
    input.creepage.speed = i == 2 ? -30.0 : 55.0;  // backwards, by the mirror
    if (i == 3) input.friction.slope_reduction = 0.6;
    hash.add(wrc_planar_step(contact, &input, nullptr));
    hash.add(wrc_exact_gap(contact, &grid, gap.data()));
    hash_field(gap, hash);
    wrc_exact_check_options options = wrc_exact_check_options_default();
    options.nx = 20;
    options.ny = 16;
    options.progress = hash_progress;
    options.user = &hash;
    wrc_exact_check_result found = sized<wrc_exact_check_result>();
    hash.add(wrc_exact_check(contact, &options, &found));
    for (double number : {found.fx, found.fy, found.mz, found.power, found.adhesion_fraction,
                          found.force_error, found.power_error})
      hash.add(number);
  }
}

/// The exact wrench of some of the poses; `place`: where along the track and round the wheel.
void run_exact_wheels(wrc_contact* right, wrc_contact* left, Hash& hash, const std::vector<int>& poses,
                      const std::function<void(int, Numbers&, wrc_wheel_input&)>& place) {
  Numbers numbers(7);
  for (const int i : poses) {
    wrc_wheel_input input = wheel_on_rail(i, numbers);
    if (input.prescribed == WRC_PRESCRIBE_HEIGHT) input.wheel.z = 0.35e-3;
    place(i, numbers, input);
    wrc_exact_wrench_options options = wrc_exact_wrench_options_default();
    options.cell_x = 1e-3;
    options.cell_s = 2e-3;
    if (i % 4 == 1) options.collocation = WRC_COLLOCATION_REFERENCE;
    if (i % 5 == 3) options.influence = WRC_INFLUENCE_PLAIN;
    options.progress = hash_progress;
    options.user = &hash;
    wrc_wrench wrench = sized<wrc_wrench>();
    hash.add(wrc_exact_wrench(i % 2 == 0 ? right : left, &input, &options, &wrench));
    for (const double* each : {wrench.force, wrench.moment, wrench.rail_moment})
      for (int k = 0; k < 3; ++k) hash.add(each[k]);
    hash.add(wrench.iterations);
    hash.add(wrench.region_count);
    for (double number : {wrench.z, wrench.normal_force, wrench.area, wrench.peak_pressure, wrench.power,
                          wrench.steepest_angle})
      hash.add(number);
  }
}

/// Zones on either profile and friction that falls with the speed.
void change_friction(int i, Numbers&, wrc_wheel_input& input) {
  static constexpr double zone_y[] = {-0.05, -0.01, 0.0, 0.02}, zone_coefficient[] = {0.1, 0.2, 0.4, 0.3};
  if (i % 3 == 1) {
    input.friction.zone_count = 4;
    input.friction.zone_y = zone_y;
    input.friction.zone_coefficients = zone_coefficient;
    input.friction.zone_frame = i % 2 == 0 ? WRC_ZONES_WHEEL_PROFILE : WRC_ZONES_RAIL_PROFILE;
  }
  if (i % 3 == 2) input.friction.speed_law = WRC_SPEED_LAW_EXPONENTIAL;
  if (i % 4 == 3) input.friction.slope_reduction = 0.7;
}

void move_along_track(int, Numbers& numbers, wrc_wheel_input& input) {
  input.distance = numbers.between(-0.2, 4.2);
  input.angle = numbers.between(-0.1, 0.1);
  const double fallen = input.distance - 1.0;
  if (fallen > 0.0) input.wheel.z += fallen < 2.0 ? 0.004 * fallen : 0.008;
}

void move_on_roller(int, Numbers& numbers, wrc_wheel_input& input) {
  input.distance = numbers.between(-5e-3, 5e-3);
  input.roller_rate = -input.wheel.angular_velocity[1] * numbers.between(0.99, 1.01);
}

void move_aslant(int, Numbers& numbers, wrc_wheel_input& input) {
  input.rail.y_slope = numbers.between(-0.01, 0.01);
  input.rail.z_slope = numbers.between(-0.01, 0.01);
}

void move_to_check_rail(int i, Numbers& numbers, wrc_wheel_input& input) {
  input.wheel.reference = WRC_REFERENCE_WHEELSET;
  input.wheel.y = (i % 2 == 0 ? -1.0 : 1.0) * numbers.between(4e-3, 6e-3);
}

}  // namespace

void add_exact(Plan& plan) {
  const auto model_of = [&plan](const std::function<void(wrc_config&)>& change) {
    wrc_config& config = plan.models.emplace_back(test_config());
    config.wheel = plan.profiles[0];
    config.rail = plan.profiles[1];
    change(config);
    return plan.models.size() - 1;
  };
  const auto add_wheels = [&plan](const char* group, std::size_t model, const std::vector<int>& poses,
                                  const auto& place) {
    plan.jobs.push_back(
        {group, model, {}, {}, [poses, place](wrc_contact* right, wrc_contact* left, Hash& hash) {
           run_exact_wheels(right, left, hash, poses, place);
         }});
  };
  static const AlongTrackBodies bodies;
  static const CheckRailPoints points;
  const std::size_t plain = model_of([](wrc_config&) {});
  plan.jobs.push_back({"exact normal", plain, {}, run_normal});
  plan.jobs.push_back({"exact rolling", plain, {}, run_rolling});
  plan.jobs.push_back({"exact rolling, step by step", plain, {}, run_steps});
  plan.jobs.push_back({"exact stresses", plain, {}, run_exact_stresses});
  plan.jobs.push_back({"exact check", plain, {}, run_check});
  add_wheels("exact wheel on rail", plain, {0, 1, 2, 3, 8}, change_friction);
  const std::size_t unlike = model_of([](wrc_config& config) { config.rail_material.shear_modulus = 5e10; });
  add_wheels("exact wheel on rail, unlike materials", unlike, {1, 2}, change_friction);
  const std::size_t along = model_of([](wrc_config& config) {
    config.wheel.kind = WRC_PROFILE_S1002;
    config.rail.kind = WRC_PROFILE_60E1;
    config.track.rail_inclination = 0.025;
    bodies.give(config);
  });
  add_wheels("exact wheel along the track", along, {2, 6}, move_along_track);
  add_wheels("exact wheel on a roller", model_of([](wrc_config& config) { config.roller_curvature = 2.0; }),
             {2, 3}, move_on_roller);
  add_wheels("exact wheel on a rail aslant", plain, {2, 3}, move_aslant);
  const std::size_t guided = model_of([](wrc_config& config) {
    config.check_rail.profile = points.profile();
    config.check_rail.y = -0.0813;
    config.check_rail.z = -0.02;
  });
  add_wheels("exact wheel at a check rail", guided, {1, 2}, move_to_check_rail);
}
