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
/// J is singular only on the line itself, where it is linear in log(tau), and bends like the root of the
/// distance at the line's end. The table has nodes that are even in log(tau) and, from the end to both sides,
/// in octaves of |xi - 1| + a small length: the node is read off the bits of these numbers, without a root, a
/// division or a logarithm. It is linear between them. Its values at the nodes are not J's but lie so much
/// beside them (a twelfth of the second differences) that straight lines follow the curve in the mean: the
/// displacement by many strips together then has a much smaller error than that by one.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "base/bits.hpp"
#include "normal/elasticity/octave_axis.hpp"
#include "normal/simd/tasks.hpp"

namespace wrc::normal {

/// Two positive numbers in the place of one, to 21 bits: the upper halves of their bits. A table of them
/// gives twice as much for one access.
inline double twin(double first, double second) noexcept {
  constexpr std::uint64_t half = std::uint64_t{1} << 31;
  return number_of((bits_of(first) + half) >> 32 | (bits_of(second) + half) >> 32 << 32);
}
inline double first_of(double twin) noexcept { return number_of(bits_of(twin) << 32); }
inline double second_of(double twin) noexcept { return number_of(bits_of(twin) >> 32 << 32); }

/// About 280 kB, of which a contact reads a tenth; immutable after tabulate(); one serves all threads.
struct InfluenceTables {
  static constexpr OctaveAxis distance_axis{-12, 20, 6};  // tau = 2.4e-4 .. 256
  static constexpr LogAxis line_rows{-10, 18};            // tau = 9.8e-4 .. 256
  static constexpr OctaveAxis from_end{-4, 9, 4};         // |xi - 1| + 1/16: xi = 0 .. 33
  /// A row has the nodes outside the line, xi >= 1, then those inside, each from the end on. The last two
  /// beside its middle: xi = 0 is a node, which has one behind it like any other.
  static constexpr int inside = from_end.intervals() + 1;
  static constexpr int nodes_inside = 67;
  static constexpr int columns = inside + nodes_inside;

  /// Twins: J(tau, 0) and 1 / sqrt(1 + tau^2).
  std::array<double, distance_axis.intervals() + 1> on_middle_plane;
  std::array<double, distance_axis.intervals() + 1> mean_under;  ///< mean of J(s, 0) over 0 < s < tau
  std::array<double, distance_axis.intervals() + 1> edge_under;  ///< mean of J(s, 1) over 0 < s < tau
  /// Twins: J at this node and at that of the next row; a row has one tau.
  std::array<double, line_rows.intervals() * columns> anywhere;

  simd::StripTables tables() const noexcept {
    return {on_middle_plane.data(), edge_under.data(), anywhere.data()};
  }

  /// J(tau, 0), tau > 0; relative error below 1e-4.
  double middle_plane(double tau) const noexcept {
    const auto [index, f] = distance_axis.locate(tau);
    const double* const at = on_middle_plane.data() + index;
    return first_of(at[0]) + f * (first_of(at[1]) - first_of(at[0]));
  }

  /// Mean of J(s, 0) over |s| < tau: a strip seen from its own middle, tau = half its width.
  double own_middle(double tau) const noexcept { return read(mean_under.data(), tau); }

  /// J(tau, xi), tau > 0, xi >= 0; relative error below 1e-3, in the mean below 2e-5.
  double at(double tau, double xi) const noexcept {
    // Row and column of the cell, and the parts of the way to the next, f and g.
    const double row_place = line_rows.place(tau);
    const int row = static_cast<int>(row_place);
    const double f = row_place - row;
    const auto [node, g] = from_end.locate(std::abs(xi - 1.0) + from_end.node(0));
    const double* const cell = anywhere.data() + row * columns + (xi < 1.0 ? inside : 0) + node;
    // Bilinear: a cell holds J at its node and at that of the next row.
    const double here = first_of(cell[0]) + f * (second_of(cell[0]) - first_of(cell[0]));
    const double next = first_of(cell[1]) + f * (second_of(cell[1]) - first_of(cell[1]));
    return here + g * (next - here);
  }

  /// Mean of J(s, 1) over |s| < tau: a strip seen from its own leading edge.
  double own_edge(double tau) const noexcept { return read(edge_under.data(), tau); }

 private:
  static double read(const double* values, double tau) noexcept {
    const auto [index, f] = distance_axis.locate(tau);
    return values[index] + f * (values[index + 1] - values[index]);
  }
};

/// Fills the tables (about ten milliseconds; at init, not in a step). Same bits on every machine.
void tabulate(InfluenceTables& influence) noexcept;

/// J by quadrature, tau > 0, from which the tables are made [-].
double line_potential(double tau, double xi) noexcept;

}  // namespace wrc::normal
