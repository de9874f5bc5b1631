#include "patch/sdec.hpp"

#include <cmath>

#include "patch/material.hpp"

namespace wrc::patch {

double peak_pressure(const Sdec& sdec, double normal_force) noexcept {
  return 1.5 * normal_force / (pi * sdec.a * sdec.b);
}

void sdec_strips(const Sdec& sdec, double x_joint, double y_joint, double normal_force, std::int32_t count,
                 Strips& strips) noexcept {
  // An odd strip goes to the wider half.
  const std::int32_t negative = sdec.psi < 0.0 ? (count + 1) / 2 : count / 2;
  const double p0 = peak_pressure(sdec, normal_force);
  for (std::int32_t j = 0; j < count; ++j) {
    const bool positive_side = j >= negative;
    const std::int32_t on_side = positive_side ? count - negative : negative;
    const double b_side = sdec.b * (positive_side ? 1.0 + sdec.psi : 1.0 - sdec.psi);
    // Borders of the strip in y / b_side, counted outwards from the joint.
    const std::int32_t outwards = positive_side ? j - negative : negative - 1 - j;
    const double inner = static_cast<double>(outwards) / on_side;
    const double outer = static_cast<double>(outwards + 1) / on_side;
    // Mean of 1 - (y / b_side)^2 over the strip: l^2 and p^2 by it carry the load exactly.
    const double mean_square = 1.0 - (inner * inner + inner * outer + outer * outer) / 3.0;

    const double middle = 0.5 * (inner + outer) * b_side;
    strips.y[j] = y_joint + (positive_side ? middle : -middle);
    strips.width[j] = b_side / on_side;
    strips.centre[j] = x_joint;
    strips.half_length[j] = sdec.a * std::sqrt(mean_square);
    strips.peak[j] = p0 * std::sqrt(mean_square);
  }
  strips.count = count;
}

}  // namespace wrc::patch
