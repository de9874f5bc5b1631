/// Strip FASTSIM on the rail's surface: tractions of strips that each have their own rigid slip and their own
/// linear theory, with no patch between them.
///
/// It is the model of tangential/methods/strip_fastsim.hpp with the patch taken out of it, so that nothing
/// jumps when regions of contact meet, part, appear or vanish:
///
///  - Coefficients are the strip's own, by its peak per length lambda = peak / half length and its curvature
///    (strip_coefficients.hpp). All lengths of a patch drop out: adhesion tractions grow by
///    4 G C11 / (pi^2 mu lambda l) per unit of slip relative to the bound, and likewise along y and for spin.
///  - The rigid slip of a strip is (slip_x, slip_y + spin (x - centre)), as kinematics gives it: rolling
///    radius and turning over the width are in slip_x. Tractions of its
///    neighbours move a strip, too. That helps where their slips are alike, not where they differ: the local
///    part of slip_x counts more than once (gain() of strip_numbers.hpp).
///  - Numbers of a patch - slenderness, saturation, common slip - are replaced by means over neighbouring
///    strips that fade where contact gets thin: the mean A of a quantity a with the weights N (load) solves
///        N (A - a) = d/ds (beta^2 l^2 N dA/ds),
///    a diffusion over a part of the half length which stops where l vanishes. Three bands, one elimination
///    for all means; smooth in all loads and lengths, also through a neck that opens. Strips that enter have
///    no weight. How far the means reach hardly matters (beta^2 from 0.1 to 10): strips are local.
///  - Elastic slip that a strip has from the tractions beside it: lateral slip of contact that spins
///    (torsion), and to either side of the middle slip across the tractions (twist).
///  - Calibration (surface_calibration.hpp): smooth functions of slenderness and saturation, fitted to
///    poses of a wheel on a rail from tread to flange, with all of the flange's spin, solved exactly on the
///    curved surface (halfspace/tangential.hpp).
///
/// Nothing in here depends on which strips exist but through their loads.
#pragma once

#include <cstddef>
#include <cstdint>

#include "surface/rolling/strip_coefficients.hpp"
#include "surface/rolling/surface_calibration.hpp"
#include "tangential/march/march_grid.hpp"
#include "tangential/problem.hpp"

namespace wrc::surface {

/// How the strips are rolled. Every one takes the strips' own slips and coefficients.
enum class SurfaceRollingMethod {
  strip_fastsim,
  fastsim,  ///< FASTSIM with separate flexibilities, the bound mu p or the parabola of the same force in each
            ///< strip (`parabolic`); power is that of the march's slip
  fastrip,  ///< strip theory where a strip sticks, directions of FASTSIM with the common flexibility
            ///< where it slips (tangential/methods/fastrip.hpp); all four fields must be given
};

/// Strips in contact, by increasing place; one element per strip in arrays of the caller. A strip without
/// half length or peak carries nothing. Number is double, or one that carries derivatives.
template <class Number>
struct SurfaceRollingInputOf {
  std::int32_t count = 0;
  const double* place = nullptr;        ///< arc length of the strip's middle [m]
  const double* width = nullptr;        ///< [m]
  const Number* half_length = nullptr;  ///< [m]
  const Number* peak = nullptr;         ///< pressure at the strip's middle [Pa]
  const Number* curvature = nullptr;    ///< curvature of the undeformed gap along x [1/m], > 0
  const Number* slip_x = nullptr;       ///< rigid slip of the wheel over the rail at the strip's middle, over
  const Number* slip_y = nullptr;       ///< the rolling speed, in the strip's own axes [-]
  const Number* spin = nullptr;         ///< rotation about the strip's normal over the rolling speed [1/m]
  const Number* friction = nullptr;     ///< coefficient of every strip [-], >= 0
  double shear_modulus = 0.0;           ///< G, times the slope reduction of a layer between the bodies [Pa]
  double normal_shear_modulus = 0.0;    ///< G of the bodies, as the normal problem had it [Pa]
  double coupling = 0.0;                ///< Kalker's K of unlike bodies [-]
  tangential::Layer layer{};            ///< between the bodies
  const Number* flexibility = nullptr;  ///< F of each strip's layer, in place of `layer` [m/Pa]
  const double* yield = nullptr;        ///< its tau_0 [Pa]
  const double* hardening = nullptr;    ///< its k [Pa/m]
  const StripCoefficientTable* coefficients = nullptr;  ///< table of the bodies' Poisson ratio
  const tangential::MarchGrid* grid = nullptr;          ///< cells along each strip
  SurfaceRollingMethod method = SurfaceRollingMethod::strip_fastsim;
  bool parabolic = false;  ///< bound of FASTSIM
  const SurfaceCalibration* calibration = &fitted_surface_calibration;

  bool layered() const { return layer.present() || flexibility != nullptr; }
};
using SurfaceRollingInput = SurfaceRollingInputOf<double>;

/// The layer of strip j.
inline tangential::Layer layer_of(const SurfaceRollingInput& in, std::int32_t j) {
  return in.flexibility == nullptr ? in.layer
                                   : tangential::Layer{in.flexibility[j], in.yield[j], in.hardening[j]};
}

/// Forces on the wheel in each strip's own axes (x, and y along the surface) and moments about the strip's
/// normal through its middle: arrays of the caller.
struct SurfaceRollingForces {
  double* fx = nullptr;  ///< [N]
  double* fy = nullptr;  ///< [N]
  double* mz = nullptr;  ///< [N m]
};

/// Work of a strip's forces by its slips, per distance that these are over [N].
inline double work_by_slips(const SurfaceRollingForces& f, const double* slip_x, const double* slip_y,
                            const double* spin, std::int32_t k) {
  return f.fx[k] * slip_x[k] + f.fy[k] * slip_y[k] + f.mz[k] * spin[k];
}

/// Totals over all strips.
struct SurfaceRollingTotals {
  double power_per_speed = 0.0;    ///< frictional power over the rolling speed [N]
  double adhesion_fraction = 0.0;  ///< area that sticks over the area [-]
};

/// Doubles of working memory for `capacity` strips.
std::size_t surface_rolling_workspace(std::int32_t capacity);

/// Rolls the strips: fills `forces`, and `fields`, element (cell i, strip j) at i * count + j
/// (tangential/problem.hpp), or null pointers. Real-time: no memory but `workspace`, work proportional to
/// strips times cells. Finite input within the stated ranges gives finite results.
SurfaceRollingTotals roll_on_surface(const SurfaceRollingInput& input, void* workspace,
                                     const tangential::TangentialFields& fields,
                                     const SurfaceRollingForces& forces);

}  // namespace wrc::surface
