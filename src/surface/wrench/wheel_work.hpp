/// A solve of a wheel on a rail on its way: its working memory, and the wheel as the rail sees it.
#pragma once

#include <cstdint>

#include "surface/geometry/overlap.hpp"
#include "surface/geometry/rail_direction.hpp"
#include "surface/pressure/pressure.hpp"
#include "surface/rolling/surface_rolling.hpp"
#include "surface/surface_model.hpp"
#include "surface/wrench/wheel_on_rail.hpp"

namespace wrc {

/// The wheel as the rail sees it: rail axes, origin of its profile.
struct RelativeMotion {
  RelativePose pose;
  double velocity[3];          ///< of the wheel's reference point less that of rail material there
  double angular_velocity[3];  ///< of the wheel less that of the rail
  double cosine, sine;         ///< of the rail's roll
  bool aslant;                 ///< does the rail run so?
  RailDirection<double> direction;
  double rail_turning;  ///< of a roller about its axle [rad/s]
};

struct WheelWork {
  RailStrips rail;                      ///< where the wheel is
  double* rail_strips;                  ///< its memory, where it is not the model's
  double steepest;                      ///< of the rail there, along the track [-]
  double distance;                      ///< of the wheel, as far as there are sections [m]
  SectionBlend blend[most_rail_faces];  ///< of the rail's faces there
  Overlaps overlaps;
  OverlapScratch scratch;
  StripPressure pressure;
  RelativeMotion seen;              ///< of the last solve
  double* normal;                   ///< scratch of the normal problem
  double* rolling;                  ///< scratch of rolling
  double* slopes;                   ///< of derivatives
  double *planar, *region, *along;  ///< scratch of methods that know planes and patches
  // over the strips in contact
  double *place, *width, *half_length, *peak, *curvature, *slip_x, *slip_y, *spin, *friction, *fx, *fy, *mz,
      *other_fx, *other_fy, *other_mz;
  double *cold_friction,
      *heat_share;          ///< of friction over temperature (tangential/friction/heated_friction.hpp)
  std::int32_t* candidate;  ///< of a strip in contact
  TangentialFields fields;  ///< over their cells, on request; scratch of FaStrip
  // of the last solve
  std::int32_t loaded;   ///< strips in contact
  double speed;          ///< what their slips are over [m/s]
  double rolling_speed;  ///< [m/s]; < 0 backwards
  bool backwards;
  double factor;  ///< on its pressures and tractions
};

/// What the strips in contact roll with: the arrays of these names in `strips`, and the model's numbers.
template <class Number, class Strips>
SurfaceRollingInputOf<Number> rolling_input(const SurfaceModel& model, const WheelOnRail& in,
                                            std::int32_t count, const Strips& strips) {
  SurfaceRollingInputOf<Number> rolls;
  rolls.count = count;
  rolls.place = strips.place;
  rolls.width = strips.width;
  rolls.half_length = strips.half_length;
  rolls.peak = strips.peak;
  rolls.curvature = strips.curvature;
  rolls.slip_x = strips.slip_x;
  rolls.slip_y = strips.slip_y;
  rolls.spin = strips.spin;
  rolls.friction = strips.friction;
  rolls.normal_shear_modulus = model.material.shear_modulus;
  rolls.shear_modulus = model.material.shear_modulus * in.slope_reduction;
  rolls.coefficients = &model.coefficients;
  rolls.grid = model.grid;
  return rolls;
}

}  // namespace wrc
