// find_overlaps() and overlap_surfaces(): cylinders and crowned wheels over flat rails and rollers, whose
// overlaps are known in closed form.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "cut_into.hpp"
#include "surface/geometry/overlap_slopes.hpp"
#include "surface/geometry/surface_geometry.hpp"
#include "surface/simd/tasks.hpp"

namespace wrc::surface {
namespace {

constexpr double radius = 0.46;  // of the wheel [m]

/// A wheel of a transverse radius `crown` (0: a cylinder) above a rail of a transverse radius `head` (0:
/// flat).
struct Bodies {
  std::vector<double> wheel_memory, rail_memory, knot_memory, strip_memory, overlap_memory, scratch_memory;
  SurfaceGeometry surfaces;
  Overlaps memory;
  OverlapScratch scratch;

  explicit Bodies(double crown = 0.0, double head = 0.0, std::int32_t capacity = 256) {
    const auto height = [](double r, double y) { return r > 0.0 ? r - std::sqrt(r * r - y * y) : 0.0; };
    constexpr int half = 400;
    std::vector<double> y, wheel, rail;
    for (int i = -half; i <= half; ++i) {
      y.push_back(0.1e-3 * i);
      wheel.push_back(radius - height(crown, 0.1e-3 * i));
      rail.push_back(height(head, 0.1e-3 * i));
    }
    const auto points = static_cast<std::int32_t>(y.size());
    const auto curve = [points](Arena& arena) { return cut_curve(arena, points); };
    Curve on_wheel;
    EXPECT_FALSE(
        make_curve(points, y.data(), wheel.data(), cut_into(wheel_memory, curve), on_wheel).failed());
    EXPECT_FALSE(make_curve(points, y.data(), rail.data(), cut_into(rail_memory, curve), surfaces.rail_curve)
                     .failed());
    surfaces.wheel = make_wheel_curve(
        on_wheel, cut_into(knot_memory, [&](Arena& arena) { return cut_knots(arena, on_wheel.pieces); }));
    surfaces.rail = cut_rail(surfaces.rail_curve, {}, 256,
                             cut_into(strip_memory, [](Arena& arena) { return cut_strips(arena, 256); }));
    surfaces.wheel_radius = radius;
    surfaces.kernels = &kernels_for(InstructionSet::baseline);
    memory = cut_into(overlap_memory, [&](Arena& arena) { return cut_overlaps(arena, capacity, true); });
    scratch = cut_into(scratch_memory, [&](Arena& arena) {
      return cut_overlap_scratch(arena, on_wheel.pieces, surfaces.rail.count);
    });
  }

  Overlaps find(const RelativePose& pose, double margin = 0.0) {
    return find_overlaps(*surfaces.kernels, surfaces.rail, surfaces.wheel, pose, margin, nullptr, scratch,
                         memory);
  }
  /// With all that varies; `distance` along the track.
  Overlaps overlap(const RelativePose& pose, double distance, double angle, double margin = 0.0) {
    PlacedRail rail;
    EXPECT_FALSE(place_rail(surfaces, distance, {}, rail).failed());
    return overlap_surfaces(surfaces, rail, pose, angle, margin, scratch, memory);
  }
};

/// Turned by roll about x, then by yaw about z; the lowest point of the untilted wheel `deep` below the rail.
RelativePose pose_of(double y, double deep, double yaw = 0.0, double roll = 0.0) {
  const double c = std::cos(yaw), s = std::sin(yaw), cr = std::cos(roll), sr = std::sin(roll);
  return {{{c, -s * cr, s * sr}, {s, c * cr, -c * sr}, {0.0, sr, cr}}, y, deep - radius};
}

TEST(Overlap, ACylinderOverAPlaneOverlapsAllItsWidthAlike) {
  Bodies bodies;
  const RailStrips& rail = bodies.surfaces.rail;
  constexpr double deep = 0.1e-3, aside = 10.3e-3;
  const Overlaps o = bodies.find(pose_of(aside, deep));
  // the wheel's face, 80 mm wide, lies over the rail's from -29.7 mm on
  const auto inside = static_cast<std::int32_t>(
      std::count_if(rail.y, rail.y + rail.count, [&](double y) { return y > aside - 40e-3; }));
  ASSERT_EQ(o.count, inside);
  EXPECT_FALSE(o.full);
  for (std::int32_t i = 0; i < o.count; ++i) {
    const std::int32_t j = o.strip[i];
    EXPECT_NEAR(o.depth[i], deep, 1e-15);
    EXPECT_EQ(o.centre[i], 0.0);
    EXPECT_NEAR(o.curvature[i], 1.0 / radius, 1e-12);
    EXPECT_NEAR(o.ny[i], 0.0, 1e-14);
    EXPECT_NEAR(o.nz[i], 1.0, 1e-14);
    EXPECT_NEAR(o.wy[i], rail.y[j] - aside, 1e-15);
    EXPECT_NEAR(o.wz[i], radius, 1e-15);
    // the ray ends on the profile at the strip's own y
    EXPECT_NEAR(evaluate(bodies.surfaces.wheel.curve, o.piece[i], o.u[i]).y, rail.y[j] - aside, 1e-15);
  }
}

// Under a yaw psi the lowest line of the cylinder runs along (-sin psi, cos psi); a step dx along the track
// is dx cos psi away from it.
TEST(Overlap, AYawedCylinderTouchesAlongItsAxle) {
  Bodies bodies;
  constexpr double deep = 0.1e-3, yaw = 0.05;
  const Overlaps o = bodies.find(pose_of(0.0, deep, yaw));
  ASSERT_GT(o.count, 140);
  for (std::int32_t i = 0; i < o.count; ++i) {
    EXPECT_NEAR(o.depth[i], deep, 1e-14);
    EXPECT_NEAR(o.centre[i], -std::tan(yaw) * o.wy[i], 1e-14);
    EXPECT_NEAR(o.curvature[i], std::cos(yaw) * std::cos(yaw) / radius, 1e-12);
  }
}

/// A crowned wheel over a plane: depth, normal and curvature of the strip at y from the wheel's middle.
struct Crowned {
  double depth, ny, nz, curvature;

  Crowned(double crown, double deep, double y) {
    const double alpha = -std::asin(y / crown), half = std::cos(0.5 * alpha);
    const double fall = crown - std::sqrt(crown * crown - y * y);
    depth = (deep - fall) * std::cos(alpha) / (half * half);
    ny = -std::sin(0.5 * alpha);
    nz = half;
    curvature = std::cos(alpha) / (radius - fall) / half;
  }
};

TEST(Overlap, ACrownedWheelFollowsItsClosedForm) {
  constexpr double crown = 0.1, deep = 0.2e-3, aside = 1.17e-3;
  Bodies bodies(crown);
  const RailStrips& rail = bodies.surfaces.rail;
  for (const double margin : {0.0, 50e-6}) {
    const Overlaps o = bodies.find(pose_of(aside, deep), margin);
    std::int32_t i = 0;
    for (std::int32_t j = 0; j < rail.count; ++j) {
      const double y = rail.y[j] - aside;
      if (std::abs(y) > 20e-3) continue;
      const Crowned exact(crown, deep, y);
      if (!(exact.depth > -margin)) continue;
      ASSERT_LT(i, o.count);
      ASSERT_EQ(o.strip[i], j);
      EXPECT_NEAR(o.depth[i], exact.depth, 1e-12);
      EXPECT_NEAR(o.ny[i], exact.ny, 1e-8);
      EXPECT_NEAR(o.nz[i], exact.nz, 1e-9);
      EXPECT_NEAR(o.curvature[i], exact.curvature, 1e-6);
      ++i;
    }
    EXPECT_EQ(o.count, i);
  }
}

TEST(Overlap, AWheelThatIsLiftedHasNone) {
  Bodies bodies(0.1);
  EXPECT_EQ(bodies.find(pose_of(0.0, -1e-6)).count, 0);
  EXPECT_GT(bodies.find(pose_of(0.0, -1e-6), 2e-6).count, 0);
  EXPECT_EQ(bodies.find(pose_of(0.0, -1.0)).count, 0);
}

// A mirror image in x-z: the strips of the rail are not symmetric, so two poses are compared strip by strip
// at the same distance from the middle only through the closed form's evenness.
TEST(Overlap, YawsToBothSidesAreMirrorImages) {
  constexpr double crown = 0.1, head = 0.3, deep = 0.15e-3;
  Bodies left(crown, head), right(crown, head);
  const Overlaps a = left.find(pose_of(0.0, deep, 0.03)), b = right.find(pose_of(0.0, deep, -0.03));
  ASSERT_EQ(a.count, b.count);
  for (std::int32_t i = 0; i < a.count; ++i) {
    ASSERT_EQ(a.strip[i], b.strip[i]);
    EXPECT_NEAR(a.depth[i], b.depth[i], 1e-15);
    EXPECT_NEAR(a.centre[i], -b.centre[i], 1e-14);
    EXPECT_NEAR(a.curvature[i], b.curvature[i], 1e-12);
  }
}

// As the wheel is lowered by small steps strips enter at zero, and each then deepens by no more than the
// step.
TEST(Overlap, StripsEnterAtZero) {
  Bodies bodies(0.1, 0.3);
  constexpr double step = 1e-6;
  std::vector<double> before(256, 0.0);
  std::int32_t most = 0;
  for (int n = 0; n < 200; ++n) {
    const Overlaps o = bodies.find(pose_of(2.3e-3, -10e-6 + step * n, 0.02));
    std::vector<double> now(256, 0.0);
    for (std::int32_t i = 0; i < o.count; ++i) now[static_cast<std::size_t>(o.strip[i])] = o.depth[i];
    for (std::size_t j = 0; j < now.size(); ++j) {
      EXPECT_LE(now[j] - before[j], step * 1.001) << n << " " << j;
      EXPECT_GE(now[j], before[j]) << n << " " << j;
    }
    most = std::max(most, o.count);
    before = now;
  }
  EXPECT_GT(most, 15);
}

TEST(Overlap, MoreStripsThanRoomAreNoticed) {
  Bodies bodies(0.0, 0.0, 5);
  const Overlaps o = bodies.find(pose_of(0.0, 0.1e-3));
  EXPECT_TRUE(o.full);
  EXPECT_EQ(o.count, 5);
}

TEST(Overlap, AllInstructionSetsGiveTheSameBits) {
  Bodies bodies(0.08, 0.3);
  std::vector<double> expected;
  for (InstructionSet set : {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512}) {
    if (set > best_instruction_set()) continue;
    bodies.surfaces.kernels = &kernels_for(set);
    const Overlaps o = bodies.find(pose_of(1e-3, 0.2e-3, 0.01, 0.02));
    std::vector<double> found;
    for (const double* a : {o.depth, o.centre, o.curvature, o.ny, o.nz, o.wy, o.wz, o.u})
      found.insert(found.end(), a, a + o.count);
    if (expected.empty()) expected = found;
    ASSERT_EQ(expected.size(), found.size());
    ASSERT_EQ(std::memcmp(expected.data(), found.data(), found.size() * sizeof(double)), 0);
  }
}

// The derivatives of a strip's overlap against differences of find_overlaps().
TEST(Overlap, DerivativesAreThoseOfTheSearch) {
  Bodies here(0.08, 0.3), ahead(0.08, 0.3), back(0.08, 0.3);
  const RelativePose pose = pose_of(1e-3, 0.2e-3, 0.02, 0.01);
  const RailStrips& rail = here.surfaces.rail;
  const Overlaps o = here.find(pose);
  ASSERT_GT(o.count, 10);
  const RelativePoseOf<PlaceDual> moving = moving_pose(pose);
  const auto attitude = attitude_of(moving);
  const auto moved = [&](int input, double by) {
    RelativePose p = pose;
    if (input == place_y) p.y += by;
    if (input == place_z) p.z += by;
    const double c = std::cos(by), s = std::sin(by);
    for (int k = 0; k < 3; ++k) {
      const double(&R)[3][3] = pose.rotation;
      if (input == turn_x) {
        p.rotation[1][k] = c * R[1][k] - s * R[2][k];
        p.rotation[2][k] = s * R[1][k] + c * R[2][k];
      }
      if (input == turn_z) {
        p.rotation[0][k] = c * R[0][k] - s * R[1][k];
        p.rotation[1][k] = s * R[0][k] + c * R[1][k];
      }
    }
    return p;
  };
  for (int input = 0; input < place_inputs; ++input) {
    constexpr double by = 1e-7, margin = 1e-5;
    const Overlaps a = ahead.find(moved(input, by), margin), b = back.find(moved(input, -by), margin);
    for (std::int32_t i = 0; i < o.count; ++i) {
      const std::int32_t j = o.strip[i];
      OverlapSlopes s;
      here.surfaces.kernels->surface.overlap_slopes(
          {rail.y[j], rail.z[j], rail.ty[j], rail.tz[j], &here.surfaces.wheel.curve, &moving, &attitude,
           o.piece[i], o.u[i]},
          s);
      const auto at = [j](const Overlaps& of) {
        return std::find(of.strip, of.strip + of.count, j) - of.strip;
      };
      ASSERT_LT(at(a), a.count);
      ASSERT_LT(at(b), b.count);
      const auto expect = [&](const PlaceDual& x, double* Overlaps::*list, double scale) {
        EXPECT_NEAR(x.value, (o.*list)[i], 1e-12 * scale);
        const double difference = ((a.*list)[at(a)] - (b.*list)[at(b)]) / (2.0 * by);
        EXPECT_NEAR(x.d[static_cast<std::size_t>(input)], difference, 1e-6 * (std::abs(difference) + scale))
            << input << " strip " << j;
      };
      expect(s.depth, &Overlaps::depth, 1.0);
      expect(s.centre, &Overlaps::centre, 1.0);
      expect(s.ny, &Overlaps::ny, 1.0);
      expect(s.nz, &Overlaps::nz, 1.0);
      expect(s.wy, &Overlaps::wy, 1.0);
      expect(s.wz, &Overlaps::wz, 1.0);
      expect(s.curvature, &Overlaps::curvature, 10.0);
    }
  }
}

// Two circles of radii r and R: axles X apart along the track, the overlap along their line of centres.
TEST(SurfaceGeometry, AWheelOnARollerOverlapsAsTwoCircles) {
  Bodies bodies;
  constexpr double roller = 0.3, deep = 0.1e-3;
  bodies.surfaces.roller_curvature = 1.0 / roller;
  for (const double distance : {-5e-3, 0.0, 2e-3, 5e-3}) {
    const Overlaps o = bodies.overlap(pose_of(0.0, deep), distance, 0.0);
    ASSERT_GT(o.count, 140);
    const double exact = radius + roller - std::hypot(distance, radius + roller - deep);
    for (std::int32_t i = 0; i < o.count; ++i) {
      EXPECT_NEAR(o.depth[i], exact, 1e-8);
      EXPECT_NEAR(o.curvature[i], 1.0 / radius + 1.0 / roller, 1e-11);
      EXPECT_NEAR(o.centre[i], -distance * radius / (radius + roller), 1e-12);
      EXPECT_NEAR(o.grade[i], distance / (radius + roller), 1e-12);
    }
  }
}

// A wheel that is larger by the same all round is as much deeper.
TEST(SurfaceGeometry, AWheelThatIsLargerAllRoundIsDeeper) {
  Bodies bodies(0.1);
  constexpr double deep = 0.1e-3, larger = 30e-6;
  std::vector<double> angle, deviation;
  for (int i = 0; i <= 36; ++i) {
    angle.push_back(2.0 * pi * i / 36);
    deviation.push_back(larger);
  }
  const RadiusTable table{37, 1, angle.data(), nullptr, deviation.data()};
  std::vector<double> memory;
  bodies.surfaces.out_of_round = make_out_of_round(
      table, radius, cut_into(memory, [&](Arena& arena) { return cut_out_of_round(arena, table); }));
  Bodies round(0.1);
  const Overlaps a = bodies.overlap(pose_of(0.0, deep), 0.0, 1.3), b = round.find(pose_of(0.0, deep));
  ASSERT_GT(a.count, b.count);
  for (std::int32_t i = 0; i < b.count; ++i) {
    const std::int32_t* const at = std::find(a.strip, a.strip + a.count, b.strip[i]);
    ASSERT_NE(at, a.strip + a.count);
    const auto k = at - a.strip;
    EXPECT_NEAR(a.depth[k] - b.depth[i], larger * std::cos(std::asin(b.ny[i])), 2e-3 * larger);
    EXPECT_NEAR(a.wz[k] - b.wz[i], larger, 0.01 * larger);
    EXPECT_NEAR(a.curvature[k], b.curvature[i], 1e-6);
  }
}

// Asking for others in other memory leaves overlaps and the ends of their rays as they are.
TEST(SurfaceGeometry, OverlapsOutliveAnotherSearch) {
  Bodies bodies(0.1);
  const Overlaps first = bodies.find(pose_of(0.0, 0.1e-3));
  const std::vector<double> u(first.u, first.u + first.count);
  const std::vector<std::int32_t> piece(first.piece, first.piece + first.count);
  std::vector<double> other;
  bodies.memory = cut_into(other, [](Arena& arena) { return cut_overlaps(arena, 256, false); });
  EXPECT_GT(bodies.find(pose_of(3e-3, 0.3e-3)).count, first.count);
  EXPECT_TRUE(std::equal(u.begin(), u.end(), first.u));
  EXPECT_TRUE(std::equal(piece.begin(), piece.end(), first.piece));
}

}  // namespace
}  // namespace wrc::surface
