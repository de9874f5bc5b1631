#include <cmath>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>

#include "kinds.hpp"
#include "wheel_cases.hpp"

namespace compare {
namespace {

constexpr double pi = 3.14159265358979323846;

/// A wheel that wanders over its rail as by an irregularity of that: a line of wheelrail_memory_params.csv.
class Wander {
 public:
  Wander(const Csv& parameters, std::size_t row)
      : number_(static_cast<long>(parameters(row, "seq"))),
        step_(1e-3 * parameters(row, "dx_mm")),
        speed_(1e-3 * parameters(row, "vs")) {
    const auto millimetres = [&](const char* column) { return 1e-3 * parameters(row, column); };
    middle_ = millimetres("y0_mm");
    amplitude_ = millimetres("A_mm");
    length_ = millimetres("L_mm");
    phase_ = parameters(row, "ph");
    for (int k = 0; k < 6; ++k) height_[k] = parameters(row, "zc" + std::to_string(k));
    wheel_ = WheelCase();
    wheel_.input.friction.coefficient = parameters(row, "mu");
    wrc_wheel_state& wheel = wheel_.input.wheel;
    wheel.yaw = parameters(row, "yaw0");
    wheel.velocity[0] = speed_;
    const double radius = millimetres("r0_mm");
    wheel.angular_axes = WRC_AXES_BODY;
    wheel.angular_velocity[1] = -speed_ / radius * (1.0 + parameters(row, "kappa"));
    pair_.wheel = parameters.text(row, "wheel_file");
    pair_.rail = parameters.text(row, "rail_file");
    pair_.shear_modulus = 1e6 * parameters(row, "G");
    pair_.poisson = parameters(row, "nu");
    pair_.radius = radius;
  }

  long number() const { return number_; }
  double friction() const { return wheel_.input.friction.coefficient; }
  const PairOptions& pair() const { return pair_; }

  /// The wheel at the middle of the k-th step, as the reference has it.
  WheelCase at(long k) const {
    WheelCase wheel = wheel_;
    const double y =
        middle_ + amplitude_ * std::sin(2.0 * pi * (static_cast<double>(k) + 0.5) * step_ / length_ + phase_);
    wheel.input.wheel.y = y;
    double z = 0.0;
    for (int power = 5; power >= 0; --power) z = z * 1e3 * y + height_[power];
    wheel.input.wheel.z = 1e-3 * z;
    return wheel;
  }

  long step_of(double s) const { return std::lround(s / step_ - 0.5); }
  double time() const { return step_ / speed_; }

 private:
  long number_;
  double step_, speed_;
  double middle_ = 0.0, amplitude_ = 0.0, length_ = 1.0, phase_ = 0.0;
  double height_[6] = {};  // polynomial, mm over mm
  WheelCase wheel_;
  PairOptions pair_;
};

/// Horizontal error over the friction limit.
double error_of(const Vector& force, const Csv& file, std::size_t row, const char* x, const char* y,
                double friction) {
  const double limit = friction * std::abs(file(row, "Fz_track_N"));
  return std::hypot(force[0] - file(row, x), force[1] - file(row, y)) / limit;
}

Vector solved(WheelCase& wheel, const Solver& solver) {
  const int32_t status = wheel.solve(solver);
  if (status < 0) throw std::runtime_error(solver.reason(status));
  return wheel.force();
}

}  // namespace

Report compare_memory_of_wheels(const Csv& file, const Csv& parameters, const Names& only) {
  struct Variant {
    const char* name;
  };
  const std::vector<Variant> every_variant = {{"wheel"}, {"steady"}};
  std::map<long, Wander> wanders;
  for (std::size_t row = 0; row < parameters.rows(); ++row) {
    const Wander wander(parameters, row);
    wanders.emplace(wander.number(), wander);
  }
  Report report;
  report.kind = "memory";
  report.rows = file.rows();
  report.measures = {"force", "beyond_steady", "vertical"};
  report.default_variant = "wheel";
  for (const Variant& variant : chosen(every_variant, only)) {
    const bool remembers = std::string(variant.name) == "wheel";
    report.variants.emplace_back(variant.name);
    long done = 0, sequence = -1;
    std::unique_ptr<Pairs> pairs;
    for (std::size_t row = 0; row < file.rows(); ++row) {
      const Wander& wander = wanders.at(static_cast<long>(file(row, "seq")));
      PairOptions pair = wander.pair();
      pair.remembers = remembers;
      if (sequence != wander.number()) {  // from rest, by a contact of its own
        done = 0;
        pairs = std::make_unique<Pairs>(file);
      }
      sequence = wander.number();
      const Solver& solver = pairs->of(pair);
      auto& errors = report.errors[variant.name];
      const long last = wander.step_of(1e-3 * file(row, "s_mm"));
      const bool has_steady = !file.text(row, "Fx_steady_N").empty();
      PairOptions forgets = pair;
      forgets.remembers = false;
      try {
        if (!remembers) {
          if (!has_steady) continue;
          WheelCase wheel = wander.at(last);
          const Vector force = solved(wheel, solver);
          errors["force"].add(row,
                              error_of(force, file, row, "Fx_steady_N", "Fy_steady_N", wander.friction()));
          errors["vertical"].add(row, force[2] / file(row, "Fz_steady_N") - 1.0);
          continue;
        }
        Vector force{};
        for (; done <= last; ++done) {
          WheelCase wheel = wander.at(done);
          wheel.input.time_step = wander.time();
          force = solved(wheel, solver);
          wrc_contact_commit(solver.contact());
        }
        errors["force"].add(row, error_of(force, file, row, "Fx_track_N", "Fy_track_N", wander.friction()));
        errors["vertical"].add(row, force[2] / file(row, "Fz_track_N") - 1.0);
        if (!has_steady) continue;
        // the part that memory adds to the steady force, beside the reference's
        WheelCase wheel = wander.at(last);
        const Vector beyond = difference(force, solved(wheel, pairs->of(forgets)));
        const Vector reference =
            difference(vector_of(file, row, "Fx_track_N", "Fy_track_N", "Fz_track_N"),
                       vector_of(file, row, "Fx_steady_N", "Fy_steady_N", "Fz_steady_N"));
        const double limit = wander.friction() * std::abs(file(row, "Fz_track_N"));
        errors["beyond_steady"].add(row,
                                    std::hypot(beyond[0] - reference[0], beyond[1] - reference[1]) / limit);
      } catch (const std::exception& error) {
        report.fail(row, variant.name, error.what(), {"force", "vertical"});
      }
    }
  }
  return report;
}

}  // namespace compare
