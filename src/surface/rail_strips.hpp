/// The cross section of a rail cut into strips, once: their places never depend on a pose, so nothing about
/// them can jump.
#pragma once

#include <cstdint>

#include "surface/curve.hpp"

namespace wrc {

/// Strips by increasing arc length, touching each other. Rail axes: origin of the rail's profile, y to the
/// field side, z down.
struct RailStrips {
  std::int32_t count = 0;
  const double* s = nullptr;                ///< arc length at the middle [m]
  const double* width = nullptr;            ///< along the arc [m]
  const double *y = nullptr, *z = nullptr;  ///< the middle [m]
  const double *ty = nullptr,
               *tz = nullptr;  ///< unit tangent, by increasing arc length; the normal into the rail is
                               ///< (-tz, ty)
};

/// Widths of strips: the narrowest where the surface is curved as a gauge corner, the widest where it is
/// nearly flat [m].
struct StripWidths {
  double narrowest = 0.25e-3, widest = 0.5e-3;
  double sharp = 0.020, flat = 0.060;  ///< radii of curvature up to and from which they hold [m]
};

/// Doubles of memory for so many strips.
std::int64_t rail_strip_doubles(std::int32_t strips);

/// Cuts the whole curve into at most `most` strips, in `memory` of rail_strip_doubles(most) doubles.
Fault cut_rail(const Curve& rail, const StripWidths& widths, std::int32_t most, double* memory,
               RailStrips& strips);

}  // namespace wrc
