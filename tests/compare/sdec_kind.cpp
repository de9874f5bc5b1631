#include <cmath>
#include <string>
#include <vector>

#include "kinds.hpp"
#include "library.hpp"
#include "presets.hpp"
#include "test_config.hpp"

namespace compare {
namespace {

struct Variant {
  std::string name;
  int32_t preset, bound, flexibility;
};

struct Option {
  const char* name;
  int32_t value;
};

/// Every published method, and the FASTSIM variants with every bound and form of the flexibilities. Left out
/// because the numbers are the same here: the ellipsoidal bound, which on double ellipses is the elliptic
/// one, and modified FASTSIM, which between clean bodies is FASTSIM-EQ.L.
std::vector<Variant> every_variant() {
  constexpr Option bounds[] = {{"/parabolic", WRC_BOUND_PARABOLIC}, {"/elliptic", WRC_BOUND_ELLIPTIC}};
  constexpr Option forms[] = {{"", WRC_FLEXIBILITY_SEPARATE},
                              {"/single", WRC_FLEXIBILITY_SINGLE},
                              {"/blended", WRC_FLEXIBILITY_BLENDED}};
  std::vector<Variant> all;
  for (int32_t preset = 0; preset < tangential_methods; ++preset) {
    const auto& [identifier, name, method, slope_falls] = presets[preset];
    if (slope_falls) continue;
    if (method != WRC_TANGENTIAL_FASTSIM) {
      all.push_back({identifier, preset, WRC_BOUND_PARABOLIC, WRC_FLEXIBILITY_SEPARATE});
      continue;
    }
    for (const Option& bound : bounds)
      for (const Option& form : forms)
        all.push_back({std::string(identifier) + bound.name + form.name, preset, bound.value, form.value});
  }
  return all;
}

}  // namespace

Report compare_sdec(const Csv& file, const Names& only) {
  const wrc_config standard = test_config();
  Report report;
  report.kind = "sdec";
  report.rows = file.rows();
  // The reference's power is a sum over its cells and lies up to a third below what its own forces dissipate
  // by the energy balance of steady rolling; the truth on fine grids is near the balance. Both are compared.
  report.measures = {"force", "power", "power_balance"};
  for (const Variant& variant : chosen(every_variant(), only)) {
    report.variants.emplace_back(variant.name);
    if (variant.preset == preset_strip_fastsim) report.default_variant = variant.name;
    for (std::size_t row = 0; row < file.rows(); ++row) {
      wrc_config config = standard;
      choose_tangential(config, variant.preset);
      config.tangential.bound = variant.bound;
      config.tangential.flexibility = variant.flexibility;
      config.wheel_material.shear_modulus = config.rail_material.shear_modulus = 1e6 * file(row, "G_MPa");
      config.wheel_material.poisson = config.rail_material.poisson = file(row, "nu");
      const Solver solver(config);

      const Rolling rolling = rolling_of(file, row);
      wrc_planar_forces forces{};
      const int32_t status = wrc_planar_tangential(solver.contact(), &rolling.ellipse, &rolling.creepage,
                                                   &rolling.friction, &forces);
      if (status < 0) {
        report.fail(row, variant.name, solver.reason(status));
        continue;
      }
      const double limit = rolling.friction.coefficient * rolling.ellipse.normal_force;
      auto& errors = report.errors[variant.name];
      errors["force"].add(row,
                          std::hypot(forces.fx - file(row, "Fx_N"), forces.fy - file(row, "Fy_N")) / limit);
      // Where nearly all of the patch sticks, hardly any power is dissipated and its relative error says
      // nothing.
      errors["power"];
      errors["power_balance"];
      if (file(row, "adh_frac") < 0.9) {
        const wrc_creepage& creepage = rolling.creepage;
        const double balance = -(file(row, "Fx_N") * creepage.longitudinal +
                                 file(row, "Fy_N") * creepage.lateral + file(row, "Mz_Nm") * creepage.spin);
        errors["power"].add(row, forces.power / file(row, "P_W_at_1mps") - 1.0);
        errors["power_balance"].add(row, forces.power / balance - 1.0);
      }
    }
  }
  return report;
}

}  // namespace compare
