// A wheelset on an irregular track in Simbody: wrc as a force element, integrated by CPODES (BDF, Newton).
//   wheelset [SECONDS [FILE.csv]]     1 s at 40 m/s; rows of time, lateral place, rails' place
#include <cstdio>
#include <cstdlib>

#include "SimTKsimbody.h"
#include "wrc/wrc.hpp"

using SimTK::Rotation, SimTK::SpatialVec, SimTK::State, SimTK::Transform, SimTK::Vec3;

const double pi = 3.14159265358979323846, speed = 40.0, radius = 0.46, load = 160e3;  // m/s, m, N on the axle

// Lateral displacement of both rails, m: 40 cosines of 3 to 60 m, rms 1.5 mm, faded in over 10 m.
double track(double x, double& slope) {
  double sum = 0.0, change = 0.0, squares = 0.0;
  for (int k = 0; k < 40; ++k) {
    const double length = 3.0 * std::pow(20.0, k / 39.0), number = 2.0 * pi / length;
    const double angle = number * x + 2.0 * pi * std::fmod(0.618034 * (k + 1), 1.0);
    squares += 0.5 * length * length;
    sum += length * std::cos(angle);
    change -= 2.0 * pi * std::sin(angle);
  }
  const double scale = 1.5e-3 / std::sqrt(squares), t = std::fmin(std::fmax(x / 10.0, 0.0), 1.0);
  const double fade = t * t * (3.0 - 2.0 * t), rate = 6.0 * t * (1.0 - t) / 10.0;
  slope = scale * (fade * change + rate * sum);
  return scale * fade * sum;
}

// Both rails and the axle boxes' springs on a wheelset whose place is seen from a frame that moves at the
// speed.
class Rails : public SimTK::Force::Custom::Implementation {
 public:
  explicit Rails(const SimTK::MobilizedBody& body)
      : body_(body), model_(profiles()), input_(wrc_wheel_input_default()) {
    for (int side = 0; side < 2; ++side) wheel_[side] = wrc::contact(model_, side);
    wrc_wheel_input standing = wrc_wheel_input_default();
    standing.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
    standing.vertical_load = load / 2;
    standing.friction.coefficient = 0.0;
    height_ = wheel_[0].wrench(standing).z;
    input_.start = WRC_START_ANEW;  // a Jacobian by differences wants the same forces at the same pose
  }

  void calcForce(const State& state, SimTK::Vector_<SpatialVec>& forces, SimTK::Vector_<Vec3>&,
                 SimTK::Vector&) const override {
    const Vec3 place = body_.getBodyOriginLocation(state);
    double slope;
    input_.rail.y = track(speed * state.getTime() + place[0], slope);
    const Rotation along(std::atan(slope),
                         SimTK::ZAxis);  // axes along the rails: these stand still, and are bent
    const Rotation turned = ~along * body_.getBodyRotation(state);
    const Vec3 velocity = ~along * (body_.getBodyOriginVelocity(state) + Vec3(speed, 0, 0));
    const Vec3 angular = ~along * body_.getBodyAngularVelocity(state);
    double rotation[9];
    for (int i = 0; i < 9; ++i) rotation[i] = turned[i / 3][i % 3];
    input_.wheel.rotation = rotation;  // pitch and all
    input_.wheel.y = place[1];
    input_.wheel.z = height_ + place[2];
    for (int i = 0; i < 3; ++i) {
      input_.wheel.velocity[i] = velocity[i];
      input_.wheel.angular_velocity[i] = angular[i];
    }
    SpatialVec sum(Vec3(0), Vec3(0, 0, load));
    for (int side = 0; side < 2; ++side) {
      const auto wrench = wheel_[side].wrench(input_);  // throws with the library's sentence
      sum += SpatialVec(along * Vec3(wrench.moment), along * Vec3(wrench.force));
    }
    for (const double side : {1.0, -1.0}) {
      const Vec3 box = side * Vec3(body_.getBodyRotation(state).y()), moved = place + box - Vec3(0, side, 0);
      const Vec3 spring = -Vec3(4e6, 2e6, 1e6).elementwiseMultiply(moved);
      sum += SpatialVec(box % spring, spring);
    }
    forces[body_.getMobilizedBodyIndex()] += sum;
  }
  SimTK::Real calcPotentialEnergy(const State&) const override { return 0.0; }

 private:
  static wrc_config profiles() {
    wrc_config config = wrc_config_default();
    config.wheel.kind = WRC_PROFILE_S1002;
    config.rail.kind = WRC_PROFILE_UIC60_BENCHMARK;
    config.material.shear_modulus = 82e9;
    config.material.poisson = 0.28;
    return config;
  }
  SimTK::MobilizedBody body_;
  wrc::model model_;
  mutable wrc::contact wheel_[2];
  mutable wrc_wheel_input input_;
  double height_;
};

int main(int count, char** words) try {
  const double seconds = count > 1 ? std::atof(words[1]) : 1.0;
  std::FILE* rows = count > 2 ? std::fopen(words[2], "w") : nullptr;
  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter(system);
  SimTK::GeneralForceSubsystem forces(system);
  const SimTK::Body::Massless none;
  const SimTK::Body::Rigid wheels(
      SimTK::MassProperties(1500.0, Vec3(0), SimTK::Inertia(800.0, 100.0, 800.0)));
  const Transform x_as_z(Rotation(pi / 2, SimTK::YAxis)), y_as_z(Rotation(-pi / 2, SimTK::XAxis));
  SimTK::MobilizedBody::Translation place(matter.updGround(), none);  // then roll, yaw, pitch
  SimTK::MobilizedBody::Pin roll(place, x_as_z, none, x_as_z), yaw(roll, none),
      body(yaw, y_as_z, wheels, y_as_z);
  const SimTK::Force::Custom contact(forces, new Rails(body));  // the system deletes it
  State state = system.realizeTopology();
  body.setOneU(state, 0, -speed / radius);
  SimTK::CPodesIntegrator integrator(system, SimTK::CPodes::BDF, SimTK::CPodes::Newton);
  integrator.setAccuracy(1e-5);
  integrator.initialize(state);
  double largest = 0.0, slope;
  for (int k = 1; k <= seconds / 0.01 + 0.5; ++k) {
    while (integrator.getTime() < 0.01 * k * (1.0 - 1e-12)) integrator.stepTo(0.01 * k);
    system.realize(integrator.getState(), SimTK::Stage::Position);
    const Vec3 at = body.getBodyOriginLocation(integrator.getState());
    const double rails = track(speed * integrator.getTime() + at[0], slope);
    if (rows) std::fprintf(rows, "%.2f,%.9g,%.9g\n", integrator.getTime(), at[1], rails);
    largest = std::fmax(largest, std::fabs(at[1] - rails));
  }
  if (rows) std::fclose(rows);
  std::printf("%g s at %g m/s: %d steps, Newton failed %d; at most %.2f mm from the rails' middle\n",
              integrator.getTime(), speed, integrator.getNumStepsTaken(),
              integrator.getNumConvergenceTestFailures(), 1e3 * largest);
  return largest < 5e-3 ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
