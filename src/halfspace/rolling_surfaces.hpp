/// The surfaces of a wheel and a rail, and the cells of an exact solution on the rail's.
///
/// Cells lie at equal steps of x along the rail and of s, the arc length of its cross section: a fixed
/// lattice, whatever the pose. Every row has one normal, the mean of the rail's and the wheel's (or the
/// rail's alone); along it each cell has its gap to the wheel, a surface of revolution in its pose.
/// Right-hand wheel and rail, track axes and types of surface/wrench/wheel_on_rail.hpp.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/elementary.hpp"
#include "base/vec3.hpp"
#include "halfspace/grid.hpp"
#include "halfspace/section_curve.hpp"
#include "halfspace/wheel_deviation.hpp"
#include "patch/material.hpp"
#include "surface/geometry/out_of_round.hpp"
#include "surface/geometry/rail_direction.hpp"
#include "surface/geometry/varying_rail.hpp"
#include "surface/wrench/wheel_on_rail.hpp"

namespace wrc::halfspace {

/// A face of the rail: its cross section below the wheel, and how it goes on along the track.
struct RailSurface {
  SectionCurve section;  ///< y to the field side, z down, from the origin of the profile
  const surface::VaryingRail* varying = nullptr;  ///< nullptr: the same everywhere
  std::int32_t first = 0;                 ///< first of its strips, through whose middles the section runs
  double distance = 0.0;                  ///< place of the wheel along the track [m]
  surface::FaceExtent extent{-1e9, 1e9};  ///< where it is there, from below the wheel [m]
};

struct WheelAndRail {
  SectionCurve wheel;  ///< y to the field side from the tape circle's plane, z outwards from its radius
  std::vector<RailSurface> rail;      ///< one, or faces that do not press on each other
  double nominal_radius = 0.0;        ///< radius of the tape circle [m]
  double rail_y = 0.0, rail_z = 0.0;  ///< place of the rail profile's origin in the track [m]
  patch::Material material;
  double coupling = 0.0;          ///< Kalker's K of unlike bodies [-]
  double roller_curvature = 0.0;  ///< 1 / radius of a roller at its profile's origin; 0: a rail [1/m]
  const surface::OutOfRound* out_of_round = nullptr;  ///< nullptr: the wheel is round
};

/// Direction of the normals of the rows.
enum class RowNormals { mean, rail };

/// A row of cells along the rail.
struct SurfaceRow {
  double y = 0.0, z = 0.0;  ///< place on the rail's surface, track axes [m]
  double angle = 0.0;       ///< angle of the normal (0, -sin, cos), into the rail [rad]
  double middle = 0.0;      ///< x where the wheel is nearest [m]
  double radius = 0.0;      ///< radius of a roller at this row; 0: the row is straight [m]
  double grade = 0.0;       ///< fall of the rail along the normal per x at the middle [-]
  std::int32_t strip = 0;   ///< first of four between which the row lies, on a rail that varies
  double weight[4] = {};    ///< weights of these four [-]
};

/// Where the rail's surface lies at some x of a row, from its place at x = 0, and the slope of that; track
/// axes.
struct RailFall {
  double y = 0.0, z = 0.0;              ///< [m]
  double slope_y = 0.0, slope_z = 0.0;  ///< by x [-]
};

/// A cell's gap, and the surfaces there.
struct SurfacePoint {
  double gap = 0.0;       ///< from the rail along -normal to the wheel; negative: overlap [m]
  double normal[3] = {};  ///< the wheel's normal, into the rail, track axes
  double wheel_s = 0.0;   ///< on the wheel's profile [m]
  RailFall fall;          ///< the rail's
  bool found = false;     ///< the normal meets the wheel's facing side near by
};

/// A wheel beside the axle of a roller, turned about that axle until it stands above it, and back.
class TurnedAboveAxle {
 public:
  /// Turns the wheel of `state`, with `distance` 0 after that, and gives it the rail's velocities to carry.
  /// Nothing at all without a roller.
  TurnedAboveAxle(const WheelAndRail& bodies, surface::WheelOnRail& state);
  /// From the turned axes to those of the track.
  void turn_back(double (&v)[3]) const;

 private:
  void turn(double sine, double (&v)[3]) const;
  double sine_ = 0.0, cosine_ = 1.0;    // sine and cosine of the turn
  double down_y_ = 0.0, down_z_ = 1.0;  // the rail's z axis
};

/// A wheel on a rail that runs aslant of the track (surface/geometry/rail_direction.hpp), seen in axes along
/// it, and back.
class SeenAlongRail {
 public:
  /// Turns the wheel of `state` about the displaced origin of the rail's profile, and leaves it no slopes.
  /// Nothing at all without them.
  SeenAlongRail(const WheelAndRail& bodies, surface::WheelOnRail& state);
  /// From axes along the rail to those of the track.
  void turn_back(double (&v)[3]) const;

 private:
  bool aslant_ = false;
  surface::RailDirection<double> direction_;
};

/// A wheel over one face of a rail, or above the axle of a roller. Axes: x from the wheel's reference point,
/// y and z of the track.
class RollingSurfaces {
 public:
  /// All three outlive it.
  RollingSurfaces(const WheelAndRail& bodies, const RailSurface& surface, const surface::WheelOnRail& state);

  /// Does the rail change along the track?
  bool varies() const { return surface_.varying != nullptr; }

  /// Is the face there at x?
  bool there(double x) const { return surface_.extent.holds(x); }

  /// Row at arc length s from the rail's first point; `found` tells whether the wheel faces it.
  SurfaceRow row(double s, RowNormals normals, bool& found) const;

  /// The row's cell at x; `wheel_s` is the start of the search on the wheel's profile.
  SurfacePoint point(const SurfaceRow& row, double x, double wheel_s) const;

  /// The same from the nearest of all points of the wheel's profile.
  SurfacePoint point(const SurfaceRow& row, double x) const;

  /// Velocity of the wheel's surface over the rail's at a cell, along x and along the row's tangent [m/s]:
  /// components in the plane across the mean of both surfaces' normals there.
  void sliding(const SurfaceRow& row, double x, const SurfacePoint& at, double& along_x,
               double& along_row) const;

  /// The same along that mean of both normals, positive while the surfaces near each other [m/s].
  double approach(const SurfaceRow& row, double x, const SurfacePoint& at) const;

 private:
  /// Velocity of the wheel's surface over the rail's at a cell [m/s], and the mean of both normals; track
  /// axes.
  struct Motion {
    Vec3<double> velocity, normal;
  };
  Motion motion(const SurfaceRow& row, double x, const SurfacePoint& at) const;
  RailFall fall(const SurfaceRow& row, double x) const;
  /// Angle of the rail's normal about x [rad].
  double rail_angle(const SurfaceRow& row, double s, double x) const;
  /// Growth of the gap by x [-].
  double gap_slope(const SurfaceRow& row, const SurfacePoint& at) const;
  /// Moves the row's middle to where the wheel is nearest; returns the point there.
  SurfacePoint nearest_place(SurfaceRow& row) const;
  /// Moves the row's middle, and `at` with it, to the bottom of the gap's valley in which it lies.
  void find_middle(SurfaceRow& row, SurfacePoint& at) const;
  /// The same where the gap's slope is smooth: by secants.
  void roll_to_middle(SurfaceRow& row, SurfacePoint& at) const;
  /// A place of the face near x.
  double on_face(double x) const { return std::clamp(x, surface_.extent.begin, surface_.extent.end); }
  /// The same where the gap's slope may leap: by halving.
  void halve_to_middle(SurfaceRow& row, SurfacePoint& at) const;

  const WheelAndRail& bodies_;
  const RailSurface& surface_;
  const surface::WheelMotion& wheel_;
  const surface::RailMotion& rail_;
  SineCosine roll_;  // the rail's
  std::optional<WheelDeviation> deviation_;
};

}  // namespace wrc::halfspace
