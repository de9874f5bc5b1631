/// The numbers of every strip that strip FASTSIM on the surface marches with (surface_rolling.hpp), in three
/// steps: link(), linear_theory(), fill_arrays(). Templates, for packs of strips
/// (surface/simd/strip_numbers_kernel.hpp, whose units may not share functions of plain numbers with others),
/// and for numbers that carry derivatives. Symbols: rolling_arrays.hpp.
#pragma once

#include "base/dual.hpp"
#include "base/elementary.hpp"
#include "patch/material.hpp"
#include "surface/rolling/rolling_arrays.hpp"
#include "tangential/methods/slip_across.hpp"

namespace wrc::surface::strip_numbers {

inline constexpr double least_limit2 = 1e-30;       // [-]: neither friction nor slips
inline constexpr double least_variance = 1e-10;     // [m^2]: of the places of strips that have no neighbours
inline constexpr double largest_slenderness = 0.9;  // the calibration was fitted up to here
inline constexpr double reach2 = 0.5;               // beta^2

/// Elastic slip at the edge of a strip that slips as a whole, over mu p / (G C).
inline constexpr double edge_slip = 32.0 / 9.0;

using Mean = RollingMeans::Mean;

/// Numbers all strips have in common.
struct Shared {
  double shear_modulus, normal_shear_modulus, poisson;
  double flexibility;  ///< F of a layer [m/Pa]
  double coupling;     ///< K over G, of unlike bodies [1/Pa]
  const StripCoefficientNodes* coefficients;
  /// Terms of the calibration whose constants are not zero, those of one quantity behind those of another.
  struct Term {
    double constant;
    std::int64_t term;
  } terms[std::int32_t{SurfaceCalibration::quantities} * SurfaceCalibration::terms];
  std::int32_t behind[SurfaceCalibration::quantities];  ///< the last one of each quantity
};

template <class Number>
Shared shared(const SurfaceRollingInputOf<Number>& in) {
  Shared s;
  s.shear_modulus = in.shear_modulus;
  s.normal_shear_modulus = in.normal_shear_modulus;
  s.poisson = in.coefficients->poisson();
  s.flexibility = in.layer.flexibility;
  s.coupling = in.coupling / in.normal_shear_modulus;
  s.coefficients = &in.coefficients->nodes();
  // constants of the calibration [-], quantity by quantity
  std::int32_t count = 0;
  for (int quantity = 0; quantity < SurfaceCalibration::quantities; ++quantity) {
    for (int term = 0; term < SurfaceCalibration::terms; ++term) {
      const double constant = in.calibration->constants[quantity][term];
      if (constant != 0.0) s.terms[count++] = {constant, term};
    }
    s.behind[quantity] = count;
  }
  return s;
}

/// Loads of the strips, coupling of neighbours and pivots of the means' equations
///     (N + K) A = N a,   K A = - d/ds (beta^2 l^2 N dA/ds),   K tridiagonal,
/// eliminated from the first strip to the last.
template <class At, class Element>
void link(const SurfaceRollingInputOf<Element>& in, const RollingArraysOf<Element>& a) {
  using Still = typename At::Still;
  const std::int32_t n = in.count;
  // N = pi/2 l p h [N], h the width, and the conductivity N l^2 / h of a strip [N m].
  Element* const conductivity = a.pivot;  // until the pivots are known
  At::each(n, [&](const At& at) {
    const auto& l = at.still(in.half_length);
    const auto& width = at.get(in.width);
    const Still load =
        select(value_of(l) > least_strip_length, 0.5 * pi * width * at.still(in.peak) * l, Still(0.0));
    at.put(a.load, load);
    at.put(conductivity, load / width * (l * l));
  });
  // Link of two strips [N]: beta^2 times the harmonic mean of their conductivities, which stops where either
  // is without load, over their distance; none between strips that do not touch.
  At::each(n - 1, [&](const At& at) {
    const auto apart = at.get(in.place + 1) - at.get(in.place);
    const auto touching = 0.5 * (at.get(in.width) + at.get(in.width + 1));
    const auto &here = at.still(conductivity), &there = at.still(conductivity + 1);
    const Still sum = here + there, none = 0.0;
    const Still joint = here * there / select(value_of(sum) > 0.0, sum, Still(1.0));
    at.put(a.link, select(apart < 1.5 * touching, reach2 * 2.0 * joint / apart, none));
  });
  // Pivots N_j + link_j + the part of link_{j-1} that elimination leaves of it: no differences, so that none
  // of them cancels. Strips without load and links have the inverse 0.
  using One = typename At::OneStrip;
  using Plain = typename One::Still;
  Plain before = 0.0;
  for (std::int32_t j = 0; j < n; ++j) {
    const One at{j};
    if (j + 1 == n) at.put(a.link, Plain(0.0));
    const Plain held = at.still(a.load) + before, link = at.still(a.link), pivot = held + link;
    const Plain inverse = value_of(pivot) > 0.0 ? 1.0 / pivot : Plain(0.0);
    at.put(a.pivot, inverse);
    before = link * (held * inverse);
  }
}

/// Replaces the quantities `first` .. `end` - 1, which are N a, by their means A; those before `moving` are
/// still.
template <class At, int first, int moving, int end, class Element>
void take_means(std::int32_t count, const RollingArraysOf<Element>& a) {
  using One = typename At::OneStrip;
  using Still = typename One::Still;
  using Plain = typename One::Number;
  // forwards: the right side with the share that comes over from the strips before
  Still still[moving - first + 1];
  Plain flow[end - moving + 1];
  for (Still& each : still) each = 0.0;
  for (Plain& each : flow) each = 0.0;
  for (std::int32_t j = 0; j < count; ++j) {
    const One at{j};
    const Still pivot = at.still(a.pivot), link = at.still(a.link);
    for (int k = first; k < moving; ++k) {
      const Still m = (at.still(a.mean[k]) + still[k - first]) * pivot;
      at.put(a.mean[k], m);
      still[k - first] = link * m;
    }
    for (int k = moving; k < end; ++k) {
      const Plain m = (at.get(a.mean[k]) + flow[k - moving]) * pivot;
      at.put(a.mean[k], m);
      flow[k - moving] = link * m;
    }
  }
  // backwards: A_j takes its share of A_{j+1}
  if (count == 0) return;
  const One last{count - 1};
  for (int k = first; k < moving; ++k) still[k - first] = last.still(a.mean[k]);
  for (int k = moving; k < end; ++k) flow[k - moving] = last.get(a.mean[k]);
  for (std::int32_t j = count - 1; j-- > 0;) {
    const One at{j};
    const Still pivot = at.still(a.pivot), link = at.still(a.link);
    for (int k = first; k < moving; ++k) {
      Still& m = still[k - first];
      m = at.still(a.mean[k]) + pivot * (link * m);
      at.put(a.mean[k], m);
    }
    for (int k = moving; k < end; ++k) {
      Plain& m = flow[k - moving];
      m = at.get(a.mean[k]) + pivot * (link * m);
      at.put(a.mean[k], m);
    }
  }
}

/// Gain g of the local part of slip along x in full adhesion [-]: with it an ellipse under spin has C33 of
/// linear theory. Fitted to C33 for a/b = 0.3 to 20 (theory.md).
template <class Number>
Number gain(const Number& u, double poisson) {
  // derivative by u, then the chain rule to all inputs
  if constexpr (has_more_inputs<1, Number>) {
    using One = typename Number::template Few<1>;
    const One g = gain(One::input(u.value, 0), poisson);
    return u.chain(g.value, g.derivative(0));
  }
  const Number u2 = u * u;
  const double off = poisson - 0.25;
  return (1.218 - 1.751 * off + 0.2043 * u - (0.696 + 0.760 * off) * u2) / (1.0 - 0.7343 * u2);
}

/// lambda: peak pressure over half length [Pa/m].
template <class Number>
Number peak_per_length(const Number& peak, const Number& half_length) {
  constexpr double least_pressure = 1.0;  // [Pa]
  return larger(peak, Number(least_pressure)) / larger(half_length, Number(least_strip_length));
}

/// Slenderness within the range of the calibration.
template <class Number>
Number held_slenderness(const Number& u) {
  return smaller(larger(u, Number(-largest_slenderness)), Number(largest_slenderness));
}

/// Longitudinal slip by pressure of unlike bodies [-]: 0.53 K (1 - u) / G times the mean of the strips' peak
/// pressures over neighbours (theory.md, section 4).
template <class At, class Element>
void pressed_slip(const SurfaceRollingInputOf<Element>& in, const Shared& shared,
                  const RollingArraysOf<Element>& a) {
  using Still = typename At::Still;
  if (shared.coupling == 0.0) return;
  At::each(in.count, [&](const At& at) {
    at.put(a.mean[Mean::longitudinal], 0.53 * shared.coupling * at.still(in.peak) * at.still(a.load));
  });
  take_means<At, Mean::longitudinal, Mean::means, Mean::means>(in.count, a);
  At::each(in.count, [&](const At& at) {
    const Still u = held_slenderness<Still>(at.still(a.mean[Mean::slender]));
    at.put(a.pressed, (1.0 - u) * at.still(a.mean[Mean::longitudinal]));
  });
}

/// Coefficients of linear theory, forces of each strip by it, and the means over neighbours.
template <class At, class Element>
void linear_theory(const SurfaceRollingInputOf<Element>& in, const Shared& shared,
                   const RollingArraysOf<Element>& a) {
  using Number = typename At::Number;
  using Still = typename At::Still;
  const double G = shared.shear_modulus, poisson = shared.poisson;
  const double stiffness = shared.normal_shear_modulus / (1.0 - poisson);  // 1 / (pi C) [Pa]
  const auto area_of = [&](const At& at, const Still& load) {
    return select(value_of(load) > 0.0, at.still(in.half_length) * at.get(in.width), Still(0.0));
  };
  // C11, C22, C23' of m = kappa / (pi C lambda); quantities of the first means times load: w_x, u, mu, place,
  // and forces of linear theory, e N = (2/pi) G C22 w_y l h and s N = (3/4) G C23' phi l^2 h [N], h the
  // width. 0.884 is the mean of l / a over the load of an ellipse: its mean edge slip is that of its middle
  // strip.
  At::each(in.count, [&](const At& at) {
    const auto &l = at.still(in.half_length), &N = at.still(a.load);
    const Still area = area_of(at, N), lambda = peak_per_length<Still>(at.still(in.peak), l);
    const Still m = at.still(in.curvature) * stiffness / lambda;
    const StripCoefficientsOf<Still> c = coefficients_at(*shared.coefficients, m);
    at.put(a.c11, c.c11);
    at.put(a.c22, c.c22);
    at.put(a.c23, c.c23);
    at.put(a.mean[Mean::slip], at.get(in.slip_x) * N);
    at.put(a.mean[Mean::slender], c.slenderness * N);
    at.put(a.mean[Mean::edge], edge_slip / 0.884 * at.get(in.friction) * lambda * l / (G * c.c22) * N);
    at.put(a.mean[Mean::lateral], 2.0 / pi * G * c.c22 * at.get(in.slip_y) * area);
    at.put(a.mean[Mean::spin], 0.75 * G * c.c23 * at.get(in.spin) * l * area);
    at.put(a.mean[Mean::friction], at.get(in.friction) * N);
    at.put(a.mean[Mean::location], at.get(in.place) * N);
  });
  take_means<At, Mean::slender, Mean::slip, Mean::variance>(in.count, a);
  pressed_slip<At>(in, shared, a);
  // With W and u known: the local part g (w_x - W) of slip along x, the force of both parts
  // x N = (2/pi) G C11 (W + g (w_x - W)) l h [N], and squared distances from the mean place [m^2].
  At::each(in.count, [&](const At& at) {
    const auto& N = at.still(a.load);
    const auto& shared_slip = at.get(a.mean[Mean::slip]);
    const Still u = held_slenderness<Still>(at.still(a.mean[Mean::slender]));
    const Number own = gain(u, poisson) * (at.get(in.slip_x) - shared_slip);
    at.put(a.own, own);
    Number both = shared_slip + own;
    if (shared.coupling != 0.0) both = both + at.get(a.pressed);
    at.put(a.mean[Mean::longitudinal], 2.0 / pi * G * at.still(a.c11) * both * area_of(at, N));
    const Still from_middle = at.get(in.place) - at.still(a.mean[Mean::location]);
    at.put(a.mean[Mean::variance], from_middle * from_middle * N);
  });
  take_means<At, Mean::variance, Mean::longitudinal, Mean::means>(in.count, a);
}

/// Inverse of a number, 0 for 0.
template <class Number>
Number inverse_or_none(const Number& x) {
  const auto any = value_of(x) > 0.0;
  return select(any, Number(1.0) / select(any, x, Number(1.0)), Number(0.0));
}

template <class Number>
struct Terms {
  Number of[SurfaceCalibration::terms];
};

/// The terms of the calibration (saturation_terms.hpp) of forces over load: x, e, s, the limit mu; Q the sum
/// of their squares.
template <class Number>
Terms<Number> calibration_terms(const Number& u, const Number& x, const Number& e, const Number& s,
                                const Number& limit2, const Number& Q) {
  const Number xx = x * x / Q, ee = e * e / Q, ss = s * s / Q, pull = e * s / Q, pull2 = pull * pull;
  const Number ratio = s * s / (limit2 + s * s), even = 4.0 * ratio * (1.0 - ratio), even2 = even * even;
  const Number unison = even2 * even2 * (limit2 / (limit2 + x * x + e * e));
  return {{Number(1.0), u, xx, ee, ss, pull, pull2, u * xx, u * ee, u * ss, u * pull, u * pull2, unison,
           u * unison, ss * ss, ee * ss, xx * ss}};
}

/// The calibrated quantities of a strip: flexibilities and turning as factors, the others as elastic slips.
template <class Number>
struct Fitted {
  Number of[SurfaceCalibration::quantities];
  Number per_size;  ///< one over the root of Q
};

template <class Number, class Still>
Fitted<Number> fit(const Shared& shared, const Still& u, const Number& x, const Number& e, const Number& s,
                   const Number& limit2) {
  Fitted<Number> fitted;
  // Derivatives by the first four numbers, then the chain rule to all inputs. Sizes of x, e, s and limit that
  // grow alike leave all as it is but for per_size, which falls as they grow: Euler's theorem has the last
  // one.
  if constexpr (has_more_inputs<4, Number>) {
    using Four = typename Number::template Few<4>;
    const Fitted<Four> few = fit(shared, Four::input(u.value, 0), Four::input(x.value, 1),
                                 Four::input(e.value, 2), Four::input(s.value, 3), Four(limit2.value));
    const double per_limit = 0.5 / limit2.value;
    const auto by_inputs = [&](const Four& a, double degree) {
      const double by_x = a.derivative(1), by_e = a.derivative(2), by_s = a.derivative(3);
      Number all(a.value);
      all.add_derivatives(a.derivative(0), u);
      all.add_derivatives(by_x, x);
      all.add_derivatives(by_e, e);
      all.add_derivatives(by_s, s);
      all.add_derivatives((degree * a.value - (by_x * x.value + by_e * e.value + by_s * s.value)) * per_limit,
                          limit2);
      return all;
    };
    fitted.per_size = by_inputs(few.per_size, -1.0);
    for (int q = 0; q < SurfaceCalibration::quantities; ++q) fitted.of[q] = by_inputs(few.of[q], 0.0);
    return fitted;
  } else {
    const Number Q = limit2 + x * x + e * e + s * s;
    const Terms<Number> terms = calibration_terms(u, x, e, s, limit2, Q);
    // quantity = sum of constants times terms
    fitted.per_size = Number(1.0) / root(Q);
    const Shared::Term* next = shared.terms;
    for (int quantity = 0; quantity < SurfaceCalibration::quantities; ++quantity) {
      Number sum = 0.0;
      for (const Shared::Term* const end = shared.terms + shared.behind[quantity]; next != end; ++next)
        sum += next->constant * terms.of[next->term];
      fitted.of[quantity] = sum;
    }
    // Flexibilities and turning as factors; at small slips those of creepages keep the forces of linear
    // theory.
    constexpr int creepages[] = {SurfaceCalibration::flexibility_x, SurfaceCalibration::flexibility_y,
                                 SurfaceCalibration::flexibility_spin_x};
    for (const int quantity : creepages)
      fitted.of[quantity] = tangential::creepage_area * tangential::factor(fitted.of[quantity]);
    fitted.of[SurfaceCalibration::flexibility_spin_y] =
        tangential::factor(fitted.of[SurfaceCalibration::flexibility_spin_y]);
    fitted.of[SurfaceCalibration::turning] = 1.4 * tangential::factor(fitted.of[SurfaceCalibration::turning]);
    return fitted;
  }
}

/// Fills the arrays that the kernel reads of every strip: numbers relative to the half length l and, growths,
/// to the bound mu p over l.
template <class At, class Element>
void fill_arrays(const SurfaceRollingInputOf<Element>& in, const Shared& shared,
                 const RollingArraysOf<Element>& a) {
  using Number = typename At::Number;
  using Still = typename At::Still;
  At::each(in.count, [&](const At& at) {
    // factors of the calibration, by means over neighbours
    const Still l = larger(at.still(in.half_length), Still(least_strip_length));
    const auto& mu = at.get(in.friction);
    const auto& peak = at.still(in.peak);
    const Still u = held_slenderness<Still>(at.still(a.mean[Mean::slender]));
    const auto &x = at.get(a.mean[Mean::longitudinal]), &e = at.get(a.mean[Mean::lateral]),
               &s = at.get(a.mean[Mean::spin]);
    const auto& held = at.get(a.mean[Mean::friction]);
    Number limit2 = held * held + least_limit2;
    // a layer takes F / (F + L) of the slip, L = 8 l / (3 G C11): contact saturates later by as much
    const double modulus = 0.375 * shared.shear_modulus;
    const auto saturate_later = [&](const auto& of_layer) {
      const auto later = 1.0 + of_layer * at.still(a.c11) / l;
      limit2 = limit2 * (later * later);
    };
    if (in.flexibility != nullptr)
      saturate_later(modulus * at.get(in.flexibility));
    else if (shared.flexibility > 0.0)
      saturate_later(modulus * shared.flexibility);
    const Fitted<Number> fitted = fit(shared, u, x, e, s, limit2);
    const Number &by_x = fitted.of[SurfaceCalibration::flexibility_x],
                 &by_y = fitted.of[SurfaceCalibration::flexibility_y],
                 &by_spin_x = fitted.of[SurfaceCalibration::flexibility_spin_x],
                 &by_spin_y = fitted.of[SurfaceCalibration::flexibility_spin_y],
                 &turning = fitted.of[SurfaceCalibration::turning];

    // Elastic slip at the edge of a strip that slips as a whole, 32 mu lambda l / (9 G C), and its inverse,
    // without C. Growth of adhesion tractions 4 G C11 w / (pi^2 mu lambda l) is slip over that slip and over
    // the factor on its flexibility; spin changes the growth along the strip by -psi_k.
    const auto &c11 = at.still(a.c11), &c22 = at.still(a.c22);
    const auto& slip_y = at.get(in.slip_y);
    const Number soft =
        edge_slip * peak_per_length<Still>(peak, at.still(in.half_length)) * mu * l / shared.shear_modulus;
    const Number none = 0.0, stiff = inverse_or_none(soft);
    const Number soft_x = soft / c11, soft_y = soft / c22;
    at.put(a.bound, select(value_of(at.still(a.load)) > 0.0, mu * peak, none));
    // Unlike bodies: the slip by pressure counts less in the stick zone as that zone shrinks towards the
    // leading edge. Where the strip slips, its mean over the load turns the traction.
    Number common = at.get(a.mean[Mean::slip]), pressed = none;
    if (shared.coupling != 0.0) {
      pressed = at.get(a.pressed);
      const Number S = (x * x + e * e + s * s) * (fitted.per_size * fitted.per_size);
      common = common + (1.0 - S * S) * pressed;
    }
    at.put(a.growth_x, stiff * c11 * (common / by_x + at.get(a.own) / by_spin_x));
    at.put(a.growth_y, stiff * c22 * slip_y / by_y);
    at.put(a.curvature, 16.0 / (3.0 * pi) * stiff * at.still(a.c23) * at.get(in.spin) * l / by_spin_y);
    at.put(a.elastic, tangential::creepage_area * (soft_x - soft_y));
    at.put(a.turn_x, turning * soft_x);
    at.put(a.turn_y, turning * soft_y);
    at.put(a.edge_x, 2.0 * by_x * soft_x);
    at.put(a.edge_y, 2.0 * by_y * soft_y);

    // Rigid slip and the elastic slip from tractions beside: torsion, an even lateral slip of contact that
    // spins; twist, slip across the force in proportion to the distance from the middle, 1 at the border of
    // an ellipse.
    const Still across = (at.get(in.place) - at.still(a.mean[Mean::location])) /
                         root(5.0 * larger(at.still(a.mean[Mean::variance]), Still(least_variance)));
    const Number elastic = at.get(a.mean[Mean::edge]) * fitted.per_size;
    at.put(a.slip_x, at.get(in.slip_x) + 1.3 * pressed +
                         elastic * (e + s) * across * fitted.of[SurfaceCalibration::twist_x]);
    at.put(a.slip_y, slip_y + elastic * (s * fitted.of[SurfaceCalibration::torsion] +
                                         x * across * fitted.of[SurfaceCalibration::twist_y]));
    // For fields, which have no derivatives: one over the size of forces (spread_slip() of
    // surface_rolling.cpp), and the growth from strips beside.
    if constexpr (!has_more_inputs<0, Number>) {
      const Number size = fitted.per_size, S = (x * x + e * e + s * s) * (size * size);
      at.put(a.across, size);
      // The curvature above by the mean force of spin: on a wheel's slopes strips have spins that cancel.
      const Number area = larger(l * at.get(in.width), Number(least_strip_length * least_strip_length));
      const Number mean = s * at.get(a.load) / ((0.75 * shared.shear_modulus) * area);
      at.put(a.beside,
             tangential::SlipAcross<Number>::beside_at(S) * (16.0 / (3.0 * pi) * stiff * mean / by_spin_y));
    }
  });
}

}  // namespace wrc::surface::strip_numbers
