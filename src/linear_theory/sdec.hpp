/// Linear theory of the single double-elliptical contact (SDEC): two half-ellipses of common length 2a that
/// meet at the initial contact point, of widths b (1 + psi) for y > 0 and b (1 - psi) for y < 0.
///
///     F_x = -G c^2 C11s nu_x - G c^3 C13s phi,   F_y = -G c^2 C22s nu_y - G c^3 C23s phi,   c = sqrt(a b),
///
/// creepages and forces referred to the junction of the half-ellipses (Liu, Fu, Bruni 2022; Liu, Bruni 2024,
/// eq. 1-5).
#pragma once

#include "fault.hpp"
#include "linear_theory/kalker.hpp"

namespace wrc {

struct SdecCoefficients {
  double c11 = 0.0, c13 = 0.0, c22 = 0.0, c23 = 0.0;  ///< C11s, C13s, C22s, C23s [-]
  double k13 = 0.0;                                   ///< -C13s / psi, finite for psi = 0 [-]
};

/// The coefficients over a/b and psi for one Poisson ratio in [0, 0.5].
///
/// The shape's influence is tabulated for a/b from 0.2 to 5 and Poisson ratios from 0.25 to 0.30. Outside,
/// its interpolants continue smoothly: b11, b22, b23 fade to zero as a/b -> 0 or infinity, K13 keeps its
/// ratio to the one-flexibility value 0.75 C11 sqrt(b/a) along the ratio's end slope, and the Poisson ratio
/// enters as a straight line.
class SdecTable {
 public:
  SdecTable() = default;
  explicit SdecTable(double poisson);

  /// For any a/b > 0 and |psi| < 1; flags WRC_FLAG_TABLE_RANGE where the shape's influence is extrapolated.
  SdecCoefficients at(double ratio, double shape_number, Fault& fault) const;

  /// Those of an ellipse of the same material.
  const KalkerTable& ellipse() const { return ellipse_; }

  /// The Poisson ratio of the bodies.
  double poisson() const { return poisson_; }

 private:
  /// The table's rows and the two limits of slender patches.
  using Shape = HermiteTable<tables::sdec.size() + 2>;
  double poisson_ = 0.0;
  KalkerTable ellipse_;
  Shape b11_, b22_, b23_;
  Shape relative_k13_;  ///< K13 / (0.75 C11 sqrt(b/a))
};

}  // namespace wrc
