/// Normal contact on the curved surface: strips of semi-elliptic pressure in half-space equilibrium.
///
/// Strip j carries p_j(x) = lambda_j sqrt(L_j - (x - c_j)^2), L_j = l_j^2 >= 0 its squared half length,
/// lambda_j its level, and the load N_j = pi/2 w_j lambda_j L_j along its own normal n_j.
///
///   contact   u_i = sum_j C w_j lambda_j l_j J(|s_i - s_j| / l_j, (c_i - c_j) / l_j) cos(a_i - a_j)
///             d_i = depth_i - kappa_i/2 shift_i^2, the overlap at c_i, shift_i from where it is largest
///             u_i = d_i   where L_i > 0
///             u_i >= d_i  where L_i = 0
///   edges     over the half length the displacement falls by kappa_i/2 l_i^2; the level that makes it so
///             is smoothed over the strips beside, weighted by their loads: a strip that enters has weight
///             zero. Its difference between the edges is 2 kappa_i l_i shift_i, smoothed the same way.
///
/// A sweep solves the contact condition for q = lambda L at the present lengths, finds the levels from the
/// edges, and with them the next lengths L = q / lambda and centres. Alone that leaves 0.1 to 0.6 of an
/// error, by how smooth it is; steps that make up for that, accelerated by Anderson's method over (L, c),
/// leave about 0.1, but no strip is held or sent back that plain sweeps move much: close to where regions
/// meet the residual has minima that are no solutions.
///
/// Unknowns enter at L = 0 and leave there, on strips that never move, so the solution is a continuous
/// function of the depths: of the pose. Distances are arc lengths; the cosine between two strips' directions
/// is all that turning does to equal materials.
#pragma once

#include <cstdint>

#include "kernels/kernels.hpp"
#include "normal/elasticity/influence_tables.hpp"
#include "surface/geometry/overlap.hpp"

namespace wrc {

/// A solution over the strips of the rail, from which the next solve may start.
struct SurfaceStart {
  double* length_squared = nullptr;  ///< for every strip of the rail [m^2]
  double* shift = nullptr;           ///< c_j less the overlap's centre [m]
  double* depth = nullptr;           ///< of the overlap [m]
  bool set = false;
  bool led = false;  ///< lengths are those expected at the next depths already, not those found at `depth`
};

struct SurfaceNormalOptions {
  /// Sweeps end without a solution after `assured_sweeps`, when the squares of the strips in contact add up
  /// to `max_work`, which 40 of them reach by then; narrow patches take more sweeps, up to `max_sweeps`.
  std::int32_t assured_sweeps = 40, max_sweeps = 160;
  double max_work = 64000.0;
  /// Part of the area that a sweep moves at which the step after it is the last. Lengths and strengths end
  /// ten and more times nearer: the step is taken, and strengths follow it.
  double tolerance = 1e-7;
};

/// Arrays over the candidates (Overlaps), in the caller's memory.
struct SurfacePressure {
  double* length_squared = nullptr;  ///< L [m^2]; 0: not in contact
  double* level = nullptr;           ///< lambda [Pa/m]
  double* centre = nullptr;          ///< c [m]
  double* strength = nullptr;        ///< q = lambda L [Pa m]; N = pi/2 w q
};

struct SurfaceNormalResult {
  std::int32_t sweeps = 0;
  bool converged = false;
};

/// Doubles of working memory for at most so many candidates.
std::int64_t surface_normal_doubles(std::int32_t most);

/// Solves at the depths given. `start` is read where it is set, and left with the solution. `compliance`:
/// that of the pair, (1 - nu) / (pi G) [1/Pa].
SurfaceNormalResult solve_surface_normal(const RailStrips& rail, const Overlaps& overlaps,
                                         const InfluenceTables& influence, const Kernels& kernels,
                                         double compliance, const SurfaceNormalOptions& options,
                                         double* workspace, SurfaceStart& start,
                                         const SurfacePressure& pressure) noexcept;

}  // namespace wrc
