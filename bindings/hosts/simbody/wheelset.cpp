// A wheelset on an irregular track in Simbody: wrc as a force element, integrated by CPODES (BDF, Newton).
//   wheelset [SECONDS] >FILE.csv     1 s at 40 m/s; rows of time, lateral place, rails' place
#include <iostream>

#include "SimTKsimbody.h"
#include "wrc/wrc.hpp"

using SimTK::Pi, SimTK::Rotation, SimTK::SpatialVec, SimTK::State, SimTK::Transform, SimTK::Vec3;
const double speed = 40.0, radius = 0.46, load = 160e3;  // m/s, m, N on the axle

// Lateral displacement of both rails, m: 40 cosines of 3 to 60 m, rms 1.5 mm, faded in over 10 m.
double track(double x) {
  double sum = 0.0, squares = 0.0;
  for (int k = 0; k < 40; ++k) {
    const double length = 3.0 * std::pow(20.0, k / 39.0);
    sum += length * std::cos(2.0 * Pi * (x / length + 0.618034 * (k + 1)));
    squares += 0.5 * length * length;
  }
  const double t = SimTK::clamp(0.0, x / 10.0, 1.0);
  return t * t * (3.0 - 2.0 * t) * 1.5e-3 / std::sqrt(squares) * sum;
}

// Both rails under a wheelset whose place is seen from a frame that moves at the speed.
struct Rails : SimTK::Force::Custom::Implementation {
  Rails(const SimTK::MobilizedBody& wheelset, const wrc_config& config) : body(wheelset), model(config) {
    for (int side = 0; side < 2; ++side) wheels[side] = wrc::contact(model, side);
    wrc_wheel_input standing = wrc_wheel_input_default();
    standing.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
    standing.vertical_load = load / 2;
    height = wheels[0].wrench(standing).z;
  }
  void calcForce(const State& state, SimTK::Vector_<SpatialVec>& forces, SimTK::Vector_<Vec3>&,
                 SimTK::Vector&) const override {
    const Vec3 place = body.getBodyOriginLocation(state);
    const double x = speed * state.getTime() + place[0], slope = (track(x + 1e-4) - track(x - 1e-4)) / 2e-4;
    wrc_wheel_input input = wrc_wheel_input_default();
    Vec3::updAs(input.wheel.velocity) = body.getBodyOriginVelocity(state) + Vec3(speed, 0, 0);
    input.wheel.angular_axes = WRC_AXES_TRACK;
    Vec3::updAs(input.wheel.angular_velocity) = body.getBodyAngularVelocity(state);
    input.wheel.orientation = WRC_ORIENTATION_ROWS;  // pitch and all
    const Rotation rotation = body.getBodyRotation(state);
    for (int i = 0; i < 9; ++i) input.wheel.rotation[i] = rotation[i / 3][i % 3];
    input.wheel.y = place[1];
    input.wheel.z = height + place[2];
    input.rail.y = track(x);
    input.rail.y_slope = slope;
    for (auto& wheel : wheels) {
      const auto wrench = wheel.wrench(input);  // throws with the library's sentence
      SpatialVec& sum = forces[body.getMobilizedBodyIndex()];
      sum += SpatialVec(Vec3(wrench.moment), Vec3(wrench.force));
    }
  }
  SimTK::Real calcPotentialEnergy(const State&) const override { return 0.0; }
  SimTK::MobilizedBody body;
  wrc::model model;
  mutable wrc::contact wheels[2];
  double height;
};

int main(int count, char** words) {
  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter(system);
  SimTK::GeneralForceSubsystem forces(system);
  const SimTK::Body::Rigid steel({1500.0, Vec3(0), SimTK::Inertia(800.0, 100.0, 800.0)});
  const Rotation axle_last(Pi / 2, SimTK::XAxis);  // of Euler's angles the third is the one about the axle
  SimTK::MobilizedBody::Bushing body(matter.Ground(), axle_last, steel, axle_last);
  for (const Vec3& box : {Vec3(0, 1, 0), Vec3(0, -1, 0)})
    SimTK::Force::LinearBushing(forces, matter.Ground(), Transform(axle_last, box), body,
                                Transform(axle_last, box), {0, 0, 0, 4e6, 1e6, 2e6}, SimTK::Vec6(0));
  SimTK::Force::ConstantForce(forces, body, Vec3(0), Vec3(0, 0, load));
  wrc_config config = wrc_config_default();
  config.wheel.kind = WRC_PROFILE_S1002;
  config.rail.kind = WRC_PROFILE_UIC60_BENCHMARK;
  SimTK::Force::Custom(forces, new Rails(body, config));  // the system deletes it
  State state = system.realizeTopology();
  body.setOneU(state, 2, speed / radius);
  SimTK::CPodesIntegrator integrator(system, SimTK::CPodes::BDF, SimTK::CPodes::Newton);
  integrator.setAccuracy(1e-5);
  integrator.initialize(state);
  double largest = 0.0;
  for (double end = count > 1 ? std::atof(words[1]) : 1.0, t = 0.01; t < end + 0.005; t += 0.01) {
    while (integrator.getTime() < t) integrator.stepTo(t);
    system.realize(integrator.getState(), SimTK::Stage::Position);
    const Vec3 at = body.getBodyOriginLocation(integrator.getState());
    const double rails = track(speed * t + at[0]);
    std::cout << t << ',' << at[1] << ',' << rails << '\n';
    largest = std::max(largest, std::abs(at[1] - rails));
  }
  std::cerr << integrator.getNumStepsTaken() << " steps, at most " << 1e3 * largest
            << " mm from the rails' middle\n";
  return largest < 5e-3 ? 0 : 1;
}
