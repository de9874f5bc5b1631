#include <cmath>
#include <cstdio>

#include "kinds.hpp"
#include "wheel_cases.hpp"
#include "wrc/wrc_offline.h"

namespace compare {
namespace {

const char* const real_time = "wrc_contact_wrench";

/// The errors of one wrench, about the middle of the axle.
void add_errors(std::map<std::string, Errors>& errors, std::size_t number, const WheelCase& solved,
                const Vector& force, const Vector& moment, double peak, double area, double power) {
  const double scale = std::max(length(force), least_force);
  errors["force"].add(number, length(difference(solved.force(), force)) / scale);
  errors["moment"].add(number, length(difference(solved.moment(), moment)) / (moment_arm * scale));
  errors["peak_pressure"].add(number, solved.wrench.peak_pressure / peak - 1.0);
  errors["area"].add(number, solved.wrench.area / area - 1.0);
  if (power > 0.0) errors["power"].add(number, solved.wrench.power / power - 1.0);
}

int32_t solve_exactly(WheelCase& wheel, const Solver& solver, const wrc_exact_wrench_options& options) {
  return wrc_exact_wrench(solver.contact(), &wheel.input, &options, &wheel.wrench);
}

void print(long number, const char* what, const WheelCase& solved, const Vector& force, double peak,
           double given_z) {
  const double scale = std::max(length(force), least_force);
  std::printf(
      "%4ld %-22s %7.3f %% peak %+7.2f %% dz %+7.3f um | %8.0f %8.0f %8.0f | %8.0f %8.0f %8.0f | %d "
      "regions\n",
      number, what, 100.0 * length(difference(solved.force(), force)) / scale,
      100.0 * (solved.wrench.peak_pressure / peak - 1.0), 1e6 * (solved.wrench.z - given_z),
      solved.wrench.force[0], solved.wrench.force[1], solved.wrench.force[2], force[0], force[1], force[2],
      solved.wrench.region_count);
  std::fflush(stdout);
}

/// A run of rows of one setting against the exact solver as the reference has it: its collocation, and its
/// influence coefficients in the plain conformal setting.
void against_reference(const Csv& file, const CaseRows& rows, const Solver& solver, const Options& options,
                       Report& report) {
  const auto number = static_cast<std::size_t>(rows.number);
  const std::string setting = file.text(rows.first, "setting");
  const std::string variant = setting + (rows.last - rows.first > 1 ? ", two patches" : "");
  wrc_exact_wrench_options how = wrc_exact_wrench_options_default();
  how.collocation = WRC_COLLOCATION_REFERENCE;
  how.influence = setting == "conformal" ? WRC_INFLUENCE_PLAIN : WRC_INFLUENCE_TURNED;
  how.cell_x = how.cell_s = options.cell;
  WheelCase solved = wheel_case(file, rows.first);
  if (file.has("fz_N")) {
    solved.input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
    solved.input.vertical_load = file(rows.first, "fz_N");
  }
  const int32_t status = solve_exactly(solved, solver, how);
  if (status != WRC_OK) report.fail(number, variant, solver.reason(status));
  if (status < 0) return;
  double peak = 0.0, area = 0.0, power = 0.0;
  for (std::size_t row = rows.first; row < rows.last; ++row) {
    peak = std::max(peak, 1e6 * file(row, "pmax_MPa"));
    area += 1e-6 * file(row, "area_mm2");
    power += file.has("P_work_W") ? file(row, "P_work_W") : 0.0;
  }
  const Vector force = vector_of(file, rows.first, "Fx_total_N", "Fy_total_N", "Fz_total_N");
  add_errors(report.errors[variant], number, solved, force,
             vector_of(file, rows.first, "Mx_ws_Nm", "My_ws_Nm", "Mz_ws_Nm"), peak, area, power);
  if (options.list) print(rows.number, variant.c_str(), solved, force, peak, solved.input.wheel.z);
}

/// The real-time solution of the case's pose against the exact one.
void against_exact(const Csv& file, const CaseRows& rows, const Solver& solver, const Options& options,
                   Report& report) {
  const auto number = static_cast<std::size_t>(rows.number);
  wrc_exact_wrench_options how = wrc_exact_wrench_options_default();
  how.cell_x = how.cell_s = options.cell;
  WheelCase exact = wheel_case(file, rows.first), solved = wheel_case(file, rows.first);
  const int32_t exact_status = solve_exactly(exact, solver, how);
  if (exact_status != WRC_OK) report.fail(number, "exact", solver.reason(exact_status));
  const int32_t status = solved.solve(solver);
  if (status != WRC_OK) report.fail(number, real_time, solver.reason(status));
  if (status < 0 || exact_status != WRC_OK) return;
  add_errors(report.errors[real_time], number, solved, exact.force(), exact.moment(),
             exact.wrench.peak_pressure, exact.wrench.area, exact.wrench.power);
  if (options.list)
    print(rows.number, real_time, solved, exact.force(), exact.wrench.peak_pressure, exact.wrench.z);
}

}  // namespace

Report compare_exact_wheel(const Csv& file, const Options& options) {
  Report report;
  report.kind = "exact-wheel";
  report.numbered = true;
  report.default_variant = real_time;
  report.measures = {"force", "moment", "peak_pressure", "area", "power"};
  Pairs pairs(file, options.setting);
  for (const CaseRows& rows : case_rows(file)) {
    if (!options.wanted(rows.number)) continue;
    ++report.rows;
    const Solver& solver = pairs.of(pair_of(file, rows.first));
    std::string before;
    for (std::size_t row = rows.first; row < rows.last; ++row) {
      const std::string setting = file.text(row, "setting");
      if (setting == before) continue;
      before = setting;
      against_reference(file, setting_rows(file, rows, setting), solver, options, report);
    }
    against_exact(file, rows, solver, options, report);
  }
  for (const auto& [variant, errors] : report.errors) report.variants.push_back(variant);
  return report;
}

}  // namespace compare
