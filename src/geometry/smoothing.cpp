#include "geometry/smoothing.hpp"

#include <algorithm>
#include <cmath>

#include "patch/material.hpp"

namespace wrc {

double smooth_points(std::int32_t count, const double* y, const double* z, double wavelength, double* scratch,
                     double* smoothed) {
  const double length = wavelength / (2.0 * pi);
  const double lambda = length * length * length * length;
  const auto spacing = [&](std::int32_t i) { return y[i + 1] - y[i]; };
  const auto weight = [&](std::int32_t i) {  // the width point i stands for
    return 0.5 * ((i > 0 ? spacing(i - 1) : 0.0) + (i + 1 < count ? spacing(i) : 0.0));
  };
  const auto middle = [&](std::int32_t i) { return -1.0 / spacing(i - 1) - 1.0 / spacing(i); };

  // Second derivatives c of the curve at the inner points: (R + lambda Q' W^-1 Q) c = Q' z, where Q' takes
  // second differences and R is the mass matrix of hat functions. Factors L D L' of the five bands.
  double* const diagonal = scratch;
  double* const first = scratch + count;
  double* const second = scratch + 2 * count;
  double* const c = scratch + 3 * count;
  c[0] = c[count - 1] = 0.0;
  for (std::int32_t i = 1; i + 1 < count; ++i) {
    const double before = spacing(i - 1), after = spacing(i);
    double d = (before + after) / 3.0 +
               lambda * (1.0 / (before * before * weight(i - 1)) + middle(i) * middle(i) / weight(i) +
                         1.0 / (after * after * weight(i + 1)));
    double e = i + 2 < count ? after / 6.0 + lambda * (middle(i) / (after * weight(i)) +
                                                       middle(i + 1) / (after * weight(i + 1)))
                             : 0.0;
    const double f = i + 3 < count ? lambda / (after * spacing(i + 1) * weight(i + 1)) : 0.0;
    double right = (z[i + 1] - z[i]) / after - (z[i] - z[i - 1]) / before;
    if (i > 1) {
      d -= first[i - 1] * first[i - 1] * diagonal[i - 1];
      e -= first[i - 1] * second[i - 1] * diagonal[i - 1];
      right -= first[i - 1] * c[i - 1];
    }
    if (i > 2) {
      d -= second[i - 2] * second[i - 2] * diagonal[i - 2];
      right -= second[i - 2] * c[i - 2];
    }
    diagonal[i] = d;
    first[i] = e / d;
    second[i] = f / d;
    c[i] = right;
  }
  for (std::int32_t i = count - 2; i >= 1; --i) {
    c[i] /= diagonal[i];
    if (i + 2 < count) c[i] -= first[i] * c[i + 1];
    if (i + 3 < count) c[i] -= second[i] * c[i + 2];
  }

  double largest = 0.0;
  for (std::int32_t i = 0; i < count; ++i) {
    double bend = 0.0;  // row i of Q c
    if (i > 0 && i + 1 < count) bend += middle(i) * c[i];
    if (i > 0) bend += c[i - 1] / spacing(i - 1);
    if (i + 1 < count) bend += c[i + 1] / spacing(i);
    smoothed[i] = z[i] - lambda * bend / weight(i);
  }
  for (std::int32_t i = 0; i < count; ++i) {
    const std::int32_t left = std::max(i - 1, 0), right = std::min(i + 1, count - 1);
    const double slope = (smoothed[right] - smoothed[left]) / (y[right] - y[left]);
    largest = std::max(largest, std::abs(z[i] - smoothed[i]) / std::sqrt(1.0 + slope * slope));
  }
  return largest;
}

}  // namespace wrc
