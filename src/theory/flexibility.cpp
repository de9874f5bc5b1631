#include "theory/flexibility.hpp"

#include <cmath>

#include "patch/material.hpp"

namespace wrc::theory {

Flexibility ellipse_flexibility(double a, double b, double shear_modulus, const KalkerTable& table,
                                Fault& fault) {
  // L1 = 8a / (3 G C11), L2 = 8a / (3 G C22), L3 = pi a sqrt(a/b) / (4 G C23) for both parts of spin
  const KalkerCoefficients k = table.at(a / b, fault);
  const double G = shear_modulus;
  const double l3 = pi * a * std::sqrt(a / b) / (4.0 * G * k.c23);
  return {8.0 * a / (3.0 * G * k.c11), l3, 8.0 * a / (3.0 * G * k.c22), l3};
}

Flexibility sdec_flexibility(double a, double b, double shape_number, double shear_modulus,
                             const SdecTable& table, Fault& fault) {
  // paper eq. 8: spin's part along x by K13, its part along y by C23s
  const SdecCoefficients s = table.at(a / b, shape_number, fault);
  const double G = shear_modulus;
  const double c = std::sqrt(a * b);
  return {8.0 * a / (3.0 * G * s.c11), 2.0 * c / (G * s.k13), 8.0 * a / (3.0 * G * s.c22),
          pi * a * a / (4.0 * G * c * s.c23)};
}

}  // namespace wrc::theory
