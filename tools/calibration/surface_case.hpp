/// A wheel rolling on a rail's surface at random: strips of its contact with rigid slips of their own, and
/// the forces of exact theory on the curved surface. What strip FASTSIM on the surface is fitted to and
/// judged on.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "surface/rolling/surface_rolling.hpp"

namespace wrc::calibration {

/// A strip of the contact, in its own axes; SI units.
struct SurfaceStrip {
  double place, width, centre, half_length, peak, curvature;
  double angle;  ///< of its normal (0, -sin, cos)
  double slip_x, slip_y, spin;
};

struct SurfaceCase {
  double shift, yaw, roll, load;  ///< pose of the wheel and its vertical load
  double poisson, shear_modulus, friction, normal_force;
  std::vector<SurfaceStrip> strips;
};

/// Forces on the wheel, tractions only.
struct SurfaceForces {
  double fx, fy, fz;   ///< rail axes [N]
  double mz;           ///< of the surface unrolled, about the load's middle [N m]
  double power;        ///< over the speed [N]
  double adhesion;     ///< area that sticks over the area
  double force_shift;  ///< |F - F on the fine grid| / (mu N): how far the extrapolation went
  bool converged;
};

struct ExactSurfaceCase {
  SurfaceCase rolling;
  SurfaceForces exact;
};

/// Case `row` of the endless list that belongs to `seed`: an S1002 on a UIC60 (1:40), lateral shift -9 to 8
/// mm, yaw up to 20 mrad either way, roll up to 8 mrad, loads of 8 to 140 kN; friction 0.1 to 0.55. Slips are
/// the wheel's own (spin of the flange, rolling radius over the width) with mean slips of all directions,
/// 0.05 to 6 friction limits; in four cases of ten the turning of slips over the width is scaled by -1.4
/// to 1.4, in a quarter of all cases spin is added. Mean spins above 2 1/m are drawn again.
SurfaceCase random_surface_case(std::uint64_t seed, std::uint64_t row);

/// On rows of the narrowest strip's width and of half of it, cells along x in proportion, extrapolated.
SurfaceForces exact_forces(const SurfaceCase& rolling);

/// What the strips of the library make of it.
SurfaceForces strip_forces(
    const SurfaceCase& rolling, const tangential::MarchGrid& grid,
    const surface::StripCoefficientTable& coefficients, const surface::SurfaceCalibration& calibration,
    surface::SurfaceRollingMethod method = surface::SurfaceRollingMethod::strip_fastsim);

std::string text_of(const SurfaceCase& rolling);
std::string text_of(const ExactSurfaceCase& c);

/// All cases of a file. Throws a sentence (std::string) where it cannot be read.
std::vector<ExactSurfaceCase> read_surface_cases(const std::string& path);

inline constexpr const char* surface_heading =
    "shift,yaw,roll,load,poisson,shear_modulus,friction,normal_force,fx,fy,fz,mz,power,adhesion,force_shift,"
    "strips";

}  // namespace wrc::calibration
