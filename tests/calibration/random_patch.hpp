/// Random SDEC patches in steady rolling: what the tangential default is fitted to and judged on.
#pragma once

#include <cstdint>

#include "tangential/problem.hpp"

namespace wrc::calibration {

/// A simple double-elliptical contact with semi-elliptic pressure, and how it rolls. SI units.
struct Patch {
  double a, b, psi;                   ///< semi-axes (a along rolling) and shape number
  double poisson, shear_modulus;      ///< of both bodies
  double friction, normal_force, p0;  ///< p0: peak pressure
  Creepage creepage;                  ///< about the joint of the half ellipses
};

/// Patch `row` of the endless list that belongs to `seed`: the same on every machine, whichever rows were
/// made before it.
///
/// a/b 0.25 to 3 (logarithmic), |psi| <= 0.7, Poisson ratio 0.25 to 0.30, sqrt(ab) 3 to 8 mm, friction 0.1 to
/// 0.5, p0 0.5 to 1.8 GPa. The creepages' length, measured by the forces they cause in linear theory, is 0.1
/// to 6 friction limits (logarithmic). Their direction: one patch in five without spin, one in five with spin
/// alone, one in five with spin against lateral creepage (where their forces cancel and methods differ most),
/// the rest anywhere.
Patch random_patch(std::uint64_t seed, std::uint64_t row);

}  // namespace wrc::calibration
