/// Friction over temperature, found together with the tractions that heat.
///
/// A strip has the mean over its load of the law at the temperatures of its cells. Tractions are solved a
/// few times, always as often, so that what is found is as continuous in the inputs as each of them; in
/// between each strip's share f of its cold coefficient, that at its sliding speed, is settled by
///     f = mean of temperature_factor(T_entry + f / f_before * rise),
/// `rise` what f_before made: heat is proportional to friction where all slides. The right side falls as f
/// grows, so that there is one solution. What is left is how slip changes with friction.
#pragma once

#include "base/fault.hpp"
#include "tangential/friction/flash_temperature.hpp"
#include "tangential/friction/friction.hpp"

namespace wrc {

/// Solutions of the tractions.
inline constexpr int heat_solutions = 6;

class HeatedFriction {
 public:
  /// speed: of rolling [m/s]
  HeatedFriction(const FrictionLaw& law, const Effusivities& bodies, std::int32_t cells, double speed);

  /// The share where friction makes no heat: of strips that have none yet.
  double share_at_entry() const { return temperature_factor(law_, entry_); }

  /// New shares in the place of those that `fields` were solved with; returns the largest change. `keep`:
  /// the old ones stay. `rise`: work space over the cells, may be one of the slips. `region`: counts and half
  /// lengths.
  double settle(const Strips& region, const TangentialFields& fields, bool keep, double* rise, double* share);

 private:
  double settled(double* rise, std::int32_t strips, double before) const;

  const FrictionLaw& law_;
  const Effusivities& bodies_;
  std::int32_t cells_;
  double speed_, entry_, weights_ = 0.0;
  double weight_[most_flash_cells];
  FlashWeights flash_;
};

/// Solves: `solve` with the strips' shares of their cold coefficients as they are, then fills `fields`; of
/// the last solution both are left. Flags shares that still move by more than a thousandth. `again`: so many
/// solutions from the shares as they are.
template <class Solve>
Fault solve_heated(HeatedFriction& heat, const Strips& region, const TangentialFields& fields, double* rise,
                   double* share, Solve&& solve, int again = 0) {
  const int solutions = again > 0 ? again : heat_solutions;
  for (std::int32_t j = 0; j < region.count && again == 0; ++j) share[j] = heat.share_at_entry();
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

}  // namespace wrc
