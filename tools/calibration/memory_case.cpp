#include "memory_case.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "cases.hpp"
#include "halfspace/transient.hpp"
#include "patch/material.hpp"
#include "random.hpp"
#include "sdec_pressure.hpp"
#include "theory/sdec.hpp"

namespace wrc::calibration {
namespace {

constexpr int half_cells = 8;      // of the coarse grid on a half length; twice as many of the fine one
constexpr double most_load = 1.3;  // over that of the start

/// Displacement, or creepage: along x, along y, rotation.
struct Motion {
  double x = 0.0, y = 0.0, turn = 0.0;
};

Motion operator*(double s, const Motion& m) { return {s * m.x, s * m.y, s * m.turn}; }
Motion operator+(const Motion& m, const Motion& n) { return {m.x + n.x, m.y + n.y, m.turn + n.turn}; }
Motion each(const Motion& m, const Motion& n) { return {m.x * n.x, m.y * n.y, m.turn * n.turn}; }

/// Writes the steps of a case.
class Driver {
 public:
  Driver(MemoryCase& c, Random& random) : case_(c), random_(random) {
    // shifts of full slip, a rotation of nearly full slip, and creepages that saturate linear theory
    const Patch& p = c.patch;
    const double size = std::sqrt(p.a * p.b), limit = p.friction * p.normal_force;
    constexpr int angles = 400;
    for (int k = 0; k < angles; ++k) {
      const double t = 2.0 * pi * k / angles, cosine = std::cos(t), sine = std::sin(t);
      const double radius = 1.0 / std::sqrt(cosine * cosine / (p.a * p.a) + sine * sine / (p.b * p.b));
      const double scale = p.friction * p.p0 / (4.0 * p.shear_modulus) * radius * 2.0 * pi / angles;
      shift_.x += scale * (1.0 - p.poisson * sine * sine);
      shift_.y += scale * (1.0 - p.poisson * cosine * cosine);
    }
    shift_.turn = 1.5 * 9.0 * pi / 128.0 * limit / (p.shear_modulus * p.a * p.b);
    Fault fault;
    const theory::SdecCoefficients linear = theory::SdecTable(p.poisson).at(p.a / p.b, 0.0, fault);
    const double unit = limit / (p.shear_modulus * size * size);
    creepage_ = {unit / linear.c11, unit / linear.c22, 0.5 * unit / (linear.c23 * size)};
  }

  /// Shifts to a place, in times full slip.
  void shift_to(const Motion& place, int steps) {
    const Motion by = (1.0 / steps) * each(shift_, place + -1.0 * place_);
    for (int k = 0; k < steps; ++k) add(0, 0.0, by);
    place_ = place;
  }

  /// Rolls on by `eighths` of a / 8 in a step, with creepages in times saturation.
  void roll(const Motion& creepage, int eighths, int direction = 1) {
    const double rolled = eighths * case_.patch.a / half_cells;
    add(direction, rolled, rolled * each(creepage_, creepage));
  }

  Motion anywhere(double most) {
    return {random_.uniform(-most, most), random_.uniform(-most, most), random_.uniform(-most, most)};
  }

  void line() {
    Motion to = anywhere(1.0);
    const double kind = random_.uniform(0.0, 1.0);
    if (kind < 0.25) to = {1.0, 0.0, 0.0};
    if (kind >= 0.25 && kind < 0.5) to = {0.0, 1.0, 0.0};
    if (kind >= 0.5 && kind < 0.75) to = {0.0, 0.0, 1.0};
    swing(random_.logarithmic(0.25, 1.4) * to);
  }
  void spin() { swing({0.0, 0.0, random_.uniform(0.25, 1.4)}); }
  void circle() {
    const double x = random_.logarithmic(0.25, 1.4), y = x * random_.uniform(0.4, 1.0);
    shift_to({x, 0.0, 0.0}, 10);
    case_.loop = 120;  // exact work with 60 steps is 4 % less
    for (int k = 1; k <= 2 * case_.loop; ++k) {
      const double angle = 2.0 * pi * k / case_.loop;
      shift_to({x * std::cos(angle), y * std::sin(angle), 0.0}, 1);
    }
  }
  void path() {
    const double spin = random_.uniform(0.0, 1.0) < 0.5 ? 0.0 : 1.0;
    for (int leg = 0; leg < 12; ++leg) shift_to(each(anywhere(1.2), {1.0, 1.0, spin}), 6);
  }
  void roll_off() {
    if (random_.uniform(0.0, 1.0) < 0.6) shift_to(anywhere(1.0), 8);
    const Motion creepage = random_.logarithmic(0.3, 3.0) * anywhere(1.0);
    const int eighths = 1 << static_cast<int>(random_.uniform(0.0, 3.0));
    for (int k = 0; k < 48 / eighths; ++k) roll(creepage, eighths);
  }
  void waves() {
    const double length = random_.logarithmic(1.0, 12.0);  // of a
    const int eighths = length > 4.0 ? 2 : 1;
    const Motion mean = random_.uniform(0.0, 1.0) < 0.5 ? Motion{} : 0.7 * anywhere(1.0);
    const Motion amplitude = random_.logarithmic(0.4, 3.0) * anywhere(1.0);
    const int steps = static_cast<int>((2.0 + 1.5 * length) * half_cells / eighths);
    for (int k = 0; k < steps; ++k)
      roll(mean + std::sin(2.0 * pi * (k + 0.5) * eighths / (half_cells * length)) * amplitude, eighths);
  }
  void reversals() {
    const Motion creepage = random_.logarithmic(0.3, 3.0) * anywhere(1.0);
    constexpr int eighths[] = {24, 16, 28, 20}, direction[] = {1, 1, -1, 1};
    for (int leg = 0; leg < 4; ++leg) {
      for (int k = 0; k < eighths[leg]; k += 2) roll(creepage, 2, direction[leg]);
      if (leg < 2) shift_to(place_ + anywhere(0.6), 5);
    }
  }
  void loads_at_rest() {
    const Motion to = anywhere(0.8), swing = random_.uniform(0.0, 1.0) < 0.5 ? Motion{} : anywhere(0.4);
    shift_to(to, 8);
    for (int k = 1; k <= 60; ++k) {
      vary_load(std::sin(2.0 * pi * k / 24));
      shift_to(to + std::sin(2.0 * pi * k / 17) * swing, 1);
    }
  }
  void loads_that_roll() {
    const double length = random_.logarithmic(2.0, 12.0);  // of a
    const Motion creepage = random_.logarithmic(0.3, 2.0) * anywhere(1.0);
    const int steps = static_cast<int>((2.0 + 1.5 * length) * half_cells / 2);
    for (int k = 0; k < steps; ++k) {
      vary_load(std::sin(2.0 * pi * (k + 1.0) * 2 / (half_cells * length)));
      roll(creepage, 2);
    }
  }

 private:
  /// Two loops along a line, of which the second is closed.
  void swing(const Motion& to) {
    case_.loop = 40;
    for (int k = 1; k <= 90; ++k) shift_to(std::sin(2.0 * pi * k / 40) * to, 1);
  }
  void add(int direction, double rolled, const Motion& by) {
    case_.steps.push_back({direction, rolled, by.x, by.y, by.turn, load_, 0, 0, 0});
  }
  /// Load at the end of the next steps, from -1 to 1 over the range.
  void vary_load(double wave) { load_ = case_.patch.normal_force * (1.0 + (most_load - 1.0) * wave); }

  MemoryCase& case_;
  Random& random_;
  Motion shift_, creepage_, place_;
  double load_ = case_.patch.normal_force;
};

struct Kind {
  const char* name;
  void (Driver::*drive)();
};
constexpr Kind at_rest[] = {{"loops at rest", &Driver::line},
                            {"circles at rest", &Driver::circle},
                            {"paths at rest", &Driver::path},
                            {"loads at rest", &Driver::loads_at_rest}};
constexpr Kind rolling[] = {{"shift, then rolling", &Driver::roll_off},
                            {"waves", &Driver::waves},
                            {"stops and reversals", &Driver::reversals},
                            {"loads that roll", &Driver::loads_that_roll}};

/// Three of four sequences roll, as wheels do most of the time.
const Kind& kind_of(std::uint64_t row) {
  return row % 4 == 0 ? at_rest[row / 4 % 4] : rolling[(row - row / 4 - 1) % 4];
}

/// Forces after each step, on cells of a / n.
std::vector<Motion> solve(const MemoryCase& c, int n) {
  const Patch& p = c.patch;
  const int half = c.load_varies() ? n + n / 8 : n;  // room for the largest load
  const double dx = p.a / n, dy = p.b / n;
  const halfspace::Grid grid = halfspace::grid_over({half * dx, half * dy, 0.0}, 2 * half, 2 * half);
  halfspace::TransientSolver solver(grid, {p.shear_modulus, p.poisson});
  halfspace::RollingProblem problem;
  problem.collocation = halfspace::Collocation::reference_program;
  problem.friction = {p.friction};
  std::vector<Motion> forces;
  double load = p.normal_force, pressed = 0.0;
  for (const MemoryStep& step : c.steps) {
    // as many cells as the step rolls; at rest one
    const int cells = step.direction == 0 ? 1 : static_cast<int>(std::lround(step.rolled / grid.dx));
    const double per = 1.0 / (cells * grid.dx);
    problem.creepage = {per * step.x, per * step.y, per * step.turn};
    tangential::TangentialForces found;
    for (int k = 1; k <= cells; ++k) {
      const double now = load + (step.load - load) * k / cells;
      if (now != pressed) {
        const Patch under = under_load(p, now);
        problem.pressure =
            halfspace::sdec_pressure({under.a, under.b, 0.0}, under.p0, grid, halfspace::CellPressure::mean);
        pressed = now;
      }
      found = solver.step(problem, static_cast<halfspace::Rolled>(step.direction)).forces;
    }
    load = step.load;
    forces.push_back({found.fx, found.fy, found.mz});
  }
  return forces;
}

}  // namespace

namespace {

MemoryCase random_case(std::uint64_t seed, std::uint64_t row, void (Driver::*drive)()) {
  Random random(seed, row);
  MemoryCase c{};
  Patch& p = c.patch;
  const double size = random.uniform(3e-3, 8e-3), ratio = random.logarithmic(0.3, 3.0);
  p.a = size * std::sqrt(ratio);
  p.b = size / std::sqrt(ratio);
  p.poisson = random.uniform(0.25, 0.30);
  p.shear_modulus = 82e9;
  p.friction = random.uniform(0.1, 0.5);
  p.p0 = random.uniform(0.5e9, 1.8e9);
  p.normal_force = 2.0 / 3.0 * pi * p.a * p.b * p.p0;
  Driver driver(c, random);
  (driver.*drive)();
  return c;
}

}  // namespace

MemoryCase random_memory_case(std::uint64_t seed, std::uint64_t row) {
  return random_case(seed, row, kind_of(row).drive);
}

MemoryCase random_spin_at_rest(std::uint64_t seed, std::uint64_t row) {
  return random_case(seed, row, &Driver::spin);
}

const char* memory_kind(std::uint64_t row) { return kind_of(row).name; }

Patch under_load(Patch patch, double load) {
  const double scale = std::cbrt(load / patch.normal_force);
  patch.a *= scale;
  patch.b *= scale;
  patch.p0 *= scale;
  patch.normal_force = load;
  return patch;
}

void solve_exactly(MemoryCase& c) {
  const std::vector<Motion> coarse = solve(c, half_cells), fine = solve(c, 2 * half_cells);
  bool has_rolled = false;
  for (std::size_t k = 0; k < c.steps.size(); ++k) {
    has_rolled = has_rolled || c.steps[k].direction != 0;
    const double left = has_rolled ? 0.5 : 0.25;  // of the error, on the fine grid
    const Motion f = (1.0 / (1.0 - left)) * (fine[k] + -left * coarse[k]);
    c.steps[k].fx = f.x;
    c.steps[k].fy = f.y;
    c.steps[k].mz = f.turn;
  }
}

std::string patch_text(const MemoryCase& c) {
  char text[200];
  const Patch& p = c.patch;
  std::snprintf(text, sizeof text, "%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%d", p.a, p.b, p.poisson, p.shear_modulus,
                p.friction, p.normal_force, c.loop);
  return text;
}

std::string text_of(const MemoryCase& c) {
  std::string line = patch_text(c) + ",";
  char text[200];
  for (const MemoryStep& s : c.steps) {
    std::snprintf(text, sizeof text, "%d %.9g %.9g %.9g %.9g %.9g %.7g %.7g %.7g ", s.direction, s.rolled,
                  s.x, s.y, s.turn, s.load, s.fx, s.fy, s.mz);
    line += text;
  }
  return line;
}

std::vector<MemoryCase> read_memory_cases(const std::string& path) {
  std::vector<MemoryCase> cases;
  read_rows(path, memory_heading, "make_patches memory", [&](std::istringstream& text) {
    MemoryCase c{};
    Patch& p = c.patch;
    text >> p.a >> p.b >> p.poisson >> p.shear_modulus >> p.friction >> p.normal_force >> c.loop;
    if (!text) return false;
    p.p0 = 1.5 * p.normal_force / (pi * p.a * p.b);
    for (MemoryStep s{};
         text >> s.direction >> s.rolled >> s.x >> s.y >> s.turn >> s.load >> s.fx >> s.fy >> s.mz;)
      c.steps.push_back(s);
    cases.push_back(c);
    return true;
  });
  return cases;
}

}  // namespace wrc::calibration
