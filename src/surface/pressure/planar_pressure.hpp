/// Planar normal methods on the rail's surface, one patch at a time.
///
/// A method for half-spaces sees a gap over a plane. The plane of a patch is here the surface itself,
/// unrolled: y is the arc length of the rail's strips, the height of a row the strip's own overlap along its
/// own normal, with its own centre and curvature along x. On a surface that is flat over the patch this is
/// the gap over its contact plane; where it is not there is no plane whose choice could leap, and forces act
/// along the strips' own normals.
///
/// The overlap decides smoothly which strips are one patch (lobes.hpp). A lobe that is solved on its own has
/// the gap beyond its valley turned over and bent away, so that its patch ends there.
///
/// The method's strips, fitted to its patch, are laid over those of the rail: of each the load and the
/// squared half length in proportion to the width that lies on a strip of the rail. Load is kept, and a patch
/// enters a strip with zero load.
///
/// Jumps that remain are the method's own: a patch of several lobes has one lowest point, about which
/// these methods solve it, and it jumps where two lobes are as deep as each other.
#pragma once

#include <cstdint>

#include "base/fault.hpp"
#include "kernels/kernels.hpp"
#include "normal/problem.hpp"
#include "surface/geometry/overlap.hpp"
#include "surface/geometry/rail_strips.hpp"
#include "surface/pressure/pressure.hpp"

namespace wrc::surface {

struct PlanarMethod {
  Fault (*solve)(const normal::NormalProblem& problem, patch::Strips& strips,
                 normal::NormalSolution& solution) = nullptr;
  std::int32_t strips = 0;  ///< to divide a patch into
  std::int32_t max_iterations = 0;
  double force_tolerance = 0.0;
};

/// Overlaps are needed down to this far apart, for the gap beside the patch [m].
inline constexpr double planar_margin = 0.15e-3;

struct PlanarResult {
  Fault fault;                  ///< failed, or a flag
  std::int32_t iterations = 0;  ///< evaluations of the method
  bool jumps = false;  ///< a patch has several lobes as deep as its deepest, within 10 % of the overlap
};

/// Doubles of working memory for at most so many candidates.
std::int64_t planar_pressure_doubles(std::int32_t most, const PlanarMethod& method);

/// Solves at the depths given; `overlaps` found with planar_margin.
PlanarResult solve_planar_pressure(const RailStrips& rail, const Overlaps& overlaps,
                                   const PlanarMethod& method, const patch::Material& material,
                                   const Kernels& kernels, double* workspace,
                                   const StripPressure& pressure) noexcept;

}  // namespace wrc::surface
