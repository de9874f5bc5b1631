/// Contact temperature: friction heats the surfaces while they pass through the contact (Ertz, Knothe, Wear
/// 253 (2002) 498; Jaeger 1942, a source that moves fast).
///
/// In rolling heat has no time to spread along the surface: every strip is a row of points that pass, and
/// heat flows into the depth alone. A surface that takes up the heat flow q(s) at the distance s from the
/// leading edge has risen by
///     theta(s) = 1 / (beta sqrt(pi V)) Int_0^s q(s') / sqrt(s - s') ds',   beta = sqrt(lambda rho c),
/// c the specific heat. Both surfaces have the same temperature where they touch; that divides heat in the
/// ratio of their beta, and lets heat flow from the warmer body to the colder one:
///     T(s) = (beta_w T_w + beta_r T_r) / (beta_w + beta_r)
///            + 1 / ((beta_w + beta_r) sqrt(pi V)) Int_0^s q(s') / sqrt(s - s') ds'.
///
/// q is taken as linear between the middles of the cells and zero at the leading edge, and the integral is
/// exact for that: with h the cell's length and G(d) = 4/3 d^(3/2), the weight of a cell d cells upstream is
/// sqrt(h) (G(d + 1) - 2 G(d) + G(d - 1)), and that of the first, half a cell behind the edge,
/// sqrt(h) (2 G(d + 1/2) - 3 G(d) + G(d - 1)); G(d) = 0 for d < 0.
#pragma once

#include <cstdint>

#include "patch/strips.hpp"
#include "tangential/problem.hpp"

namespace wrc::tangential {

/// How bodies take up heat, beta = sqrt(lambda rho c) [W s^(1/2) / (m^2 K)].
struct Effusivities {
  double wheel = 1.0, rail = 1.0;

  double sum() const { return wheel + rail; }
};

/// Temperatures of the bodies away from the contact [degC].
struct BulkTemperatures {
  double wheel = 0.0, rail = 0.0;

  /// Common temperature of both surfaces as soon as they touch.
  double at_entry(const Effusivities& bodies) const {
    return (bodies.wheel * wheel + bodies.rail * rail) / bodies.sum();
  }
};

/// Most cells along a strip.
inline constexpr std::int32_t most_flash_cells = 512;

/// Weights of the integral over a strip of so many cells, over sqrt(h): of a cell so many cells upstream, and
/// of the first cell seen from so many behind it.
struct FlashWeights {
  explicit FlashWeights(std::int32_t cells);

  double inner[most_flash_cells], first[most_flash_cells];
};

/// Fills `rise` (cell i, strip j at i * region.count + j) with the rise over the temperature at entry at the
/// cells' middles [K]. fields: tractions [Pa] and slips, cell 0 at the leading edge; speed [m/s]. Work
/// proportional to strips times cells^2.
void flash_rise(const patch::Strips& region, const TangentialFields& fields, std::int32_t cells, double speed,
                const Effusivities& bodies, const FlashWeights& weights, double* rise);

/// Heat that passes from a body at `difference` [K] above the other into it by their touching alone, over a
/// strip of that length, per width [W/m].
double heat_by_touching(const Effusivities& bodies, double difference, double speed, double length);

}  // namespace wrc::tangential
