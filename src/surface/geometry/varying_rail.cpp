#include "surface/geometry/varying_rail.hpp"

#include <algorithm>
#include <cmath>

#include "base/number.hpp"
#include "surface/geometry/strip_gain.hpp"
#include "surface/simd/tasks.hpp"

namespace wrc::surface {
namespace {

constexpr double faces_apart = 1.0;          // [m] of arc length
constexpr std::int32_t width_samples = 512;  // along an outline, of the widths wanted
constexpr double largest_stretch = 8.0;      // length of a part over that of the part it is paired with
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
    // Hermite cubic on the interval and its derivative by x
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
  // each mark's length by bisection: y increases along an outline between its ends
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

/// The outline of a section in the rail's axes.
Fault read_outline(const RailSection& section, std::int32_t index, double cosine, double sine,
                   const VaryingRailArrays& a, Curve& curve) {
  for (std::int32_t i = 0; i < section.profile.count; ++i) {
    const double y = section.profile.y[i], z = section.profile.z[i];
    a.y[i] = section.y + cosine * y + sine * z;
    a.z[i] = section.z + cosine * z - sine * y;
  }
  Fault fault = make_curve(section.profile.count, a.y, a.z, a.curve, curve);
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
  // knots at the outline's ends and marks; the parts between two knots may differ in length, but not by much
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

/// The lists of a section: y, z, dy/du, dz/du, and how they change along the track.
double* lists_of(const VaryingRail& rail, double* outline, std::int32_t section) {
  return outline + static_cast<std::int64_t>(section) * 8 * rail.stride;
}

/// Slopes of the outlines along the track at a face's sections; `before`, `behind`: scratch of four lists.
void find_slopes(const VaryingRail& rail, const RailFace& face, double* outline, double* before,
                 double* behind) {
  const std::int32_t stride = rail.stride, first = face.first, last = face.first + face.strips;
  const auto secant = [&](std::int32_t k, double* to) {
    const double per = 1.0 / (rail.distance[k + 1] - rail.distance[k]);
    const double *const here = lists_of(rail, outline, k), *const next = lists_of(rail, outline, k + 1);
    for (std::int32_t q = 0; q < 4; ++q)
      for (std::int32_t j = first; j < last; ++j)
        to[q * stride + j] = (next[q * stride + j] - here[q * stride + j]) * per;
  };
  // a.b over the points of a whole outline
  const auto dot = [&](const double* a, const double* b) {
    double sum = 0.0;
    for (std::int32_t q = 0; q < 2; ++q)
      for (std::int32_t j = first; j < last; ++j) sum += a[q * stride + j] * b[q * stride + j];
    return sum;
  };
  const std::int32_t end = face.first_section + face.sections;
  for (std::int32_t k = face.first_section; k < end; ++k) {
    // at the face's first and last section that of the secant, at the whole rail's zero
    double* const slope = lists_of(rail, outline, k) + 4 * static_cast<std::int64_t>(stride);
    std::fill_n(slope, 4 * static_cast<std::int64_t>(stride), 0.0);
    if (k == face.first_section || k + 1 == end) {
      const bool goes_on = rail.distance[k] == rail.begin || rail.distance[k] == rail.end;
      if (!goes_on && face.sections > 1) secant(k == face.first_section ? k : k - 1, slope);
      continue;
    }
    // 2 a.b / (a.a + b.b) times the mean of the secants a, b, the shorter interval's weighing more
    secant(k - 1, before);
    secant(k, behind);
    const double both = dot(before, behind), each = dot(before, before) + dot(behind, behind);
    if (!(both > 0.0)) continue;
    const double left = rail.distance[k] - rail.distance[k - 1],
                 right = rail.distance[k + 1] - rail.distance[k], agree = 2.0 * both / each;
    for (std::int32_t q = 0; q < 4; ++q)
      for (std::int32_t j = first; j < last; ++j)
        slope[q * stride + j] =
            agree * (right * before[q * stride + j] + left * behind[q * stride + j]) / (left + right);
  }
}

/// Points that are paired must face the same way, else strips between them would have no direction.
Fault check_directions(const VaryingRail& rail, const RailFace& face, const double* outline) {
  for (std::int32_t k = face.first_section; k + 1 < face.first_section + face.sections; ++k) {
    const double* const a = outline + static_cast<std::int64_t>(k) * 8 * rail.stride;
    const double* const b = a + 8 * static_cast<std::int64_t>(rail.stride);
    for (std::int32_t j = face.first; j < face.first + face.strips; ++j) {
      const double ay = a[2 * rail.stride + j], az = a[3 * rail.stride + j], by = b[2 * rail.stride + j],
                   bz = b[3 * rail.stride + j];
      const double cosine = (ay * by + az * bz) / std::sqrt((ay * ay + az * az) * (by * by + bz * bz));
      if (!(cosine > least_cosine))
        return Fault::profile(
            {"config.rail_section: cosine between the surfaces of the one before and of section", k + 1},
            {cosine, ""}, "points that differ so much are no pair: give marks, or a section between them");
    }
  }
  return {};
}

/// Do a face's sections differ from one another?
bool sections_differ(const VaryingRail& rail, const RailFace& face, const double* outline) {
  constexpr double same = 1e-12;  // [m]
  const std::int64_t section = 8 * static_cast<std::int64_t>(rail.stride);
  const double* const begin = outline + face.first_section * section;
  for (std::int32_t k = 1; k < face.sections; ++k)
    for (std::int32_t q = 0; q < 2; ++q)
      for (std::int32_t j = face.first; j < face.first + face.strips; ++j) {
        const std::int64_t at = q * rail.stride + j;
        if (std::abs(begin[k * section + at] - begin[at]) > same) return true;
      }
  return false;
}

/// The valleys between a face's sections, at places between them.
void find_valleys(const VaryingRail& rail, const RailFace& face, double* valley) {
  constexpr int places = 8;
  for (std::int32_t k = face.first_section; k + 1 < face.first_section + face.sections; ++k) {
    const double* const here = rail.outline + static_cast<std::int64_t>(k) * 8 * rail.stride;
    // the largest at places between the sections
    double* const behind = valley + static_cast<std::int64_t>(k) * valleys_of_section(rail.stride);
    for (int n = 1; n < places; ++n) {
      const double at = rail.distance[k] + (rail.distance[k + 1] - rail.distance[k]) * n / places;
      const SectionBlend blend = blend_at(rail, face, at, 2);
      for (std::int32_t j = face.first; j < face.first + face.strips; ++j) {
        // n.P'' of the normal (-dz/du, dy/du) at the section before
        const double dy = here[2 * rail.stride + j], dz = here[3 * rail.stride + j];
        const double bent = dy * blended(rail, blend, j, 1).f[2] - dz * blended(rail, blend, j, 0).f[2];
        double& sharpest = behind[eight_of(j)];
        sharpest = larger(sharpest, -bent / std::sqrt(dy * dy + dz * dz));
      }
    }
    for (std::int32_t e = 0; e < eights(rail.stride); ++e)
      behind[sharpest_of_face(rail)] = larger(behind[sharpest_of_face(rail)], behind[e]);
  }
}

/// Puts the sections into faces, and notes their distances.
void take_sections(const RailSection* sections, std::int32_t count, double* distance, VaryingRail& rail) {
  // sections of one face stand together, by increasing distance
  std::int32_t faces = 0;
  for (std::int32_t k = 0; k < count; ++k) {
    distance[k] = sections[k].distance;
    if (k == 0 || sections[k].face != sections[k - 1].face) rail.face[faces++].first_section = k;
    ++rail.face[faces - 1].sections;
    rail.begin = k == 0 ? distance[k] : std::min(rail.begin, distance[k]);
    rail.end = k == 0 ? distance[k] : std::max(rail.end, distance[k]);
  }
  rail.faces = faces;
}

/// Sections on their way to strips.
struct SectionReader {
  const RailSection* sections;
  double cosine, sine;  ///< inclination of the rail
  const VaryingRailArrays& arrays;
  Curve curve;      ///< outline of the section read last
  Pairing pairing;  ///< lengths along it over those along the first of its face

  Fault read(std::int32_t k, bool first) {
    const Fault fault = read_outline(sections[k], k, cosine, sine, arrays, curve);
    return fault.failed() ? fault : pair_with_first(sections[k], k, curve, cosine, sine, pairing, first);
  }
};

/// Widths that the strips of a face may have, sampled over the first section's outline: the narrowest that
/// any section wants there. `length`: of that outline [m].
Fault find_widths(SectionReader& reader, const RailFace& face, const StripWidths& widths, double* wanted,
                  double& length) {
  const std::int32_t begin = face.first_section;
  for (std::int32_t k = begin; k < begin + face.sections; ++k) {
    const Fault fault = reader.read(k, k == begin);
    if (fault.failed()) return fault;
    if (k == begin) length = reader.curve.s[reader.curve.pieces];
    for (std::int32_t i = 0; i < width_samples; ++i) {
      // a width on this section is narrower by ds/du on the first one
      double s, growth;
      reader.pairing.at(length * i / (width_samples - 1), s, growth);
      const double here = wanted_width(reader.curve, widths, s) / growth;
      wanted[i] = k == begin ? here : std::min(wanted[i], here);
    }
  }
  return {};
}

/// Points and tangents P(u), P'(u) of a face's sections in the middles of its strips.
Fault lay_outlines(SectionReader& reader, const VaryingRail& rail, const RailFace& face,
                   const VaryingRailArrays& a) {
  const std::int32_t begin = face.first_section, stride = rail.stride;
  for (std::int32_t k = begin; k < begin + face.sections; ++k) {
    const Fault fault = reader.read(k, k == begin);
    if (fault.failed()) return fault;
    double* const list = lists_of(rail, a.outline, k);
    for (std::int32_t j = 0; j < face.strips; ++j) {
      // P(u) at the length s(u) along this outline, and P'(u) = dP/ds ds/du
      double s, growth;
      reader.pairing.at(a.middle[j], s, growth);
      const std::int32_t piece = piece_of(reader.curve, s), to = face.first + j;
      const CurvePoint p = evaluate(reader.curve, piece, s - reader.curve.s[piece]);
      list[to] = p.y;
      list[stride + to] = p.z;
      list[2 * stride + to] = p.dy * growth;
      list[3 * stride + to] = p.dz * growth;
    }
  }
  return {};
}

}  // namespace

VaryingRailArrays cut_varying_rail(Arena& arena, std::int32_t sections, std::int32_t nodes,
                                   std::int32_t most_strips) {
  VaryingRailArrays a;
  a.distance = arena.take(sections);
  a.valley = arena.take(static_cast<std::int64_t>(sections) * valleys_of_section(most_strips));
  a.outline = arena.take(static_cast<std::int64_t>(sections) * 8 * most_strips);
  arena.each(most_strips, a.step, a.middle);
  a.wanted = arena.take(width_samples);
  arena.each(4 * static_cast<std::int64_t>(most_strips), a.before, a.behind);
  arena.each(nodes, a.y, a.z);
  a.curve = cut_curve(arena, nodes);
  return a;
}

Fault make_varying_rail(const RailSection* sections, std::int32_t count, double inclination,
                        const StripWidths& widths, std::int32_t most_strips, const VaryingRailArrays& a,
                        VaryingRail& rail) {
  rail = {};
  rail.stride = most_strips;
  rail.distance = a.distance;
  rail.outline = a.outline;
  rail.step = a.step;
  rail.valley = a.valley;
  std::fill_n(a.valley, static_cast<std::int64_t>(count) * valleys_of_section(rail.stride), 0.0);
  take_sections(sections, count, a.distance, rail);
  const double cosine = 1.0 / std::sqrt(1.0 + inclination * inclination), sine = inclination * cosine;
  for (std::int32_t f = 0; f < rail.faces; ++f) {
    RailFace& face = rail.face[f];
    // one strip between faces belongs to none, so that strips of different faces are never neighbours
    face.first = f == 0 ? 0 : rail.strips + 1;
    // strips along u by the widths wanted, linear between their samples; a share of all strips for each face
    SectionReader reader{sections, cosine, sine, a, {}, {}};
    double length = 0.0;
    StripWidths of_face = widths;
    if (f + 1 < rail.faces) of_face.guiding = guiding_width;
    Fault fault = find_widths(reader, face, of_face, a.wanted, length);
    if (fault.failed()) return fault;
    const auto wanted_at = [&](double u) {
      const double place = std::clamp(u / length, 0.0, 1.0) * (width_samples - 1);
      const auto i = std::min(static_cast<std::int32_t>(place), width_samples - 2);
      return a.wanted[i] + (place - i) * (a.wanted[i + 1] - a.wanted[i]);
    };
    const std::int32_t share = most_strips / rail.faces - 1;
    face.strips = cut_length(0.0, length, wanted_at, share, a.middle, a.step + face.first);
    rail.strips = face.first + face.strips;
    // outlines at the strips' middles, and how they change from section to section
    fault = lay_outlines(reader, rail, face, a);
    if (!fault.failed()) fault = check_directions(rail, face, a.outline);
    if (fault.failed()) return fault;
    find_slopes(rail, face, a.outline, a.before, a.behind);
    find_valleys(rail, face, a.valley);
    const bool ends = rail.distance[face.first_section] > rail.begin ||
                      rail.distance[face.first_section + face.sections - 1] < rail.end;
    face.changes = ends || sections_differ(rail, face, a.outline);
  }
  return {};
}

namespace {

/// Between two sections, with so many of the derivatives' weights.
SectionBlend blend_between(const VaryingRail& rail, std::int32_t left, double distance, int derivatives) {
  SectionBlend b{};
  b.left = left;
  b.right = left + 1;
  const double apart = rail.distance[left + 1] - rail.distance[left], per = 1.0 / apart,
               t = (distance - rail.distance[left]) * per;
  const auto put = [&b](int d, const SectionWeights<double>& w) {
    b.weight[d][0] = (d == 0 ? 1.0 : 0.0) - w.up;
    b.weight[d][1] = w.up;
    b.weight[d][2] = w.leaving;
    b.weight[d][3] = w.reaching;
  };
  put(0, value_weights(t, apart));
  if (derivatives < 1) return b;
  put(1, slope_weights(t, per));
  put(2, curvature_weights(t, per));
  if (derivatives < 3) return b;
  put(3, {60.0 * (1.0 + 6.0 * t * (t - 1.0)) * per * per * per, (t * (192.0 - 180.0 * t) - 36.0) * per * per,
          (t * (168.0 - 180.0 * t) - 24.0) * per * per});
  return b;
}

}  // namespace

SectionBlend blend_at(const VaryingRail& rail, const RailFace& face, double distance, int derivatives) {
  // the interval of sections that holds the distance
  const double *const begin = rail.distance + face.first_section, *const end = begin + face.sections;
  const double* const above = std::upper_bound(begin, end, distance);
  if (above != begin && above != end)
    return blend_between(rail, static_cast<std::int32_t>(above - rail.distance) - 1, distance, derivatives);
  SectionBlend b{};  // beyond its sections, or at the last one
  b.left = b.right = face.first_section + (above == begin ? 0 : face.sections - 1);
  b.weight[0][0] = 1.0;
  return b;
}

SectionBlend blend_at(const VaryingRail& rail, const RailFace& face, double distance,
                      const SectionBlend& near, int derivatives) {
  const bool there =
      near.left < near.right && distance >= rail.distance[near.left] && distance < rail.distance[near.right];
  return there ? blend_between(rail, near.left, distance, derivatives)
               : blend_at(rail, face, distance, derivatives);
}

PlaceWeights place_at(const VaryingRail& rail, const RailFace& face, double distance, double x) {
  const SectionBlend b = blend_at(rail, face, distance + x, 0);
  PlaceWeights place{x, b.left, b.right, {}};
  std::copy_n(b.weight[0], 4, place.weight);
  return place;
}

namespace {

/// How far a face reaches to both sides along the track, and the places there.
void look_along_face(const VaryingRail& rail, std::int32_t f, PlacedRail& placed) {
  const RailFace& face = rail.face[f];
  const FaceExtent extent = extent_of(rail, face, placed.distance);
  placed.low[f] = larger(extent.begin, -farthest_along);
  placed.high[f] = smaller(extent.end, farthest_along);
  placed.valley[f] = valley_between(rail, face, sharpest_of_face(rail), placed.distance - farthest_along,
                                    placed.distance + farthest_along);
  for (std::int32_t k = 0; k < track_places; ++k) {
    placed.place[f][k] = place_at(rail, face, placed.distance, place_apart * (k - places_to_a_side));
  }
  placed.end[f][0] = place_at(rail, face, placed.distance, placed.low[f]);
  placed.end[f][1] = place_at(rail, face, placed.distance, placed.high[f]);
}

/// The most that a strip's overlap grows along the track, from the place `at` of its largest growth so far,
/// `most`: beyond the last place, as long as the overlap grows.
double gain_beyond(const VaryingRail& rail, std::int32_t f, double wheel_radius, const PlacedRail& placed,
                   std::int32_t j, double most, double at) {
  if (magnitude(at) < last_place || placed.ty[j] < steepest_far) return most;
  constexpr double apart = 2.0 * place_apart;  // [m]
  const double step = at < 0.0 ? -apart : apart;
  const StripBelowAxle<double> below{placed.y[j], placed.z[j], placed.ty[j], placed.tz[j]};
  for (double x = at + step; x > placed.low[f] && x < placed.high[f]; x += step) {
    const PlaceWeights place = place_at(rail, rail.face[f], placed.distance, x);
    const double here =
        gain_at<double>(below, x, place_of(rail, place, j, 0), place_of(rail, place, j, 1), wheel_radius);
    if (!(here > most)) break;
    most = here;
  }
  return most;
}

/// Gains of a face's strips: at every sixteenth strip, and the larger of two for those between.
void find_gains_of(const Kernels& kernels, const VaryingRail& rail, std::int32_t f, double wheel_radius,
                   const PlacedRail& placed, double* gain) {
  constexpr std::int32_t every = 16;
  const RailFace& face = rail.face[f];
  const std::int32_t end = face.first + face.strips, looks = (face.strips + every - 1) / every + 1;
  StripGains some;
  double before = 0.0;
  for (std::int32_t i = 0; i < looks; ++i) {
    const std::int32_t k = i % StripGains::most;
    if (k == 0) {
      some.count = std::min(looks - i, StripGains::most);
      for (std::int32_t n = 0; n < some.count; ++n)
        some.strip[n] = std::min(face.first + (i + n) * every, end - 1);
      kernels.surface.strip_gains({&rail, &placed, f, wheel_radius}, some);
    }
    const double here = gain_beyond(rail, f, wheel_radius, placed, some.strip[k], some.gain[k], some.at[k]);
    const std::int32_t j = face.first + (i - 1) * every;
    if (i > 0) std::fill(gain + j, gain + std::min(j + every, end), larger(before, here));
    before = here;
  }
}

}  // namespace

PlacedRail place_strips(const Kernels& kernels, const VaryingRail& rail, double distance,
                        const StripArrays& a) {
  PlacedRail placed;
  static_cast<RailStrips&>(placed) = {rail.strips, a.s, a.width, a.y, a.z, a.ty, a.tz, nullptr, 0, {}};
  placed.distance = distance;
  for (std::int32_t f = 0; f < rail.faces; ++f) {
    const RailFace& face = rail.face[f];
    const std::int32_t first = face.first, end = first + face.strips;
    const SectionBlend& b = placed.blend[f] = blend_at(rail, face, distance);
    // a face is there between its first and its last section, and as far as a wheel reaches beyond
    if (distance < rail.distance[face.first_section] - farthest_along ||
        distance > rail.distance[face.first_section + face.sections - 1] + farthest_along)
      continue;
    const auto lists = [&](std::int32_t section) {
      return rail.outline + static_cast<std::int64_t>(section) * 8 * rail.stride + first;
    };
    kernels.surface.section_strips({face.strips, lists(b.left), lists(b.right), rail.stride, b.weight,
                                    rail.step + first, a.y + first, a.z + first, a.ty + first, a.tz + first,
                                    a.width + first});
    look_along_face(rail, f, placed);
    // arc length by the widths there, each face from a place of its own
    double at = faces_apart * f;
    for (std::int32_t j = first; j < end; ++j) {
      a.s[j] = at + 0.5 * a.width[j];
      at += a.width[j];
    }
    placed.range[placed.ranges++] = range_of(placed, first, face.strips);
  }
  return placed;
}

void find_gains(const Kernels& kernels, const VaryingRail& rail, double wheel_radius,
                const PlacedRail& placed, double* gain) {
  std::fill_n(gain, placed.count, 0.0);
  for (std::int32_t r = 0; r < placed.ranges; ++r) {
    const std::int32_t face = face_of(rail, placed.range[r].first);
    if (rail.face[face].changes) find_gains_of(kernels, rail, face, wheel_radius, placed, gain);
  }
}

}  // namespace wrc::surface
