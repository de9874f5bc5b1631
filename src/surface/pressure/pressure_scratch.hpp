/// Working memory of a pressure solve (pressure.hpp), shared by its parts: active_set, edge_condition,
/// iteration, newton, start.
///
///   symbol        array                unit    of
///   s, w          place, width         m       each strip: arc length of its middle, width
///   d, kappa      depth, curvature     m, 1/m  each strip: largest overlap, its curvature along x
///   W             deepest_x            m       each strip: x of the largest overlap
///   n             ny, nz               -       each strip: direction
///   L, c - W      L, shift             m^2, m  each strip: unknowns of the iteration
///   q             q                    N/m     each strip: line load
///   l             half_length          m       each strip, and each active strip
///   C w / l       active.factor        1/Pa    active strip: displacement by unit q over the influence J
///   w / (2 l)     active.half_width    -       active strip
///   M             matrix               1/Pa    displacement at row's middle by unit q of column
///   u+, u-        u_leading, u_trailing  m     active strip: displacements at c + l and c - l
///   lambda*, c*   edge_lambda, edge_shift  Pa/m, m  active strip: asked for by its own edges
///   f             residual             m^2, m  fixed-point residual: of L, then of the shifts
///   x, f          iterate[]            m^2, m  ring buffer: (L, shifts) and the step asked for there
#pragma once

#include <cstdint>

#include "base/arena.hpp"
#include "kernels/kernels.hpp"
#include "surface/simd/tasks.hpp"

namespace wrc::surface {

inline constexpr std::int32_t rows_at_a_time = 8;  ///< rows of the elimination without a place

inline constexpr std::int32_t history = 5;  ///< earlier iterates the acceleration combines

/// Fewer strips count as so many: kernels and the elimination take as many at once.
inline constexpr std::int32_t fewest_counted = 4;

/// Work in which each of so many strips displaces each: twice that in an iteration.
inline double work_of_pass(std::int32_t strips) {
  const double n = strips < fewest_counted ? fewest_counted : strips;
  return n * n;
}

/// Constants of a solve.
struct PressureProblem {
  const Kernels& kernels;
  simd::SurfaceTables tables;
  double compliance;     ///< C [1/Pa]
  double lambda_length;  ///< as PressureModel
  bool along_track;      ///< as PressureModel
};

/// Strips that are solved for: the candidates, or pairs of them.
struct StripSet {
  std::int32_t count = 0;
  std::int32_t behind = 0;  ///< strips from here on are second places: no neighbours of those before
  bool skewed = false;      ///< deepest_x differs from strip to strip: shifts are unknowns, too
  double *place, *width, *depth, *curvature, *deepest_x, *ny, *nz;  ///< given
  double *L, *shift, *q;                                            ///< solution; c = deepest_x + shift
};

/// Strips in contact, as sources of displacement; whole packs, those behind the last without effect.
struct ActiveStrips {
  std::int32_t count = 0, behind = 0;  ///< behind: as in the StripSet
  std::int32_t* index;                 ///< in the StripSet
  double *place, *centre, *half_length, *inverse_length, *half_width, *factor;
  double* q;                  ///< not negative [N/m]
  double* load_factor;        ///< factor q [m]
  double* load;               ///< w q [N], weights of the means
  double *width, *ny, *nz;    ///< width: 0 of second places, whose width is not seen from the first ones
  double* width_behind;       ///< the same for second places as points: 0 of the first ones
  double* per_lambda_reach;   ///< one over lambda_reach() [1/m]
  double* per_apart_squared;  ///< 1 over the squared distance to the strip behind [1/m^2]; 0 over a gap
};

/// An iterate and its step.
struct Iterate {
  double *x, *f;     ///< L, then shifts
  double* q;         ///< line loads at x
  double moved = 0;  ///< part of the area that the map moves x by
};

/// Size of the move that the fixed-point map asks for.
struct Change {
  double moved = 0.0, area = 1.0;  ///< sums over strips of w (|f_L| + |f_shift| l) and of w (L + f_L) [m^3]
};

struct PressureScratch {
  StripSet fine, coarse;
  double work = 0.0;      ///< so far, of the whole solve (PressureOptions::max_work)
  double max_work = 0.0;  ///< that it may take
  double* depth_before;   ///< each strip: overlap of the solution that a solve starts from [m]
  ActiveStrips active;
  std::int32_t* in_contact;  ///< each strip: 1 in the active set
  double* half_length;       ///< each strip: l, at least a part of its width [m]
  double* continued;  ///< each strip that was asked and is not in contact: L < 0 [m^2] (activate()); else 0
  double *matrix, *solution;  ///< elimination (simd::EliminationTask)
  std::int64_t places;        ///< doubles of the matrix, which many strips do not fit in
  double* rows;               ///< rows_at_a_time of such many
  std::int32_t* outside;      ///< strips asked whether they enter
  double *outside_place, *outside_x, *outside_ny, *outside_nz;
  double *u_leading, *u_trailing, *edge_lambda, *edge_shift;
  double* inverse_reach;                     ///< each strip: one over shift_reach() [1/m]
  double *residual, *residual_before;        ///< L and shifts; L in the iteration before
  Change change;                             ///< in the last iteration
  double *rim_weight, *upper, *smooth_part;  ///< for precondition()
  Iterate iterate[history + 1];
  Iterate best;  ///< the iterate that the map moves least, of all attempts that failed
  double products[history + 1][history + 1];  ///< scalar products of the iterates' steps
  double shares[history];                     ///< shares g of earlier iterates in `next`
  double* next;                               ///< accelerated iterate
  std::int32_t* pair_of;                      ///< each strip: its pair in `coarse`
};

/// Cuts the arrays for at most so many strips.
PressureScratch cut_pressure_scratch(Arena& arena, std::int32_t most);

/// Overlap at the centre of a strip's pressure, which lies beside the largest overlap under yaw:
/// d - kappa/2 shift^2 [m].
inline double overlap_at_centre(const StripSet& s, std::int32_t i) {
  return s.depth[i] - 0.5 * s.curvature[i] * s.shift[i] * s.shift[i];
}

}  // namespace wrc::surface
