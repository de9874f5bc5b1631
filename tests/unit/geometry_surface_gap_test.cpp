/// The separation of the true surfaces against closed forms, its own expansion, and Newton over both surface
/// coordinates.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "geometry/gap_rows.hpp"
#include "geometry/surface_gap.hpp"
#include "geometry_test_bodies.hpp"
#include "kernels/kernels.hpp"

namespace wrc::geometry {
namespace {

constexpr double mm = 1e-3;

/// A wheel of one slope all over, r = radius + slope (s - s0), and a plane rail.
struct ConeOnPlane {
  std::array<double, 2> s{0.6, 0.9}, z{}, wheel_slope{}, y{0.6, 0.9}, rail_z{}, rail_slope{},
      none{};  // straight
  Wheel wheel;
  Rail rail;

  ConeOnPlane(double cone, double plane) : wheel_slope{cone, cone}, rail_slope{plane, plane} {
    z = {-0.15 * cone, 0.15 * cone};
    rail_z = {-0.15 * plane, 0.15 * plane};
    wheel.profile = {2, s.data(), z.data(), wheel_slope.data(), none.data(), none.data()};
    wheel.nominal_radius = 0.46;
    rail.profile = {2, y.data(), rail_z.data(), rail_slope.data(), none.data(), none.data()};
  }

  /// From the point (x, y) of the contact plane along the normal n to the cone X^2 + Z^2 = r^2 and the plane,
  /// both roots of quadratic and linear equations.
  double separation(const PosedWheel& posed_wheel, const ContactPoint& contact, double x,
                    double y_contact) const {
    const double c = contact.cosine, sine = contact.sine;
    // Track frame: base point of the normal line, and its direction (0, -sine, c).
    const double base[3] = {contact.x + x, contact.y + c * y_contact, contact.z + sine * y_contact};
    const double n[3] = {0.0, -sine, c};
    const double rail_t =
        (rail_z[0] + rail_slope[0] * (base[1] - y[0]) - base[2]) / (n[2] - rail_slope[0] * n[1]);
    const double from_middle[3] = {base[0], base[1] - posed_wheel.centre_y,
                                   base[2] - contact.vertical_gap - posed_wheel.centre_z};
    double p[3] = {}, d[3] = {};  // wheelset frame
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) {
        p[i] += posed_wheel.attitude.r[k][i] * from_middle[k];
        d[i] += posed_wheel.attitude.r[k][i] * n[k];
      }
    const double cone = wheel_slope[0], r = wheel.nominal_radius + z[0] + cone * (p[1] - s[0]),
                 dr = cone * d[1];
    const double a2 = d[0] * d[0] + d[2] * d[2] - dr * dr, a1 = p[0] * d[0] + p[2] * d[2] - r * dr,
                 a0 = p[0] * p[0] + p[2] * p[2] - r * r;
    const double wheel_t = (-a1 + std::sqrt(a1 * a1 - a2 * a0)) / a2;  // the lower side
    return rail_t - wheel_t;
  }
};

/// Any point can be the origin of a contact frame.
ContactPoint origin_at(double y, double z, double angle) {
  ContactPoint point;
  point.x = 0.4 * mm;
  point.y = y;
  point.z = z;
  point.cosine = std::cos(angle);
  point.sine = std::sin(angle);
  point.wheel_s = y;
  point.vertical_gap = 0.3 * mm;
  return point;
}

TEST(SurfaceGap, OfAConeOnAPlaneIsTheClosedForm) {
  const std::array<Pose, 4> poses{{{},
                                   {.yaw = 0.03},
                                   {.lateral = 2.0 * mm, .vertical = 1.0 * mm, .roll = 0.01, .yaw = -0.02},
                                   {.roll = -0.02, .yaw = 0.2}}};
  for (const double cone : {0.0, -0.05, -2.0}) {  // cylinder, tread, flange
    for (const double plane : {cone, 0.1}) {
      const ConeOnPlane bodies(cone, plane);
      for (const Pose& pose : poses) {
        const SurfaceGap gap{bodies.rail, posed(bodies.wheel, pose),
                             origin_at(0.75, 0.0, std::atan(0.9 * cone))};
        for (const double x : {-40.0 * mm, -8.0 * mm, 0.0, 11.0 * mm})
          for (const double y : {-20.0 * mm, 0.0, 6.0 * mm})
            EXPECT_NEAR(gap.at(x, y), bodies.separation(gap.wheel, gap.contact, x, y), 1e-12)
                << cone << " " << plane << " yaw " << pose.yaw << " x " << x << " y " << y;
      }
    }
  }
}

TEST(SurfaceGap, IsNewtonsOverBothCoordinatesOfTheRealWheel) {
  const ReferenceBodies bodies;
  const std::array<Pose, 5> poses{{{.lateral = 0.0},
                                   {.lateral = 1.0 * mm, .roll = 0.003, .yaw = 0.02},
                                   {.lateral = 5.0 * mm, .yaw = -0.01},
                                   {.lateral = 6.65 * mm, .yaw = 0.01},
                                   {.lateral = 7.2 * mm, .roll = -0.002, .yaw = 0.01}}};
  for (const Pose& pose : poses) {
    const PosedWheel wheel = posed(bodies.wheel, pose);
    ContactPoint contact;
    std::int32_t found = 0;
    ASSERT_EQ(find_contact(bodies.rail, wheel, 1, &contact, found).status, WRC_OK);
    const SurfaceGap gap{bodies.rail, wheel, contact};
    for (const double x : {-12.0 * mm, -5.0 * mm, 0.0, 3.0 * mm, 11.0 * mm})
      for (const double y : {-3.0 * mm, -1.1 * mm, -0.3 * mm, 0.0, 0.2 * mm, 0.9 * mm, 3.0 * mm})
        EXPECT_NEAR(gap.at(x, y), separation(bodies, wheel, contact, x, y), 1e-13)
            << pose.lateral << " x " << x << " y " << y;
  }
}

TEST(SurfaceGap, WithoutYawIsTheRowsParabolaAndThenACircle) {
  // In a frame level with the track every row is the circle
  // r - sqrt(r^2 - x^2) = x^2/2r + x^4/8r^3 + x^6/16r^5.
  const ReferenceBodies bodies;
  const PosedWheel wheel = posed(bodies.wheel, Pose{.lateral = 1.0 * mm});
  ContactPoint contact;
  std::int32_t found = 0;
  ASSERT_EQ(find_contact(bodies.rail, wheel, 1, &contact, found).status, WRC_OK);
  contact.cosine = 1.0;
  contact.sine = 0.0;
  std::array<double, 20> y, height, centre, curvature;
  patch::GapRows rows;
  ASSERT_EQ(fill_gap_rows(bodies.rail, wheel, contact, {.low = -9.0 * mm, .high = 9.0 * mm}, 20,
                          {20, y.data(), height.data(), centre.data(), curvature.data()},
                          kernels_for(InstructionSet::baseline), rows)
                .status,
            WRC_OK);
  const SurfaceGap gap{bodies.rail, wheel, contact};
  for (std::size_t j = 0; j < y.size(); ++j) {
    EXPECT_NEAR(gap.at(0.0, y[j]), height[j], 1e-12);
    for (const double x : {-15.0 * mm, 5.0 * mm, 10.0 * mm}) {
      const double parabola = height[j] + 0.5 * curvature[j] * x * x;
      const double fourth = std::pow(curvature[j], 3) * std::pow(x, 4) / 8.0;
      const double sixth = std::pow(curvature[j], 5) * std::pow(x, 6) / 16.0;
      EXPECT_NEAR(gap.at(x, y[j]) - parabola, fourth + sixth, 1e-12) << x << " " << y[j];
    }
  }
}

TEST(SurfaceGap, OfTheLeftWheelIsTheMirrorImage) {
  const ReferenceBodies right, left(Side::left);
  const Pose pose{.lateral = 6.65 * mm, .roll = 0.002, .yaw = 0.01};
  const PosedWheel wheel = posed(right.wheel, pose),
                   mirrored = posed(left.wheel,
                                    Pose{.lateral = -pose.lateral, .roll = -pose.roll, .yaw = -pose.yaw});
  ContactPoint contact, image;
  std::int32_t found = 0;
  ASSERT_EQ(find_contact(right.rail, wheel, 1, &contact, found).status, WRC_OK);
  ASSERT_EQ(find_contact(left.rail, mirrored, 1, &image, found).status, WRC_OK);
  const SurfaceGap gap{right.rail, wheel, contact}, mirror{left.rail, mirrored, image};
  for (const double x : {-11.0 * mm, 0.0, 7.0 * mm})
    for (const double y : {-4.0 * mm, 0.1 * mm, 9.0 * mm}) EXPECT_NEAR(gap.at(x, y), mirror.at(x, -y), 1e-10);
}

// A step of the profile's curvature under yaw: no row of the surface has the step in curvature over x that
// the expansions of neighbouring rows have, so across y the surface 11 mm ahead bends no more sharply than at
// x = 0.
TEST(SurfaceGap, HasNoRidgeAheadOfTheFlangeRoot) {
  const ReferenceBodies bodies;
  const PosedWheel wheel = posed(bodies.wheel, Pose{.lateral = 6.65 * mm, .yaw = 0.01});
  ContactPoint contact;
  std::int32_t found = 0;
  ASSERT_EQ(find_contact(bodies.rail, wheel, 1, &contact, found).status, WRC_OK);
  const SurfaceGap gap{bodies.rail, wheel, contact};
  std::array<double, 80> y, height, centre, curvature;
  patch::GapRows rows;
  ASSERT_EQ(fill_gap_rows(bodies.rail, wheel, contact, {.low = -1.0 * mm, .high = 1.0 * mm}, 80,
                          {80, y.data(), height.data(), centre.data(), curvature.data()},
                          kernels_for(InstructionSet::baseline), rows)
                .status,
            WRC_OK);
  const auto parabola = [&](std::size_t j, double x) {
    return height[j] + 0.5 * curvature[j] * (x - centre[j]) * (x - centre[j]);
  };
  double middle = 0.0, ahead = 0.0, expanded = 0.0;
  const double step = y[1] - y[0], x = 11.0 * mm;
  for (std::size_t j = 1; j + 1 < y.size(); ++j) {
    const auto bend = [&](auto&& of) {
      return std::abs(of(j - 1) - 2.0 * of(j) + of(j + 1)) / (step * step);
    };
    middle = std::max(middle, bend([&](std::size_t k) { return gap.at(0.0, y[k]); }));
    ahead = std::max(ahead, bend([&](std::size_t k) { return gap.at(x, y[k]); }));
    expanded = std::max(expanded, bend([&](std::size_t k) { return parabola(k, x); }));
  }
  EXPECT_LT(ahead, 1.1 * middle);
  EXPECT_GT(expanded, 5.0 * middle);
}

TEST(SurfaceGap, IsFiniteAndApartFarOff) {
  const ReferenceBodies bodies;
  for (const double yaw : {-0.3, -0.05, 0.0, 0.05, 0.3}) {
    for (const double lateral : {-6.0 * mm, 0.0, 6.65 * mm, 8.0 * mm}) {
      const PosedWheel wheel = posed(bodies.wheel, Pose{.lateral = lateral, .yaw = yaw});
      ContactPoint contact;
      std::int32_t found = 0;
      if (find_contact(bodies.rail, wheel, 1, &contact, found).failed()) continue;
      const SurfaceGap gap{bodies.rail, wheel, contact};
      for (const double x : {-11.0, -1.0, -0.2, 0.2, 0.5, 11.0})
        for (const double y : {-30.0 * mm, -15.0 * mm, -5.0 * mm, 0.0, 5.0 * mm, 15.0 * mm, 30.0 * mm})
          EXPECT_GT(gap.at(x, y), 0.0) << yaw << " " << lateral << " " << x << " " << y;
    }
  }
}

}  // namespace
}  // namespace wrc::geometry
