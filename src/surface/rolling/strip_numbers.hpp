/// The numbers strip FASTSIM on the surface has of every strip (surface_rolling.hpp), from loads, slips and
/// coefficients: for packs of strips (simd/strip_numbers_kernel.hpp, whose units may not share functions of
/// plain numbers with others), and for numbers that carry derivatives.
#pragma once

#include "base/dual.hpp"
#include "base/elementary.hpp"
#include "patch/material.hpp"
#include "surface/rolling/rolling_arrays.hpp"

namespace wrc::strip_numbers {

inline constexpr double least_force2 = 1e-30;       // [N^2]: neither friction nor slips
inline constexpr double least_variance = 1e-10;     // [m^2]: of the places of strips that have no neighbours
inline constexpr double largest_slenderness = 0.9;  // of what the calibration was fitted to
inline constexpr double reach2 = 0.5;               // beta^2

/// FASTSIM's tractions v (creepage) instead of sqrt(v/u): their integrals over a semi-ellipse
/// (strip_fastsim.cpp).
inline constexpr double creepage_area = 9.0 * pi * pi / 128.0;
/// The elastic slip of a strip that slips as a whole at its edge: this times mu p / (G C).
inline constexpr double edge_slip = 32.0 / 9.0;

using Mean = RollingMeans::Mean;
using enum RollingMeans::Mean;

template <class Number>
RollingArraysOf<Number> arrays(Number* workspace, std::int32_t count) {
  const auto array = [&] {
    Number* const begin = workspace;
    workspace += count;
    return begin;
  };
  RollingArraysOf<Number> a{};
  a.load = array();
  a.link = array();
  a.pivot = array();
  for (Number*& p : a.mean) p = array();
  for (Number** p : {&a.c11, &a.c22, &a.c23, &a.own, &a.bound, &a.growth_x, &a.growth_y, &a.curvature,
                     &a.slip_x, &a.slip_y, &a.elastic, &a.turn_x, &a.turn_y, &a.edge_x, &a.edge_y})
    *p = array();
  return a;
}

/// Where the functions below read and write the strips' numbers: at one strip, or
/// (simd/strip_numbers_kernel.hpp) at as many as a pack has lanes.
template <class Any>
struct OneStrip {
  using Number = Any;
  std::int32_t strip;

  template <class Each>
  const Each& get(const Each* of) const {
    return of[strip];
  }
  void put(Number* of, const Number& x) const { of[strip] = x; }
  template <class F>
  static void each(std::int32_t count, const F& f) {
    for (std::int32_t j = 0; j < count; ++j) f(OneStrip{j});
  }
  static bool positive(const Number& x) { return value_of(x) > 0.0; }
};

/// What all strips share.
struct Shared {
  double shear_modulus, normal_shear_modulus, poisson;
  const StripCoefficientNodes* coefficients;
  const SurfaceCalibration* calibration;
};

template <class Number>
Shared shared(const SurfaceRollingInputOf<Number>& in) {
  return {in.shear_modulus, in.normal_shear_modulus, in.coefficients->poisson(), &in.coefficients->nodes(),
          in.calibration};
}

/// Loads of the strips, how strongly neighbours share their means, and the pivots of that: (N + K) A = N a
/// with K the diffusion between strips side by side, eliminated from the first strip to the last.
template <class At, class Element>
void link(const SurfaceRollingInputOf<Element>& in, const RollingArraysOf<Element>& a) {
  using Number = typename At::Number;
  const std::int32_t n = in.count;
  Element* const flow = a.pivot;  // of each strip, until its pivot is known
  At::each(n, [&](const At& at) {
    const auto& l = at.get(in.half_length);
    const auto& width = at.get(in.width);
    const Number load =
        select(value_of(l) > least_strip_length, 0.5 * pi * width * at.get(in.peak) * l, Number(0.0));
    at.put(a.load, load);
    at.put(flow, load / width * (l * l));
  });
  At::each(n - 1, [&](const At& at) {
    const auto apart = at.get(in.place + 1) - at.get(in.place);
    const auto touching = 0.5 * (at.get(in.width) + at.get(in.width + 1));
    const auto &here = at.get(flow), &there = at.get(flow + 1);
    const Number sum = here + there, none = 0.0;
    const Number shared = here * there / select(value_of(sum) > 0.0, sum, Number(1.0));
    at.put(a.link, select(apart < 1.5 * touching, reach2 * 2.0 * shared / apart, none));
  });
  Element before = 0.0;  // what is left of the link to the strips before
  for (std::int32_t j = 0; j < n; ++j) {
    if (j + 1 == n) a.link[j] = 0.0;
    const Element held = a.load[j] + before, pivot = held + a.link[j];
    a.pivot[j] = At::positive(pivot) ? Element(1.0) / pivot : Element(0.0);
    before = a.link[j] * (held * a.pivot[j]);
  }
}

/// Replaces quantities times load by their means.
template <class At, int first, int end, class Element>
void take_means(std::int32_t count, const RollingArraysOf<Element>& a) {
  Element flow[end - first] = {};
  for (std::int32_t j = 0; j < count; ++j)
    for (int k = first; k < end; ++k) {
      Element* const m = a.mean[k];
      m[j] = (m[j] + flow[k - first]) * a.pivot[j];
      flow[k - first] = a.link[j] * m[j];
    }
  for (std::int32_t j = count - 1; j-- > 0;)
    for (int k = first; k < end; ++k) {
      Element* const m = a.mean[k];
      m[j] += a.pivot[j] * (a.link[j] * m[j + 1]);
    }
}

/// How much more than what neighbours share the difference of a strip's slip to them counts in full adhesion:
/// what gives an ellipse under spin C33 of linear theory, fitted to that for a/b = 0.3 to 20 (theory.md).
template <class Number>
Number gain(const Number& u, double poisson) {
  const Number u2 = u * u;
  const double off = poisson - 0.25;
  return (1.218 - 1.751 * off + 0.2043 * u - (0.696 + 0.760 * off) * u2) / (1.0 - 0.7343 * u2);
}

/// By u alone first.
template <std::size_t n>
requires(n > 1) Dual<n> gain(const Dual<n>& u, double poisson) {
  const Dual<1> g = gain(Dual<1>::input(u.value, 0), poisson);
  return u.chain(g.value, g.d[0]);
}

/// exp(asinh q): 1 + q for small q, positive for any, 1 / itself for -q.
template <class Number>
Number factor(const Number& q) {
  return q + root(1.0 + q * q);
}

/// Peak pressure over half length [Pa/m].
template <class Number>
Number strip_level(const Number& peak, const Number& half_length) {
  constexpr double least_pressure = 1.0;  // [Pa]
  return larger(peak, Number(least_pressure)) / larger(half_length, Number(least_strip_length));
}

/// Slenderness within what the calibration holds for.
template <class Number>
Number held_slenderness(const Number& u) {
  return smaller(larger(u, Number(-largest_slenderness)), Number(largest_slenderness));
}

/// Coefficients, forces of linear theory and their means.
template <class At, class Element>
void linear_theory(const SurfaceRollingInputOf<Element>& in, const Shared& shared,
                   const RollingArraysOf<Element>& a) {
  using Number = typename At::Number;
  const double G = shared.shear_modulus, poisson = shared.poisson;
  const double per_level = shared.normal_shear_modulus / (1.0 - poisson);  // 1 / (pi C)
  const auto area_of = [&](const At& at, const Number& load) {
    return select(value_of(load) > 0.0, at.get(in.half_length) * at.get(in.width), Number(0.0));
  };
  At::each(in.count, [&](const At& at) {
    const auto &l = at.get(in.half_length), &N = at.get(a.load);
    const Number area = area_of(at, N), lambda = strip_level<Number>(at.get(in.peak), l);
    const Number m = at.get(in.curvature) * per_level / lambda;
    const StripCoefficientsOf<Number> c = coefficients_at(*shared.coefficients, m);
    at.put(a.c11, c.c11);
    at.put(a.c22, c.c22);
    at.put(a.c23, c.c23);
    at.put(a.mean[slip], at.get(in.slip_x) * N);
    at.put(a.mean[slender], c.slenderness * N);
    at.put(a.mean[edge],  // 0.884: of an ellipse
           edge_slip / 0.884 * at.get(in.friction) * lambda * l / (G * c.c22) * N);
    at.put(a.mean[lateral], 2.0 / pi * G * c.c22 * at.get(in.slip_y) * area);
    at.put(a.mean[spin], 0.75 * G * c.c23 * at.get(in.spin) * l * area);
    at.put(a.mean[friction], at.get(in.friction) * N);
    at.put(a.mean[location], at.get(in.place) * N);
  });
  take_means<At, slip, longitudinal>(in.count, a);
  At::each(in.count, [&](const At& at) {
    const auto &N = at.get(a.load), &shared_slip = at.get(a.mean[slip]);
    const Number u = held_slenderness<Number>(at.get(a.mean[slender]));
    const Number own = gain(u, poisson) * (at.get(in.slip_x) - shared_slip);
    at.put(a.own, own);
    at.put(a.mean[longitudinal], 2.0 / pi * G * at.get(a.c11) * (shared_slip + own) * area_of(at, N));
    const Number from_middle = at.get(in.place) - at.get(a.mean[location]);
    at.put(a.mean[variance], from_middle * from_middle * N);
  });
  take_means<At, longitudinal, means>(in.count, a);
}

/// One over a number, 0 for 0.
template <class Number>
Number inverse_or_none(const Number& x) {
  const auto any = value_of(x) > 0.0;
  return select(any, Number(1.0) / select(any, x, Number(1.0)), Number(0.0));
}

template <class Number>
struct Terms {
  Number of[SurfaceCalibration::terms];
};

/// The terms of the calibration; x, e, s and the friction limit as forces, Q the sum of their squares.
template <class Number>
Terms<Number> calibration_terms(const Number& u, const Number& x, const Number& e, const Number& s,
                                const Number& limit2, const Number& Q) {
  const Number xx = x * x / Q, ee = e * e / Q, ss = s * s / Q, pull = e * s / Q, pull2 = pull * pull;
  const Number ratio = s * s / (limit2 + s * s), even = 4.0 * ratio * (1.0 - ratio), even2 = even * even;
  const Number unison = even2 * even2 * (limit2 / (limit2 + x * x + e * e));
  return {{Number(1.0), u, xx, ee, ss, pull, pull2, u * xx, u * ee, u * ss, u * pull, u * pull2, unison,
           u * unison, ss * ss, ee * ss, xx * ss}};
}

/// What the calibration says of a strip: its quantities, flexibilities and turning as the factors they stand
/// for.
template <class Number>
struct Fitted {
  Number of[SurfaceCalibration::quantities];
  Number per_size;  ///< one over the root of Q
};

template <class Number>
Fitted<Number> fit(const SurfaceCalibration& calibration, const Number& u, const Number& x, const Number& e,
                   const Number& s, const Number& limit2) {
  const Number Q = limit2 + x * x + e * e + s * s;
  const Terms<Number> terms = calibration_terms(u, x, e, s, limit2, Q);
  Fitted<Number> fitted;
  fitted.per_size = Number(1.0) / root(Q);
  for (int quantity = 0; quantity < SurfaceCalibration::quantities; ++quantity) {
    Number sum = 0.0;
    for (int i = 0; i < SurfaceCalibration::terms; ++i) {
      const double constant = calibration.constants[quantity][i];
      if (constant != 0.0) sum += constant * terms.of[i];
    }
    fitted.of[quantity] = sum;
  }
  constexpr int creepages[] = {SurfaceCalibration::flexibility_x, SurfaceCalibration::flexibility_y,
                               SurfaceCalibration::flexibility_spin_x};
  for (const int quantity : creepages) fitted.of[quantity] = creepage_area * factor(fitted.of[quantity]);
  fitted.of[SurfaceCalibration::flexibility_spin_y] =
      factor(fitted.of[SurfaceCalibration::flexibility_spin_y]);
  fitted.of[SurfaceCalibration::turning] = 1.4 * factor(fitted.of[SurfaceCalibration::turning]);
  return fitted;
}

/// By the five numbers it depends on first: there are more inputs than these.
template <std::size_t n>
requires(n > 5) Fitted<Dual<n>> fit(const SurfaceCalibration& calibration, const Dual<n>& u, const Dual<n>& x,
                                    const Dual<n>& e, const Dual<n>& s, const Dual<n>& limit2) {
  using Few = Dual<5>;
  const Fitted<Few> few = fit(calibration, Few::input(u.value, 0), Few::input(x.value, 1),
                              Few::input(e.value, 2), Few::input(s.value, 3), Few::input(limit2.value, 4));
  const auto by_inputs = [&](const Few& a) {
    Dual<n> all(a.value);
    const Dual<n>* const of[] = {&u, &x, &e, &s, &limit2};
    for (std::size_t i = 0; i < 5; ++i) pairwise::add<n>(a.d[i], of[i]->d.data(), all.d.data());
    return all;
  };
  Fitted<Dual<n>> fitted;
  fitted.per_size = by_inputs(few.per_size);
  for (int q = 0; q < SurfaceCalibration::quantities; ++q) fitted.of[q] = by_inputs(few.of[q]);
  return fitted;
}

/// Fills the arrays that the kernel reads of every strip.
template <class At, class Element>
void fill_arrays(const SurfaceRollingInputOf<Element>& in, const Shared& shared,
                 const RollingArraysOf<Element>& a) {
  using Number = typename At::Number;
  At::each(in.count, [&](const At& at) {
    const Number l = larger(at.get(in.half_length), Number(least_strip_length));
    const auto &mu = at.get(in.friction), &peak = at.get(in.peak);
    const Number u = held_slenderness<Number>(at.get(a.mean[slender]));
    const auto &x = at.get(a.mean[longitudinal]), &e = at.get(a.mean[lateral]), &s = at.get(a.mean[spin]);
    const auto& held = at.get(a.mean[friction]);
    const Number limit2 = held * held + least_force2;
    const Fitted<Number> fitted = fit(*shared.calibration, u, x, e, s, limit2);
    const Number &by_x = fitted.of[SurfaceCalibration::flexibility_x],
                 &by_y = fitted.of[SurfaceCalibration::flexibility_y],
                 &by_spin_x = fitted.of[SurfaceCalibration::flexibility_spin_x],
                 &by_spin_y = fitted.of[SurfaceCalibration::flexibility_spin_y],
                 &turning = fitted.of[SurfaceCalibration::turning];

    // Elastic slip at the edge of a strip that slips as a whole, and one over it, without the coefficients.
    const auto &c11 = at.get(a.c11), &c22 = at.get(a.c22), &slip_y = at.get(in.slip_y);
    const Number soft =
        edge_slip * strip_level<Number>(peak, at.get(in.half_length)) * mu * l / shared.shear_modulus;
    const Number none = 0.0, stiff = inverse_or_none(soft);
    const Number soft_x = soft / c11, soft_y = soft / c22;
    at.put(a.bound, select(value_of(at.get(a.load)) > 0.0, mu * peak, none));
    at.put(a.growth_x, stiff * c11 * (at.get(a.mean[slip]) / by_x + at.get(a.own) / by_spin_x));
    at.put(a.growth_y, stiff * c22 * slip_y / by_y);
    at.put(a.curvature, 16.0 / (3.0 * pi) * stiff * at.get(a.c23) * at.get(in.spin) * l / by_spin_y);
    at.put(a.elastic, creepage_area * (soft_x - soft_y));
    at.put(a.turn_x, turning * soft_x);
    at.put(a.turn_y, turning * soft_y);
    at.put(a.edge_x, 2.0 * by_x * soft_x);
    at.put(a.edge_y, 2.0 * by_y * soft_y);

    const Number across = (at.get(in.place) - at.get(a.mean[location])) /
                          root(5.0 * larger(at.get(a.mean[variance]), Number(least_variance)));
    const Number elastic = at.get(a.mean[edge]) * fitted.per_size;
    at.put(a.slip_x, at.get(in.slip_x) + elastic * (e + s) * across * fitted.of[SurfaceCalibration::twist_x]);
    at.put(a.slip_y, slip_y + elastic * (s * fitted.of[SurfaceCalibration::torsion] +
                                         x * across * fitted.of[SurfaceCalibration::twist_y]));
  });
}

}  // namespace wrc::strip_numbers
