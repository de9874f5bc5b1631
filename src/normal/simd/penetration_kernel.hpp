/// The strips of a virtual penetration, and displacements at a point by their pressure: the work of an
/// evaluation of the Kik-Piotrowski family.
#pragma once

#include "normal/simd/influence_kernel.hpp"
#include "normal/simd/line_tables.hpp"

namespace wrc::simd {
namespace {

/// The slope of the height at y, by the parabola through the row `before` and the two behind it [-]:
/// row_slope of patch/gap.cpp, operation by operation.
inline Pack row_slope(const patch::GapRows& rows, const Indices& before, Pack y) {
  const Neighbours y_left = pick(rows.y, before), y_right = pick(rows.y + 1, before);
  const Neighbours height_left = pick(rows.height, before), height_right = pick(rows.height + 1, before);
  // Intervals, rises, and the parabola's slope at the middle row with its second derivative.
  const Pack left = y_left.behind - y_left.at, right = y_right.behind - y_right.at;
  const Pack drop = height_left.behind - height_left.at, rise = height_right.behind - height_right.at;
  const Pack inverse = 1.0 / (left * right * (left + right));
  const Pack slope = (drop * right * right + rise * left * left) * inverse;
  const Pack second = 2.0 * (rise * left - drop * right) * inverse;
  return slope + second * (y - y_right.at);
}

/// NormalKernels::divide_span.
void divide_span_kernel(const SpanTask& task, const StripArrays& strips) {
  const patch::GapRows& rows = task.rows;
  const std::int32_t last = rows.count - 1;
  std::int64_t interval = task.first_interval;
  for (std::int32_t first = 0; first < task.count; first += lanes) {
    const std::int32_t count = task.count - first < lanes ? task.count - first : lanes;
    const Pack y = task.y_from + (load_pack(lane_numbers) + (1.0 * first + 0.5)) * task.width;
    double places[lanes];
    store_pack(places, y);
    // The interval of each strip, and where the three rows begin that the slopes at its ends come from.
    Indices from, slope_from, slope_to;
    for (std::int32_t k = 0; k < lanes; ++k) {
      while (k < count && interval < last - 1 && places[k] >= rows.y[interval + 1]) ++interval;
      from.at[k] = interval;
      slope_from.at[k] = interval > 0 ? interval - 1 : 0;
      slope_to.at[k] = interval < last - 1 ? interval : last - 2;
    }
    const Neighbours y_row = pick(rows.y, from), height_row = pick(rows.height, from);
    const Neighbours centre = pick(rows.centre, from), curvature = pick(rows.curvature, from);
    const Pack c1 = row_slope(rows, slope_from, y_row.at), c1_to = row_slope(rows, slope_to, y_row.behind);
    // Height [m] by the cubic of GapReader (patch/gap.hpp), curvature linear.
    const Pack d = y - y_row.at;
    const Pack inverse = 1.0 / (y_row.behind - y_row.at);
    const Pack chord = (height_row.behind - height_row.at) * inverse;
    const Pack c2 = (3.0 * chord - 2.0 * c1 - c1_to) * inverse;
    const Pack c3 = (c1 + c1_to - 2.0 * chord) * (inverse * inverse);
    const Pack height = height_row.at + d * (c1 + d * (c2 + d * c3));
    const Pack row_curvature = curvature.at + d * ((curvature.behind - curvature.at) * inverse);

    // g = eps(y) delta - height; half length sqrt(2 g / curvature).
    const Pack apart = y - task.scale_centre;
    const Pack scale = smaller(larger(task.scale_at_centre + task.scale_bend * apart * apart, 0.05), 1.0);
    // A dip of the overlap between two rows must not end in the root of a negative number.
    const Pack overlap = larger(scale * task.approach - (height - task.lowest_height), 1e-12 * task.approach);
    store(y, strips.y + first, count);
    store(task.width, strips.width + first, count);
    store(centre.at + d * ((centre.behind - centre.at) * inverse), strips.centre + first, count);
    store(root(2.0 * overlap / row_curvature), strips.half_length + first, count);
  }
}

/// NormalKernels::displacements_at.
void displacements_at_kernel(const PointTask& task, const StripArrays& strips, double* displacement) {
  constexpr normal::OctaveAxis axis = normal::line_axis;
  constexpr double half_pi = 1.57079632679489661923;
  for (std::int32_t first = 0; first < task.count; first += lanes) {
    const std::int32_t count = task.count - first < lanes ? task.count - first : lanes;
    const Pack dy = load(strips.y, first, count, 0.0) - task.y;
    const Pack shift = load(strips.centre, first, count, 0.0) - task.x;
    const Pack l = load(strips.half_length, first, count, 1.0);
    const Pack half_width = 0.5 * load(strips.width, first, count, 1.0);
    // strip_displacement (contact_condition.cpp) away from the strip, operation by operation.
    const Pack y_from = dy - half_width, y_to = dy + half_width;
    const Pack width = y_to - y_from, middle = 0.5 * (y_from + y_to);
    const Pack distance = larger(magnitude(middle), width);  // nearer is the caller's
    const Pack t2 = width * width / (4.0 * distance * distance);
    Pack series = 0.0;
    for (std::int32_t n = 8; n >= 1; --n) series = t2 * (series + 1.0 / (2 * n * (2 * n + 1)));
    // J(tau, 0) by its cubics; far away pi / (2 tau).
    const Pack tau = magnitude(middle) / l;
    const Places place = locate<axis.lowest_exponent, axis.octaves, axis.bits_per_octave>(tau);
    const Indices cubic = indices(place.interval << 2);
    const Neighbours low = pick(task.line_cubics, cubic), high = pick(task.line_cubics + 2, cubic);
    Pack line =
        low.at + place.fraction * (low.behind + place.fraction * (high.at + place.fraction * high.behind));
    constexpr double end = axis.node(axis.intervals());
    const Mask far = tau >= Pack(end);
    if (any(far)) {
      const Pack beyond = larger(tau, end);
      line = select(far, half_pi / beyond * (1.0 - 0.125 / (beyond * beyond)), line);
    }
    // The width's correction and the shift's factor, as impose_approach().
    const Pack r = root(l * l + middle * middle);
    const Pack seen = width * (line + 2.0 * series * l / r);
    const Pack to_line2 = l * l + dy * dy;
    store(l * (seen * root(to_line2 / (to_line2 + shift * shift))), displacement + first, count);
  }
}

}  // namespace
}  // namespace wrc::simd
