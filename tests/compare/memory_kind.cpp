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

/// One line of memory_params.csv.
struct Sequence {
  std::string family;
  double a = 0.0, b = 0.0;  ///< at the load of the start [m]
  double load = 0.0, friction = 0.0;
  bool of_halfspace = false;        ///< the gap and the load press, else a semi-elliptic pressure is given
  double gap_x = 0.0, gap_y = 0.0;  ///< A, B of the gap A x^2 + B y^2 [1/m]
  wrc_material material = wrc_material_default();  ///< of either body
};

Sequence sequence_of(const Csv& file, std::size_t row) {
  Sequence q;
  q.family = file.text(row, "family");
  q.a = 1e-3 * file(row, "a_mm");
  q.b = 1e-3 * file(row, "b_mm");
  q.load = file(row, "Fn0_N");
  q.friction = file(row, "mu");
  q.of_halfspace = file.text(row, "pressure") == "halfspace";
  q.gap_x = 1e3 * file(row, "A_per_mm");
  q.gap_y = 1e3 * file(row, "B_per_mm");
  q.material.shear_modulus = 1e6 * file(row, "G_MPa");
  q.material.poisson = file(row, "nu");
  return q;
}

/// A row: a shift at rest, or rolling with constant creepages under a load that varies evenly.
struct Row {
  int direction = 0;                                ///< of rolling along x; 0: at rest
  double rolled = 0.0;                              ///< amount of the distance [m]
  double shift_x = 0.0, shift_y = 0.0, turn = 0.0;  ///< of the wheel over the rail [m, rad]
  double load_before = 0.0, load = 0.0;             ///< at its beginning and its end [N]
};

struct Force {
  double fx = 0.0, fy = 0.0, mz = 0.0;
};

/// Bodies that go through the rows of a sequence.
class Bodies {
 public:
  virtual ~Bodies() = default;
  /// Force at the end of a row; throws the reason of a failure.
  virtual Force go(const Sequence& sequence, const Row& row) = 0;
};

/// The exact solver on cells a / n by b / n, borders on the origin.
class ExactOnCells {
 public:
  ExactOnCells(const Sequence& q, std::uint32_t n) : cells_(grid_of(q, n), q.material, q.friction) {}

  Force go(const Sequence& q, const Row& row) {
    const double cell = cells_.grid().dx;
    const int steps = row.direction == 0 ? 1 : static_cast<int>(std::lround(row.rolled / cell));
    if (steps == 0) throw std::runtime_error("a row rolls less than a cell");
    wrc_creepage creepage = wrc_creepage_default();
    creepage.speed = row.direction;
    creepage.longitudinal = row.shift_x / (steps * cell);
    creepage.lateral = row.shift_y / (steps * cell);
    creepage.spin = row.turn / (steps * cell);
    wrc_exact_rolling_solution solution{};
    for (int step = 1; step <= steps; ++step) {
      press(q, row.load_before + (row.load - row.load_before) * step / steps);
      solution = cells_.step(creepage);
    }
    return {solution.fx, solution.fy, solution.mz};
  }

 private:
  static wrc_grid grid_of(const Sequence& q, std::uint32_t n) {
    // 9 % about the ellipse hold that of 30 % more load
    const std::uint32_t half = q.of_halfspace ? n + n / 8 : n;
    return grid_about(q.a, q.b, n, half);
  }

  void press(const Sequence& q, double load) {
    if (load == pressed_) return;
    pressed_ = load;
    if (q.of_halfspace) return cells_.press_gap(q.gap_x, q.gap_y, load);
    cells_.press_ellipse(q.a, q.b, load);
  }

  TransientCells cells_;
  double pressed_ = 0.0;  ///< load that presses [N]
};

/// The exact solver on the cells of the reference and on cells twice as large: the error of first order
/// is taken off as it is taken off the reference.
class Exact : public Bodies {
 public:
  explicit Exact(const Sequence& q) : fine_(q, 24), coarse_(q, 12) {}

  Force go(const Sequence& q, const Row& row) override {
    const Force fine = fine_.go(q, row), coarse = coarse_.go(q, row);
    return {2.0 * fine.fx - coarse.fx, 2.0 * fine.fy - coarse.fy, 2.0 * fine.mz - coarse.mz};
  }

 private:
  ExactOnCells fine_, coarse_;
};

/// wrc_planar_tangential() of a model with config.planar.non_steady: a step for every row.
class Strip : public Bodies {
 public:
  explicit Strip(const Sequence& q) : solver_(non_steady_config(q.material)) {}

  Force go(const Sequence& q, const Row& row) override {
    // under Hertz's pressure the ellipse grows with the load
    const double scale = q.of_halfspace ? std::cbrt(row.load / q.load) : 1.0;
    wrc_ellipse ellipse = sized<wrc_ellipse>();
    ellipse.a = scale * q.a;
    ellipse.b = scale * q.b;
    ellipse.normal_force = row.load;
    // at rest creepages are the shift over any length
    const double length = row.direction == 0 ? 1e-3 : row.rolled;
    wrc_creepage creepage = wrc_creepage_default();
    creepage.speed = row.direction;
    creepage.longitudinal = row.shift_x / length;
    creepage.lateral = row.shift_y / length;
    creepage.spin = row.turn / length;
    wrc_friction friction = wrc_friction_default();
    friction.coefficient = q.friction;
    wrc_planar_roll(solver_.contact(), length);
    wrc_planar_forces forces{};
    const int32_t status = wrc_planar_tangential(solver_.contact(), &ellipse, &creepage, &friction, &forces);
    if (status < 0) throw std::runtime_error(solver_.reason(status));
    return {forces.fx, forces.fy, forces.mz};
  }

 private:
  Solver solver_;
};

template <class Kind>
std::unique_ptr<Bodies> make(const Sequence& q) {
  return std::make_unique<Kind>(q);
}

struct Variant {
  const char* name;
  std::unique_ptr<Bodies> (*make)(const Sequence&);
};
const std::vector<Variant> every_variant = {{"exact", make<Exact>}, {"strip", make<Strip>}};

}  // namespace

Report compare_memory(const Csv& file, const Names& only) {
  const Csv parameters(parameters_of(file.path()));
  if (parameters.has("wheel_file")) return compare_memory_of_wheels(file, parameters, only);
  std::map<long, Sequence> sequences;
  Report report;
  report.kind = "memory";
  report.rows = file.rows();
  report.measures = {"force", "moment"};
  for (std::size_t row = 0; row < parameters.rows(); ++row) {
    const Sequence q = sequence_of(parameters, row);
    sequences[static_cast<long>(parameters(row, "seq"))] = q;
    for (const std::string& name : {"force_" + q.family, "moment_" + q.family})
      if (std::find(report.measures.begin(), report.measures.end(), name) == report.measures.end())
        report.measures.push_back(name);
  }
  for (const Variant& variant : chosen(every_variant, only)) {
    report.variants.emplace_back(variant.name);
    report.default_variant = variant.name;
    std::unique_ptr<Bodies> bodies;
    const Sequence* q = nullptr;
    double load = 0.0;
    for (std::size_t row = 0; row < file.rows(); ++row) {
      const auto found = sequences.find(static_cast<long>(file(row, "seq")));
      if (found == sequences.end()) throw std::runtime_error(file.path() + ": a sequence without parameters");
      if (q != &found->second) {
        q = &found->second;
        bodies = variant.make(*q);
        load = q->load;
      }
      try {
        const Row now{.direction = static_cast<int>(file(row, "dir")),
                      .rolled = 1e-3 * file(row, "ds_mm"),
                      .shift_x = 1e-3 * file(row, "dux_mm"),
                      .shift_y = 1e-3 * file(row, "duy_mm"),
                      .turn = file(row, "dphi_rad"),
                      .load_before = load,
                      .load = file(row, "Fn_N")};
        load = now.load;
        const Force force = bodies->go(*q, now);
        const double limit = q->friction * now.load;
        auto& errors = report.errors[variant.name];
        const double of_force =
            std::hypot(force.fx - file(row, "Fx_extrap_N"), force.fy - file(row, "Fy_extrap_N")) / limit;
        const double of_moment = (force.mz - file(row, "Mz_extrap_Nm")) / (limit * std::sqrt(q->a * q->b));
        errors["force"].add(row, of_force);
        errors["force_" + q->family].add(row, of_force);
        errors["moment"].add(row, of_moment);
        errors["moment_" + q->family].add(row, of_moment);
      } catch (const std::exception& error) {
        report.fail(row, variant.name, error.what(),
                    {"force", "moment", "force_" + q->family, "moment_" + q->family});
      }
    }
  }
  return report;
}

}  // namespace compare
