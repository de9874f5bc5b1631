/// A wheel or rail profile as a smooth curve z(y): cubic Hermite pieces between nodes that carry value and
/// slope.
///
/// Standard profiles are sampled from their analytic definitions with exact slopes (standard_profiles.hpp);
/// point arrays get the slopes of the natural cubic spline (profile_points.hpp). One representation serves
/// both. z points down, y to the field side (right wheel).
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/fault.hpp"

namespace wrc::geometry {

/// View of the nodes; y strictly increasing; memory is the owner's (the model). From node i to the next
///     z = z[i] + u (slope[i] + u (square[i] + u cube[i])),   u = y - y[i].
struct Profile {
  std::int32_t count = 0;
  const double* y = nullptr;       ///< [m]
  const double* z = nullptr;       ///< [m]
  const double* slope = nullptr;   ///< dz/dy [-]
  const double* square = nullptr;  ///< [1/m]
  const double* cube = nullptr;    ///< [1/m^2]
};

/// Memory for the nodes of a profile, handed to the init functions that fill one.
struct ProfileMemory {
  std::int32_t capacity = 0;  ///< nodes
  double* y = nullptr;
  double* z = nullptr;
  double* slope = nullptr;
  double* square = nullptr;
  double* cube = nullptr;
};

/// Doubles that a profile of so many nodes needs.
constexpr std::size_t profile_doubles(std::int32_t nodes) { return 5 * static_cast<std::size_t>(nodes); }

/// Profile memory cut from profile_doubles(nodes) doubles.
inline ProfileMemory profile_memory(std::int32_t nodes, double* doubles) {
  return {nodes, doubles, doubles + nodes, doubles + 2 * nodes, doubles + 3 * nodes, doubles + 4 * nodes};
}

/// The first `count` nodes of `memory`, whose y, z and slope are set, as a profile: finds the pieces between
/// them.
Profile profile_in(const ProfileMemory& memory, std::int32_t count);

/// The fault of every init function whose node memory is too small for `needed` nodes.
Fault too_few_nodes(std::int32_t capacity, std::int32_t needed);

/// Value and derivatives at one y. Outside the nodes the end tangent continues (curvature 0): a search that
/// starts there is led back, and the gap there is flagged by the caller as beyond the profile.
template <class Number>
struct ProfilePointOf {
  Number z = 0.0;       ///< [m]
  Number slope = 0.0;   ///< dz/dy [-]
  Number second = 0.0;  ///< d2z/dy2 [1/m]
};
using ProfilePoint = ProfilePointOf<double>;

/// A piece's cubic at distance u from its node.
template <class Number>
ProfilePointOf<Number> evaluate_cubic(const Number& z, const Number& slope, const Number& square,
                                      const Number& cube, const Number& u) {
  return {z + u * (slope + u * (square + u * cube)), slope + u * (2.0 * square + 3.0 * u * cube),
          2.0 * square + 6.0 * u * cube};
}

ProfilePoint evaluate(const Profile& profile, double y);

/// The same by the piece that holds y.
inline ProfilePoint evaluate_piece(const Profile& profile, double y, std::int32_t piece) {
  const std::int32_t last = profile.count - 1;
  if (y < profile.y[0]) return {profile.z[0] + profile.slope[0] * (y - profile.y[0]), profile.slope[0], 0.0};
  if (y > profile.y[last])
    return {profile.z[last] + profile.slope[last] * (y - profile.y[last]), profile.slope[last], 0.0};
  return evaluate_cubic(profile.z[piece], profile.slope[piece], profile.square[piece], profile.cube[piece],
                        y - profile.y[piece]);
}

/// The same for a caller who moves along the profile in small steps: `piece` is the index of the Hermite
/// piece of the previous evaluation (any value in [0, count - 2] is a valid start) and is updated. The result
/// does not depend on it, only the time to find the piece does.
inline ProfilePoint evaluate(const Profile& profile, double y, std::int32_t& piece) {
  while (piece > 0 && y < profile.y[piece]) --piece;
  while (piece < profile.count - 2 && y >= profile.y[piece + 1]) ++piece;
  return evaluate_piece(profile, y, piece);
}

/// Index of the Hermite piece that holds y: y[piece] <= y < y[piece + 1], clamped to the first or last piece.
std::int32_t piece_at(const Profile& profile, double y);

/// Lowest z value of the profile (the highest point: z points down), its y from the zero slope inside a
/// piece.
struct ProfileTop {
  double y = 0.0;  ///< [m]
  double z = 0.0;  ///< [m]
};
ProfileTop highest_point(const Profile& profile);

}  // namespace wrc::geometry
