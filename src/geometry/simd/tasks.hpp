/// What crosses between the geometry stage and the kernels of an instruction set: plain data, no
/// constructors.
#pragma once

#include <cstdint>

#include "geometry/contact_search.hpp"
#include "geometry/placement.hpp"
#include "geometry/silhouette.hpp"

namespace wrc {

struct GapRowMemory;

namespace simd {

/// Rows of a gap that are to be filled: row j lies at low + j step.
struct RowsTask {
  const Rail* rail;
  const PosedWheel* wheel;
  const ContactPoint* contact;
  std::int32_t rail_piece, wheel_piece;  ///< of the profiles, where the contact point is
  double low, step;                      ///< [m]
  std::int32_t count;
  const GapRowMemory* memory;
};

}  // namespace simd

}  // namespace wrc
