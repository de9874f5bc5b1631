/// Where the reference program of the field puts a contact, for comparisons with its results.
#pragma once

#include <cmath>
#include <cstdint>

#include "base/elementary.hpp"
#include "geometry/contact_search.hpp"

namespace wrc::test {

/// The point the reference program of the field (CONTACT) refers its creepages, contact angle and moments to:
/// the rail position and contact angle averaged over the overlap of the undeformed bodies, weighted with the
/// square of the overlap,
///     y_ref = IInt y g^2 dx dy / IInt g^2 dx dy,   angle likewise,   g(x, y) = overlap, vertical.
/// Across x the overlap is a parabola of constant curvature, so the weight of a strip is g^(5/2) with g its
/// overlap. Unlike the point of first contact, which jumps across the tread, it moves continuously with the
/// pose while the overlap stays in one piece. `overlap` is the vertical overlap at the point of first contact
/// [m], > 0; only the contiguous region around it counts. The point keeps the vertical gap of the first
/// contact, so that a gap in its frame touches zero there.
inline geometry::ContactPoint overlap_weighted_point(const geometry::Rail& rail,
                                                     const geometry::PosedWheel& wheel,
                                                     const geometry::ContactPoint& first_contact,
                                                     double overlap) {
  constexpr double spacing = 0.1e-3;  // of the integration over the overlap [m]
  constexpr int most = 1000;          // stations on either side
  struct Station {
    geometry::OutlinePoint outline;
    geometry::ProfilePoint on_rail;
    double gap = 0.0;  // vertical [m]
  };
  const auto station_at = [&](double s) {
    std::int32_t wheel_piece = geometry::piece_at(wheel.wheel->profile, s);
    Station station{geometry::outline(wheel, s, wheel_piece), {}, 0.0};
    std::int32_t rail_piece = geometry::piece_at(rail.profile, station.outline.y);
    station.on_rail = geometry::evaluate(rail.profile, station.outline.y, rail_piece);
    station.gap = station.on_rail.z - station.outline.z;
    return station;
  };
  double weights = 0.0, sum_y = 0.0, sum_angle = 0.0;
  // Relative to the first contact, so that nothing cancels in the sums. False where the overlap has ended.
  const auto add = [&](double s) {
    const Station station = station_at(s);
    const double y = station.outline.y, depth = overlap + first_contact.vertical_gap - station.gap;
    if (!(depth > 0.0) || y < rail.profile.y[0] || y > rail.profile.y[rail.profile.count - 1]) return false;
    const double weight = depth * depth * std::sqrt(depth) * station.outline.dy_ds;
    weights += weight;
    sum_y += weight * (y - first_contact.y);
    sum_angle += weight * (std::atan(station.on_rail.slope) - first_contact.angle);
    return true;
  };
  const double start = first_contact.wheel_s;
  if (!add(start)) return first_contact;
  for (int i = 1; i < most && add(start + i * spacing); ++i) continue;
  for (int i = 1; i < most && add(start - i * spacing); ++i) continue;

  // The wheel's point over the weighted y: Newton, well started by the first contact.
  const double y = first_contact.y + sum_y / weights;
  double s = start;
  Station station = station_at(s);
  for (int i = 0; i < 60 && std::abs(y - station.outline.y) > 1e-11; ++i) {
    s += (y - station.outline.y) / station.outline.dy_ds;
    station = station_at(s);
  }
  geometry::ContactPoint point = first_contact;
  point.x = station.outline.x;
  point.y = station.outline.y;
  point.z = station.on_rail.z;
  point.angle = first_contact.angle + sum_angle / weights;
  point.cosine = std::cos(point.angle);
  point.sine = std::sin(point.angle);
  point.y_rail = rail.outward * (station.outline.y - rail.origin_y);
  point.y_wheel = wheel.wheel->outward * (s - wheel.wheel->origin_y);
  point.wheel_s = s;
  point.rolling_radius = station.outline.radius;
  return point;
}

}  // namespace wrc::test
