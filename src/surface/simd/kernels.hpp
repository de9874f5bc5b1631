/// What crosses between contact on the rail's surface and the kernels of an instruction set: plain data, no
/// constructors.
#pragma once

#include <cstdint>

#include "normal/simd/kernels.hpp"
#include "surface/outline.hpp"

namespace wrc {
namespace simd {

/// Strips that press, seen by points of the surface. Arrays have whole packs of elements, those behind the
/// last with factor 0 and inverse_length 0.
struct SurfaceSources {
  std::int32_t count;
  const double* place;           ///< arc length of the middle [m]
  const double* centre;          ///< x of the middle [m]
  const double* inverse_length;  ///< 1 / l [1/m]
  const double* half_width;      ///< half the width over l [-]
  const double* factor;          ///< what the displacement is multiplied by
  const double *ny, *nz;         ///< directions
};

/// Tables of the influence function (normal/strip_kernel.hpp).
struct SurfaceTables {
  StripTables line;
  const double* own_middle;
};

/// A point of the surface that sees the sources.
struct SurfacePoint {
  double place, x, ny, nz;
};

/// A wheel's outline, and the strips whose rays it may cross.
struct OutlineTask {
  const RailStrips* rail;
  const WheelCurve* wheel;
  const RelativePose* pose;
  OutlineAttitude attitude;
  const OverlapScratch* scratch;
};

}  // namespace simd

/// The kernels of one instruction set for contact on a surface. All sets give the same bits.
struct SurfaceKernels {
  InstructionSet set;
  /// factor_k J_k cos_k for each source, seen from the middle of a strip. `skewed`: not all centres are the
  /// same.
  void (*influence_row)(const simd::SurfaceTables& tables, const simd::SurfaceSources& sources,
                        const simd::SurfacePoint& point, bool skewed, double* row);
  /// Sum of the same, seen from the edge of a strip.
  double (*edge_displacement)(const simd::SurfaceTables& tables, const simd::SurfaceSources& sources,
                              const simd::SurfacePoint& point);
  /// Fills scratch.y, z and seen at the wheel's knots.
  void (*outline)(const simd::OutlineTask& task);
  /// Fills the overlaps' numbers (but `strip`) along the rays of overlaps.count strips in scratch.strip.
  /// Depth -1 where the surfaces do not face each other.
  void (*follow_rays)(const simd::OutlineTask& task, Overlaps& overlaps);
};

/// The kernels of a set, which the processor must have.
const SurfaceKernels& surface_kernels(InstructionSet set);

}  // namespace wrc
