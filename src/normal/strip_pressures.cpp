#include "normal/strip_pressures.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "normal/linear_solve.hpp"

namespace wrc {
namespace {

/// A strip enters when the bodies would overlap by this part of the approach: rounding must not decide.
constexpr double overlap_to_enter = 1e-4;

/// J(tau, xi) for xi mostly near 0: the middle plane's with the leading effect of xi, which is right both
/// near the line, sqrt(1 - xi^2), and far from it, 1 / sqrt(tau^2 + xi^2).
inline double seen_from(const StripKernel& kernel, double tau, double xi) {
  const double xi2 = xi * xi;
  if (xi2 > 0.09) return kernel.at(tau, std::abs(xi));
  return kernel.middle_plane(tau) * (1.0 - 0.5 * xi2 / (1.0 + tau * tau));
}

/// Displacement at the middle of strip j by unit peak in strip i, over the compliance [m].
inline double influence(const StripKernel& kernel, const StripSystem& s, std::int32_t j, std::int32_t i) {
  constexpr std::int32_t near = 8;  // strips away: beyond, the correction is below 2e-3 of an entry
  const double inverse = s.inverse_length[i], width = s.grid.width[i];
  if (i == j) return width * kernel.own_middle(0.5 * width * inverse);
  const double tau = std::abs(s.grid.y[i] - s.grid.y[j]) * inverse;
  double seen =
      s.skewed ? seen_from(kernel, tau, (s.centre[i] - s.centre[j]) * inverse) : kernel.middle_plane(tau);
  if (std::abs(i - j) <= near) {
    // Midpoint error of the logarithm over the strip's width: see strip_displacement (contact_condition.cpp).
    const double tau2 = tau * tau;
    const double t2 = 0.25 * width * width * inverse * inverse / tau2;
    seen += 2.0 * t2 * (1.0 / 6.0 + t2 * (1.0 / 20.0 + t2 / 42.0)) / std::sqrt(1.0 + tau2);
  }
  return width * seen;
}

double* influence_row(const StripSystem& s, std::int32_t j) {
  return s.influence + static_cast<std::int64_t>(j) * s.grid.count;
}

/// Copies the influence of the active strips on each other into the matrix, run by run of neighbours.
void gather(const StripSystem& s) {
  const std::int32_t m = s.active_count;
  const std::int64_t stride = solve_stride(m);
  std::int32_t* const run_end = s.next_active;  // free between exchanges of strips
  for (std::int32_t b = m - 1; b >= 0; --b)
    run_end[b] = b + 1 < m && s.active[b + 1] == s.active[b] + 1 ? run_end[b + 1] : b + 1;
  for (std::int32_t a = 0; a < m; ++a) {
    const double* const row = influence_row(s, s.active[a]);
    double* const target = s.matrix + a * stride;
    for (std::int32_t b = 0; b < m; b = run_end[b])
      std::copy_n(row + s.active[b], run_end[b] - b, target + b);
  }
}

/// Drops the strips that pull. True if there are any.
bool release(StripSystem& s) {
  std::int32_t kept = 0;
  for (std::int32_t a = 0; a < s.active_count; ++a) {
    double& peak = s.peak[s.active[a]];
    if (peak > 0.0)
      s.active[kept++] = s.active[a];
    else
      peak = 0.0;
  }
  const bool changed = kept < s.active_count;
  s.active_count = kept;
  return changed;
}

/// Takes in the strips where the bodies would overlap. True if there are any.
bool admit(const StripKernel& kernel, Search search, double compliance, double approach, StripSystem& s) {
  constexpr std::int32_t beside = 2;  // strips from the nearest in contact that still count as beside it
  std::int32_t a = 0, next_count = 0;
  const std::int32_t m = s.active_count;
  for (std::int32_t j = 0; j < s.grid.count; ++j) {
    bool in = a < m && s.active[a] == j;
    const bool near = (a < m && s.active[a] - j <= beside) || (a > 0 && j - s.active[a - 1] <= beside);
    if (in) {
      ++a;
    } else if (s.height[j] < approach && (near || search == Search::everywhere)) {
      double* const row = influence_row(s, j);
      double displacement = 0.0;
      for (std::int32_t b = 0; b < m; ++b) {
        const std::int32_t i = s.active[b];
        row[i] = influence(kernel, s, j, i);
        displacement += row[i] * s.peak[i];
      }
      in = compliance * displacement < (1.0 - overlap_to_enter) * approach - s.height[j];
    }
    if (in) s.next_active[next_count++] = j;
  }
  if (next_count == m) return false;
  // The columns of those that entered; their rows among the old ones are known from above.
  a = 0;
  for (std::int32_t b = 0; b < next_count; ++b) {
    const std::int32_t i = s.next_active[b];
    if (a < m && s.active[a] == i) {
      ++a;
      continue;
    }
    for (std::int32_t c = 0; c < next_count; ++c) {
      const std::int32_t j = s.next_active[c];
      influence_row(s, j)[i] = influence(kernel, s, j, i);
    }
  }
  std::swap(s.active, s.next_active);
  s.active_count = next_count;
  return true;
}

}  // namespace

double solve_pressures(const NormalProblem& problem, const StripKernel& kernel, Search search, StripSystem& s,
                       double& stiffness) noexcept {
  const double compliance = problem.material.normal_compliance();
  for (std::int32_t i = 0; i < s.grid.count; ++i) s.inverse_length[i] = 1.0 / s.half_length[i];
  for (std::int32_t a = 0; a < s.active_count; ++a) {
    double* const row = influence_row(s, s.active[a]);
    for (std::int32_t b = 0; b < s.active_count; ++b)
      row[s.active[b]] = influence(kernel, s, s.active[a], s.active[b]);
  }

  double approach = problem.approach;
  constexpr int rounds = 6;
  for (int round = 0; round < rounds; ++round) {
    const std::int32_t m = s.active_count;
    gather(s);
    for (std::int32_t a = 0; a < m; ++a) {
      s.by_approach[a] = 1.0 / compliance;
      s.by_height[a] = s.height[s.active[a]] / compliance;
    }
    solve_two(m, s.matrix, s.by_approach, s.by_height);

    double load_by_approach = 0.0, load_by_height = 0.0;
    for (std::int32_t a = 0; a < m; ++a) {
      const std::int32_t j = s.active[a];
      const double section = 0.5 * pi * s.half_length[j] * s.grid.width[j];
      load_by_approach += section * s.by_approach[a];
      load_by_height += section * s.by_height[a];
    }
    if (problem.prescribed == Prescribed::load)
      approach = (problem.normal_force + load_by_height) / load_by_approach;
    stiffness = load_by_approach;

    std::fill(s.peak, s.peak + s.grid.count, 0.0);
    for (std::int32_t a = 0; a < m; ++a) s.peak[s.active[a]] = approach * s.by_approach[a] - s.by_height[a];
    if (!release(s) && !admit(kernel, search, compliance, approach, s)) break;
    if (s.active_count == 0) break;
  }
  return approach;
}

}  // namespace wrc
