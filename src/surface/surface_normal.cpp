#include "surface/surface_normal.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "elementary.hpp"

namespace wrc {
namespace {

/// Half lengths below this part of a strip's width count as it: a strip that enters has a place and no length.
constexpr double least_half_length = 0.02;
constexpr std::int32_t memory_of_sweeps = 5;  // of Anderson's acceleration

/// Dense equations of n unknowns by elimination without pivoting, rows of `stride`.
void eliminate(std::int32_t n, std::int64_t stride, double* a, double* b) {
  for (std::int32_t k = 0; k < n; ++k) {
    const double inverse = 1.0 / a[k * stride + k];
    for (std::int32_t i = k + 1; i < n; ++i) {
      const double f = a[i * stride + k] * inverse;
      if (f == 0.0) continue;
      for (std::int32_t c = k + 1; c < n; ++c) a[i * stride + c] -= f * a[k * stride + c];
      b[i] -= f * b[k];
    }
  }
  for (std::int32_t k = n - 1; k >= 0; --k) {
    double sum = b[k];
    for (std::int32_t c = k + 1; c < n; ++c) sum -= a[k * stride + c] * b[c];
    b[k] = sum / a[k * stride + k];
  }
}

struct Workspace {
  double *B, *A, *b, *u, *l, *target, *trailing, *leading, *level_wanted, *shift_wanted, *residual, *shift, *shift_residual, *next;
  double* history_x[memory_of_sweeps + 1];
  double* history_f[memory_of_sweeps + 1];
};

}  // namespace

std::int64_t surface_normal_doubles(std::int32_t most) {
  return 2 * static_cast<std::int64_t>(most) * most + (16 + 4 * (memory_of_sweeps + 1)) * static_cast<std::int64_t>(most) + 64;
}

SurfaceNormalResult solve_surface_normal(const RailStrips& rail, const Overlaps& o, const StripKernel& kernel,
                                         double compliance, const SurfaceNormalOptions& options, double* memory,
                                         SurfaceStart& start, const SurfacePressure& p) noexcept {
  const std::int32_t n = o.count;
  SurfaceNormalResult result;
  if (n == 0) {
    result.converged = true;
    return result;
  }
  Workspace w{};
  {
    const std::int64_t m = o.capacity;
    double* at = memory;
    const auto take = [&](std::int64_t doubles) { double* const here = at; at += doubles; return here; };
    w.B = take(m * m);
    w.A = take(m * m);
    w.b = take(m);
    w.u = take(m);
    w.l = take(m);
    w.target = take(m);
    w.trailing = take(m);
    w.leading = take(m);
    w.level_wanted = take(m);
    w.shift_wanted = take(m);
    w.residual = take(m);
    w.shift = take(m);
    w.shift_residual = take(m);
    w.next = take(2 * m);
    for (double*& h : w.history_x) h = take(2 * m);
    for (double*& h : w.history_f) h = take(2 * m);
  }
  double first_centre = o.centre[0];
  bool skewed = false;
  for (std::int32_t i = 0; i < n; ++i) skewed = skewed || o.centre[i] != first_centre;

  const auto least = [&](std::int32_t i) {
    const double l = least_half_length * rail.width[o.strip[i]];
    return l * l;
  };
  bool any = false;
  if (start.set)
    for (std::int32_t i = 0; i < n; ++i) any = any || start.length_squared[o.strip[i]] > 0.0;
  for (std::int32_t i = 0; i < n; ++i) {
    const std::int32_t j = o.strip[i];
    p.length_squared[i] = any ? start.length_squared[j] : std::max(o.depth[i], 0.0) / o.curvature[i];
    w.shift[i] = any ? start.shift[j] : 0.0;
    p.level[i] = 0.0;
    p.strength[i] = 0.0;
  }
  // active set as flags in w.target's stead: strips with L > 0
  constexpr std::int32_t most_active = 1024;
  std::int32_t active[most_active];
  bool in[most_active];
  std::int32_t kept = 0, since = 0, slow = 0;
  double moved_before = 1e300;
  for (std::int32_t i = 0; i < n; ++i) in[i] = p.length_squared[i] > 0.0;

  for (std::int32_t sweep = 0; sweep < options.max_sweeps; ++sweep) {
    ++result.sweeps;
    for (std::int32_t i = 0; i < n; ++i) {
      w.l[i] = std::sqrt(std::max(p.length_squared[i], least(i)));
      p.centre[i] = o.centre[i] + w.shift[i];
    }
    // influence of all on all, columns of strips that may be active
    for (std::int32_t i = 0; i < n; ++i) {
      const std::int32_t a = o.strip[i];
      for (std::int32_t k = 0; k < n; ++k) {
        const std::int32_t b = o.strip[k];
        const double l = w.l[k];
        double seen;
        if (i == k) {
          seen = kernel.own_middle(0.5 * rail.width[b] / l);
        } else {
          const double inverse = 1.0 / l;
          const double tau = std::abs(rail.s[a] - rail.s[b]) * inverse;
          const double xi = std::abs(p.centre[i] - p.centre[k]) * inverse;
          seen = xi == 0.0 ? kernel.middle_plane(tau) : kernel.at(tau, xi);
          const double tau2 = tau * tau;
          const double to_end = std::sqrt(1.0 + tau2), inverse_cube = 1.0 / (tau2 * to_end);
          const double half = 0.5 * rail.width[b] * inverse, square = half * half;
          const double t2 = square * (inverse_cube * to_end);
          const double flat = std::sqrt(std::max(0.0, 1.0 - xi * xi));
          if (tau < 10.0 * 2.0 * half) seen += flat * 2.0 * square * inverse_cube * (1.0 / 6.0 + t2 * (1.0 / 20.0 + t2 * (1.0 / 42.0)));
          seen *= o.ny[i] * o.ny[k] + o.nz[i] * o.nz[k];
        }
        w.B[i * o.capacity + k] = compliance * rail.width[b] * seen / l;
      }
    }
    // contact
    for (std::int32_t round = 0; round < 20; ++round) {
      kept = 0;
      for (std::int32_t i = 0; i < n; ++i)
        if (in[i]) active[kept++] = i;
      if (kept == 0) {
        std::int32_t deepest = 0;
        for (std::int32_t i = 1; i < n; ++i)
          if (o.depth[i] > o.depth[deepest]) deepest = i;
        if (!(o.depth[deepest] > 0.0)) break;
        in[deepest] = true;
        continue;
      }
      for (std::int32_t i = 0; i < kept; ++i) {
        for (std::int32_t k = 0; k < kept; ++k) w.A[i * o.capacity + k] = w.B[active[i] * o.capacity + active[k]];
        w.b[i] = o.depth[active[i]];
      }
      eliminate(kept, o.capacity, w.A, w.b);
      bool changed = false;
      for (std::int32_t i = 0; i < n; ++i) {
        if (in[i]) continue;
        double u = 0.0;
        for (std::int32_t k = 0; k < kept; ++k) u += w.B[i * o.capacity + active[k]] * w.b[k];
        if (u < o.depth[i] - 1e-15) changed = in[i] = true;
      }
      for (std::int32_t i = 0; i < kept; ++i)
        if (w.b[i] < 0.0) {
          in[active[i]] = false;
          changed = true;
        }
      if (!changed) break;
    }
    if (kept == 0) break;
    // edges
    std::fill_n(p.strength, n, 0.0);
    for (std::int32_t i = 0; i < kept; ++i) p.strength[active[i]] = std::max(w.b[i], 0.0);
    const auto displacement = [&](std::int32_t i, double x) {
      double u = 0.0;
      for (std::int32_t k = 0; k < kept; ++k) {
        const std::int32_t j = active[k];
        const double inverse = 1.0 / w.l[j];
        const double seen =
            j == i ? kernel.own_edge(0.5 * rail.width[o.strip[j]] * inverse)
                   : kernel.at(std::abs(rail.s[o.strip[i]] - rail.s[o.strip[j]]) * inverse,
                               std::abs(x - p.centre[j]) * inverse) *
                         (o.ny[i] * o.ny[j] + o.nz[i] * o.nz[j]);
        u += compliance * rail.width[o.strip[j]] * seen * p.strength[j] * inverse;
      }
      return u;
    };
    for (std::int32_t k = 0; k < kept; ++k) {
      const std::int32_t i = active[k];
      const double l = w.l[i], L = l * l;
      w.leading[i] = displacement(i, p.centre[i] + l);
      w.trailing[i] = skewed ? displacement(i, p.centre[i] - l) : w.leading[i];
      const double drop = o.depth[i] - 0.5 * (w.leading[i] + w.trailing[i]);
      const double ratio = std::clamp(drop / (0.5 * o.curvature[i] * L), 0.2, 5.0);
      w.level_wanted[i] = (p.strength[i] / L) / ratio;
      w.shift_wanted[i] = (w.trailing[i] - w.leading[i]) / (2.0 * l * o.curvature[i]);
    }
    double moved = 0.0, area = 0.0;
    for (std::int32_t i = 0; i < n; ++i) {
      w.residual[i] = -p.length_squared[i];
      w.shift_residual[i] = 0.0;
    }
    for (std::int32_t k = 0; k < kept; ++k) {
      const std::int32_t i = active[k], a = o.strip[i];
      double weight = 0.0, level = 0.0, shift = 0.0;
      const double* const row = rail.smoothing + a * (2 * rail.reach + 1) + rail.reach;
      for (std::int32_t q = 0; q < kept; ++q) {
        const std::int32_t j = active[q], apart = o.strip[j] - a;
        if (apart < -rail.reach || apart > rail.reach) continue;
        const double here = row[apart] * p.strength[j];
        weight += here;
        level += here * w.level_wanted[j];
        shift += here * w.shift_wanted[j];
      }
      if (!(weight > 0.0)) {
        level = w.level_wanted[i];
        shift = w.shift_wanted[i];
        weight = 1.0;
      }
      p.level[i] = level / weight;
      const double wanted = p.strength[i] / p.level[i];
      w.residual[i] += wanted;
      if (skewed) w.shift_residual[i] = std::clamp(shift / weight, -10e-3, 10e-3) - w.shift[i];
    }
    for (std::int32_t i = 0; i < n; ++i) {
      moved += std::abs(w.residual[i]) + std::abs(w.shift_residual[i]) * w.l[i];
      area += p.length_squared[i] + w.residual[i];
    }
    if (getenv("TRACE")) std::printf("   sweep %d kept %d moved %.2e\n", sweep, kept, moved / area);
    if (moved <= options.tolerance * area) {
      for (std::int32_t i = 0; i < n; ++i) {
        p.length_squared[i] += w.residual[i];
        w.shift[i] += w.shift_residual[i];
      }
      result.converged = true;
      break;
    }
    // Anderson
    const std::int32_t depth = getenv("ANDERSON") ? atoi(getenv("ANDERSON")) : memory_of_sweeps;
    // where acceleration does not pay it starts anew
    if (moved > 0.7 * moved_before) slow += 1; else slow = 0;
    if (slow >= 2) { since = 0; slow = 0; }
    moved_before = moved;
    const std::int32_t slot = sweep % (memory_of_sweeps + 1), both = skewed ? 2 * n : n;
    double* const x = w.history_x[slot];
    double* const f = w.history_f[slot];
    // shifts count like lengths: by the half length they move
    const double size = std::sqrt(area / n);
    for (std::int32_t i = 0; i < n; ++i) {
      x[i] = p.length_squared[i];
      f[i] = w.residual[i];
      x[n + i] = w.shift[i];
      f[n + i] = w.shift_residual[i];
    }
    for (std::int32_t i = 0; i < both; ++i) w.next[i] = x[i] + f[i];
    const std::int32_t used = std::min({since, depth, memory_of_sweeps});
    ++since;
    if (used > 0) {
      double G[memory_of_sweeps * memory_of_sweeps], g[memory_of_sweeps];
      const auto product = [&](const double* fa, const double* fb) {
        double sum = 0.0, shifts = 0.0;
        for (std::int32_t i = 0; i < n; ++i) sum += (f[i] - fa[i]) * fb[i];
        if (skewed)
          for (std::int32_t i = n; i < both; ++i) shifts += (f[i] - fa[i]) * fb[i];
        return sum + size * size * shifts;
      };
      const auto earlier = [&](double* const* history, std::int32_t a) { return history[(sweep - 1 - a) % (memory_of_sweeps + 1)]; };
      for (std::int32_t a = 0; a < used; ++a) {
        const double* fa = earlier(w.history_f, a);
        g[a] = product(fa, f);
        for (std::int32_t b = 0; b <= a; ++b)
          G[a * memory_of_sweeps + b] = G[b * memory_of_sweeps + a] = g[a] - product(fa, earlier(w.history_f, b));
      }
      for (std::int32_t a = 0; a < used; ++a) G[a * memory_of_sweeps + a] *= 1.0 + 1e-10;
      eliminate(used, memory_of_sweeps, G, g);
      for (std::int32_t a = 0; a < used; ++a) {
        const double* fa = earlier(w.history_f, a);
        const double* xa = earlier(w.history_x, a);
        for (std::int32_t i = 0; i < both; ++i) w.next[i] -= g[a] * ((x[i] - xa[i]) + (f[i] - fa[i]));
      }
    }
    for (std::int32_t i = 0; i < n; ++i) {
      const double plain = p.length_squared[i] + w.residual[i], old = p.length_squared[i];
      double next = w.next[i];
      if (plain == 0.0) next = 0.0;
      else next = std::clamp(next, 0.1 * std::max(plain, 0.0), 10.0 * plain);
      if (old > 0.0 && plain > 0.0 && sweep < 6) next = std::clamp(next, 0.1 * old, 10.0 * old);
      p.length_squared[i] = next;
      if (skewed) w.shift[i] = std::clamp(w.next[n + i], -10e-3, 10e-3);
    }
  }
  for (std::int32_t j = 0; j < rail.count; ++j) start.length_squared[j] = start.shift[j] = 0.0;
  for (std::int32_t i = 0; i < n; ++i) {
    start.length_squared[o.strip[i]] = in[i] ? p.length_squared[i] : 0.0;
    start.shift[o.strip[i]] = w.shift[i];
    if (!in[i]) p.strength[i] = p.length_squared[i] = 0.0;
  }
  start.set = true;
  return result;
}

}  // namespace wrc
