/// Contact of a wheel with a rail on the rail's curved surface, cell by cell: the exact solution that the
/// real-time strips are measured against. Not real-time: allocates.
///
/// Half-space coefficients over arc length with turned normals (turned_convolution.hpp). The normal problem
/// p >= 0, e >= 0, p e = 0 is solved over the gaps along the rows' normals (normal.hpp), steady rolling with
/// Coulomb's law over the sliding velocity of every cell's own surface points (tangential.hpp). Each acts on
/// the other through the turned normals: both are solved in turn until the force rests (Panagiotopoulos).
///
///     const SurfaceContact contact(bodies, options);
///     const SurfaceSolution s = contact.solve({.state = state});      // height or load given in `state`
///     s.force, s.moment, s.height, s.power                            // force and moment on the wheel
///     for (const RowForces& row : s.row_forces) ...                   // the same per row of cells
///
/// Pressures alone: state.friction = 0.
///
///     h  gap                     [m]      p_n  pressure                [Pa]
///     p  traction_x, traction_y  [Pa]     w    sliding velocity / V    [-]
///     s  arc length of the rail  [m]      a    SurfaceRow::angle       [rad]
///
/// V, by which sliding velocities become slips, is the mean of the speeds at which both materials pass
/// through the contact, over its pressure. Rolling backwards is forwards seen in a mirror across the axle,
/// and below a small V the tractions are those of both ways by shares (geometry/creepages.hpp), as in real
/// time. So is damping: it multiplies the pressures of a row, by the speed at which the surfaces near each
/// other at their middle, before rolling sees them. So is the friction law: a coefficient for every
/// row, by its place on the rail and the root mean square of its rigid sliding velocity
/// (tangential/friction/friction.hpp).
#pragma once

#include <vector>

#include "base/fault.hpp"
#include "halfspace/normal.hpp"
#include "halfspace/rolling_surfaces.hpp"
#include "halfspace/tangential.hpp"
#include "surface/wrench/wheel_on_rail.hpp"

namespace wrc::halfspace {

struct SurfaceOptions {
  double cell_x = 2e-4, cell_s = 2e-4;  ///< size of the cells along the rail and along its arc [m]
  RowNormals normals = RowNormals::mean;
  /// Coefficients with turned normals; otherwise those of a plane over arc length, and only gaps, slips and
  /// the directions of forces follow the curvature (the reference program's plain conformal setting).
  bool turned = true;
  Collocation collocation = Collocation::quarter_point;
  double normal_tolerance = 1e-6;   ///< GapProblem's
  double rolling_tolerance = 1e-4;  ///< RollingProblem's
  double force_tolerance = 1e-5;    ///< change of the force vector / force at which the turns end
  double load_tolerance = 1e-4;     ///< relative error of a prescribed load, above the noise of rolling
  int max_turns = 30;               ///< normal and tangential problem in turn, at one height
  int max_heights = 40;             ///< tried for a prescribed load
  std::size_t max_cells = 1000000;
};

struct SurfaceProblem {
  surface::WheelOnRail state;
  ProgressCallback progress = {};  ///< while heights are tried and both problems solved in turn
};

/// One row of cells: forces on the wheel per arc length, in the row's own frame.
struct RowForces {
  double s = 0.0;              ///< arc length of the rail from its first point [m]
  int face = 0;                ///< index of the rail's face
  double y = 0.0, z = 0.0;     ///< place on the rail's surface, track axes [m]
  double angle = 0.0;          ///< angle of the normal (0, -sin, cos) about x [rad]
  double normal_force = 0.0;   ///< integral of the pressure over x [N/m]
  double fx = 0.0, fy = 0.0;   ///< tractions on the wheel along x and (0, cos, sin) [N/m]
  double length = 0.0;         ///< length of the cells in contact [m]
  double peak_pressure = 0.0;  ///< [Pa]
  double power = 0.0;          ///< frictional power: of the rigid slips, the exact total [W/m]
};

struct SurfaceSolution {
  double force[3] = {};       ///< on the wheel, track axes [N]
  double moment[3] = {};      ///< about the wheel's reference point, track axes [N m]
  double height = 0.0;        ///< position[2] of the wheel, as given or as found [m]
  double pressure_sum = 0.0;  ///< integral of the pressure [N]
  double area = 0.0, peak_pressure = 0.0;
  double power = 0.0;  ///< -sum of traction * rigid slip * V: the exact dissipation of steady rolling [W]
  double adhesion_fraction = 0.0;
  Grid grid;  ///< x from the wheel's reference point; y: arc length s of the rail from its first point
  std::vector<SurfaceRow> rows;
  Field gap, pressure, traction_x, traction_y;  ///< over the grid
  std::vector<RowForces> row_forces;            ///< one per row in contact
  /// A rail's several faces, each with its own cells, which the numbers above are the sums of.
  std::vector<SurfaceSolution> faces;
  int turns = 0, heights = 0;
  Fault fault;  ///< flags of both solvers; WRC_FLAG_ITERATION_CAP where turns or heights did not suffice
};

class SurfaceContact {
 public:
  SurfaceContact(WheelAndRail bodies, const SurfaceOptions& options = {});

  SurfaceSolution solve(const SurfaceProblem& problem) const;

  const WheelAndRail& bodies() const { return bodies_; }

 private:
  SurfaceSolution at_height(const surface::WheelOnRail& state, double height, bool with_friction,
                            const SurfaceSolution* start, const ProgressCallback& progress) const;
  /// At the height that carries the load given.
  SurfaceSolution at_load(const SurfaceProblem& problem) const;
  /// Height of first touch on faces that carry [m].
  double first_touch(const surface::WheelOnRail& state) const;

  WheelAndRail bodies_;
  SurfaceOptions options_;
};

}  // namespace wrc::halfspace
