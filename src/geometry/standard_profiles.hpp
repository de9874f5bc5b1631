/// Standard wheel and rail profiles from their analytic definitions: theory 6.1 (wheel S1002 of EN 13715) and
/// 6.2 (rail head 60E1 of EN 13674-1, and the UIC60 variant of the Manchester benchmarks).
///
/// Three faces of each: the analytic curve (value, slope, second derivative at any y), its sampling into
/// profile nodes, and the number of nodes that takes. Init only.
#pragma once

#include <cstdint>

#include "geometry/profile.hpp"

namespace wrc::geometry {

/// Where the flange-back arc of the S1002 is cut: its tangent becomes vertical 1 mm further out, and no
/// rail touches a wheel there.
inline constexpr double s1002_first_y = -0.0690;  ///< [m]
inline constexpr double s1002_last_y = 0.0600;    ///< [m]

/// Wheel profile S1002 at y in [s1002_first_y, s1002_last_y], origin at the tape circle, flange at negative
/// y.
///
/// The rounded coefficients of the standard leave steps of 3.7e-5 mm at y = -26 mm and 1.2e-4 mm at -35 mm,
/// at both ends of the flange-root polynomial (section C). A step would be a spike of curvature, so section C
/// carries a cubic correction (at most 1.2e-4 mm) that joins its neighbours in value and slope; every other
/// section is the standard's. Steps of curvature at the joins are the standard's own and stay.
ProfilePoint s1002(double y);

/// Uncorrected flange-root polynomial of the standard, for -35 mm <= y < -26 mm.
ProfilePoint s1002_flange_root_of_standard(double y);

/// A rail head of tangent arcs R300, R80, R13 and a 1:20 side, symmetric, crown at the origin.
/// The arcs are tangent by construction, so the two transitions define everything else.
struct RailHead {
  double crown_half_width;     ///< |y| where R300 meets R80 [m]
  double shoulder_half_width;  ///< |y| where R80 meets R13 [m]

  /// Centres (y > 0 side) and the start of the side, from tangency [m].
  double crown_z() const;                                       ///< z of the R300-R80 joint
  double shoulder_centre_y() const, shoulder_centre_z() const;  ///< R80
  double corner_centre_y() const, corner_centre_z() const;      ///< R13
  double side_y() const, side_z() const;                        ///< where R13 meets the side
};

/// Nominal 60E1 head.
inline constexpr RailHead rail_60e1{0.020456 / 2.0, 0.052053 / 2.0};
/// The head inside the benchmark UIC60: it differs from 60E1 by a few hundredths of a mm.
inline constexpr RailHead rail_uic60_benchmark{0.0105000, 0.0259881};

/// How far down the 1:20 side the sampled head reaches [m].
inline constexpr double rail_side_depth = 0.022;

/// Rail head before canting, |y| up to last_y(head).
ProfilePoint rail_head(const RailHead& head, double y);
double rail_head_last_y(const RailHead& head);

/// Position of the benchmark head in the coordinates of the benchmark's profile, which is canted 1:40 towards
/// the track centre and has its origin at its highest point.
inline constexpr double benchmark_inclination = 1.0 / 40.0;
inline constexpr double benchmark_crown_y = -0.0074917;  ///< [m]
inline constexpr double benchmark_crown_z = 0.0000937;   ///< [m]

/// Nodes each sampling writes; between them the Hermite curve stays within 1e-9 m of the analytic one.
inline constexpr std::int32_t s1002_nodes = 255;
inline constexpr std::int32_t rail_head_nodes = 193;
inline constexpr std::int32_t uic60_benchmark_nodes = rail_head_nodes;

/// Fills `memory` and points `profile` at it. WRC_ERROR_BUFFER if the memory is too small.
Fault sample_s1002(const ProfileMemory& memory, Profile& profile);
Fault sample_rail_head(const RailHead& head, const ProfileMemory& memory, Profile& profile);
/// The UIC60 of the Manchester benchmarks, already canted 1:40 (place it with inclination 0).
Fault sample_uic60_benchmark(const ProfileMemory& memory, Profile& profile);

}  // namespace wrc::geometry
