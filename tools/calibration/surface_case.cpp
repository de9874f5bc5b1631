#include "surface_case.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "cases.hpp"
#include "geometry/standard_profiles.hpp"
#include "halfspace/pressure.hpp"
#include "halfspace/tangential.hpp"
#include "kernels/kernels.hpp"
#include "patch/material.hpp"
#include "random.hpp"
#include "surface/wrench/wheel_on_rail.hpp"

namespace wrc::calibration {
namespace {

constexpr double G = 82e9, poisson = 0.28, tape_circle_y = 0.75, rail_y = 0.7605325577, radius = 0.46;

/// An S1002 and a UIC60, with all the memory a solve needs.
class Pair {
 public:
  Pair() : ellipse_(poisson), march_memory_(tangential::march_grid_size(8)) {
    wheel_memory_.resize(5 * geometry::s1002_nodes);
    rail_memory_.resize(5 * geometry::uic60_benchmark_nodes);
    surface::SurfaceBodies bodies;
    grid_ = tangential::make_march_grid(8, march_memory_.data(), kernels_for(InstructionSet::baseline));
    normal::tabulate(influence_);
    if (geometry::sample_s1002(geometry::profile_memory(geometry::s1002_nodes, wheel_memory_.data()),
                               bodies.wheel)
            .failed() ||
        geometry::sample_uic60_benchmark(
            geometry::profile_memory(geometry::uic60_benchmark_nodes, rail_memory_.data()), bodies.rail)
            .failed())
      throw std::string("the profiles cannot be made");
    bodies.rail_origin_y = rail_y;
    bodies.nominal_radius = radius;
    bodies.material = {G, poisson};
    bodies.influence = &influence_;
    bodies.kernels = &kernels_for(InstructionSet::baseline);
    bodies.ellipse = &ellipse_;
    bodies.grid = &grid_;
    model_memory_.resize(surface::surface_model_bytes(bodies.wheel.count, bodies.rail.count, 0, 0, 1, {}) /
                             sizeof(double) +
                         1);
    if (surface::make_surface_model(bodies, model_memory_.data(), model_).failed())
      throw std::string("the wheel on the rail cannot be made");
    workspace_.resize(static_cast<std::size_t>(surface::surface_workspace_bytes(*model_)) / sizeof(double) +
                      1);
    Arena counted;
    surface::cut_surface_state(counted, model_->most_overlapping, 0);
    state_.resize(static_cast<std::size_t>(counted.doubles()));
  }

  const surface::SurfaceModel& model() const { return *model_; }

  /// Height of the wheel under the load, no friction; false where there is none.
  bool press(surface::WheelOnRail& in) {
    Arena arena(state_.data());
    const surface::SurfaceState state = surface::cut_surface_state(arena, model_->most_overlapping, 0);
    surface::Wrench wrench;
    in.load_prescribed = true;
    in.friction = 0.0;
    if (surface::solve_wheel_on_rail(*model_, in, surface::SolutionStart::anew, state, workspace_.data(),
                                     wrench)
            .status != WRC_OK)
      return false;
    in.wheel.position[2] = wrench.height;
    return true;
  }

  /// Strips in contact at that height, without slips; their points of the wheel.
  std::vector<SurfaceStrip> strips(const surface::WheelOnRail& in,
                                   std::vector<std::array<double, 3>>& points) {
    const std::int32_t most = model_->most_overlapping;
    surface::RelativePose pose;
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) pose.rotation[i][k] = in.wheel.rotation[i][k];
    }
    pose.y = in.wheel.position[1] - rail_y;
    pose.z = in.wheel.position[2];
    const auto cut = [&](Arena arena, surface::Overlaps& o, surface::OverlapScratch& scratch,
                         surface::StripPressure& p) {
      o = surface::cut_overlaps(arena, most, false);
      scratch = surface::cut_overlap_scratch(arena, surface::most_curve_pieces(geometry::s1002_nodes),
                                             surface::most_strips_of_a_rail);
      arena.each(most, p.length_squared, p.peak_per_length, p.centre, p.line_load);
      return arena.doubles();
    };
    surface::Overlaps memory;
    surface::OverlapScratch scratch;
    surface::StripPressure p;
    std::vector<double> doubles(static_cast<std::size_t>(cut(Arena(), memory, scratch, p)));
    cut(Arena(doubles.data()), memory, scratch, p);
    const surface::Overlaps o = surface::find_overlaps(*model_->kernels, model_->rail, model_->wheel, pose,
                                                       0.0, nullptr, scratch, memory);
    std::vector<double> normal(static_cast<std::size_t>(surface::pressure_doubles(o.capacity)));
    Arena arena(state_.data());
    const surface::KeptStart kept = surface::cut_surface_state(arena, model_->most_overlapping, 0).last;
    surface::PressureStart start{kept.strip, kept.length_squared, kept.shift, kept.depth};
    surface::solve_pressure(surface::pressure_model(*model_), model_->rail, o, {}, normal.data(), start,
                            surface::StartFrom::overlaps, p);
    std::vector<SurfaceStrip> found;
    points.clear();
    for (std::int32_t i = 0; i < o.count; ++i) {
      if (!(p.length_squared[i] > 0.0 && p.line_load[i] > 0.0)) continue;
      const double l = std::sqrt(p.length_squared[i]);
      const std::int32_t j = o.strip[i];
      found.push_back({model_->rail.s[j], model_->rail.width[j], p.centre[i], l, p.line_load[i] / l,
                       o.curvature[i], std::atan2(-o.ny[i], o.nz[i]), 0.0, 0.0, 0.0});
      points.push_back({p.centre[i], o.wy[i], o.wz[i]});
    }
    return found;
  }

 private:
  theory::KalkerTable ellipse_;
  normal::InfluenceTables influence_;
  std::vector<double> march_memory_, wheel_memory_, rail_memory_, model_memory_, workspace_, state_;
  tangential::MarchGrid grid_;
  const surface::SurfaceModel* model_ = nullptr;
};

Pair& pair_of_bodies() {
  static Pair made;
  return made;
}

double load_of(const SurfaceStrip& s) { return 0.5 * pi * s.width * s.peak * s.half_length; }

double mean(const std::vector<SurfaceStrip>& strips, double SurfaceStrip::*of) {
  double sum = 0.0, load = 0.0;
  for (const SurfaceStrip& s : strips) {
    sum += load_of(s) * s.*of;
    load += load_of(s);
  }
  return sum / load;
}

/// Slips of the wheel rolling at 1 m/s with the tape circle's free rolling speed, and their means; then what
/// the draw makes of them.
void set_slips(SurfaceCase& c, const surface::WheelOnRail& in,
               const std::vector<std::array<double, 3>>& points, Random& random) {
  double turning[3];  // about the axle
  for (int k = 0; k < 3; ++k) turning[k] = -in.wheel.rotation[k][1] / radius;
  double area = 0.0, longest = 0.0;
  for (std::size_t j = 0; j < c.strips.size(); ++j) {
    SurfaceStrip& s = c.strips[j];
    const auto& r = points[j];
    const double ca = std::cos(s.angle), sa = std::sin(s.angle);
    s.slip_x = 1.0 + turning[1] * r[2] - turning[2] * r[1];
    s.slip_y = (turning[2] * r[0] - turning[0] * r[2]) * ca + (turning[0] * r[1] - turning[1] * r[0]) * sa;
    s.spin = turning[2] * ca - turning[1] * sa;
    area += 2.0 * s.half_length * s.width;
    longest = std::max(longest, s.half_length);
  }
  const double ab = area / pi, stiffness = G * ab * (2.8 + 1.05 * longest * longest / ab);
  const double limit = c.friction * c.normal_force;
  const double level = std::sqrt(random.logarithmic(0.05, 6.0) * random.logarithmic(0.05, 6.0));
  const double direction = random.uniform(0.0, 2.0 * pi), kind = random.uniform(0.0, 1.0);
  double along = level * limit / stiffness * std::cos(direction),
         across = level * limit / stiffness * std::sin(direction);
  if (kind < 0.15) along = across = 0.0;
  const double scale = kind > 0.6 ? random.uniform(-1.4, 1.4) : 1.0;
  const double added = kind > 0.75
                           ? (random.uniform(0.0, 1.0) < 0.5 ? -1.0 : 1.0) * random.logarithmic(0.05, 4.0) *
                                 limit / (1.5 * stiffness * std::sqrt(ab))
                           : 0.0;
  const double middle = mean(c.strips, &SurfaceStrip::place);
  const double mean_x = mean(c.strips, &SurfaceStrip::slip_x), mean_y = mean(c.strips, &SurfaceStrip::slip_y);
  double mean_cosine = 0.0;
  for (const SurfaceStrip& s : c.strips) mean_cosine += load_of(s) / c.normal_force * std::cos(s.angle);
  for (SurfaceStrip& s : c.strips) {
    const double lateral = std::cos(s.angle) / mean_cosine;  // of a lateral velocity of the wheel
    s.slip_x = along + scale * (s.slip_x - mean_x) - added * (s.place - middle);
    s.slip_y = scale * (s.slip_y - mean_y * lateral) + across * lateral + added * s.centre;
    s.spin = scale * s.spin + added;
  }
}

/// Numbers of strips over a grid's rows: linear between strips, constant beyond the half strip at an end.
double at(const std::vector<SurfaceStrip>& strips, double place, double SurfaceStrip::*of) {
  if (strips.size() == 1) return strips[0].*of;
  std::size_t i = 0;
  while (i + 2 < strips.size() && place > strips[i + 1].place) ++i;
  const SurfaceStrip &a = strips[i], &b = strips[i + 1];
  const double t = std::clamp((place - a.place) / (b.place - a.place), -0.5, 1.5);
  return a.*of + t * (b.*of - a.*of);
}

SurfaceForces on_grid(const SurfaceCase& c, int nx, int ny) {
  std::vector<double> memory(5 * c.strips.size());
  const auto count = static_cast<std::ptrdiff_t>(c.strips.size());
  double* const m = memory.data();
  const patch::Strips strips{static_cast<std::int32_t>(count),
                             static_cast<std::int32_t>(count),
                             m,
                             m + count,
                             m + 2 * count,
                             m + 3 * count,
                             m + 4 * count};
  for (std::ptrdiff_t j = 0; j < count; ++j) {
    const SurfaceStrip& s = c.strips[static_cast<std::size_t>(j)];
    strips.y[j] = s.place;
    strips.width[j] = s.width;
    strips.centre[j] = s.centre;
    strips.half_length[j] = s.half_length;
    strips.peak[j] = s.peak;
  }
  const halfspace::Grid grid = halfspace::grid_over(strips, nx, ny);
  halfspace::Field angles;
  for (int j = 0; j < ny; ++j) angles.push_back(at(c.strips, grid.y(j), &SurfaceStrip::angle));
  halfspace::RollingSolver solver(grid, {c.shear_modulus, c.poisson}, angles);
  halfspace::RollingProblem problem;
  problem.pressure = halfspace::strip_pressure(strips, grid);
  problem.friction = {c.friction};
  for (int j = 0; j < ny; ++j) {
    const double y = grid.y(j), x = at(c.strips, y, &SurfaceStrip::slip_x),
                 lateral = at(c.strips, y, &SurfaceStrip::slip_y);
    const double spin = at(c.strips, y, &SurfaceStrip::spin), centre = at(c.strips, y, &SurfaceStrip::centre);
    for (int i = 0; i < nx; ++i) {
      const double from = grid.x(i) + halfspace::rigid_slip_ahead(problem.collocation) * grid.dx - centre;
      problem.rigid_slip_x.push_back(x);
      problem.rigid_slip_y.push_back(lateral + spin * from);
    }
  }
  const halfspace::RollingSolution solution = solver.solve(problem);
  const double middle = mean(c.strips, &SurfaceStrip::place);
  const double behind = halfspace::traction_behind(problem.collocation) * grid.dx;
  SurfaceForces f{};
  for (int j = 0; j < ny; ++j) {
    const double ca = std::cos(angles[static_cast<std::size_t>(j)]),
                 sa = std::sin(angles[static_cast<std::size_t>(j)]);
    for (int i = 0; i < nx; ++i) {
      const std::size_t cell = grid.index(i, j);
      const double px = solution.traction_x[cell] * grid.cell_area(),
                   py = solution.traction_y[cell] * grid.cell_area();
      f.fx += px;
      f.fy += py * ca;
      f.fz += py * sa;
      f.mz += (grid.x(i) - behind) * py - (grid.y(j) - middle) * px;
    }
  }
  f.power = solution.power_by_balance;
  f.adhesion = solution.forces.adhesion_fraction;
  f.converged = solution.fault.status == WRC_OK;
  return f;
}

}  // namespace

SurfaceCase random_surface_case(std::uint64_t seed, std::uint64_t row) {
  Random random(seed, row);
  Pair& bodies = pair_of_bodies();
  for (;;) {
    SurfaceCase c{};
    c.poisson = poisson;
    c.shear_modulus = G;
    const double where = random.uniform(0.0, 1.0);
    c.shift = 1e-3 * (where < 0.15   ? random.uniform(4.3, 5.7)
                      : where < 0.40 ? random.uniform(5.7, 8.0)
                                     : random.uniform(-9.0, 4.3));
    c.yaw = random.uniform(-20e-3, 20e-3) * (random.uniform(0.0, 1.0) < 0.5 ? 0.2 : 1.0);
    c.roll = random.uniform(0.0, 1.0) < 0.5 ? 0.0 : random.uniform(-8e-3, 8e-3);
    c.load = random.logarithmic(8e3, 140e3);
    if (c.shift > 6.4e-3) c.load *= random.uniform(0.2, 1.0);
    c.friction = random.uniform(0.1, 0.55);
    surface::WheelOnRail in;
    const double cy = std::cos(c.yaw), sy = std::sin(c.yaw), cr = std::cos(c.roll), sr = std::sin(c.roll);
    const double rotation[3][3] = {{cy, -sy, 0.0}, {cr * sy, cr * cy, -sr}, {sr * sy, sr * cy, cr}};
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) in.wheel.rotation[i][k] = rotation[i][k];
    }
    in.wheel.position[1] = tape_circle_y + c.shift - radius * c.roll;
    in.wheel.position[2] = -radius;
    in.wheel.velocity[0] = 1.0;
    in.wheel.angular_velocity[1] = -1.0 / radius;
    in.vertical_load = c.load;
    std::vector<std::array<double, 3>> points;
    if (!bodies.press(in)) continue;
    c.strips = bodies.strips(in, points);
    double peak = 0.0;
    for (const SurfaceStrip& s : c.strips) {
      c.normal_force += load_of(s);
      peak = std::max(peak, s.peak);
    }
    if (c.strips.size() < 6 || c.normal_force > 220e3 || peak > 4e9) continue;
    set_slips(c, in, points, random);
    if (std::abs(mean(c.strips, &SurfaceStrip::spin)) > 2.0) continue;
    return c;
  }
}

SurfaceForces exact_forces(const SurfaceCase& c) {
  double narrowest = c.strips[0].width, leading = -1.0, trailing = 1.0;
  for (const SurfaceStrip& s : c.strips) {
    narrowest = std::min(narrowest, s.width);
    leading = std::max(leading, s.centre + s.half_length);
    trailing = std::min(trailing, s.centre - s.half_length);
  }
  const SurfaceStrip &first = c.strips.front(), &last = c.strips.back();
  const double across = last.place + 0.5 * last.width - first.place + 0.5 * first.width;
  const int rows = std::clamp(static_cast<int>(std::lround(across / narrowest)), 12, 96);
  const int cells = std::clamp(static_cast<int>(std::lround((leading - trailing) / 0.4e-3)), 28, 48);
  const SurfaceForces coarse = on_grid(c, cells, rows), fine = on_grid(c, 2 * cells, 2 * rows);
  SurfaceForces f = fine;
  for (double SurfaceForces::*of : {&SurfaceForces::fx, &SurfaceForces::fy, &SurfaceForces::fz,
                                    &SurfaceForces::mz, &SurfaceForces::power})
    f.*of = 2.0 * fine.*of - coarse.*of;
  f.force_shift =
      std::sqrt(std::pow(f.fx - fine.fx, 2) + std::pow(f.fy - fine.fy, 2) + std::pow(f.fz - fine.fz, 2)) /
      (c.friction * c.normal_force);
  f.converged = coarse.converged && fine.converged;
  return f;
}

SurfaceForces strip_forces(const SurfaceCase& c, const tangential::MarchGrid& grid,
                           const surface::StripCoefficientTable& coefficients,
                           const surface::SurfaceCalibration& calibration,
                           surface::SurfaceRollingMethod method) {
  const std::size_t n = c.strips.size();
  const std::size_t cells = n * static_cast<std::size_t>(grid.cells);
  std::vector<double> memory(12 * n + surface::surface_rolling_workspace(static_cast<std::int32_t>(n)) +
                             4 * cells);
  double* d = memory.data();
  const auto copied = [&](double SurfaceStrip::*of) {
    double* const begin = d;
    for (const SurfaceStrip& s : c.strips) *d++ = s.*of;
    return begin;
  };
  surface::SurfaceRollingInput in;
  in.count = static_cast<std::int32_t>(n);
  in.place = copied(&SurfaceStrip::place);
  in.width = copied(&SurfaceStrip::width);
  in.half_length = copied(&SurfaceStrip::half_length);
  in.peak = copied(&SurfaceStrip::peak);
  in.curvature = copied(&SurfaceStrip::curvature);
  in.slip_x = copied(&SurfaceStrip::slip_x);
  in.slip_y = copied(&SurfaceStrip::slip_y);
  in.spin = copied(&SurfaceStrip::spin);
  in.friction = std::exchange(d, d + n);
  std::fill_n(d - n, n, c.friction);
  in.shear_modulus = in.normal_shear_modulus = c.shear_modulus;
  in.coefficients = &coefficients;
  in.grid = &grid;
  in.method = method;
  in.calibration = &calibration;
  tangential::TangentialFields fields;
  if (method == surface::SurfaceRollingMethod::fastrip) {
    for (double** field : {&fields.traction_x, &fields.traction_y, &fields.slip_x, &fields.slip_y})
      *field = std::exchange(d, d + cells);
  }
  surface::SurfaceRollingForces rolled;
  rolled.fx = std::exchange(d, d + n);
  rolled.fy = std::exchange(d, d + n);
  rolled.mz = std::exchange(d, d + n);
  const surface::SurfaceRollingTotals totals = surface::roll_on_surface(in, d, fields, rolled);
  SurfaceForces f{};
  const double middle = mean(c.strips, &SurfaceStrip::place);
  for (std::size_t j = 0; j < n; ++j) {
    const SurfaceStrip& s = c.strips[j];
    f.fx += rolled.fx[j];
    f.fy += rolled.fy[j] * std::cos(s.angle);
    f.fz += rolled.fy[j] * std::sin(s.angle);
    f.mz += rolled.mz[j] + s.centre * rolled.fy[j] - (s.place - middle) * rolled.fx[j];
  }
  f.power = totals.power_per_speed;
  f.adhesion = totals.adhesion_fraction;
  f.converged = true;
  return f;
}

std::string text_of(const SurfaceCase& c) {
  char text[300];
  std::snprintf(text, sizeof text, "%.8g,%.8g,%.8g,%.8g,%.8g,%.8g,%.8g,%.8g", c.shift, c.yaw, c.roll, c.load,
                c.poisson, c.shear_modulus, c.friction, c.normal_force);
  return text;
}

std::string text_of(const ExactSurfaceCase& c) {
  const SurfaceForces& f = c.exact;
  char text[400];
  std::snprintf(text, sizeof text, ",%.8g,%.8g,%.8g,%.8g,%.8g,%.6f,%.1e,", f.fx, f.fy, f.fz, f.mz, f.power,
                f.adhesion, f.force_shift);
  std::string line = text_of(c.rolling) + text;
  for (const SurfaceStrip& s : c.rolling.strips) {
    std::snprintf(text, sizeof text, "%.7g %.7g %.7g %.7g %.7g %.7g %.7g %.8g %.8g %.8g ", s.place, s.width,
                  s.centre, s.half_length, s.peak, s.curvature, s.angle, s.slip_x, s.slip_y, s.spin);
    line += text;
  }
  return line;
}

std::vector<ExactSurfaceCase> read_surface_cases(const std::string& path) {
  std::vector<ExactSurfaceCase> cases;
  read_rows(path, surface_heading, "make_patches surface", [&](std::istringstream& text) {
    std::array<double, 15> v{};
    for (double& value : v) text >> value;
    if (!text) return false;
    ExactSurfaceCase c{{v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], {}},
                       {v[8], v[9], v[10], v[11], v[12], v[13], v[14], true}};
    for (SurfaceStrip s{}; text >> s.place >> s.width >> s.centre >> s.half_length >> s.peak >> s.curvature >>
                           s.angle >> s.slip_x >> s.slip_y >> s.spin;)
      c.rolling.strips.push_back(s);
    cases.push_back(std::move(c));
    return true;
  });
  return cases;
}

}  // namespace wrc::calibration
