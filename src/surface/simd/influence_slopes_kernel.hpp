/// Displacement of a point of the curved surface by strips of semi-elliptic pressure, with its derivatives by
/// their half lengths and by the point's place along x. The formulas are those of influence_kernel.hpp;
/// tables are linear in each interval, so the slope of the interval is the derivative of the number itself.
#pragma once

#include "surface/simd/influence_kernel.hpp"

namespace wrc::simd {
namespace {

namespace sloped {

/// A number and its derivative by the source's half length: it does not change with the point's x.
struct ByLength {
  Pack v, l;

  ByLength() = default;
  ByLength(Pack value, Pack by_length) : v(value), l(by_length) {}
  ByLength(double constant) : v(constant), l(0.0) {}  // NOLINT: constants mix freely

  friend ByLength operator+(double a, const ByLength& b) { return {a + b.v, b.l}; }
  friend ByLength operator-(double a, const ByLength& b) { return {a - b.v, -b.l}; }
  friend ByLength operator*(double a, const ByLength& b) { return {a * b.v, a * b.l}; }
  friend ByLength operator*(const ByLength& a, const ByLength& b) {
    return {a.v * b.v, a.l * b.v + a.v * b.l};
  }
  friend ByLength operator/(const ByLength& a, const ByLength& b) {
    const Pack inverse = 1.0 / b.v, q = a.v * inverse;
    return {q, (a.l - q * b.l) * inverse};
  }
};
inline ByLength select(Mask m, const ByLength& yes, const ByLength& no) {
  return {select(m, yes.v, no.v), select(m, yes.l, no.l)};
}

/// A number and its derivatives by the source's half length and by the point's x.
struct Sloped {
  Pack v, l, x;

  Sloped() = default;
  Sloped(Pack value, Pack by_length, Pack by_x) : v(value), l(by_length), x(by_x) {}
  Sloped(double constant) : v(constant), l(0.0), x(0.0) {}  // NOLINT: constants mix freely

  friend Sloped operator+(const Sloped& a, const Sloped& b) { return {a.v + b.v, a.l + b.l, a.x + b.x}; }
  friend Sloped operator+(const Sloped& a, const ByLength& b) { return {a.v + b.v, a.l + b.l, a.x}; }
  friend Sloped operator-(const Sloped& a, const Sloped& b) { return {a.v - b.v, a.l - b.l, a.x - b.x}; }
  friend Sloped operator-(double a, const Sloped& b) { return {a - b.v, -b.l, -b.x}; }
  friend Sloped operator-(const Sloped& a, double b) { return {a.v - b, a.l, a.x}; }
  friend Sloped operator-(const ByLength& a, const Sloped& b) { return {a.v - b.v, a.l - b.l, -b.x}; }
  friend Sloped operator*(const Sloped& a, const Sloped& b) {
    return {a.v * b.v, a.l * b.v + a.v * b.l, a.x * b.v + a.v * b.x};
  }
  friend Sloped operator*(const ByLength& a, const Sloped& b) {
    return {a.v * b.v, a.l * b.v + a.v * b.l, a.v * b.x};
  }
  friend Sloped operator*(const Sloped& a, const ByLength& b) { return b * a; }
  friend Sloped operator*(double a, const Sloped& b) { return {a * b.v, a * b.l, a * b.x}; }
};
inline Sloped select(Mask m, const Sloped& yes, const Sloped& no) {
  return {select(m, yes.v, no.v), select(m, yes.l, no.l), select(m, yes.x, no.x)};
}
inline Sloped select(Mask m, const ByLength& yes, const Sloped& no) {
  return {select(m, yes.v, no.v), select(m, yes.l, no.l), select(m, 0.0, no.x)};
}
inline Sloped larger(const Sloped& a, const Sloped& b) { return select(a.v > b.v, a, b); }
inline Sloped smaller(const Sloped& a, const Sloped& b) { return select(a.v < b.v, a, b); }

/// f(a) from its value and f'(a).
inline ByLength chained(const ByLength& a, Pack value, Pack slope) { return {value, slope * a.l}; }

/// Derivative of the fraction of locate() by x: 0 beyond the axis.
template <int lowest_exponent, int octaves, int bits_per_octave>
Pack fraction_slope(Pack x) {
  // An octave is divided evenly: the fraction grows by 2^bits intervals over the octave's width, which is the
  // power of two in the exponent's bits of x.
  constexpr normal::OctaveAxis axis{lowest_exponent, octaves, bits_per_octave};
  constexpr double low = axis.node(0), high = axis.node(axis.intervals());
  constexpr std::uint64_t exponent = std::uint64_t{0x7ff} << 52;
  const Mask inside = (x >= low) & (x < high);
  const Pack octave = pack_of(bits_of(select(inside, x, low)) & exponent);
  return select(inside, static_cast<double>(1 << bits_per_octave) / octave, 0.0);
}

/// read() of line_tables.hpp.
inline ByLength read_sloped(const double* table, const ByLength& tau) {
  constexpr normal::OctaveAxis axis = normal::InfluenceTables::distance_axis;
  const Places place = locate<axis.lowest_exponent, axis.octaves, axis.bits_per_octave>(tau.v);
  const Neighbours value = pick(table, indices(place.interval));
  // Linear between two nodes: the rise times the slope of the fraction is the derivative.
  const Pack rise = value.behind - value.at;
  return chained(tau, value.at + place.fraction * rise,
                 rise * fraction_slope<axis.lowest_exponent, axis.octaves, axis.bits_per_octave>(tau.v));
}

/// read_middle_plane() of the same.
inline MiddlePlane<ByLength> read_middle_plane(const StripTables& tables, const ByLength& tau) {
  constexpr normal::OctaveAxis axis = normal::InfluenceTables::distance_axis;
  const Places place = locate<axis.lowest_exponent, axis.octaves, axis.bits_per_octave>(tau.v);
  const Neighbours twins = pick(tables.on_middle_plane, indices(place.interval));
  const Pack slope = fraction_slope<axis.lowest_exponent, axis.octaves, axis.bits_per_octave>(tau.v);
  const auto between = [&](Pack at, Pack behind) {
    const Pack rise = behind - at;
    return chained(tau, at + place.fraction * rise, rise * slope);
  };
  return {between(first_of(twins.at), first_of(twins.behind)),
          between(second_of(twins.at), second_of(twins.behind))};
}

/// Place on the rows' axis, of a distance in half lengths: the difference of two places, as in
/// influence_kernel.hpp.
inline ByLength row_place(Pack distance, Pack inverse_length) {
  constexpr std::uint64_t exponent = std::uint64_t{0x7ff} << 52;
  constexpr double origin = normal::InfluenceTables::line_rows.origin(),
                   last = normal::InfluenceTables::line_rows.last();
  // Derivative of the axis's polynomial in 1 / l at the octave's own t; 1 / l is 0 behind the last source.
  const Mask some = inverse_length > 0.0;
  const Pack inverse = select(some, inverse_length, 1.0);
  const Pack t = octaves_of(inverse).within, octave = pack_of(bits_of(inverse) & exponent);
  const Pack slope = (normal::LogAxis::first +
                      t * (2.0 * normal::LogAxis::second +
                           t * (3.0 * normal::LogAxis::third + t * (4.0 * normal::LogAxis::fourth)))) /
                     octave;
  // By l, with d(1/l)/dl = -1/l^2; outside the table's rows the place is held and does not change.
  const Pack place = place_from_one(distance) + origin + place_from_one(inverse);
  const Mask inside = (place > 0.0) & (place < last);
  return {place, select(inside, Pack(0.0) - slope * inverse * inverse, 0.0)};
}

/// line_potential_at() of the same, xi >= 0.
inline Sloped line_potential_sloped(const StripTables& tables, const ByLength& row, const LineRows& rows,
                                    const Sloped& xi) {
  constexpr normal::OctaveAxis axis = normal::InfluenceTables::from_end;
  constexpr double least = axis.node(0);
  // Bilinear in (row, from_end = xi - 1); the axis of columns is of |xi - 1| + least, hence the sign.
  const Pack from_end = xi.v - 1.0, sign = with_sign(1.0, from_end);
  const BetweenColumns j = between_columns(tables, rows, from_end);
  const Pack per_distance =
      fraction_slope<axis.lowest_exponent, axis.octaves, axis.bits_per_octave>(magnitude(from_end) + least);
  const Pack by_row = j.here_rise + j.fraction * (j.next_rise - j.here_rise);
  const Pack by_xi = sign * j.rise * per_distance;
  return {j.here + j.fraction * j.rise, by_row * row.l + by_xi * xi.l, by_xi * xi.x};
}

/// A pack of sources and their distances from points of one place, in half lengths [-].
struct SeenSources {
  ByLength tau, half_width, factor;
  ByLength row;  ///< place on the rows' axis
  Mask own;
};

inline SeenSources seen_sources(const SurfaceSources& sources, std::int32_t first, double place) {
  // a / l has the derivative -a / l^2 by l.
  const Pack inverse = load_pack(sources.inverse_length + first), zero = 0.0;
  const auto over_length = [&](Pack a) { return ByLength{a * inverse, zero - a * inverse * inverse}; };
  SeenSources s;
  const Pack distance = magnitude(load_pack(sources.place + first) - Pack(place));
  s.tau = over_length(distance);
  s.row = row_place(distance, inverse);
  const Pack half = load_pack(sources.half_width + first), factor = load_pack(sources.factor + first);
  s.half_width = {half, zero - half * inverse};
  s.factor = {factor, zero - factor * inverse};
  s.own = s.tau.v <= 0.0;
  return s;
}

/// |x - c| / l of a pack of sources, with the sign of x - c in its derivative by x.
inline Sloped seen_along(const SurfaceSources& sources, std::int32_t first, double x) {
  const Pack inverse = load_pack(sources.inverse_length + first), zero = 0.0;
  const Pack offset = Pack(x) - load_pack(sources.centre + first), distance = magnitude(offset) * inverse;
  return {distance, zero - distance * inverse, select(offset < zero, zero - inverse, inverse)};
}

inline void store_sloped(const Sloped& a, std::int32_t first, const SurfaceSlopes& to) {
  store_pack(to.value + first, a.v);
  store_pack(to.by_length + first, a.l);
  store_pack(to.by_x + first, a.x);
}

/// SurfaceKernels::influence_slopes.
inline void surface_influence_slopes(const SurfaceTables& tables, const SurfaceSources& sources,
                                     const SurfacePoint& point, const SurfaceSlopes& slopes) {
  for (std::int32_t first = 0; first < sources.count; first += lanes) {
    // On the middle plane, and beside it where xi is not small: line_potential_near() of the values.
    const SeenSources s = seen_sources(sources, first, point.place);
    const Sloped xi = seen_along(sources, first, point.x);
    const ByLength tau = select(s.own, ByLength(1.0), s.tau);
    const MiddlePlane<ByLength> middle = read_middle_plane(tables.line, tau);
    const ByLength towards_line = middle.inverse_to_end * middle.inverse_to_end;
    const Sloped y = towards_line * (xi * xi);
    const Sloped close = near_middle_plane(middle.potential, towards_line, y);
    Sloped seen = close;
    if (any(y.v > beside_middle_plane))
      seen = close + part_off_middle_plane(y) *
                         (line_potential_sloped(tables.line, s.row, line_rows_at(s.row.v), xi) - close);
    // The width of near sources, and the mean over the width for the point's own.
    const Mask is_near = s.tau.v < near_strip * s.half_width.v;
    if (any(is_near)) {
      const ByLength correction = width_correction(s.half_width / tau, middle.inverse_to_end);
      seen = select(is_near & !s.own, seen + correction, seen);
      if (any(s.own)) seen = select(s.own, read_sloped(tables.own_middle, s.half_width), seen);
    }
    store_sloped(s.factor * seen, first, slopes);
  }
}

/// SurfaceKernels::edge_slopes.
inline void surface_edge_slopes(const SurfaceTables& tables, const SurfaceSources& sources, double place,
                                const double* x, const SurfaceSlopes* slopes) {
  for (std::int32_t first = 0; first < sources.count; first += lanes) {
    // J(tau, xi); the mean over its own width where the point is an edge of the source.
    const SeenSources s = seen_sources(sources, first, place);
    const LineRows rows = line_rows_at(s.row.v);
    const bool any_own = any(s.own);
    const ByLength own = any_own ? read_sloped(tables.line.edge_under, s.half_width) : ByLength(0.0);
    for (std::int32_t edge = 0; edge < 2; ++edge) {
      const Sloped far = line_potential_sloped(tables.line, s.row, rows, seen_along(sources, first, x[edge]));
      store_sloped(s.factor * (any_own ? select(s.own, own, far) : far), first, slopes[edge]);
    }
  }
}

}  // namespace sloped

}  // namespace
}  // namespace wrc::simd
