#include "geometry/profile.hpp"

#include <algorithm>

namespace wrc::geometry {

Profile profile_in(const ProfileMemory& memory, std::int32_t count) {
  for (std::int32_t i = 0; i + 1 < count; ++i) {
    const double inverse = 1.0 / (memory.y[i + 1] - memory.y[i]);
    const double chord = (memory.z[i + 1] - memory.z[i]) * inverse;
    const double m0 = memory.slope[i], m1 = memory.slope[i + 1];
    memory.square[i] = (3.0 * chord - 2.0 * m0 - m1) * inverse;
    memory.cube[i] = (m0 + m1 - 2.0 * chord) * inverse * inverse;
  }
  return {count, memory.y, memory.z, memory.slope, memory.square, memory.cube};
}

Fault too_few_nodes(std::int32_t capacity, std::int32_t needed) {
  return Fault::buffer("profile memory", {capacity, "nodes", needed, 1e9},
                       "the memory holds fewer nodes than the profile has");
}

std::int32_t piece_at(const Profile& profile, double y) {
  const double* above = std::upper_bound(profile.y, profile.y + profile.count, y);
  return std::clamp(static_cast<std::int32_t>(above - profile.y) - 1, 0, profile.count - 2);
}

ProfilePoint evaluate(const Profile& profile, double y) {
  return evaluate_piece(profile, y, piece_at(profile, y));
}

ProfileTop highest_point(const Profile& profile) {
  const auto top =
      static_cast<std::int32_t>(std::min_element(profile.z, profile.z + profile.count) - profile.z);
  // Between the neighbours of the highest node the slope rises through zero: bisect it.
  double low = profile.y[std::max(top - 1, 0)];
  double high = profile.y[std::min(top + 1, profile.count - 1)];
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (evaluate(profile, middle).slope < 0.0 ? low : high) = middle;
  }
  const double y = 0.5 * (low + high);
  return {y, evaluate(profile, y).z};
}

}  // namespace wrc::geometry
