#include "profiles/evolution.hpp"

#include <algorithm>
#include <cmath>

#include "base/elementary.hpp"
#include "geometry/arc_length.hpp"

namespace wrc::profiles {
namespace {

/// The spline through points, with its memory and arc lengths.
class SplineProfile {
 public:
  Fault make(geometry::ProfileBody body, std::uint32_t count, const double* y, const double* z) {
    const auto nodes = static_cast<std::int32_t>(count);
    memory_.resize(geometry::profile_doubles(nodes));
    std::vector<double> scratch(count);
    const Fault fault = geometry::spline_through(body, nodes, y, z, scratch.data(),
                                                 geometry::profile_memory(nodes, memory_.data()), profile_);
    if (fault.failed()) return fault;
    arc_.resize(count);
    measured_ = geometry::measure(profile_, 0.0, arc_.data());
    return fault;
  }
  const geometry::Profile& profile() const { return profile_; }
  const geometry::MeasuredProfile& measured() const { return measured_; }
  double begin() const { return arc_.front(); }
  double end() const { return arc_.back(); }

 private:
  std::vector<double> memory_, arc_;
  geometry::Profile profile_;
  geometry::MeasuredProfile measured_;
};

/// Depth at an arc length: straight between the middles of bins, zero beyond them.
double depth_at(const WearStep& step, double arc) {
  const double at = (arc - step.first) / step.width - 0.5, below = std::floor(at);
  const auto of = [&](double bin) {
    return bin >= 0.0 && bin < static_cast<double>(step.bins) ? step.depth[static_cast<std::size_t>(bin)]
                                                              : 0.0;
  };
  return of(below) + (at - below) * (of(below + 1.0) - of(below));
}

/// Values every `spacing`, through a bell curve that halves waves of length `wave`. Weights beyond an end
/// are reflected there, so that the sum is kept.
std::vector<double> smoothed(const std::vector<double>& values, double spacing, double wave) {
  // exp(-x^2 / 2 sigma^2) lets exp(-(2 pi sigma / wave)^2 / 2) of a wave through: a half
  const double ln2 = ln2_high + ln2_low, sigma = wave * std::sqrt(0.5 * ln2) / pi;
  const auto reach = static_cast<std::ptrdiff_t>(4.0 * sigma / spacing);
  if (reach < 1) return values;
  std::vector<double> weight(static_cast<std::size_t>(reach) + 1);
  double sum = 0.0;
  for (std::ptrdiff_t k = 0; k <= reach; ++k) {
    const double x = static_cast<double>(k) * spacing / sigma;
    weight[static_cast<std::size_t>(k)] = natural_exp(-0.5 * x * x);
    sum += (k == 0 ? 1.0 : 2.0) * weight[static_cast<std::size_t>(k)];
  }
  const auto last = static_cast<std::ptrdiff_t>(values.size()) - 1;
  // every value spread by the weights; beyond an end it is reflected there
  std::vector<double> result(values.size());
  for (std::ptrdiff_t i = 0; i <= last; ++i) {
    const double share = values[static_cast<std::size_t>(i)] / sum;
    if (share == 0.0) continue;
    for (std::ptrdiff_t k = -reach; k <= reach; ++k) {
      std::ptrdiff_t to = i + k;
      if (to < 0) to = -to - 1;
      if (to > last) to = 2 * last + 1 - to;
      result[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(to, 0, last))] +=
          share * weight[static_cast<std::size_t>(std::abs(k))];
    }
  }
  return result;
}

}  // namespace

Fault wear_profile(std::uint32_t count, const double* y, const double* z, const WearStep& step,
                   WornProfile& worn) {
  SplineProfile given;
  Fault fault = given.make(step.body, count, y, z);
  if (fault.failed()) return fault;
  // depth of wear at even places along the curve, smoothed
  const double length = given.end() - given.begin();
  const auto pieces =
      std::max<std::int32_t>(8, static_cast<std::int32_t>(std::floor(length / step.spacing + 0.5)));
  const double spacing = length / pieces;
  std::vector<double> depth(static_cast<std::size_t>(pieces) + 1);
  for (std::int32_t i = 0; i <= pieces; ++i)
    depth[static_cast<std::size_t>(i)] = depth_at(step, given.begin() + spacing * i);
  if (step.smoothing > 0.0) depth = smoothed(depth, spacing, step.smoothing);
  // passages: as wanted, or as many as the largest depth of a step allows
  const double deepest = *std::max_element(depth.begin(), depth.end());
  worn.passages = deepest * step.passages > step.largest_depth ? step.largest_depth / deepest : step.passages;
  worn.depth = deepest * worn.passages;

  // A wheel's steel is above its profile, a rail's below; z points down.
  // off along the normal (-slope, 1) / root(1 + slope^2), into the steel; the area by trapezia
  const double into_steel = step.body == geometry::ProfileBody::wheel ? -1.0 : 1.0;
  worn.y.resize(depth.size());
  worn.z.resize(depth.size());
  for (std::int32_t i = 0; i <= pieces; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double at =
        i == pieces ? y[count - 1] : geometry::place_at(given.measured(), given.begin() + spacing * i);
    const geometry::ProfilePoint point = geometry::evaluate(given.profile(), at);
    const double off = into_steel * worn.passages * depth[k] / std::sqrt(1.0 + point.slope * point.slope);
    worn.y[k] = at - off * point.slope;
    worn.z[k] = point.z + off;
    worn.area += worn.passages * depth[k] * spacing * (i == 0 || i == pieces ? 0.5 : 1.0);
    if (k > 0 && !(worn.y[k] > worn.y[k - 1]))
      return Fault::profile({"worn profile", i}, {worn.y[k], "m"},
                            "it crosses itself at this point: take off less at a time, or smooth more");
  }
  // new points, evenly along the worn curve
  SplineProfile moved;
  fault = moved.make(step.body, static_cast<std::uint32_t>(worn.y.size()), worn.y.data(), worn.z.data());
  if (fault.failed()) return fault;
  const double new_spacing = (moved.end() - moved.begin()) / pieces;
  std::vector<double> laid_y(worn.y), laid_z(worn.z);
  for (std::int32_t i = 1; i < pieces; ++i) {
    const auto k = static_cast<std::size_t>(i);
    laid_y[k] = geometry::place_at(moved.measured(), moved.begin() + new_spacing * i);
    laid_z[k] = geometry::evaluate(moved.profile(), laid_y[k]).z;
  }
  worn.y = std::move(laid_y);
  worn.z = std::move(laid_z);
  return fault;
}

Fault measure_flange(std::uint32_t count, const double* y, const double* z, double back,
                     FlangeDimensions& dimensions) {
  SplineProfile given;
  const Fault fault = given.make(geometry::ProfileBody::wheel, count, y, z);
  if (fault.failed()) return fault;
  const geometry::Profile& wheel = given.profile();
  // tip of the flange: lowest point of the profile on the flange's side
  const double datum = geometry::evaluate(wheel, 0.0).z;
  std::int32_t tip = 0;
  for (std::int32_t i = 0; i < wheel.count && wheel.y[i] < 0.0; ++i)
    if (wheel.z[i] > wheel.z[tip]) tip = i;
  double tip_z = wheel.z[tip], tip_y = wheel.y[tip];
  for (int i = -50; i <= 50; ++i) {  // between the points beside it
    const double at = wheel.y[tip] + 0.02 * i * (wheel.y[tip + 1] - wheel.y[tip]);
    if (geometry::evaluate(wheel, at).z > tip_z) tip_z = geometry::evaluate(wheel, at).z, tip_y = at;
  }
  // on the face, from the tip towards the tread, where it has a height
  const auto face = [&](double height, double& at) {
    // steps of 0.1 mm along the face until it is above the height, then halves
    double low = tip_y, high = tip_y;
    const double step = 1e-4;
    while (high < 0.0 && geometry::evaluate(wheel, high).z > height) low = high, high += step;
    if (!(high < 0.0)) return false;
    for (int n = 0; n < 60; ++n) {
      const double middle = 0.5 * (low + high);
      (geometry::evaluate(wheel, middle).z > height ? low : high) = middle;
    }
    at = 0.5 * (low + high);
    return true;
  };
  double lower = 0.0, upper = 0.0;
  if (!(tip_z > datum + 0.012) || !face(datum + 0.010, lower) || !face(tip_z - 0.002, upper))
    return Fault::profile("height of the flange", {tip_z - datum, "m"},
                          "there is no flange of 12 mm or more at y < 0");
  dimensions = {.height = tip_z - datum, .thickness = lower + back, .slope = lower - upper};
  return fault;
}

}  // namespace wrc::profiles
