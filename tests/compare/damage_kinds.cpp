#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "halfspace_cases.hpp"
#include "kinds.hpp"
#include "library.hpp"
#include "test_config.hpp"
#include "wrc/wrc_offline.h"

namespace compare {
namespace {

/// A row's double ellipse; its load follows from the peak pressure.
wrc_ellipse ellipse_of(const Csv& file, std::size_t row) {
  const double pi = 3.14159265358979323846;
  wrc_ellipse ellipse = sized<wrc_ellipse>();
  ellipse.a = 1e-3 * file(row, "a_mm");
  ellipse.b = 1e-3 * file(row, "b_mm");
  ellipse.psi = file.has("psi") ? file(row, "psi") : 0.0;
  ellipse.normal_force = 2.0 / 3.0 * pi * ellipse.a * ellipse.b * 1e6 * file(row, "p0_MPa");
  return ellipse;
}

wrc_creepage creepage_of(const Csv& file, std::size_t row) {
  wrc_creepage creepage = wrc_creepage_default();
  creepage.longitudinal = file(row, "cx");
  creepage.lateral = file(row, "cy");
  creepage.spin = file(row, "phi_per_m");
  if (file.has("V_mps")) creepage.speed = file(row, "V_mps");
  return creepage;
}

wrc_heat_properties steel_of(const Csv& file, std::size_t row) {
  return {file(row, "lambda_W_mK"), file(row, "rho_kg_m3"), file(row, "cp_J_kgK"), {}};
}

/// Pressure, tractions and slip of a row by the exact solver, on cells of about `dx` and `dy`.
struct ExactFields {
  wrc_grid grid;
  std::vector<double> pressure, traction_x, traction_y, slip_x, slip_y;
};

ExactFields exact_fields(const Csv& file, std::size_t row, double dx, double dy) {
  const wrc_ellipse ellipse = ellipse_of(file, row);
  ExactFields fields;
  fields.grid = grid_over(ellipse, static_cast<uint32_t>(std::lround(2.0 * ellipse.a / dx)),
                          static_cast<uint32_t>(std::lround(2.0 * ellipse.b / dy)));
  fields.pressure = pressure_at_centres(ellipse, fields.grid);
  for (std::vector<double>* each : {&fields.traction_x, &fields.traction_y, &fields.slip_x, &fields.slip_y})
    each->assign(fields.pressure.size(), 0.0);
  wrc_exact_rolling_problem problem = wrc_exact_rolling_problem_default();
  problem.collocation = WRC_COLLOCATION_REFERENCE;
  problem.wheel_material = problem.rail_material = material_of(1e6 * file(row, "G_MPa"), file(row, "nu"));
  problem.grid = fields.grid;
  problem.pressure = fields.pressure.data();
  problem.coefficient = file(row, "mu");
  problem.creepage = creepage_of(file, row);
  wrc_exact_rolling_solution solution = sized<wrc_exact_rolling_solution>();
  solution.traction_x = fields.traction_x.data();
  solution.traction_y = fields.traction_y.data();
  solution.slip_x = fields.slip_x.data();
  solution.slip_y = fields.slip_y.data();
  char text[256];
  const int32_t status = wrc_exact_rolling(&problem, &solution, text, sizeof text);
  if (status < 0) throw std::runtime_error(text);
  return fields;
}

wrc_stresses exact_stresses(const Csv& file, std::size_t row) {
  const ExactFields fields = exact_fields(file, row, 1e-3 * file(row, "dx_mm"), 1e-3 * file(row, "dy_mm"));
  wrc_exact_loads loads = wrc_exact_loads_default();
  loads.poisson = file(row, "nu");
  loads.grid = fields.grid;
  loads.pressure = fields.pressure.data();
  loads.traction_x = fields.traction_x.data();
  loads.traction_y = fields.traction_y.data();
  wrc_stresses stresses = sized<wrc_stresses>();
  char text[256];
  const int32_t status =
      wrc_exact_largest_stresses(&loads, nullptr, 0, nullptr, &stresses, nullptr, nullptr, text, sizeof text);
  if (status < 0) throw std::runtime_error(text);
  return stresses;
}

/// How far a depth is from that of the reference [mm]. Where the largest inside and at the surface differ by
/// less than 3 %, either place counts.
double depth_error(const wrc_stress_peak& surface, const wrc_stress_peak& below, double reference) {
  const double at_surface = std::fabs(reference), inside = std::fabs(1e3 * below.depth - reference);
  const bool alike = std::fabs(surface.stress - below.stress) < 0.03 * std::max(surface.stress, below.stress);
  if (alike) return std::min(at_surface, inside);
  return surface.stress > below.stress ? at_surface : inside;
}

/// Depths at which the real-time call looks.
constexpr double depth_shares[] = {0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.75, 0.95, 1.2};

wrc_stresses strip_stresses(const Csv& file, std::size_t row) {
  wrc_config config = test_config();
  config.wheel_material.shear_modulus = config.rail_material.shear_modulus = 1e6 * file(row, "G_MPa");
  config.wheel_material.poisson = config.rail_material.poisson = file(row, "nu");
  const Solver solver(config);
  const wrc_ellipse ellipse = ellipse_of(file, row);
  const wrc_creepage creepage = creepage_of(file, row);
  wrc_friction friction = wrc_friction_default();
  friction.coefficient = file(row, "mu");
  int32_t status = wrc_planar_tangential(solver.contact(), &ellipse, &creepage, &friction, nullptr);
  std::vector<double> depths;
  for (const double share : depth_shares) depths.push_back(share * std::min(ellipse.a, ellipse.b));
  wrc_stresses stresses = sized<wrc_stresses>();
  if (status >= 0)
    status = wrc_contact_stresses(solver.contact(), WRC_ALL_REGIONS, WRC_BODY_RAIL, depths.data(),
                                  static_cast<uint32_t>(depths.size()), nullptr, &stresses);
  if (status < 0) throw std::runtime_error(solver.reason(status));
  return stresses;
}

struct StressVariant {
  const char* name;
  wrc_stresses (*find)(const Csv&, std::size_t row);
};
const std::vector<StressVariant> stress_variants = {{"strip", strip_stresses}, {"exact", exact_stresses}};

/// Largest rise of the temperature [K].
double exact_temperature(const Csv& file, std::size_t row) {
  const ExactFields fields = exact_fields(file, row, 1e-3 * file(row, "dx_mm"), 1e-3 * file(row, "dy_mm"));
  const double speed = file(row, "V_mps");
  const wrc_heat_properties steel = steel_of(file, row);
  double largest = 0.0;
  for (uint32_t j = 0; j < fields.grid.ny; ++j) {
    std::vector<double> power, rise;  // of the row's cells from the leading edge on
    for (uint32_t i = fields.grid.nx; i-- > 0;) {
      const std::size_t k = std::size_t{j} * fields.grid.nx + i;
      if (fields.pressure[k] <= 0.0) continue;
      power.push_back(-speed *
                      (fields.traction_x[k] * fields.slip_x[k] + fields.traction_y[k] * fields.slip_y[k]));
    }
    if (power.empty()) continue;
    rise.resize(power.size());
    if (wrc_flash_temperature(static_cast<uint32_t>(power.size()), fields.grid.dx, power.data(), speed,
                              &steel, &steel, rise.data()) < 0)
      throw std::runtime_error("wrc_flash_temperature failed");
    largest = std::max(largest, *std::max_element(rise.begin(), rise.end()));
  }
  return largest;
}

double strip_temperature(const Csv& file, std::size_t row) {
  wrc_config config = test_config();
  config.wheel_material.shear_modulus = config.rail_material.shear_modulus = 1e6 * file(row, "G_MPa");
  config.wheel_material.poisson = config.rail_material.poisson = file(row, "nu");
  config.wheel_heat = config.rail_heat = steel_of(file, row);
  const Solver solver(config);
  const wrc_ellipse ellipse = ellipse_of(file, row);
  const wrc_creepage creepage = creepage_of(file, row);
  wrc_friction friction = wrc_friction_default();
  friction.coefficient = file(row, "mu");
  int32_t status = wrc_planar_tangential(solver.contact(), &ellipse, &creepage, &friction, nullptr);
  wrc_temperature temperature = sized<wrc_temperature>();
  if (status >= 0) status = wrc_contact_temperature(solver.contact(), WRC_ALL_REGIONS, nullptr, &temperature);
  if (status < 0) throw std::runtime_error(solver.reason(status));
  return temperature.rise;
}

struct TemperatureVariant {
  const char* name;
  double (*find)(const Csv&, std::size_t row);
};
const std::vector<TemperatureVariant> temperature_variants = {{"strip", strip_temperature},
                                                              {"exact", exact_temperature}};

}  // namespace

Report compare_temperature(const Csv& file, const Names& only) {
  Report report;
  report.kind = "temperature";
  report.rows = file.rows();
  report.measures = {"temperature"};
  report.default_variant = temperature_variants[0].name;
  for (const TemperatureVariant& variant : chosen(temperature_variants, only)) {
    report.variants.emplace_back(variant.name);
    for (std::size_t row = 0; row < file.rows(); ++row) {
      try {
        report.errors[variant.name]["temperature"].add(row,
                                                       variant.find(file, row) / file(row, "dT_max_K") - 1.0);
      } catch (const std::runtime_error& why) {
        report.fail(row, variant.name, why.what());
      }
    }
  }
  return report;
}

Report compare_subsurface(const Csv& file, const Names& only) {
  Report report;
  report.kind = "subsurf";
  report.rows = file.rows();
  // stress: vm_max and tau_max in one sample, as the larger of the two errors; then each.
  report.measures = {"stress", "depth", "vm_max", "tau_max", "vm_surf", "s1_max", "s1_surf"};
  report.units["depth"] = "mm";
  report.default_variant = stress_variants[0].name;
  for (const StressVariant& variant : chosen(stress_variants, only)) {
    report.variants.emplace_back(variant.name);
    for (std::size_t row = 0; row < file.rows(); ++row) {
      try {
        const wrc_stresses found = variant.find(file, row);
        const auto error = [&](double stress, const char* column) {
          return stress / (1e6 * file(row, column)) - 1.0;
        };
        auto& errors = report.errors[variant.name];
        const double mises = error(found.largest.von_mises.stress, "vm_max_MPa");
        const double shear = error(found.largest.shear.stress, "tau_max_MPa");
        errors["stress"].add(row, std::fabs(mises) > std::fabs(shear) ? mises : shear);
        errors["vm_max"].add(row, mises);
        errors["tau_max"].add(row, shear);
        errors["vm_surf"].add(row, error(found.surface.von_mises.stress, "vm_surf_MPa"));
        errors["s1_max"].add(row, error(found.largest.tension.stress, "s1_max_MPa"));
        errors["s1_surf"].add(row, error(found.surface.tension.stress, "s1_surf_MPa"));
        errors["depth"].add(
            row, std::max(depth_error(found.surface.von_mises, found.below.von_mises, file(row, "vm_z_mm")),
                          depth_error(found.surface.shear, found.below.shear, file(row, "tau_z_mm"))));
      } catch (const std::runtime_error& why) {
        report.fail(row, variant.name, why.what());
      }
    }
  }
  return report;
}

}  // namespace compare
