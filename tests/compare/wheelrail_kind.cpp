#include <cmath>
#include <vector>

#include "kinds.hpp"
#include "library.hpp"
#include "presets.hpp"
#include "test_config.hpp"

namespace compare {
namespace {

/// Methods with a bound of their own have the default's name beside them.
struct Variant {
  const char* name;
  int32_t normal, tangential, bound;  // tangential: number of a published method
};

const std::vector<Variant> every_variant = {
    {"strip_halfspace + strip_fastsim", WRC_NORMAL_STRIP_HALFSPACE, preset_strip_fastsim,
     WRC_BOUND_PARABOLIC},
    {"strip_halfspace + fastsim_sdec/parabolic", WRC_NORMAL_STRIP_HALFSPACE, preset_fastsim_sdec,
     WRC_BOUND_PARABOLIC},
    {"strip_halfspace + fastsim_sdec/elliptic", WRC_NORMAL_STRIP_HALFSPACE, preset_fastsim_sdec,
     WRC_BOUND_ELLIPTIC},
    {"ekp + strip_fastsim", WRC_NORMAL_EKP, preset_strip_fastsim, WRC_BOUND_PARABOLIC},
    {"ekp + fastsim_sdec/parabolic", WRC_NORMAL_EKP, preset_fastsim_sdec, WRC_BOUND_PARABOLIC},
    {"ekp + fastsim_eql/parabolic", WRC_NORMAL_EKP, preset_fastsim_eql, WRC_BOUND_PARABOLIC},
};

}  // namespace

Report compare_wheelrail(const Csv& file, const Names& only) {
  const wrc_config standard = test_config();
  Report report;
  report.kind = "wheelrail";
  report.rows = file.rows();
  report.measures = {"force", "power", "power_balance", "peak_pressure", "area", "approach"};
  report.default_variant = every_variant[0].name;
  for (const Variant& variant : chosen(every_variant, only)) {
    report.variants.emplace_back(variant.name);
    for (std::size_t row = 0; row < file.rows(); ++row) {
      wrc_config config = standard;
      config.normal.method = variant.normal;
      choose_tangential(config, variant.tangential);
      config.tangential.bound = variant.bound;
      config.wheel_material.shear_modulus = config.rail_material.shear_modulus = 1e6 * file(row, "G_MPa");
      config.wheel_material.poisson = config.rail_material.poisson = file(row, "nu");
      config.wheel.kind = WRC_PROFILE_S1002;
      config.rail.kind = WRC_PROFILE_UIC60_BENCHMARK;
      const Solver solver(config);
      wrc_planar_pose pose = sized<wrc_planar_pose>();
      pose.lateral = 1e-3 * file(row, "y_ws_mm");
      pose.roll = file(row, "roll_rad");
      pose.yaw = file(row, "yaw_rad");
      wrc_planar_load load = wrc_planar_load_default();
      load.normal_force = file(row, "Fn_N");
      wrc_friction friction = wrc_friction_default();
      friction.coefficient = file(row, "mu");
      wrc_planar_point point{};
      wrc_planar_normal_solution normal{};
      wrc_planar_forces forces{};
      int32_t status = wrc_planar_geometry(solver.contact(), &pose, &point);

      // The file's creepages are those of the rail over the wheel, at the reference's contact location, and
      // so are its forces: with both signs changed they are ours. The creepage moves to our origin with the
      // spin.
      wrc_creepage creepage = wrc_creepage_default();
      const double y = (1e-3 * file(row, "ycp_rail_mm") - point.y_rail) / std::cos(point.angle);
      creepage.spin = file(row, "cphi_per_m");
      creepage.longitudinal = file(row, "cksi") + creepage.spin * y;
      creepage.lateral = file(row, "ceta");
      creepage.speed = file(row, "vs_mps");
      if (status >= 0) status = wrc_planar_normal(solver.contact(), nullptr, &load, &normal);
      if (status >= 0)
        status = wrc_planar_tangential(solver.contact(), nullptr, &creepage, &friction, &forces);
      if (status < 0) {
        report.fail(row, variant.name, solver.reason(status));
        continue;
      }
      auto& errors = report.errors[variant.name];
      const double limit = friction.coefficient * load.normal_force;
      errors["force"].add(row,
                          std::hypot(forces.fx - file(row, "Fx_N"), forces.fy - file(row, "Fy_N")) / limit);
      errors["power"].add(row, forces.power / file(row, "P_W") - 1.0);
      // The same sign in both frames of reference; see sdec_kind.cpp on the two powers.
      const double balance = -(file(row, "Fx_N") * file(row, "cksi") + file(row, "Fy_N") * file(row, "ceta") +
                               file(row, "Mz_Nm") * file(row, "cphi_per_m"));
      errors["power_balance"].add(row, forces.power / (balance * file(row, "vs_mps")) - 1.0);
      errors["peak_pressure"].add(row, normal.peak_pressure / (1e6 * file(row, "pmax_MPa")) - 1.0);
      errors["area"].add(row, normal.area / (1e-6 * file(row, "area_mm2")) - 1.0);
      errors["approach"].add(row, normal.approach / (1e-3 * file(row, "pen_mm")) - 1.0);
    }
  }
  return report;
}

}  // namespace compare
