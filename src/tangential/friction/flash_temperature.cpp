#include "tangential/friction/flash_temperature.hpp"

#include <algorithm>
#include <cmath>

#include "base/elementary.hpp"

namespace wrc::tangential {
namespace {

double power_three_halves(double d) { return d > 0.0 ? d * std::sqrt(d) : 0.0; }

}  // namespace

FlashWeights::FlashWeights(std::int32_t cells) {
  for (std::int32_t d = 0; d < cells; ++d) {
    const double at = power_three_halves(d), before = power_three_halves(d - 1.0);
    inner[d] = 4.0 / 3.0 * (power_three_halves(d + 1.0) - 2.0 * at + before);
    first[d] = 4.0 / 3.0 * (2.0 * power_three_halves(d + 0.5) - 3.0 * at + before);
  }
}

void flash_rise(const patch::Strips& region, const TangentialFields& fields, std::int32_t cells, double speed,
                const Effusivities& bodies, const FlashWeights& weights, double* rise) {
  const std::int32_t strips = region.count;
  // Heat over the speed q / V = -s.p [N/m^2], not negative, though the march may leave a trace of the other
  // sign beside a stick zone.
  for (std::int32_t at = 0; at < cells * strips; ++at) {
    const double work = fields.slip_x[at] * fields.traction_x[at] + fields.slip_y[at] * fields.traction_y[at];
    rise[at] = std::max(0.0, -work);
  }
  const double scale = std::sqrt(speed / pi) / bodies.sum();
  // theta_i = sqrt(V h / pi) / (beta_w + beta_r) times the weighted sum of q / V over the cells k <= i. From
  // the last cell to the first, each in the place of its own heat, which the cells before it do not read.
  constexpr std::int32_t block = 64;  // strips at a time
  for (std::int32_t from = 0; from < strips; from += block) {
    const std::int32_t count = std::min(block, strips - from);
    double root_of_cell[block];
    for (std::int32_t j = 0; j < count; ++j)
      root_of_cell[j] = scale * std::sqrt(2.0 * region.half_length[from + j] / cells);
    for (std::int32_t i = cells - 1; i >= 0; --i) {
      double sum[block] = {};
      for (std::int32_t k = 0; k <= i; ++k) {
        const double weight = k == 0 ? weights.first[i] : weights.inner[i - k];
        const double* const heat = rise + k * strips + from;
        for (std::int32_t j = 0; j < count; ++j) sum[j] += weight * heat[j];
      }
      double* const here = rise + i * strips + from;
      for (std::int32_t j = 0; j < count; ++j) here[j] = root_of_cell[j] * sum[j];
    }
  }
}

double heat_by_touching(const Effusivities& bodies, double difference, double speed, double length) {
  return 2.0 * bodies.wheel * bodies.rail / bodies.sum() * difference * std::sqrt(speed * length / pi);
}

}  // namespace wrc::tangential
