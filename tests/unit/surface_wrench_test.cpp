/// From strips to the wrench: kinematics and statics of a strip, sums by region, heights of touch and of a
/// load.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "base/elementary.hpp"
#include "base/instruction_set.hpp"
#include "base/number.hpp"
#include "surface/wrench/first_touch.hpp"
#include "surface/wrench/regions.hpp"
#include "surface/wrench/strip_mechanics.hpp"
#include "surface/wrench/wheel_on_rail.hpp"

namespace wrc::surface {
namespace {

using Vector = std::array<double, 3>;

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector of(const double (&a)[3]) { return {a[0], a[1], a[2]}; }

constexpr double wheel_radius = 0.46, crown_radius = 0.46;

/// A cylindrical wheel on a rail whose head is a circular cylinder as curved: about where they touch, a
/// sphere of that radius on a plane.
class CylinderOnCrown {
 public:
  CylinderOnCrown() {
    constexpr int nodes = 81;
    for (int i = 0; i < nodes; ++i) {
      const double y = 1e-3 * (i - nodes / 2);
      y_.push_back(y);
      wheel_z_.push_back(0.0);
      rail_z_.push_back(crown_radius - std::sqrt(crown_radius * crown_radius - y * y));
    }
    grid_ = tangential::make_march_grid(cells, march_.data(), kernels());
    static const auto influence = [] {
      auto made = std::make_unique<normal::InfluenceTables>();
      normal::tabulate(*made);
      return made;
    }();
    SurfaceBodies bodies;
    bodies.wheel = {nodes, y_.data(), wheel_z_.data()};
    bodies.rail = {nodes, y_.data(), rail_z_.data()};
    bodies.nominal_radius = wheel_radius;
    bodies.material = material;
    bodies.influence = influence.get();
    bodies.kernels = &kernels();
    bodies.ellipse = &ellipse_;
    bodies.grid = &grid_;
    model_memory_.resize(surface_model_bytes(nodes, nodes, 0, 0, 1, {}) / sizeof(double) + 1);
    EXPECT_FALSE(make_surface_model(bodies, model_memory_.data(), model).failed());
    workspace.resize(static_cast<std::size_t>(surface_workspace_bytes(*model)) / sizeof(double));
    Arena counted;
    cut_surface_state(counted, model->most_overlapping, 0);
    state_.resize(static_cast<std::size_t>(counted.doubles()));
    Arena arena(state_.data());
    state = cut_surface_state(arena, model->most_overlapping, 0);
    in.friction = 0.0;
    in.wheel.position[2] = -wheel_radius;
  }

  Fault solve(SolutionStart from = SolutionStart::anew) {
    return solve_wheel_on_rail(*model, in, from, state, workspace.data(), wrench);
  }
  WheelProblem problem() const {
    WheelProblem problem{*model, in, {}};
    EXPECT_EQ(place_rail(*model, 0.0, {}, problem.rail).status, WRC_OK);
    return problem;
  }

  static constexpr patch::Material material{82e9, 0.28};
  const SurfaceModel* model = nullptr;
  WheelOnRail in;
  Wrench wrench;
  SurfaceState state;
  std::vector<double> workspace;

 private:
  static constexpr std::int32_t cells = 8;
  static const Kernels& kernels() { return kernels_for(best_instruction_set()); }

  std::vector<double> y_, wheel_z_, rail_z_, march_ = std::vector<double>(tangential::march_grid_size(cells)),
                                             model_memory_, state_;
  theory::KalkerTable ellipse_{material.poisson};
  tangential::MarchGrid grid_;
};

/// Strips of a strip's middle off the crown's top by half a width at most: the gap there [m].
constexpr double strip_gap = 0.25e-3 * 0.25e-3 / (2.0 * crown_radius) * 1.01;

TEST(FirstTouch, OfACylinderOnACrownIsWhereTheRadiiMeet) {
  CylinderOnCrown pair;
  for (const double guess : {-3e-3, -0.2e-3, 0.0, 0.05e-3, 1.5e-3}) {
    pair.in.wheel.position[2] = -wheel_radius + guess;
    EXPECT_NEAR(first_touch(pair.problem(), Arena(pair.workspace.data())), -wheel_radius, strip_gap) << guess;
  }
}

TEST(FirstTouch, ClearanceIsTheGapThatWasMade) {
  CylinderOnCrown pair;
  for (const double gap : {1e-6, 1e-4, 1e-3, 20e-3}) {
    pair.in.wheel.position[2] = -wheel_radius - gap;
    EXPECT_NEAR(clearance(pair.problem(), Arena(pair.workspace.data())), gap, strip_gap);
    EXPECT_EQ(pair.solve().status, WRC_FLAG_NO_CONTACT);
    EXPECT_NEAR(pair.wrench.clearance, gap, strip_gap);
  }
  pair.in.wheel.position[2] = -wheel_radius - 2.0 * farthest_touch;
  EXPECT_EQ(clearance(pair.problem(), Arena(pair.workspace.data())), farthest_touch);
  pair.in.wheel.position[2] = -wheel_radius + 1e-5;
  EXPECT_EQ(clearance(pair.problem(), Arena(pair.workspace.data())), 0.0);
}

// Hertz, sphere on plane: a^3 = 3 F R / (4 E'), approach a^2 / R, peak pressure 3 F / (2 pi a^2), E' = G / (1
// - nu).
TEST(GivenLoad, IsCarriedAtTheApproachOfHertz) {
  CylinderOnCrown pair;
  const double stiff = pair.material.shear_modulus / (1.0 - pair.material.poisson);
  pair.in.load_prescribed = true;
  for (const double load : {2e4, 6e4, 1.2e5}) {
    pair.in.vertical_load = load;
    ASSERT_EQ(pair.solve().status, WRC_OK);
    const double a = std::cbrt(0.75 * load * wheel_radius / stiff);
    EXPECT_NEAR(pair.wrench.height + wheel_radius, a * a / wheel_radius, 0.01 * a * a / wheel_radius);
    EXPECT_NEAR(pair.wrench.peak_pressure, 1.5 * load / (pi * a * a), 0.02 * load / (a * a));
    EXPECT_NEAR(-pair.wrench.force[2], load, 1e-8 * load);
    EXPECT_NEAR(pair.wrench.force[0], 0.0, 1e-12 * load);
    EXPECT_NEAR(pair.wrench.force[1], 0.0, 1e-4 * load);  // the strips do not lie symmetrically
    EXPECT_EQ(pair.wrench.regions, 1);
  }
}

TEST(GivenLoad, OfTheHeightFoundComesBack) {
  CylinderOnCrown pair;
  pair.in.vertical_load = 7e4;
  pair.in.wheel.rotation[1][1] = pair.in.wheel.rotation[2][2] = std::cos(0.01);
  pair.in.wheel.rotation[1][2] = -std::sin(0.01);
  pair.in.wheel.rotation[2][1] = std::sin(0.01);
  pair.in.load_prescribed = true;
  ASSERT_EQ(pair.solve().status, WRC_OK);
  const Wrench found = pair.wrench;
  EXPECT_EQ(pair.state.last.head->height, found.height);
  pair.in.load_prescribed = false;
  pair.in.wheel.position[2] = found.height;
  ASSERT_EQ(pair.solve(SolutionStart::last).status, WRC_OK);
  EXPECT_NEAR(pair.wrench.force[2], found.force[2], 1e-9 * 7e4);
  EXPECT_NEAR(-pair.wrench.force[2], 7e4, 1e-8 * 7e4);
  // wherever the search begins
  pair.in.load_prescribed = true;
  for (const double guess : {-2e-3, 1e-4}) {
    pair.in.wheel.position[2] = -wheel_radius + guess;
    ASSERT_EQ(pair.solve().status, WRC_OK);
    EXPECT_NEAR(pair.wrench.height, found.height, 1e-12);
  }
}

/// Numbers of a strip that none of the formulas knows.
StripOverlap<double> some_strip(double angle, double grade) {
  return {1e-4, 2e-3, 3.0, -std::sin(angle), std::cos(angle), -0.012, 0.44, grade};
}

RelativeVelocityOf<double> some_velocity() { return {{20.3, -0.11, 0.07}, {0.3, -43.0, 0.2}, 0.0, false}; }

// The power of the strip's forces, F.V + M.omega, is that in its own axes: f_x along + f_y across - N
// approach
// + m_z spin; so it is with a grade.
TEST(StripMechanics, PowerOfTheForcesIsThatInTheStripsOwnAxes) {
  const RelativeVelocityOf<double> v = some_velocity();
  const double x = 4e-3, N = 3e4, fx = 7e3, fy = -2e3, mz = 11.0;
  for (const double angle : {-0.9, 0.025, 1.2})
    for (const double grade : {0.0, 0.03}) {
      const StripOverlap<double> o = some_strip(angle, grade);
      const StripMotion<double> m = motion_at(v, o, x, grade != 0.0);
      double force[3] = {1.0, 2.0, 3.0}, moment[3] = {4.0, 5.0, 6.0};
      add_force(o, x, grade != 0.0, {N, fx, fy, mz}, force, moment);
      const double power = dot(of(force), of(v.linear)) + dot(of(moment), of(v.angular)) -
                           dot({1.0, 2.0, 3.0}, of(v.linear)) - dot({4.0, 5.0, 6.0}, of(v.angular));
      EXPECT_NEAR(power, fx * m.along + fy * m.across - N * m.approach + mz * m.spin, 1e-9 * std::abs(power));
      // and the force itself, as vectors
      const Vector n{0.0, o.ny, o.nz}, r{x, o.wy, o.wz}, t{0.0, o.nz, -o.ny};
      Vector F{}, M{};
      for (std::size_t c = 0; c < 3; ++c) F[c] = fy * t[c] + (fx * grade - N) * n[c];
      F[0] += fx + N * grade;
      const Vector rF = cross(r, F);
      for (std::size_t c = 0; c < 3; ++c) M[c] = rF[c] + mz * n[c];
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(force[c] - 1.0 - static_cast<double>(c), F[c], 1e-9 * N);
        EXPECT_NEAR(moment[c] - 4.0 - static_cast<double>(c), M[c], 1e-9 * N);
      }
    }
}

// A roller's surface moves with its turning: deeper in by d it is nearer to the axle, and slower by turning d
// n_z.
TEST(StripMechanics, ARollersOwnPointIsThatOfTheUndeformedBody) {
  RelativeVelocityOf<double> v = some_velocity();
  const StripOverlap<double> o = some_strip(0.4, 0.0);
  const double without = motion_at(v, o, 0.0, false).along;
  v.on_roller = true;
  v.roller = 12.0;
  EXPECT_NEAR(motion_at(v, o, 0.0, false).along - without, 12.0 * 1e-4 * std::cos(0.4), 1e-13);
}

TEST(RelativeMotion, OfAWheelThatMovesAsTheRailDoesIsNone) {
  const CylinderOnCrown pair;
  RailMotion rail;
  rail.y = 3e-3;
  rail.z = -2e-3;
  rail.roll = 0.2;
  rail.slope_y = 0.02;
  rail.slope_z = -0.03;
  rail.velocity_y = 0.3;
  rail.velocity_z = -0.2;
  rail.velocity_roll = 1.7;
  const double length = std::sqrt(1.0 + 0.02 * 0.02 + 0.03 * 0.03);
  const Vector d{1.0 / length, 0.02 / length, -0.03 / length};
  WheelMotion wheel;
  const Vector arm{0.05, 0.1, -0.47};
  const Vector omega{1.7 * d[0], 1.7 * d[1], 1.7 * d[2]}, turns = cross(omega, arm);
  const double origin[3] = {0.0, rail.y, rail.z}, velocity[3] = {0.0, 0.3, -0.2};
  for (std::size_t i = 0; i < 3; ++i) {
    wheel.position[i] = origin[i] + arm[i];
    wheel.velocity[i] = velocity[i] + turns[i];
    wheel.angular_velocity[i] = omega[i];
  }
  const RelativeMotion m = relative_motion(*pair.model, wheel, rail, 0.0);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(m.velocity.linear[i], 0.0, 1e-14);
    EXPECT_NEAR(m.velocity.angular[i], 0.0, 1e-14);
  }
  // rotations: the rail's x is its direction, and there and back is the same
  double x[3] = {d[0], d[1], d[2]}, there[3] = {0.3, -0.5, 0.7};
  into_rail(m, x);
  EXPECT_NEAR(x[0], 1.0, 1e-15);
  into_track(m, there);
  into_rail(m, there);
  EXPECT_NEAR(there[0], 0.3, 1e-15);
  EXPECT_NEAR(there[1], -0.5, 1e-15);
  EXPECT_NEAR(there[2], 0.7, 1e-15);
}

TEST(RelativeMotion, CarriesTheDerivativesOfItsDifferences) {
  const CylinderOnCrown pair;
  using Number = Dual<1>;
  constexpr double h = 1e-5;
  const auto at = [](auto roll) {
    using N = decltype(roll);
    RailMotionOf<N> rail;
    rail.y = N(3e-3);
    rail.roll = roll;
    rail.slope_y = N(0.1) * roll;
    rail.velocity_roll = N(1.7);
    return rail;
  };
  WheelMotion wheel;
  WheelMotionOf<Number> dual;
  const double p[3] = {0.05, 0.1, -0.47}, v[3] = {20.0, 0.3, 0.1}, w[3] = {0.1, -43.0, 0.2};
  for (int i = 0; i < 3; ++i) {
    dual.position[i] = wheel.position[i] = p[i];
    dual.velocity[i] = wheel.velocity[i] = v[i];
    dual.angular_velocity[i] = wheel.angular_velocity[i] = w[i];
  }
  const auto m = relative_motion(*pair.model, dual, at(Number::input(0.2, 0)), 0.0);
  const RelativeMotion more = relative_motion(*pair.model, wheel, at(0.2 + h), 0.0),
                       less = relative_motion(*pair.model, wheel, at(0.2 - h), 0.0);
  const auto expect = [&](const Number& n, double above, double below) {
    EXPECT_NEAR(n.d[0], (above - below) / (2.0 * h), 2e-8);
  };
  expect(m.pose.y, more.pose.y, less.pose.y);
  expect(m.pose.z, more.pose.z, less.pose.z);
  for (int i = 0; i < 3; ++i) {
    expect(m.velocity.linear[i], more.velocity.linear[i], less.velocity.linear[i]);
    expect(m.velocity.angular[i], more.velocity.angular[i], less.velocity.angular[i]);
    for (int k = 0; k < 3; ++k)
      expect(m.pose.rotation[i][k], more.pose.rotation[i][k], less.pose.rotation[i][k]);
  }
}

/// Strips in contact made by hand.
struct HandMadeStrips {
  static constexpr SurfaceMethods methods{};
  std::vector<double> memory;
  WheelSolution s;

  explicit HandMadeStrips(const std::vector<std::int32_t>& strips) {
    const WorkSizes sizes{8, 8, 192, true, methods};
    const auto cut = [&](Arena arena) {
      const ContactArrays results = cut_surface_state(arena, sizes.strips, 0).kept;
      s = cut_solution(arena, sizes, results);
      return arena.doubles();
    };
    memory.resize(static_cast<std::size_t>(cut(Arena())));
    cut(Arena(memory.data()));
    const CylinderOnCrown pair;
    RailMotion rail;
    rail.roll = 0.3;
    s.motion = relative_motion(*pair.model, WheelMotion{}, rail, 0.0);
    s.sums.speed = 20.0;
    ContactStrips& c = s.strips;
    for (const std::int32_t strip : strips) {
      const std::int32_t k = c.count++;
      const double u = 0.1 * k;
      s.overlaps.strip[k] = strip;
      s.overlaps.ny[k] = -std::sin(u);
      s.overlaps.nz[k] = std::cos(u);
      s.overlaps.wy[k] = -0.03 + 1e-3 * strip;
      s.overlaps.wz[k] = 0.46 + 1e-4 * strip;
      s.overlaps.grade[k] = 0.01 * u;
      s.overlaps.depth[k] = s.overlaps.centre[k] = s.overlaps.curvature[k] = 0.0;
      c.candidate[k] = k;
      c.x[k] = 1e-3 * (k - 1);
      c.width[k] = 5e-4;
      c.half_length[k] = 4e-3 + 1e-4 * k;
      c.solved_peak[k] = 8e8 - 1e7 * k;
      c.slip_x[k] = -2e-3;
      c.slip_y[k] = 1e-3 * u;
      c.spin[k] = 0.2;
      c.fx[k] = 300.0 + k;
      c.fy[k] = -150.0 * u;
      c.mz[k] = 0.01 * k;
      c.power[k] = 7.0 + k;
    }
  }

  double load(std::int32_t k) const {
    return 0.5 * pi * s.strips.width[k] * s.strips.half_length[k] * s.strips.solved_peak[k];
  }

  /// Force and moment of some strips, as vectors, track axes.
  void expect_equilibrium(std::int32_t first, std::int32_t count, const Vector& about, const Vector& force,
                          const Vector& moment) const {
    Vector F{}, M{};
    for (std::int32_t k = first; k < first + count; ++k) {
      const double N = load(k), g = s.overlaps.grade[k], ny = s.overlaps.ny[k], nz = s.overlaps.nz[k];
      const double fx = s.strips.fx[k], fy = s.strips.fy[k];
      const auto turned = [](double x, double y, double z) {
        return Vector{x, std::cos(0.3) * y - std::sin(0.3) * z, std::sin(0.3) * y + std::cos(0.3) * z};
      };
      const Vector f = turned(fx + N * g, fy * nz + (fx * g - N) * ny, -fy * ny + (fx * g - N) * nz);
      const Vector n = turned(0.0, ny, nz), r = turned(s.strips.x[k], s.overlaps.wy[k], s.overlaps.wz[k]);
      const Vector rf = cross({r[0] - about[0], r[1] - about[1], r[2] - about[2]}, f);
      for (std::size_t c = 0; c < 3; ++c) {
        F[c] += f[c];
        M[c] += rf[c] + s.strips.mz[k] * n[c];
      }
    }
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(force[c], F[c], 1e-9 * load(0));
      EXPECT_NEAR(moment[c], M[c], 1e-9 * load(0));
    }
  }
};

TEST(Regions, AreInEquilibriumWithTheirStrips) {
  const HandMadeStrips strips({5, 6, 7, 10, 11});
  WheelOnRail in;
  in.wheel.position[0] = 0.2;
  in.wheel.position[1] = 0.7;
  Wrench out;
  out.height = -0.45;
  EXPECT_EQ(sum_regions(in, strips.s, out).status, WRC_OK);
  strips.expect_equilibrium(0, 5, {0.0, 0.0, 0.0}, of(out.force), of(out.moment));
  ASSERT_EQ(out.regions, 2);
  const std::int32_t first[] = {0, 3}, count[] = {3, 2}, strip[] = {5, 10};
  double power = 0.0;
  for (int i = 0; i < 2; ++i) {
    const SurfaceRegion& r = out.region[i];
    EXPECT_EQ(r.first, strip[i]);
    EXPECT_EQ(r.count, count[i]);
    const Vector about{r.point[0] - 0.2, r.point[1] - 0.7, r.point[2] + 0.45};
    strips.expect_equilibrium(first[i], count[i], about, of(r.force), of(r.moment));
    EXPECT_NEAR(r.peak_pressure, 8e8 - 1e7 * first[i], 1.0);
    EXPECT_NEAR(r.creepage[0], -2e-3, 1e-17);
    power += r.power;
  }
  double area = 0.0, expected = 0.0;
  for (std::int32_t k = 0; k < 5; ++k) {
    const ContactStrips& c = strips.s.strips;
    area += 2.0 * c.half_length[k] * c.width[k];
    expected += c.power[k];
  }
  EXPECT_NEAR(out.area, area, 1e-18);
  EXPECT_NEAR(out.power, expected, 1e-9 * expected);
  EXPECT_NEAR(out.power, power, 1e-12 * power);
}

TEST(Regions, BeyondThoseThatAreListedGoToTheLast) {
  std::vector<std::int32_t> apart;
  for (std::int32_t k = 0; k < most_surface_regions + 2; ++k) apart.push_back(3 * k);
  const HandMadeStrips strips(apart);
  Wrench out;
  EXPECT_EQ(sum_regions({}, strips.s, out).status, WRC_FLAG_MORE_PATCHES);
  EXPECT_EQ(out.regions, most_surface_regions);
  EXPECT_EQ(out.region[most_surface_regions - 1].count, 7);  // from strip 45 to strip 51
  strips.expect_equilibrium(0, most_surface_regions + 2, {0.0, 0.0, 0.0}, of(out.force), of(out.moment));
  double sum = 0.0;
  for (std::int32_t i = 0; i < out.regions; ++i) sum += out.region[i].normal_force;
  EXPECT_NEAR(sum, out.normal_force, 1e-12 * sum);
}

}  // namespace
}  // namespace wrc::surface
