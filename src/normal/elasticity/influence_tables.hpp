/// Elastic displacement around a line of semi-elliptic pressure, tabulated: the influence function of the
/// strip half-space solver.
///
///   J(tau, xi) = Int_{-1}^{1} sqrt(1 - t^2) / sqrt((t - xi)^2 + tau^2) dt
///
/// is the displacement at lateral distance tau and longitudinal distance xi from a line of half length 1 and
/// peak pressure 1, per unit of lateral width and of normal compliance. On the line's middle plane (xi = 0)
/// it is the closed form of contact_condition.hpp; elsewhere it needs elliptic integrals of the third kind,
/// and a table costs a tenth of them.
///
/// J is singular only on the line itself. In the spheroidal coordinates of the line's ends,
///   chi = (r1 + r2) / 2 >= 1,  eta = (r1 - r2) / 2 in 0..1,  r1,2 = distances to the ends,
/// it is smooth in eta' = sqrt(1 - eta) and, towards the line, linear in log(chi - 1). The tables are
/// therefore linear between nodes that stand in every octave of chi - 1 (or tau) at equal distances: the node
/// is read off the bits of the number, no logarithm is taken.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "normal/elasticity/octave_axis.hpp"
#include "normal/simd/tasks.hpp"

namespace wrc {

/// About 110 kB, immutable after tabulate(); one serves all threads.
struct InfluenceTables {
  static constexpr OctaveAxis distance_axis{-12, 20, 6};  // tau = 2.4e-4 .. 256
  static constexpr OctaveAxis chi_axis{-18, 26, 4};       // chi - 1 = 3.8e-6 .. 256
  static constexpr int eta_intervals = 24;

  std::array<double, distance_axis.intervals() + 1> on_middle_plane;  ///< J(tau, 0)
  std::array<double, distance_axis.intervals() + 1> mean_under;       ///< mean of J(s, 0) over 0 < s < tau
  std::array<double, distance_axis.intervals() + 1> edge_under;       ///< mean of J(s, 1) over 0 < s < tau
  std::array<double, (chi_axis.intervals() + 1) * (eta_intervals + 1)> anywhere;

  simd::StripTables tables() const noexcept {
    return {on_middle_plane.data(), edge_under.data(), anywhere.data()};
  }

  /// J(tau, 0), tau > 0; relative error below 1e-4.
  double middle_plane(double tau) const noexcept { return read(on_middle_plane.data(), tau); }

  /// Mean of J(s, 0) over |s| < tau: a strip seen from its own middle, tau = half its width.
  double own_middle(double tau) const noexcept { return read(mean_under.data(), tau); }

  /// J(tau, xi), tau > 0; relative error below 2e-3.
  double at(double tau, double xi) const noexcept {
    const double tau2 = tau * tau;
    const double to_trailing = std::sqrt((xi + 1.0) * (xi + 1.0) + tau2);
    const double to_leading = std::sqrt((xi - 1.0) * (xi - 1.0) + tau2);
    const double one_minus_eta = 1.0 - 0.5 * std::abs(to_trailing - to_leading);
    const auto [row, f] = chi_axis.locate(0.5 * (to_trailing + to_leading) - 1.0);
    const double v = std::sqrt(std::max(0.0, one_minus_eta)) * eta_intervals;
    const int column = std::min(static_cast<int>(v), eta_intervals - 1);
    const double g = v - column;
    const double* const low = anywhere.data() + row * (eta_intervals + 1) + column;
    const double* const high = low + eta_intervals + 1;
    const double at_low = low[0] + g * (low[1] - low[0]);
    const double at_high = high[0] + g * (high[1] - high[0]);
    return at_low + f * (at_high - at_low);
  }

  /// Mean of J(s, 1) over |s| < tau: a strip seen from its own leading edge.
  double own_edge(double tau) const noexcept { return read(edge_under.data(), tau); }

 private:
  static double read(const double* values, double tau) noexcept {
    const auto [index, f] = distance_axis.locate(tau);
    return values[index] + f * (values[index + 1] - values[index]);
  }
};

/// Fills the tables (about ten milliseconds; at init, not in a step). Same bits on
/// every machine.
void tabulate(InfluenceTables& influence) noexcept;

/// J by quadrature, tau > 0: what the tables are made from [-].
double line_potential(double tau, double xi) noexcept;

}  // namespace wrc
