/// The strip half-space solver: exact-grade normal contact in real time, the accurate default method.
///
/// Every strip has its own peak p_j, half length l_j and centre x_cj, found from the contact conditions of
/// the elastic half-space instead of from one point:
///
///   at strip centres   u(x_cj, y_j)        = delta - h(x_cj, y_j)          a dense linear system for p
///   at strip edges     u(x_cj +- l_j, y_j) = delta - h(x_cj +- l_j, y_j)   smooth edges: l_j and x_cj
///   displacement       u(x, y) = (1 - nu) / (pi G) sum_i p_i (potential of a line of half length l_i over
///                                the width of strip i; influence_tables.hpp)
///   p_j >= 0: strips that would pull leave, strips where the bodies would overlap enter.
///
/// All contact regions of the gap are in one system, so that neighbouring spots push each other apart as they
/// do in reality. Each iteration solves p for the present lengths and then moves the lengths; three to
/// five are enough from a cold start. With load prescribed the approach is one more unknown of the linear
/// system: there is no outer root find.
///
/// The solver's own strips stand where the gap needs them (collocation_grid.hpp). It returns the
/// solution cut again into problem.strips strips of equal width per patch, between borders where l^2
/// extrapolates to zero: they move smoothly when strips of the solver enter or leave. Strips of different
/// patches are separated by a gap in y (patch_end() below).
///
/// Limits: pressure semi-elliptic along each strip (exact for elliptic contact; within 1 % elsewhere);
/// half-space theory, so no conformal contact.
#pragma once

#include "normal/elasticity/influence_tables.hpp"
#include "normal/problem.hpp"

namespace wrc::normal {

struct StripHalfspaceOptions {
  std::int32_t max_sweeps = 16;  ///< iterations at most: config.planar.max_sweeps
  double tolerance = 5e-3;       ///< part of the area still to be moved at which iterations end [-]
};

/// Scratch memory of a solve, aligned for double; nothing in it outlives the call.
struct NormalWorkspace {
  void* memory = nullptr;
  std::int64_t bytes = 0;
};

/// Bytes of scratch memory a solve with this many strips needs.
std::int64_t strip_halfspace_workspace(std::int32_t strips) noexcept;

/// The last solution, from which the next solve of the same contact starts (or not: count = 0 is a cold
/// start). Plain memory of the caller, so that saving and restoring a contact is a copy; arrays of at least
/// problem.strips elements.
struct StripHalfspaceStart {
  std::int32_t capacity = 0;
  std::int32_t count = 0;
  double* y = nullptr;               ///< middles of the solver's strips in contact [m]
  double* width = nullptr;           ///< [m]
  double* length_squared = nullptr;  ///< l^2 [m^2]
  double* shift = nullptr;           ///< x_c less the gap's own centre [m]
};

/// Solves the problem. Statuses as the other methods (check.hpp, load_search.hpp); WRC_FLAG_ITERATION_CAP
/// when max_sweeps ended it: the patch is then that of the last iteration, in equilibrium with the load.
Fault solve_strip_halfspace(const NormalProblem& problem, const StripHalfspaceOptions& options,
                            const InfluenceTables& influence, NormalWorkspace& workspace,
                            StripHalfspaceStart& start, patch::Strips& strips,
                            NormalSolution& solution) noexcept;

}  // namespace wrc::normal
