/// Linear theory of the single double-elliptical contact (SDEC): two half-ellipses of common length 2a that
/// meet at the initial contact point, of widths b (1 + psi) for y > 0 and b (1 - psi) for y < 0.
///
///     F_x = -G c^2 C11s nu_x - G c^3 C13s phi,   F_y = -G c^2 C22s nu_y - G c^3 C23s phi,   c = sqrt(a b),
///
/// creepages and forces referred to the junction of the half-ellipses (Liu, Fu, Bruni 2022; Liu, Bruni 2024,
/// eq. 1-5).
#pragma once

#include "base/fault.hpp"
#include "theory/kalker.hpp"

namespace wrc::theory {

struct SdecCoefficients {
  double c11 = 0.0, c13 = 0.0, c22 = 0.0, c23 = 0.0;  ///< C11s, C13s, C22s, C23s [-]
  double k13 = 0.0;                                   ///< -C13s / psi, finite for psi = 0 [-]
};

/// The coefficients over a/b and psi for one Poisson ratio in [0, 0.5].
///
/// For psi = 0 C11s, C22s, C23s are exactly the ellipse's. The shape's influence, at every a/b of
/// generated_tables.hpp, is fitted over psi = 0.2 to 0.95 by
///     C11s = C11 (1 + b psi^2 + d psi^4) and likewise C22s, C23s;  K13 = 0.75 C11 sqrt(b/a) (k + m psi^2),
/// so is smooth in psi; b, d, k, m are interpolated C1 in log(a/b) (quadratic in the Poisson ratio). Beyond
/// a/b = 0.05 and 20, b and d fade to zero, k and m follow their end slopes.
class SdecTable {
 public:
  SdecTable() = default;
  explicit SdecTable(double poisson);

  /// For any a/b > 0 and |psi| < 1; flags WRC_FLAG_TABLE_RANGE beyond a/b = 0.05 to 20 and |psi| = 0.95.
  SdecCoefficients at(double ratio, double shape_number, Fault& fault) const;

  /// Those of an ellipse of the same material.
  const KalkerTable& ellipse() const { return ellipse_; }

  /// The Poisson ratio of the bodies.
  double poisson() const { return poisson_; }

 private:
  /// The table's nodes and the two limits of slender patches.
  using Shape = HermiteTable<tables::ratio_count + 2>;
  /// Relative influence of psi^2 and psi^4.
  struct Influence {
    Shape second, fourth;
  };
  double poisson_ = 0.0;
  KalkerTable ellipse_;
  Influence c11_, c22_, c23_;
  Shape k13_, k13_second_;  ///< k and m

  static Influence influence(std::size_t coefficient, double poisson);
};

}  // namespace wrc::theory
