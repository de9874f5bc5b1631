/// Arc length along a placed profile, from its origin; to the field side positive. Right-hand profiles.
#pragma once

#include "geometry/profile.hpp"

namespace wrc::geometry {

/// A profile with the arc lengths of its nodes.
struct MeasuredProfile {
  const Profile* profile = nullptr;
  const double* arc = nullptr;  ///< profile->count of them [m]
};

/// Fills `arc`, 0 at y = origin.
MeasuredProfile measure(const Profile& profile, double origin, double* arc);

/// Arc length at y; beyond an end along its tangent. `piece`: as in evaluate().
double arc_at(const MeasuredProfile& measured, double y, std::int32_t& piece);

/// y at an arc length; beyond an end that end.
double place_at(const MeasuredProfile& measured, double arc);

}  // namespace wrc::geometry
