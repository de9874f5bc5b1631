/// Kernels: functions that are compiled once per instruction set, with a table of them per module. Their
/// contracts are here, for whoever calls them; their bodies are in src/<module>/simd, beside the tasks they
/// are given, and src/<module>/simd/kernels.cpp fills the table.
#pragma once

#include <cstdint>

#include "base/instruction_set.hpp"

namespace wrc::patch {
struct Strips;
}

namespace wrc::surface {
struct FollowedStrips;
struct Overlaps;
struct OverlapSlopes;
struct FirstLooks;
struct StripGains;
}  // namespace wrc::surface

namespace wrc::tangential {
struct MarchGrid;
}

namespace wrc::simd {

struct RowsTask;
struct InfluenceTask;
struct EdgeTask;
struct EliminationTask;
struct SpanTask;
struct StripArrays;
struct PointTask;
struct MarchTask;
struct StripFastsimTask;
struct SurfaceMarchTask;
struct LayeredMarchTask;
struct SurfaceStripsTask;
struct SurfaceStripsSlopesTask;
struct RememberingStrip;
struct MemoryBoundsTask;
struct MemoryBringTask;
struct MemoryPassTask;
struct MemoryPassSums;
struct MemoryMarchTask;
struct Sums;
struct SurfaceTables;
struct SurfaceSources;
struct SurfaceFaces;
struct SurfacePoint;
struct SurfacePoints;
struct SurfaceEdges;
struct SurfaceSlopes;
struct SlopesRowTask;
struct BlendRowsTask;
struct NearLinesTask;
struct SmoothedSlopesTask;
struct SectionStripsTask;
struct FollowRailTask;
struct LookAlongTask;
struct StripGainsTask;
struct OutlineTask;
struct OverlapSlopesTask;
struct StripNumbersTask;
struct StripNumbersSlopesTask;
struct StripForcesSlopesTask;
struct CellTask;
struct CellExtremes;
struct PointLoads;
struct CornerLoads;
struct StressParts;

struct GeometryKernels {
  /// Fills the rows; false: not every one of them converged.
  bool (*fill_rows)(const RowsTask& task);
};

struct NormalKernels {
  /// Displacement at the middle of strip j by unit peak in each of the strips, over the compliance [m]. The
  /// strip's own element of the row is left to the caller.
  void (*influence_row)(const InfluenceTask& task, std::int32_t j, double* row);
  /// Displacements at the edges of strips, by all strips.
  void (*edge_displacements)(const EdgeTask& task);
  /// Solves dense linear equations without pivoting.
  void (*eliminate)(const EliminationTask& task);
  /// Fills the strips: place, width, centre, and half length, that of the overlap of the row's parabola,
  /// sqrt(2 g / curvature).
  void (*divide_span)(const SpanTask& task, const StripArrays& strips);
  /// Displacement at the point by each strip of unit peak / half length, over the compliance [m^2]: see
  /// impose_approach (normal/elasticity/contact_condition.hpp). Strips nearer to it than their width are left
  /// to the caller.
  void (*displacements_at)(const PointTask& task, const StripArrays& strips, double* displacement);
};

/// Fields are written by the kernels of fields only.
struct TangentialKernels {
  void (*march)(const MarchTask& task, Sums& sums);
  void (*march_fields)(const MarchTask& task, Sums& sums);
  void (*march_sensitivities)(const MarchTask& task, Sums& sums);
  void (*strip_fastsim)(const StripFastsimTask& task, Sums& sums);
  void (*strip_fastsim_fields)(const StripFastsimTask& task, Sums& sums);
  void (*strip_fastsim_sensitivities)(const StripFastsimTask& task, Sums& sums);
  /// Sums hold power and areas only: forces of strips with axes of their own do not add.
  void (*surface_march)(const SurfaceMarchTask& task, Sums& sums);
  void (*surface_march_fields)(const SurfaceMarchTask& task, Sums& sums);
  void (*surface_strips)(const SurfaceStripsTask& task, Sums& sums);
  void (*surface_strips_fields)(const SurfaceStripsTask& task, Sums& sums);
  void (*surface_strips_slopes)(const SurfaceStripsSlopesTask& task);
  /// Bounds of a strip's cells, up to a factor that a patch shares; returns their sum.
  double (*memory_bounds)(const MemoryBoundsTask& task, double load, double friction, RememberingStrip& to);
  /// Adds the tractions that a past strip brings.
  void (*memory_bring)(const MemoryBringTask& task, RememberingStrip& to);
  /// Tractions alone, or with the sums.
  void (*memory_pass)(const MemoryPassTask& task);
  void (*memory_pass_sums)(const MemoryPassTask& task, MemoryPassSums& sums);
  void (*memory_march)(const MemoryMarchTask& task);
  /// Tractions of a strip's cells: a share of others, and the sums of their squares.
  void (*memory_tend)(const double* others, double share, double* to);
  void (*memory_squares)(const double* tractions, double& along_x, double& along_y);
  void (*layered_march)(const LayeredMarchTask& task, Sums& sums);
  void (*layered_march_fields)(const LayeredMarchTask& task, Sums& sums);
};

struct SurfaceKernels {
  /// Fills the arrays from loads and means on.
  void (*strip_numbers)(const StripNumbersTask& task);
  /// Numbers of strips with derivatives, for strip FASTSIM: those up to the means over neighbours; then, for
  /// some of the strips, those that march.
  void (*strip_means_slopes)(const StripNumbersSlopesTask& task);
  void (*strip_arrays_slopes)(const StripNumbersSlopesTask& task);
  /// Derivatives of the strips' forces by the chain rule.
  void (*strip_forces_slopes)(const StripForcesSlopesTask& task);
  /// factor_k J_k cos_k for each source k, seen from points that are middles of strips: a row for each, of
  /// whole vectors, and one more where they are odd. A source's effect on itself is not in them. `skewed`:
  /// not all centres are the same.
  void (*influence)(const SurfaceTables& tables, const SurfaceSources& sources, const SurfaceFaces& faces,
                    const SurfacePoints& points, bool skewed, double* rows, std::int64_t stride);
  /// The same of each source on itself, written to the diagonal of rows that are the sources'.
  void (*own_influence)(const SurfaceTables& tables, const SurfaceSources& sources, double* rows,
                        std::int64_t stride);
  /// Sums of the same, seen from the edges of the sources.
  void (*edges)(const SurfaceTables& tables, const SurfaceSources& sources, const SurfaceFaces& faces,
                const SurfaceEdges& edges);
  /// influence and edges, source by source, with their derivatives. The two edges are points `x` of one
  /// place; `slopes` has an element for each.
  void (*influence_slopes)(const SurfaceTables& tables, const SurfaceSources& sources,
                           const SurfacePoint& point, const SurfaceSlopes& slopes);
  void (*edge_slopes)(const SurfaceTables& tables, const SurfaceSources& sources, double place,
                      const double* x, const SurfaceSlopes* slopes);
  void (*slopes_row)(const SlopesRowTask& task);
  void (*blend_rows)(const BlendRowsTask& task);
  /// Subtracts from four right-hand sides the sums of row[c] times their solutions x[c], from c = first to
  /// before `end`.
  void (*take_known)(const double* row, std::int32_t first, std::int32_t end, const double* x, double* right);
  void (*near_lines)(const NearLinesTask& task);
  /// Returns the smoothed value; where nothing presses 0, as its derivatives.
  double (*smoothed_slopes)(const SmoothedSlopesTask& task);
  /// Places strips between sections of a rail.
  void (*section_strips)(const SectionStripsTask& task);
  /// Fills the most that overlaps of strips grow at places along a rail that varies, and where.
  void (*strip_gains)(const StripGainsTask& task, surface::StripGains& gains);
  /// Overlaps at places along a rail that varies, by the parabolas below the axle.
  void (*look_along)(const LookAlongTask& task, surface::FirstLooks& looks);
  /// Takes x, u, piece and depth from places far from the axle to larger overlaps near by, by rays.
  void (*climb_along)(const FollowRailTask& task, surface::FollowedStrips& strips);
  /// Finds the largest overlaps of strips along a rail that varies, and their parabolas.
  void (*follow_rail)(const FollowRailTask& task, surface::FollowedStrips& strips);
  /// Fills scratch.y, z and seen at the wheel's knots.
  void (*outline)(const OutlineTask& task);
  /// Fills scratch.overlap, and piece and part of the strips whose rays the outline crosses less than the
  /// `margin` of their range above the rail, which lie from `begin` to before `end`.
  void (*cross_rays)(const OutlineTask& task, const double* margin, std::int32_t& begin, std::int32_t& end);
  /// Fills the overlaps of overlaps.count strips, whose rays cross the chord of overlaps.piece at the part
  /// overlaps.u of it; then `u` is the length on the piece [m]. Depth -1 where the surfaces do not face each
  /// other.
  void (*follow_rays)(const OutlineTask& task, const surface::Overlaps& overlaps);
  /// Fills the overlap of a strip with its derivatives.
  void (*overlap_slopes)(const OverlapSlopesTask& task, surface::OverlapSlopes& to);
};

struct DamageKernels {
  void (*assess_cells)(const CellTask& task, CellExtremes& extremes);
  /// Add the stresses by loads on a half-space at a point of it.
  void (*stress_of_points)(const PointLoads& loads, StressParts& stress);
  void (*stress_of_corners)(const CornerLoads& loads, StressParts& stress);
};

}  // namespace wrc::simd

namespace wrc {

/// The tables of one instruction set. All sets give the same bits.
struct Kernels {
  InstructionSet set;
  const simd::GeometryKernels& geometry;
  const simd::NormalKernels& normal;
  const simd::TangentialKernels& tangential;
  const simd::SurfaceKernels& surface;
  const simd::DamageKernels& damage;
};

/// The kernels of a set, which the processor must have.
const Kernels& kernels_for(InstructionSet set);

}  // namespace wrc
