#include "tangential/friction/heated_friction.hpp"

#include <algorithm>
#include <cmath>

namespace wrc::tangential {

HeatedFriction::HeatedFriction(const FrictionLaw& law, const Effusivities& bodies, std::int32_t cells,
                               double speed)
    : law_(law),
      bodies_(bodies),
      cells_(cells),
      speed_(speed),
      entry_(BulkTemperatures{law.wheel_temperature, law.rail_temperature}.at_entry(bodies)),
      flash_(cells) {
  // weights of a mean over the strip's load: the semi-ellipse of pressure at the cells' middles
  for (std::int32_t i = 0; i < cells; ++i) {
    const double xi = (2.0 * i + 1.0) / cells - 1.0;
    weight_[i] = std::sqrt(1.0 - xi * xi);
    weights_ += weight_[i];
  }
}

double HeatedFriction::settle(const patch::Strips& region, const TangentialFields& fields, bool keep,
                              double* rise, double* share) {
  // temperatures of all cells, then the share of each strip by itself
  constexpr double least_share = 1e-6;  // below, there is no heat to go by
  flash_rise(region, fields, cells_, speed_, bodies_, flash_, rise);
  double change = 0.0;
  for (std::int32_t j = 0; j < region.count; ++j) {
    if (!(share[j] > least_share)) continue;
    const double next = settled(rise + j, region.count, share[j]);
    change = std::max(change, std::fabs(next - share[j]));
    if (!keep) share[j] = next;
  }
  return change;
}

/// The share g of one strip, whose cells' rises `rise` are those of the share `before`.
double HeatedFriction::settled(double* rise, std::int32_t strips, double before) const {
  // Newton's method on g - mean of h(T_entry + g rise / g_before), which grows with g; steps that leave the
  // bracket are halved into it.
  for (std::int32_t i = 0; i < cells_; ++i) rise[i * strips] /= before;
  double low = law_.hot_ratio, high = 1.0, f = before;
  constexpr int most_steps = 30;
  for (int step = 0; step < most_steps; ++step) {
    double sum = 0.0, slopes = 0.0;
    for (std::int32_t i = 0; i < cells_; ++i) {
      const double per_share = rise[i * strips];
      double slope = 0.0;
      sum += weight_[i] * temperature_factor(law_, entry_ + per_share * f, &slope);
      slopes += weight_[i] * slope * per_share;
    }
    const double excess = f - sum / weights_;
    if (excess > 0.0) {
      high = f;
    } else {
      low = f;
    }
    const double next = f - excess / (1.0 - slopes / weights_);
    if (std::fabs(excess) < 1e-13) return f;
    f = next > low && next < high ? next : 0.5 * (low + high);
  }
  return f;
}

}  // namespace wrc::tangential
