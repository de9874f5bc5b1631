#include "tangential/strip_fastsim.hpp"

#include <algorithm>
#include <cmath>

#include "patch/material.hpp"
#include "tangential/dual.hpp"
#include "tangential/simd/kernels.hpp"
#include "tangential/simd/sensitivities.hpp"

namespace wrc {
namespace {

/// With derivatives with respect to nu_x, nu_y, phi.
using Number = Dual<simd::inputs>;

/// What the patch, its load and the creepages make of the model; T carries derivatives or not.
template <class T>
struct Model {
  T nu_x, nu_y, phi;
  T l11, l13, l22, l23;    ///< flexibilities of the stick zone [m/Pa]
  double t11, t22;         ///< flexibilities of linear theory, for the turning of slip [m/Pa]
  T turning;               ///< factor on them
  T stick_form;            ///< share of FASTSIM's form of the stick zone in strip theory's
  double bound_per_width;  ///< 4 / (3 a): B = bound_per_width mu p / l
};

/// How far the creepages are from those of linear theory, from x, e, s: the forces of linear theory due to
/// nu_x, nu_y, phi over mu N.
template <class T>
struct Saturation {
  T spin;    ///< s^2 / (1 + s^2): saturation by spin, 0 to 1
  T pull;    ///< e s / (1 + s^2 + x^2 + e^2): lateral creepage pulls with spin (> 0) or against it
  T unison;  ///< (4 spin (1 - spin))^4: near s = 1, where strip theory lets all strips slip at once
};

/// The calibration; u = (a - b) / (a + b).
template <class T>
void calibrate(double u, const Saturation<T>& at, const Flexibility& linear, Model<T>& m) {
  const T spin = at.spin, pull = at.pull, pull2 = at.pull * at.pull, unison = at.unison;
  m.stick_form = 0.060 + 0.035 * u;
  m.turning = (1.460 + 0.082 * u) * (1.0 - 0.539 * spin) * (1.0 + 0.739 * pull2) *
              (1.0 + (-0.316 + 0.186 * u) * pull + (-0.082 + 0.066 * u) * unison);
  // Linear forces of the tractions sqrt(v/u), sqrt(uv) relative to those of v, uv, integrated over an SDEC:
  // 9 pi^2 / 128 for creepages, pi / 4 for the part of spin that acts along x, 1 for the other part. The
  // stick zone takes (1 + stick_form) / 2 of t for small t.
  constexpr double creepage_area = 9.0 * pi * pi / 128.0, spin_area = pi / 4.0;
  const T form = 1.0 + m.stick_form;
  m.l11 = linear.l11 * creepage_area * form * (1.0 + (0.328 + 0.311 * u) * spin) *
          (1.0 + 0.066 * pull - 0.060 * unison) * (1.0 - 0.303 * pull2);
  m.l22 = linear.l22 * creepage_area * form * (1.0 + (0.088 + 0.217 * u) * spin) *
          (1.0 + (0.170 - 0.112 * u) * pull) * (1.0 - 0.070 * pull2);
  m.l13 = linear.l13 * spin_area * form * (1.0 - 0.077 * u * spin) * (1.0 + (-0.016 + 0.095 * u) * unison);
  m.l23 = linear.l23 * (1.0 + (-0.075 + 0.107 * u) * spin) *
          (1.0 + (-0.005 + 0.024 * u + 0.069 * u * u) * unison - 0.063 * pull);
}

template <class T>
Model<T> model(const RollingContact& c, const T& nu_x, const T& nu_y, const T& phi, Fault& fault) {
  const SdecCoefficients s = c.linear_theory->at(c.a / c.b, c.shape_number, fault);
  Fault reported;
  const Flexibility linear =
      sdec_flexibility(c.a, c.b, c.shape_number, c.shear_modulus, *c.linear_theory, reported);
  // x, e, s times mu N
  const double stiffness = c.shear_modulus * c.a * c.b;
  const T x = stiffness * s.c11 * nu_x, e = stiffness * s.c22 * nu_y;
  const T k = stiffness * std::sqrt(c.a * c.b) * s.c23 * phi;
  const T limit = c.friction.mean * totals(c.region).normal_force;
  constexpr double least_force2 = 1e-30;  // [N^2]: neither friction nor creepages
  const T with_spin = limit * limit + k * k + least_force2;
  Saturation<T> saturation;
  saturation.spin = k * k / with_spin;
  saturation.pull = e * k / (with_spin + x * x + e * e);
  const T even = 4.0 * saturation.spin * (1.0 - saturation.spin);
  saturation.unison = even * even * even * even;
  Model<T> m;
  m.nu_x = nu_x;
  m.nu_y = nu_y;
  m.phi = phi;
  m.t11 = linear.l11;
  m.t22 = linear.l22;
  m.bound_per_width = 4.0 / (3.0 * c.a);
  calibrate(slenderness(c.a / c.b), saturation, linear, m);
  return m;
}

simd::Coefficient coefficient(double value) { return {value, {}}; }
simd::Coefficient coefficient(const Number& x) { return {x.value, {x.d[0], x.d[1], x.d[2]}}; }

/// The model for the kernels; it points into the contact and the fields.
template <class T>
simd::StripFastsimTask task_of(const RollingContact& contact, const Model<T>& m,
                               const TangentialFields& fields) {
  simd::StripFastsimTask task{};
  task.region = &contact.region;
  task.nu_x = contact.creepage.longitudinal;
  task.nu_y = contact.creepage.lateral;
  task.phi = contact.creepage.spin;
  task.friction = contact.friction.mean;
  task.shares = contact.friction.shares;
  task.gx_constant = coefficient(m.nu_x / m.l11);
  task.gx_by_y = coefficient(m.phi / m.l13);
  task.gy_constant = coefficient(m.nu_y / m.l22);
  task.gy_by_x = coefficient(m.phi / m.l23);
  task.l11 = coefficient(m.l11);
  task.l22 = coefficient(m.l22);
  task.t11 = m.t11;
  task.t22 = m.t22;
  task.turning = coefficient(m.turning);
  task.stick_form = coefficient(m.stick_form);
  task.bound_per_width = m.bound_per_width;
  task.shape = &contact.grid->elliptic;
  task.cells = contact.grid->cells;
  task.fields = &fields;
  return task;
}

}  // namespace

TangentialForces strip_fastsim(const RollingContact& contact, const TangentialFields& fields, Fault& fault,
                               TangentialSensitivities* sensitivities) {
  const Creepage& c = contact.creepage;
  simd::Sums sums;
  if (sensitivities) {
    const Model<Number> m = model<Number>(contact, Number::input(c.longitudinal, 0),
                                          Number::input(c.lateral, 1), Number::input(c.spin, 2), fault);
    contact.grid->kernels->strip_fastsim_sensitivities(task_of(contact, m, fields), sums);
    *sensitivities = sensitivities_of(sums, c, contact.friction.mean, totals(contact.region).normal_force);
  } else {
    const Model<double> m = model<double>(contact, c.longitudinal, c.lateral, c.spin, fault);
    contact.grid->kernels->strip_fastsim(task_of(contact, m, fields), sums);
  }
  const double balance = -(sums.fx * c.longitudinal + sums.fy * c.lateral + sums.mz * c.spin);
  const double power = std::max(0.0, balance);
  const double scale = sums.power_per_speed > 0.0 ? power / sums.power_per_speed : 0.0;
  const std::ptrdiff_t cells = static_cast<std::ptrdiff_t>(contact.region.count) * contact.grid->cells;
  for (double* slip : {fields.slip_x, fields.slip_y}) {
    if (slip) std::transform(slip, slip + cells, slip, [scale](double s) { return s * scale; });
  }
  return {sums.fx, sums.fy, sums.mz, power, sums.area > 0.0 ? 1.0 - sums.slid_area / sums.area : 0.0};
}

}  // namespace wrc
