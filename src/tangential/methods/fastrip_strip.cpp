#include "tangential/methods/fastrip_strip.hpp"

#include <algorithm>
#include <cmath>

namespace wrc::tangential {
namespace {

/// The mean over a cell of sqrt((u - u_s) / u) weighted by sqrt(u), u running from `ahead` cells down to
/// `ahead - 1`, both of the strip's trailing edge; zero where the cell lies in the slip zone.
double stick_share(double ahead, double slip_cells) {
  const auto area = [](double u) { return u > 0.0 ? u * std::sqrt(u) : 0.0; };
  return (area(ahead - slip_cells) - area(ahead - 1.0 - slip_cells)) / (area(ahead) - area(ahead - 1.0));
}

}  // namespace

StripSolution solve_strip(const StripGrowth& growth, double steepness, double y, double centre,
                          double half_length) {
  // q, r [m] and psi [-]; with q = r = 0 all of the strip sticks where |psi| < 1
  StripSolution strip;
  const double q = -(growth.longitudinal - growth.longitudinal_spin * y) / steepness;
  strip.psi = -growth.lateral_spin / steepness;
  const double r = -growth.lateral / steepness + strip.psi * centre;
  const double forces2 = q * q + r * r;
  if (forces2 == 0.0 && std::fabs(strip.psi) < 1.0) return strip;
  // d = (r psi + root) / (1 - psi^2), in the form that stays finite at psi = 1
  const double square = r * r + (1.0 - strip.psi * strip.psi) * q * q;
  const double divisor = std::sqrt(std::max(0.0, square)) - r * strip.psi;
  // d >= l, or none: the strip slips as a whole
  strip.slip_length = 2.0 * half_length;
  if (square < 0.0 || forces2 >= half_length * divisor) return strip;
  const double d = forces2 / divisor;
  // (kappa, lambda): direction of (w q, w r + psi d)
  const double along = growth.weight * q, across = growth.weight * r + strip.psi * d;
  const double size = std::sqrt(along * along + across * across);
  if (size == 0.0) return strip;
  const double kappa = along / size, lambda = across / size;
  // traction over bound at the leading edge, where it is largest; above one only if psi is
  const double s = std::sqrt(1.0 - d / half_length);
  const double edge = lambda * (1.0 - s) + strip.psi * s;
  if (kappa * kappa * (1.0 - s) * (1.0 - s) + edge * edge > 1.0) return strip;
  strip.slip_length = 2.0 * d;
  strip.kappa = kappa;
  strip.lambda = lambda;
  return strip;
}

RolledStrip roll_strip(const SlidingStrip& sliding, const StripSolution& strip, const MarchGrid& grid,
                       const SlipDirections& directions, std::int32_t strips, std::int32_t j,
                       const TangentialFields& fields) {
  const std::int32_t cells = grid.cells;
  const Creepage& creep = sliding.creepage;
  const double l = sliding.half_length, y = sliding.y, h = 2.0 * l / cells;
  const double cell = h * sliding.width;
  const double slip_cells = strip.slip_length / h;
  const bool slips_as_a_whole = strip.slip_length >= 2.0 * l;
  double px_sum = 0.0, py_sum = 0.0, x_py_sum = 0.0, power_sum = 0.0;
  for (std::int32_t i = 0; i < cells; ++i) {
    // Traction over the bound: in stick the closed form, with s the mean of sqrt(1 - 2 d / u) over the cell;
    // in slip FASTSIM's direction.
    const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(i) * strips + j;
    const double from_centre = l - (i + 0.5) * h, x = sliding.centre + from_centre;
    const double ahead = cells - i;  // leading border of the cell, in cells from the trailing edge
    const double bound = sliding.bound * grid.elliptic.mean[i];
    double ex, ey;
    if (slip_cells <= ahead - 0.5) {
      const double s = stick_share(ahead, slip_cells);
      ex = strip.kappa * (1.0 - s);
      ey = strip.lambda * (1.0 - s) + strip.psi * s;
    } else {
      const double tx = slips_as_a_whole ? directions.common_x[at] : directions.separate_x[at];
      const double ty = slips_as_a_whole ? directions.common_y[at] : directions.separate_y[at];
      const double size = std::sqrt(tx * tx + ty * ty);
      ex = size > 0.0 ? tx / size : 0.0;
      ey = size > 0.0 ? ty / size : 0.0;
    }
    fields.traction_x[at] = bound * ex;
    fields.traction_y[at] = bound * ey;

    // Carter: slip grows like sqrt((u_s - u) v) from the border of the stick zone, as that part of the cell
    // sees it which slips.
    const double part = std::clamp(slip_cells - (ahead - 1.0), 0.0, 1.0);
    double slip = 0.0;
    if (part > 0.0) {
      const double u = ahead - 1.0 + 0.5 * part, behind = slip_cells - u, before = cells - u;
      const double form = slips_as_a_whole ? 1.0 : 2.0 * std::sqrt(behind * before) / (behind + before);
      const double rigid_x = creep.longitudinal - creep.spin * y, rigid_y = creep.lateral + creep.spin * x;
      const double along = -(rigid_x * ex + rigid_y * ey);
      // A trace where the traction does not oppose the rigid slip: were there nothing else, as happens on
      // coarse grids, the power of the forces would have no cell to be spent in.
      const double trace = 1e-9 * (std::abs(rigid_x) + std::abs(rigid_y));
      slip = std::max(trace, along) * form * part;
    }
    fields.slip_x[at] = -slip * ex;
    fields.slip_y[at] = -slip * ey;

    // moment about the origin of the creepages; power of slip against the traction
    px_sum += bound * ex;
    py_sum += bound * ey;
    x_py_sum += x * bound * ey;
    power_sum += slip * bound * (ex * ex + ey * ey);
  }
  return {px_sum * cell,
          py_sum * cell,
          (x_py_sum - y * px_sum) * cell,
          2.0 * l * sliding.width,
          strip.slip_length * sliding.width,
          power_sum * cell};
}

}  // namespace wrc::tangential
