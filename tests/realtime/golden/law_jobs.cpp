/// What bends the creep curve, and its slopes: friction over place and sliding speed, a layer between the
/// bodies, damping of the approach, and the derivatives of the forces, with every tangential method.
#include "golden/plan.hpp"
#include "test_config.hpp"

namespace {

constexpr double zone_y[] = {-4e-3, 0.0, 0.0, 5e-3};
constexpr double zone_coefficient[] = {0.1, 0.3, 0.0, 0.4};

/// Friction number i: the speed laws in turn, every other time with zones, in the one frame and the other.
wrc_friction friction_number(int i, int32_t tangential) {
  wrc_friction friction = wrc_friction_default();
  friction.speed_law = i % 3;
  friction.slope_reduction = i % 4 == 3 ? 0.4 : 1.0;
  friction.slope_fall = slope_fall_for(tangential);
  friction.adhesion_reduction = i % 2 == 1 ? 0.7 : 1.0;
  friction.slip_reduction = i % 3 == 1 ? 0.2 : friction.adhesion_reduction;
  friction.zone_count = i % 2 == 1 ? 4 : 0;
  friction.zone_y = zone_y;
  friction.zone_coefficients = zone_coefficient;
  friction.zone_frame = i % 4 == 1 ? WRC_ZONES_RAIL_PROFILE : WRC_ZONES_CONTACT_FRAME;
  return friction;
}

/// One patch and two; every friction number; once in a while damped.
std::vector<Step> steps_with_laws(int32_t tangential) {
  std::vector<Step> steps;
  Numbers numbers(7);
  for (int i = 0; i < 12; ++i) {
    Step step;
    step.pose.lateral = i % 3 == 2 ? 5.1e-3 : numbers.between(-3e-3, 4e-3);
    step.load.normal_force = numbers.between(5e4, 1e5);
    step.load.prescribed = i % 4 == 2 ? WRC_PRESCRIBE_APPROACH : WRC_PRESCRIBE_NORMAL_FORCE;
    step.load.approach = 70e-6;
    step.load.approach_velocity = 0.5;
    step.load.damping = 0.2;
    step.creepage.longitudinal = numbers.between(-3e-3, 3e-3);
    step.creepage.lateral = numbers.between(-3e-3, 3e-3);
    step.creepage.spin = numbers.between(-0.6, 0.6);
    step.creepage.speed = 40.0;
    step.friction = friction_number(i, tangential);
    steps.push_back(step);
  }
  return steps;
}

/// The same with both factors.
std::vector<Step> with_temperature(std::vector<Step> steps) {
  for (std::size_t i = 0; i < steps.size(); ++i) {
    steps[i].friction.speed_law = i % 2 == 0 ? WRC_SPEED_LAW_EXPONENTIAL : WRC_SPEED_LAW_HYPERBOLIC;
    steps[i].friction.temperature_law = WRC_TEMPERATURE_LAW_LINEAR;
  }
  return steps;
}

void run_sensitivities(const std::vector<Step>& steps, wrc_contact* contact, Hash& hash) {
  for (const Step& step : steps) {
    wrc_planar_input input = wrc_planar_input_default();
    input.pose = step.pose;
    input.load = step.load;
    input.creepage = step.creepage;
    input.friction = step.friction;
    wrc_planar_output output = sized<wrc_planar_output>();
    wrc_planar_derivatives slopes = sized<wrc_planar_derivatives>();
    hash.add(wrc_planar_step(contact, &input, &output));
    hash.add(wrc_planar_tangential_derivatives(contact, &slopes));
    for (const auto& row : slopes.forces) {
      for (int k = 0; k < 5; ++k) hash.add(row[k]);
    }
  }
}

/// Rolling that is not steady: steps of all lengths, the patch and the creepages changing.
void run_memory(wrc_contact* contact, Hash& hash) {
  Numbers numbers(19);
  for (int i = 0; i < 40; ++i) {
    wrc_ellipse ellipse = sized<wrc_ellipse>();
    ellipse.a = numbers.between(5e-3, 6e-3);
    ellipse.b = numbers.between(4e-3, 5e-3);
    ellipse.psi = numbers.between(-0.4, 0.4);
    ellipse.normal_force = numbers.between(5e4, 1e5);
    wrc_creepage creepage = wrc_creepage_default();
    creepage.longitudinal = numbers.between(-3e-3, 3e-3);
    creepage.lateral = numbers.between(-3e-3, 3e-3);
    creepage.spin = numbers.between(-0.6, 0.6);
    const double length = i % 8 == 7 ? 0.2 : 0.005;
    wrc_friction friction = friction_number(i % 4 == 1 ? 0 : i, preset_strip_fastsim);
    friction.zone_frame = WRC_ZONES_CONTACT_FRAME;
    hash.add(wrc_planar_roll(contact, i % 5 == 0 ? 0.0 : numbers.between(0.0, length)));
    wrc_planar_forces forces{};
    hash.add(wrc_planar_tangential(contact, &ellipse, &creepage, &friction, &forces));
    hash_forces(forces, hash);
  }
}

}  // namespace

void add_laws(Plan& plan) {
  for (int32_t tangential = 0; tangential < tangential_methods; ++tangential) {
    wrc_config& config = plan.models.emplace_back(test_config());
    config.normal.method = WRC_NORMAL_EKP;
    choose_tangential(config, tangential);
    config.planar.strips = 26;
    config.planar.cells = 18;
    config.wheel = plan.profiles[0];
    config.rail = plan.profiles[1];
    const std::vector<Step> steps = steps_with_laws(tangential);
    plan.jobs.push_back({"friction", plan.models.size() - 1, steps, {}});
    if (gives_tractions(tangential))  // they heat
      plan.jobs.push_back({"friction factors", plan.models.size() - 1, with_temperature(steps), {}});
    plan.jobs.push_back(
        {"sensitivities", plan.models.size() - 1, {}, [steps](wrc_contact* contact, Hash& hash) {
           run_sensitivities(steps, contact, hash);
         }});
  }
  wrc_config& config = plan.models.emplace_back(test_config());
  config.planar.non_steady = 1;
  plan.jobs.push_back({"rolling with memory", plan.models.size() - 1, {}, run_memory});
}
