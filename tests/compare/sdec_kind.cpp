#include <cmath>

#include "kinds.hpp"
#include "library.hpp"

namespace compare {
namespace {

struct Variant {
  const char* name;
  int32_t method, bound;
};

constexpr Variant variants[] = {
    {"strip_fastsim", WRC_TANGENTIAL_STRIP_FASTSIM, WRC_BOUND_PARABOLIC},
    {"fastsim_sdec/parabolic", WRC_TANGENTIAL_FASTSIM_SDEC, WRC_BOUND_PARABOLIC},
    {"fastsim_sdec/elliptic", WRC_TANGENTIAL_FASTSIM_SDEC, WRC_BOUND_ELLIPTIC},
    {"fastsim_eql/parabolic", WRC_TANGENTIAL_FASTSIM_EQL, WRC_BOUND_PARABOLIC},
    {"fastsim_eql/elliptic", WRC_TANGENTIAL_FASTSIM_EQL, WRC_BOUND_ELLIPTIC},
    {"fastsim_eqe/parabolic", WRC_TANGENTIAL_FASTSIM_EQE, WRC_BOUND_PARABOLIC},
    {"fastsim_eqe/elliptic", WRC_TANGENTIAL_FASTSIM_EQE, WRC_BOUND_ELLIPTIC},
    {"fastsim/parabolic", WRC_TANGENTIAL_FASTSIM, WRC_BOUND_PARABOLIC},
    {"fastsim/elliptic", WRC_TANGENTIAL_FASTSIM, WRC_BOUND_ELLIPTIC},
    {"table", WRC_TANGENTIAL_TABLE, WRC_BOUND_PARABOLIC},
};

}  // namespace

Report compare_sdec(const Csv& file) {
  const wrc_config standard = made<wrc_config>(wrc_config_init);
  Report report;
  report.kind = "sdec";
  report.rows = file.rows();
  // The reference's power is a sum over its cells and lies up to a third below what its own forces dissipate
  // by the energy balance of steady rolling; the truth on fine grids is near the balance. Both are compared.
  report.measures = {"force", "power", "power_balance"};
  for (const Variant& variant : variants) {
    report.variants.emplace_back(variant.name);
    if (variant.method == standard.tangential_method && variant.bound == standard.traction_bound) {
      report.default_variant = variant.name;
    }
    for (std::size_t row = 0; row < file.rows(); ++row) {
      wrc_config config = standard;
      config.tangential_method = variant.method;
      config.traction_bound = variant.bound;
      config.force_table = WRC_FORCE_TABLE;
      config.shear_modulus = 1e6 * file(row, "G_MPa");
      config.poisson = file(row, "nu");
      const Solver solver(config);

      const Rolling rolling = rolling_of(file, row);
      wrc_forces forces = made<wrc_forces>(wrc_forces_init);
      const int32_t status =
          wrc_tangential(solver.contact(), &rolling.patch, &rolling.creepage, &rolling.friction, &forces);
      if (status < 0) {
        report.fail(row, variant.name, solver.reason(status));
        continue;
      }
      const double limit = rolling.friction.coefficient * rolling.patch.normal_force;
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
