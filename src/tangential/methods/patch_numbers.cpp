#include "tangential/methods/patch_numbers.hpp"

#include <algorithm>
#include <cmath>

#include "base/number.hpp"
#include "tangential/methods/strip_fastsim.hpp"

namespace wrc::tangential {
namespace {

/// Yield at rest of an ellipse whose surfaces stick, Cattaneo's and Mindlin's: displacement over force along
/// x and y [m/N]. Int R dt and Int R cos^2 t dt, R the radius, are complete elliptic integrals, by the
/// arithmetic-geometric mean.
struct Yield {
  double x, y;
};

Yield yield_at_rest(double a, double b, double shear_modulus, double poisson) {
  const double longer = std::max(a, b), shorter = std::min(a, b);
  // K and (K - E) / e^2 of the eccentricity e
  double mean = 1.0, root = shorter / longer, square = std::max(0.0, 1.0 - root * root);
  double weight = 0.5, sum = 0.5;
  const double e2 = std::max(square, least_divisor);
  for (int k = 0; k < 6; ++k) {
    const double next = 0.5 * (mean + root);
    root = std::sqrt(mean * root);
    mean = next;
    const double difference = square / (4.0 * next);
    square = difference * difference;
    weight *= 2.0;
    sum += weight * (square / e2);
  }
  const double K = 0.5 * pi / mean;
  const double all = 4.0 * shorter * K, along_longer = all * sum, along_shorter = all - along_longer;
  const double scale = 1.0 / (4.0 * shear_modulus * pi * a * b);
  const double along_x = a >= b ? along_longer : along_shorter;
  return {scale * ((1.0 - poisson) * all + poisson * along_x),
          scale * ((1.0 - poisson) * all + poisson * (all - along_x))};
}

/// Yield at rest of an outline that is no ellipse, over that of the ellipse of its area [-]. The ellipse of
/// its second moments is larger, and yields less. The outline's yield lies half way between both: within 1 %
/// of half-spaces, on wheels with one hump and with two.
double yield_of_outline(const patch::Strips& region) {
  double length = 0.0, first = 0.0, along = 0.0, across = 0.0;
  for (std::int32_t j = 0; j < region.count; ++j) {
    const double l = region.half_length[j], own = region.width[j] * l;
    length += own;
    first += own * region.y[j];
    along += own * l * l;
    across += own * (region.y[j] * region.y[j] + region.width[j] * region.width[j] / 12.0);
  }
  if (!(length > 0.0)) return 1.0;
  // area 2 Int l dy over that of the ellipse whose second moments are Int 2/3 l^3 dy and Int 2 l y^2 dy
  const double middle = first / length;
  const double moments = (4.0 / 3.0) * along * (4.0 * (across - length * middle * middle));
  return std::sqrt(std::sqrt((2.0 / pi) * length * length / std::sqrt(std::max(moments, least_divisor))));
}

/// The same of a rotation, times G sqrt(ab)^3: 3/8 on a circle (Mindlin), others by the exact solver within
/// 0.3 % (a/b from 1/4 to 4).
double torsion_at_rest(double u2) { return 0.375 * (1.0 - u2 * (1.81 - 0.92 * u2)); }

}  // namespace

PatchNumbers patch_numbers(const RollingContact& contact, Fault& fault, const MemoryFactors& factors) {
  // the longest strip, the friction limit of N_j = pi/2 peak half_length width, and the centre of the load
  PatchNumbers n;
  const patch::Strips& region = contact.region;
  double load = 0.0, square = 0.0;
  for (std::int32_t j = 0; j < region.count; ++j) {
    n.length = std::max(n.length, 2.0 * region.half_length[j]);
    const double per_width = region.peak[j] * region.half_length[j], own = per_width * region.width[j];
    n.largest_load = std::max(n.largest_load, per_width);
    n.limit += contact.friction[j] * (0.5 * pi) * own;
    load += own;
    n.centre_x += own * region.centre[j];
    n.centre_y += own * region.y[j];
    square += own * region.y[j] * region.y[j];
  }
  n.centre_x /= std::max(load, least_divisor);
  n.centre_y /= std::max(load, least_divisor);

  // Local flexibilities, of linear rolling; the yield of the patch as a whole, of linear theory at rest less
  // theirs.
  const StripEllipse ellipse = strip_ellipse(contact);
  const double a = n.a = ellipse.a, b = n.b = ellipse.b;
  const double G = contact.shear_modulus;
  const theory::SdecCoefficients linear = contact.linear_theory->at(a / b, ellipse.shape_number, fault);
  const double area = pi * a * b, u = theory::slenderness(a / b), u2 = u * u;
  n.growth_x = 3.0 * G * linear.c11 / (8.0 * a * (1.0 + factors.flexibility_x));
  n.growth_y = 3.0 * G * linear.c22 / (8.0 * a * (1.0 + factors.flexibility_y));
  n.arm = 1.0 + factors.arm + factors.arm_slender * u2;
  Yield rest = yield_at_rest(a, b, G, contact.linear_theory->poisson());
  const double outline = yield_of_outline(region);
  rest.x *= outline;
  rest.y *= outline;
  const double turned = torsion_at_rest(u2) / (G * a * b * std::sqrt(a * b));
  const double cells_turned = 4.0 / (n.arm * n.arm * area * (n.growth_x * b * b + n.growth_y * a * a));
  n.yield[0] = std::max(0.0, rest.x - 1.0 / (n.growth_x * area));
  n.yield[1] = std::max(0.0, rest.y - 1.0 / (n.growth_y * area));
  n.yield[2] = std::max(0.0, (1.0 + factors.torsion) * turned - cells_turned);
  // Humps whose load spreads wider than an ellipse's displace one another in proportion to their forces. That
  // part of the yield forms no bounds. Of two circles that touch, of spread 1.5, it is 0.24.
  const double spread = 5.0 * (square / std::max(load, least_divisor) - n.centre_y * n.centre_y) / (b * b);
  const double wider = std::clamp(spread - 1.0, 0.0, 0.5), mutual = wider * wider;
  const double whole = 0.5 * (n.yield[0] / rest.x + n.yield[1] / rest.y) + factors.share;
  n.share = std::clamp((whole - mutual) / (1.0 - mutual), 0.0, 0.9);
  return n;
}

}  // namespace wrc::tangential
