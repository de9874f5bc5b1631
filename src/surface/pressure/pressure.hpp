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

/// Constants of a pair of bodies.
struct PressureModel {
  const InfluenceTables& influence;
  const Kernels& kernels;
  double compliance;  ///< (1 - nu) / (pi G) [1/Pa]
};

/// A solution over the strips of the rail, from which the next solve may start.
struct PressureStart {
  double* length_squared = nullptr;  ///< for every strip of the rail [m^2]
  double* shift = nullptr;           ///< c_j less the overlap's centre [m]
  double* depth = nullptr;           ///< of the overlap [m]
  bool set = false;
  bool extrapolated =
      false;  ///< length_squared is predicted for the new overlaps already, not found at `depth`
};

struct PressureOptions {
  /// Sweeps end without a solution after `assured_iterations`, when the squares of the strips in contact add
  /// up to `max_work`, which 40 of them reach by then; narrow patches take more sweeps, up to
  /// `max_iterations`.
  std::int32_t assured_iterations = 40, max_iterations = 160;
  double max_work = 64000.0;
  /// Part of the area that a sweep moves at which the step after it is the last. Lengths and strengths end
  /// ten and more times nearer: the step is taken, and strengths follow it.
  double tolerance = 1e-7;
};

/// Arrays over the candidates (Overlaps), in the caller's memory.
struct StripPressure {
  double* length_squared = nullptr;   ///< L [m^2]; 0: not in contact
  double* peak_per_length = nullptr;  ///< lambda [Pa/m]
  double* centre = nullptr;           ///< c [m]
  double* line_load = nullptr;        ///< q = lambda L [N/m]; N = pi/2 w q
};

struct PressureResult {
  std::int32_t iterations = 0;
  bool converged = false;
};

/// Doubles of working memory for at most so many candidates.
std::int64_t pressure_doubles(std::int32_t most);

/// Solves at the depths given. `start` is read where it is set, and left with the solution.
PressureResult solve_pressure(const PressureModel& model, const RailStrips& rail, const Overlaps& overlaps,
                              const PressureOptions& options, double* workspace, PressureStart& start,
                              const StripPressure& pressure) noexcept;

}  // namespace wrc
