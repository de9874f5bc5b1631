#include <cmath>
#include <cstdio>

#include "kinds.hpp"
#include "wheel_cases.hpp"

namespace compare {
namespace {

/// The reference's own ways to see a patch on a curved surface; the last is the most complete.
constexpr const char* settings[] = {"planar", "planar_ext", "conformal", "conformal_angle"};
constexpr double beyond = 1.15;  // contact angles [rad]: flange faces

double relative_error(const Csv& file, const CaseRows& rows, const WheelCase& solved) {
  const Vector force = vector_of(file, rows.first, "Fx_total_N", "Fy_total_N", "Fz_total_N");
  return length(difference(solved.force(), force)) / std::max(length(force), least_force);
}

}  // namespace

Report compare_conformal(const Csv& file, const Options& options) {
  Report report;
  report.kind = "conformal";
  report.numbered = true;
  report.default_variant = "conformal_angle";
  report.measures = {"force", "peak_pressure", "force_steep", "force_steep_height"};
  for (const char* setting : settings) report.variants.emplace_back(setting);
  Pairs pairs(file, options.setting);
  if (options.list)
    std::printf("case setting, steepest angle, errors of force and peak pressure, at height\n");
  for (const CaseRows& rows : case_rows(file)) {
    if (!options.wanted(rows.number)) continue;
    ++report.rows;
    const auto number = static_cast<std::size_t>(rows.number);
    for (const char* setting : settings) {
      const CaseRows of_setting = setting_rows(file, rows, setting);
      if (of_setting.first == of_setting.last) continue;
      double angle = 0.0, peak = 0.0;
      for (std::size_t row = of_setting.first; row < of_setting.last; ++row) {
        angle = std::max(angle, std::fabs(file(row, "delta_track_rad")));
        peak = std::max(peak, 1e6 * file(row, "pmax_MPa"));
      }
      const Solver& solver = pairs.of(pair_of(file, of_setting.first));
      WheelCase at_height = wheel_case(file, of_setting.first);
      WheelCase loaded = wheel_case(file, of_setting.first);
      loaded.input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
      loaded.input.vertical_load = file(of_setting.first, "fz_N");
      const int32_t height_status = at_height.solve(solver);
      const std::string height_reason = height_status < 0 ? solver.reason(height_status) : "";
      const int32_t status = loaded.solve(solver);
      if (status < 0 || height_status < 0) {
        const std::vector<std::string> steep{"force_steep", "force_steep_height"},
            others{"force", "peak_pressure"};
        report.fail(number, setting, status < 0 ? solver.reason(status) : height_reason,
                    angle <= beyond ? others : steep);
        continue;
      }
      auto& errors = report.errors[setting];
      const double force_error = relative_error(file, of_setting, loaded);
      const double height_error = relative_error(file, of_setting, at_height);
      if (angle <= beyond) {
        errors["force"].add(number, force_error);
        errors["peak_pressure"].add(number, loaded.wrench.peak_pressure / peak - 1.0);
      } else {
        errors["force_steep"].add(number, force_error);
        errors["force_steep_height"].add(number, height_error);
      }
      if (options.list) {
        const Vector force = vector_of(file, of_setting.first, "Fx_total_N", "Fy_total_N", "Fz_total_N");
        std::printf(
            "%4ld %-16s %6.3f rad %8.3f %% %8.3f %% at z %8.3f %%, dz %+7.3f um | %8.0f %8.0f %8.0f | %8.0f "
            "%8.0f "
            "%8.0f%s%s\n",
            rows.number, setting, angle, 100.0 * force_error,
            100.0 * (loaded.wrench.peak_pressure / peak - 1.0), 100.0 * height_error,
            1e6 * (loaded.wrench.z - at_height.input.wheel.z), loaded.wrench.force[0], loaded.wrench.force[1],
            loaded.wrench.force[2], force[0], force[1], force[2],
            status > 0 ? (std::string(" ") + wrc_status_name(status)).c_str() : "",
            height_status > 0 ? (std::string(" at z ") + wrc_status_name(height_status)).c_str() : "");
      }
    }
  }
  return report;
}

}  // namespace compare
