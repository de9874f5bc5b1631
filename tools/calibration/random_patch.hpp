/// Random patches in steady rolling: what the tangential default is fitted to and judged on.
#pragma once

#include <cstdint>
#include <vector>

#include "tangential/problem.hpp"

namespace wrc::calibration {

/// A strip of a patch with semi-elliptic pressure along x, as in patch/strips.hpp. SI units.
struct Strip {
  double y, width, centre, half_length, peak;
};

/// A contact patch and how it rolls. SI units.
struct Patch {
  double a, b, psi;                   ///< semi-axes (a along rolling) and shape number
  double poisson, shear_modulus;      ///< of both bodies
  double friction, normal_force, p0;  ///< p0: peak pressure
  tangential::Creepage creepage;      ///< about the joint of the half ellipses
  std::vector<Strip> strips;          ///< the patch; none: it is the SDEC itself
};

/// Patch `row` of the endless list that belongs to `seed`: the same on every machine, whichever rows were
/// made before it.
///
/// a/b 0.25 to 3 (logarithmic), |psi| <= 0.7, Poisson ratio 0.25 to 0.30, sqrt(ab) 3 to 8 mm, friction 0.1 to
/// 0.5, p0 0.5 to 1.8 GPa. The creepages' length, measured by the forces they cause in linear theory, is 0.05
/// to 6 friction limits, the geometric mean of two logarithmic draws: from nearly full adhesion to full slip,
/// most of them in between. Their direction: one patch in five without spin, one in four with spin alone, one
/// in six with spin against lateral creepage (where their forces cancel and methods differ most), the rest
/// anywhere.
Patch random_sdec(std::uint64_t seed, std::uint64_t row);

/// The same of an S1002 wheel on a UIC60 rail, solved by the strip half-space method: a, b, psi are those of
/// the equivalent SDEC. Lateral shift -6 to 5 mm, yaw up to 15 mrad either way, load 25 to 125 kN, cases with
/// one patch only; Poisson ratio, friction and creepages as above.
Patch random_wheel_on_rail(std::uint64_t seed, std::uint64_t row);

}  // namespace wrc::calibration
