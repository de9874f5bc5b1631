/// Cost of every stage and variant against strips and cells, with Google Benchmark:
///     step_cost                                                       a table
///     step_cost --benchmark_filter=tangential                         part of it
///     step_cost --benchmark_out=cost.json --benchmark_out_format=json for a machine
/// Times are of this machine in this minute; compare rows of one run only.
#include <benchmark/benchmark.h>

#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "proof/wheel.hpp"
#include "wrc/wrc_surface.h"

namespace {

/// Inputs go round in this many positions, so that neither caches nor branches learn one case by heart.
constexpr int positions = 64;

/// A wheel driven across the head, with the cost of all but the named stage kept out of the time.
class Driven {
 public:
  explicit Driven(const Methods& methods) : wheel(methods) {
    for (int i = 0; i < positions; ++i) {
      vary(i);
      gaps_.push_back(wheel.gap_of_pose());
    }
  }
  const Gap& gap(int i) const { return gaps_[static_cast<std::size_t>(i % positions)]; }
  void vary(int i) {
    wheel.vary(i % positions);
    wheel.pose.lateral = -3e-3 + 8e-3 * (i % positions) / positions;
    wheel.load.prescribed = WRC_PRESCRIBE_NORMAL_FORCE;
  }
  Wheel wheel;

 private:
  std::vector<Gap> gaps_;
};

void step_from_pose(benchmark::State& state, Methods methods) {
  Driven driven(methods);
  int i = 0;
  for (auto _ : state) {
    driven.vary(++i);
    benchmark::DoNotOptimize(driven.wheel.step());
  }
}

void step_from_gap(benchmark::State& state, Methods methods) {
  Driven driven(methods);
  int i = 0;
  for (auto _ : state) {
    driven.vary(++i);
    benchmark::DoNotOptimize(driven.wheel.step_with(driven.gap(i)));
  }
}

void geometry(benchmark::State& state, Methods methods) {
  Driven driven(methods);
  int i = 0;
  for (auto _ : state) {
    driven.vary(++i);
    benchmark::DoNotOptimize(driven.wheel.geometry());
  }
}

void normal(benchmark::State& state, Methods methods) {
  Driven driven(methods);
  int i = 0;
  for (auto _ : state) {
    driven.vary(++i);
    const wrc_planar_gap rows = shown(driven.gap(i));
    benchmark::DoNotOptimize(
        wrc_planar_normal(driven.wheel.contact, &rows, &driven.wheel.load, &driven.wheel.output.normal));
  }
}

/// On the patch of one position: the tangential problem's cost hardly depends on the patch, but on the
/// creepages.
void tangential(benchmark::State& state, Methods methods) {
  Driven driven(methods);
  Wheel& wheel = driven.wheel;
  driven.vary(20);
  wheel.step();
  int i = 0;
  for (auto _ : state) {
    driven.vary(++i);
    benchmark::DoNotOptimize(wrc_planar_tangential(wheel.contact, nullptr, &wheel.creepage, &wheel.friction,
                                                   &wheel.output.forces));
  }
}

void damage(benchmark::State& state, Methods methods) {
  Driven driven(methods);
  driven.vary(20);
  driven.wheel.step();
  for (auto _ : state)
    benchmark::DoNotOptimize(
        wrc_contact_damage(driven.wheel.contact, WRC_ALL_REGIONS, &driven.wheel.output.damage));
}

void wear(benchmark::State& state, Methods methods) {
  Driven driven(methods);
  driven.vary(20);
  driven.wheel.step();
  wrc_wear numbers{};
  for (auto _ : state)
    benchmark::DoNotOptimize(wrc_contact_wear(driven.wheel.contact, WRC_ALL_REGIONS, nullptr, &numbers));
}

void save_and_restore(benchmark::State& state, Methods methods) {
  Driven driven(methods);
  driven.vary(20);
  driven.wheel.step();
  for (auto _ : state) {
    driven.wheel.save();
    benchmark::DoNotOptimize(driven.wheel.restore());
  }
}

/// A wheel on its rail at "real time": the wrench alone, or with friction of films before it and the passage
/// behind it, without and with layers, on one band of each body or on 8 rows of 8 mm across.
void wheel_on_films(benchmark::State& state, const char* set, uint32_t rows) {
  wrc_config config = wrc_config_default();
  config.wheel.kind = WRC_PROFILE_S1002;
  config.rail.kind = WRC_PROFILE_60E1;
  config.track.rail_inclination = 1.0 / 40.0;
  wrc_config_use(&config, "real time", nullptr, 0);
  wrc_model* model = nullptr;
  wrc_contact* contact = nullptr;
  wrc_model_create(&config, nullptr, &model, nullptr, 0);
  wrc_contact_create(model, WRC_SIDE_RIGHT, nullptr, &contact, nullptr, 0);
  const uint32_t counts[2] = {1000, 24};
  std::vector<wrc_surface_bin> bins[2] = {std::vector<wrc_surface_bin>(counts[0] * rows),
                                          std::vector<wrc_surface_bin>(counts[1] * rows)};
  std::vector<double> across(WRC_FILM_NUMBERS(rows, rows));
  wrc_surface surface[2] = {wrc_surface_default(), wrc_surface_default()};
  for (int body = 0; body < 2; ++body) {
    surface[body].count = counts[body];
    surface[body].rows = rows;
    if (rows > 1) surface[body].width = 8e-3;
    surface[body].row_first = -37e-3;
    surface[body].length = body == 0 ? 1.0 : 2.89 / 24;
    surface[body].closed = 1;
    surface[body].bins = bins[body].data();
    surface[body].bin_size = sizeof(wrc_surface_bin);
  }
  wrc_surface_laws laws = wrc_surface_laws_default();
  if (set != nullptr) wrc_surface_laws_use(&laws, set, nullptr, 0);
  for (const int32_t wet_leaves : {WRC_SURFACE_WATER, WRC_SURFACE_FILM})
    wrc_surface_add(&surface[0], wet_leaves, 4e-3, 0.0, 1000.0, nullptr, 0);
  wrc_wheel_input input = wrc_wheel_input_default();
  input.wheel.z = 0.1e-3;
  input.wheel.velocity[0] = 40.0;
  input.wheel.pitch_rate = -40.0 / 0.46 * 0.98;
  input.friction.coefficient = 0.1;
  wrc_surface_passage passage = {};
  passage.struct_size = sizeof passage;
  if (rows > 1) {
    passage.film_rows = across.data();
    passage.film_numbers = static_cast<uint32_t>(across.size());
    passage.contact = contact;
  }
  wrc_wrench wrench = {};
  wrench.struct_size = sizeof wrench;
  int i = 0;
  for (auto _ : state) {
    input.wheel.y = 4e-3 * (++i % positions) / positions - 2e-3;
    passage.rail_from = passage.rail_to;
    passage.wheel_from = passage.wheel_to;
    passage.rail_to += 0.04;
    passage.wheel_to += 0.0392;
    if (set != nullptr)
      wrc_surface_friction(&surface[0], &surface[1], &laws, &passage, nullptr, &input.friction, nullptr, 0);
    benchmark::DoNotOptimize(wrc_contact_wrench(contact, &input, &wrench));
    passage.energy = wrench.power * 1e-3;
    if (set != nullptr) wrc_surface_pass(&surface[0], &surface[1], &laws, &passage, nullptr, nullptr, 0);
  }
  wrc_contact_destroy(contact);
  wrc_model_destroy(model);
}

void creation(benchmark::State& state, Methods methods) {
  for (auto _ : state) Wheel wheel(methods);
}

using Work = void (*)(benchmark::State&, Methods);

void add(const std::string& stage, const std::string& variant, const Methods& methods, Work work) {
  const std::string name =
      stage + "/" + variant + "/" + std::to_string(methods.strips) + "x" + std::to_string(methods.cells);
  benchmark::RegisterBenchmark(name.c_str(), work, methods)->Unit(benchmark::kMicrosecond);
}

void add_all() {
  const std::pair<int, int> grids[] = {{16, 16}, {32, 32}, {60, 32}, {60, 50}, {128, 64}};
  Methods methods;
  add("geometry", "pose", methods, geometry);
  for (const auto& [name, set, rows] :
       {std::tuple<const char*, const char*, uint32_t>{"wheel/wrench alone", nullptr, 1},
        {"wheel/with films", "low adhesion", 1},
        {"wheel/with films and layers", "low adhesion, layers", 1},
        {"wheel/with films in rows", "low adhesion", 8},
        {"wheel/with films and layers in rows", "low adhesion, layers", 8}})
    benchmark::RegisterBenchmark(name, wheel_on_films, set, rows)->Unit(benchmark::kMicrosecond);
  for (const auto& [strips, cells] : grids) {
    methods.strips = strips;
    methods.cells = cells;
    for (int32_t each = 0; each < normal_methods; ++each) {
      methods.normal = each;
      add("normal", normal_names[each], methods, normal);
    }
    methods.normal = WRC_NORMAL_STRIP_HALFSPACE;
    for (int32_t each = 0; each < tangential_methods; ++each) {
      methods.tangential = each;
      add("tangential", presets[each].identifier, methods, tangential);
    }
    methods.tangential = preset_strip_fastsim;
    add("damage", "all", methods, damage);
    add("wear", "all", methods, wear);
    add("state", "save and restore", methods, save_and_restore);
    add("step", "from gap", methods, step_from_gap);
    add("step", "from pose", methods, step_from_pose);
    add("creation", "model and contact", methods, creation);
  }
}

}  // namespace

int main(int count, char** arguments) {
  add_all();
  benchmark::Initialize(&count, arguments);
  if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
