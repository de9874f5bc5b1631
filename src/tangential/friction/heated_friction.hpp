/// Friction over temperature, found together with the tractions that heat.
///
/// A strip's coefficient is mu f g (friction.hpp), g the mean over its load of temperature_factor() at the
/// temperatures of its cells, which its own tractions make (flash_temperature.hpp). Tractions are solved a
/// few times, always as often, so that the result is as continuous in the inputs as each of them; in between
/// g of every strip is settled by
///     g = mean of temperature_factor(T_entry + g / g_before * rise),
/// `rise` [K] that of the tractions with g_before: heat is proportional to friction where all slides. The
/// right side falls as g grows, so that there is one solution. The remaining error is the change of slip by
/// friction. In the code g is a strip's `share` of its cold coefficient.
#pragma once

#include "base/fault.hpp"
#include "tangential/friction/flash_temperature.hpp"
#include "tangential/friction/friction.hpp"

namespace wrc::tangential {

/// Solutions of the tractions from cold surfaces.
inline constexpr int heat_solutions = 6;

class HeatedFriction {
 public:
  /// speed: of rolling [m/s]
  HeatedFriction(const FrictionLaw& law, const Effusivities& bodies, std::int32_t cells, double speed);

  /// The share at the temperature of entry, where friction has made no heat yet.
  double share_at_entry() const { return temperature_factor(law_, entry_); }

  /// Replaces the shares that `fields` were solved with by settled ones; returns the largest change. `keep`:
  /// the old ones stay. `rise`: work space over the cells, may be one of the slips. Reads count and half
  /// lengths of `region`.
  double settle(const patch::Strips& region, const TangentialFields& fields, bool keep, double* rise,
                double* share);

 private:
  double settled(double* rise, std::int32_t strips, double before) const;

  const FrictionLaw& law_;
  const Effusivities& bodies_;
  std::int32_t cells_;
  double speed_, entry_, weights_ = 0.0;
  double weight_[most_flash_cells];
  FlashWeights flash_;
};

/// Iterates: `solve` fills `fields` with the strips' present shares; shares and fields of the last solution
/// stay. `further`: number of further iterations from the shares as they are; 0: heat_solutions from those at
/// entry. Flags shares that still move by more than a thousandth.
template <class Solve>
Fault solve_heated(HeatedFriction& heat, const patch::Strips& region, const TangentialFields& fields,
                   double* rise, double* share, Solve&& solve, int further = 0) {
  const int solutions = further > 0 ? further : heat_solutions;
  for (std::int32_t j = 0; j < region.count && further == 0; ++j) share[j] = heat.share_at_entry();
  // after the last solution the shares are only compared: they must be those of its tractions
  double change = 0.0;
  for (int k = 0; k < solutions; ++k) {
    solve();
    change = heat.settle(region, fields, k + 1 == solutions, rise, share);
  }
  constexpr double settled = 1e-3;
  if (!(change > settled)) return {};
  return Fault::iteration_cap("friction.temperature_law", {change, ""},
                              "friction over temperature has not settled: this is its last change");
}

}  // namespace wrc::tangential
