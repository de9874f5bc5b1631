#include "geometry/standard_profiles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "base/elementary.hpp"
#include "geometry/placement.hpp"

namespace wrc::geometry {
namespace {

constexpr double mm = 1e-3;

/// Value and derivatives in millimetres: the units of the standards' formulas.
ProfilePoint from_millimetres(const ProfilePoint& p) { return {p.z * mm, p.slope, p.second / mm}; }

template <std::size_t N>
ProfilePoint polynomial(const std::array<double, N>& coefficient, double s) {
  ProfilePoint p;
  for (std::size_t i = N; i-- > 0;) {
    p.second = p.second * s + 2.0 * p.slope;
    p.slope = p.slope * s + p.z;
    p.z = p.z * s + coefficient[i];
  }
  return p;
}

/// An arc z = z0 + sign sqrt(r^2 - (s - s0)^2): sign +1 is the lower half of the circle (z points down).
ProfilePoint arc(double s0, double z0, double radius, double sign, double s) {
  const double u = s - s0;
  const double height = std::sqrt(radius * radius - u * u);
  return {z0 + sign * height, -sign * u / height, -sign * radius * radius / (height * height * height)};
}

constexpr std::array<double, 9> tread_coefficients{0.0,
                                                   -3.358537058e-2,
                                                   1.565681624e-3,
                                                   -2.810427944e-5,
                                                   5.844240864e-8,
                                                   -1.562379023e-8,
                                                   5.309217349e-15,
                                                   -5.957839843e-12,
                                                   2.646656573e-13};
constexpr std::array<double, 8> root_coefficients{-4.320221063e3,  -1.038384026e3,  -1.065501873e2,
                                                  -6.051367875,    -2.054332446e-1, -4.169739389e-3,
                                                  -4.687195829e-5, -2.252755540e-7};

ProfilePoint s1002_chamfer(double s) { return {1.364323640 - 0.066666667 * s, -0.066666667, 0.0}; }
ProfilePoint s1002_tread(double s) { return polynomial(tread_coefficients, s); }
ProfilePoint s1002_root(double s) { return polynomial(root_coefficients, s); }
ProfilePoint s1002_root_arc(double s) { return arc(-26.210665, 16.446, 13.0, -1.0, s); }

/// Cubic that takes the standard's steps in value and slope at both ends of section C, to be added to it.
ProfilePoint s1002_root_correction(double s) {
  constexpr double from = -35.0, to = -26.0, length = to - from;
  const ProfilePoint low_wanted = s1002_root_arc(from), low = s1002_root(from);
  const ProfilePoint high_wanted = s1002_tread(to), high = s1002_root(to);
  const double z0 = low_wanted.z - low.z, m0 = low_wanted.slope - low.slope;
  const double z1 = high_wanted.z - high.z, m1 = high_wanted.slope - high.slope;
  const double u = s - from;
  const double chord = (z1 - z0) / length;
  const double c2 = (3.0 * chord - 2.0 * m0 - m1) / length;
  const double c3 = (m0 + m1 - 2.0 * chord) / (length * length);
  return {z0 + u * (m0 + u * (c2 + u * c3)), m0 + u * (2.0 * c2 + 3.0 * u * c3), 2.0 * c2 + 6.0 * u * c3};
}

/// S1002 in millimetres; sections A to H of theory 6.1, field side first.
ProfilePoint s1002_millimetres(double s) {
  if (s > 32.15796) return s1002_chamfer(s);
  if (s >= -26.0) return s1002_tread(s);
  if (s >= -35.0) {
    const ProfilePoint root = s1002_root(s), correction = s1002_root_correction(s);
    return {root.z + correction.z, root.slope + correction.slope, root.second + correction.second};
  }
  if (s >= -38.426669071) return s1002_root_arc(s);
  if (s >= -39.764473993) return {-93.576667419 - 2.747477419 * s, -2.747477419, 0.0};
  if (s >= -49.662510381) return arc(-58.558326413, 8.834924130, 20.0, 1.0, s);
  if (s >= -62.764705882) return arc(-55.0, 16.0, 12.0, 1.0, s);
  return arc(-49.5, 9.519259302, 20.5, 1.0, s);
}

/// A section of a sampled profile, divided uniformly in y or, on an arc, in t = asinh(slope): the angle
/// between neighbouring nodes then shrinks with the cosine of the slope angle, as the error of a Hermite
/// cubic in z(y) asks.
struct Section {
  double from, to;        ///< [m]
  std::int32_t pieces;    ///< Hermite pieces
  double centre, radius;  ///< arc [m]; radius 0: uniform in y
};

double section_y(const Section& section, std::int32_t i) {
  if (i == 0) return section.from;
  const double t = static_cast<double>(i) / static_cast<double>(section.pieces);
  if (section.radius == 0.0) return section.from + t * (section.to - section.from);
  // exp(2 artanh(u)) = (1 + u) / (1 - u) at u = (y - centre) / radius, and back.
  const double first = (section.from - section.centre) / section.radius;
  const double last = (section.to - section.centre) / section.radius;
  const double e_first = (1.0 + first) / (1.0 - first), e_last = (1.0 + last) / (1.0 - last);
  const double e = e_first * natural_exp(t * natural_log(e_last / e_first));
  return section.centre + section.radius * (e - 1.0) / (e + 1.0);
}

/// Nodes at the ends of every piece of every section; `curve(y)` gives value and slope.
template <std::size_t N, class Curve>
std::int32_t sample(const std::array<Section, N>& sections, const Curve& curve, const ProfileMemory& memory) {
  std::int32_t node = 0;
  const auto add = [&](double y) {
    const ProfilePoint point = curve(y);
    memory.y[node] = y;
    memory.z[node] = point.z;
    memory.slope[node] = point.slope;
    ++node;
  };
  for (const Section& section : sections) {
    for (std::int32_t i = 0; i < section.pieces; ++i) add(section_y(section, i));
  }
  add(sections.back().to);
  return node;
}

template <std::size_t N>
constexpr std::int32_t nodes_of(const std::array<Section, N>& sections) {
  std::int32_t pieces = 0;
  for (const Section& section : sections) pieces += section.pieces;
  return pieces + 1;
}

constexpr std::array<Section, 8> s1002_sections{{
    {s1002_first_y, -62.764705882 * mm, 30, -49.5 * mm, 20.5 * mm},
    {-62.764705882 * mm, -49.662510381 * mm, 30, -55.0 * mm, 12.0 * mm},
    {-49.662510381 * mm, -39.764473993 * mm, 60, -58.558326413 * mm, 20.0 * mm},
    {-39.764473993 * mm, -38.426669071 * mm, 2, 0.0, 0.0},
    {-38.426669071 * mm, -35.0 * mm, 28, -26.210665 * mm, 13.0 * mm},
    {-35.0 * mm, -26.0 * mm, 30, 0.0, 0.0},
    {-26.0 * mm, 32.15796 * mm, 70, 0.0, 0.0},
    {32.15796 * mm, s1002_last_y, 4, 0.0, 0.0},
}};
static_assert(nodes_of(s1002_sections) == s1002_nodes);

constexpr double crown_radius = 300.0 * mm, shoulder_radius = 80.0 * mm, corner_radius = 13.0 * mm;
constexpr double side_slope = 20.0;  ///< 1:20

}  // namespace

ProfilePoint s1002(double y) { return from_millimetres(s1002_millimetres(y / mm)); }
ProfilePoint s1002_flange_root_of_standard(double y) { return from_millimetres(s1002_root(y / mm)); }

double RailHead::crown_z() const {
  return crown_radius - std::sqrt(crown_radius * crown_radius - crown_half_width * crown_half_width);
}
double RailHead::shoulder_centre_y() const {
  return crown_half_width * (1.0 - shoulder_radius / crown_radius);
}
double RailHead::shoulder_centre_z() const {
  return crown_z() + (crown_radius - crown_z()) * shoulder_radius / crown_radius;
}
double RailHead::corner_centre_y() const {
  return shoulder_half_width + (shoulder_centre_y() - shoulder_half_width) * corner_radius / shoulder_radius;
}
double RailHead::corner_centre_z() const {
  const double u = shoulder_half_width - shoulder_centre_y();
  return shoulder_centre_z() -
         std::sqrt(shoulder_radius * shoulder_radius - u * u) * (1.0 - corner_radius / shoulder_radius);
}
double RailHead::side_y() const {
  return corner_centre_y() + corner_radius * side_slope / std::sqrt(1.0 + side_slope * side_slope);
}
double RailHead::side_z() const {
  return corner_centre_z() - corner_radius / std::sqrt(1.0 + side_slope * side_slope);
}

double rail_head_last_y(const RailHead& head) {
  return head.side_y() + (rail_side_depth - head.side_z()) / side_slope;
}

ProfilePoint rail_head(const RailHead& head, double y) {
  const double u = std::abs(y);
  ProfilePoint point;
  if (u <= head.crown_half_width) {
    point = arc(0.0, crown_radius, crown_radius, -1.0, u);
  } else if (u <= head.shoulder_half_width) {
    point = arc(head.shoulder_centre_y(), head.shoulder_centre_z(), shoulder_radius, -1.0, u);
  } else if (u < head.side_y()) {
    point = arc(head.corner_centre_y(), head.corner_centre_z(), corner_radius, -1.0, u);
  } else {
    point = {head.side_z() + side_slope * (u - head.side_y()), side_slope, 0.0};
  }
  if (y < 0.0) point.slope = -point.slope;
  return point;
}

Fault sample_s1002(const ProfileMemory& memory, Profile& profile) {
  if (memory.capacity < s1002_nodes) return too_few_nodes(memory.capacity, s1002_nodes);
  profile = profile_in(memory, sample(s1002_sections, s1002, memory));
  return {};
}

Fault sample_rail_head(const RailHead& head, const ProfileMemory& memory, Profile& profile) {
  if (memory.capacity < rail_head_nodes) return too_few_nodes(memory.capacity, rail_head_nodes);
  const double crown = head.crown_half_width, shoulder = head.shoulder_half_width;
  const double side = head.side_y(), last = rail_head_last_y(head);
  const std::array<Section, 7> sections{{
      {-last, -side, 2, 0.0, 0.0},
      {-side, -shoulder, 76, -head.corner_centre_y(), corner_radius},
      {-shoulder, -crown, 12, -head.shoulder_centre_y(), shoulder_radius},
      {-crown, crown, 12, 0.0, crown_radius},
      {crown, shoulder, 12, head.shoulder_centre_y(), shoulder_radius},
      {shoulder, side, 76, head.corner_centre_y(), corner_radius},
      {side, last, 2, 0.0, 0.0},
  }};
  profile = profile_in(memory, sample(
                                   sections, [&](double y) { return rail_head(head, y); }, memory));
  return {};
}

Fault sample_uic60_benchmark(const ProfileMemory& memory, Profile& profile) {
  std::array<double, profile_doubles(rail_head_nodes)> upright;
  Profile head;
  const ProfileMemory scratch = profile_memory(rail_head_nodes, upright.data());
  if (const Fault fault = sample_rail_head(rail_uic60_benchmark, scratch, head); fault.failed()) return fault;
  return place(
      head, Placement{.inclination = benchmark_inclination, .y = benchmark_crown_y, .z = benchmark_crown_z},
      memory, profile);
}

}  // namespace wrc::geometry
