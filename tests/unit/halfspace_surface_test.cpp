#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "halfspace/surface_cells.hpp"
#include "halfspace/surface_contact.hpp"
#include "unit/halfspace_closed_forms.hpp"

namespace wrc::halfspace {
namespace {

constexpr patch::Material steel{.shear_modulus = 82e9, .poisson = 0.28};
constexpr double degree = pi / 180.0;

// An arc of radius R about (0, R), its top at the origin, from angle `from` to `to` about x.
SectionCurve arc(double radius, double from, double to) {
  std::vector<double> y, z;
  constexpr int points = 400;
  for (int k = 0; k <= points; ++k) {
    const double a = from + (to - from) * k / points;
    y.push_back(radius * std::sin(a));
    z.push_back(radius * (1.0 - std::cos(a)));
  }
  return {y, z};
}

// A straight profile through the origin, at an angle about x.
SectionCurve line(double angle) {
  std::vector<double> y, z;
  for (int k = -20; k <= 20; ++k) {
    y.push_back(1e-3 * k * std::cos(angle));
    z.push_back(1e-3 * k * std::sin(angle));
  }
  return {y, z};
}

// A cone, flat in its section, on a round rail, touching where the rail has the cone's angle.
struct ConeOnArc {
  double angle = 0.0, radius = 13e-3, wheel_radius = 0.46, overlap = 60e-6;
  WheelAndRail bodies() const {
    return {.wheel = line(angle),
            .rail = {{.section = arc(radius, angle - 8e-3 / radius, angle + 8e-3 / radius)}},
            .nominal_radius = wheel_radius,
            .material = steel};
  }
  surface::WheelOnRail state(double friction) const {
    surface::WheelOnRail s;
    s.friction = friction;
    s.wheel.velocity[0] = 20.0;
    // The cone's line lies below the rail's point of equal angle by the overlap, along the normal.
    const double y = radius * std::sin(angle), z = radius * (1.0 - std::cos(angle));
    s.wheel.position[1] = y - overlap * std::sin(angle);
    s.wheel.position[2] = z + overlap * std::cos(angle) - wheel_radius;
    s.wheel.angular_velocity[1] = -20.0 / wheel_radius;
    return s;
  }
};

TEST(HalfspaceTurnedConvolution, IsThePlainDoubleSum) {
  const Grid grid{.nx = 5, .ny = 4, .dx = 2e-4, .dy = 3e-4, .x0 = 0.0, .y0 = 0.0};
  const Field angles{-0.9, -0.4, 0.1, 0.7};
  Field x(grid.cells()), y(grid.cells()), out(grid.cells()), crossed(grid.cells());
  for (std::size_t k = 0; k < grid.cells(); ++k) {
    x[k] = std::sin(1.0 + 3.0 * static_cast<double>(k));
    y[k] = std::cos(2.0 + 5.0 * static_cast<double>(k));
  }
  TurnedConvolution normal(grid, steel, Convolution::Kernel::normal, angles);
  TurnedConvolution tangential(grid, steel, Convolution::Kernel::tangential, angles);
  Field tangential_x = x, tangential_y = y, tangential_crossed(grid.cells());
  normal.normal(x, out);
  normal.normal_crossed(x, crossed);
  tangential.tangential(tangential_x, tangential_y);
  tangential.tangential_crossed(x, y, tangential_crossed);
  for (int j = 0; j < grid.ny; ++j) {
    for (int i = 0; i < grid.nx; ++i) {
      double sums[5] = {};
      for (int l = 0; l < grid.ny; ++l) {
        for (int k = 0; k < grid.nx; ++k) {
          const std::size_t from = grid.index(k, l);
          const double turn = angles[j] - angles[l];
          const double zz = normal.planar().xx(i - k, j - l) * x[from];
          const Convolution& c = tangential.planar();
          const double to_y = c.xy(i - k, j - l) * x[from] + c.yy(i - k, j - l) * y[from];
          sums[0] += std::cos(turn) * zz;
          sums[1] += std::sin(turn) * zz;
          sums[2] += c.xx(i - k, j - l) * x[from] + c.xy(i - k, j - l) * y[from];
          sums[3] += std::cos(turn) * to_y;
          sums[4] += std::sin(turn) * to_y;
        }
      }
      const std::size_t at = grid.index(i, j);
      const double scale = normal.planar().xx(0, 0), slip_scale = tangential.planar().xx(0, 0);
      EXPECT_NEAR(out[at], sums[0], 1e-13 * scale);
      EXPECT_NEAR(crossed[at], sums[1], 1e-13 * scale);
      EXPECT_NEAR(tangential_x[at], sums[2], 1e-13 * slip_scale);
      EXPECT_NEAR(tangential_y[at], sums[3], 1e-13 * slip_scale);
      EXPECT_NEAR(tangential_crossed[at], sums[4], 1e-13 * slip_scale);
    }
  }
}

// Cells stand on a lattice of the rail, cover every overlap and go on beyond it; the deepest is the cone's.
TEST(HalfspaceSurface, CellsCoverTheOverlapOnALatticeOfTheRail) {
  const ConeOnArc contact{.angle = 10.0 * degree};
  const WheelAndRail bodies = contact.bodies();
  const surface::WheelOnRail state = contact.state(0.0);
  const RollingSurfaces surfaces(bodies, bodies.rail[0], state);
  SurfaceOptions options;
  const double length = bodies.rail[0].section.length();
  const SurfaceCells cells = lay_cells(surfaces, length, options);
  const Grid& g = cells.grid;
  ASSERT_FALSE(cells.too_many);
  ASSERT_EQ(cells.points.size(), g.cells());
  // less by half a cell beside the deepest point, s^2 / (2 R), at most
  EXPECT_LT(cells.deepest, contact.overlap + 1e-9);
  EXPECT_GT(cells.deepest, contact.overlap - options.cell_s * options.cell_s / (8.0 * contact.radius) - 1e-9);
  EXPECT_NEAR(g.x0 / g.dx, nearest_integer(g.x0 / g.dx), 1e-9);
  EXPECT_NEAR(g.y0 / g.dy - 0.5, nearest_integer(g.y0 / g.dy - 0.5), 1e-9);
  int overlapping = 0;
  for (int j = 0; j < g.ny; ++j) {
    for (int i = 0; i < g.nx; ++i) {
      const SurfacePoint& p = cells.points[g.index(i, j)];
      if (!p.found || p.gap > 0.0) continue;
      ++overlapping;
      EXPECT_TRUE(i >= 2 && i < g.nx - 2 && j >= 2 && j < g.ny - 2) << i << ' ' << j;
    }
  }
  EXPECT_GT(overlapping, 100);
  options.max_cells = g.cells() / 2;
  EXPECT_TRUE(lay_cells(surfaces, length, options).too_many);
}

// The height found for a load carries it when it is given, with friction and without.
TEST(HalfspaceSurface, HeightOfALoadCarriesThatLoad) {
  const ConeOnArc contact{.angle = 5.0 * degree};
  SurfaceOptions options;
  options.cell_x = options.cell_s = 4e-4;
  const SurfaceContact solver(contact.bodies(), options);
  for (const double friction : {0.0, 0.3}) {
    surface::WheelOnRail state = contact.state(friction);
    state.load_prescribed = true;
    state.vertical_load = 50e3;
    const SurfaceSolution by_load = solver.solve({.state = state});
    ASSERT_EQ(by_load.fault.status, WRC_OK);
    EXPECT_NEAR(-by_load.force[2] / 50e3, 1.0, options.load_tolerance);
    EXPECT_LT(by_load.heights, 8);
    state.load_prescribed = false;
    state.wheel.position[2] = by_load.height;
    const SurfaceSolution by_height = solver.solve({.state = state});
    ASSERT_EQ(by_height.fault.status, WRC_OK);
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(by_height.force[k], by_load.force[k], 2.0 * options.load_tolerance * 50e3) << k;
  }
}

// Narrow beside the radii, the contact is Hertz's, and force and direction are known.
TEST(HalfspaceSurface, ShallowContactIsHertz) {
  const double a = 3e-3, b = 4e-3, p0 = 0.6e9;
  const closed_forms::Hertz exact = closed_forms::hertz(steel, a, b, p0);
  const ConeOnArc contact{
      .radius = 1.0 / exact.curvature_y, .wheel_radius = 1.0 / exact.curvature_x, .overlap = exact.approach};
  const SurfaceSolution s = SurfaceContact(contact.bodies()).solve({.state = contact.state(0.0)});
  ASSERT_EQ(s.fault.status, WRC_OK);
  EXPECT_NEAR(-s.force[2] / exact.load, 1.0, 2e-3);
  EXPECT_NEAR(s.peak_pressure / p0, 1.0, 2e-3);
  EXPECT_NEAR(s.force[1] / exact.load, 0.0, 1e-6);
}

// Of unlike bodies: tractions as on a plane under the same pressure; whichever body is the stiffer, contact
// that sticks carries more than without coupling.
TEST(HalfspaceSurface, UnlikeBodiesCoupleAsOnAPlane) {
  const ConeOnArc contact{.radius = 0.3};
  WheelAndRail bodies = contact.bodies();
  const surface::WheelOnRail state = contact.state(1.0);
  SurfaceOptions options;
  options.cell_x = options.cell_s = 4e-4;
  const SurfaceSolution alike = SurfaceContact(bodies, options).solve({.state = state});
  for (const double coupling : {0.3, -0.3}) {
    bodies.coupling = coupling;
    const SurfaceSolution s = SurfaceContact(bodies, options).solve({.state = state});
    ASSERT_EQ(s.fault.status, WRC_OK);
    RollingProblem plane;
    plane.pressure = s.pressure;
    plane.friction = {1.0};
    const RollingSolution rolled = RollingSolver(s.grid, steel, {}, coupling).solve(plane);
    const double fx = s.force[0] - alike.force[0];
    EXPECT_LT(fx * coupling, 0.0);
    EXPECT_NEAR(fx, rolled.forces.fx, 0.05 * std::abs(fx));
    EXPECT_GT(s.pressure_sum, 1.001 * alike.pressure_sum);
  }
}

// Everything but the cone's growing radius is symmetric about the touching point: the force is normal there,
// however wide the contact, and the pressure's middle lies on it.
TEST(HalfspaceSurface, ForceOnASteepConeIsNormalToIt) {
  for (const double angle : {-70.0 * degree, -30.0 * degree}) {
    for (const RowNormals normals : {RowNormals::mean, RowNormals::rail}) {
      const ConeOnArc contact{.angle = angle};
      SurfaceOptions options;
      options.normals = normals;
      const SurfaceSolution s =
          SurfaceContact(contact.bodies(), options).solve({.state = contact.state(0.0)});
      ASSERT_EQ(s.fault.status, WRC_OK);
      EXPECT_NEAR(std::atan2(s.force[1], -s.force[2]) / degree, angle / degree, 0.02);
    }
  }
}

}  // namespace
}  // namespace wrc::halfspace
