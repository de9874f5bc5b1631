#include "tangential/methods/strip_fastsim.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

#include "base/dual.hpp"
#include "kernels/kernels.hpp"
#include "patch/material.hpp"
#include "patch/regularise.hpp"
#include "tangential/layer/layered_rolling.hpp"
#include "tangential/methods/slip_across.hpp"
#include "tangential/methods/strip_calibration.hpp"
#include "tangential/simd/sums.hpp"
#include "tangential/simd/tasks.hpp"

namespace wrc::tangential {
namespace {

/// With derivatives with respect to nu_x, nu_y, phi.
using Number = Dual<simd::inputs>;

constexpr double least_force2 = 1e-30;       // [N^2]: neither friction nor creepages
constexpr double largest_slenderness = 0.6;  // the calibration was fitted up to here

/// The model for a patch, its load and the creepages; T carries derivatives or not.
template <class T>
struct Model {
  T gx_constant, gx_by_y;          ///< growth along x of adhesion tractions: gx_constant - gx_by_y y [Pa/m]
  T gy_constant, gy_by_x;          ///< along y: gy_constant + gy_by_x x [Pa/m]
  T l11, l22;                      ///< flexibilities of creepages in the stick zone [m/Pa]
  double t11, t22;                 ///< flexibilities of linear theory, for the turning of slip [m/Pa]
  T turning;                       ///< factor on them
  T torsion;                       ///< lateral elastic slip of a patch that spins [-]
  double elastic;                  ///< difference of the elastic slip between x and y, (l_x - l_y) B [1/m]
  double B;                        ///< bound of the march [Pa/m^2]
  double across_even, across_odd;  ///< m, n of slip_across.hpp
  double across_beside;            ///< its b
  double middle, per_width;        ///< y of the patch's middle [m], one over half its width [1/m]
};

/// The terms of the calibration; x, e, s and the limit mu N as forces [N], Q the sum of their squares.
template <class T>
std::array<T, StripCalibration::terms> calibration_terms(double u, double shape_number, const T& x,
                                                         const T& e, const T& s, double limit, const T& Q) {
  // saturations x^2 / Q, ..., e s / Q; `even` is 1 where s^2 = limit^2, its fourth power times the share
  // without creepages the term `unison`; in the order of StripCalibration's terms
  const double limit2 = limit * limit + least_force2;
  const T inverse = 1.0 / Q;
  const T longitudinal = x * x * inverse, lateral = e * e * inverse, spin = s * s * inverse;
  const T pull = e * s * inverse, pull2 = pull * pull;
  const T ratio = s * s / (limit2 + s * s), even = 4.0 * ratio * (1.0 - ratio), even2 = even * even;
  return {T(1.0),
          T(u),
          longitudinal,
          lateral,
          spin,
          pull,
          pull2,
          u * longitudinal,
          u * lateral,
          u * spin,
          u * pull,
          u * pull2,
          even2 * even2 * (limit2 / (limit2 + x * x + e * e)),
          shape_number * (x * s * inverse)};
}

template <class T>
Model<T> model(const RollingContact& c, const StripCalibration& calibration, const T& nu_x, const T& nu_y,
               const T& phi, Fault& fault) {
  // The equivalent double ellipse, its coefficients of linear theory and its flexibilities. The fault of a
  // shape beyond the tables is reported once.
  const StripEllipse patch = strip_ellipse(c);
  const double a = patch.a, b = patch.b, psi = patch.shape_number, u = theory::slenderness(a / b);
  const theory::SdecCoefficients linear = c.linear_theory->at(a / b, psi, fault);
  Fault reported;
  const theory::Flexibility flexibility =
      theory::sdec_flexibility(a, b, psi, c.shear_modulus, *c.linear_theory, reported);

  // Forces of linear theory, where a layer takes part of the slip, and the friction limit mu N [N].
  const double stiffness = c.shear_modulus * a * b, size = std::sqrt(a * b);
  const auto held = [&](double bodies) { return bodies / (bodies + c.layer.flexibility); };
  const T longitudinal =
      held(flexibility.l11) * (stiffness * (linear.c11 * nu_x + (linear.c13 * size) * phi));
  const T lateral = held(flexibility.l22) * ((stiffness * linear.c22) * nu_y),
          spin = held(flexibility.l23) * ((stiffness * size * linear.c23) * phi);
  const double limit = c.friction.mean * patch.normal_force;
  const T saturation2 =
      limit * limit + longitudinal * longitudinal + lateral * lateral + spin * spin + least_force2;
  const std::array<T, StripCalibration::terms> terms =
      calibration_terms<T>(std::clamp(u, -largest_slenderness, largest_slenderness), psi, longitudinal,
                           lateral, spin, limit, saturation2);
  const auto fitted = [&](StripCalibration::Quantity quantity) {
    T sum = 0.0;
    for (int i = 0; i < StripCalibration::terms; ++i) sum += calibration.constants[quantity][i] * terms[i];
    return sum;
  };

  // Linear forces of the tractions sqrt(v/u) / 2, sqrt(uv) relative to those of v, uv, integrated over an
  // SDEC: creepage_area for creepages, pi / 4 for the part of spin that acts along x, 1 for the other part.
  constexpr double spin_area = pi / 4.0;
  // The centre of an SDEC's length is at 8 / (3 pi) psi b: a shift of the neutral line towards it must
  // stiffen spin, or C13 would change.
  constexpr double centre = 8.0 / (3.0 * pi);
  const double neutral = neutral_line(u, c.linear_theory->poisson(), psi);
  const T l13 = flexibility.l13 * spin_area * (1.0 - neutral / centre) *
                factor(fitted(StripCalibration::flexibility_spin_x));
  const T l23 = flexibility.l23 * factor(fitted(StripCalibration::flexibility_spin_y));
  Model<T> m;
  m.t11 = flexibility.l11;
  m.t22 = flexibility.l22;
  m.l11 = flexibility.l11 * creepage_area * factor(fitted(StripCalibration::flexibility_x));
  m.l22 = flexibility.l22 * creepage_area * factor(fitted(StripCalibration::flexibility_y));

  // Growth of adhesion tractions. Along x spin counts from the neutral line y_n [m], chi psi b of a double
  // ellipse; the fitted part moves it to the axis as the patch saturates.
  const T neutral_y =
      (patch.y_stiff - (centre - neutral) * psi * b) * (1.0 + fitted(StripCalibration::neutral_line));
  m.gx_constant = nu_x / m.l11 + neutral_y * phi / l13;
  m.gx_by_y = phi / l13;
  m.gy_constant = nu_y / m.l22;
  m.gy_by_x = phi / l23;

  // Slip: turning, and elastic slip under the march's bound B u v, B = 4 mu (mean of p / l) / (3 a).
  m.turning = 1.4 * factor(fitted(StripCalibration::turning));
  m.B = 4.0 / (3.0 * a) * patch.pressure_per_length * c.friction.mean;
  m.elastic = m.B * creepage_area * (m.t11 - m.t22);
  m.torsion = m.B * (m.t22 * a) * (spin / root(saturation2)) * fitted(StripCalibration::torsion);

  // Spread of the slip across the patch, for fields.
  const double per_size = 1.0 / std::sqrt(value_of(saturation2));
  const SlipAcross<double> across(u, value_of(longitudinal) * per_size, value_of(lateral) * per_size,
                                  value_of(spin) * per_size);
  m.across_even = across.even;
  m.across_odd = across.odd;
  m.across_beside = across.beside;
  m.middle = patch.y_stiff;
  m.per_width = 1.0 / b;
  return m;
}

simd::Coefficient coefficient(double value) { return {value, {}}; }
simd::Coefficient coefficient(const Number& x) { return {x.value, {x.d[0], x.d[1], x.d[2]}}; }

/// The model for the kernels; it points into the contact and the fields.
template <class T>
simd::StripFastsimTask task_of(const RollingContact& contact, const Model<T>& m,
                               const TangentialFields& fields) {
  simd::StripFastsimTask task{};
  task.strips = contact.region.count;
  task.cells = contact.grid->cells;
  task.shape = &contact.grid->elliptic;
  task.inverse_weight = contact.grid->inverse_weight;
  task.fields = &fields;
  task.region = &contact.region;
  task.nu_x = contact.creepage.longitudinal;
  task.nu_y = contact.creepage.lateral;
  task.phi = contact.creepage.spin;
  task.friction = contact.friction.mean;
  task.shares = contact.friction.shares;
  task.gx_constant = coefficient(m.gx_constant);
  task.gx_by_y = coefficient(m.gx_by_y);
  task.gy_constant = coefficient(m.gy_constant);
  task.gy_by_x = coefficient(m.gy_by_x);
  task.l11 = value_of(m.l11);
  task.l22 = value_of(m.l22);
  task.t11 = m.t11;
  task.t22 = m.t22;
  task.turning = coefficient(m.turning);
  task.torsion = coefficient(m.torsion);
  task.B = m.B;
  task.elastic = m.elastic;
  task.across_even = m.across_even;
  task.across_odd = m.across_odd;
  task.across_beside = m.across_beside;
  task.middle = m.middle;
  task.per_width = m.per_width;
  return task;
}

/// A strip with a layer, by the model for the patch and creepages. The bodies' part are the flexibilities of
/// strip FASTSIM; the layer's adds to it.
template <class T>
LayeredStripAt<T> layered_strip(const RollingContact& contact, const Model<T>& m, const LayeredInputs<T>& in,
                                std::int32_t j) {
  const patch::Strips& strips = contact.region;
  const double l = strips.half_length[j], y = strips.y[j], centre = strips.centre[j];
  LayeredStripAt<T> strip;
  const double bound = contact.friction[j] * strips.peak[j];
  strip.bound = bound;
  using Of = LayeredNumbers;
  auto& n = strip.numbers.of;
  // displacements by the bound over the half length: of the bodies under the parabola, of the layer
  const double parabola = m.B * contact.friction.share(j) * l;
  const T spring = contact.layer.flexibility * bound / l;
  n[Of::bodies_x] = m.l11 * parabola;
  n[Of::bodies_y] = m.l22 * parabola;
  n[Of::spring_x] = n[Of::spring_y] = spring;
  n[Of::turn_x] = (m.t11 * parabola) * m.turning;
  n[Of::turn_y] = (m.t22 * parabola) * m.turning;
  // Slips: particles that stick follow those of the bodies' linear theory, or of kinematics, as the one or
  // the other gives way.
  n[Of::slip_x] = in.longitudinal - y * in.spin;
  n[Of::slip_y] = in.lateral + centre * in.spin;
  n[Of::slip_turn] = l * in.spin;
  n[Of::stick_x] =
      slip_in_series(n[Of::bodies_x], m.l11 * (m.gx_constant - y * m.gx_by_y), spring, n[Of::slip_x]);
  n[Of::stick_y] =
      slip_in_series(n[Of::bodies_y], m.l22 * (m.gy_constant + centre * m.gy_by_x), spring, n[Of::slip_y]);
  n[Of::stick_turn] = slip_in_series(n[Of::bodies_y], (l * m.l22) * m.gy_by_x, spring, n[Of::slip_turn]);
  n[Of::slip_y] += m.torsion;
  set_yield(contact.layer, in.yield, l, strip);
  return strip;
}

/// Strip FASTSIM with a layer.
TangentialForces strip_fastsim_layered(const RollingContact& contact, const TangentialFields& fields,
                                       Fault& fault, TangentialSensitivities* sensitivities) {
  // one model for the patch, of plain numbers, and where derivatives are asked for of such
  const auto model_of = [&](const auto& in) {
    return model(contact, fitted_calibration, in.longitudinal, in.lateral, in.spin, fault);
  };
  const auto inputs = layered_inputs(contact.creepage);
  const auto m = model_of(inputs);
  const auto varied =
      sensitivities ? model_of(layered_inputs_varied(contact.creepage)) : Model<LayeredDual>{};
  return roll_layered(
      {contact.region, contact.creepage, contact.friction.mean, contact.grid->elliptic, *contact.grid},
      fields, sensitivities, [&](const auto& in, std::int32_t j) {
        if constexpr (std::is_same_v<decltype(in), decltype((inputs))>)
          return layered_strip(contact, m, in, j);
        else
          return layered_strip(contact, varied, in, j);
      });
}

/// The creepages at which derivatives are found: the contact's own; or, where these are so small that changes
/// of the forces drown in rounding, others that make 1e-8 of the friction limit. Forces are linear up to
/// there.
Creepage away_from_rest(const RollingContact& contact) {
  // nu ~ mu N / (G a b) saturates a patch; spin counts as a creepage by sqrt(a b) phi
  constexpr double least = 1e-8;
  const Creepage& c = contact.creepage;
  const double ab = contact.a * contact.b;
  const double saturating =
      contact.friction.mean * patch::normal_force(contact.region) / (contact.shear_modulus * ab);
  const double size =
      std::sqrt(c.longitudinal * c.longitudinal + c.lateral * c.lateral + ab * c.spin * c.spin);
  if (size >= least * saturating) return c;
  if (!(size > 0.0)) return {least * saturating, 0.0, 0.0};
  const double scale = least * saturating / size;
  return {scale * c.longitudinal, scale * c.lateral, scale * c.spin};
}

}  // namespace

TangentialForces strip_fastsim(const RollingContact& contact, const TangentialFields& fields, Fault& fault,
                               TangentialSensitivities* sensitivities) {
  if (contact.layer.present()) return strip_fastsim_layered(contact, fields, fault, sensitivities);
  return calibrated_strip_fastsim(contact, fields, fault, sensitivities, fitted_calibration);
}

TangentialForces calibrated_strip_fastsim(const RollingContact& contact, const TangentialFields& fields,
                                          Fault& fault, TangentialSensitivities* sensitivities,
                                          const StripCalibration& calibration) {
  const Kernels& kernels = *contact.grid->kernels;
  const auto forces = [&](simd::Sums& sums) {
    const Creepage& c = contact.creepage;
    const Model<double> m = model<double>(contact, calibration, c.longitudinal, c.lateral, c.spin, fault);
    (fields.any() ? kernels.tangential.strip_fastsim_fields : kernels.tangential.strip_fastsim)(
        task_of(contact, m, fields), sums);
  };
  simd::Sums sums;
  if (sensitivities) {
    // Derivatives come with the forces of their creepages; forces of other creepages are solved again.
    RollingContact shifted = contact;
    shifted.creepage = away_from_rest(contact);
    const Creepage& c = shifted.creepage;
    const Model<Number> m = model<Number>(shifted, calibration, Number::input(c.longitudinal, 0),
                                          Number::input(c.lateral, 1), Number::input(c.spin, 2), fault);
    kernels.tangential.strip_fastsim_sensitivities(task_of(shifted, m, fields), sums);
    *sensitivities = sensitivities_of(sums, c, contact.friction.mean, patch::normal_force(contact.region));
    const Creepage& asked = contact.creepage;
    if (c.longitudinal != asked.longitudinal || c.lateral != asked.lateral || c.spin != asked.spin)
      forces(sums);
  } else {
    forces(sums);
  }
  return forces_of(sums);
}

StripEllipse strip_ellipse(const RollingContact& c) {
  const patch::Strips& strips = c.region;
  // Int p dy [N/m], Int l dy [m^2] and their first moments; p and l of a strip are its peak and half length
  double pressure = 0.0, pressure_y = 0.0, length = 0.0, length_y = 0.0;
  for (std::int32_t j = 0; j < strips.count; ++j) {
    const double p = strips.width[j] * strips.peak[j], l = strips.width[j] * strips.half_length[j];
    pressure += p;
    pressure_y += p * strips.y[j];
    length += l;
    length_y += l * strips.y[j];
  }
  const double load = patch::normal_force(strips);
  if (!(pressure > 0.0 && length > 0.0)) return {c.a, c.b, c.shape_number, 0.0, 0.0, 0.0};
  // a = 3 N / (4 Int p dy), area pi a b = 2 Int l dy, and psi from the centre 8 / (3 pi) psi b of a double
  // ellipse's length, here midway between the centroids of area and of stiffness (peaks)
  StripEllipse patch;
  patch.a = 0.75 * load / pressure;
  patch.b = 2.0 * length / (pi * patch.a);
  patch.y_stiff = pressure_y / pressure;
  const double centre = 0.5 * (patch.y_stiff + length_y / length) / patch.b;
  patch.shape_number = std::clamp(3.0 * pi / 8.0 * centre, -patch::largest_psi, patch::largest_psi);
  patch.pressure_per_length = pressure / length;
  patch.normal_force = load;
  return patch;
}

}  // namespace wrc::tangential
