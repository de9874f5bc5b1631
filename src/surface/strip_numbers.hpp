/// The numbers strip FASTSIM on the surface has of every strip (surface_rolling.hpp), from loads, slips and
/// coefficients: for plain numbers, and for numbers that carry derivatives.
#pragma once

#include <array>
#include <type_traits>

#include "base/dual.hpp"
#include "base/elementary.hpp"
#include "patch/material.hpp"
#include "surface/rolling_arrays.hpp"

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

/// Loads of the strips, how strongly neighbours share their means, and the pivots of that: (N + K) A = N a
/// with K the diffusion between strips side by side, eliminated from the first strip to the last.
template <class Number>
void link(const SurfaceRollingInputOf<Number>& in, const RollingArraysOf<Number>& a) {
  const std::int32_t n = in.count;
  const auto flow = [&](std::int32_t j) {
    return a.load[j] / in.width[j] * (in.half_length[j] * in.half_length[j]);
  };
  for (std::int32_t j = 0; j < n; ++j) {
    const Number l = in.half_length[j];
    a.load[j] = value_of(l) > least_strip_length ? 0.5 * pi * in.width[j] * in.peak[j] * l : Number(0.0);
  }
  Number before = 0.0;  // what is left of the link to the strips before
  for (std::int32_t j = 0; j < n; ++j) {
    a.link[j] = 0.0;
    if (j + 1 < n) {
      const double apart = in.place[j + 1] - in.place[j], touching = 0.5 * (in.width[j] + in.width[j + 1]);
      const Number here = flow(j), there = flow(j + 1), sum = here + there;
      if (value_of(sum) > 0.0 && apart < 1.5 * touching)
        a.link[j] = reach2 * 2.0 * (here * there / sum) / apart;
    }
    const Number held = a.load[j] + before, pivot = held + a.link[j];
    a.pivot[j] = value_of(pivot) > 0.0 ? Number(1.0) / pivot : Number(0.0);
    before = a.link[j] * (held * a.pivot[j]);
  }
}

/// Replaces quantities times load by their means.
template <class Number>
void take_means(const SurfaceRollingInputOf<Number>& in, const RollingArraysOf<Number>& a, Mean first,
                Mean end) {
  for (int k = first; k < end; ++k) {
    Number* const m = a.mean[static_cast<std::size_t>(k)];
    Number flow = 0.0;
    for (std::int32_t j = 0; j < in.count; ++j) {
      m[j] = (m[j] + flow) * a.pivot[j];
      flow = a.link[j] * m[j];
    }
    for (std::int32_t j = in.count - 1; j-- > 0;) m[j] += a.pivot[j] * (a.link[j] * m[j + 1]);
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
Number strip_level(const SurfaceRollingInputOf<Number>& in, std::int32_t j) {
  constexpr double least_pressure = 1.0;  // [Pa]
  return larger(in.peak[j], Number(least_pressure)) / larger(in.half_length[j], Number(least_strip_length));
}

/// Slenderness within what the calibration holds for.
template <class Number>
Number held_slenderness(const Number& u) {
  return smaller(larger(u, Number(-largest_slenderness)), Number(largest_slenderness));
}

/// Coefficients, forces of linear theory and their means.
template <class Number>
void linear_theory(const SurfaceRollingInputOf<Number>& in, const RollingArraysOf<Number>& a) {
  const double G = in.shear_modulus, poisson = in.coefficients->poisson();
  const double per_level = in.normal_shear_modulus / (1.0 - poisson);  // 1 / (pi C)
  for (std::int32_t j = 0; j < in.count; ++j) {
    const Number l = in.half_length[j], N = a.load[j];
    const Number area = value_of(N) > 0.0 ? l * in.width[j] : Number(0.0);
    const Number lambda = strip_level(in, j);
    const StripCoefficientsOf<Number> c = in.coefficients->at(in.curvature[j] * per_level / lambda);
    a.c11[j] = c.c11;
    a.c22[j] = c.c22;
    a.c23[j] = c.c23;
    a.mean[slip][j] = in.slip_x[j] * N;
    a.mean[slender][j] = c.slenderness * N;
    a.mean[edge][j] =
        edge_slip / 0.884 * in.friction[j] * lambda * l / (G * c.c22) * N;  // 0.884: of an ellipse
    a.mean[lateral][j] = 2.0 / pi * G * c.c22 * in.slip_y[j] * area;
    a.mean[spin][j] = 0.75 * G * c.c23 * in.spin[j] * l * area;
    a.mean[friction][j] = in.friction[j] * N;
    a.mean[location][j] = in.place[j] * N;
  }
  take_means(in, a, slip, longitudinal);
  for (std::int32_t j = 0; j < in.count; ++j) {
    const Number u = held_slenderness(a.mean[slender][j]);
    const Number area = value_of(a.load[j]) > 0.0 ? in.half_length[j] * in.width[j] : Number(0.0);
    a.own[j] = gain(u, poisson) * (in.slip_x[j] - a.mean[slip][j]);
    a.mean[longitudinal][j] = 2.0 / pi * G * a.c11[j] * (a.mean[slip][j] + a.own[j]) * area;
    const Number from_middle = in.place[j] - a.mean[location][j];
    a.mean[variance][j] = from_middle * from_middle * a.load[j];
  }
  take_means(in, a, longitudinal, means);
}

template <class Number>
using Terms = std::array<Number, SurfaceCalibration::terms>;

/// The terms of the calibration; x, e, s and the friction limit as forces, Q the sum of their squares.
template <class Number>
Terms<Number> calibration_terms(const Number& u, const Number& x, const Number& e, const Number& s,
                                const Number& limit2, const Number& Q) {
  const Number xx = x * x / Q, ee = e * e / Q, ss = s * s / Q, pull = e * s / Q, pull2 = pull * pull;
  const Number ratio = s * s / (limit2 + s * s), even = 4.0 * ratio * (1.0 - ratio), even2 = even * even;
  const Number unison = even2 * even2 * (limit2 / (limit2 + x * x + e * e));
  return {Number(1.0), u,        xx,        ee,     ss,         pull,    pull2,   u * xx, u * ee,
          u * ss,      u * pull, u * pull2, unison, u * unison, ss * ss, ee * ss, xx * ss};
}

/// What the calibration says of a strip: its quantities, flexibilities and turning as the factors they stand
/// for.
template <class Number>
struct Fitted {
  std::array<Number, SurfaceCalibration::quantities> of;
  Number per_size;  ///< one over the root of Q
};

template <class Number>
Fitted<Number> fit(const SurfaceCalibration& calibration, const Number& u, const Number& x, const Number& e,
                   const Number& s, const Number& limit2) {
  const Number Q = limit2 + x * x + e * e + s * s;
  const Terms<Number> terms = calibration_terms(u, x, e, s, limit2, Q);
  Fitted<Number> fitted;
  fitted.per_size = Number(1.0) / root(Q);
  for (std::size_t quantity = 0; quantity < fitted.of.size(); ++quantity) {
    Number sum = 0.0;
    for (std::size_t i = 0; i < terms.size(); ++i) {
      if constexpr (!std::is_same_v<Number, double>)
        if (calibration.constants[quantity][i] == 0.0) continue;
      sum += calibration.constants[quantity][i] * terms[i];
    }
    fitted.of[quantity] = sum;
  }
  for (const auto quantity : {SurfaceCalibration::flexibility_x, SurfaceCalibration::flexibility_y,
                              SurfaceCalibration::flexibility_spin_x})
    fitted.of[quantity] = creepage_area * factor(fitted.of[quantity]);
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
  for (std::size_t q = 0; q < fitted.of.size(); ++q) fitted.of[q] = by_inputs(few.of[q]);
  return fitted;
}

/// Fills the arrays that the kernel reads of every strip.
template <class Number>
void fill_arrays(const SurfaceRollingInputOf<Number>& in, const RollingArraysOf<Number>& a) {
  const SurfaceCalibration& calibration = *in.calibration;
  for (std::int32_t j = 0; j < in.count; ++j) {
    const Number l = larger(in.half_length[j], Number(least_strip_length)), mu = in.friction[j];
    const Number u = held_slenderness(a.mean[slender][j]);
    const Number x = a.mean[longitudinal][j], e = a.mean[lateral][j], s = a.mean[spin][j];
    const Number limit2 = a.mean[friction][j] * a.mean[friction][j] + least_force2;
    const Fitted<Number> fitted = fit(calibration, u, x, e, s, limit2);
    const Number &by_x = fitted.of[SurfaceCalibration::flexibility_x],
                 &by_y = fitted.of[SurfaceCalibration::flexibility_y],
                 &by_spin_x = fitted.of[SurfaceCalibration::flexibility_spin_x],
                 &by_spin_y = fitted.of[SurfaceCalibration::flexibility_spin_y],
                 &turning = fitted.of[SurfaceCalibration::turning];

    // Elastic slip at the edge of a strip that slips as a whole, and one over it, without the coefficients.
    const Number soft = edge_slip * strip_level(in, j) * mu * l / in.shear_modulus;
    const Number stiff = value_of(soft) > 0.0 ? Number(1.0) / soft : Number(0.0);
    const Number soft_x = soft / a.c11[j], soft_y = soft / a.c22[j];
    a.bound[j] = value_of(a.load[j]) > 0.0 ? mu * in.peak[j] : Number(0.0);
    a.growth_x[j] = stiff * a.c11[j] * (a.mean[slip][j] / by_x + a.own[j] / by_spin_x);
    a.growth_y[j] = stiff * a.c22[j] * in.slip_y[j] / by_y;
    a.curvature[j] = 16.0 / (3.0 * pi) * stiff * a.c23[j] * in.spin[j] * l / by_spin_y;
    a.elastic[j] = creepage_area * (soft_x - soft_y);
    a.turn_x[j] = turning * soft_x;
    a.turn_y[j] = turning * soft_y;
    a.edge_x[j] = 2.0 * by_x * soft_x;
    a.edge_y[j] = 2.0 * by_y * soft_y;

    const Number across =
        (in.place[j] - a.mean[location][j]) / root(5.0 * larger(a.mean[variance][j], Number(least_variance)));
    const Number elastic = a.mean[edge][j] * fitted.per_size;
    a.slip_x[j] = in.slip_x[j] + elastic * (e + s) * across * fitted.of[SurfaceCalibration::twist_x];
    a.slip_y[j] = in.slip_y[j] + elastic * (s * fitted.of[SurfaceCalibration::torsion] +
                                            x * across * fitted.of[SurfaceCalibration::twist_y]);
  }
}

}  // namespace wrc::strip_numbers
