#include <vector>

#include "cases.hpp"
#include "field_values.hpp"
#include "kinds.hpp"
#include "library.hpp"
#include "test_config.hpp"

namespace compare {
namespace {

struct Variant {
  const char* name;
  int32_t method;
};

const std::vector<Variant> every_variant = {
#define WRC_METHOD(identifier, value) {#identifier, value},
    WRC_NORMAL_METHOD_LIST(WRC_METHOD)
#undef WRC_METHOD
};

FieldValues field_of(const Solver& solver, int32_t patch, int32_t field) {
  FieldValues values = field_values(solver.contact(), patch, field);
  if (values.status != WRC_OK) throw std::runtime_error("field not available");
  return values;
}

LineLoad computed_line_load(const Solver& solver, int32_t patches) {
  const double pi = 3.14159265358979323846;
  LineLoad load;
  for (int32_t patch = 0; patch < patches; ++patch) {
    const FieldValues y = field_of(solver, patch, WRC_FIELD_STRIP_Y),
                      width = field_of(solver, patch, WRC_FIELD_STRIP_WIDTH);
    const FieldValues half = field_of(solver, patch, WRC_FIELD_STRIP_HALF_LENGTH);
    const FieldValues peak = field_of(solver, patch, WRC_FIELD_STRIP_PEAK);
    for (uint64_t j = 0; j < y.strips; ++j) {
      load.add(y[j] - 0.5 * width[j], y[j] + 0.5 * width[j], 0.5 * pi * half[j] * peak[j]);
    }
  }
  return load;
}

}  // namespace

Report compare_normal(const Csv& file, const Names& only) {
  const wrc_config standard = test_config();
  const std::vector<Case> cases = find_cases(file);

  Report report;
  report.kind = "normal";
  report.rows = cases.size();
  report.measures = {"peak_pressure", "area", "approach", "line_load"};
  for (const Variant& variant : chosen(every_variant, only)) {
    report.variants.emplace_back(variant.name);
    if (variant.method == standard.normal.method) report.default_variant = variant.name;
    wrc_config config = standard;  // G = 80 GPa, nu = 0.25, R = 460 mm: those of the reference
    config.normal.method = variant.method;
    config.wheel.kind = WRC_PROFILE_S1002;
    config.rail.kind = WRC_PROFILE_UIC60_BENCHMARK;
    const Solver solver(config);
    for (std::size_t i = 0; i < cases.size(); ++i) {
      const std::size_t head = cases[i].first;
      wrc_planar_pose pose = sized<wrc_planar_pose>();
      pose.lateral = 1e-3 * file(head, "y_ws_mm");
      pose.yaw = file(head, "yaw_rad");
      wrc_planar_load load = wrc_planar_load_default();
      load.normal_force = file(head, "Fn_N");
      wrc_planar_point point{};
      wrc_planar_normal_solution normal{};
      int32_t status = wrc_planar_geometry(solver.contact(), &pose, &point);
      if (status >= 0) status = wrc_planar_normal(solver.contact(), nullptr, &load, &normal);
      if (status < 0) {
        report.fail(i, variant.name, solver.reason(status));
        continue;
      }
      auto& errors = report.errors[variant.name];
      errors["peak_pressure"].add(i, normal.peak_pressure / (1e6 * file(head, "pmax_MPa")) - 1.0);
      errors["area"].add(i, normal.area / (1e-6 * file(head, "area_mm2")) - 1.0);
      errors["approach"].add(i, normal.approach / (1e-3 * file(head, "pen_mm")) - 1.0);
      const double shift = reference_shift(file, cases[i], point);
      errors["line_load"].add(
          i, line_load_error(file, cases[i], computed_line_load(solver, normal.patch_count), shift));
    }
  }
  return report;
}

}  // namespace compare
