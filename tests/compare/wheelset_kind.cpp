#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "kinds.hpp"
#include "wheel_cases.hpp"

namespace compare {
namespace {

/// Of the total force, in a frame the reference gives: separate patches (sep) or its usual settings (blend).
struct Reference {
  Vector force{}, moment{};
  double scale = 0.0;  ///< errors of forces are over this [N]
};

Reference reference_of(const Csv& file, const CaseRows& rows) {
  Reference reference;
  reference.force = vector_of(file, rows.first, "Fx_total_N", "Fy_total_N", "Fz_total_N");
  reference.moment = vector_of(file, rows.first, "Mx_ws_Nm", "My_ws_Nm", "Mz_ws_Nm");
  reference.scale = std::max(length(reference.force), least_force);
  return reference;
}

double sum(const Csv& file, const CaseRows& rows, const char* column) {
  double total = 0.0;
  for (std::size_t row = rows.first; row < rows.last; ++row) total += file(row, column);
  return total;
}

double largest(const Csv& file, const CaseRows& rows, const char* column) {
  double most = 0.0;
  for (std::size_t row = rows.first; row < rows.last; ++row)
    most = std::max(most, std::fabs(file(row, column)));
  return most;
}

/// Vector from the straight line between two points to a third.
Vector from_segment(const Vector& point, const Vector& from, const Vector& to) {
  const Vector along = difference(to, from), away = difference(point, from);
  const double size = length(along);
  if (size == 0.0) return away;
  double share = (along[0] * away[0] + along[1] * away[1] + along[2] * away[2]) / (size * size);
  share = std::min(1.0, std::max(0.0, share));
  return {away[0] - share * along[0], away[1] - share * along[1], away[2] - share * along[2]};
}

/// Centre of pressure of a patch of the reference, track axes from the wheelset's x [m].
Vector pressure_centre(const Csv& file, std::size_t row) {
  const double angle = file(row, "delta_track_rad"), along = file(row, "ypc_patch_mm");
  return {1e-3 * (file(row, "xcp_track_mm") + file(row, "xpc_patch_mm")),
          1e-3 * (file(row, "ycp_track_mm") + along * std::cos(angle)),
          1e-3 * (file(row, "zcp_track_mm") + along * std::sin(angle))};
}

constexpr double least_share = 0.01;  // of the normal force: smaller patches are a few cells of the reference
constexpr double same_setting = 1e-6;         // relative difference below which sep and blend are the same
constexpr double steep = 0.4, beyond = 1.15;  // contact angles [rad]
const std::string standard = "strip_halfspace on the surface";

/// Methods by name; those of the standard are the default's.
void choose(const std::string& variant, PairOptions& pair) {
  if (variant != standard) choose_methods(variant, pair);
}

/// Distance of each patch of the reference that counts from the nearest region of ours [mm].
std::vector<double> centre_errors(const Csv& file, const CaseRows& rows,
                                  const std::vector<wrc_region>& regions) {
  double normal_force = 0.0;
  for (const wrc_region& region : regions) normal_force += region.normal_force;
  std::vector<double> errors;
  for (std::size_t row = rows.first; row < rows.last; ++row) {
    if (file(row, "Fn_N") < least_share * sum(file, rows, "Fn_N")) continue;
    double nearest = 1.0;  // of an error that counts [m]: nothing of the library is there
    for (const wrc_region& region : regions) {
      if (region.normal_force < least_share * normal_force) continue;
      const Vector point{region.point[0], region.point[1], region.point[2]};
      nearest = std::min(nearest, length(difference(point, pressure_centre(file, row))));
    }
    errors.push_back(1e3 * nearest);
  }
  return errors;
}

/// Time of a solution [us], the least of 9.
double time_of(WheelCase& at, const Solver& solver) {
  double least = 1e9;
  for (int i = 0; i < 9; ++i) {
    const auto start = std::chrono::steady_clock::now();
    at.solve(solver);
    const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - start;
    least = std::min(least, time.count());
  }
  return least;
}

/// The solution of a case beside its exact reference. Where patches solved on their own (sep) and patches as
/// one (blend) differ, the truth lies between: an error is what lies beyond both; measures with _sep are
/// against the former alone.
void add_case(const Csv& file, const CaseRows& rows, const std::string& variant, Pairs& pairs, bool list,
              Report& report) {
  const auto number = static_cast<std::size_t>(rows.number);
  const CaseRows sep = setting_rows(file, rows, "sep"), blend = setting_rows(file, rows, "blend");
  if (sep.first == sep.last) return;
  PairOptions pair = pair_of(file, sep.first);
  choose(variant, pair);
  const Solver& solver = pairs.of(pair);
  WheelCase solved = wheel_case(file, sep.first);
  const int32_t status = solved.solve(solver);
  const double angle = largest(file, sep, "delta_track_rad");
  const char* const steepness = angle <= steep    ? "force_flat"
                                : angle <= beyond ? "force_steep"
                                                  : "force_steeper";
  if (status < 0) {
    return report.fail(
        number, variant, solver.reason(status),
        {"force", "force_sep", "force_blend", steepness, "moment", "moment_sep", "point", "normal_force",
         "normal_force_sep", "area", "area_sep", "power", "power_sep", "peak_pressure", "peak_pressure_sep"});
  }

  auto& errors = report.errors[variant];
  if (report.units.count("time") > 0) errors["time"].add(number, time_of(solved, solver));
  const Reference separate = reference_of(file, sep);
  const Reference blended = blend.first == blend.last ? separate : reference_of(file, blend);
  const bool differ = length(difference(separate.force, blended.force)) > same_setting * separate.scale;
  const Vector off_sep = difference(solved.force(), separate.force);
  const Vector off = from_segment(solved.force(), separate.force, blended.force);
  errors["force"].add(number, length(off) / separate.scale);
  errors["force_sep"].add(number, length(off_sep) / separate.scale);
  errors["force_blend"].add(number, length(difference(solved.force(), blended.force)) / blended.scale);
  errors[steepness].add(number, length(off) / separate.scale);
  errors["moment"].add(number, length(from_segment(solved.moment(), separate.moment, blended.moment)) /
                                   (moment_arm * separate.scale));
  errors["moment_sep"].add(
      number, length(difference(solved.moment(), separate.moment)) / (moment_arm * separate.scale));
  const auto add_number = [&](const char* measure, double ours, double of_sep, double of_blend) {
    const double low = std::min(of_sep, of_blend), high = std::max(of_sep, of_blend);
    errors[measure].add(number, ours < low ? ours / low - 1.0 : ours > high ? ours / high - 1.0 : 0.0);
    errors[std::string(measure) + "_sep"].add(number, ours / of_sep - 1.0);
  };
  const CaseRows& other = blend.first == blend.last ? sep : blend;
  const auto add_sum = [&](const char* measure, double ours, const char* column, double unit) {
    add_number(measure, ours, unit * sum(file, sep, column), unit * sum(file, other, column));
  };
  add_sum("normal_force", solved.wrench.normal_force, "Fn_N", 1.0);
  add_sum("area", solved.wrench.area, "area_mm2", 1e-6);
  add_sum("power", solved.wrench.power, "P_work_W", 1.0);
  add_number("peak_pressure", solved.wrench.peak_pressure, 1e6 * largest(file, sep, "pmax_MPa"),
             1e6 * largest(file, other, "pmax_MPa"));

  const std::vector<wrc_region> regions = regions_of(solver, solved.wrench);
  const std::vector<double> of_sep = centre_errors(file, sep, regions),
                            of_blend = centre_errors(file, other, regions);
  const bool nearer =
      *std::max_element(of_sep.begin(), of_sep.end()) <= *std::max_element(of_blend.begin(), of_blend.end());
  for (const double error : nearer ? of_sep : of_blend) errors["point"].add(number, error);
  if (list) {
    std::printf(
        "%4ld %-5s %6.3f rad%s %8.3f %% %8.3f %% of sep | %8.0f %8.0f %8.0f | %8.0f %8.0f %8.0f | %d "
        "regions, %d"
        " sweeps%s\n",
        rows.number, file.text(sep.first, "side").c_str(), angle, differ ? " two" : "    ",
        100.0 * length(off) / separate.scale, 100.0 * length(off_sep) / separate.scale, off_sep[0],
        off_sep[1], off_sep[2], separate.force[0], separate.force[1], separate.force[2],
        solved.wrench.region_count, solved.wrench.iterations,
        status > 0 ? (std::string(" ") + wrc_status_name(status)).c_str() : "");
  }
}

/// The noisy profiles of a case, smoothed, beside the exact profiles' reference.
void add_noisy_case(const Csv& file, const CaseRows& rows, const std::string& variant, Pairs& pairs,
                    double smoothing, Report& report) {
  if (!file.has("smooth_Lfilt_mm")) return;
  std::size_t noisy = rows.first;
  while (noisy < rows.last && file(noisy, "smooth_Lfilt_mm") == 0.0) ++noisy;
  if (noisy == rows.last) return;
  const auto number = static_cast<std::size_t>(rows.number);
  PairOptions pair = pair_of(file, noisy);
  pair.smoothing = smoothing;
  choose(variant, pair);
  const Solver& solver = pairs.of(pair);
  WheelCase solved = wheel_case(file, noisy);
  const int32_t status = solved.solve(solver);
  if (status < 0) return report.fail(number, variant, solver.reason(status), {"force_noisy"});
  const Reference exact = reference_of(file, setting_rows(file, rows, "sep"));
  report.errors[variant]["force_noisy"].add(number,
                                            length(difference(solved.force(), exact.force)) / exact.scale);
}

}  // namespace

Report compare_wheelset(const Csv& file, const Options& options) {
  Report report;
  report.kind = "wheelset";
  report.numbered = true;
  report.variants = options.only.empty() ? Names{standard} : options.only;
  report.default_variant = report.variants.front();
  report.measures = {
      "force",    "force_sep",  "force_blend", "force_flat",    "force_steep",       "force_steeper",
      "moment",   "moment_sep", "point",       "normal_force",  "normal_force_sep",  "area",
      "area_sep", "power",      "power_sep",   "peak_pressure", "peak_pressure_sep", "force_noisy"};
  report.units["point"] = "mm";
  if (!options.only.empty()) {
    report.measures.emplace_back("time");
    report.units["time"] = "us";
  }
  Pairs pairs(file, options.setting);
  if (options.list) {
    std::printf(
        "case side steepest angle, error of the force, of sep alone | library - sep Fx Fy Fz [N] | sep "
        "[N]\n");
  }
  for (const CaseRows& rows : case_rows(file)) {
    if (!options.wanted(rows.number)) continue;
    ++report.rows;
    for (const std::string& variant : report.variants) {
      add_case(file, rows, variant, pairs, options.list, report);
      add_noisy_case(file, rows, variant, pairs, options.smoothing, report);
    }
  }
  return report;
}

}  // namespace compare
