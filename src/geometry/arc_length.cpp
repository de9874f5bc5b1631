#include "geometry/arc_length.hpp"

#include <algorithm>
#include <cmath>

namespace wrc::geometry {
namespace {

/// Length of piece i from its node to `u` behind it: Gauss's rule with three points, to 1e-9 of a piece.
double length_of(const Profile& profile, std::int32_t i, double u) {
  constexpr double outer = 0.77459666924148337704;
  const auto stretch = [&](double node) {
    const double slope = evaluate_piece(profile, profile.y[i] + 0.5 * u * (1.0 + node), i).slope;
    return std::sqrt(1.0 + slope * slope);
  };
  return u * (5.0 * (stretch(-outer) + stretch(outer)) + 8.0 * stretch(0.0)) / 18.0;
}

}  // namespace

MeasuredProfile measure(const Profile& profile, double origin, double* arc) {
  arc[0] = 0.0;
  for (std::int32_t i = 0; i + 1 < profile.count; ++i)
    arc[i + 1] = arc[i] + length_of(profile, i, profile.y[i + 1] - profile.y[i]);
  const MeasuredProfile measured{&profile, arc};
  std::int32_t piece = piece_at(profile, origin);
  const double shift = arc_at(measured, origin, piece);
  for (std::int32_t i = 0; i < profile.count; ++i) arc[i] -= shift;
  return measured;
}

double arc_at(const MeasuredProfile& measured, double y, std::int32_t& piece) {
  const Profile& profile = *measured.profile;
  const std::int32_t last = profile.count - 1;
  for (const std::int32_t end : {0, last}) {
    const double beyond = y - profile.y[end];
    if (end == 0 ? beyond < 0.0 : beyond > 0.0)
      return measured.arc[end] + beyond * std::sqrt(1.0 + profile.slope[end] * profile.slope[end]);
  }
  evaluate(profile, y, piece);
  return measured.arc[piece] + length_of(profile, piece, y - profile.y[piece]);
}

double place_at(const MeasuredProfile& measured, double arc) {
  const Profile& profile = *measured.profile;
  const std::int32_t last = profile.count - 1;
  if (!(arc > measured.arc[0])) return profile.y[0];
  if (!(arc < measured.arc[last])) return profile.y[last];
  const auto i = static_cast<std::int32_t>(std::upper_bound(measured.arc + 1, measured.arc + last, arc) -
                                           measured.arc - 1);
  const double wanted = arc - measured.arc[i], width = profile.y[i + 1] - profile.y[i];
  double u = width * wanted / (measured.arc[i + 1] - measured.arc[i]);
  for (int n = 0; n < 4; ++n) {
    const double slope = evaluate_piece(profile, profile.y[i] + u, i).slope;
    u = std::clamp(u - (length_of(profile, i, u) - wanted) / std::sqrt(1.0 + slope * slope), 0.0, width);
  }
  return profile.y[i] + u;
}

}  // namespace wrc::geometry
