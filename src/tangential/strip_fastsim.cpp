#include "tangential/strip_fastsim.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

#include "patch/material.hpp"
#include "patch/regularise.hpp"
#include "tangential/dual.hpp"
#include "tangential/lanes.hpp"
#include "tangential/strip_calibration.hpp"

namespace wrc {
namespace {

constexpr double tiny_stress = 1e-6;         // [Pa]
constexpr double least_force2 = 1e-30;       // [N^2]: neither friction nor creepages
constexpr double largest_slenderness = 0.6;  // of the patches the calibration was fitted to

/// What the patch, its load and the creepages make of the model; T carries derivatives or not.
template <class T>
struct Model {
  T nu_x, nu_y, phi, friction;
  T l11, l13, l22, l23;  ///< flexibilities of the stick zone [m/Pa]
  T neutral_y;           ///< neutral line of spin in the stick zone [m]
  double t11, t22;       ///< flexibilities of linear theory, for the turning of slip [m/Pa]
  T turning;             ///< factor on them
  T torsion;             ///< lateral elastic slip of a patch that spins [-]
  T elastic;             ///< what the elastic slip differs by between x and y, (l_x - l_y) B [1/m]
  T B;                   ///< bound of the march [Pa/m^2]
};

/// The double ellipse that stands for the patch in linear theory, from the strips' pressure: see the header.
struct Equivalent {
  double a = 0.0, b = 0.0, shape_number = 0.0;
  double y_stiff = 0.0;              ///< lateral centre of the strips' stiffness [m]
  double pressure_per_length = 0.0;  ///< mean of peak / half length over the area [Pa/m]
  double normal_force = 0.0;         ///< [N]
};

Equivalent equivalent(const RollingContact& c) {
  const Strips& strips = c.region;
  double pressure = 0.0, pressure_y = 0.0, length = 0.0, length_y = 0.0;
  for (std::int32_t j = 0; j < strips.count; ++j) {
    const double p = strips.width[j] * strips.peak[j], l = strips.width[j] * strips.half_length[j];
    pressure += p;
    pressure_y += p * strips.y[j];
    length += l;
    length_y += l * strips.y[j];
  }
  const double load = totals(strips).normal_force;
  if (!(pressure > 0.0 && length > 0.0)) return {c.a, c.b, c.shape_number, 0.0, 0.0, 0.0};
  Equivalent patch;
  patch.a = 0.75 * load / pressure;
  patch.b = 2.0 * length / (pi * patch.a);
  patch.y_stiff = pressure_y / pressure;
  const double centre = 0.5 * (patch.y_stiff + length_y / length) / patch.b;
  patch.shape_number = std::clamp(3.0 * pi / 8.0 * centre, -largest_psi, largest_psi);
  patch.pressure_per_length = pressure / length;
  patch.normal_force = load;
  return patch;
}

/// The terms of the calibration; x, e, s and the limit mu N as forces [N], Q the sum of their squares.
template <class T>
std::array<T, StripCalibration::terms> calibration_terms(double u, double shape_number, const T& x,
                                                         const T& e, const T& s, const T& limit, const T& Q) {
  const T limit2 = limit * limit + least_force2, inverse = 1.0 / Q;
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

/// exp(asinh q): 1 + q for small q, positive for any, 1 / itself for -q.
template <class T>
T factor(const T& q) {
  return q + root(1.0 + q * q);
}

template <class T>
Model<T> model(const RollingContact& c, const StripCalibration& calibration, const T& nu_x, const T& nu_y,
               const T& phi, const T& friction, Fault& fault) {
  const Equivalent patch = equivalent(c);
  const double a = patch.a, b = patch.b, psi = patch.shape_number, u = slenderness(a / b);
  const SdecCoefficients linear = c.linear_theory->at(a / b, psi, fault);
  Fault reported;
  const Flexibility flexibility = sdec_flexibility(a, b, psi, c.shear_modulus, *c.linear_theory, reported);

  // Forces of linear theory and what friction allows [N].
  const double stiffness = c.shear_modulus * a * b, size = std::sqrt(a * b);
  const T longitudinal = stiffness * (linear.c11 * nu_x + (linear.c13 * size) * phi);
  const T lateral = (stiffness * linear.c22) * nu_y, spin = (stiffness * size * linear.c23) * phi;
  const T limit = friction * patch.normal_force;
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
  // SDEC: 9 pi^2 / 128 for creepages, pi / 4 for the part of spin that acts along x, 1 for the other part.
  constexpr double creepage_area = 9.0 * pi * pi / 128.0, spin_area = pi / 4.0;
  // The centre of an SDEC's length is at 8 / (3 pi) psi b: what shifts the neutral line must stiffen spin.
  constexpr double centre = 8.0 / (3.0 * pi);
  const double neutral = neutral_line(u, c.linear_theory->ellipse().poisson(), psi);
  Model<T> m;
  m.nu_x = nu_x;
  m.nu_y = nu_y;
  m.phi = phi;
  m.friction = friction;
  m.t11 = flexibility.l11;
  m.t22 = flexibility.l22;
  m.l11 = flexibility.l11 * creepage_area * factor(fitted(StripCalibration::flexibility_x));
  m.l22 = flexibility.l22 * creepage_area * factor(fitted(StripCalibration::flexibility_y));
  m.l13 = flexibility.l13 * spin_area * (1.0 - neutral / centre) *
          factor(fitted(StripCalibration::flexibility_spin_x));
  m.l23 = flexibility.l23 * factor(fitted(StripCalibration::flexibility_spin_y));
  m.neutral_y =
      (patch.y_stiff - (centre - neutral) * psi * b) * (1.0 + fitted(StripCalibration::neutral_line));
  m.turning = 1.4 * factor(fitted(StripCalibration::turning));
  m.B = 4.0 / (3.0 * a) * patch.pressure_per_length * friction;
  m.elastic = m.B * creepage_area * (m.t11 - m.t22);
  m.torsion = m.B * (m.t22 * a) * (spin / root(saturation2)) * fitted(StripCalibration::torsion);
  return m;
}

/// What does not change along the strips of a group.
template <class T>
struct Group {
  Lane<double> half_length{}, centre{}, y{}, width{};
  Lane<T> gx{}, gy{}, k{};  ///< growth of adhesion tractions (gx, gy + 2 k x), x from the strip's middle
  Lane<T> B{}, bound{};     ///< parabolic bound B u v of the march; mu p at the strip's middle
  Lane<T> onset_u{};        ///< u_s [m]
  Lane<T> kappa{}, lambda{}, psi{};
  Lane<T> form{};      ///< share of FASTSIM's form 1 - t in strip theory's sqrt(1 - t)
  Lane<T> wx{}, wy{};  ///< rigid slip at the strip's middle, with torsion
  Lane<T> elastic{};   ///< half of what 2 B L differs by between x and y [1/m]
};

/// State of the march: traction over the bound of the march, and that bound.
template <class T>
struct State {
  Lane<T> rho_x{}, rho_y{}, bound{};
};

template <class T>
void prepare(const Model<T>& m, const Strips& strips, std::int32_t first, std::int32_t count, Group<T>& g,
             State<T>& state) {
  g.half_length.fill(1.0);
  for (std::int32_t i = 0; i < count; ++i) {
    const std::int32_t j = first + i;
    const double l = strips.half_length[j];
    g.half_length[i] = l;
    g.centre[i] = strips.centre[j];
    g.y[i] = strips.y[j];
    g.width[i] = strips.width[j];
    g.wx[i] = m.nu_x - m.phi * g.y[i];
    g.wy[i] = m.nu_y + m.phi * g.centre[i] + m.torsion;
    const T gx = m.nu_x / m.l11 - m.phi * (g.y[i] - m.neutral_y) / m.l13;
    const T gy = m.nu_y / m.l22 + m.phi * g.centre[i] / m.l23;
    const T k = 0.5 * m.phi / m.l23;
    g.gx[i] = gx;
    g.gy[i] = gy;
    g.k[i] = k;
    g.bound[i] = m.friction * strips.peak[j];
    const T B = m.B;  // the same in all strips: see the file's header
    g.B[i] = B;
    g.elastic[i] = m.elastic;

    // onset of slip, as onset_parabolic() in stick_zone.hpp
    const T c = gx * gx + gy * gy, A = B * B - k * k, H = -(gy * k);
    const T lead = gy + 2.0 * k * l;
    const T edge2 = gx * gx + lead * lead, bound2 = 4.0 * B * B * (l * l);
    const bool slips_at_edge = edge2 >= bound2;
    // A strip about to slip at the leading edge may, with |psi| > 1, have sticking material behind it, to
    // which the march gives FASTSIM's form: the closed form must arrive there too, or forces jump strip by
    // strip.
    const T near_edge = smaller(T(1.0), edge2 / (bound2 + tiny_stress * tiny_stress));
    g.form[i] = near_edge * near_edge * (near_edge * near_edge);
    const T S = root(larger(T(0.0), H * H + A * c));
    const bool cancels = H < T(0.0);
    const T numerator = cancels ? S - H : c, denominator = cancels ? A : H + S;
    const T u = denominator > T(0.0) ? numerator / denominator : T(0.0);
    const T us = slips_at_edge ? T(2.0 * l) : smaller(larger(u, T(0.0)), T(2.0 * l));
    g.onset_u[i] = us;

    const T at_onset = B * us + tiny_stress / l;
    g.kappa[i] = -gx / at_onset;
    g.lambda[i] = -(gy + k * us) / at_onset;
    g.psi[i] = -k / (B + tiny_stress / (l * l));
    // A strip that slips from its leading edge on starts against the slip there, whose elastic part depends
    // on the direction itself: three substitutions settle it.
    T ex = g.kappa[i], ey = g.lambda[i];
    if (slips_at_edge) {
      T wx = g.wx[i], wy = g.wy[i] + m.phi * l;
      for (int n = 0; n < 3; ++n) {
        const T size = root(wx * wx + wy * wy) + 1e-100;
        ex = -wx / size;
        ey = -wy / size;
        wx = g.wx[i] + g.elastic[i] * l * ex;
        wy = g.wy[i] + m.phi * l - g.elastic[i] * l * ey;
      }
    }
    state.rho_x[i] = ex;
    state.rho_y[i] = ey;
    state.bound[i] = B * us * (2.0 * l - us);
  }
}

/// Traction (over mu p) of one cell of every strip of the group, and the slip's share of the cell.
template <class T>
struct Row {
  Lane<T> px{}, py{};
  Lane<double> slides{};
};

/// One march step of a group; see the file's header for the stick zone and march.hpp for the turning of slip.
template <class T>
inline void step(const Group<T>& g, const Model<T>& m, std::int32_t i, std::int32_t cells, double shape_mean,
                 State<T>& state, Row<T>& row) {
  const double ahead_of_cell = cells - i, behind_cell = cells - i - 1;  // u at the cell's borders / h
  const double inverse_weight =
      1.0 / (ahead_of_cell * std::sqrt(ahead_of_cell) - behind_cell * std::sqrt(behind_cell));
  for (std::int32_t k = 0; k < lanes; ++k) {
    const double l = g.half_length[k], h = 2.0 * l / cells;
    const double v = (i + 0.5) * h, u = 2.0 * l - v, x = l - v;
    const T us = g.onset_u[k];
    const bool first_stick = us <= T(u);

    // The mean of sqrt(1 - t) = sqrt((u - u_s) / u) over the cell, weighted by the bound's sqrt(u): small
    // creepages leave a traction 1 / sqrt(u) at the trailing edge, of which the middle of a cell sees too
    // little.
    const T us_cells = us * (1.0 / h);
    const T near = larger(T(0.0), ahead_of_cell - us_cells), far = larger(T(0.0), behind_cell - us_cells);
    const T whole = (near * root(near) - far * root(far)) * inverse_weight;
    const T s = whole * (1.0 - g.form[k] + g.form[k] * whole);
    const T stick_x = g.kappa[k] * (1.0 - s);
    const T stick_y = g.lambda[k] + (g.psi[k] - g.lambda[k]) * s;

    const T dv = larger(T(0.0), smaller(T(h), us - u));
    const T tau = g.B[k] * (u * v);
    const T rho_x = state.rho_x[k], rho_y = state.rho_y[k], before = state.bound[k];
    const T trial_x = rho_x * before - dv * g.gx[k];
    const T trial_y = rho_y * before - dv * (g.gy[k] + g.k[k] * (2.0 * x + dv));
    const bool stick = trial_x * trial_x + trial_y * trial_y <= tau * tau;

    const T flexibility = m.turning * (m.t11 * (1.0 - rho_x * rho_x) + m.t22 * (1.0 - rho_y * rho_y));
    const T wx = g.wx[k] + g.elastic[k] * x * rho_x;
    const T wy = g.wy[k] + m.phi * x - g.elastic[k] * x * rho_y;
    const T wy_mid = wy + 0.5 * m.phi * dv;
    const T turn = 2.0 * dv * root(wx * wx + wy_mid * wy_mid) / (flexibility * (before + tau + tiny_stress));
    const T z = smaller(turn, T(1e8));
    const T q = 1.0 + z + 0.5 * z * z;
    const T wy_seen = wy + m.phi * dv / (2.0 + z);
    const T product = root((rho_x * rho_x + rho_y * rho_y) * (wx * wx + wy_seen * wy_seen));
    const T along = -(rho_x * wx + rho_y * wy_seen), across = wy_seen * rho_x - wx * rho_y;
    const T towards = (product + along) * (q * q) - (product - along), aside = 2.0 * across * q;
    const T turned_x = aside * wy_seen - towards * wx, turned_y = -(towards * wy_seen) - aside * wx;
    const T turned2 = turned_x * turned_x + turned_y * turned_y;
    const bool turns = !first_stick && !stick && turned2 > T(1e-250);

    const T tau_safe = tau + tiny_stress;
    const T dir_x = first_stick ? stick_x : (turns ? turned_x : (stick ? trial_x / tau_safe : rho_x));
    const T dir_y = first_stick ? stick_y : (turns ? turned_y : (stick ? trial_y / tau_safe : rho_y));
    // unit length in slip; at most unit length elsewhere (|psi| > 1 could lift a stick zone over the bound)
    const T norm2 = turns ? turned2 : larger(T(1.0), dir_x * dir_x + dir_y * dir_y);
    const T inverse = 1.0 / root(norm2);
    const T ux = dir_x * inverse, uy = dir_y * inverse;
    state.rho_x[k] = first_stick ? rho_x : ux;
    state.rho_y[k] = first_stick ? rho_y : uy;
    state.bound[k] = first_stick ? before : tau;

    const T bound = g.bound[k] * shape_mean;
    row.px[k] = bound * ux;
    row.py[k] = bound * uy;
    const double part = value_of(dv) < h ? 0.5 + value_of(dv) / h : 1.0;
    row.slides[k] = first_stick || stick ? 0.0 : part;
  }
}

/// Magnitude of the slip in a slipping cell, before the scaling to the balance of power: rigid slip along the
/// traction plus the elastic slip 2 B L x of a strip that slips as a whole, times what Carter's solution, in
/// which s is proportional to sqrt(v (u_s - u)), makes of it when only u < u_s slips.
double slip_size(const Group<double>& g, const Model<double>& m, std::int32_t k, double v, double ex,
                 double ey) {
  const double l = g.half_length[k], u = 2.0 * l - v, x = l - v;
  const double rigid = -(g.wx[k] * ex + (g.wy[k] + m.phi * x) * ey);
  const double elastic = 2.0 * g.B[k] * (m.l11 * ex * ex + m.l22 * ey * ey) * x;
  const double behind = std::max(0.0, g.onset_u[k] - u);
  const double partial = g.onset_u[k] < 2.0 * l ? 2.0 * std::sqrt(behind * v) / (behind + v) : 1.0;
  return std::max(0.0, rigid - elastic) * partial;
}

template <class T>
struct Forces {
  T fx = 0.0, fy = 0.0, mz = 0.0;
  double area = 0.0, slid_area = 0.0, local_power = 0.0;
};

/// Marches the patch; with fields (T = double only) they are written, slip not yet scaled.
template <class T>
Forces<T> solve(const RollingContact& contact, const Model<T>& m, const TangentialFields& fields) {
  const MarchGrid& grid = *contact.grid;
  const Strips& strips = contact.region;
  Forces<T> total;
  for (std::int32_t first = 0; first < strips.count; first += lanes) {
    const std::int32_t count = std::min(lanes, strips.count - first);
    Group<T> g;
    State<T> state;
    prepare(m, strips, first, count, g, state);
    Row<T> row;
    Lane<T> px{}, py{}, x_py{};
    Lane<double> slid{}, power{};
    for (std::int32_t i = 0; i < grid.cells; ++i) {
      step(g, m, i, grid.cells, grid.elliptic.mean[i], state, row);
      const double s = 1.0 - (2.0 * i + 1.0) / grid.cells;
      for (std::int32_t k = 0; k < lanes; ++k) {
        px[k] += row.px[k];
        py[k] += row.py[k];
        x_py[k] += (g.centre[k] + g.half_length[k] * s) * row.py[k];
        slid[k] += row.slides[k];
      }
      if constexpr (std::is_same_v<T, double>) {
        const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(i) * strips.count + first;
        if (fields.traction_x) std::copy_n(row.px.data(), count, fields.traction_x + at);
        if (fields.traction_y) std::copy_n(row.py.data(), count, fields.traction_y + at);
        if (!fields.slip_x && !fields.slip_y) continue;
        for (std::int32_t k = 0; k < count; ++k) {
          double sx = 0.0, sy = 0.0;
          const double bound = g.bound[k] * grid.elliptic.mean[i];
          if (row.slides[k] > 0.0 && bound > 0.0) {
            const double ex = row.px[k] / bound, ey = row.py[k] / bound;
            const double v = (i + 0.5) * 2.0 * g.half_length[k] / grid.cells;
            const double size = slip_size(g, m, k, v, ex, ey) * row.slides[k];
            sx = -size * ex;
            sy = -size * ey;
            power[k] += size * bound;
          }
          if (fields.slip_x) fields.slip_x[at + k] = sx;
          if (fields.slip_y) fields.slip_y[at + k] = sy;
        }
      }
    }
    for (std::int32_t k = 0; k < count; ++k) {
      const double cell = 2.0 * g.half_length[k] / grid.cells * g.width[k];
      total.fx += px[k] * cell;
      total.fy += py[k] * cell;
      total.mz += (x_py[k] - g.y[k] * px[k]) * cell;
      total.area += cell * grid.cells;
      total.slid_area += slid[k] * cell;
      total.local_power += power[k] * cell;
    }
  }
  return total;
}

TangentialForces result(double fx, double fy, double mz, double area, double slid_area, const Creepage& c) {
  const double balance = -(fx * c.longitudinal + fy * c.lateral + mz * c.spin);
  return {fx, fy, mz, std::max(0.0, balance), area > 0.0 ? 1.0 - slid_area / area : 0.0};
}

}  // namespace

double neutral_line(double u, double poisson, double shape_number) {
  return 0.164 + 0.284 * u + 0.140 * u * u - (0.627 + 0.500 * u) * (poisson - 0.27) -
         0.077 * shape_number * shape_number;
}

TangentialForces strip_fastsim(const RollingContact& contact, const TangentialFields& fields, Fault& fault,
                               const StripCalibration& calibration) {
  const Creepage& c = contact.creepage;
  const Model<double> m =
      model<double>(contact, calibration, c.longitudinal, c.lateral, c.spin, contact.friction, fault);
  const Forces<double> f = solve(contact, m, fields);
  const TangentialForces forces = result(f.fx, f.fy, f.mz, f.area, f.slid_area, c);
  const double scale = f.local_power > 0.0 ? forces.power_per_speed / f.local_power : 0.0;
  const std::ptrdiff_t cells = static_cast<std::ptrdiff_t>(contact.region.count) * contact.grid->cells;
  for (double* slip : {fields.slip_x, fields.slip_y}) {
    if (slip) std::transform(slip, slip + cells, slip, [scale](double s) { return s * scale; });
  }
  return forces;
}

TangentialForces strip_fastsim(const RollingContact& contact, TangentialSensitivities& sensitivities,
                               Fault& fault) {
  // The load acts through mu N alone (pressure proportional to it), so four inputs give five derivatives.
  using Number = Dual<4>;
  const Creepage& c = contact.creepage;
  const Model<Number> m = model<Number>(contact, fitted_calibration, Number::input(c.longitudinal, 0),
                                        Number::input(c.lateral, 1), Number::input(c.spin, 2),
                                        Number::input(contact.friction, 3), fault);
  const Forces<Number> f = solve(contact, m, {});
  const double N = totals(contact.region).normal_force;
  const Number* rows[3] = {&f.fx, &f.fy, &f.mz};
  for (int r = 0; r < 3; ++r) {
    const auto& d = rows[r]->d;
    const double columns[5] = {d[0], d[1], d[2], N > 0.0 ? d[3] * contact.friction / N : 0.0, d[3]};
    std::copy_n(columns, 5, sensitivities.d[r]);
  }
  return result(f.fx.value, f.fy.value, f.mz.value, f.area, f.slid_area, c);
}

}  // namespace wrc
