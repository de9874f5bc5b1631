// How good and how fast the force table is:
//     force_table_report FILE [patches]
// Error against the exact solver on random patches that are no nodes of the table, extrapolated from 24 x 24
// and 48 x 48 cells (own error 0.04 % median, 0.15 % at the 95th percentile): a/b 0.25 to 3 (logarithmic),
// |psi| up to 0.7, Poisson's ratio 0.25 to 0.30, peak pressure 0.5 to 1.8 GPa, friction 0.1 to 0.5; creepages
// cause 0.1 to 6 friction limits by linear theory; one patch in five without spin, one with spin alone, one
// with spin against lateral creepage. Then the same for single Poisson's ratios, and cost against
// FASTSIM-SDEC.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <random>
#include <vector>

#include "halfspace/tangential.hpp"
#include "patch/material.hpp"
#include "sdec_pressure.hpp"
#include "tangential/force_table/force_table_file.hpp"
#include "test_config.hpp"
#include "wrc/wrc_planar.h"

namespace {

using namespace wrc;

struct Case {
  patch::Sdec patch;
  double normal_force = 0.0, friction = 0.0, poisson = 0.0;
  tangential::Creepage creepage;

  double limit() const { return friction * normal_force; }
  double size() const { return std::sqrt(patch.a * patch.b); }
};
constexpr double shear_modulus = 80e9;

class Random {
 public:
  // The engine's own bits: the same patches with every standard library.
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_()) / 4294967296.0;
  }
  double logarithmic(double low, double high) { return low * std::pow(high / low, uniform(0.0, 1.0)); }

 private:
  std::mt19937 engine_{20240607};
};

// poisson 0: 0.25 to 0.30
Case random_case(Random& random, double poisson) {
  Case c;
  const double ratio = random.logarithmic(0.25, 3.0), size = random.uniform(3e-3, 8e-3);
  c.patch = {size * std::sqrt(ratio), size / std::sqrt(ratio), random.uniform(-0.7, 0.7)};
  c.normal_force = 2.0 / 3.0 * pi * size * size * random.uniform(0.5e9, 1.8e9);
  c.friction = random.uniform(0.1, 0.5);
  const double any = random.uniform(0.25, 0.30);
  c.poisson = poisson > 0.0 ? poisson : any;
  double spin = random.uniform(-1.0, 1.0);
  const double angle = random.uniform(0.0, 2.0 * pi), kind = random.uniform(0.0, 1.0);
  if (kind < 0.2) spin = 0.0;
  if (kind >= 0.2 && kind < 0.4) spin = spin < 0.0 ? -1.0 : 1.0;
  const double rest = std::sqrt(1.0 - spin * spin), x = rest * std::cos(angle);
  double y = rest * std::sin(angle);
  if (kind >= 0.4 && kind < 0.6 && y * spin > 0.0) y = -y;
  Fault fault;
  const theory::SdecCoefficients linear = theory::SdecTable(c.poisson).at(ratio, c.patch.psi, fault);
  const double unit = random.logarithmic(0.1, 6.0) * c.limit() / (shear_modulus * size * size);
  c.creepage = {x * unit / linear.c11, y * unit / linear.c22, spin * unit / (linear.c23 * size)};
  return c;
}

tangential::TangentialForces exact(const Case& c) {
  const halfspace::SdecPatch patch{c.patch.a, c.patch.b, c.patch.psi};
  const auto on = [&](int cells) {
    const halfspace::Grid grid = halfspace::grid_over(patch, cells, cells);
    halfspace::RollingProblem problem;
    problem.pressure = halfspace::sdec_pressure(patch, patch::peak_pressure(c.patch, c.normal_force), grid,
                                                halfspace::CellPressure::mean);
    problem.friction = {c.friction};
    problem.creepage = c.creepage;
    return halfspace::RollingSolver(grid, {shear_modulus, c.poisson}).solve(problem).forces;
  };
  const tangential::TangentialForces coarse = on(24), fine = on(48);
  tangential::TangentialForces f;
  f.fx = 2.0 * fine.fx - coarse.fx;
  f.fy = 2.0 * fine.fy - coarse.fy;
  f.mz = 2.0 * fine.mz - coarse.mz;
  f.power_per_speed = -(f.fx * c.creepage.longitudinal + f.fy * c.creepage.lateral + f.mz * c.creepage.spin);
  f.adhesion_fraction = fine.adhesion_fraction;
  return f;
}

void print(const char* what, std::vector<double> errors) {
  std::sort(errors.begin(), errors.end());
  const std::size_t n = errors.size();
  if (n == 0) return;
  std::printf("  %-46s median %6.3f   p95 %6.3f   worst %6.3f %%\n", what, 100.0 * errors[n / 2],
              100.0 * errors[n * 95 / 100], 100.0 * errors[n - 1]);
}

void report_errors(tangential::ForceTable& table, int patches, double poisson) {
  Random random;
  std::vector<double> force, moment, power, adhesion;
  for (int k = 0; k < patches; ++k) {
    const Case c = random_case(random, poisson);
    tangential::adapt_to_poisson(c.poisson, table);
    Fault fault;
    const tangential::TangentialForces ours = tangential::table_forces(
        table, c.patch, c.normal_force, shear_modulus, c.friction, c.creepage, fault);
    const tangential::TangentialForces e = exact(c);
    force.push_back(std::hypot(ours.fx - e.fx, ours.fy - e.fy) / c.limit());
    const double centre = tangential::pressure_centre(c.patch);
    moment.push_back(std::abs(ours.mz + centre * ours.fx - e.mz - centre * e.fx) / (c.limit() * c.size()));
    adhesion.push_back(std::abs(ours.adhesion_fraction - e.adhesion_fraction));
    if (e.adhesion_fraction < 0.9) power.push_back(std::abs(ours.power_per_speed / e.power_per_speed - 1.0));
  }
  print("force / (mu N)", force);
  print("moment about the pressure's centre / (mu N c)", moment);
  print("power, where less than 0.9 sticks", power);
  print("share that sticks", adhesion);
}

class Timed {
 public:
  Timed(int method, const char* file) {
    wrc_config config = test_config();
    config.tangential.method = method;
    if (method == WRC_TANGENTIAL_FORCE_TABLE) config.tangential.force_table = file;
    config.planar.strips = config.planar.cells = 32;
    if (wrc_model_create(&config, nullptr, &model_, nullptr, 0) < 0 ||
        wrc_contact_create(model_, WRC_SIDE_RIGHT, nullptr, &contact_, nullptr, 0) < 0) {
      std::exit(1);
    }
  }
  ~Timed() {
    wrc_contact_destroy(contact_);
    wrc_model_destroy(model_);
  }
  Timed(const Timed&) = delete;
  Timed& operator=(const Timed&) = delete;

  void run(const Case& c) {
    wrc_ellipse ellipse = sized<wrc_ellipse>();
    ellipse.a = c.patch.a;
    ellipse.b = c.patch.b;
    ellipse.psi = c.patch.psi;
    ellipse.normal_force = c.normal_force;
    wrc_creepage creepage = wrc_creepage_default();
    creepage.longitudinal = c.creepage.longitudinal;
    creepage.lateral = c.creepage.lateral;
    creepage.spin = c.creepage.spin;
    creepage.speed = 1.0;
    wrc_friction friction = wrc_friction_default();
    friction.coefficient = c.friction;
    wrc_planar_tangential(contact_, &ellipse, &creepage, &friction, nullptr);
  }

 private:
  wrc_model* model_ = nullptr;
  wrc_contact* contact_ = nullptr;
};

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template <class Work>
double nanoseconds(const std::vector<Case>& cases, Work&& work) {
  const double start = processor_seconds();
  for (const Case& c : cases) work(c);
  return 1e9 * (processor_seconds() - start) / static_cast<double>(cases.size());
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

// Interleaved: a busy machine slows all three.
void report_speed(const tangential::ForceTable& table, const char* file) {
  Random random;
  std::vector<Case> scattered, neighbours;
  for (int k = 0; k < 300; ++k) scattered.push_back(random_case(random, 0.0));
  for (int k = 0; k < 300; ++k) {  // a wheel's next steps: the same corner of the table
    Case c = scattered[0];
    c.creepage.longitudinal *= 1.0 + 1e-4 * k;
    neighbours.push_back(c);
  }
  Timed march(WRC_TANGENTIAL_FASTSIM, nullptr), by_table(WRC_TANGENTIAL_FORCE_TABLE, file);
  double sum = 0.0;
  const auto look_up = [&](const Case& c) {
    Fault fault;
    sum +=
        tangential::table_forces(table, c.patch, c.normal_force, shear_modulus, c.friction, c.creepage, fault)
            .fx;
  };
  std::vector<double> anywhere, near, call, sdec;
  for (int repeat = 0; repeat < 51; ++repeat) {
    sdec.push_back(nanoseconds(scattered, [&](const Case& c) { march.run(c); }));
    call.push_back(nanoseconds(scattered, [&](const Case& c) { by_table.run(c); }));
    anywhere.push_back(nanoseconds(scattered, look_up));
    near.push_back(nanoseconds(neighbours, look_up));
  }
  const double reference = median(sdec);
  std::printf("processor time, medians of interleaved runs (checksum %.6g)\n", sum);
  std::printf("  FASTSIM-SDEC 32 x 32, wrc_planar_tangential   %8.0f ns   1\n", reference);
  std::printf("  table, wrc_planar_tangential                  %8.0f ns   1/%.0f\n", median(call),
              reference / median(call));
  std::printf("  table alone, scattered patches         %8.0f ns   1/%.0f\n", median(anywhere),
              reference / median(anywhere));
  std::printf("  table alone, neighbouring creepages    %8.0f ns   1/%.0f\n", median(near),
              reference / median(near));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "force_table_report FILE [patches]\n");
    return 2;
  }
  const int patches = argc > 2 ? std::atoi(argv[2]) : 2000;
  tangential::ForceTable table;
  if (tangential::read_force_table_axes(argv[1], table.axes).failed()) return 1;
  std::vector<float> coefficients(tangential::force_table_size(table.axes));
  if (tangential::read_force_table(argv[1], table.axes, coefficients.data()).failed()) return 1;
  table.coefficients = coefficients.data();

  tangential::adapt_to_poisson(0.25, table);
  report_speed(table, argv[1]);
  std::printf("%d patches, Poisson's ratio 0.25 to 0.30\n", patches);
  report_errors(table, patches, 0.0);
  for (const double poisson : {0.20, 0.25, 0.27, 0.30, 0.33}) {
    std::printf("%d patches, Poisson's ratio %.2f\n", patches / 4, poisson);
    report_errors(table, patches / 4, poisson);
  }
  return 0;
}
