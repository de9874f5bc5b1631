/// pressure_report - the pressure solver of a wheel on a rail at work (docs/surface_solver.md).
///
///     pressure_report trace [A B DEGREES UM]  one solve, iteration by iteration: two bodies with the gap A x'^2 + B y'^2
///                                             [1/m], axes turned by the angle, approached by UM micrometres
///     pressure_report map                     part of an error in L that the fixed-point map takes away, and part that a
///                                             preconditioned step leaves, by the error's wave length: the constants of
///                                             precondition() (src/surface/pressure/iteration.cpp) against these
///     pressure_report memory                  bytes of a contact at each setting: its state, and of a wheel on a rail
///                                             the results and the scratch of each stage, which share their memory
///
/// The contact is Hertz's, on flat strips of 0.25 mm, so that its load is known.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <numbers>
#include <vector>

#include "abi/handles.hpp"
#include "base/instruction_set.hpp"
#include "normal/elasticity/hertz_theory.hpp"
#include "patch/material.hpp"
#include "surface/pressure/iteration.hpp"
#include "surface/pressure/start.hpp"
#include "surface/wrench/wheel_solution.hpp"
#include "wrc/wrc.h"

namespace {

using namespace wrc;

constexpr double strip_width = 0.25e-3;  // [m]

/// Strips under a gap whose axes are turned, and the memory of a solve.
class Case {
 public:
  Case(double A, double B, double degrees, double approach) {
    normal::tabulate(*influence_);
    const double angle = degrees * std::numbers::pi / 180.0, c = std::cos(angle), s = std::sin(angle);
    const double xx = A * c * c + B * s * s, xy = 2.0 * (A - B) * c * s, yy = A * s * s + B * c * c;
    for (int i = -200; i <= 200; ++i) {
      const double y = i * strip_width, depth = approach - (yy - xy * xy / (4.0 * xx)) * y * y;
      if (depth <= 0.0) continue;
      number_.push_back(static_cast<std::int32_t>(number_.size()));
      place_.push_back(y);
      depth_.push_back(depth);
      deepest_.push_back(-xy * y / (2.0 * xx));
    }
    curvature_ = 2.0 * xx;
    overlaps_.capacity = overlaps_.count = static_cast<std::int32_t>(number_.size());
    overlaps_.strip = number_.data();
    Arena counted;
    surface::cut_pressure_scratch(counted, overlaps_.count);
    memory_.resize(static_cast<std::size_t>(counted.doubles()));
    Arena arena(memory_.data());
    w = surface::cut_pressure_scratch(arena, overlaps_.count);
  }

  void load() {
    surface::StripSet& s = w.fine;
    s.count = overlaps_.count;
    for (std::int32_t i = 0; i < s.count; ++i) {
      const auto k = static_cast<std::size_t>(i);
      s.place[i] = place_[k];
      s.width[i] = strip_width;
      s.depth[i] = depth_[k];
      s.curvature[i] = curvature_;
      s.deepest_x[i] = deepest_[k];
      s.ny[i] = 0.0;
      s.nz[i] = 1.0;
    }
  }
  std::int32_t start(std::int32_t most = surface::usual_iterations) {
    load();
    return surface::start_from_overlaps(problem(), overlaps_, options.max_work, w, most);
  }
  surface::PressureProblem problem() const {
    return {kernels_for(best_instruction_set()),
            {influence_->tables(), influence_->mean_under.data()},
            steel.normal_compliance(),
            surface::usual_lambda_length,
            false};
  }

  surface::PressureScratch w;
  surface::PressureOptions options;
  const patch::Material steel = {82e9, 0.28};

 private:
  std::unique_ptr<normal::InfluenceTables> influence_ = std::make_unique<normal::InfluenceTables>();
  std::vector<std::int32_t> number_;
  std::vector<double> place_, depth_, deepest_, memory_;
  double curvature_ = 0.0;
  surface::Overlaps overlaps_;
};

double load_of(const surface::StripSet& s) {
  double load = 0.0;
  for (std::int32_t i = 0; i < s.count; ++i) load += 0.5 * std::numbers::pi * s.width[i] * s.q[i];
  return load;
}

void print_iteration(const char* stage, std::int32_t k, const surface::StripSet& s,
                     const surface::PressureScratch& w, double end) {
  double longest = 0.0, aside = 0.0;
  for (std::int32_t i = 0; i < s.count; ++i) {
    longest = std::max(longest, std::sqrt(s.L[i]));
    aside = std::max(aside, s.L[i] > 0.0 ? std::fabs(s.shift[i]) : 0.0);
  }
  std::printf("%-5s %3d %7d %13.2e %12.3f %12.2e %10.4f %10.4f\n", stage, k, w.active.count,
              w.change.moved / w.change.area, load_of(s), load_of(s) / end - 1.0, 1e3 * longest, 1e3 * aside);
}

void trace(double A, double B, double degrees, double approach) {
  Case c(A, B, degrees, approach);
  const surface::PressureProblem problem = c.problem();
  c.start();
  surface::IterationLimits limits{c.options.tolerance, surface::any_change, c.options.max_work};
  const surface::PressureResult result = surface::iterate(problem, c.w.fine, limits, c.w);
  const double end = load_of(c.w.fine);
  const normal::HertzEllipse hertz = normal::hertz_ellipse(A, B, approach, c.steel.normal_compliance());
  std::printf("Hertz: %.3f N, half axes %.4f and %.4f mm\n\n", hertz.normal_force, 1e3 * hertz.a,
              1e3 * hertz.b);
  std::printf("stage   k  active  moved/area       load N  from the end  longest l  largest shift (mm)\n");
  for (std::int32_t k = 1;; ++k) {
    const bool ended = c.start(k) < k;
    if (ended) break;
    print_iteration("half", k, c.w.coarse, c.w, end);
  }
  for (std::int32_t k = 1; k <= result.iterations; ++k) {
    c.start();
    limits.most = k;
    surface::iterate(problem, c.w.fine, limits, c.w);
    print_iteration("full", k, c.w.fine, c.w, end);
  }
  std::printf("\n   s mm     d um     W mm     c mm     l mm   lambda MPa/mm   q N/mm   peak MPa\n");
  const surface::StripSet& s = c.w.fine;
  for (std::int32_t i = 0; i < s.count; i += 4) {
    if (!(s.L[i] > 0.0)) continue;
    const double l = std::sqrt(s.L[i]), lambda = s.q[i] / s.L[i];
    std::printf("%7.2f %8.3f %8.4f %8.4f %8.4f %15.3f %8.2f %10.2f\n", 1e3 * s.place[i], 1e6 * s.depth[i],
                1e3 * s.deepest_x[i], 1e3 * (s.deepest_x[i] + s.shift[i]), 1e3 * l, 1e-9 * lambda,
                1e-3 * s.q[i], 1e-6 * lambda * l);
  }
}

/// Errors L^(3/4) cos(2 pi a / length), as they vanish at the rims, and the parts of them taken away and
/// left.
void print_map(double A, double B) {
  Case c(A, B, 0.0, 60e-6);
  const surface::PressureProblem problem = c.problem();
  surface::StripSet& s = c.w.fine;
  c.start();
  surface::iterate(problem, s, {1e-11, surface::any_change, c.options.max_work}, c.w);
  const auto n = static_cast<std::size_t>(s.count);
  const std::vector<double> solution(s.L, s.L + n);
  const auto strips = std::count_if(solution.begin(), solution.end(), [](double L) { return L > 0.0; });
  for (const double length : {2.0, 3.0, 4.0, 6.0, 10.0, 1e9}) {
    std::vector<double> error(n, 0.0);
    double largest = 0.0;
    for (std::size_t i = 0; i < n; ++i) largest = std::max(largest, solution[i]);
    double square = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      if (!(solution[i] > 0.2 * largest)) continue;  // inside, where lengths are longer than strips wide
      error[i] = 1e-4 * largest * std::pow(solution[i] / largest, 0.75) *
                 std::cos(2.0 * std::numbers::pi * static_cast<double>(i) / length);
      square += error[i] * error[i];
    }
    for (std::size_t i = 0; i < n; ++i) s.L[i] = solution[i] + error[i];
    surface::begin_iterations(s, c.w);
    surface::evaluate(problem, s, surface::Asked::all, c.w);
    std::vector<double> step(c.w.residual, c.w.residual + 2 * n);
    double taken = 0.0;
    for (std::size_t i = 0; i < n; ++i) taken -= c.w.residual[i] * error[i];
    surface::precondition(s, step.data(), c.w);
    double left = 0.0;
    for (std::size_t i = 0; i < n; ++i)
      if (error[i] != 0.0) left += (error[i] + step[i]) * (error[i] + step[i]);
    std::printf("%8.2f %8td %12.0f %10.3f %10.3f\n", A / B, strips, length < 1e6 ? length : 0.0,
                taken / square, std::sqrt(left / square));
  }
}

/// Bytes of a contact of S1002 on UIC60 at each setting.
int print_memory() {
  std::printf("%-19s", "setting");
  for (const char* const of :
       {"contact", "state", "results", "overlaps", "pressure", "rolling", "derivatives", "model"})
    std::printf(" %11s", of);
  std::printf("\n");
#define WRC_RESOLUTION(identifier, name, ...) name,
  const char* const settings[] = {WRC_RESOLUTION_LIST(WRC_RESOLUTION)};
#undef WRC_RESOLUTION
  const auto print = [](const char* setting, int32_t memory) {
    wrc_config config = wrc_config_default();
    config.wheel.kind = WRC_PROFILE_S1002;
    config.rail.kind = WRC_PROFILE_UIC60_BENCHMARK;
    config.surface.memory = memory;
    wrc_model* model = nullptr;
    std::uint64_t contact = 0, state = 0, own = 0, alignment = 0;
    if (wrc_config_use(&config, setting, nullptr, 0) != WRC_OK ||
        wrc_model_create(&config, nullptr, &model, nullptr, 0) != WRC_OK)
      return false;
    wrc_contact_size(model, &contact, &alignment);
    wrc_contact_state_size(model, &state);
    wrc_model_size(&config, &own, &alignment);
    const auto b = surface::wheel_work_bytes(surface::work_sizes(*model->model->surface));
    std::printf("%-10s%-9s", setting, memory ? ", memory" : "");
    for (const auto bytes :
         {static_cast<std::int64_t>(contact), static_cast<std::int64_t>(state), b.results, b.overlaps,
          b.pressure, b.rolling, b.derivatives, static_cast<std::int64_t>(own)})
      std::printf(" %11lld", static_cast<long long>(bytes));
    std::printf("\n");
    wrc_model_destroy(model);
    return true;
  };
  for (const int32_t memory : {0, 1})
    for (const char* const setting : settings)
      if (!print(setting, memory)) return 1;
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  if (count > 1 && !std::strcmp(arguments[1], "memory")) return print_memory();
  const auto number = [&](int i, double otherwise) {
    return count > i ? std::atof(arguments[i]) : otherwise;
  };
  if (count > 1 && !std::strcmp(arguments[1], "trace")) {
    trace(number(2, 1.2), number(3, 3.0), number(4, 30.0), 1e-6 * number(5, 60.0));
    return 0;
  }
  if (count > 1 && !std::strcmp(arguments[1], "map")) {
    std::printf(
        "     A/B   strips  wave/strips  taken away  left by a step   (wave 0: the same everywhere)\n");
    for (const double ratio : {0.25, 0.5, 1.0, 2.0}) print_map(1.0, 1.0 / ratio);
    return 0;
  }
  std::puts("pressure_report trace [A B DEGREES UM] | map | memory");
  return 2;
}
