#include "tangential/fastrip.hpp"

#include <algorithm>
#include <cmath>

#include "patch/material.hpp"
#include "tangential/flexibility_form.hpp"
#include "tangential/march.hpp"

namespace wrc {
namespace {

/// What creepages make of a strip in strip theory, corrected to the linear theory of the patch [Pa, Pa/m].
struct Growth {
  double longitudinal = 0.0;       ///< 2 G C11 / pi^2 nu_x
  double longitudinal_spin = 0.0;  ///< k13 phi
  double lateral = 0.0;            ///< 2 G C22 / pi^2 nu_y
  double lateral_spin = 0.0;       ///< 3 G c C23 / (2 pi a) phi
  double weight = 1.0;             ///< of (q, r) against psi d in the direction of traction
};

Growth growth_on_ellipse(const RollingContact& contact, Fault& fault) {
  const KalkerCoefficients k = contact.linear_theory->ellipse().at(contact.a / contact.b, fault);
  const Creepage& creep = contact.creepage;
  const double G = contact.shear_modulus, c = std::sqrt(contact.a * contact.b);
  const double spin = 3.0 * G * c * k.c23 / (2.0 * pi * contact.a) * creep.spin;
  const double weight = 1.0 - contact.linear_theory->poisson();
  return {2.0 * G * k.c11 / (pi * pi) * creep.longitudinal, spin / weight,
          2.0 * G * k.c22 / (pi * pi) * creep.lateral, spin, weight};
}

Growth growth_on_sdec(const RollingContact& contact, Fault& fault) {
  const double a = contact.a, b = contact.b;
  const SdecCoefficients s = contact.linear_theory->at(a / b, contact.shape_number, fault);
  const Creepage& creep = contact.creepage;
  const double G = contact.shear_modulus, c = std::sqrt(a * b);
  return {2.0 * G * s.c11 / (pi * pi) * creep.longitudinal,
          3.0 * G * c * c * c * s.k13 / (4.0 * pi * a * b * b) * creep.spin,
          2.0 * G * s.c22 / (pi * pi) * creep.lateral, 3.0 * G * c * s.c23 / (2.0 * pi * a) * creep.spin,
          1.0};
}

/// Where a strip slips, and its direction of traction at the border of the stick zone.
struct StripSolution {
  double slip_length = 0.0;  ///< 2 d [m]
  double kappa = 0.0, lambda = 0.0, psi = 0.0;
};

StripSolution solve_strip(const Growth& growth, double steepness, double y, double centre,
                          double half_length) {
  StripSolution strip;
  const double q = -(growth.longitudinal - growth.longitudinal_spin * y) / steepness;
  strip.psi = -growth.lateral_spin / steepness;
  const double r = -growth.lateral / steepness + strip.psi * centre;
  const double forces2 = q * q + r * r;
  if (forces2 == 0.0 && std::fabs(strip.psi) < 1.0) return strip;
  // d = (r psi + root) / (1 - psi^2), in the form that psi = 1 does not trouble
  const double square = r * r + (1.0 - strip.psi * strip.psi) * q * q;
  const double divisor = std::sqrt(std::max(0.0, square)) - r * strip.psi;
  strip.slip_length = 2.0 * half_length;
  if (square < 0.0 || forces2 >= half_length * divisor) return strip;
  const double d = forces2 / divisor;
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

/// FASTSIM's part: traction bound and flexibilities.
struct Directions {
  Flexibility separate;
  double common = 0.0;  ///< where a strip slips as a whole
  TractionBound bound = TractionBound::elliptic;
  double load_factor = 1.0;
};

/// The mean over a cell of sqrt((u - u_s) / u) weighted by sqrt(u), u running from `ahead` cells down to
/// `ahead - 1`, both of the strip's trailing edge; zero where the cell lies in the slip zone.
double stick_share(double ahead, double slip_cells) {
  const auto area = [](double u) { return u > 0.0 ? u * std::sqrt(u) : 0.0; };
  return (area(ahead - slip_cells) - area(ahead - 1.0 - slip_cells)) / (area(ahead) - area(ahead - 1.0));
}

struct Sums {
  double fx = 0.0, fy = 0.0, mz = 0.0, area = 0.0, slid = 0.0, power = 0.0;
};

/// One strip: replaces FASTSIM's tractions in the fields by FaStrip's, slip not yet scaled.
void roll_strip(const RollingContact& contact, const StripSolution& strip, std::int32_t j,
                const TangentialFields& fields, Sums& total) {
  const Strips& strips = contact.region;
  const std::int32_t cells = contact.grid->cells;
  const double l = strips.half_length[j], y = strips.y[j], h = 2.0 * l / cells;
  const double cell = h * strips.width[j];
  const double middle_bound = contact.friction[j] * strips.peak[j];
  const double slip_cells = strip.slip_length / h;
  const bool slips_as_a_whole = strip.slip_length >= 2.0 * l;
  double px_sum = 0.0, py_sum = 0.0, x_py_sum = 0.0, power_sum = 0.0;
  for (std::int32_t i = 0; i < cells; ++i) {
    const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(i) * strips.count + j;
    const double from_centre = l - (i + 0.5) * h, x = strips.centre[j] + from_centre;
    const double ahead = cells - i;  // leading border of the cell, in cells from the trailing edge
    const double bound = middle_bound * contact.grid->elliptic.mean[i];
    double ex, ey;
    if (slip_cells <= ahead - 0.5) {
      const double s = stick_share(ahead, slip_cells);
      ex = strip.kappa * (1.0 - s);
      ey = strip.lambda * (1.0 - s) + strip.psi * s;
    } else {
      // the common flexibility's tractions wait in the slip fields
      const double tx = slips_as_a_whole ? fields.slip_x[at] : fields.traction_x[at];
      const double ty = slips_as_a_whole ? fields.slip_y[at] : fields.traction_y[at];
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
      const Creepage& creep = contact.creepage;
      const double rigid_x = creep.longitudinal - creep.spin * y, rigid_y = creep.lateral + creep.spin * x;
      const double along = -(rigid_x * ex + rigid_y * ey);
      // A trace where the traction does not oppose the rigid slip: were there nothing else, as happens on
      // coarse grids, the power of the forces would have no cell to be spent in.
      const double trace = 1e-9 * (std::abs(rigid_x) + std::abs(rigid_y));
      slip = std::max(trace, along) * form * part;
    }
    fields.slip_x[at] = -slip * ex;
    fields.slip_y[at] = -slip * ey;

    px_sum += bound * ex;
    py_sum += bound * ey;
    x_py_sum += x * bound * ey;
    power_sum += slip * bound * (ex * ex + ey * ey);
  }
  total.fx += px_sum * cell;
  total.fy += py_sum * cell;
  total.mz += (x_py_sum - y * px_sum) * cell;
  total.power += power_sum * cell;
  total.area += 2.0 * l * strips.width[j];
  total.slid += strip.slip_length * strips.width[j];
}

TangentialForces solve(const RollingContact& contact, const Growth& growth, const Directions& directions,
                       const TangentialFields& fields) {
  const StripFriction friction{contact.friction.mean * directions.load_factor, contact.friction.shares};
  TangentialProblem problem{contact.region, contact.creepage, directions.separate, friction,
                            directions.bound};
  march(problem, *contact.grid, {fields.traction_x, fields.traction_y, nullptr, nullptr});
  const double l = directions.common;
  problem.flexibility = {l, l, l, l};
  march(problem, *contact.grid, {fields.slip_x, fields.slip_y, nullptr, nullptr});

  constexpr double least_stress = 1e-6;  // [Pa]: strips without friction or pressure slip
  const Strips& strips = contact.region;
  Sums total;
  for (std::int32_t j = 0; j < strips.count; ++j) {
    const double steepness =
        std::max(contact.friction[j] * strips.peak[j], least_stress) / strips.half_length[j];
    const StripSolution strip =
        solve_strip(growth, steepness, strips.y[j], strips.centre[j], strips.half_length[j]);
    roll_strip(contact, strip, j, fields, total);
  }
  const Creepage& c = contact.creepage;
  const double balance =
      std::max(0.0, -(total.fx * c.longitudinal + total.fy * c.lateral + total.mz * c.spin));
  const double scale = total.power > 0.0 ? balance / total.power : 0.0;
  const std::ptrdiff_t cells = static_cast<std::ptrdiff_t>(strips.count) * contact.grid->cells;
  for (double* slip : {fields.slip_x, fields.slip_y}) {
    std::transform(slip, slip + cells, slip, [scale](double s) { return s * scale; });
  }
  return {total.fx, total.fy, total.mz, balance, total.area > 0.0 ? 1.0 - total.slid / total.area : 0.0};
}

Directions on_ellipse(const RollingContact& contact, Fault& fault) {
  const Flexibility separate = ellipse_flexibility(contact.a, contact.b, contact.shear_modulus,
                                                   contact.linear_theory->ellipse(), fault);
  return {separate, common_flexibility(separate, contact.a, contact.b, 0.0, contact.creepage),
          TractionBound::elliptic, 1.0};
}

}  // namespace

TangentialForces fastrip(const RollingContact& contact, const TangentialFields& fields, Fault& fault) {
  Directions directions = on_ellipse(contact, fault);
  directions.bound = TractionBound::parabolic;
  const double slender = std::max(0.0, 1.0 - contact.a / contact.b);
  directions.load_factor = 1.0 + slender * slender * slender * slender;
  return solve(contact, growth_on_ellipse(contact, fault), directions, fields);
}

TangentialForces fastrip_modified(const RollingContact& contact, const TangentialFields& fields,
                                  Fault& fault) {
  return solve(contact, growth_on_ellipse(contact, fault), on_ellipse(contact, fault), fields);
}

TangentialForces fastrip_sdec(const RollingContact& contact, const TangentialFields& fields, Fault& fault) {
  const Flexibility separate = sdec_flexibility(contact.a, contact.b, contact.shape_number,
                                                contact.shear_modulus, *contact.linear_theory, fault);
  const double common =
      common_flexibility(separate, contact.a, contact.b, contact.shape_number, contact.creepage);
  return solve(contact, growth_on_sdec(contact, fault), {separate, common, TractionBound::elliptic, 1.0},
               fields);
}

}  // namespace wrc
