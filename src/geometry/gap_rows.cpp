#include "geometry/gap_rows.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/simd/tasks.hpp"

namespace wrc::geometry {
namespace {

constexpr double least_cosine = 0.17364818;  ///< cos 80 degrees: steepest inclination to the contact plane
constexpr double least_advance = 0.05;  ///< dy per parameter; below, the wheel's outline is about to fold
constexpr double window_step = scan_spacing;

/// A curve's point in the contact frame.
struct FramePoint {
  double y = 0.0, z = 0.0;  ///< [m]
  double dz_dy = 0.0;
  double dy_dt = 1.0;  ///< derivative of y by the curve's own parameter
};

/// The contact frame and the two curves in it. The wheel's curve parameter is s, the rail's is track y.
struct Frame {
  const Rail& rail;
  const PosedWheel& wheel;
  const ContactPoint& contact;
  std::int32_t rail_piece, wheel_piece;

  Frame(const Rail& rail_, const PosedWheel& wheel_, const ContactPoint& contact_)
      : rail(rail_),
        wheel(wheel_),
        contact(contact_),
        rail_piece(piece_at(rail_.profile, contact_.y)),
        wheel_piece(piece_at(wheel_.wheel->profile, contact_.wheel_s)) {}

  /// y, z relative to the contact point in track axes; (ty, tz) the tangent.
  FramePoint turned(double y, double z, double ty, double tz, double dy_dt) const {
    const double c = contact.cosine, s = contact.sine;
    const double run = c * ty + s * tz;
    return {c * y + s * z, c * z - s * y, (c * tz - s * ty) / run, run / ty * dy_dt};
  }

  FramePoint rail_at(double y) {
    const ProfilePoint p = evaluate(rail.profile, y, rail_piece);
    return turned(y - contact.y, p.z - contact.z, 1.0, p.slope, 1.0);
  }

  FramePoint wheel_at(double s, OutlinePoint& point) {
    point = outline(wheel, s, wheel_piece);
    return turned(point.y - contact.y, point.z + contact.vertical_gap - contact.z, point.normal_z,
                  -point.normal_y, point.dy_ds);
  }

  /// Cosine between a surface's normal and the contact normal, from its slope in the contact frame.
  static double facing(double dz_dy) { return 1.0 / std::sqrt(1.0 + dz_dy * dz_dy); }
};

/// Gap of one row seen from a wheel station, without Newton: the vertical gap g and the inclinations of the
/// wheel to the vertical and to the contact plane give the separation along the contact normal to first order
/// in g.
struct Station {
  double y = 0.0;        ///< the wheel's point in the contact frame [m]
  double height = 0.0;   ///< [m]
  double facing = 1.0;   ///< least cosine of rail and wheel to the contact normal; <= 0 turned away
  double advance = 1.0;  ///< dy/ds of the wheel's outline
  bool over_rail = true;
};

Station station(Frame& frame, double s) {
  OutlinePoint point;
  const FramePoint wheel = frame.wheel_at(s, point);
  const ContactPoint& contact = frame.contact;
  const Profile& profile = frame.rail.profile;
  Station result;
  result.y = wheel.y;
  result.advance = wheel.dy_dt;
  result.over_rail = point.y >= profile.y[0] && point.y <= profile.y[profile.count - 1];
  if (!result.over_rail) return result;
  const ProfilePoint rail = evaluate(profile, point.y, frame.rail_piece);
  const double gap = rail.z - (point.z + contact.vertical_gap);
  // Unit normals against (-sine, cosine), the contact normal; rail: (-slope, 1), wheel: N.
  const double rail_facing =
      (contact.cosine + contact.sine * rail.slope) / std::sqrt(1.0 + rail.slope * rail.slope);
  const double length = std::sqrt(point.normal_y * point.normal_y + point.normal_z * point.normal_z);
  const double wheel_facing = (contact.cosine * point.normal_z - contact.sine * point.normal_y) / length;
  result.facing = std::min(rail_facing, wheel_facing);
  result.height = gap * (point.normal_z / length) / std::max(wheel_facing, least_cosine);
  return result;
}

/// Contact-frame y where rail and wheel both still exist on the side of `direction` (-1 low, +1 high).
double profile_end(Frame& frame, double direction) {
  const Profile& rail = frame.rail.profile;
  const Profile& wheel = frame.wheel.wheel->profile;
  OutlinePoint ignored;
  const double rail_y = frame.rail_at(direction < 0.0 ? rail.y[0] : rail.y[rail.count - 1]).y;
  const double wheel_y = frame.wheel_at(direction < 0.0 ? wheel.y[0] : wheel.y[wheel.count - 1], ignored).y;
  return direction < 0.0 ? std::max(rail_y, wheel_y) : std::min(rail_y, wheel_y);
}

/// Where a quantity that is `a` at y_a and `b` at y_b passes `level`.
double crossing(double y_a, double a, double y_b, double b, double level) {
  return y_a + (y_b - y_a) * std::clamp((level - a) / (b - a), 0.0, 1.0);
}

/// Walks outwards from the contact point and returns the end of the rows on that side.
double window_end(Frame frame, const GapLimits& limits, double direction, RowsEnd& end) {
  const Profile& profile = frame.wheel.wheel->profile;
  const double last_s = direction < 0.0 ? profile.y[0] : profile.y[profile.count - 1];
  const double start = frame.contact.wheel_s;
  const auto steps = static_cast<std::int32_t>(std::abs(last_s - start) / window_step) + 1;

  double reached = 0.0;  // outermost y known to end a zone with the gap below the limit
  end = RowsEnd::gap;
  Station before;
  for (std::int32_t i = 1; i <= steps; ++i) {
    const double s = i < steps ? start + direction * i * window_step : last_s;
    const Station now = station(frame, s);
    const bool was_inside = before.height <= limits.height;
    if (!now.over_rail) {
      if (!was_inside) return reached;
      end = RowsEnd::profile_end;
      return profile_end(frame, direction);
    }
    if (now.facing <= least_cosine) {
      if (!was_inside) return reached;
      end = RowsEnd::inclination;
      return crossing(before.y, before.facing, now.y, now.facing, least_cosine);
    }
    if (now.advance <= least_advance) {
      if (!was_inside) return reached;
      end = RowsEnd::fold;
      return crossing(before.y, before.advance, now.y, now.advance, least_advance);
    }
    if (direction * now.y >= limits.max_half_width) {
      if (!was_inside) return reached;
      end = RowsEnd::half_width;
      return direction * limits.max_half_width;
    }
    if (was_inside && now.height > limits.height) {
      reached = crossing(before.y, before.height, now.y, now.height, limits.height);
    }
    before = now;
  }
  if (before.height > limits.height) return reached;
  end = RowsEnd::profile_end;
  return profile_end(frame, direction);
}

}  // namespace

GapWindow gap_window(const Rail& rail, const PosedWheel& wheel, const ContactPoint& contact,
                     const GapLimits& limits) {
  const Frame frame(rail, wheel, contact);
  GapWindow window;
  window.low = window_end(frame, limits, -1.0, window.low_end);
  window.high = window_end(frame, limits, +1.0, window.high_end);
  return window;
}

Fault fill_gap_rows(const Rail& rail, const PosedWheel& wheel, const ContactPoint& contact,
                    const GapWindow& window, std::int32_t count, const GapRowMemory& memory,
                    const Kernels& kernels, patch::GapRows& rows) {
  rows = {};
  if (count < 4 || count > memory.capacity) {
    return Fault::buffer("gap rows", {count, "rows", 4.0, memory.capacity});
  }
  if (!(window.high > window.low)) {
    return Fault::gap("gap window", {window.high - window.low, "m"},
                      "no width around the contact point in which the gap stays below its limit");
  }

  const double step = (window.high - window.low) / (count - 1);
  const bool converged =
      kernels.geometry.fill_rows({.rail = &rail,
                                  .wheel = &wheel,
                                  .contact = &contact,
                                  .rail_piece = piece_at(rail.profile, contact.y),
                                  .wheel_piece = piece_at(wheel.wheel->profile, contact.wheel_s),
                                  .low = window.low,
                                  .step = step,
                                  .count = count,
                                  .memory = &memory});

  rows = {count, memory.y, memory.height, memory.centre, memory.curvature};
  if (!converged) return Fault::iteration_cap("gap rows");
  return {};
}

}  // namespace wrc::geometry
