#include "tangential/methods/past_strip.hpp"

#include <algorithm>
#include <cmath>

#include "tangential/methods/patch_numbers.hpp"

namespace wrc::tangential {
namespace {

constexpr std::int32_t cells = memory_cells;

constexpr double kept_back = 0.25;  // least part of the stored energy that can be given back

}  // namespace

PastStrip turned(const PastStrip& strip, double direction) {
  PastStrip s = strip;
  if (direction > 0.0) return s;
  s.centre = -s.centre;
  s.way = -s.way;
  for (double* three : {s.force, s.added}) {
    three[0] = -three[0];
    three[2] = -three[2];
  }
  std::reverse(s.px, s.px + cells);
  std::reverse(s.py, s.py + cells);
  for (double& p : s.px) p = -p;
  return s;
}

void tend_to(const simd::TangentialKernels& kernels, const PastStrip& steady, double share,
             PastStrip& strip) {
  kernels.memory_tend(steady.px, share, strip.px);
  for (int i = 0; i < 3; ++i) strip.force[i] = (1.0 - share) * strip.force[i] + share * steady.force[i];
}

double stored_in(const simd::TangentialKernels& kernels, const PastStrip& strip, double area, double growth_x,
                 double growth_y) {
  // 1/2 L p^2; L of a patch whose load underflows is 0, and so is p
  double x2, y2;
  kernels.memory_squares(strip.px, x2, y2);
  return 0.5 * area * (x2 / std::max(growth_x, least_divisor) + y2 / std::max(growth_y, least_divisor));
}

double stored_by(const double yield[3], const double force[3]) {
  // 1/2 S F^2
  double sum = 0.0;
  for (int i = 0; i < 3; ++i) sum += 0.5 * yield[i] * force[i] * force[i];
  return sum;
}

void lower(double scale, PastStrip& strip) {
  for (std::int32_t i = 0; i < cells; ++i) {
    strip.px[i] *= scale;
    strip.py[i] *= scale;
  }
  for (double& part : strip.force) part *= scale;
}

EnergyLeft count_energy(double before, double work, double stored) {
  // before + scale work >= kept_back scale^2 stored
  EnergyLeft e;
  const double least_kept = kept_back * stored;
  if (before + work < least_kept) {
    e.scale = least_kept > 0.0
                  ? (work + std::sqrt(work * work + 4.0 * least_kept * before)) / (2.0 * least_kept)
                  : (work < 0.0 ? before / -work : 1.0);
    e.scale = std::clamp(e.scale, 0.0, 1.0);
  }
  const double there = std::max(0.0, before + e.scale * work);
  e.left = std::min(e.scale * e.scale * stored, there);
  e.dissipated = there - e.left;
  return e;
}

}  // namespace wrc::tangential
