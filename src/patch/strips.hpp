/// The contact patch as strips along the rolling direction: results of normal methods, input of tangential
/// methods.
///
/// In strip j the pressure is semi-elliptic over the strip,
///
///     p(x) = peak[j] * sqrt(1 - ((x - centre[j]) / half_length[j])^2),   |x - centre[j]| <= half_length[j],
///
/// constant over the strip's width. Contact frame: x rolling direction, y lateral, origin at the initial
/// contact point; strips are ordered by increasing y. SI units.
#pragma once

#include <cstdint>

#include "base/fault.hpp"

namespace wrc::patch {

/// Structure of arrays over caller-owned memory; `count` of `capacity` strips are in use.
struct Strips {
  std::int32_t capacity = 0;
  std::int32_t count = 0;
  double* y = nullptr;            ///< lateral position of the strip's middle [m]
  double* width = nullptr;        ///< lateral width [m]
  double* centre = nullptr;       ///< x of the strip's middle [m]
  double* half_length = nullptr;  ///< [m], > 0
  double* peak = nullptr;         ///< pressure at the strip's middle [Pa], >= 0
};

/// Integral measures of a strip patch.
struct StripTotals {
  double area = 0.0;           ///< sum of 2 l dy [m^2]
  double normal_force = 0.0;   ///< sum of (pi/2) l p dy [N]
  double peak_pressure = 0.0;  ///< largest strip peak [Pa]
  double length = 0.0;         ///< max over strips of leading edge minus min of trailing edge [m]
  double y_min = 0.0;          ///< border of smaller y [m]
  double y_max = 0.0;          ///< border of larger y [m]
};

/// Sums the strips in order of increasing index (the order is part of the result's bits).
StripTotals totals(const Strips& strips);

/// The normal force of totals() by itself, the same bits.
double normal_force(const Strips& strips);

}  // namespace wrc::patch
