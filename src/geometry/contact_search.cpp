#include "geometry/contact_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/elementary.hpp"

namespace wrc::geometry {
namespace {

constexpr std::int32_t scan_cap = 2048;     ///< points of a scan; a profile is at most 0.5 m wide
constexpr double scan_margin = 3e-3;        ///< stations scanned on either side of the rail [m]
constexpr std::int32_t refine_cap = 60;     ///< secant steps; ten are typical
constexpr double refine_tolerance = 1e-11;  ///< [m]

/// Wheel and rail over each other at one position of the wheel's profile.
struct Station {
  double s = 0.0;
  double departing = 0.0;  ///< slope of the gap along y: rail slope - outline slope; < 0 while they approach
  double gap = 0.0;        ///< vertical [m]
  OutlinePoint outline;
  bool over_rail = false;  ///< the outline's point is above the rail's profile, not beside it
};

struct Search {
  const Rail& rail;
  const PosedWheel& wheel;
  std::int32_t rail_piece = 0, wheel_piece = 0;

  /// Beside the rail its end tangent continues, so that a contact close to its end is bracketed as any other.
  Station at(double s) {
    Station station;
    station.s = s;
    station.outline = outline(wheel, s, wheel_piece);
    const double y = station.outline.y;
    const ProfilePoint on_rail = evaluate(rail.profile, y, rail_piece);
    station.gap = on_rail.z - station.outline.z;
    station.departing = on_rail.slope - station.outline.dz_dy();
    station.over_rail = y >= rail.profile.y[0] && y <= rail.profile.y[rail.profile.count - 1];
    return station;
  }

  /// The station between low (approaching) and high (departing) where the tangents agree.
  Station refine(Station low, Station high, Fault& fault) {
    double f_low = low.departing, f_high = high.departing;
    for (std::int32_t i = 0; i < refine_cap; ++i) {
      Station middle = at(low.s + (high.s - low.s) * f_low / (f_low - f_high));
      if (middle.departing < 0.0) {
        const double moved = middle.s - low.s;
        low = middle;
        f_low = middle.departing;
        f_high *=
            0.5;  // Illinois: an end that stays put loses weight, so that the bracket closes on both sides
        if (moved < refine_tolerance) return middle;
      } else {
        const double moved = high.s - middle.s;
        high = middle;
        f_high = middle.departing;
        f_low *= 0.5;
        if (moved < refine_tolerance) return middle;
      }
    }
    keep_worst(fault, Fault::iteration_cap("contact search"));
    return low.gap < high.gap ? low : high;
  }
};

ContactPoint contact_point(const Rail& rail, const PosedWheel& wheel, const Station& station) {
  const OutlinePoint& on_wheel = station.outline;
  ContactPoint contact;
  contact.x = on_wheel.x;
  contact.y = on_wheel.y;
  contact.z = on_wheel.z + station.gap;
  contact.vertical_gap = station.gap;
  const double tangent = on_wheel.dz_dy();
  contact.angle = arctangent(tangent);
  contact.cosine = 1.0 / std::sqrt(1.0 + tangent * tangent);
  contact.sine = tangent * contact.cosine;
  contact.y_rail = rail.outward * (on_wheel.y - rail.origin_y);
  contact.y_wheel = wheel.wheel->outward * (station.s - wheel.wheel->origin_y);
  contact.wheel_s = station.s;
  contact.rolling_radius = on_wheel.radius;
  return contact;
}

/// Keeps the points sorted by gap; of too many the one with the largest gap is dropped.
void insert(const ContactPoint& point, std::int32_t capacity, ContactPoint* points, std::int32_t& count) {
  std::int32_t place = count;
  while (place > 0 && points[place - 1].vertical_gap > point.vertical_gap) --place;
  if (place >= capacity) return;
  count = std::min(count + 1, capacity);
  for (std::int32_t i = count - 1; i > place; --i) points[i] = points[i - 1];
  points[place] = point;
}

}  // namespace

Fault find_contact(const Rail& rail, const PosedWheel& wheel, std::int32_t capacity, ContactPoint* points,
                   std::int32_t& count) {
  count = 0;
  const Profile& profile = wheel.wheel->profile;
  const double first = profile.y[0], last = profile.y[profile.count - 1];
  const std::int32_t steps =
      std::clamp(static_cast<std::int32_t>((last - first) / scan_spacing), 1, scan_cap);
  const double step = (last - first) / steps;
  // Only stations over the rail count: y of the outline is this line in s but for the yaw's second order
  // effect.
  const Attitude& a = wheel.attitude;
  const double offset = a.r[1][2] * wheel.wheel->nominal_radius + wheel.centre_y;
  if (!(a.r[1][1] > 0.5) || !std::isfinite(offset) || !std::isfinite(wheel.centre_z)) {
    return Fault::not_finite("pose", "check the pose before it is used");
  }
  const auto station_index = [&](double y) {
    return static_cast<std::int32_t>(
        std::clamp(((y - offset) / a.r[1][1] - first) / step, -1.0, steps + 1.0));
  };
  const std::int32_t beside = static_cast<std::int32_t>(scan_margin / step) + 1;
  const std::int32_t begin = std::max(station_index(rail.profile.y[0]) - beside, 0);
  const std::int32_t end = std::min(station_index(rail.profile.y[rail.profile.count - 1]) + beside, steps);

  Search search{rail, wheel, 0, piece_at(profile, first + begin * step)};
  Fault fault;
  bool over_rail = false;
  double end_gap = std::numeric_limits<double>::max();  // least gap at a place where one of the profiles ends
  Station before;
  for (std::int32_t i = begin; i <= end; ++i) {
    const Station now = search.at(i < steps ? first + i * step : last);
    over_rail = over_rail || now.over_rail;
    if (i == begin) {
      if (now.departing >= 0.0) end_gap = now.gap;
    } else if (before.departing < 0.0 && now.departing >= 0.0) {
      const Station closest = search.refine(before, now, fault);
      if (closest.outline.dy_ds <= 0.0) {
        // on the folded part of the outline (see outline()): hidden behind the rest of the wheel
      } else if (closest.over_rail) {
        insert(contact_point(rail, wheel, closest), capacity, points, count);
      } else {
        end_gap = std::min(end_gap, closest.gap);
      }
    }
    if (i == end && now.departing < 0.0) end_gap = std::min(end_gap, now.gap);
    before = now;
  }
  if (!over_rail) {
    return Fault::gap("pose.lateral", {wheel.centre_y, "m"},
                      "the wheel stands beside the rail: their profiles do not overlap");
  }
  if (count == 0 || end_gap < points[0].vertical_gap) {
    count = 0;
    return Fault::gap("pose.lateral", {wheel.centre_y, "m"},
                      "wheel and rail are closest at the end of a profile: is the profile cut too short?");
  }
  return fault;
}

}  // namespace wrc::geometry
