/// Paths through pose space: how smooth the wrench is along lines, and what work it does round closed ones.
#include <cmath>
#include <cstdio>

#include "kinds.hpp"
#include "wheel_cases.hpp"

namespace compare {
namespace {

constexpr double tread = 0.12;  // steepest strip of a contact on the tread [rad]

/// Force [N] and moment about the wheelset's middle over moment_arm [N] at one pose.
struct Load {
  std::array<double, 6> component{};
  double normal_force = 0.0, steepest = 0.0;
  int32_t spoilt = WRC_OK;  ///< an error, or a flag that says that the result is not what it should be
};

Load load_of(WheelCase& at, const Solver& solver) {
  const int32_t status = at.solve(solver);
  Load load;
  // nor does a shape beyond a table, or a patch wider than its overlap, spoil what methods for planes find
  const bool harmless =
      status == WRC_FLAG_NO_CONTACT || status == WRC_FLAG_TABLE_RANGE || status == WRC_FLAG_PATCH_AT_EDGE;
  load.spoilt = harmless ? WRC_OK : status;
  for (std::size_t i = 0; i < 3; ++i) {
    load.component[i] = at.wrench.force[i];
    load.component[i + 3] = at.wrench.moment[i] / moment_arm;
  }
  load.normal_force = at.wrench.normal_force;
  load.steepest = at.wrench.steepest_angle;
  return load;
}

std::vector<Load> scan(const Csv& file, std::size_t row, const Solver& solver, bool warm) {
  const auto steps = static_cast<std::size_t>(file(row, "steps"));
  WheelCase at = wheel_case(file, row);
  at.input.start = warm ? WRC_START_WARM : WRC_START_COLD;
  if (file.text(row, "prescribed") == "load") {
    at.input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
    at.input.vertical_load = file(row, "Q_N");
  }
  const auto between = [&](const char* from, const char* to, std::size_t k) {
    const double share = static_cast<double>(k) / static_cast<double>(steps);
    return (1.0 - share) * file(row, from) + share * file(row, to);
  };
  std::vector<Load> loads;
  for (std::size_t k = 0; k <= steps; ++k) {
    at.input.wheel.y = 1e-3 * between("y0_mm", "y1_mm", k);
    at.input.wheel.z = 1e-3 * between("z0_mm", "z1_mm", k);
    at.input.wheel.roll = between("roll0_rad", "roll1_rad", k);
    at.input.wheel.yaw = between("yaw0_rad", "yaw1_rad", k);
    loads.push_back(load_of(at, solver));
  }
  return loads;
}

/// Largest half second difference of a component over the larger of normal force and least_force; where is
/// set to its step.
double largest_jump(const std::vector<Load>& loads, std::size_t& where, std::size_t& component) {
  double jump = 0.0;
  for (std::size_t k = 0; k < loads.size(); ++k) {
    if (loads[k].spoilt != WRC_OK) {
      where = k;
      component = 0;
      return 1.0;
    }
    if (k == 0 || k + 1 == loads.size()) continue;
    const double scale = std::max(loads[k].normal_force, least_force);
    for (std::size_t i = 0; i < 6; ++i) {
      const double second =
          loads[k + 1].component[i] - 2.0 * loads[k].component[i] + loads[k - 1].component[i];
      if (0.5 * std::fabs(second) / scale > jump) {
        jump = 0.5 * std::fabs(second) / scale;
        where = k;
        component = i;
      }
    }
  }
  return jump;
}

/// Work round a closed path over half of what is exchanged on it; poses (y, z, roll).
double loop_error(const std::vector<Load>& loads, const std::vector<Vector>& poses) {
  const std::size_t steps = loads.size();
  // Fy, Fz and Mx about the middle.
  const auto conjugate = [&](std::size_t k) {
    return Vector{loads[k].component[1], loads[k].component[2], loads[k].component[3] * moment_arm};
  };
  Vector mean{};
  for (std::size_t k = 0; k < steps; ++k) {
    for (std::size_t i = 0; i < 3; ++i) mean[i] += conjugate(k)[i] / static_cast<double>(steps);
  }
  double work = 0.0, exchanged = 0.0;
  for (std::size_t k = 0; k < steps; ++k) {
    const std::size_t next = (k + 1) % steps;
    const Vector here = conjugate(k), there = conjugate(next), step = difference(poses[next], poses[k]);
    double part = 0.0, varying = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      part += 0.5 * (here[i] + there[i]) * step[i];
      varying += (0.5 * (here[i] + there[i]) - mean[i]) * step[i];
    }
    work += part;
    exchanged += std::fabs(varying);
  }
  return std::fabs(work) / (0.5 * exchanged);
}

}  // namespace

Report compare_scan(const Csv& file, const Options& options) {
  Report report;
  report.kind = "scan";
  report.numbered = true;
  const bool standard = options.only.empty();
  report.variants = standard ? Names{"cold", "warm"} : options.only;
  report.default_variant = report.variants.front();
  report.measures = {"jump", "jump_tread"};
  if (standard) report.measures.emplace_back("warm_from_cold");
  static constexpr const char* names[] = {"Fx", "Fy", "Fz", "Mx", "My", "Mz"};
  Pairs pairs(file, options.setting);
  for (std::size_t row = 0; row < file.rows(); ++row) {
    const auto number = static_cast<std::size_t>(file(row, "case"));
    if (!options.wanted(static_cast<long>(number))) continue;
    ++report.rows;
    std::vector<Load> cold;
    for (const std::string& variant : report.variants) {
      const bool warm = variant == "warm";
      PairOptions pair = pair_of(file, row);
      if (!standard) choose_methods(variant, pair);
      const std::vector<Load> loads = scan(file, row, pairs.of(pair), warm);
      auto& errors = report.errors[variant];
      std::size_t where = 0, component = 0;
      const double jump = largest_jump(loads, where, component);
      double steepest = 0.0;
      for (const Load& each : loads) steepest = std::max(steepest, each.steepest);
      errors["jump"].add(number, jump);
      if (steepest <= tread) errors["jump_tread"].add(number, jump);
      if (options.list) {
        std::size_t spoilt = 0;
        for (const Load& each : loads) spoilt += each.spoilt != WRC_OK ? 1 : 0;
        std::printf("%4zu %-4s jump %.3e at step %zu in %s, steepest strip %.3f rad, moves %s", number,
                    variant.c_str(), jump, where, names[component], steepest,
                    file.text(row, "moves").c_str());
        if (spoilt > 0) std::printf(", %zu steps %s", spoilt, wrc_status_name(loads[where].spoilt));
        std::printf("\n");
      }
      if (!warm) {
        cold = loads;
        continue;
      }
      double apart = 0.0;
      for (std::size_t k = 0; k < loads.size(); ++k) {
        for (std::size_t i = 0; i < 6; ++i) {
          const double here = std::fabs(loads[k].component[i] - cold[k].component[i]) /
                              std::max(cold[k].normal_force, least_force);
          if (here <= apart) continue;
          apart = here, where = k, component = i;
        }
      }
      errors["warm_from_cold"].add(number, apart);
      if (options.list)
        std::printf("%4zu warm from cold %.3e at step %zu in %s\n", number, apart, where, names[component]);
    }
    show_progress("scan", row + 1, file.rows());
  }
  return report;
}

Report compare_loop(const Csv& file, const Options& options) {
  Report report;
  report.kind = "loop";
  report.numbered = true;
  const bool standard = options.only.empty();
  report.variants = standard ? Names{"as given", "steps halved"} : options.only;
  report.default_variant = report.variants.front();
  report.measures = {"loop"};
  Pairs pairs(file, options.setting);
  for (std::size_t row = 0; row < file.rows(); ++row) {
    const auto number = static_cast<std::size_t>(file(row, "case"));
    if (!options.wanted(static_cast<long>(number))) continue;
    ++report.rows;
    for (std::size_t variant = 0; variant < report.variants.size(); ++variant) {
      const std::size_t finer = standard ? variant + 1 : 1;
      PairOptions pair = pair_of(file, row);
      if (!standard) choose_methods(report.variants[variant], pair);
      const Solver& solver = pairs.of(pair);
      WheelCase at = wheel_case(file, row);
      const std::size_t steps = finer * static_cast<std::size_t>(file(row, "steps"));
      std::vector<Load> loads;
      std::vector<Vector> poses;
      int32_t spoilt = WRC_OK;
      for (std::size_t k = 0; k < steps; ++k) {
        const double t = 2.0 * 3.14159265358979323846 * static_cast<double>(k) / static_cast<double>(steps);
        at.input.wheel.y = 1e-3 * (file(row, "y_centre_mm") + file(row, "y_amplitude_mm") * std::cos(t));
        at.input.wheel.z = 1e-3 * (file(row, "z_centre_mm") + file(row, "z_amplitude_mm") * std::sin(t));
        at.input.wheel.roll = file(row, "roll_amplitude_rad") * std::sin(2.0 * t);
        loads.push_back(load_of(at, solver));
        poses.push_back({at.input.wheel.y, at.input.wheel.z, at.input.wheel.roll});
        if (loads.back().spoilt != WRC_OK) spoilt = loads.back().spoilt;
      }
      const double error = spoilt != WRC_OK ? 1.0 : loop_error(loads, poses);
      report.errors[report.variants[variant]]["loop"].add(number, error);
      if (options.list)
        std::printf("%4zu %5zu steps: %.3e %s\n", number, steps, error, wrc_status_name(spoilt));
    }
    show_progress("loop", row + 1, file.rows());
  }
  return report;
}

}  // namespace compare
