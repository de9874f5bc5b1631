/// The functions that are compiled once per instruction set: one table of them for each set. Their bodies are
/// in the rooms' simd folders, beside the tasks they are given.
#pragma once

#include <cstdint>

#include "base/instruction_set.hpp"

namespace wrc {

struct MarchGrid;
struct Overlaps;
struct Strips;

namespace simd {

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
struct SurfaceStripsTask;
struct SurfaceStripsSlopesTask;
struct Sums;
struct SurfaceTables;
struct SurfaceStrips;
struct SurfaceSources;
struct SurfacePairs;
struct SurfacePoint;
struct SurfacePoints;
struct SurfaceEdges;
struct SurfaceSlopes;
struct SlopesRowTask;
struct BlendRowsTask;
struct NearLinesTask;
struct SectionStripsTask;
struct OutlineTask;
struct StripNumbersTask;
struct CellTask;
struct CellExtremes;
struct PointLoads;
struct CornerLoads;
struct StressParts;

}  // namespace simd

/// All sets give the same bits.
struct Kernels {
  InstructionSet set;

  // geometry
  /// Fills the rows; false: not every one of them converged.
  bool (*fill_rows)(const simd::RowsTask& task);

  // normal contact
  /// Displacement at the middle of strip j by unit peak in each of the strips, over the compliance [m]. Its
  /// own element of the row is left to the caller.
  void (*influence_row)(const simd::InfluenceTask& task, std::int32_t j, double* row);
  void (*edge_displacements)(const simd::EdgeTask& task);
  void (*eliminate)(const simd::EliminationTask& task);
  /// Fills the strips: place, width, centre, and half length, that of the overlap of the row's parabola,
  /// sqrt(2 g / curvature).
  void (*divide_span)(const simd::SpanTask& task, const simd::StripArrays& strips);
  /// Displacement at the point by each strip of unit peak / half length, over the compliance [m^2]: see
  /// impose_approach (normal/elasticity/contact_condition.hpp). What strips nearer than their width do is
  /// left to the caller.
  void (*displacements_at)(const simd::PointTask& task, const simd::StripArrays& strips,
                           double* displacement);

  // rolling; fields are written by the kernels of fields only
  void (*march)(const simd::MarchTask& task, simd::Sums& sums);
  void (*march_fields)(const simd::MarchTask& task, simd::Sums& sums);
  void (*march_sensitivities)(const simd::MarchTask& task, simd::Sums& sums);
  void (*strip_fastsim)(const simd::StripFastsimTask& task, simd::Sums& sums);
  void (*strip_fastsim_fields)(const simd::StripFastsimTask& task, simd::Sums& sums);
  void (*strip_fastsim_sensitivities)(const simd::StripFastsimTask& task, simd::Sums& sums);

  // contact on the rail's surface
  /// Fills the arrays from loads and means on.
  void (*strip_numbers)(const simd::StripNumbersTask& task);
  /// Sums hold power and areas only: forces of strips with axes of their own do not add.
  void (*surface_march)(const simd::SurfaceMarchTask& task, simd::Sums& sums);
  void (*surface_march_fields)(const simd::SurfaceMarchTask& task, simd::Sums& sums);
  void (*surface_strips)(const simd::SurfaceStripsTask& task, simd::Sums& sums);
  void (*surface_strips_fields)(const simd::SurfaceStripsTask& task, simd::Sums& sums);
  void (*surface_strips_slopes)(const simd::SurfaceStripsSlopesTask& task);
  /// Fills a row for each of `rows` over `columns`, of whole vectors from whichever column.
  void (*surface_pairs)(const simd::SurfaceStrips& rows, const simd::SurfaceStrips& columns,
                        const simd::SurfacePairs& pairs);
  /// factor_k J_k cos_k for each source k, seen from points that are middles of strips: a row for each, of
  /// whole vectors; what a source does to itself is left out. `skewed`: not all centres are the same.
  void (*surface_influence)(const simd::SurfaceTables& tables, const simd::SurfaceSources& sources,
                            const simd::SurfacePairs& pairs, const simd::SurfacePoints& points, bool skewed,
                            double* rows, std::int64_t stride);
  /// That, on the diagonal of rows that are the sources'.
  void (*surface_own_influence)(const simd::SurfaceTables& tables, const simd::SurfaceSources& sources,
                                double* rows, std::int64_t stride);
  /// Sums of the same, seen from the edges of the sources, whose pairs with themselves are given.
  void (*surface_edges)(const simd::SurfaceTables& tables, const simd::SurfaceSources& sources,
                        const simd::SurfacePairs& pairs, const simd::SurfaceEdges& edges);
  /// Both, source by source, with their derivatives.
  void (*surface_influence_slopes)(const simd::SurfaceTables& tables, const simd::SurfaceSources& sources,
                                   const simd::SurfacePoint& point, const simd::SurfaceSlopes& slopes);
  void (*surface_edge_slopes)(const simd::SurfaceTables& tables, const simd::SurfaceSources& sources,
                              const simd::SurfacePoint& point, const simd::SurfaceSlopes& slopes);
  void (*slopes_row)(const simd::SlopesRowTask& task);
  void (*blend_rows)(const simd::BlendRowsTask& task);
  void (*near_lines)(const simd::NearLinesTask& task);
  /// Places strips between sections of a rail. Returns how steeply any of them falls along its normal, within
  /// task.within of there.
  double (*section_strips)(const simd::SectionStripsTask& task);
  /// Fills scratch.y, z and seen at the wheel's knots.
  void (*outline)(const simd::OutlineTask& task);
  /// Fills scratch.overlap, and piece and part of the strips whose rays the outline crosses less than
  /// `margin` above the rail, which lie from `begin` to before `end`.
  void (*cross_rays)(const simd::OutlineTask& task, double margin, std::int32_t& begin, std::int32_t& end);
  /// Fills the overlaps of overlaps.count strips, whose rays cross the chord of overlaps.piece at the part
  /// overlaps.u of it; then `u` is the length on the piece [m]. Depth -1 where the surfaces do not face each
  /// other.
  void (*follow_rays)(const simd::OutlineTask& task, const Overlaps& overlaps);

  // damage
  void (*assess_cells)(const simd::CellTask& task, simd::CellExtremes& extremes);
  /// Add what loads on a half-space do at a point of it.
  void (*stress_of_points)(const simd::PointLoads& loads, simd::StressParts& stress);
  void (*stress_of_corners)(const simd::CornerLoads& loads, simd::StressParts& stress);
};

/// The kernels of a set, which the processor must have.
const Kernels& kernels_for(InstructionSet set);

}  // namespace wrc
