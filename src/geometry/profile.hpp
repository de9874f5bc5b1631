/// A wheel or rail profile as a smooth curve z(y): cubic Hermite pieces between nodes that carry value and
/// slope.
///
/// Standard profiles are sampled from their analytic definitions with exact slopes; point arrays get the
/// slopes of the natural cubic spline. One representation serves both. z points down, y to the field side
/// (right wheel).
#pragma once

#include <cstdint>

#include "fault.hpp"

namespace wrc {

/// View of the nodes; y strictly increasing; memory is the owner's (the model).
struct Profile {
  std::int32_t count = 0;
  const double* y = nullptr;      ///< [m]
  const double* z = nullptr;      ///< [m]
  const double* slope = nullptr;  ///< dz/dy [-]
};

/// Value and derivatives at one y. Outside the nodes the end tangent continues (curvature 0): a search that
/// starts there is led back, and the gap there is flagged by the caller as beyond the profile.
struct ProfilePoint {
  double z = 0.0;       ///< [m]
  double slope = 0.0;   ///< dz/dy [-]
  double second = 0.0;  ///< d2z/dy2 [1/m]
};

ProfilePoint evaluate(const Profile& profile, double y);

}  // namespace wrc
