/// Kalker's creepage coefficients of the linear theory for elliptic patches.
///
///     F_x = -G c^2 C11 nu_x,   F_y = -G c^2 C22 nu_y - G c^3 C23 phi,   c = sqrt(a b),
///
/// a semi-axis in the rolling direction, b across it.
#pragma once

#include "base/fault.hpp"
#include "theory/hermite.hpp"
#include "theory/node_values.hpp"

namespace wrc::theory {

struct KalkerCoefficients {
  double c11 = 0.0, c22 = 0.0, c23 = 0.0;  ///< [-]
};

/// The coefficients over a/b for one Poisson ratio in [0, 0.5].
///
/// Inside the table (psi = 0 of generated_tables.hpp, a/b from 0.05 to 20) the reciprocals 1/C (of C23 with a
/// factor sqrt(a/b)) are interpolated, C1 in (a - b) / (a + b) and quadratic in the Poisson ratio, to 0.1 %
/// at usual Poisson ratios. Beyond it Kalker's asymptotes for slender ellipses take over, multiplied by a
/// factor that continues the table in value and slope and fades to 1 linearly in the axis ratio: nothing
/// jumps.
class KalkerTable {
 public:
  KalkerTable() = default;
  explicit KalkerTable(double poisson);

  /// For any ratio a/b > 0; flags WRC_FLAG_TABLE_RANGE where the asymptotes are used.
  KalkerCoefficients at(double ratio, Fault& fault) const;

  double poisson() const { return poisson_; }

 private:
  using Reciprocal = HermiteTable<tables::ratio_count>;
  double poisson_ = 0.0;
  Reciprocal c11_, c22_, c23_;  ///< 1/C11, 1/C22, sqrt(a/b)/C23 over the slenderness
};

}  // namespace wrc::theory
