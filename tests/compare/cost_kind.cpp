/// Calls of a wheel on rails of sections, one by one, beside the same calls on the rail of the case held
/// constant: for tests/bench/crossing_cost.py, which counts the instructions of each.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>
#include <stdexcept>
#include <string>

#include "kinds.hpp"
#include "settings_cases.hpp"

/// What the counting is switched on for, by this name.
extern "C" __attribute__((noinline, visibility("default"))) int32_t measured_steps(compare::WheelCase& wheel,
                                                                                   const compare::Solver& on);

extern "C" int32_t measured_steps(compare::WheelCase& wheel, const compare::Solver& on) {
  return wheel.solve(on);
}

namespace compare {
namespace {

constexpr double inside = 5e-3;  // from the ends of the sections [m]

/// One line of the output for each call that is counted, in their order.
struct Calls {
  const char* rail;
  const Solver& solver;
  Report& report;

  void count(WheelCase& wheel, const char* way) {
    const int32_t status = measured_steps(wheel, solver);
    if (status < 0) throw std::runtime_error(solver.reason(status));
    const std::size_t row = report.rows++;
    report.errors[report.default_variant]["flagged"].add(row, status != WRC_OK ? 1.0 : 0.0);
    const Vector force = wheel.force();
    std::printf("call %s, %s, y %.3f mm, at %.2f mm: %.9g %.9g %.9g N\n", rail, way,
                1e3 * wheel.input.wheel.y, 1e3 * wheel.input.distance, force[0], force[1], force[2]);
  }

  /// Cold calls at one place: under the load, and at the height that was found.
  void cold(WheelCase wheel) {
    count(wheel, "cold, load");
    at_height(wheel);
    count(wheel, "cold, height");
  }

  /// A step of a host: from the marked solution, which is marked then. Both calls start from the same mark.
  void marked(WheelCase wheel, bool counted) {
    wheel.input.start = WRC_START_MARK;
    if (counted)
      count(wheel, "mark, load");
    else
      wheel.solve(solver);
    WheelCase again = wheel;
    at_height(again);
    if (counted) count(again, "mark, height");
    wheel.solve(solver);
    wrc_contact_mark(solver.contact());
  }

 private:
  static void at_height(WheelCase& wheel) {
    wheel.input.prescribed = WRC_PRESCRIBE_HEIGHT;
    wheel.input.vertical_load = 0.0;
    wheel.input.wheel.z = wheel.wrench.z;
  }
};

/// A host's run over the line: 1 ms at 80 km/h a step. The wheel moves aside by 0.05 mm a step, and its load
/// sways by 5 % with a period of 12 steps.
void run(Calls& calls, const WheelCase& about, double begin, double end, bool changes) {
  constexpr double step = 80.0 / 3.6 * 1e-3, aside = 0.05e-3;  // [m]
  const int steps = static_cast<int>((end - begin) / step);
  for (int k = 0; k <= steps; ++k) {
    WheelCase wheel = about;
    wheel.input.wheel.y += aside * (k - steps / 2);
    wheel.input.vertical_load *= 1.0 + 0.05 * std::sin(k * 2.0 * std::acos(-1.0) / 12.0);
    wheel.input.distance = changes ? begin + k * step : 0.0;
    calls.marked(wheel, k > 1);  // a first and a second mark come before
  }
}

}  // namespace

Report compare_cost(const Csv& file, const Options& options) {
  Report report;
  report.kind = options.kind;
  report.measures = {"flagged"};
  report.units = {{"flagged", "1"}};
  report.default_variant = "wrc_contact_wrench";
  report.variants = {report.default_variant};
  CaseBodies varying(file, options.setting), constant(file, options.setting, false);
  std::set<std::string> rails;
  for (const CaseRows& rows : case_rows(file)) {
    if (!options.wanted(rows.number) || !rails.insert(file.text(rows.first, "sections")).second) continue;
    const CaseBodies::Made& made = varying.of(rows.first);
    const double begin = std::max(options.from, made.begin + inside),
                 end = std::min(options.to, made.end - inside);
    for (CaseBodies* const bodies : {&varying, &constant}) {
      const bool changes = bodies == &varying;
      Calls calls{changes ? "sections" : "constant", *bodies->of(rows.first).solver, report};
      for (int k = -most_beside; k <= most_beside; ++k) {
        if (!options.wants_beside(k)) continue;
        WheelCase wheel = case_of(file, rows.first, {});
        wheel.input.wheel.y += 1e-3 * k;
        const int places = 1 + static_cast<int>((end - begin) / options.step + 1e-9);
        // the rail that is the same everywhere has one place
        for (int place = 0; place < (changes ? places : 1); ++place) {
          wheel.input.distance = changes ? begin + place * options.step : 0.0;
          calls.cold(wheel);
        }
        run(calls, wheel, begin, end, changes);
      }
    }
  }
  return report;
}

}  // namespace compare
