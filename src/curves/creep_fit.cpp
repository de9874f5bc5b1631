#include "curves/creep_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/elementary.hpp"
#include "contact/stages.hpp"
#include "curves/symmetric.hpp"

namespace wrc::curves {
namespace {

using Vector = std::array<double, most_parameters>;
using Matrix = Symmetric<most_parameters>;

constexpr double difference = 1e-3;  // step in u, for slopes
constexpr double farthest = 3.0;     // largest change of u in a step
constexpr double singular = 1e-10;   // eigenvalue of the scaled matrix along which nothing is determined
constexpr double takes_part = 1e-4;  // share of a parameter in such an eigenvector
constexpr double settled = 1e-10;    // relative fall of the sum in the last iteration

/// Half width of an interval of 95 % over the deviation, by Student's distribution: series of Cornish and
/// Fisher.
double students_factor(double freedom) {
  const double z = 1.959963984540054, z2 = z * z;
  const double first = z * (z2 + 1.0) / 4.0, second = z * ((5.0 * z2 + 16.0) * z2 + 3.0) / 96.0;
  const double third = z * (((3.0 * z2 + 19.0) * z2 + 17.0) * z2 - 15.0) / 384.0;
  return z + (first + (second + third / freedom) / freedom) / freedom;
}

class Fitter {
 public:
  Fitter(contact::Contact& contact, const CurveFitProblem& problem)
      : contact_(contact),
        problem_(problem),
        count_(static_cast<int>(problem.parameters.size())),
        slopes_(problem.points.size() * problem.parameters.size()),
        scatter_(problem.points.size(), 1.0) {
    // ends of the range of u
    for (int k = 0; k < count_; ++k) {
      low_[at(k)] = coordinate(k, problem.parameters[at(k)].low);
      high_[at(k)] = coordinate(k, problem.parameters[at(k)].high);
    }
  }

  CurveFit run() {
    // by the measured adhesion first, then twice by that of the law
    constexpr int fits = 3;
    Vector u{};
    double sum = 0.0;
    bool done = false;
    for (int round = 0; round < (problem_.relative ? fits : 1) && !fit_.fault.failed(); ++round) {
      if (problem_.relative) weigh(u, round == 0);
      sum = residuals(u, residual_);
      done = settle(u, sum);
    }
    if (fit_.fault.failed()) return std::move(fit_);
    if (!done) keep_worst(fit_.fault, Fault::iteration_cap("curve.max_iterations"));
    find_slopes(u);
    state(u, sum);
    return std::move(fit_);
  }

 private:
  /// Steps to the smallest sum; false where the cap came first.
  bool settle(Vector& u, double& sum) {
    double damping = 1e-3;
    bool done = false;
    for (; !done && fit_.iterations < problem_.max_iterations && !fit_.fault.failed(); ++fit_.iterations) {
      if (!problem_.progress.goes_on(static_cast<double>(fit_.iterations) / problem_.max_iterations)) {
        fit_.fault = Fault::cancelled();
        break;
      }
      find_slopes(u);
      done = !improve(u, sum, damping);
    }
    return done;
  }

  /// Scatter of the points in proportion to their adhesion, the measured one or that of the law.
  void weigh(const Vector& u, bool measured) {
    constexpr double least_share = 0.01;
    const contact::Friction law = law_at(u);
    double largest = 0.0;
    for (std::size_t i = 0; i < scatter_.size(); ++i) {
      const CurvePoint& point = problem_.points[i];
      scatter_[i] = measured ? point.adhesion : adhesion(law, point);
      largest = std::max(largest, scatter_[i]);
    }
    for (double& each : scatter_) each = std::max(each, least_share * largest);
  }

  static std::size_t at(int k) { return static_cast<std::size_t>(k); }
  double start(int k) const {
    contact::Friction law = problem_.start;
    return problem_.parameters[at(k)].of(law);
  }
  /// u of a value. Where only positive values exist, a value of 0 or less has a u far below all others.
  double coordinate(int k, double value) const {
    const FitParameter& p = problem_.parameters[at(k)];
    return p.positive ? natural_log(value / start(k)) : (value - start(k)) / p.unit;
  }
  double value(int k, double u) const {
    const FitParameter& p = problem_.parameters[at(k)];
    const double found = p.positive ? start(k) * natural_exp(u) : start(k) + p.unit * u;
    return std::clamp(found, p.low, p.high);
  }
  /// The law at u. Polach's k_S never passes his k_A, and no layer softens so fast that tractions would jump.
  contact::Friction law_at(const Vector& u) const {
    contact::Friction law = problem_.start;
    for (int k = 0; k < count_; ++k) problem_.parameters[at(k)].of(law) = value(k, u[at(k)]);
    law.reduction.slip = std::min(law.reduction.slip, law.reduction.adhesion);
    if (law.layer.flexibility > 0.0)
      law.layer.hardening = std::max(law.layer.hardening, -0.5 / law.layer.flexibility);
    return law;
  }

  /// Adhesion of a law at a point.
  double adhesion(const contact::Friction& law, const CurvePoint& point) {
    // Hertz: axes grow with the cube root of the load
    const double grown = natural_exp(natural_log(point.load / problem_.patch_load) / 3.0);
    const patch::Sdec& patch = problem_.patch;
    contact::take_double_ellipse(contact_, {grown * patch.a, grown * patch.b, patch.psi}, point.load);
    const Fault solved =
        contact::solve_tangential(contact_, {point.slip, 0.0, 0.0}, law, {.speed = point.speed});
    keep_worst(fit_.fault, solved);
    return -contact_.forces.fx / point.load;
  }

  /// Residuals over the points' scatter, and the sum of their squares.
  double residuals(const Vector& u, std::vector<double>& found) {
    const contact::Friction law = law_at(u);
    found.resize(problem_.points.size());
    double sum = 0.0;
    for (std::size_t i = 0; i < found.size(); ++i) {
      const CurvePoint& point = problem_.points[i];
      found[i] = (adhesion(law, point) - point.adhesion) / scatter_[i];
      sum += found[i] * found[i];
    }
    return sum;
  }

  /// Slopes of the residuals by u, within the range, and J^T J with columns of unit length.
  void find_slopes(const Vector& u) {
    for (int k = 0; k < count_; ++k) {
      Vector below = u, above = u;
      below[at(k)] = std::max(u[at(k)] - difference, low_[at(k)]);
      above[at(k)] = std::min(u[at(k)] + difference, high_[at(k)]);
      residuals(below, below_);
      residuals(above, above_);
      double square = 0.0;
      for (std::size_t i = 0; i < above_.size(); ++i) {
        double& slope = slopes_[i * at(count_) + at(k)];
        slope = (above_[i] - below_[i]) / (above[at(k)] - below[at(k)]);
        square += slope * slope;
      }
      length_[at(k)] = std::sqrt(square);
    }
    for (int i = 0; i < count_; ++i) {
      gradient_[at(i)] = column(i, [&](std::size_t point) { return residual_[point]; });
      for (int k = 0; k < count_; ++k)
        normal_[i][k] = i == k ? 1.0 : column(i, [&](std::size_t point) { return scaled(point, k); });
    }
  }
  double scaled(std::size_t point, int k) const {
    return length_[at(k)] > 0.0 ? slopes_[point * at(count_) + at(k)] / length_[at(k)] : 0.0;
  }
  template <class Other>
  double column(int k, const Other& other) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < problem_.points.size(); ++i) sum += scaled(i, k) * other(i);
    return sum;
  }

  /// The scaled matrix of some parameters, diagonal.
  Matrix diagonal(const std::vector<int>& of) const {
    Matrix m;
    m.n = static_cast<int>(of.size());
    for (int i = 0; i < m.n; ++i)
      for (int k = 0; k < m.n; ++k) m.a[i][k] = normal_[of[at(i)]][of[at(k)]];
    m.diagonalise();
    return m;
  }

  /// Parameters that have an effect and would not leave their range.
  std::vector<int> free(const Vector& u) const {
    std::vector<int> chosen;
    for (int k = 0; k < count_; ++k) {
      const bool leaves = (u[at(k)] <= low_[at(k)] && gradient_[at(k)] > 0.0) ||
                          (u[at(k)] >= high_[at(k)] && gradient_[at(k)] < 0.0);
      if (length_[at(k)] > 0.0 && !leaves && k != fixed_) chosen.push_back(k);
    }
    return chosen;
  }

  /// One step to a smaller sum; false where none is found, or the sum has settled.
  bool improve(Vector& u, double& sum, double& damping) {
    constexpr double most_damping = 1e10;
    const std::vector<int> chosen = free(u);
    if (chosen.empty()) return false;
    const Matrix m = diagonal(chosen);
    // powers of 4 times a number: exact steps
    for (; damping < most_damping; damping *= 4.0) {  // NOLINT(clang-analyzer-security.FloatLoopCounter)
      // (A + damping) step = -gradient, along the eigenvectors
      Vector tried = u;
      for (int i = 0; i < m.n; ++i) {
        double step = 0.0;
        for (int k = 0; k < m.n; ++k) {
          double along = 0.0;
          for (int j = 0; j < m.n; ++j) along += m.vectors[j][k] * gradient_[at(chosen[at(j)])];
          step -= m.vectors[i][k] * along / (std::max(m.a[k][k], 0.0) + damping);
        }
        const std::size_t p = at(chosen[at(i)]);
        tried[p] = std::clamp(u[p] + std::clamp(step / length_[p], -farthest, farthest), low_[p], high_[p]);
      }
      const double reached = residuals(tried, tried_);
      if (fit_.fault.failed()) return false;
      if (!(reached < sum)) continue;
      const double fall = sum - reached;
      u = tried;
      sum = reached;
      residual_.swap(tried_);
      damping = std::max(damping / 8.0, 1e-9);
      return fall > settled * sum;
    }
    return false;
  }

  /// Covariance of u over sigma^2, and the parameters that the curve does not determine.
  void spread(double (&covariance)[most_parameters][most_parameters], bool (&vague)[most_parameters]) const {
    std::vector<int> acting;
    for (int k = 0; k < count_; ++k) {
      vague[k] = !(length_[at(k)] > 0.0);
      if (!vague[k]) acting.push_back(k);
    }
    const Matrix m = diagonal(acting);
    for (int e = 0; e < m.n; ++e) {
      for (int i = 0; i < m.n; ++i) {
        const int row = acting[at(i)];
        if (m.a[e][e] <= singular) {
          vague[row] = vague[row] || std::abs(m.vectors[i][e]) > takes_part;
          continue;
        }
        for (int k = 0; k < m.n; ++k) {
          const int other = acting[at(k)];
          covariance[row][other] +=
              m.vectors[i][e] * m.vectors[k][e] / (m.a[e][e] * length_[at(row)] * length_[at(other)]);
        }
      }
    }
  }

  /// Values, deviations, intervals.
  void state(const Vector& u, double sum) {
    const double freedom = static_cast<double>(problem_.points.size()) - count_;
    const double variance = sum / freedom;
    double covariance[most_parameters][most_parameters] = {};
    bool vague[most_parameters] = {};
    spread(covariance, vague);
    fit_.scatter = std::sqrt(variance);
    fit_.law = law_at(u);
    Vector by_u{};  // d value / d u
    for (int k = 0; k < count_; ++k) {
      const FitParameter& p = problem_.parameters[at(k)];
      CurveFit::Of& of = fit_.of[at(k)];
      of.value = p.of(fit_.law);
      by_u[at(k)] = p.positive ? of.value : p.unit;
      const double deviation = std::sqrt(variance * covariance[k][k]);
      of.undetermined = vague[k] || !(deviation <= p.vague);
      vague[k] = of.undetermined;
      of.at_limit = u[at(k)] <= low_[at(k)] || u[at(k)] >= high_[at(k)];
      of.deviation = of.undetermined ? std::numeric_limits<double>::infinity() : by_u[at(k)] * deviation;
    }
    for (const CurvePoint& point : problem_.points) fit_.adhesion.push_back(adhesion(fit_.law, point));
    for (int i = 0; i < count_; ++i)
      for (int k = 0; k < count_; ++k)
        if (!vague[i] && !vague[k])
          fit_.covariance[i][k] = variance * covariance[i][k] * by_u[at(i)] * by_u[at(k)];
    // intervals by the profile of the sum of squares, searched from those of the linear problem on
    for (int k = 0; k < count_; ++k) {
      CurveFit::Of& of = fit_.of[at(k)];
      const double deviation = std::sqrt(variance * covariance[k][k]);
      of.low = problem_.parameters[at(k)].low;
      of.high = problem_.parameters[at(k)].high;
      if (of.undetermined || !(deviation > 0.0)) continue;
      const Profile profile{u, sum, variance, students_factor(freedom), deviation};
      of.low = value(k, end_of(profile, k, -1.0));
      of.high = value(k, end_of(profile, k, 1.0));
    }
  }

  /// The least sum of squares and its place, sigma^2, Student's factor, and the linear problem's deviation.
  struct Profile {
    const Vector& best;
    double sum, variance, factor, deviation;
  };

  /// End of the interval of parameter k on one side. There the least sum of squares with k held and all other
  /// parameters free has grown by sigma^2 times the square of Student's factor.
  double end_of(const Profile& profile, int k, double side) {
    constexpr int most = 12, most_steps = 20;
    constexpr double near = 1e-3;  // relative to the factor
    const double limit = side < 0.0 ? low_[at(k)] : high_[at(k)];
    const double range = side * (limit - profile.best[at(k)]);
    double reach = profile.factor * profile.deviation;
    // a trial begins within the interval: beyond it the other parameters may be where none leads back
    Vector inside = profile.best;
    fixed_ = k;
    for (int trial = 0; trial < most && reach < range; ++trial) {
      Vector u = inside;
      u[at(k)] = profile.best[at(k)] + side * reach;
      double sum = residuals(u, residual_), damping = 1e-3;
      for (int step = 0; step < most_steps; ++step) {
        find_slopes(u);
        if (!improve(u, sum, damping)) break;
      }
      // the root of the sum's growth is nearly in proportion to the distance
      const double found = std::sqrt(std::max(0.0, sum - profile.sum) / profile.variance);
      if (std::abs(found - profile.factor) < near * profile.factor) break;
      if (found < profile.factor) inside = u;
      reach *= std::clamp(profile.factor / std::max(found, 1e-3), 0.4, 2.5);
    }
    fixed_ = -1;
    return profile.best[at(k)] + side * std::min(reach, range);
  }

  contact::Contact& contact_;
  const CurveFitProblem& problem_;
  const int count_;
  Vector low_{}, high_{}, length_{}, gradient_{};
  int fixed_ = -1;  ///< parameter that is held; -1: none
  double normal_[most_parameters][most_parameters] = {};
  std::vector<double> slopes_, scatter_, residual_, below_, above_, tried_;
  CurveFit fit_;
};

}  // namespace

CurveFit fit_curve(contact::Contact& contact, const CurveFitProblem& problem) {
  return Fitter(contact, problem).run();
}

}  // namespace wrc::curves
