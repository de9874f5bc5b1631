#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "kinds.hpp"
#include "library.hpp"
#include "transient_cells.hpp"

namespace compare {
namespace {

/// One line of transient_params.csv.
struct Sequence {
  long number = 0;
  std::string kind;
  bool ellipse = false;
  wrc_ellipse shape = sized<wrc_ellipse>();  ///< at the mean load
  double load_amplitude = 0.0, wave_length = 0.0;
  double gap_x = 0.0, gap_y = 0.0;                 ///< A, B of the gap A x^2 + B y^2 [1/m]
  wrc_material material = wrc_material_default();  ///< of either body
  double friction = 0.0, step = 0.0;
  wrc_creepage mean = wrc_creepage_default(), amplitude = wrc_creepage_default();
  int stride = 0;

  double sine(double s) const { return wave_length > 0.0 ? std::sin(2.0 * pi * s / wave_length) : 0.0; }
  double load(double s) const { return shape.normal_force * (1.0 + load_amplitude * sine(s)); }
  wrc_creepage creepage(double s) const {
    wrc_creepage c = mean;
    c.longitudinal += amplitude.longitudinal * sine(s);
    c.lateral += amplitude.lateral * sine(s);
    c.spin += amplitude.spin * sine(s);
    return c;
  }
  /// Hertz's ellipse at this load, the double ellipse of a prescribed pressure at the mean one.
  wrc_ellipse patch(double s) const {
    wrc_ellipse patch = shape;
    patch.normal_force = load(s);
    const double scale = std::cbrt(patch.normal_force / shape.normal_force);
    patch.a *= scale;
    patch.b *= scale;
    return patch;
  }
};

Sequence sequence_of(const Csv& file, std::size_t row) {
  Sequence q;
  q.number = static_cast<long>(file(row, "case"));
  q.kind = file.text(row, "kind");
  q.ellipse = file.text(row, "shape") == "ellipse";
  q.shape.a = 1e-3 * file(row, "a_mm");
  q.shape.b = 1e-3 * file(row, "b_mm");
  q.shape.psi = file(row, "psi");
  q.shape.normal_force = file(row, "Fn0_N");
  q.load_amplitude = file(row, "Fn_amp");
  q.wave_length = 1e-3 * file(row, "L_mm");
  q.gap_x = 1e3 * file(row, "A_per_mm");
  q.gap_y = 1e3 * file(row, "B_per_mm");
  q.material.shear_modulus = 1e6 * file(row, "G_MPa");
  q.material.poisson = file(row, "nu");
  q.friction = file(row, "mu");
  q.step = 1e-3 * file(row, "dq_mm");
  q.mean.longitudinal = file(row, "cx0");
  q.amplitude.longitudinal = file(row, "cx1");
  q.mean.lateral = file(row, "cy0");
  q.amplitude.lateral = file(row, "cy1");
  q.mean.spin = file(row, "phi0_per_m");
  q.amplitude.spin = file(row, "phi1_per_m");
  q.stride = static_cast<int>(file(row, "stride"));
  return q;
}

struct Force {
  double fx = 0.0, fy = 0.0;
};

/// What rolls a sequence, one step of `Sequence::step` at a time.
class Roller {
 public:
  virtual ~Roller() = default;
  /// Force at the end of the step that ends at `s`; throws the reason of a failure.
  virtual Force roll(const Sequence& sequence, double s) = 0;
};

/// The exact solver on the reference's own cells: a step long, b / 28 wide, borders on the origin.
class Exact : public Roller {
 public:
  explicit Exact(const Sequence& q) : cells_(grid_of(q), q.material, q.friction) {
    if (q.load_amplitude == 0.0) press(q, 0.0);
  }

  Force roll(const Sequence& q, double s) override {
    if (q.load_amplitude != 0.0) press(q, s);
    const wrc_exact_rolling_solution solution = cells_.step(q.creepage(s - 0.5 * q.step));
    return {solution.fx, solution.fy};
  }

 private:
  static wrc_grid grid_of(const Sequence& q) {
    wrc_grid grid = sized<wrc_grid>();
    grid.dx = q.step;
    grid.dy = q.shape.b / 28.0;
    const double margin = std::cbrt(1.0 + std::fabs(q.load_amplitude));
    const auto cells = [](double length, double cell) {
      return static_cast<std::uint32_t>(std::ceil(length / cell - 1e-3)) + 1;
    };
    const std::uint32_t ahead = cells(margin * q.shape.a, grid.dx);
    const std::uint32_t right = cells(margin * q.shape.b * (1.0 - q.shape.psi), grid.dy);
    const std::uint32_t left = cells(margin * q.shape.b * (1.0 + q.shape.psi), grid.dy);
    grid.nx = 2 * ahead;
    grid.ny = left + right;
    grid.x0 = -(ahead - 0.5) * grid.dx;
    grid.y0 = -(right - 0.5) * grid.dy;
    return grid;
  }

  /// The pressure at the load at `s`.
  void press(const Sequence& q, double s) {
    if (q.ellipse) return cells_.press_gap(q.gap_x, q.gap_y, q.load(s));
    const double peak = 1.5 * q.load(s) / (pi * q.shape.a * q.shape.b);
    cells_.press([&](double x, double y) {
      const double eta = y / (q.shape.b * (1.0 + (y > 0.0 ? q.shape.psi : -q.shape.psi)));
      const double xi = x / q.shape.a;
      return peak * std::sqrt(std::fmax(0.0, 1.0 - xi * xi - eta * eta));
    });
  }

  TransientCells cells_;
};

/// wrc_planar_tangential() of a model with config.planar.non_steady.
class Strip : public Roller {
 public:
  explicit Strip(const Sequence& q) : solver_(non_steady_config(q.material)) {}

  Force roll(const Sequence& q, double s) override {
    const wrc_ellipse patch = q.patch(s);
    const wrc_creepage creepage = q.creepage(s - 0.5 * q.step);
    wrc_friction friction = wrc_friction_default();
    friction.coefficient = q.friction;
    wrc_planar_forces forces{};
    wrc_planar_roll(solver_.contact(), q.step);
    const int32_t status = wrc_planar_tangential(solver_.contact(), &patch, &creepage, &friction, &forces);
    if (status < 0) throw std::runtime_error(solver_.reason(status));
    return {forces.fx, forces.fy};
  }

 private:
  Solver solver_;
};

template <class Kind>
std::unique_ptr<Roller> make(const Sequence& q) {
  return std::make_unique<Kind>(q);
}

struct Variant {
  const char* name;
  std::unique_ptr<Roller> (*make)(const Sequence&);
};
const std::vector<Variant> every_variant = {{"exact", make<Exact>}, {"strip", make<Strip>}};

/// What a row is listed under beside "force".
std::string group_of(const Sequence& q) {
  if (q.kind == "start") return "force_start";
  const double waves = q.wave_length / q.shape.a;
  return "force_L" + std::to_string(std::lround(waves)) + "a";
}

}  // namespace

Report compare_transient(const Csv& file, const Names& only) {
  const Csv parameters(parameters_of(file.path()));
  std::map<long, Sequence> sequences;
  for (std::size_t row = 0; row < parameters.rows(); ++row) {
    const Sequence q = sequence_of(parameters, row);
    sequences[q.number] = q;
  }
  Report report;
  report.kind = "transient";
  report.rows = file.rows();
  report.measures = {"force"};
  for (const auto& [number, q] : sequences) {
    const std::string group = group_of(q);
    if (std::find(report.measures.begin(), report.measures.end(), group) == report.measures.end())
      report.measures.push_back(group);
  }
  report.default_variant = "strip";
  for (const Variant& variant : chosen(every_variant, only)) {
    report.variants.emplace_back(variant.name);
    std::unique_ptr<Roller> roller;
    const Sequence* q = nullptr;
    long step = 0;
    for (std::size_t row = 0; row < file.rows(); ++row) {
      const long number = static_cast<long>(file(row, "case"));
      try {
        if (q == nullptr || number != q->number) {
          q = &sequences.at(number);
          roller = variant.make(*q);
          step = 0;
        }
        Force force;
        for (const long end = q->stride * static_cast<long>(file(row, "step")); step < end;) {
          ++step;
          force = roller->roll(*q, static_cast<double>(step) * q->step);
        }
        const double error = std::hypot(force.fx - file(row, "Fx_N"), force.fy - file(row, "Fy_N")) /
                             (q->friction * file(row, "Fn_N"));
        report.errors[variant.name]["force"].add(row, error);
        report.errors[variant.name][group_of(*q)].add(row, error);
      } catch (const std::exception& error) {
        report.fail(row, variant.name, error.what(), {"force"});
      }
    }
  }
  return report;
}

}  // namespace compare
