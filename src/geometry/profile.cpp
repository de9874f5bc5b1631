#include "geometry/profile.hpp"

#include <algorithm>

namespace wrc {
namespace {

ProfilePoint evaluate_piece(const Profile& profile, double y, std::int32_t piece) {
  const std::int32_t last = profile.count - 1;
  if (y < profile.y[0]) {
    return {profile.z[0] + profile.slope[0] * (y - profile.y[0]), profile.slope[0], 0.0};
  }
  if (y > profile.y[last]) {
    return {profile.z[last] + profile.slope[last] * (y - profile.y[last]), profile.slope[last], 0.0};
  }
  const double dy = profile.y[piece + 1] - profile.y[piece];
  const double inverse = 1.0 / dy;
  const double u = y - profile.y[piece];
  const double m0 = profile.slope[piece];
  const double m1 = profile.slope[piece + 1];
  const double chord = (profile.z[piece + 1] - profile.z[piece]) * inverse;
  // z = z0 + u (m0 + u (c2 + u c3))
  const double c2 = (3.0 * chord - 2.0 * m0 - m1) * inverse;
  const double c3 = (m0 + m1 - 2.0 * chord) * inverse * inverse;
  ProfilePoint point;
  point.z = profile.z[piece] + u * (m0 + u * (c2 + u * c3));
  point.slope = m0 + u * (2.0 * c2 + 3.0 * u * c3);
  point.second = 2.0 * c2 + 6.0 * u * c3;
  return point;
}

}  // namespace

Fault too_few_nodes(std::int32_t capacity, std::int32_t needed) {
  return {.status = WRC_ERROR_BUFFER,
          .field = "profile memory",
          .value = static_cast<double>(capacity),
          .unit = "nodes",
          .low = static_cast<double>(needed),
          .high = 1e9,
          .cause = "the memory holds fewer nodes than the profile has"};
}

std::int32_t piece_at(const Profile& profile, double y) {
  const double* above = std::upper_bound(profile.y, profile.y + profile.count, y);
  return std::clamp(static_cast<std::int32_t>(above - profile.y) - 1, 0, profile.count - 2);
}

ProfilePoint evaluate(const Profile& profile, double y) {
  return evaluate_piece(profile, y, piece_at(profile, y));
}

ProfilePoint evaluate(const Profile& profile, double y, std::int32_t& piece) {
  while (piece > 0 && y < profile.y[piece]) --piece;
  while (piece < profile.count - 2 && y >= profile.y[piece + 1]) ++piece;
  return evaluate_piece(profile, y, piece);
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

}  // namespace wrc
