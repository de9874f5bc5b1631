/// Steps from a pose of the wheelset: every method, creepages up to full slip, grids that do not fill a
/// vector register.
#include <algorithm>

#include "golden/plan.hpp"
#include "test_config.hpp"

namespace {

Step at(double lateral, double roll, double yaw, double load) {
  Step step;
  step.pose.lateral = lateral;
  step.pose.roll = roll;
  step.pose.yaw = yaw;
  step.load.normal_force = load;
  step.creepage.longitudinal = 0.8e-3;
  step.creepage.lateral = -0.5e-3;
  step.creepage.spin = 0.3;
  step.friction.coefficient = 0.35;
  return step;
}

/// Centred, yawed, two patches, the flange root, the flange; then the approach prescribed, down to lift-off.
std::vector<Step> usual_poses() {
  std::vector<Step> steps = {at(0.0, 0.0, 0.0, 80e3),     at(-4e-3, 1e-3, -15e-3, 110e3),
                             at(3e-3, -2e-3, 8e-3, 60e3), at(5.1e-3, 0.0, 0.0, 80e3),
                             at(6.2e-3, 0.0, 5e-3, 95e3), at(7.1e-3, 0.0, 10e-3, 50e3)};
  for (double approach : {90e-6, 5e-6, 0.0}) {
    Step step = at(1e-3, 0.0, 2e-3, 0.0);
    step.load.prescribed = WRC_PRESCRIBE_APPROACH;
    step.load.approach = approach;
    steps.push_back(step);
  }
  return steps;
}

/// None, linear range, single components, all together, sliding nearly and altogether, extremes of the
/// ranges.
std::vector<Step> creepages() {
  const double given[][3] = {
      {0.0, 0.0, 0.0},       {1e-9, 0.0, 0.0},  {1e-3, 0.0, 0.0},     {-2e-3, 0.0, 0.0},
      {0.0, 1e-3, 0.0},      {0.0, -3e-3, 0.0}, {0.0, 0.0, 0.4},      {0.0, 0.0, -1.5},
      {6e-3, 0.0, 0.0},      {5e-2, 2e-2, 0.0}, {10.0, -10.0, 0.0},   {0.0, 0.0, 1000.0},
      {1e-300, 1e-308, 0.0}, {1e-3, 1e-3, 1.0}, {-1e-3, 4e-4, -0.05}, {3e-3, -2e-3, 5.0}};
  std::vector<Step> steps;
  Numbers numbers(1);
  for (const auto& nu : given) {
    Step step = at(0.5e-3, 0.0, 1e-3, 75e3);
    step.creepage.longitudinal = nu[0];
    step.creepage.lateral = nu[1];
    step.creepage.spin = nu[2];
    step.creepage.speed = 30.0;
    step.friction.coefficient = 0.3;
    steps.push_back(step);
  }
  for (int i = 0; i < 12; ++i) {
    // One by one: arguments of a call would be evaluated in an order of the compiler's choice.
    Step step = at(0.0, 0.0, 0.0, 0.0);
    step.pose.lateral = numbers.between(-4e-3, 5e-3);
    step.pose.yaw = numbers.between(-0.01, 0.01);
    step.load.normal_force = numbers.between(2e3, 2e5);
    step.creepage.longitudinal = numbers.between(-5e-3, 5e-3);
    step.creepage.lateral = numbers.between(-5e-3, 5e-3);
    step.creepage.spin = numbers.between(-1.0, 1.0);
    step.creepage.speed = numbers.between(0.0, 80.0);
    step.friction.coefficient = numbers.between(0.02, 0.9);
    steps.push_back(step);
  }
  return steps;
}

/// A model on S1002 and the benchmark's UIC60; further settings are the caller's.
wrc_config& add_model(Plan& plan) {
  if (plan.profiles.size() < 2) {
    plan.profiles.assign(2, sized<wrc_profile>());
    plan.profiles[0].kind = WRC_PROFILE_S1002;
    plan.profiles[1].kind = WRC_PROFILE_UIC60_BENCHMARK;
  }
  wrc_config& config = plan.models.emplace_back(test_config());
  config.wheel = plan.profiles[0];
  config.rail = plan.profiles[1];
  return config;
}

void add_job(Plan& plan, std::string group, std::vector<Step> steps) {
  plan.jobs.push_back({std::move(group), plan.models.size() - 1, std::move(steps), {}});
}

void add_methods(Plan& plan) {
  const std::vector<Step> poses = usual_poses();
  for (int32_t normal = 0; normal < normal_methods; ++normal) {
    wrc_config& config = add_model(plan);
    config.normal.method = normal;
    config.planar.regularisation = normal % 2;
    add_job(plan, std::string("normal ") + normal_names[normal], poses);
  }
  for (int32_t tangential = 0; tangential < tangential_methods; ++tangential) {
    std::vector<Step> few = {poses[0], poses[2], poses[3], poses[5]};
    for (Step& step : few) step.friction.slope_fall = slope_fall_for(tangential);
    const std::string group = std::string("tangential ") + presets[tangential].identifier;
    for (int32_t normal = 0; normal < normal_methods; ++normal) {
      wrc_config& config = add_model(plan);
      config.normal.method = normal;
      choose_tangential(config, tangential);
      config.planar.strips = 28;
      config.planar.cells = 16;
      config.planar.gap_rows = 128;
      add_job(plan, group, few);
    }
    for (int32_t bound : {WRC_BOUND_PARABOLIC, WRC_BOUND_ELLIPTIC}) {
      wrc_config& config = add_model(plan);
      config.normal.method = WRC_NORMAL_EKP;
      choose_tangential(config, tangential);
      config.tangential.bound = bound;
      if (wrc_config_check(&config, nullptr, 0) != WRC_OK)
        config.tangential.bound = WRC_BOUND_PARABOLIC;  // the method has a bound of its own
      config.planar.strips = 37;
      config.planar.cells = 21;
      add_job(plan, group, few);
    }
  }
}

/// A group for each, of the methods that know the choice.
void add_flexibilities(Plan& plan) {
  const std::vector<Step> steps = {at(0.0, 0.0, 0.0, 80e3), at(5.1e-3, 0.0, 4e-3, 80e3)};
  for (int32_t flexibility : {WRC_FLEXIBILITY_SINGLE, WRC_FLEXIBILITY_BLENDED}) {
    for (int32_t tangential = 0; tangential < tangential_methods; ++tangential) {
      wrc_config& config = add_model(plan);
      choose_tangential(config, tangential);
      config.tangential.flexibility = flexibility;
      if (wrc_config_check(&config, nullptr, 0) != WRC_OK) {
        plan.models.pop_back();
        continue;
      }
      add_job(plan, flexibility == WRC_FLEXIBILITY_SINGLE ? "flexibility single" : "flexibility blended",
              steps);
    }
  }
}

void add_creepages(Plan& plan) {
  const std::vector<Step> steps = creepages();
  for (int32_t tangential : {preset_strip_fastsim, preset_fastsim_sdec}) {
    wrc_config& config = add_model(plan);
    choose_tangential(config, tangential);
    config.wheel_material.poisson = config.rail_material.poisson =
        tangential == preset_strip_fastsim ? 0.28 : 0.25;
    // Contacts of one model, so that threads have something to share.
    for (std::size_t first = 0; first < steps.size(); first += 7)
      add_job(plan, "creepage",
              {steps.begin() + static_cast<std::ptrdiff_t>(first),
               steps.begin() + static_cast<std::ptrdiff_t>(std::min(first + 7, steps.size()))});
  }
}

void add_grids(Plan& plan) {
  const std::vector<Step> poses = usual_poses();
  for (const auto& [strips, cells] :
       {std::pair{4, 4}, {5, 7}, {7, 31}, {9, 8}, {17, 33}, {50, 60}, {64, 64}, {130, 5}}) {
    for (int32_t tangential : {preset_strip_fastsim, preset_fastsim_sdec}) {
      wrc_config& config = add_model(plan);
      choose_tangential(config, tangential);
      config.planar.strips = strips;
      config.planar.cells = cells;
      add_job(plan, "grids", {poses[0], poses[3]});
    }
  }
}

void add_warm_start(Plan& plan) {
  wrc_config& config = add_model(plan);
  config.planar.start = WRC_START_WARM;
  std::vector<Step> steps;
  for (int i = 0; i < 24; ++i) {
    Step step = at(0.3e-3 * i - 1e-3, 0.0, 0.4e-3 * i, 80e3 + 1e3 * (i % 5));
    if (i % 6 == 5) step.load.prescribed = WRC_PRESCRIBE_APPROACH;
    step.load.approach = i == 11 ? -1e-5 : 60e-6;  // apart once
    steps.push_back(step);
  }
  add_job(plan, "warm start", steps);
}

/// Points of the caller: a worn-looking wheel and rail of polynomials, given every 0.7 mm, and smoothed.
void add_profiles(Plan& plan) {
  const auto points = [&](double low, double high, auto&& height) -> const std::vector<double>& {
    std::vector<double>& list = plan.points.emplace_back();
    const int count = 171;
    for (int i = 0; i < count; ++i) list.push_back(low + (high - low) * i / (count - 1));
    for (int i = 0; i < count; ++i) list.push_back(height(list[static_cast<std::size_t>(i)]));
    return list;
  };
  const auto wheel_height = [](double y) { return y * (-0.025 + y * (0.4 - 20.0 * y)); };
  const auto rail_height = [](double y) { return y * y * (1.7 + y * (4.0 + 10e3 * y)); };
  for (double smoothing : {0.0, 5e-3}) {
    const std::vector<double>& on_wheel = points(-0.055, 0.055, wheel_height);
    const std::vector<double>& on_rail = points(-0.035, 0.035, rail_height);
    wrc_config& config = add_model(plan);
    for (const auto* list : {&on_wheel, &on_rail}) {
      wrc_profile& profile = list == &on_wheel ? config.wheel : config.rail;
      profile = sized<wrc_profile>();
      profile.kind = WRC_PROFILE_POINTS;
      profile.count = static_cast<uint32_t>(list->size() / 2);
      profile.y = list->data();
      profile.z = list->data() + profile.count;
      profile.smoothing = smoothing;
    }
    config.track.rail_inclination = 0.025;
    add_job(plan, "profiles",
            {at(0.0, 0.0, 0.0, 80e3), at(2e-3, 1e-3, -6e-3, 80e3), at(-3e-3, 0.0, 4e-3, 80e3)});
  }
  wrc_profile rail = sized<wrc_profile>();
  rail.kind = WRC_PROFILE_60E1;
  for (int32_t side : {WRC_SIDE_RIGHT, WRC_SIDE_LEFT}) {
    wrc_config& config = add_model(plan);
    config.rail = rail;
    config.track.rail_inclination = 0.025;
    const double sign = side == WRC_SIDE_RIGHT ? 1.0 : -1.0;
    add_job(plan, "profiles",
            {at(0.0, 0.0, 0.0, 80e3), at(4e-3 * sign, 0.0, 6e-3, 80e3), at(7e-3 * sign, 0.0, 0.0, 80e3)});
    plan.jobs.back().side = side;
  }
}

}  // namespace

void add_poses(Plan& plan) {
  add_methods(plan);
  add_flexibilities(plan);
  add_creepages(plan);
  add_grids(plan);
  add_warm_start(plan);
  add_profiles(plan);
}
