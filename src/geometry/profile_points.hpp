/// A profile from measured or tabulated points: checks a user can act on, then a cubic spline. Init only.
#pragma once

#include <cstdint>

#include "base/fault.hpp"
#include "geometry/profile.hpp"

namespace wrc::geometry {

/// Which body the points describe; the orientation checks differ.
enum class ProfileBody { rail, wheel };

/// Bounds of a profile in metres.
inline constexpr double profile_reach = 1.0;            ///< |y|, |z| of a point [m]
inline constexpr double profile_width_least = 0.020;    ///< [m]
inline constexpr double profile_width_most = 0.5;       ///< [m]
inline constexpr double profile_spacing_least = 1e-12;  ///< steep ends have points nanometres apart [m]
inline constexpr double profile_spacing_most = 0.035;   ///< between neighbouring points [m]
inline constexpr double profile_noise_most = 1e-4;      ///< in points that will be smoothed [m]

/// Checks points (y strictly increasing towards the field side, z down, metres) and names their error:
/// non-finite values, millimetres, points that run backwards or fold back, gaps, steps, upside-down or
/// mirrored profiles, too few points or too short a piece. WRC_ERROR_NOT_FINITE, WRC_ERROR_PROFILE; `index`
/// is the point's. `noise`: y may step back so far from point to point [m]; for points that will be smoothed.
Fault check_points(ProfileBody body, std::int32_t count, const double* y, const double* z,
                   double noise = 0.0);

/// Checks the points, copies them into `memory` and gives them the slopes of the natural cubic spline.
///
/// Natural, not not-a-knot: its ends are straight, so that the curve stays twice continuously differentiable
/// where the end tangent takes over beyond the last point, and noise at the ends is not amplified. Its error
/// at an end with curvature fades by 0.27 per point, and contact does not happen at the last points of a
/// usable profile. `scratch` holds `count` doubles.
Fault spline_through(ProfileBody body, std::int32_t count, const double* y, const double* z, double* scratch,
                     const ProfileMemory& memory, Profile& profile);

}  // namespace wrc::geometry
