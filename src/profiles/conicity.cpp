#include "profiles/conicity.hpp"

#include <algorithm>
#include <cmath>

#include "base/elementary.hpp"

namespace wrc::profiles {
namespace {

std::uint32_t piece_at(const RadiusDifference& of, double y) {
  const double* const above = std::upper_bound(of.y + 1, of.y + of.count - 1, y);
  return static_cast<std::uint32_t>(above - of.y) - 1;
}

double slope_of(const RadiusDifference& of, std::uint32_t k) {
  return (of.dr[k + 1] - of.dr[k]) / (of.y[k + 1] - of.y[k]);
}

double value_at(const RadiusDifference& of, double y) {
  const std::uint32_t k = piece_at(of, y);
  return of.dr[k] + slope_of(of, k) * (y - of.y[k]);
}

double potential_at(const RadiusDifference& of, double y) {
  const std::uint32_t k = piece_at(of, y);
  const double u = y - of.y[k];
  return of.potential[k] + u * (of.dr[k] + 0.5 * slope_of(of, k) * u);
}

/// Middle of the motion with an amplitude: where the integral of dr from one end to the other vanishes and
/// rises; of several the one next to 0. False if there is none.
bool find_centre(const RadiusDifference& of, double amplitude, double& centre) {
  const double low = of.y[0] + amplitude, high = of.y[of.count - 1] - amplitude;
  if (low > high) return false;
  const auto tilt = [&](double c) {
    return potential_at(of, c + amplitude) - potential_at(of, c - amplitude);
  };
  // tilt of the potential between the motion's ends, V(c + a) - V(c - a) = integral of dr, over its middle c
  double largest = 0.0;
  for (std::uint32_t k = 0; k < of.count; ++k) largest = std::max(largest, std::abs(of.dr[k]));
  const double rounding = 1e-6 * largest * amplitude;  // where the points end with the motion
  constexpr int stations = 2000;
  bool found = false;
  double before = low, tilt_before = tilt(low);
  for (int i = 0; i <= stations; ++i) {
    // a place where it rises through zero, or stays zero to rounding at the range's ends, refined by halving
    const double now = low + (high - low) * i / stations, tilt_now = tilt(now);
    const bool rises = tilt_before < 0.0 && tilt_now >= 0.0;
    const bool stands = std::abs(tilt_now) <= rounding && (i == 0 || i == stations);
    if (rises || stands) {
      double a = rises ? before : now, b = now;
      for (int n = 0; n < 80 && b - a > 0.0; ++n) {
        const double middle = 0.5 * (a + b);
        (tilt(middle) < 0.0 ? a : b) = middle;
      }
      if (!found || std::abs(b) < std::abs(centre)) centre = b;
      found = true;
    }
    before = now;
    tilt_before = tilt_now;
  }
  return found;
}

/// Distance rolled while y goes from one place of a piece to another `step` further, with the slopes y' = u0
/// and u1 there and y'' = -f, which goes from f0 to f1 in a straight line: with w^2 = df/dy the pair (f / w,
/// u) turns at the rate w; where f falls it moves along a hyperbola.
double distance_over(double step, double f0, double f1, double u0, double u1) {
  const double stiffness = (f1 - f0) / step;
  const double plain = 2.0 * step / (u0 + u1);  // under constant f
  if (stiffness * plain * plain > 1e-10) {
    const double w = std::sqrt(stiffness);
    return (arctangent2(f1 / w, u1) - arctangent2(f0 / w, u0)) / w;
  }
  if (stiffness * plain * plain < -1e-10) {
    const double w = std::sqrt(-stiffness);
    // u - f / w grows and u + f / w falls by e^(w x); the larger of the two keeps its digits
    return f0 < 0.0 ? natural_log((u1 - f1 / w) / (u0 - f0 / w)) / w
                    : natural_log((u0 + f0 / w) / (u1 + f1 / w)) / w;
  }
  return plain;
}

double klingel_wavelength(double conicity, double contact_distance, double radius) {
  return conicity > 0.0 ? pi * std::sqrt(2.0 * contact_distance * radius / conicity) : 0.0;
}

}  // namespace

void integrate(const RadiusDifference& of) {
  of.potential[0] = 0.0;
  for (std::uint32_t k = 0; k + 1 < of.count; ++k)
    of.potential[k + 1] = of.potential[k] + 0.5 * (of.dr[k] + of.dr[k + 1]) * (of.y[k + 1] - of.y[k]);
}

Conicity conicity_by_wavelength(const RadiusDifference& of, double amplitude, double contact_distance,
                                double radius) {
  double centre = 0.0;
  if (!find_centre(of, amplitude, centre)) return {};
  // y'^2 / 2 = (V(end) - V(y)) / (e r0): slope of the motion at each point
  const double from = centre - amplitude, to = centre + amplitude, level = potential_at(of, to);
  const double scale = 1.0 / (contact_distance * radius);
  const auto slope = [&](double y) {
    return std::sqrt(std::max(0.0, 2.0 * scale * (level - potential_at(of, y))));
  };
  double distance = 0.0, y0 = from, u0 = 0.0, f0 = scale * value_at(of, from);
  for (std::uint32_t k = piece_at(of, from); y0 < to && k + 1 < of.count; ++k) {
    // distance over each piece between points, where y'' is linear in y
    const bool last = of.y[k + 1] >= to;
    const double y1 = last ? to : of.y[k + 1], f1 = scale * (last ? value_at(of, to) : of.dr[k + 1]);
    const double u1 = last ? 0.0 : slope(y1);
    if (!(y1 > y0)) continue;
    const bool at_rest = !(u0 + u1 > 0.0);  // at both ends of the piece
    if (at_rest && !(y1 - y0 > 1e-12 * amplitude)) {
      // a point that is the motion's end but for rounding
    } else if (at_rest && !(f0 < 0.0 && f1 > 0.0)) {
      return {};  // the potential rises above the ends' level, or there is no force
    } else if (!at_rest) {
      distance += distance_over(y1 - y0, f0, f1, u0, u1);
    } else {  // the whole motion is in one piece
      distance += pi / std::sqrt((f1 - f0) / (y1 - y0));
    }
    y0 = y1;
    u0 = u1;
    f0 = f1;
  }
  if (!(distance > 0.0) || !std::isfinite(distance)) return {};
  // there and back; Klingel's formula, solved for tan gamma
  const double wavelength = 2.0 * distance;
  return {.conicity = 2.0 * pi * pi * contact_distance * radius / (wavelength * wavelength),
          .wavelength = wavelength,
          .centre = centre};
}

Conicity conicity_by_regression(const RadiusDifference& of, double amplitude, double contact_distance,
                                double radius) {
  double centre = 0.0;
  if (!find_centre(of, amplitude, centre)) return {};
  // slope of the fit: integral of (y - centre) dr over that of (y - centre)^2, which is 2/3 amplitude^3
  const double from = centre - amplitude, to = centre + amplitude;
  // exact over each straight piece: its middle's moment and its own slope's, width^3 / 12
  double moment = 0.0, y0 = from;
  for (std::uint32_t k = piece_at(of, from); y0 < to && k + 1 < of.count; ++k) {
    const double y1 = std::min(of.y[k + 1], to);
    if (!(y1 > y0)) continue;
    const double slope = slope_of(of, k), middle = 0.5 * (y0 + y1), width = y1 - y0;
    const double at_middle = of.dr[k] + slope * (middle - of.y[k]);
    moment += width * (at_middle * (middle - centre) + slope * width * width / 12.0);
    y0 = y1;
  }
  const double conicity = 0.75 * moment / (amplitude * amplitude * amplitude);
  return {.conicity = conicity,
          .wavelength = klingel_wavelength(conicity, contact_distance, radius),
          .centre = centre};
}

}  // namespace wrc::profiles
