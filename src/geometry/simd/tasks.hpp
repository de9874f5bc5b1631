/// Arguments of the kernels of the geometry stage: plain data, no constructors.
#pragma once

#include <cstdint>

#include "geometry/contact_search.hpp"
#include "geometry/placement.hpp"
#include "geometry/silhouette.hpp"

namespace wrc::geometry {

struct GapRowMemory;

}  // namespace wrc::geometry

namespace wrc::simd {

/// Rows of a gap that are to be filled: row j lies at low + j step.
struct RowsTask {
  const geometry::Rail* rail;
  const geometry::PosedWheel* wheel;
  const geometry::ContactPoint* contact;
  std::int32_t rail_piece, wheel_piece;  ///< pieces of the profiles at the contact point
  double low, step;                      ///< [m]
  std::int32_t count;
  const geometry::GapRowMemory* memory;
};

}  // namespace wrc::simd
