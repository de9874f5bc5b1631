/// Kalker's creepage coefficients of the linear theory for elliptic patches.
///
///     F_x = -G c^2 C11 nu_x,   F_y = -G c^2 C22 nu_y - G c^3 C23 phi,   c = sqrt(a b),
///
/// a semi-axis in the rolling direction, b across it.
#pragma once

#include "fault.hpp"
#include "linear_theory/coefficient_tables.hpp"
#include "linear_theory/hermite.hpp"

namespace wrc {

struct KalkerCoefficients {
  double c11 = 0.0, c22 = 0.0, c23 = 0.0;  ///< [-]
};

/// The coefficients over a/b for one Poisson ratio in [0, 0.5].
///
/// Inside Kalker's table (a/b from 0.1 to 10) the reciprocals 1/C are interpolated, C1 in a/b and quadratic
/// in the Poisson ratio; the table's three digits limit the accuracy to about 0.3 %. Beyond it Kalker's
/// asymptotes for slender ellipses take over. They differ from the table's ends by up to 9 %, so they are
/// multiplied by a factor that continues the table in value and slope and fades to 1 linearly in the axis
/// ratio: nothing jumps.
class KalkerTable {
 public:
  KalkerTable() = default;
  explicit KalkerTable(double poisson);

  /// For any ratio a/b > 0; flags WRC_FLAG_TABLE_RANGE where the asymptotes are used.
  KalkerCoefficients at(double ratio, Fault& fault) const;

  double poisson() const { return poisson_; }

 private:
  using Reciprocal = HermiteTable<tables::kalker.size()>;
  double poisson_ = 0.0;
  Reciprocal c11_, c22_, c23_;  ///< 1/C over the slenderness
};

}  // namespace wrc
