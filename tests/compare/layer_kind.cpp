#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "halfspace_cases.hpp"
#include "kinds.hpp"
#include "library.hpp"
#include "presets.hpp"
#include "test_config.hpp"
#include "wrc/wrc_offline.h"

namespace compare {
namespace {

struct Variant {
  const char* name;
  int32_t preset;  ///< of the method; < 0: the exact solver
};
const std::vector<Variant> every_variant = {
    {"strip", preset_strip_fastsim}, {"exact", -1}, {"fastsim", preset_fastsim}};

/// A row's rolling: curves without a friction law of their own have no moment, nor names of cases.
Rolling rolling_with_layer(const Csv& file, std::size_t row) {
  Rolling rolling;
  rolling.ellipse.a = 1e-3 * file(row, "a_mm");
  rolling.ellipse.b = 1e-3 * file(row, "b_mm");
  rolling.ellipse.normal_force = file(row, "Fn_N");
  rolling.creepage.longitudinal = file(row, "cx");
  rolling.creepage.lateral = file(row, "cy");
  rolling.creepage.spin = 1e3 * file(row, "phi_per_mm");
  wrc_friction& friction = rolling.friction;
  friction.coefficient = file(row, "mu");
  // the flexibility counts, not thickness and modulus by themselves
  if (const double flexibility = file(row, "flex_mm3_per_N"); flexibility > 0.0) {
    friction.layer_thickness = 1e-3;
    friction.layer_modulus = 1e-3 / (1e-9 * flexibility);
  }
  friction.layer_yield = 1e6 * file(row, "tau_c0_MPa");
  if (friction.layer_yield > 0.0) friction.layer_hardening = 1e9 * file(row, "k_tau_N_per_mm3");
  if (file.has("V_mps")) rolling.creepage.speed = file(row, "V_mps");
  if (file.has("fric_law") && file.text(row, "fric_law") != "Coulomb") {
    // mu(s) = .14 + .19 exp(-ln 2 s / 1.25 m/s)
    friction.speed_law = WRC_SPEED_LAW_EXPONENTIAL;
    friction.coefficient = 0.33;
    friction.kinetic_ratio = 0.14 / 0.33;
    friction.fall_rate = 0.69314718055994531 / 1.25;
  }
  return rolling;
}

struct Forces {
  double fx, fy, mz, power;
};

/// By a method of the planar stages, in real time.
Forces by_method(const wrc_config& config, const Rolling& rolling) {
  const Solver solver(config);
  wrc_planar_forces f{};
  const int32_t status =
      wrc_planar_tangential(solver.contact(), &rolling.ellipse, &rolling.creepage, &rolling.friction, &f);
  if (status < 0) throw std::runtime_error(solver.reason(status));
  return {f.fx, f.fy, f.mz, f.power};
}

/// By the exact solver, on so many cells each way. It has one friction: that at the sliding speed of a patch
/// that slides as a whole.
Forces exactly(const wrc_config& config, const Rolling& rolling, uint32_t cells) {
  const wrc_grid grid = grid_over(rolling.ellipse, cells, cells);
  const std::vector<double> pressure = pressure_at_centres(rolling.ellipse, grid);
  const wrc_friction& friction = rolling.friction;
  wrc_exact_rolling_problem problem = wrc_exact_rolling_problem_default();
  problem.wheel_material = config.wheel_material;
  problem.rail_material = config.rail_material;
  problem.grid = grid;
  problem.pressure = pressure.data();
  problem.coefficient = friction.coefficient;
  if (friction.speed_law == WRC_SPEED_LAW_EXPONENTIAL) {
    const double sliding = rolling.creepage.speed * std::fabs(rolling.creepage.longitudinal);
    problem.coefficient *=
        friction.kinetic_ratio + (1.0 - friction.kinetic_ratio) * std::exp(-friction.fall_rate * sliding);
  }
  problem.creepage = rolling.creepage;
  problem.layer_thickness = friction.layer_thickness;
  problem.layer_modulus = friction.layer_modulus;
  problem.layer_yield = friction.layer_yield;
  problem.layer_hardening = friction.layer_hardening;
  wrc_exact_rolling_solution s = sized<wrc_exact_rolling_solution>();
  char text[256];
  if (wrc_exact_rolling(&problem, &s, text, sizeof text) != WRC_OK) throw std::runtime_error(text);
  return {s.fx, s.fy, s.mz, s.power_by_balance};
}

}  // namespace

Report compare_layer(const Csv& file, const Names& only) {
  Report report;
  report.kind = "layer";
  report.rows = file.rows();
  // Cases are compared over mu N (moment: times sqrt(ab)), points of creep curves over N, curve by curve.
  const bool curves = file.has("curve");
  if (!curves) report.measures = {"force", "moment", "power"};
  for (std::size_t row = 0; curves && row < file.rows(); ++row) {
    const std::string& name = file.text(row, "curve");
    if (std::find(report.measures.begin(), report.measures.end(), name) == report.measures.end())
      report.measures.push_back(name);
  }
  report.default_variant = every_variant[0].name;
  for (const Variant& variant : chosen(every_variant, only)) {
    report.variants.emplace_back(variant.name);
    auto& errors = report.errors[variant.name];
    for (const std::string& measure : report.measures) errors[measure];
    for (std::size_t row = 0; row < file.rows(); ++row) {
      wrc_config config = test_config();
      config.wheel_material.shear_modulus = config.rail_material.shear_modulus = 1e6 * file(row, "G_MPa");
      config.wheel_material.poisson = config.rail_material.poisson = file(row, "nu");
      if (variant.preset >= 0) choose_tangential(config, variant.preset);
      const Rolling rolling = rolling_with_layer(file, row);
      Forces forces{};
      try {
        forces = variant.preset >= 0 ? by_method(config, rolling) : exactly(config, rolling, 96);
      } catch (const std::runtime_error& error) {
        report.fail(row, variant.name, error.what());
        continue;
      }
      const double load = rolling.ellipse.normal_force, limit = rolling.friction.coefficient * load;
      const double dx = forces.fx - file(row, "Fx_extrap_N");
      if (curves) {
        errors[file.text(row, "curve")].add(row, dx / load);
        continue;
      }
      errors["force"].add(row, std::hypot(dx, forces.fy - file(row, "Fy_extrap_N")) / limit);
      errors["moment"].add(row, (forces.mz - file(row, "Mz_extrap_Nm")) /
                                    (limit * std::sqrt(rolling.ellipse.a * rolling.ellipse.b)));
      errors["power"].add(row, forces.power / (rolling.creepage.speed * file(row, "P_work_W")) - 1.0);
    }
  }
  return report;
}

}  // namespace compare
