#include "surface/pressure/newton.hpp"

#include <algorithm>

#include "base/number.hpp"
#include "surface/pressure/smoothing.hpp"

namespace wrc::surface {
namespace {

constexpr std::int32_t most_steps = 40;
/// Part of the tolerance to which steps are taken: behind the last one there is no other.
constexpr double nearer = 0.1;
constexpr double least_part = 0.015;  ///< least part of a step that is taken
constexpr double gained = 0.3;        ///< part of a linear residual's loss that a step loses at least
constexpr double shrinking = 0.1, growth = 10.0;  ///< factors on L that a step takes at most
/// Where two solutions have just vanished the residual has a minimum. A whole step leads past it, taken so
/// many times where the map moves this part of the area or less.
constexpr std::int32_t most_jumps = 3;
constexpr double small_minimum = 1e-3;
/// Over the norm of L: length of a difference that stands for a derivative.
constexpr double difference = 1e-7;
/// Part of the residual at which the linear equations are solved.
constexpr double solved = 0.1;

/// Vectors of the ring of iterates, two of each, which is free.
constexpr std::int32_t vectors = 2 * (history + 1);

/// A solve: unknowns L [m^2] and, on skewed contacts, shifts [m].
class Newton {
 public:
  Newton(const PressureProblem& problem, StripSet& s, const IterationLimits& limits, PressureScratch& w)
      : problem_(problem),
        limits_(limits),
        s_(s),
        w_(w),
        count_(s.count),
        start_(w.next),
        loads_(w.iterate[0].q) {
    begin_iterations(s, w);
    unknowns_ = s.skewed ? 2 * count_ : count_;
    for (std::int32_t i = 0; i <= history; ++i) {
      v_[2 * i] = w.iterate[i].x;
      v_[2 * i + 1] = w.iterate[i].f;
    }
  }

  PressureResult solve(double tolerance) {
    PressureResult result;
    if (!look(Asked::all)) return {.residual = any_change};
    // Shifts weigh by the mean L beside lengths squared, as in iterate().
    shift_weight_ = w_.change.area / (count_ * s_.width[0]);
    double moved = moved_part();
    keep();
    // Steps that lose residual; where none does, jumps past a small minimum.
    std::int32_t jumps = 0;
    for (std::int32_t step = 0; moved > nearer * tolerance && step < most_steps && find_step(); ++step) {
      const bool less = take_step(moved);
      if (!less && (moved <= tolerance || moved > small_minimum || jumps++ == most_jumps || !look_at(1.0)))
        break;
      moved = moved_part();
      keep();
    }
    result.converged = moved <= tolerance;
    result.residual = moved;
    result.iterations = looks_;
    // The last iterate kept, with its loads. Strips that are not in contact have none.
    go_back();
    for (std::int32_t i = 0; i < count_; ++i) {
      result.strips += w_.in_contact[i];
      if (!w_.in_contact[i]) s_.L[i] = s_.q[i] = 0.0;
    }
    return result;
  }

 private:
  double moved_part() const { return w_.active.count > 0 ? w_.change.moved / w_.change.area : any_change; }

  /// Scalar product, shifts by their weight.
  double product_of(const double* a, const double* b) const {
    return product(count_, a, b) +
           (s_.skewed ? shift_weight_ * product(count_, a + count_, b + count_) : 0.0);
  }

  /// Evaluates the map at the lengths and shifts in `s`. False, if that exceeds the work or nothing presses.
  bool look(Asked asked) {
    std::int32_t n = 0;
    for (std::int32_t i = 0; i < count_; ++i) n += w_.in_contact[i];
    w_.max_work = smaller(limits_.max_work, work_in_contact(n, limits_.in_contact));
    if (n == 0 || w_.work + 2.0 * work_of_pass(n) > w_.max_work) return false;
    ++looks_;
    evaluate(problem_, s_, asked, w_);
    return true;
  }

  /// Keeps where a step begins. Strips that have entered have their least length.
  void keep() {
    for (std::int32_t i = 0; i < count_; ++i) {
      const double least = least_half_length * s_.width[i];
      s_.L[i] = w_.in_contact[i] ? larger(s_.L[i], least * least) : 0.0;
    }
    std::copy_n(s_.L, count_, start_);
    std::copy_n(s_.shift, count_, start_ + count_);
    std::copy_n(s_.q, count_, loads_);
  }
  void go_back() {
    std::copy_n(start_, count_, s_.L);
    std::copy_n(start_ + count_, count_, s_.shift);
    std::copy_n(loads_, count_, s_.q);
    for (std::int32_t i = 0; i < count_; ++i) w_.in_contact[i] = start_[i] > 0.0;
  }

  /// The preconditioned residual of the strips in contact.
  void read_residual(double* to) {
    std::copy_n(w_.residual, unknowns_, to);
    precondition(s_, to, w_);
    for (std::int32_t i = 0; i < count_; ++i)
      if (!w_.in_contact[i]) to[i] = 0.0;
  }

  /// Moves from the start by `part` of a direction.
  void move(double part, const double* direction) {
    for (std::int32_t i = 0; i < count_; ++i) {
      // Strips that have left or entered since are as at the start.
      w_.in_contact[i] = start_[i] > 0.0;
      s_.L[i] = start_[i] + part * direction[i];
      if (s_.skewed) s_.shift[i] = start_[count_ + i] + part * direction[count_ + i];
    }
  }

  /// Newton's step into v_[0]: GMRES on -J x = f, both preconditioned, with products J v by differences.
  bool find_step() {
    // The first vector is the residual over its size. A difference is short beside the norm of L.
    double* const f = v_[0];
    read_residual(f);
    const double size = root(product_of(f, f)), by = difference * root(product(count_, start_, start_));
    if (!(size > 0.0)) return false;
    for (std::int32_t i = 0; i < unknowns_; ++i) f[i] /= size;
    // Rotations make the Hessenberg matrix triangular; left[n] is the residual that n vectors leave.
    double upper[vectors][vectors], left[vectors + 1] = {size}, cosine[vectors], sine[vectors];
    std::int32_t n = 0;
    while (n + 1 < vectors && magnitude(left[n]) > solved * size) {
      // -J v, with the strips in contact as they are.
      move(by, v_[n]);
      if (!look(Asked::none)) break;
      double* const next = v_[n + 1];
      read_residual(next);
      for (std::int32_t i = 0; i < unknowns_; ++i) next[i] = (size * f[i] - next[i]) / by;
      // Gram and Schmidt: at right angles to the vectors before.
      for (std::int32_t a = 0; a <= n; ++a) {
        const double along = upper[a][n] = product_of(next, v_[a]);
        for (std::int32_t i = 0; i < unknowns_; ++i) next[i] -= along * v_[a][i];
      }
      const double rest = root(product_of(next, next));
      // The rotations before turn the new column; one more takes its last element away.
      for (std::int32_t a = 0; a < n; ++a) {
        const double above = upper[a][n], below = upper[a + 1][n];
        upper[a][n] = cosine[a] * above + sine[a] * below;
        upper[a + 1][n] = cosine[a] * below - sine[a] * above;
      }
      const double pivot = root(upper[n][n] * upper[n][n] + rest * rest);
      if (!(pivot > 0.0)) break;
      cosine[n] = upper[n][n] / pivot;
      sine[n] = rest / pivot;
      upper[n][n] = pivot;
      left[n + 1] = -sine[n] * left[n];
      left[n] *= cosine[n];
      ++n;
      if (!(rest > 0.0)) break;
      for (std::int32_t i = 0; i < unknowns_; ++i) next[i] /= rest;
    }
    if (n == 0) return false;
    // Shares of the vectors, and their sum.
    for (std::int32_t a = n - 1; a >= 0; --a) {
      for (std::int32_t b = a + 1; b < n; ++b) left[a] -= upper[a][b] * left[b];
      left[a] /= upper[a][a];
    }
    for (std::int32_t i = 0; i < unknowns_; ++i) {
      double sum = 0.0;
      for (std::int32_t a = 0; a < n; ++a) sum += left[a] * v_[a][i];
      f[i] = sum;
    }
    return true;
  }

  /// Looks at the iterate behind a part of the step in v_[0]. False, if that exceeds the work.
  bool look_at(double part) {
    move(part, v_[0]);
    for (std::int32_t i = 0; i < count_; ++i) {
      s_.L[i] = smaller(larger(s_.L[i], shrinking * start_[i]), growth * start_[i]);
      s_.shift[i] = smaller(larger(s_.shift[i], -longest_shift), longest_shift);
    }
    return look(Asked::all);
  }

  /// Takes the step, or half, a quarter ... of it, until the map moves the iterate by a smaller part of the
  /// area than before. Returns whether it does.
  bool take_step(double before) {
    for (double part = 1.0; part > least_part && look_at(part); part *= 0.5)
      if (moved_part() < (1.0 - gained * part) * before) return true;
    return false;
  }

  const PressureProblem& problem_;
  const IterationLimits& limits_;
  StripSet& s_;
  PressureScratch& w_;
  std::int32_t count_, unknowns_ = 0, looks_ = 0;
  double shift_weight_ = 0.0;
  double *start_, *loads_;  ///< L and shifts, and loads, that a step begins with
  double* v_[vectors];      ///< Krylov vectors
};

}  // namespace

PressureResult solve_by_newton(const PressureProblem& problem, StripSet& s, const IterationLimits& limits,
                               PressureScratch& w) {
  return Newton(problem, s, limits, w).solve(limits.tolerance);
}

}  // namespace wrc::surface
