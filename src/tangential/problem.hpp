/// The tangential problem of steady rolling that every FASTSIM variant reduces to, and its solution.
///
/// Contact frame, x rolling direction, origin at the reference point of the creepages (the initial contact
/// point unless a variant shifts it). Rigid slip per unit rolled length
///     w(x, y) = (longitudinal - spin y, lateral + spin x);
/// tractions act on the wheel and oppose it. Particles enter at the leading edge x = centre + half_length.
#pragma once

#include <cstddef>
#include <cstdint>

#include "patch/strips.hpp"
#include "tangential/friction/strip_friction.hpp"
#include "tangential/layer/layer.hpp"
#include "theory/flexibility.hpp"

namespace wrc::tangential {

struct Creepage {
  double longitudinal = 0.0;  ///< nu_x [-]
  double lateral = 0.0;       ///< nu_y [-]
  double spin = 0.0;          ///< phi [1/m]
};

/// Form of the traction bound tau_b(x, y) over a strip. All integrate to mu N over the patch where mu is the
/// same everywhere; where it is not, each strip has its own mu in place of the patch's.
enum class TractionBound {
  parabolic,    ///< mu N (x_l^2 - x^2) / IInt (x_l^2 - x^2) dA: Liu, Bruni (2024), eq. 9, on any region
  elliptic,     ///< mu p_n, the semi-elliptic pressure of each strip as the normal method gives it
  ellipsoidal,  ///< mu N sqrt(x_l^2 - x^2) / IInt sqrt(x_l^2 - x^2) dA: the pressure of a Kik-Piotrowski
                ///< patch
};

struct TangentialProblem {
  patch::Strips region;  ///< where tractions live, with their pressure
  Creepage creepage;
  theory::Flexibility flexibility;
  StripFriction friction;  ///< mu [-]
  TractionBound bound = TractionBound::parabolic;
  Layer layer{};  ///< between the bodies
};

/// Fields over cells: element (cell i, strip j) is at i * strips + j, cell 0 at the leading edge, so that one
/// march step of all strips is contiguous; strips is region.count. The middle of the cell is at
/// x = centre + half_length (1 - (2 i + 1) / cells). Memory is the caller's; nullptr leaves a field out.
struct TangentialFields {
  double* traction_x = nullptr;  ///< on the wheel [Pa]
  double* traction_y = nullptr;  ///< [Pa]
  double* slip_x = nullptr;      ///< sliding velocity / rolling speed [-]
  double* slip_y = nullptr;      ///< [-]

  bool any() const { return traction_x || traction_y || slip_x || slip_y; }
};

/// Multiplies the slips of the first `cells` cells, as far as they are wanted.
inline void scale_slips(double factor, std::ptrdiff_t cells, const TangentialFields& fields) {
  double* const slips[] = {fields.slip_x, fields.slip_y};
  for (double* const slip : slips)
    for (std::ptrdiff_t at = 0; slip && at < cells; ++at) slip[at] *= factor;
}

struct TangentialForces {
  double fx = 0.0, fy = 0.0;       ///< on the wheel [N]
  double mz = 0.0;                 ///< about the origin of the creepages [N m]
  double power_per_speed = 0.0;    ///< dissipated power / rolling speed [N]: -IInt (s . p) dA
  double adhesion_fraction = 0.0;  ///< area that sticks / area
};

/// Derivatives of the forces at a fixed patch, exact for the discrete model.
struct TangentialSensitivities {
  /// Rows: Fx, Fy, Mz. Columns: nu_x, nu_y, phi, N (pressure growing in proportion), mu.
  double d[3][5] = {};
};

// A problem may be solved about a point y of its frame: nu_x there is nu_x - y phi, and M_z comes back by
// - y F_x.

/// Creepages at y [m].
inline Creepage seen_from(double y, const Creepage& creepage) {
  return {creepage.longitudinal - creepage.spin * y, creepage.lateral, creepage.spin};
}

/// Forces of a problem solved about y, made those of the frame; so its sensitivities, nullptr: none.
inline void refer_back(double y, TangentialForces& forces, TangentialSensitivities* sensitivities) {
  forces.mz -= y * forces.fx;
  if (sensitivities == nullptr) return;
  auto& d = sensitivities->d;
  for (auto& row : d) row[2] -= y * row[0];
  for (int k = 0; k < 5; ++k) d[2][k] -= y * d[0][k];
}

}  // namespace wrc::tangential
