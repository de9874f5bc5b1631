/// Points of creep curves by the planar stage.
#pragma once

#include <cmath>

#include "wrc/wrc_planar.h"

/// Adhesion of a law at a slip, a speed [m/s] and a load [N]. The axes of the ellipse grow with the cube root
/// of the load, as in Hertz' theory. NaN where the stage fails or flags its result.
inline double creep_adhesion(wrc_contact* contact, wrc_ellipse ellipse, const wrc_friction& law, double slip,
                             double speed, double load) {
  const double grown = std::cbrt(load / ellipse.normal_force);
  ellipse.a *= grown;
  ellipse.b *= grown;
  ellipse.normal_force = load;
  wrc_creepage creepage = wrc_creepage_default();
  creepage.longitudinal = slip;
  creepage.speed = speed;
  wrc_planar_forces forces{};
  if (wrc_planar_tangential(contact, &ellipse, &creepage, &law, &forces) != WRC_OK) return std::nan("");
  return -forces.fx / forces.fn;
}
