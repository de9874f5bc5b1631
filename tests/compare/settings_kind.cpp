/// Wheels on rails of every kind, each case under several settings of the reference: separate patches,
/// patches as one, its conformal method. Columns and frames: tests/data/README.md.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "kinds.hpp"
#include "settings_cases.hpp"

namespace compare {
namespace {

struct Variant {
  const char* name;
  bool exact;
};
const std::vector<Variant> every_variant = {{"wrc_contact_wrench", false}, {"wrc_exact_wrench", true}};

int32_t solve(const Variant& variant, WheelCase& wheel, const Solver& solver, double cell_size) {
  return variant.exact ? solve_exactly(wheel, solver, cell_size) : wheel.solve(solver);
}

/// Smallest and largest of a number over the settings of a case.
struct Range {
  double low = 0.0, high = 0.0;

  Range(const Csv& file, const CaseRows& rows, const char* column, double unit = 1.0) {
    for (std::size_t row = rows.first; row < rows.last; ++row) {
      const double value = unit * file(row, column);
      low = row == rows.first ? value : std::min(low, value);
      high = row == rows.first ? value : std::max(high, value);
    }
  }

  /// The part of a value that lies beyond the range, with its sign.
  double beyond(double value) const { return value - std::clamp(value, low, high); }

  /// The same in parts of the nearer end.
  double beyond_relative(double value) const { return beyond(value) / std::clamp(value, low, high); }
};

/// The part of each component of the force on the rail that lies beyond all settings [N].
Vector force_beyond(const Csv& file, const CaseRows& rows, const wrc_wrench& wrench) {
  return {Range(file, rows, "Fx_r").beyond(wrench.rail_force[0]),
          Range(file, rows, "Fy_r").beyond(wrench.rail_force[1]),
          Range(file, rows, "Fz_r").beyond(wrench.rail_force[2])};
}

bool has_result(int32_t status) { return status >= 0 && status != WRC_FLAG_NO_CONTACT; }

void print(const CaseRows& rows, const Variant& variant, const char* what, int32_t status,
           const Vector& beyond, double normal_force, const wrc_wrench& wrench) {
  std::printf(
      "%4ld %-18s %-9s %8.3f %% of Fn %8.0f N, beyond %8.0f %8.0f %8.0f N | rail %8.0f %8.0f %8.0f, z %9.4f "
      "mm %s\n",
      rows.number, variant.name, what, 100.0 * length(beyond) / normal_force, normal_force, beyond[0],
      beyond[1], beyond[2], wrench.rail_force[0], wrench.rail_force[1], wrench.rail_force[2], 1e3 * wrench.z,
      status == WRC_OK ? "" : wrc_status_name(status));
}

/// The errors of a case, prescribed as it is in the file.
void add_case(const Csv& file, const CaseRows& rows, const Variant& variant, WheelCase& wheel,
              const Solver& solver, const Options& options, Report& report) {
  const auto number = static_cast<std::size_t>(rows.number);
  const int32_t status = solve(variant, wheel, solver, options.cell);
  if (!has_result(status))
    return report.fail(number, variant.name, solver.reason(status),
                       {"force", "force_sep", "vertical", "peak_pressure", "failed"});
  auto& errors = report.errors[variant.name];
  const CaseRows sep = setting_rows(file, rows, "sep");
  const double normal_force = file(sep.first == sep.last ? rows.first : sep.first, "Fn");
  const Vector beyond = force_beyond(file, rows, wheel.wrench);
  errors["force"].add(number, length(beyond) / normal_force);
  if (sep.first != sep.last) {
    const Vector force{wheel.wrench.rail_force[0], wheel.wrench.rail_force[1], wheel.wrench.rail_force[2]};
    errors["force_sep"].add(
        number, length(difference(force, vector_of(file, sep.first, "Fx_r", "Fy_r", "Fz_r"))) / normal_force);
  }
  errors["vertical"].add(number, beyond[2] / normal_force);
  errors["peak_pressure"].add(number,
                              Range(file, rows, "pmax", 1e6).beyond_relative(wheel.wrench.peak_pressure));
  errors["failed"].add(number, status == WRC_FLAG_ITERATION_CAP ? 1.0 : 0.0);
  if (options.list) print(rows, variant, "as given", status, beyond, normal_force, wheel.wrench);
}

/// The same wheel at the height that the reference found.
void add_at_height(const Csv& file, const CaseRows& rows, const Variant& variant, WheelCase& wheel,
                   const Solver& solver, const Options& options, Report& report) {
  const auto number = static_cast<std::size_t>(rows.number);
  wheel.input.prescribed = WRC_PRESCRIBE_HEIGHT;
  wheel.input.vertical_load = 0.0;
  wheel.input.wheel.z = 1e-3 * file(rows.first, "z_out");
  const int32_t status = solve(variant, wheel, solver, options.cell);
  if (!has_result(status))
    return report.fail(number, variant.name, "at the reference's height: " + solver.reason(status),
                       {"vertical_at_height", "peak_at_height"});
  auto& errors = report.errors[variant.name];
  const Vector beyond = force_beyond(file, rows, wheel.wrench);
  errors["vertical_at_height"].add(number, beyond[2] / file(rows.first, "Fn"));
  errors["peak_at_height"].add(number,
                               Range(file, rows, "pmax", 1e6).beyond_relative(wheel.wrench.peak_pressure));
  if (options.list) print(rows, variant, "at height", status, beyond, file(rows.first, "Fn"), wheel.wrench);
}

}  // namespace

Report compare_settings(const Csv& file, const Options& options) {
  Report report;
  report.kind = options.kind;
  report.numbered = true;
  report.measures = {"force", "force_sep", "vertical", "peak_pressure", "failed"};
  const bool along_track = report.kind == "track";
  if (along_track) report.measures.insert(report.measures.end(), {"vertical_at_height", "peak_at_height"});
  report.default_variant = every_variant.front().name;
  const Names only = options.only.empty() ? Names{report.default_variant} : options.only;
  const std::vector<Variant> variants = chosen(every_variant, only);
  for (const Variant& variant : variants) report.variants.emplace_back(variant.name);
  CaseBodies bodies(file, options.setting);
  for (const CaseRows& rows : case_rows(file)) {
    if (!options.wanted(rows.number)) continue;
    ++report.rows;
    const CaseBodies::Made& made = bodies.of(rows.first);
    const std::string& text = file.text(rows.first, "zones");
    const Zones zones = text.empty() ? Zones{} : zones_of(text, made.rail);
    for (const Variant& variant : variants) {
      WheelCase wheel = case_of(file, rows.first, zones);
      add_case(file, rows, variant, wheel, *made.solver, options, report);
      if (along_track) add_at_height(file, rows, variant, wheel, *made.solver, options, report);
    }
  }
  return report;
}

}  // namespace compare
