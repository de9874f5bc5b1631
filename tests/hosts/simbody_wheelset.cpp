// A wheelset on an irregular track in Simbody, integrated by CPODES (BDF, Newton, error control).
//
//   simbody_wheelset wrc|smooth|ratio [--seconds 1] [--speed 40] [--rms 0.0015] [--free] [--lateral 0]
//                    [--accuracy 1e-5] [--cone 0.136] [--rows FILE.csv] [--every 0.1]
//
// wrc: the wheels' forces are the library's. smooth: those of one Hertzian ellipse on a cone and an arc,
// Kalker's linear law with smooth saturation, as a measure of what the same motion costs at least. ratio:
// both, and how the calls compare. Prints calls of the contact element, steps, failures of the error test and
// of Newton's iteration. The wheelset, its springs and the track are those of docs/hosts.md. --free: no
// springs, prints the wave lengths of its motion. Exit status 1 if an integration does not reach its end, or
// wrc takes more than 1.3 times the calls.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "SimTKsimbody.h"
#include "test_config.hpp"
#include "wrc/wrc_damage.h"

using SimTK::Force, SimTK::MobilizedBody, SimTK::Real, SimTK::Rotation, SimTK::SpatialVec, SimTK::State,
    SimTK::Transform, SimTK::Vec3;

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double mass = 1500.0, across_axle = 800.0, about_axle = 100.0;  // kg, kg m2
constexpr double load = 160e3;                                            // N, on both rails
constexpr double arm = 1.0;                                               // m, of an axle box
const Vec3 box_stiffness(4e6, 2e6, 1e6);                                  // N/m
constexpr double radius = 0.46, half_distance = 0.75;                     // m, of the tape circles
constexpr double most = 1.3;  // calls of the contact element over the smooth one's
constexpr double friction = 0.3, shear_modulus = 82e9, poisson = 0.28;

struct Options {
  std::string element, rows;
  double seconds = 1.0, speed = 40.0, rms = 1.5e-3, lateral = 0.0, accuracy = 1e-5, cone = 0.136, every = 0.1;
  bool free = false;
};

// Lateral displacement of both rails at a distance: 40 cosines, faded in over the first 10 m.
class Track {
 public:
  explicit Track(double rms) {
    double squares = 0.0;
    for (int k = 0; k < 40; ++k) {
      length_[k] = 3.0 * std::pow(20.0, k / 39.0);
      phase_[k] = 2.0 * pi * std::fmod(0.618034 * (k + 1), 1.0);
      squares += length_[k] * length_[k];
    }
    scale_ = rms / std::sqrt(0.5 * squares);
  }

  void at(double x, double& y, double& slope) const {
    double sum = 0.0, change = 0.0;
    for (int k = 0; k < 40; ++k) {
      const double number = 2.0 * pi / length_[k], angle = number * x + phase_[k];
      sum += scale_ * length_[k] * std::cos(angle);
      change -= scale_ * length_[k] * number * std::sin(angle);
    }
    const double t = std::fmin(std::fmax(x / 10.0, 0.0), 1.0);
    const double fade = t * t * (3.0 - 2.0 * t), rate = 6.0 * t * (1.0 - t) / 10.0;
    y = fade * sum;
    slope = fade * change + rate * sum;
  }

 private:
  double length_[40], phase_[40], scale_;
};

// How a wheelset stands and moves: x forward, y right, z down; and the rails' lateral place and slope there.
struct Motion {
  double y, z;
  Rotation rotation;  // of the body, its turning about the axle included
  Vec3 velocity, angular;
  double rail_y, rail_slope;
};

// What both rails do to the wheelset, moment about its middle, and the two rails' shares.
struct Wrench {
  Vec3 force[2], moment[2];
};

class Element {
 public:
  virtual ~Element() = default;
  virtual Wrench wheels(const Motion& motion) = 0;
  virtual double height() = 0;  // of the middle where the wheels carry the load
  long calls = 0;               // of both wheels at a time
};

class WrcElement : public Element {
 public:
  WrcElement() {
    wrc_config config = test_config();
    config.wheel_material.shear_modulus = config.rail_material.shear_modulus = shear_modulus;
    config.wheel_material.poisson = config.rail_material.poisson = poisson;
    config.wheel.kind = WRC_PROFILE_S1002;
    config.rail.kind = WRC_PROFILE_UIC60_BENCHMARK;
    char text[300];
    if (wrc_model_create(&config, nullptr, &model_, text, sizeof text) < 0) throw std::runtime_error(text);
    for (int side = 0; side < 2; ++side)
      if (wrc_contact_create(model_, side, nullptr, &contact_[side], text, sizeof text) < 0)
        throw std::runtime_error(text);
  }
  ~WrcElement() override {
    for (auto* contact : contact_) wrc_contact_destroy(contact);
    wrc_model_destroy(model_);
  }
  WrcElement(const WrcElement&) = delete;
  WrcElement& operator=(const WrcElement&) = delete;

  Wrench wheels(const Motion& motion) override {
    ++calls;
    Wrench both;
    for (int side = 0; side < 2; ++side) {
      const wrc_wrench wrench = step(side, motion, WRC_PRESCRIBE_HEIGHT, 0.0);
      both.force[side] = Vec3(wrench.force[0], wrench.force[1], wrench.force[2]);
      both.moment[side] = Vec3(wrench.moment[0], wrench.moment[1], wrench.moment[2]);
    }
    return both;
  }

  double height() override {
    return step(WRC_SIDE_RIGHT, {0.0, 0.0, Rotation(), Vec3(0), Vec3(0), 0.0, 0.0},
                WRC_PRESCRIBE_VERTICAL_LOAD, load / 2)
        .z;
  }

 private:
  wrc_wrench step(int side, const Motion& motion, int prescribed, double vertical_load) {
    wrc_wheel_input input = wrc_wheel_input_default();
    wrc_wheel_state& wheel = input.wheel;
    wheel.y = motion.y;
    wheel.z = motion.z;
    wheel.orientation = WRC_ORIENTATION_ROWS;
    for (int i = 0; i < 9; ++i) wheel.rotation[i] = motion.rotation[i / 3][i % 3];
    wheel.angular_axes = WRC_AXES_TRACK;
    for (int i = 0; i < 3; ++i) {
      wheel.velocity[i] = motion.velocity[i];
      wheel.angular_velocity[i] = motion.angular[i];
    }
    input.rail.y = motion.rail_y;
    input.rail.y_slope = motion.rail_slope;
    input.friction.coefficient = prescribed == WRC_PRESCRIBE_HEIGHT ? friction : 0.0;
    input.prescribed = prescribed;
    input.vertical_load = vertical_load;
    wrc_wrench wrench = sized<wrc_wrench>();
    if (wrc_contact_wrench(contact_[side], &input, &wrench) < 0) {
      char text[400];
      wrc_contact_last_error(contact_[side], text, sizeof text);
      throw std::runtime_error(text);
    }
    return wrench;
  }

  wrc_model* model_ = nullptr;
  wrc_contact* contact_[2] = {nullptr, nullptr};
};

// One Hertzian ellipse between a cone and a rail's arc; Kalker's linear law, saturated by a hyperbolic
// tangent. Hertz by the approximations of Hamrock and Brewe (J. Lubrication Technology 105, 1983).
class SmoothElement : public Element {
 public:
  explicit SmoothElement(double cone) : cone_(std::atan(cone)) {
    const double ratio = radius / arc;  // the larger radius along the track, and so the larger semi-axis
    k_ = 1.0339 * std::pow(ratio, 0.636);
    const double e = 1.0003 + 0.5968 / ratio, f = 1.5277 + 0.6023 * std::log(ratio);
    const double combined = 1.0 / (1.0 / radius + 1.0 / arc), modulus = 2.0 * shear_modulus / (1.0 - poisson);
    depth_ = f * std::cbrt(9.0 / (2.0 * e * combined) / std::pow(pi * k_ * modulus, 2.0));
    axis_ = std::cbrt(6.0 * k_ * k_ * e * combined / (pi * modulus));
    if (wrc_linear_coefficients(k_, 0.0, poisson, &coefficients_) < 0)
      throw std::runtime_error("no coefficients");
  }

  Wrench wheels(const Motion& given) override {
    ++calls;
    // the rails run in the direction of the slope: all is seen in axes along them
    const Rotation along(std::atan(given.rail_slope), SimTK::ZAxis);
    const Motion motion{
        given.y,      given.z, ~along * given.rotation, ~along * given.velocity, ~along * given.angular,
        given.rail_y, 0.0};
    const double speed = motion.velocity[0], tilt = std::atan2(motion.rotation[2][1], motion.rotation[1][1]);
    Wrench both;
    for (int side = 0; side < 2; ++side) {
      const double outwards = side == 0 ? 1.0 : -1.0;
      const Vec3 centre(0.0, motion.y, motion.z - radius);
      const Vec3 across = about_x(tilt, Vec3(0, std::cos(cone_), -outwards * std::sin(cone_)));
      const Vec3 normal = about_x(tilt, Vec3(0, -outwards * std::sin(cone_), -std::cos(cone_)));
      const Vec3 cone_point = centre + about_x(tilt, Vec3(0, outwards * half_distance, radius));
      const Vec3 nominal(0, -outwards * std::sin(cone_), -std::cos(cone_));
      const Vec3 middle = Vec3(0, motion.rail_y + outwards * half_distance, 0) - arc * nominal;
      const double overlap = arc - ~(cone_point - middle) * normal;
      both.force[side] = both.moment[side] = Vec3(0);
      if (overlap <= 0.0) continue;
      const double n = std::pow(overlap / depth_, 1.5), a = axis_ * std::cbrt(n), b = a / k_;
      const Vec3 point = middle + arc * normal - centre;
      const Vec3 slip = motion.velocity + motion.angular % point;
      const double longitudinal = slip[0] / speed, lateral = ~slip * across / speed;
      const double spin = -(~motion.angular * normal) / speed;  // about the normal into the rail
      const double g = shear_modulus * a * b, c = std::sqrt(a * b);
      const double fx = -g * coefficients_.c11 * longitudinal;
      // the ellipse's own axes are x, across, and across x normal's opposite: right-handed with z into the
      // rail
      const double fy = -g * (coefficients_.c22 * lateral + c * coefficients_.c23 * spin);
      const double mz = g * c * coefficients_.c23 * lateral;
      const double whole = std::sqrt(fx * fx + fy * fy) / (friction * n);
      const double share = whole > 1e-8 ? std::tanh(whole) / whole : 1.0;
      const Vec3 force = n * normal + share * (fx * Vec3(1, 0, 0) + fy * across);
      both.force[side] = along * force;
      both.moment[side] = along * (point % force - share * mz * normal);
    }
    return both;
  }

  double height() override {
    double low = 0.0, high = 1e-3;
    for (int i = 0; i < 60; ++i) {
      const double z = 0.5 * (low + high);
      const Wrench w = wheels({0.0, z, Rotation(), Vec3(1, 0, 0), Vec3(0, -1.0 / radius, 0), 0.0, 0.0});
      (-w.force[0][2] - w.force[1][2] < load ? low : high) = z;
    }
    return low;
  }

 private:
  static Vec3 about_x(double angle, const Vec3& v) { return Rotation(angle, SimTK::XAxis) * v; }

  static constexpr double arc = 0.3;  // m, the rail's
  double cone_, k_, depth_, axis_;
  wrc_coefficients coefficients_;
};

// The wheelset's place in a frame that moves along the straight track at constant speed.
class Wheelset : public Force::Custom::Implementation {
 public:
  Wheelset(const Options& options, Element& element, const MobilizedBody& body)
      : options_(options), track_(options.rms), element_(element), body_(body), height_(element.height()) {}

  Wrench contact(const State& state, double& rail_y) const {
    const Vec3 place = body_.getBodyOriginLocation(state);
    double slope;
    track_.at(options_.speed * state.getTime() + place[0], rail_y, slope);
    const Vec3 velocity = body_.getBodyOriginVelocity(state) + Vec3(options_.speed, 0, 0);
    return element_.wheels({place[1], height_ + place[2], body_.getBodyRotation(state), velocity,
                            body_.getBodyAngularVelocity(state), rail_y, slope});
  }

  void calcForce(const State& state, SimTK::Vector_<SpatialVec>& forces, SimTK::Vector_<Vec3>&,
                 SimTK::Vector&) const override {
    double rail_y;
    const Wrench both = contact(state, rail_y);
    SpatialVec sum(both.moment[0] + both.moment[1], both.force[0] + both.force[1] + Vec3(0, 0, load));
    if (!options_.free) {
      const Vec3 place = body_.getBodyOriginLocation(state);
      const Vec3 axle(body_.getBodyRotation(state).y());
      for (const double side : {1.0, -1.0}) {
        const Vec3 box = side * arm * axle, moved = place + box - Vec3(0, side * arm, 0);
        const Vec3 force = -box_stiffness.elementwiseMultiply(moved);
        sum += SpatialVec(box % force, force);
      }
    }
    forces[body_.getMobilizedBodyIndex()] += sum;
  }

  Real calcPotentialEnergy(const State&) const override { return 0.0; }

 private:
  Options options_;
  Track track_;
  Element& element_;
  MobilizedBody body_;
  double height_;
};

struct Result {
  double calls = 0.0;  // of the contact element per second
  bool whole = false;
};

Result run(const Options& options) {
  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter(system);
  SimTK::GeneralForceSubsystem forces(system);
  // along x, y, z, about x, about the rolled z, about the axle
  const SimTK::Body::Massless none;
  const SimTK::Body::Rigid wheels(
      SimTK::MassProperties(mass, Vec3(0), SimTK::Inertia(across_axle, about_axle, across_axle)));
  const Transform x_as_z(Rotation(pi / 2, SimTK::YAxis)), y_as_z(Rotation(-pi / 2, SimTK::XAxis));
  MobilizedBody::Translation place(matter.updGround(), none);
  MobilizedBody::Pin roll(place, x_as_z, none, x_as_z);
  MobilizedBody::Pin yaw(roll, none);
  MobilizedBody::Pin body(yaw, y_as_z, wheels, y_as_z);
  const std::unique_ptr<Element> element = options.element == "wrc"
                                               ? std::unique_ptr<Element>(std::make_unique<WrcElement>())
                                               : std::make_unique<SmoothElement>(options.cone);
  auto* wheelset = new Wheelset(options, *element, body);  // the system deletes it
  const Force::Custom contact(forces, wheelset);
  State state = system.realizeTopology();
  place.setOneQ(state, 1, options.lateral);
  body.setOneU(state, 0, -options.speed / radius);

  SimTK::CPodesIntegrator integrator(system, SimTK::CPodes::BDF, SimTK::CPodes::Newton);
  integrator.setAccuracy(options.accuracy);
  integrator.initialize(state);
  element->calls = 0;
  std::FILE* rows = options.rows.empty() ? nullptr : std::fopen(options.rows.c_str(), "w");
  if (!rows && !options.rows.empty()) throw std::runtime_error("cannot write " + options.rows);
  if (rows) std::fprintf(rows, "t,x,y,z,roll,yaw,spin,rail_y,y_right,z_right,y_left,z_left\n");
  std::vector<double> crossings;  // m
  double before = options.lateral, largest = 0.0, reached = 0.0;
  long own = 0;  // calls made for the rows
  const long last = std::lround(options.seconds / options.every);
  try {
    for (long k = 1; k <= last; ++k) {
      while (integrator.getTime() < static_cast<double>(k) * options.every * (1.0 - 1e-12))
        integrator.stepTo(static_cast<double>(k) * options.every);
      const State& now = integrator.getState();
      system.realize(now, SimTK::Stage::Velocity);
      reached = now.getTime();
      const Vec3 at = body.getBodyOriginLocation(now);
      if (options.free && (at[1] > 0.0) != (before > 0.0))
        crossings.push_back(options.speed * (reached - options.every * at[1] / (at[1] - before)));
      before = at[1];
      double rail_y = 0.0;
      if (rows) {
        const Wrench w = wheelset->contact(now, rail_y);
        ++own;
        std::fprintf(rows, "%.6f,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g\n", reached, at[0],
                     at[1], at[2], roll.getOneQ(now, 0), yaw.getOneQ(now, 0), body.getOneU(now, 0), rail_y,
                     w.force[0][1], w.force[0][2], w.force[1][1], w.force[1][2]);
      }
      largest = std::fmax(largest, std::fabs(at[1] - rail_y));
    }
  } catch (const std::exception& error) {
    std::printf("CPODES stopped: %s\n", error.what());
  }
  if (rows) std::fclose(rows);
  Result result;
  result.whole = reached > options.seconds * (1.0 - 1e-9);
  result.calls = static_cast<double>(element->calls - own) / reached;
  std::printf(
      "%-6s reached %.3f of %g s at %g m/s, accuracy %g: steps %d (tried %d), error test failed %d, Newton "
      "failed "
      "%d; contact calls %.0f per second\n",
      options.element.c_str(), reached, options.seconds, options.speed, options.accuracy,
      integrator.getNumStepsTaken(), integrator.getNumStepsAttempted(), integrator.getNumErrorTestFailures(),
      integrator.getNumConvergenceTestFailures(), result.calls);
  if (options.free) {
    std::printf("wave lengths [m]:");
    for (std::size_t i = 2; i < crossings.size(); ++i) std::printf(" %.4f", crossings[i] - crossings[i - 2]);
    std::printf("\n");
  }
  std::fflush(stdout);
  return result;
}

}  // namespace

int main(int count, char** words) {
  Options options;
  options.element = count > 1 ? words[1] : "ratio";
  for (int i = 2; i < count; ++i) {
    const std::string name = words[i];
    if (name == "--free") {
      options.free = true;
      continue;
    }
    double* const number = name == "--seconds"    ? &options.seconds
                           : name == "--speed"    ? &options.speed
                           : name == "--rms"      ? &options.rms
                           : name == "--lateral"  ? &options.lateral
                           : name == "--accuracy" ? &options.accuracy
                           : name == "--cone"     ? &options.cone
                           : name == "--every"    ? &options.every
                                                  : nullptr;
    if ((!number && name != "--rows") || i + 1 == count) {
      std::fprintf(stderr, "%s: not an option, or without its value\n", words[i]);
      return 2;
    }
    ++i;
    if (number)
      *number = std::atof(words[i]);
    else
      options.rows = words[i];
  }
  try {
    if (options.element == "wrc" || options.element == "smooth") return run(options).whole ? 0 : 1;
    if (options.element != "ratio") {
      std::fprintf(stderr, "%s: wrc, smooth or ratio\n", words[1]);
      return 2;
    }
    options.element = "smooth";
    const Result smooth = run(options);
    options.element = "wrc";
    const Result wrc = run(options);
    std::printf("contact calls, wrc over smooth: %.2f\n", wrc.calls / smooth.calls);
    return smooth.whole && wrc.whole && wrc.calls < most * smooth.calls ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
