#include "geometry/placement.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/profile_points.hpp"

namespace wrc::geometry {
namespace {

/// Steepest tangent kept at the ends of a rotated profile: 89.4 degrees, beyond any contact.
constexpr double steepest = 100.0;

void shift(const ProfileMemory& memory, const Profile& profile, double y, double z) {
  for (std::int32_t i = 0; i < profile.count; ++i) {
    memory.y[i] += y;
    memory.z[i] += z;
  }
}

/// y of the innermost point that lies no deeper than `depth` below the top, searched from there inwards
/// (towards negative y) [m].
Fault find_gauge_face(const Profile& profile, const ProfileTop& top, double depth, double& y) {
  std::int32_t i = piece_at(profile, top.y);
  while (i >= 0 && profile.z[i] <= top.z + depth) --i;
  if (i < 0) {
    return Fault::profile(
        "depth of the rail profile at its gauge end", {profile.z[0] - top.z, "m", depth, profile_reach},
        "it ends above config.track.gauge_depth, where the gauge is measured: add points further down");
  }
  double low = profile.y[i], high = profile.y[i + 1];
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (evaluate(profile, middle).z > top.z + depth ? low : high) = middle;
  }
  y = 0.5 * (low + high);
  return {};
}

}  // namespace

Fault place(const Profile& profile, const Placement& placement, const ProfileMemory& memory,
            Profile& placed) {
  const double c = 1.0 / std::sqrt(1.0 + placement.inclination * placement.inclination);
  const double s = placement.inclination * c;
  // dy'/dy > 0 with a slope that is not too steep: the part that stays a function z(y) after the rotation.
  const auto usable = [&](std::int32_t i) {
    const double run = c + s * profile.slope[i];
    const double rise = c * profile.slope[i] - s;
    return run > 0.0 && std::abs(rise) <= steepest * run;
  };
  std::int32_t first = 0, last = profile.count - 1;
  while (first < last && !usable(first)) ++first;
  while (last > first && !usable(last)) --last;
  const std::int32_t count = last - first + 1;
  if (memory.capacity < count) return too_few_nodes(memory.capacity, count);

  for (std::int32_t i = 0; i < count; ++i) {
    const double y = profile.y[first + i], z = profile.z[first + i], slope = profile.slope[first + i];
    memory.y[i] = c * y + s * z + placement.y;
    memory.z[i] = c * z - s * y + placement.z;
    memory.slope[i] = (c * slope - s) / (c + s * slope);
    if (!usable(first + i)) {
      return Fault::profile(
          {"slope of the profile, after canting,", first + i}, {memory.slope[i], ""},
          "it passes 89.4 degrees with flatter points on both sides: is there a step in the points?");
    }
    if (i > 0 && memory.y[i] <= memory.y[i - 1]) {
      return Fault::profile({"rail inclination", first + i}, {placement.inclination, ""},
                            "the canted profile folds back: it is no longer a height over lateral position");
    }
  }
  const double width = memory.y[count - 1] - memory.y[0];
  if (width < profile_width_least) {
    return Fault::profile("width of a profile where it is not too steep",
                          {width, "m", profile_width_least, profile_width_most},
                          "its ends are steeper than 89.4 degrees and cut off: is the scale of z that of y?");
  }
  placed = profile_in(memory, count);
  return {};
}

void mirror(const ProfileMemory& memory, const Profile& profile) {
  std::reverse(memory.y, memory.y + profile.count);
  std::reverse(memory.z, memory.z + profile.count);
  std::reverse(memory.slope, memory.slope + profile.count);
  for (std::int32_t i = 0; i < profile.count; ++i) {
    memory.y[i] = -memory.y[i];
    memory.slope[i] = -memory.slope[i];
  }
}

Fault place_rail(const Profile& profile, const TrackDimensions& track, Side side, const ProfileMemory& memory,
                 Rail& rail) {
  Profile canted;
  Fault fault = place(profile, Placement{.inclination = track.rail_inclination}, memory, canted);
  if (fault.failed()) return fault;
  double origin = track.rail_origin, depth = 0.0;
  if (!track.by_origin) {
    const ProfileTop top = highest_point(canted);
    double gauge_face = 0.0;
    fault = find_gauge_face(canted, top, track.gauge_depth, gauge_face);
    if (fault.failed()) return fault;
    origin = 0.5 * track.gauge - gauge_face;
    depth = -top.z;
  }
  shift(memory, canted, origin, depth);
  if (side == Side::left) mirror(memory, canted);
  rail.outward = side == Side::left ? -1.0 : 1.0;
  rail.profile = profile_in(memory, canted.count);
  rail.origin_y = rail.outward * origin;
  rail.origin_z = depth;
  return {};
}

Fault place_wheel(const Profile& profile, const WheelsetDimensions& wheelset, Side side,
                  const ProfileMemory& memory, Wheel& wheel) {
  const double origin = 0.5 * wheelset.tape_circle_distance;
  Profile placed;
  const Fault fault = place(profile, Placement{.y = origin}, memory, placed);
  if (fault.failed()) return fault;
  if (side == Side::left) mirror(memory, placed);
  wheel.outward = side == Side::left ? -1.0 : 1.0;
  wheel.profile = profile_in(memory, placed.count);
  wheel.origin_y = wheel.outward * origin;
  wheel.nominal_radius = wheelset.nominal_radius;
  return {};
}

}  // namespace wrc::geometry
