/// Normal contact on the curved surface: Overlaps -> StripPressure. Strips of semi-elliptic pressure in
/// half-space equilibrium. docs/surface_solver.md has the drawing, the flow chart and a solve in numbers.
///
/// Strip j carries p_j(x) = lambda_j sqrt(L_j - (x - c_j)^2), L_j = l_j^2 >= 0 its squared half length,
/// lambda_j its peak per length, and the load N_j = pi/2 w_j lambda_j L_j along its own normal n_j.
///
///   contact   u_i = sum_j C w_j lambda_j l_j J(|s_i - s_j| / l_j, (c_i - c_j) / l_j) cos(a_i - a_j)
///             d_i = depth_i - kappa_i/2 shift_i^2, the overlap at c_i, shift_i = c_i - W_i from where it is
///             largest
///             u_i = d_i   where L_i > 0
///             u_i >= d_i  where L_i = 0
///   edges     over the half length the displacement falls by kappa_i/2 l_i^2; the lambda that makes it so
///             is smoothed over the strips beside, weighted by their loads: a strip that enters has weight
///             zero. Its difference between the edges is 2 kappa_i l_i shift_i, smoothed the same way.
///
/// An iteration solves the contact condition for q = lambda L at the present lengths (active_set.hpp). From
/// the edges it finds lambda, with it the next lengths L = q / lambda, and the next centres
/// (edge_condition.hpp). Alone that leaves 0.1 to 0.6 of an error, by how smooth it is; preconditioned and
/// accelerated by Anderson's method over (L, shift) it leaves about 0.1 (iteration.hpp). start.hpp: where it
/// begins.
///
/// Unknowns enter at L = 0 and leave there, on strips that never move, so the solution is a continuous
/// function of the depths: of the pose. Distances are arc lengths; the cosine between two strips' directions
/// is all that turning does to equal materials.
///
///   symbol          array              unit    of
///   d, kappa, W     Overlaps.depth, curvature, centre  m, 1/m, m  candidate
///   L               length_squared     m^2     candidate; 0: not in contact
///   lambda          peak_per_length    Pa/m    candidate in contact
///   c               centre             m       candidate
///   q = lambda L    line_load          N/m     candidate; the strip's load is pi/2 w q
///   C               compliance         1/Pa    pair of bodies, (1 - nu) / (pi G)
///   J               influence          -       displacement by unit q on a unit half length and width
#pragma once

#include <cstdint>

#include "kernels/kernels.hpp"
#include "normal/elasticity/influence_tables.hpp"
#include "surface/geometry/overlap.hpp"
#include "surface/pressure/smoothing.hpp"

namespace wrc::surface {

/// Constants of a pair of bodies.
struct PressureModel {
  const normal::InfluenceTables& influence;
  const Kernels& kernels;
  double compliance;                           ///< (1 - nu) / (pi G) [1/Pa]
  double lambda_length = usual_lambda_length;  ///< lambda_reach() is at least this [m]
  bool along_track = false;                    ///< the rail changes along the track
};

/// Change from an earlier solution to a later one, by the strips of the later one. It is 0 for strips whose L
/// is not known in both.
struct SolutionChange {
  const double* length_squared = nullptr;  ///< L [m^2]
  const double* shift = nullptr;           ///< c less the overlap's centre [m]
  const double* depth = nullptr;           ///< overlap [m]
};

/// A solution over the strips that overlapped, from which a later solve may start: `count` of them by
/// increasing number.
struct PressureStart {
  double* strip = nullptr;           ///< number among the rail's strips
  double* length_squared = nullptr;  ///< L [m^2]; beside contact negative (activate()); 0: not known
  double* shift = nullptr;           ///< c less the overlap's centre [m]
  double* depth = nullptr;           ///< overlap it was found at [m]
  std::int32_t count = 0;
  /// Until they are used, changes from the solution before to this one, and from that before to the one
  /// before. NULL: not known.
  SolutionChange change{}, earlier{};
};

/// Calls each(i, b) for each strip that is in both of two lists, at i in the first and b in the second. Both
/// lists increase. `other`: an array of numbers, or anything with numbers by [].
template <class Number, class Count, class Others, class Each>
void for_shared_strips(std::int32_t count, const Number* strip, Count others, const Others& other,
                       const Each& each) {
  Count b = 0;
  for (std::int32_t i = 0; i < count; ++i) {
    while (b < others && other[b] < strip[i]) ++b;
    if (b == others) return;
    if (other[b] == strip[i]) each(i, b);
  }
}

/// Where a solve starts.
enum class StartFrom {
  overlaps,      ///< from the overlaps alone
  solution,      ///< from an earlier solution, moved as its overlaps have moved since
  extrapolation  ///< from lengths that are predicted for the overlaps: they are not moved again
};

struct PressureOptions {
  /// Part of the area that an iteration moves at which it is the last. Its step is taken and line loads
  /// follow it, so that L and q end ten and more times nearer.
  double tolerance = 1e-7;
  /// Work that a solve may take: pairs of strips of which one displaces the other, each time it does. The
  /// iteration that would exceed it is not begun, but for the first.
  double max_work = 2e7;
  double max_iterations = 1e6;  ///< the same in iterations over all strips that overlap
};

/// Arrays over the candidates (Overlaps), in the caller's memory.
struct StripPressure {
  double* length_squared = nullptr;   ///< L [m^2]; 0: not in contact
  double* peak_per_length = nullptr;  ///< lambda [Pa/m]; 0: not in contact
  double* centre = nullptr;           ///< c [m]
  double* line_load = nullptr;        ///< q = lambda L [N/m]; N = pi/2 w q
};

struct PressureResult {
  std::int32_t iterations = 0;  ///< in all, those at half resolution included
  double work = 0.0;            ///< in all (PressureOptions::max_work)
  double residual = 0.0;        ///< part of the area that the last iteration moved; of the best one at a cap
  std::int32_t strips = 0;      ///< in contact, of the best one at a cap
  bool converged = false;
};

/// Doubles of working memory for at most so many candidates.
std::int64_t pressure_doubles(std::int32_t most);

/// Solves at the depths given. `start` is read unless `from` the overlaps, and left with the solution.
PressureResult solve_pressure(const PressureModel& model, const RailStrips& rail, const Overlaps& overlaps,
                              const PressureOptions& options, double* workspace, PressureStart& start,
                              StartFrom from, const StripPressure& pressure) noexcept;

}  // namespace wrc::surface
