/// Contact of a wheel with one face of a rail at a given height: the normal problem over the gaps along the
/// rows' normals, and with friction rolling over the sliding velocity of every cell's own surface points, in
/// turn.
///
/// Each problem's part in the other (Blanco-Lorenzo et al., Tribology Int. 103, 2016; d the angle between
/// the normals of two rows, turned_convolution.hpp; K Kalker's coupling of unlike bodies):
///     gap         h + sum sin d (K_xy p_x + K_yy p_y) + K (p_x x + p_y y) / r^2 / (pi G)
///     rigid slip  w - d/dx sum sin d K_zz p_n
#pragma once

#include "halfspace/surface_contact.hpp"

namespace wrc::halfspace {

struct FaceProblem {
  const WheelAndRail& bodies;
  const RailSurface& face;
  const surface::WheelOnRail& state;  ///< at the height and above the axle of a roller
  const SurfaceOptions& options;
  bool with_friction = false;
  const SurfaceSolution* start = nullptr;  ///< solution near this one, for its tractions; nullptr: none
  ProgressCallback progress = {};
};

/// Solves into `s`, which has no more than its height yet; forces in the axes of `state`.
void solve_face(const FaceProblem& in, SurfaceSolution& s);

}  // namespace wrc::halfspace
