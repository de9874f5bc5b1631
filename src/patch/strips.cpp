#include "patch/strips.hpp"

#include <algorithm>

#include "patch/material.hpp"

namespace wrc::patch {

StripTotals totals(const Strips& strips) {
  StripTotals sum;
  if (strips.count == 0) return sum;
  // Extent along x [m]: from the rearmost trailing to the foremost leading edge.
  double trail = strips.centre[0] - strips.half_length[0];
  double lead = strips.centre[0] + strips.half_length[0];
  for (std::int32_t j = 0; j < strips.count; ++j) {
    const double l = strips.half_length[j];
    sum.area += 2.0 * l * strips.width[j];
    sum.normal_force += 0.5 * pi * l * strips.peak[j] * strips.width[j];
    sum.peak_pressure = std::max(sum.peak_pressure, strips.peak[j]);
    trail = std::min(trail, strips.centre[j] - l);
    lead = std::max(lead, strips.centre[j] + l);
  }
  const std::int32_t last = strips.count - 1;
  sum.length = lead - trail;
  sum.y_min = strips.y[0] - 0.5 * strips.width[0];
  sum.y_max = strips.y[last] + 0.5 * strips.width[last];
  return sum;
}

double normal_force(const Strips& strips) {
  double sum = 0.0;
  for (std::int32_t j = 0; j < strips.count; ++j)
    sum += 0.5 * pi * strips.half_length[j] * strips.peak[j] * strips.width[j];
  return sum;
}

}  // namespace wrc::patch
