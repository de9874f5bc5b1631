/// Rails that run aslant of the track (wrc_rail_state.y_slope, z_slope): against everything turned by hand,
/// against sections that are displaced along the track, against exact solutions.
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "reference_contact.hpp"
#include "test_config.hpp"
#include "vectors.hpp"
#include "wheel_on_rail.hpp"
#include "wrc/wrc_offline.h"

namespace {

constexpr double radius = 0.46, half_base = 0.75, rail_origin = 0.7605325577;

/// The smallest rotation that takes x into (1, y, z), by Rodrigues' formula about x cross that.
Matrix smallest_rotation(double y, double z) {
  const double tangent = std::sqrt(y * y + z * z);
  if (tangent == 0.0) return about_x(0.0);
  const double angle = std::atan(tangent), s = std::sin(angle), c = 1.0 - std::cos(angle);
  const Vector k = {0.0, -z / tangent, y / tangent};
  const Matrix across = {0.0, -k[2], k[1], k[2], 0.0, -k[0], -k[1], k[0], 0.0};
  const Matrix twice = across * across;
  Matrix turn = about_x(0.0);
  for (std::size_t i = 0; i < 9; ++i) turn[i] += s * across[i] + c * twice[i];
  return turn;
}

/// S1002 on the benchmark UIC60, rolling with a little of everything, on a rail that moves.
class RailSlope : public testing::Test, protected PlacedWheel {
 protected:
  RailSlope() {
    take_reference_bodies();
    roll_with_a_little_of_everything();
    wheel.velocity[2] = 0.01;
    rail.z_velocity = -0.02;
    rail.roll_rate = 0.05;
    input.damping = 0.05;
    config.surface.tolerance = 1e-7;
  }
  void SetUp() override { create(); }
  static double outwards_of(int32_t which) { return which == WRC_SIDE_LEFT ? -1.0 : 1.0; }
  double outward() const { return outwards_of(side); }
  /// Finds the height for 60 kN, then is pressed by that height.
  void carry() {
    input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
    input.vertical_load = 60e3;
    ASSERT_EQ(step(), WRC_OK) << error();
    wheel.z = wrench.z;
    input.prescribed = WRC_PRESCRIBE_HEIGHT;
    input.vertical_load = 0.0;
    ASSERT_EQ(step(), WRC_OK) << error();
  }

  /// The input seen in axes along the rail, turned about the displaced origin of its profile, with a rail
  /// that is straight there: what a host did by hand. Velocities are the wheel's over the rail's.
  wrc_wheel_input turned_by_hand(const Matrix& turn) const {
    wrc_wheel_input by_hand = input;
    wrc_wheel_state& seen = by_hand.wheel;
    const Matrix back = transposed(turn), own = about_x(wheel.roll) * about_z(wheel.yaw);
    const bool of_wheel = wheel.reference == WRC_REFERENCE_WHEEL;
    const Vector arm = own * Vector{0.0, of_wheel ? 0.0 : outward() * half_base, 0.0};
    const Vector origin = {0.0, outward() * rail_origin + rail.y, rail.z};
    const Vector nominal = {0.0, of_wheel ? outward() * half_base : 0.0, -radius};
    const Vector centre = Vector{0.0, wheel.y, wheel.z} + nominal + arm;  // of the wheel
    const Vector at = back * (centre - origin) + origin - nominal - back * arm;
    seen.y = at[1];
    seen.z = at[2];
    seen.roll = seen.yaw = 0.0;
    seen.orientation = WRC_ORIENTATION_ROWS;
    const Matrix rotation = back * own;
    std::copy(rotation.begin(), rotation.end(), seen.rotation);
    put(back * (vector_of(wheel.velocity) - Vector{0.0, rail.y_velocity, rail.z_velocity}), seen.velocity);
    put(back * vector_of(wheel.angular_velocity), seen.angular_velocity);
    by_hand.rail.y_slope = by_hand.rail.z_slope = by_hand.rail.y_velocity = by_hand.rail.z_velocity = 0.0;
    return by_hand;
  }
  static void expect_same(const wrc_wrench& one, const wrc_wrench& other, double share) {
    const double near = share * other.normal_force;
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(one.force[i], other.force[i], near) << "force " << i;
      EXPECT_NEAR(one.moment[i], other.moment[i], near) << "moment " << i;
    }
    EXPECT_NEAR(one.normal_force, other.normal_force, near);
    EXPECT_NEAR(one.power, other.power, share * (other.power + other.normal_force));
    EXPECT_EQ(one.region_count, other.region_count);
  }
  static wrc_wrench turned(const wrc_wrench& seen, const Matrix& turn) {
    wrc_wrench back = seen;
    put(turn * vector_of(seen.force), back.force);
    put(turn * vector_of(seen.moment), back.moment);
    return back;
  }
  wrc_wrench exactly(const wrc_wheel_input& of) {
    wrc_exact_wrench_options options = wrc_exact_wrench_options_default();
    options.cell_x = options.cell_s = 0.5e-3;
    wrc_wrench exact = sized<wrc_wrench>();
    EXPECT_EQ(wrc_exact_wrench(contact, &of, &options, &exact), WRC_OK) << error();
    return exact;
  }
};

TEST_F(RailSlope, IsEverythingElseTurnedByHand) {
  for (const int32_t which : {WRC_SIDE_RIGHT, WRC_SIDE_LEFT})
    for (const int32_t reference : {WRC_REFERENCE_WHEELSET, WRC_REFERENCE_WHEEL})
      for (const double slope : {1e-3, -1e-2, 0.05}) {
        SCOPED_TRACE(testing::Message() << which << ' ' << reference << ' ' << slope);
        take(which);
        wheel.y = outward() * 1e-3;
        wheel.reference = reference;
        rail.y_slope = slope;
        rail.z_slope = 0.4 * slope;
        // the wheel goes along with the rail, nose and all, at some distance of its own
        wheel.yaw = slope + 2e-3;
        wheel.velocity[1] = 20.0 * slope + 0.03;
        wheel.velocity[2] = 20.0 * rail.z_slope + 0.01;
        input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
        input.vertical_load = 60e3;
        const double damping = std::exchange(input.damping, 0.0);
        ASSERT_EQ(step(), WRC_OK) << error();
        EXPECT_NEAR(wrench.force[2], -60e3, 1e-7 * 60e3);  // along the track's z, not the rail's
        const wrc_wrench carried = wrench;
        input.prescribed = WRC_PRESCRIBE_HEIGHT;
        input.vertical_load = 0.0;
        wheel.z = wrench.z;
        ASSERT_EQ(step(), WRC_OK) << error();
        expect_same(wrench, carried, 1e-7);

        input.damping = damping;
        ASSERT_EQ(step(), WRC_OK) << error();
        const wrc_wrench aslant = wrench;
        wrc_region region = sized<wrc_region>(), along = region;
        ASSERT_EQ(wrc_contact_region(contact, 0, &region), WRC_OK);
        const Matrix turn = smallest_rotation(rail.y_slope, rail.z_slope);
        const wrc_wheel_input by_hand = turned_by_hand(turn);
        ASSERT_EQ(wrc_contact_wrench(contact, &by_hand, &wrench), WRC_OK) << error();
        wrc_wrench back = turned(wrench, turn);
        expect_same(aslant, back, 1e-9);
        for (int i = 0; i < 3; ++i) EXPECT_EQ(aslant.rail_force[i], -aslant.force[i]);
        ASSERT_EQ(wrc_contact_region(contact, 0, &along), WRC_OK);
        EXPECT_NEAR(region.y_wheel, along.y_wheel, 1e-9);
        EXPECT_NEAR(region.z_rail, along.z_rail, 1e-9);
        EXPECT_NEAR(region.creepage.lateral, along.creepage.lateral, 1e-9);
        wheel.z = 1.2e-3;
      }
}

/// Where a region is told to lie: its force has no moment about the track's axes there but that of its own.
TEST_F(RailSlope, RegionsLieInTheTrack) {
  rail.y_slope = 0.01;
  rail.z_slope = -0.02;
  wheel.velocity[1] = 0.2;
  wheel.velocity[2] = -0.4;
  wheel.yaw = 0.012;
  input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
  input.vertical_load = 60e3;
  input.damping = 0.0;
  ASSERT_EQ(step(), WRC_OK) << error();
  Vector force{}, moment{};
  const Vector reference = {0.0, wheel.y, wrench.z - radius};
  for (int32_t k = 0; k < wrench.region_count; ++k) {
    wrc_region region = sized<wrc_region>();
    ASSERT_EQ(wrc_contact_region(contact, k, &region), WRC_OK);
    force = force + vector_of(region.force);
    moment = moment + vector_of(region.moment) +
             cross(vector_of(region.point) - reference, vector_of(region.force));
    // below the axle, square to the rail: half a wheel's radius times the slope behind it, and the wheel's
    // own place by the yaw
    EXPECT_NEAR(region.point[0], -half_base * std::sin(wheel.yaw) - radius * rail.z_slope, 1e-3);
    std::vector<double> x(static_cast<std::size_t>(region.strip_count));
    ASSERT_EQ(wrc_contact_field(contact, k, WRC_FIELD_STRIP_CENTRE, x.data(), x.size(), nullptr), WRC_OK);
    EXPECT_NEAR(x[x.size() / 2], region.point[0], 2e-3);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(force[i], wrench.force[i], 1e-9 * wrench.normal_force);
    EXPECT_NEAR(moment[i], wrench.moment[i], 1e-9 * wrench.normal_force);
  }
}

/// The axes of docs/hosts.md as hosts turned them: no place is, which is the same for a wheel right above
/// the origin of its rail's profile; elsewhere half the square of the slope of the way to it is left.
TEST_F(RailSlope, TheUsualTurnOfOrientationAndVelocities) {
  config.track.rail_origin = half_base;
  create();
  wheel.reference = WRC_REFERENCE_WHEEL;
  rail.y_velocity = rail.z_velocity = 0.0;
  rail.y = wheel.y;
  const double slope = 3e-3, angle = std::atan(slope);
  wheel.roll = 0.0;  // else roll, seen aslant, is not the same roll
  wheel.yaw = slope;
  wheel.velocity[1] = 20.0 * slope;
  rail.y_slope = slope;
  input.damping = 0.0;
  carry();
  const wrc_wrench aslant = wrench;
  wrc_wheel_input usual = input;
  usual.rail.y_slope = 0.0;
  usual.wheel.yaw -= angle;
  put(about_z(-angle) * vector_of(wheel.velocity), usual.wheel.velocity);
  put(about_z(-angle) * vector_of(wheel.angular_velocity), usual.wheel.angular_velocity);
  ASSERT_EQ(wrc_contact_wrench(contact, &usual, &wrench), WRC_OK) << error();
  expect_same(aslant, turned(wrench, about_z(angle)), 1e-9);
}

TEST_F(RailSlope, LeftIsTheMirrorImageOfRight) {
  rail.y_slope = 0.01;
  rail.z_slope = 0.004;
  wheel.velocity[1] = 0.2;
  wheel.yaw = 0.011;
  ASSERT_EQ(step(), WRC_OK) << error();
  const wrc_wrench right = wrench;
  take(WRC_SIDE_LEFT);
  for (double* each :
       {&wheel.y, &wheel.roll, &wheel.yaw, &wheel.velocity[1], &wheel.angular_velocity[0],
        &wheel.angular_velocity[2], &rail.y, &rail.roll, &rail.y_velocity, &rail.roll_rate, &rail.y_slope})
    *each = -*each;
  ASSERT_EQ(step(), WRC_OK) << error();
  EXPECT_EQ(wrench.force[0], right.force[0]);
  EXPECT_EQ(wrench.force[1], -right.force[1]);
  EXPECT_EQ(wrench.force[2], right.force[2]);
  EXPECT_EQ(wrench.moment[0], -right.moment[0]);
  EXPECT_EQ(wrench.moment[1], right.moment[1]);
}

/// Differences of second order over shorter and shorter steps come to one number, through zero, where the
/// formulas are left out, and beside it.
TEST_F(RailSlope, TheWrenchIsSmoothInTheSlopes) {
  const auto lateral = [&](double& slope, double at) {
    slope = at;
    EXPECT_EQ(step(), WRC_OK) << error();
    slope = 0.0;
    return wrench.force[1];
  };
  for (double* const slope : {&rail.y_slope, &rail.z_slope})
    for (const double middle : {0.0, 2e-3}) {
      const auto second = [&](double h) {
        return (lateral(*slope, middle + h) - 2.0 * lateral(*slope, middle) + lateral(*slope, middle - h)) /
               (h * h);
      };
      const auto first = [&](double h) {
        return (lateral(*slope, middle + h) - lateral(*slope, middle - h)) / (2.0 * h);
      };
      const double slope_here = first(1e-5), bend = second(2e-4);
      EXPECT_NEAR(first(1e-6), slope_here, 1e-3 * std::fabs(slope_here) + 1e3);
      EXPECT_NEAR(second(1e-4), bend, 0.05 * std::fabs(bend) + 1e-3 * std::fabs(slope_here) / 1e-4);
      // no jump where the slope begins
      EXPECT_NEAR(lateral(*slope, middle + 1e-12), lateral(*slope, middle), 1e-4);
    }
}

/// Sections stand square to the track, so that a rail of sections displaced in proportion to the distance is
/// that rail sheared, not turned: the same but for the square of the slope.
TEST_F(RailSlope, IsARailOfSectionsThatRunsSo) {
  rail = sized<wrc_rail_state>();
  wheel.roll = 0.0;
  input.damping = 0.0;
  wrc_config plain = config;
  for (const int32_t which : {WRC_SIDE_RIGHT, WRC_SIDE_LEFT})
    for (const double slope : {1e-3, 1e-2}) {
      SCOPED_TRACE(testing::Message() << which << ' ' << slope);
      const double z_slope = 0.5 * slope;
      wheel.yaw = outwards_of(which) * slope + 1e-3;
      put({20.0, 20.0 * outwards_of(which) * slope, 20.0 * z_slope}, wheel.velocity);
      wheel.y = 0.0;
      config = plain;
      create(which);
      rail.y_slope = outwards_of(which) * slope;
      rail.z_slope = z_slope;
      carry();
      const wrc_wrench turned_rail = wrench;
      const wrc_wrench exactly_turned = exactly(input);

      rail = sized<wrc_rail_state>();
      std::vector<wrc_rail_section> sections;
      for (int k = -4; k <= 4; ++k) {
        wrc_rail_section section{};
        section.distance = 10.0 + 0.5 * k;
        section.y = slope * 0.5 * k;  // outwards
        section.z = z_slope * 0.5 * k;
        section.profile = config.rail;
        sections.push_back(section);
      }
      config.rail_section_count = static_cast<uint32_t>(sections.size());
      config.rail_sections = sections.data();
      config.rail_section_size = sizeof sections[0];
      create(which);
      input.distance = 10.0;
      carry();
      std::printf("slope %g: sections %.1f %.1f N, aslant %.1f %.1f N\n", slope, wrench.force[0],
                  wrench.force[1], turned_rail.force[0], turned_rail.force[1]);
      // exactly, sections are splines through strips, whatever the slope
      const double share = 2.0 * slope, of_splines = 4e-3;
      for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(wrench.force[i], turned_rail.force[i], share * 0.3 * turned_rail.normal_force) << i;
      const wrc_wrench exactly_sections = exactly(input);
      std::printf("  exactly: sections %.1f %.1f N, aslant %.1f %.1f N\n", exactly_sections.force[0],
                  exactly_sections.force[1], exactly_turned.force[0], exactly_turned.force[1]);
      for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(exactly_sections.force[i], exactly_turned.force[i],
                    (share + of_splines) * 0.3 * exactly_turned.normal_force)
            << i;
      input.distance = 0.0;
    }
}

TEST_F(RailSlope, ExactSolutionsAreTurnedAlike) {
  rail.y_slope = 0.02;
  rail.z_slope = -0.01;
  wheel.yaw = 0.021;
  wheel.velocity[1] = 0.41;
  wheel.velocity[2] = -0.2;
  input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
  input.vertical_load = 60e3;
  input.damping = 0.0;
  ASSERT_EQ(step(), WRC_OK) << error();
  wheel.z = wrench.z;
  input.prescribed = WRC_PRESCRIBE_HEIGHT;
  input.vertical_load = 0.0;
  const wrc_wrench exact = exactly(input);
  const Matrix turn = smallest_rotation(rail.y_slope, rail.z_slope);
  expect_same(exact, turned(exactly(turned_by_hand(turn)), turn), 1e-7);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(wrench.force[i], exact.force[i], 0.04 * 60e3) << i;
}

TEST_F(RailSlope, IsNoneOfARoller) {
  config.roller_curvature = 1.0;
  create();
  rail.z_slope = 1e-3;
  EXPECT_EQ(step(), WRC_ERROR_UNSUPPORTED);
  ReferenceWheel::expect_words(error(), {"input.rail.z_slope = 0.001", "roller"});
}

}  // namespace
