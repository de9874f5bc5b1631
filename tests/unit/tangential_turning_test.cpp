#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tangential/simd/turning.hpp"

namespace wrc::simd {
namespace {

constexpr double pi = 3.14159265358979323846;

double lane(Pack x) {
  double of[lanes];
  store_pack(of, x);
  return of[0];
}

struct Case {
  double angle;  ///< of e
  double Vx, Vy, d;
};

Case random_case(std::mt19937& random) {
  std::uniform_real_distribution<double> angle(-pi, pi), decade(-3.0, 3.0);
  const double towards = angle(random), r = std::pow(10.0, decade(random));
  return {angle(random), r * std::cos(towards), r * std::sin(towards), std::pow(10.0, decade(random))};
}

Turn turn_of(double Vx, double Vy, double d, Pack ex, Pack ey) {
  Turn t = begin_turn(Vx, Vy, d, ex, ey);
  turn(t);
  return t;
}

Turn turn_of(const Case& c) { return turn_of(c.Vx, c.Vy, c.d, std::cos(c.angle), std::sin(c.angle)); }

/// Angle of e after the step; z of the step gives `ahead`.
double turned(const Case& c, double& ahead) {
  const Turn t = turn_of(c);
  ahead = lane(t.ahead);
  return std::atan2(lane(t.ey), lane(t.ex));
}

TEST(Turning, HalvesTheTangentAsItShould) {
  std::mt19937 random(3);
  for (int n = 0; n < 1000; ++n) {
    const Case c = random_case(random);
    const double against = std::atan2(-c.Vy, -c.Vx), z = 2.0 * std::hypot(c.Vx, c.Vy) / c.d;
    const double q = 1.0 + z + 0.5 * z * z;
    const double expected = against + 2.0 * std::atan(std::tan(0.5 * (c.angle - against)) / q);
    double ahead;
    EXPECT_NEAR(std::remainder(turned(c, ahead) - expected, 2.0 * pi), 0.0, 1e-12);
    EXPECT_NEAR(ahead * (2.0 + z), 1.0, 1e-14);
  }
}

TEST(Turning, KeepsTheLengthOfTheDirection) {
  std::mt19937 random(5);
  Pack ex = 0.6, ey = 0.8;
  for (int n = 0; n < 1000; ++n) {
    const Case c = random_case(random);
    const Turn t = turn_of(c.Vx, c.Vy, c.d, ex, ey);
    ex = t.ex;
    ey = t.ey;
  }
  EXPECT_NEAR(std::hypot(lane(ex), lane(ey)), 1.0, 1e-13);  // a thousand roundings
}

TEST(Turning, LeavesTheDirectionWhereNothingSlipsAndWhereItHasNoWayToTurn) {
  for (const double Vx : {0.0, 3.0, 1e12}) {  // 3, 1e12: against itself, where both ways round are as far
    const Turn t = turn_of(Vx, 0.0, 0.01, 1.0, 0.0);
    EXPECT_NEAR(std::fabs(lane(t.ex)), 1.0, 1e-15);
    EXPECT_EQ(lane(t.ey), 0.0);
  }
}

TEST(Turning, TwoAtOnceAreTheSameAsEachByItself) {
  std::mt19937 random(11);
  for (int n = 0; n < 100; ++n) {
    const Case of[] = {random_case(random), random_case(random)};
    Turn together[2];
    for (int k = 0; k < 2; ++k)
      together[k] = begin_turn(of[k].Vx, of[k].Vy, of[k].d, std::cos(of[k].angle), std::sin(of[k].angle));
    turn(together[0], together[1]);
    for (int k = 0; k < 2; ++k) {
      const Turn alone = turn_of(of[k]);
      Pack Turn::*const all[] = {&Turn::Vx, &Turn::Vy, &Turn::d,  &Turn::ex, &Turn::ey,     &Turn::ahead,
                                 &Turn::r,  &Turn::s,  &Turn::cx, &Turn::cy, &Turn::per_rs, &Turn::per_c};
      for (Pack Turn::*const x : all) EXPECT_EQ(lane(together[k].*x), lane(alone.*x));
    }
  }
}

TEST(Turning, SlopesAreThoseOfDifferences) {
  std::mt19937 random(7);
  for (int n = 0; n < 300; ++n) {
    const Case c = random_case(random);
    const TurnSlopes s = slopes(turn_of(c), std::cos(c.angle), std::sin(c.angle));
    const double r = std::hypot(c.Vx, c.Vy);
    const double unit[] = {1.0, r, r, c.d};
    const double of_angle[] = {lane(s.kept), lane(s.by_x), lane(s.by_y), lane(s.by_d)};
    const double of_ahead[] = {0.0, lane(s.ahead_by_x), lane(s.ahead_by_y), lane(s.ahead_by_d)};
    for (int k = 0; k < 4; ++k) {
      const double step = 1e-6 * unit[k];
      Case more = c, less = c;
      double* const inputs_of[][4] = {{&more.angle, &more.Vx, &more.Vy, &more.d},
                                      {&less.angle, &less.Vx, &less.Vy, &less.d}};
      *inputs_of[0][k] += step;
      *inputs_of[1][k] -= step;
      double ahead_more, ahead_less;
      const double change = std::remainder(turned(more, ahead_more) - turned(less, ahead_less), 2.0 * pi);
      // an unstable direction, against which e is turned away, multiplies what is left of the differences by
      // q
      const double largest = 1.0 + std::fabs(of_angle[k] * unit[k]);
      EXPECT_NEAR(of_angle[k] * unit[k], 0.5e6 * change, 1e-7 * largest * largest * largest) << n << ' ' << k;
      EXPECT_NEAR(of_ahead[k] * unit[k], 0.5e6 * (ahead_more - ahead_less), 1e-9);
    }
  }
}

}  // namespace
}  // namespace wrc::simd
