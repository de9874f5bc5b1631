#include "surface/geometry/varying_rail.hpp"

#include <algorithm>
#include <cmath>

#include "base/cutter.hpp"
#include "base/number.hpp"
#include "surface/simd/tasks.hpp"

namespace wrc {
namespace {

constexpr double faces_apart = 1.0;          // [m] of arc length
constexpr std::int32_t width_samples = 512;  // of an outline, where the widths wanted are looked at
constexpr double largest_stretch = 8.0;      // of an outline's part against that it is paired with
constexpr double least_cosine = 0.5;         // between the tangents of points that are paired

/// A cubic that rises through its knots (Fritsch and Carlson, SIAM J. Numer. Anal. 17 (1980) 238-246, with
/// harmonic means for slopes): length along a section's outline over that along the first one's.
struct Pairing {
  static constexpr std::int32_t most = most_rail_marks + 2;
  std::int32_t knots = 0;
  double u[most] = {}, s[most] = {}, slope[most] = {};

  void find_slopes() {
    const auto secant = [&](std::int32_t i) { return (s[i + 1] - s[i]) / (u[i + 1] - u[i]); };
    slope[0] = secant(0);
    slope[knots - 1] = secant(knots - 2);
    for (std::int32_t i = 1; i + 1 < knots; ++i) {
      const double before = secant(i - 1), behind = secant(i);
      slope[i] = 2.0 * before * behind / (before + behind);
    }
  }
  /// Length and its derivative.
  void at(double x, double& length, double& growth) const {
    std::int32_t i = 0;
    while (i + 2 < knots && x > u[i + 1]) ++i;
    const double h = u[i + 1] - u[i], t = std::clamp((x - u[i]) / h, 0.0, 1.0);
    const double d = s[i + 1] - s[i], a = h * slope[i], b = h * slope[i + 1];
    length = s[i] + t * (a + t * (3.0 * d - 2.0 * a - b + t * (a + b - 2.0 * d)));
    growth = (a + t * (2.0 * (3.0 * d - 2.0 * a - b) + t * 3.0 * (a + b - 2.0 * d))) / h;
  }
};

/// Lengths along a section's outline at its marks.
Fault find_marks(const RailSection& section, std::int32_t index, const Curve& curve, double cosine,
                 double sine, double (&length)[most_rail_marks]) {
  const auto own_y = [&](double s) {
    const std::int32_t k = piece_of(curve, s);
    const CurvePoint p = evaluate(curve, k, s - curve.s[k]);
    return cosine * (p.y - section.y) - sine * (p.z - section.z);
  };
  double before = 0.0;
  for (std::int32_t m = 0; m < section.marks; ++m) {
    double low = 0.0, high = curve.s[curve.pieces];
    if (!(section.mark[m] > own_y(low) && section.mark[m] < own_y(high)))
      return Fault::profile({"config.rail_section.mark", index}, {section.mark[m], "m"},
                            "a mark lies between the ends of its profile");
    for (int n = 0; n < 60; ++n) {
      const double middle = 0.5 * (low + high);
      (own_y(middle) < section.mark[m] ? low : high) = middle;
    }
    constexpr double nearest = 1e-3;
    if (!(low > before + nearest && low < curve.s[curve.pieces] - nearest))
      return Fault::profile({"config.rail_section.mark", index}, {section.mark[m], "m"},
                            "marks increase, further than 1 mm from each other and from the ends");
    length[m] = before = low;
  }
  return {};
}

/// Memory while sections are read.
struct Reading {
  double *y, *z, *curve;
};

/// The outline of a section in the rail's axes.
Fault read_outline(const RailSection& section, std::int32_t index, double cosine, double sine,
                   const Reading& memory, Curve& curve) {
  for (std::int32_t i = 0; i < section.profile.count; ++i) {
    const double y = section.profile.y[i], z = section.profile.z[i];
    memory.y[i] = section.y + cosine * y + sine * z;
    memory.z[i] = section.z + cosine * z - sine * y;
  }
  Fault fault = make_curve(section.profile.count, memory.y, memory.z, memory.curve, curve);
  if (fault.failed()) {
    fault.index = index;
    fault.field = "config.rail_section.profile";
  }
  return fault;
}

Fault pair_with_first(const RailSection& section, std::int32_t index, const Curve& curve, double cosine,
                      double sine, Pairing& pairing, bool first) {
  double length[most_rail_marks] = {};
  const Fault fault = find_marks(section, index, curve, cosine, sine, length);
  if (fault.failed()) return fault;
  pairing.knots = section.marks + 2;
  const auto knot = [&](std::int32_t i) {
    return i == 0 ? 0.0 : i <= section.marks ? length[i - 1] : curve.s[curve.pieces];
  };
  for (std::int32_t i = 0; i < pairing.knots; ++i) {
    if (first) pairing.u[i] = knot(i);
    pairing.s[i] = knot(i);
    if (i == 0) continue;
    const double stretch = (pairing.s[i] - pairing.s[i - 1]) / (pairing.u[i] - pairing.u[i - 1]);
    if (!(stretch < largest_stretch && stretch > 1.0 / largest_stretch))
      return Fault::profile(
          {"config.rail_section: length between marks or ends over that of the first, of section", index},
          {stretch, ""}, "these profiles cannot be paired: do they end at the same places?");
  }
  pairing.find_slopes();
  return {};
}

double dot(const double* a, const double* b, std::int32_t first, std::int32_t n, std::int32_t room) {
  double sum = 0.0;
  for (std::int32_t q = 0; q < 2; ++q)
    for (std::int32_t j = first; j < first + n; ++j) sum += a[q * room + j] * b[q * room + j];
  return sum;
}

/// How the outlines change along the track at a face's sections.
void find_slopes(const VaryingRail& rail, const RailFace& face, double* outline, double* before,
                 double* behind) {
  const std::int32_t room = rail.room;
  const auto lists = [&](std::int32_t k) { return outline + static_cast<std::int64_t>(k) * 8 * room; };
  const auto secant = [&](std::int32_t k, double* to) {
    const double per = 1.0 / (rail.distance[k + 1] - rail.distance[k]);
    for (std::int32_t q = 0; q < 4; ++q)
      for (std::int32_t j = face.first; j < face.first + face.strips; ++j)
        to[q * room + j] = (lists(k + 1)[q * room + j] - lists(k)[q * room + j]) * per;
  };
  const std::int32_t end = face.first_section + face.sections;
  for (std::int32_t k = face.first_section; k < end; ++k) {
    double* const slope = lists(k) + 4 * static_cast<std::int64_t>(room);
    std::fill_n(slope, 4 * static_cast<std::int64_t>(room), 0.0);
    if (k == face.first_section || k + 1 == end) continue;
    secant(k - 1, before);
    secant(k, behind);
    const double both = dot(before, behind, face.first, face.strips, room);
    const double each = dot(before, before, face.first, face.strips, room) +
                        dot(behind, behind, face.first, face.strips, room);
    if (!(both > 0.0)) continue;
    const double left = rail.distance[k] - rail.distance[k - 1],
                 right = rail.distance[k + 1] - rail.distance[k], agree = 2.0 * both / each;
    for (std::int32_t q = 0; q < 4; ++q)
      for (std::int32_t j = face.first; j < face.first + face.strips; ++j)
        slope[q * room + j] =
            agree * (right * before[q * room + j] + left * behind[q * room + j]) / (left + right);
  }
}

/// Points that are paired must face the same way, else strips between them would have no direction.
Fault check_directions(const VaryingRail& rail, const RailFace& face, const double* outline) {
  for (std::int32_t k = face.first_section; k + 1 < face.first_section + face.sections; ++k) {
    const double* const a = outline + static_cast<std::int64_t>(k) * 8 * rail.room;
    const double* const b = a + 8 * static_cast<std::int64_t>(rail.room);
    for (std::int32_t j = face.first; j < face.first + face.strips; ++j) {
      const double ay = a[2 * rail.room + j], az = a[3 * rail.room + j], by = b[2 * rail.room + j],
                   bz = b[3 * rail.room + j];
      const double cosine = (ay * by + az * bz) / std::sqrt((ay * ay + az * az) * (by * by + bz * bz));
      if (!(cosine > least_cosine))
        return Fault::profile(
            {"config.rail_section: cosine between the surfaces of the one before and of section", k + 1},
            {cosine, ""}, "points that differ so much are no pair: give marks, or a section between them");
    }
  }
  return {};
}

}  // namespace

std::int64_t varying_rail_doubles(std::int32_t sections, std::int32_t nodes, std::int32_t most_strips) {
  return static_cast<std::int64_t>(sections) * (8 * most_strips + 1) + 9 * most_strips + width_samples +
         2 * static_cast<std::int64_t>(nodes) + curve_doubles(nodes);
}

Fault make_varying_rail(const RailSection* sections, std::int32_t count, double inclination,
                        std::int32_t most_strips, double* memory, VaryingRail& rail) {
  rail = {};
  rail.room = most_strips;
  Cutter take{memory};
  double* const distance = take(count);
  double* const outline = take(static_cast<std::int64_t>(count) * 8 * most_strips);
  double* const step = take(most_strips);
  double* const wanted = take(width_samples);
  double *const before = take(4 * static_cast<std::int64_t>(most_strips)), *const behind = take(
                                                                               4 * static_cast<std::int64_t>(
                                                                                       most_strips));
  std::int32_t nodes = 0;
  for (std::int32_t k = 0; k < count; ++k) nodes = std::max(nodes, sections[k].profile.count);
  const Reading reading{take(nodes), take(nodes), take(curve_doubles(nodes))};
  rail.distance = distance;
  rail.outline = outline;
  rail.step = step;
  const double cosine = 1.0 / std::sqrt(1.0 + inclination * inclination), sine = inclination * cosine;

  std::int32_t faces = 0;
  for (std::int32_t k = 0; k < count; ++k) {
    distance[k] = sections[k].distance;
    if (k == 0 || sections[k].face != sections[k - 1].face) rail.face[faces++].first_section = k;
    ++rail.face[faces - 1].sections;
    rail.begin = k == 0 ? distance[k] : std::min(rail.begin, distance[k]);
    rail.end = k == 0 ? distance[k] : std::max(rail.end, distance[k]);
  }
  rail.faces = faces;
  for (std::int32_t f = 0; f < faces; ++f) {
    RailFace& face = rail.face[f];
    // one strip between faces belongs to none, so that strips of different faces are never neighbours
    face.first = f == 0 ? 0 : rail.strips + 1;
    const std::int32_t begin = face.first_section, end = begin + face.sections;
    Pairing pairing;
    Curve curve;
    double length = 0.0;
    const StripWidths widths = f + 1 < faces ? guiding_widths : StripWidths{};
    for (std::int32_t k = begin; k < end; ++k) {
      Fault fault = read_outline(sections[k], k, cosine, sine, reading, curve);
      if (fault.failed()) return fault;
      fault = pair_with_first(sections[k], k, curve, cosine, sine, pairing, k == begin);
      if (fault.failed()) return fault;
      if (k == begin) length = curve.s[curve.pieces];
      for (std::int32_t i = 0; i < width_samples; ++i) {
        double s, growth;
        pairing.at(length * i / (width_samples - 1), s, growth);
        const double here = wanted_width(curve, widths, s) / growth;
        wanted[i] = k == begin ? here : std::min(wanted[i], here);
      }
    }
    const auto wanted_at = [&](double u) {
      const double place = std::clamp(u / length, 0.0, 1.0) * (width_samples - 1);
      const auto i = std::min(static_cast<std::int32_t>(place), width_samples - 2);
      return wanted[i] + (place - i) * (wanted[i + 1] - wanted[i]);
    };
    double* const middle = before;  // free as yet
    const std::int32_t share = most_strips / faces - 1;
    face.strips = cut_length(0.0, length, wanted_at, share, middle, step + face.first);
    rail.strips = face.first + face.strips;
    for (std::int32_t k = begin; k < end; ++k) {
      Fault fault = read_outline(sections[k], k, cosine, sine, reading, curve);
      if (!fault.failed()) fault = pair_with_first(sections[k], k, curve, cosine, sine, pairing, k == begin);
      if (fault.failed()) return fault;
      double* const list = outline + static_cast<std::int64_t>(k) * 8 * most_strips;
      for (std::int32_t j = 0; j < face.strips; ++j) {
        double s, growth;
        pairing.at(middle[j], s, growth);
        const std::int32_t piece = piece_of(curve, s);
        const CurvePoint p = evaluate(curve, piece, s - curve.s[piece]);
        const std::int32_t to = face.first + j;
        list[to] = p.y;
        list[most_strips + to] = p.z;
        list[2 * most_strips + to] = p.dy * growth;
        list[3 * most_strips + to] = p.dz * growth;
      }
    }
    const Fault fault = check_directions(rail, face, outline);
    if (fault.failed()) return fault;
    find_slopes(rail, face, outline, before, behind);
  }
  return {};
}

namespace {

/// Between two sections.
SectionBlend blend_between(const VaryingRail& rail, std::int32_t left, double distance) {
  SectionBlend b;
  b.left = left;
  b.right = left + 1;
  const double h = rail.distance[left + 1] - rail.distance[left], per = 1.0 / h,
               t = (distance - rail.distance[left]) * per;
  const double t2 = t * t;
  const double up[4] = {t2 * t * (10.0 + t * (6.0 * t - 15.0)), 30.0 * t2 * (1.0 + t * (t - 2.0)) * per,
                        60.0 * t * (1.0 + t * (2.0 * t - 3.0)) * per * per,
                        60.0 * (1.0 + 6.0 * t * (t - 1.0)) * per * per * per};
  const double leaving[4] = {
      t * (1.0 + t2 * (t * (8.0 - 3.0 * t) - 6.0)) * h, 1.0 + t2 * (t * (32.0 - 15.0 * t) - 18.0),
      t * (t * (96.0 - 60.0 * t) - 36.0) * per, (t * (192.0 - 180.0 * t) - 36.0) * per * per};
  const double reaching[4] = {t2 * t * (t * (7.0 - 3.0 * t) - 4.0) * h, t2 * (t * (28.0 - 15.0 * t) - 12.0),
                              t * (t * (84.0 - 60.0 * t) - 24.0) * per,
                              (t * (168.0 - 180.0 * t) - 24.0) * per * per};
  for (int d = 0; d < 4; ++d) {
    b.weight[d][0] = (d == 0 ? 1.0 : 0.0) - up[d];
    b.weight[d][1] = up[d];
    b.weight[d][2] = leaving[d];
    b.weight[d][3] = reaching[d];
  }
  return b;
}

}  // namespace

SectionBlend blend_at(const VaryingRail& rail, const RailFace& face, double distance) {
  const double *const begin = rail.distance + face.first_section, *const end = begin + face.sections;
  const double* const above = std::upper_bound(begin, end, distance);
  if (above != begin && above != end)
    return blend_between(rail, static_cast<std::int32_t>(above - rail.distance) - 1, distance);
  SectionBlend b{};  // beyond its sections, or at the last one
  b.left = b.right = face.first_section + (above == begin ? 0 : face.sections - 1);
  b.weight[0][0] = 1.0;
  return b;
}

SectionBlend blend_at(const VaryingRail& rail, const RailFace& face, double distance,
                      const SectionBlend& near) {
  const bool there =
      near.left < near.right && distance >= rail.distance[near.left] && distance < rail.distance[near.right];
  return there ? blend_between(rail, near.left, distance) : blend_at(rail, face, distance);
}

double place_strips(const Kernels& kernels, const VaryingRail& rail, double distance, double* memory,
                    std::int32_t most, RailStrips& strips, SectionBlend (&blend)[most_rail_faces]) {
  double *const s = memory, *const width = s + most, *const y = width + most, *const z = y + most,
                *const ty = z + most, *const tz = ty + most;
  strips = {rail.strips, s, width, y, z, ty, tz, nullptr, 0, {}};
  double steepest = 0.0;
  for (std::int32_t f = 0; f < rail.faces; ++f) {
    const RailFace& face = rail.face[f];
    const std::int32_t first = face.first, end = first + face.strips;
    const SectionBlend& b = blend[f] = blend_at(rail, face, distance);
    if (distance < rail.distance[face.first_section] ||
        distance > rail.distance[face.first_section + face.sections - 1])
      continue;
    const auto lists = [&](std::int32_t section) {
      return rail.outline + static_cast<std::int64_t>(section) * 8 * rail.room + first;
    };
    constexpr double within = 20e-3;  // [m]
    const simd::SectionStripsTask task{face.strips, lists(b.left),     lists(b.right), rail.room,
                                       b.weight,    rail.step + first, within,         y + first,
                                       z + first,   ty + first,        tz + first,     width + first};
    steepest = std::max(steepest, kernels.surface.section_strips(task));
    double at = faces_apart * f;
    for (std::int32_t j = first; j < end; ++j) {
      s[j] = at + 0.5 * width[j];
      at += width[j];
    }
    strips.range[strips.ranges++] = range_of(strips, first, face.strips);
  }
  return steepest;
}

Fault place_strips(const Kernels& kernels, const VaryingRail& rail, double* memory, std::int32_t most,
                   double& distance, RailStrips& strips, SectionBlend (&blend)[most_rail_faces],
                   double& steepest) {
  const double asked = distance;
  distance = smaller(larger(asked, rail.begin), rail.end);
  steepest = place_strips(kernels, rail, distance, memory, most, strips, blend);
  if (has_check_rail(rail)) {
    // it guides with the side that faces the rail; rays of the other side meet the wheel through its body
    FaceStrips& check = strips.range[0];
    while (check.count > 1 && strips.tz[check.first] < 0.0) {
      ++check.first;
      --check.count;
    }
  }
  if (distance == asked) return {};
  return Fault::beyond_sections("input.distance", {asked, "m", rail.begin, rail.end},
                                "the nearest section is used");
}

}  // namespace wrc
