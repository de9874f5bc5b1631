#include "surface/wrench/first_touch.hpp"

#include <algorithm>
#include <cmath>

#include "base/number.hpp"

namespace wrc::surface {
namespace {

/// The distance that the wheel falls until it touches the nearest of these strips [m], by their tangents; at
/// most farthest_touch.
double fall_of(const Overlaps& o, const RelativeMotion& motion, double least_down) {
  double fall = farthest_touch;
  for (std::int32_t i = 0; i < o.count; ++i) {
    const double down = downwards(motion, o.ny[i], o.nz[i]);
    if (down > least_down) fall = smaller(fall, -o.depth[i] / down);
  }
  return fall;
}

/// The distance that the wheel falls until it touches the nearest strip [m], by the strips' tangents; at most
/// farthest_touch. Strips count whose mean normal points down by more than `least_down`.
double fall_to_strips(const WheelProblem& problem, const RelativeMotion& motion, double least_down,
                      WheelOverlaps& o) {
  // The few strips near the wheel are enough if one touches soon: others' depths are at least a third of
  // their overlaps, as their normals are less than 80 degrees off the wheel's.
  constexpr double near = 1.5e-3;  // [m]
  double fall = farthest_touch;
  for (const double margin : {near, farthest_touch}) {
    find_wheel_overlaps(problem, motion, margin, o);
    fall = smaller(fall, fall_of(o, motion, least_down));
    if (fall < margin / 3.0) break;
  }
  return fall;
}

/// The distance from the lowest point of the wheel's outline down to the highest of the rail [m].
double fall_from_above(const WheelProblem& problem, const RelativeMotion& motion,
                       const OverlapScratch& outline) {
  double lowest = -1e300, top = 1e300;
  for (std::int32_t k = 0; k < problem.model.wheel.knots; ++k)
    if (outline.seen[k] > 0.0) lowest = larger(lowest, outline.z[k]);
  const RailStrips& rail = problem.rail;
  for (std::int32_t r = 0; r < rail.ranges; ++r) top = smaller(top, rail.range[r].top);
  return (top - lowest) / motion.cosine;
}

/// Some strips of a surface under the wheel's outline, each with a knot of the outline near its place.
struct StripsBelow {
  static constexpr std::int32_t every = 16, most = most_strips_of_a_rail / every + 1;

  std::int32_t count = 0;
  std::int32_t strip[most], knot[most];
};

/// Vertical distance of a place on the rail below a chord of the outline [m], from the knot given on; 1e300
/// where the outline is not seen. Leaves the knot behind the chord.
double fall_to_place(const OverlapScratch& outline, std::int32_t knots, double y, double z, std::int32_t& k) {
  while (k + 1 < knots && outline.y[k] < y) ++k;
  while (k > 1 && outline.y[k - 1] > y) --k;
  const double left = outline.y[k - 1], right = outline.y[k];
  if (!(outline.seen[k - 1] > 0.0 && outline.seen[k] > 0.0 && left <= y && y <= right && left < right))
    return 1e300;
  const double share = (y - left) / (right - left);
  return z - outline.z[k - 1] - share * (outline.z[k] - outline.z[k - 1]);
}

/// Each sixteenth strip of a surface that may be nearer to the wheel anywhere along the track than `nearest`
/// [m].
StripsBelow strips_below(const WheelProblem& problem, const OverlapScratch& outline, const FaceStrips& range,
                         double nearest) {
  // a strip gains along its normal, and the wheel's outline is round
  constexpr double steepest = 0.2, doubt = 0.3e-3;  // [-], [m]
  const PlacedRail& rail = problem.rail;
  StripsBelow some;
  std::int32_t k = 1;
  for (std::int32_t j = range.first; j < range.first + range.count; j += StripsBelow::every) {
    const double fall = fall_to_place(outline, problem.model.wheel.knots, rail.y[j], rail.z[j], k);
    if (fall < 1e300 && fall - outline.gain[j] / larger(rail.ty[j], steepest) > nearest + doubt) continue;
    some.strip[some.count] = j;
    some.knot[some.count++] = k;
  }
  return some;
}

/// Least vertical distance between the wheel's outline and strips at a place along the track [m]. The outline
/// is raised there by the wheel's circle.
double fall_at_place(const WheelProblem& problem, const OverlapScratch& outline, StripsBelow& strips,
                     const PlaceWeights& place) {
  const SurfaceModel& model = problem.model;
  double nearest = 1e300;
  for (std::int32_t i = 0; i < strips.count; ++i) {
    const std::int32_t j = strips.strip[i];
    const double y = place_of(model.varying, place, j, 0), z = place_of(model.varying, place, j, 1);
    nearest = smaller(nearest, fall_to_place(outline, model.wheel.knots, y, z, strips.knot[i]));
  }
  return nearest + 0.5 * place.x * place.x / model.wheel_radius;
}

/// Least vertical distance over the rail's places along the track [m], to some tenths of a millimetre.
/// `outline` is that of `motion`.
double fall_along(const WheelProblem& problem, const RelativeMotion& motion, const OverlapScratch& outline) {
  constexpr double apart = 2.0 * place_apart, far = places_to_a_side * place_apart + apart;  // [m]
  const VaryingRail& varying = problem.model.varying;
  const RailStrips ranges = strips_before(problem.model, motion.pose, problem.rail);
  double nearest = 1e300;
  for (std::int32_t r = 0; r < ranges.ranges; ++r) {
    const FaceStrips& range = ranges.range[r];
    const std::int32_t face = face_of(varying, range.first);
    const double low = problem.rail.low[face], high = problem.rail.high[face];
    StripsBelow strips = strips_below(problem, outline, range, nearest);
    const auto look = [&](const PlaceWeights& place) {
      nearest = smaller(nearest, fall_at_place(problem, outline, strips, place));
    };
    // most strips are farther away than the nearest below the axle; a face counts at places beside its ends
    const PlaceWeights& below_axle = problem.rail.place[face][places_to_a_side];
    const auto is_there = [&](const PlaceWeights& place) {
      return place.x >= low - place_apart && place.x <= high + place_apart;
    };
    if (is_there(below_axle)) look(below_axle);
    strips = strips_below(problem, outline, range, nearest);
    for (const PlaceWeights& place : problem.rail.place[face])
      if (is_there(place)) look(place);
    for (const double way : {-1.0, 1.0}) {
      double x = far;
      while (x < farthest_along + place_apart) {
        if (way * x >= low - apart && way * x <= high + apart)
          look(place_at(varying, varying.face[face], problem.rail.distance, way * x));
        x += apart;
      }
    }
  }
  return nearest / motion.cosine;
}

/// The distance that the wheel falls to the nearest of the candidates along the track [m], as far as they are
/// known; at most farthest_touch.
double fall_to_candidates(const WheelProblem& problem, const RelativeMotion& motion, double least_down) {
  const CandidatesAlong& c = problem.rail.candidates;
  double fall = farthest_touch;
  for (std::int32_t k = 0; k < c.tops; ++k) {
    const CandidateAlong& top = c.top[k];
    const double down = downwards(motion, top.ny, top.nz);
    if (down > least_down) fall = smaller(fall, -c.depth(top, motion.pose.y, motion.pose.z) / down);
  }
  return fall;
}

/// Strips whose mean normals point down by less are not lowered onto along the track [-].
constexpr double least_down_along = 0.1;

/// Lowers the wheel on a rail that varies along the track to where its outline meets the rail's places, looks
/// for candidates there, and returns the height of the nearest by first looks. `height`: any.
double height_by_first_looks(const WheelProblem& problem, double height, WheelOverlaps& overlaps) {
  constexpr double reach = 0.8e-3;  // [m]
  const SurfaceModel& model = problem.model;
  RelativeMotion motion = motion_at_height(model, problem.in, height);
  find_outline(*model.kernels, problem.rail, model.wheel, motion.pose, overlaps.outline);
  find_gains(*model.kernels, model.varying, model.wheel_radius, problem.rail, overlaps.outline.gain);
  height += fall_along(problem, motion, overlaps.outline) - model.out_of_round.largest;
  motion = motion_at_height(model, problem.in, height);
  look_for_candidates(model, problem.rail, motion.pose, reach, overlaps.outline, overlaps);
  // down or up to the nearest of them
  const double fall = fall_to_candidates(problem, motion, least_down_along);
  return fall < farthest_touch ? height + fall : height;
}

/// The distance from overlaps found with a margin to first touch [m]; where they are further away than that,
/// to candidates, which have been followed by now, or any strips.
double fall_along_from(const WheelProblem& problem, const RelativeMotion& motion, double margin,
                       WheelOverlaps& o) {
  double fall = fall_of(o, motion, least_down_along);
  if (!(fall < margin)) fall = smaller(fall, fall_to_candidates(problem, motion, least_down_along));
  return fall < farthest_touch ? fall : fall_to_strips(problem, motion, least_down_along, o);
}

/// First touch on a rail that varies along the track: by first looks, then by Newton's method. `height`: any.
double first_touch_along(const WheelProblem& problem, double height, WheelOverlaps& overlaps) {
  constexpr int most_steps = 16;
  constexpr double close = 1e-8, near = 20e-6;  // [m]
  height = height_by_first_looks(problem, height, overlaps);
  for (int n = 0; n < most_steps; ++n) {
    const RelativeMotion motion = motion_at_height(problem.model, problem.in, height);
    find_wheel_overlaps(problem, motion, near, overlaps);
    const double fall = fall_along_from(problem, motion, near, overlaps);
    height += fall;
    if (std::abs(fall) < close) break;
  }
  return height;
}

}  // namespace

double clearance(const WheelProblem& problem, Arena scratch) {
  constexpr int most_steps = 12;
  constexpr double close = 1e-10;     // [m]
  constexpr double least_down = 0.1;  // steeper than any flange
  WheelOverlaps overlaps = cut_wheel_overlaps(scratch, work_sizes(problem.model));
  if (changes(problem.model.varying)) {
    const double height = problem.in.wheel.position[2];
    return smaller(larger(first_touch_along(problem, height, overlaps) - height, 0.0), farthest_touch);
  }
  double lowered = 0.0;
  for (int n = 0; n < most_steps; ++n) {
    const double height = problem.in.wheel.position[2] + lowered;
    const RelativeMotion motion = motion_at_height(problem.model, problem.in, height);
    const double fall = fall_to_strips(problem, motion, least_down, overlaps);
    // Newton's method: the tangent of the nearest strip, which may be another at the next height
    lowered += fall;
    if (!(lowered > 0.0) || lowered >= farthest_touch || std::abs(fall) < close) break;
  }
  return smaller(larger(lowered, 0.0), farthest_touch);
}

double first_touch(const WheelProblem& problem, Arena scratch) {
  constexpr int most_steps = 16;
  constexpr double close = 1e-7;  // [m]
  constexpr double least_down = 0.2;
  constexpr double deep =
      0.1e-3;  // [m]: from there on the wheel may be below a face that it touches from above
  WheelOverlaps overlaps = cut_wheel_overlaps(scratch, work_sizes(problem.model));
  double height = problem.in.wheel.position[2];
  if (changes(problem.model.varying)) return first_touch_along(problem, height, overlaps);
  bool above = false;
  for (int n = 0; n < most_steps; ++n) {
    const RelativeMotion motion = motion_at_height(problem.model, problem.in, height);
    double fall = fall_to_strips(problem, motion, least_down, overlaps);
    // a guess deep inside the rail starts again from above all of it, once
    if (!above && fall < -deep) {
      above = true;
      fall = smaller(fall, fall_from_above(problem, motion, overlaps.outline));
    }
    height += fall;
    if (std::abs(fall) < close) break;
  }
  return height;
}

double tops_below_touch(const WheelProblem& problem, double below, RelativeMotion& motion,
                        WheelOverlaps& overlaps) {
  constexpr int most_steps = 8;
  constexpr double close = 0.1e-3;  // [m]: tops within the margin are then those that will touch
  double height = height_by_first_looks(problem, problem.in.wheel.position[2], overlaps) + below;
  // tops there say where first touch is; few steps, as the nearest strip hardly changes
  for (int n = 0;; ++n) {
    motion = motion_at_height(problem.model, problem.in, height);
    find_wheel_overlaps(problem, motion, tops_apart, overlaps, true);
    const double off = fall_along_from(problem, motion, tops_apart, overlaps) + below;
    if (std::abs(off) < close || n == most_steps) return height;
    height += off;
  }
}

double height_at_border(const WheelProblem& problem, double height, RelativeMotion& motion,
                        WheelOverlaps& overlaps) {
  constexpr int most_steps = 12;
  constexpr double close = 1e-12, least_down = 0.1;  // [m], [-]
  const WheelOverlaps& o = overlaps;
  for (int n = 0; n < most_steps; ++n) {
    motion = motion_at_height(problem.model, problem.in, height);
    find_wheel_overlaps(problem, motion, candidate_margin(problem.model), overlaps);
    // raise the wheel until the strip that is furthest beyond the border lies on it
    double rise = 0.0;
    for (std::int32_t i = 0; i < o.count; ++i) {
      if (!(o.depth[i] > deepest_overlap)) continue;
      const double down = larger(downwards(motion, o.ny[i], o.nz[i]), least_down);
      rise = larger(rise, (o.depth[i] - deepest_overlap) / down);
    }
    height -= rise;
    if (rise < close) break;
  }
  return height;
}

}  // namespace wrc::surface
