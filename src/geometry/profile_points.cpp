#include "geometry/profile_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wrc::geometry {
namespace {

struct Names {
  const char *points, *y, *z, *spacing, *step;
};
Names names_of(ProfileBody body) {
  if (body == ProfileBody::rail) {
    return {"rail profile", "rail profile y", "rail profile z", "spacing of rail profile y",
            "step of rail profile z"};
  }
  return {"wheel profile", "wheel profile y", "wheel profile z", "spacing of wheel profile y",
          "step of wheel profile z"};
}

/// A step: far between two points, steeply, between parts that are flat. Flanges and gauge faces are steep
/// from point to point or end the profile; a flange of few points may rise by one chord, at up to
/// 79 degrees, where a head has no such thing. Beyond the head, over the foot, a rail may do as it likes.
Fault check_steps(ProfileBody body, std::int32_t count, const double* y, const double* z) {
  const bool rail = body == ProfileBody::rail;
  constexpr double least_step = 1e-3;           // [m]
  const double least_slope = rail ? 1.5 : 5.0;  // 56 and 79 degrees
  constexpr double flat = 1.0, flatter = 0.2;   // beside it: slope, and over the step's
  constexpr double depth_of_a_head = 0.040;     // [m]
  const double deepest =
      rail ? *std::min_element(z, z + count) + depth_of_a_head : std::numeric_limits<double>::infinity();
  const auto slope = [&](std::int32_t i) {  // points to be smoothed may stand above each other
    return std::abs(z[i] - z[i - 1]) / std::max(std::abs(y[i] - y[i - 1]), profile_spacing_least);
  };
  for (std::int32_t i = 2; i + 1 < count; ++i) {
    const double step = z[i] - z[i - 1], steep = slope(i);
    if (std::abs(step) < least_step || steep < least_slope || std::max(z[i], z[i - 1]) > deepest) continue;
    if (std::max(slope(i - 1), slope(i + 1)) < std::min(flat, flatter * steep)) {
      return Fault::profile(
          {names_of(body).step, i}, {step, "m"},
          "it jumps from the point before to this one: are two measurements joined there, or is a "
          "part of one shifted?");
    }
  }
  return {};
}

/// Mean of z over y, by trapezoids [m].
double mean_height(std::int32_t count, const double* y, const double* z) {
  double area = 0.0;
  for (std::int32_t i = 1; i < count; ++i) area += 0.5 * (z[i] + z[i - 1]) * (y[i] - y[i - 1]);
  return area / (y[count - 1] - y[0]);
}

/// A head is highest (least z) inside and falls off to both ends.
Fault check_rail_orientation(std::int32_t count, const double* y, const double* z) {
  const auto [top, bottom] = std::minmax_element(z, z + count);
  const double mean = mean_height(count, y, z);
  if (mean - *top > *bottom - mean) {
    return Fault::profile({"rail profile z", bottom - z}, {*bottom, "m"},
                          "the head is upside down: z must point down; change the sign of all z");
  }
  if (top == z || top == z + count - 1) {
    return Fault::profile(
        {"rail profile z", top - z}, {*top, "m"},
        "the highest point of the head is at an end of the points: is the profile cut too short, or a "
        "wheel's?");
  }
  constexpr double datum_most = 0.020;  // a head wears down by this much before it is scrapped
  if (std::abs(*top) > datum_most) {
    return Fault::profile({"rail profile z", top - z}, {*top, "m", -datum_most, datum_most},
                          "z must be 0 at the top of the head: shift z");
  }
  return {};
}

/// A wheel is lowest (largest z) at its flange, on the inner side. Of a tread without flange the side cannot
/// be found.
Fault check_wheel_orientation(std::int32_t count, const double* y, const double* z) {
  constexpr double flange_least = 0.015;  // flanges are 26..36 mm high, treads fall by 4 mm
  constexpr double datum_most = 0.010;    // treads wear hollow by a few millimetres
  const auto [least, most] = std::minmax_element(z, z + count);
  if (*most - *least < flange_least) return {};
  const double mean = mean_height(count, y, z);
  const bool upside_down = mean - *least > *most - mean;
  const auto flange = static_cast<std::int32_t>((upside_down ? least : most) - z);
  if (upside_down) {
    return Fault::profile({"wheel profile z", flange}, {z[flange], "m"},
                          "the flange points up: z must point down; change the sign of all z");
  }
  if (y[flange] > 0.5 * (y[0] + y[count - 1])) {
    return Fault::profile(
        {"wheel profile y", flange}, {y[flange], "m"},
        "the flange is on the field side: the profile is a rail's, or mirrored: turn the sign of y and the "
        "order of the points");
  }
  const double* after = std::lower_bound(y, y + count, 0.0);
  if (after == y + count || y[0] > 0.0 || std::abs(z[after - y]) > datum_most) {
    const auto at = std::min(static_cast<std::int32_t>(after - y), count - 1);
    return Fault::profile({"wheel profile z", at}, {z[at], "m", -datum_most, datum_most},
                          "y = 0 must be at the running circle and z = 0 there: shift the profile");
  }
  return {};
}

/// Slopes of the natural cubic spline: the tridiagonal system
///   h_i m_{i-1} + 2 (h_{i-1} + h_i) m_i + h_{i-1} m_{i+1} = 3 (h_i d_{i-1} + h_{i-1} d_i),
/// h the spacings, d the chord slopes, with 2 m_0 + m_1 = 3 d_0 at the ends (zero curvature), by elimination.
void natural_slopes(std::int32_t count, const double* y, const double* z, double* scratch, double* slope) {
  const auto spacing = [&](std::int32_t i) { return y[i + 1] - y[i]; };
  const auto chord = [&](std::int32_t i) { return (z[i + 1] - z[i]) / spacing(i); };
  const std::int32_t last = count - 1;
  scratch[0] = 0.5;
  slope[0] = 1.5 * chord(0);
  for (std::int32_t i = 1; i <= last; ++i) {
    double below = 1.0, diagonal = 2.0, above = 0.0, right = 3.0 * chord(last - 1);
    if (i < last) {
      below = spacing(i);
      above = spacing(i - 1);
      diagonal = 2.0 * (below + above);
      right = 3.0 * (below * chord(i - 1) + above * chord(i));
    }
    const double pivot = diagonal - below * scratch[i - 1];
    scratch[i] = above / pivot;
    slope[i] = (right - below * slope[i - 1]) / pivot;
  }
  for (std::int32_t i = last - 1; i >= 0; --i) slope[i] -= scratch[i] * slope[i + 1];
}

}  // namespace

Fault check_points(ProfileBody body, std::int32_t count, const double* y, const double* z, double noise) {
  const Names name = names_of(body);
  if (count < 4) {
    return Fault::profile(name.points, {count, "points", 4.0, 1e6}, "a profile needs at least four points");
  }
  for (std::int32_t i = 0; i < count; ++i) {
    const bool y_bad = !std::isfinite(y[i]);
    if (y_bad || !std::isfinite(z[i])) {
      return Fault::not_finite({y_bad ? name.y : name.z, i}, {y_bad ? y[i] : z[i], "m"},
                               "a point is NaN or infinite");
    }
    const bool y_far = std::abs(y[i]) > profile_reach;
    if (y_far || std::abs(z[i]) > profile_reach) {
      return Fault::profile({y_far ? name.y : name.z, i},
                            {y_far ? y[i] : z[i], "m", -profile_reach, profile_reach},
                            "did you pass millimetres?");
    }
  }
  if (y[count - 1] < y[0]) {
    return Fault::profile({name.y, count - 1}, {y[count - 1], "m"},
                          "the points run from the field side inwards: reverse their order");
  }
  for (std::int32_t i = 1; i < count; ++i) {
    if (y[i] == y[i - 1] && (noise == 0.0 || z[i] == z[i - 1]))
      return Fault::profile({name.y, i}, {y[i], "m"}, "two neighbouring points have the same y");
    if (y[i] < y[i - 1] - noise) {
      return Fault::profile({name.y, i}, {y[i], "m"},
                            "the profile folds back or crosses itself: y must increase from point to point");
    }
    const double spacing = y[i] - y[i - 1];
    if ((noise == 0.0 && spacing < profile_spacing_least) || spacing > profile_spacing_most) {
      return Fault::profile({name.spacing, i}, {spacing, "m", profile_spacing_least, profile_spacing_most},
                            spacing > profile_spacing_most ? "points are missing before this one"
                                                           : "leave out one of the two points");
    }
  }
  const double width = y[count - 1] - y[0];
  if (width < profile_width_least || width > profile_width_most) {
    return Fault::profile(
        name.points, {width, "m", profile_width_least, profile_width_most},
        width < profile_width_least
            ? "the profile is too short, this is its width: are its points in the unit expected?"
            : "the profile is too long, this is its width: are its points in millimetres?");
  }
  if (const Fault fault = check_steps(body, count, y, z); fault.failed()) return fault;
  return body == ProfileBody::rail ? check_rail_orientation(count, y, z)
                                   : check_wheel_orientation(count, y, z);
}

Fault spline_through(ProfileBody body, std::int32_t count, const double* y, const double* z, double* scratch,
                     const ProfileMemory& memory, Profile& profile) {
  if (const Fault fault = check_points(body, count, y, z); fault.failed()) return fault;
  if (memory.capacity < count) return too_few_nodes(memory.capacity, count);
  std::copy(y, y + count, memory.y);
  std::copy(z, z + count, memory.z);
  natural_slopes(count, memory.y, memory.z, scratch, memory.slope);
  profile = profile_in(memory, count);
  return {};
}

}  // namespace wrc::geometry
