#include "geometry/smoothing.hpp"

#include <algorithm>
#include <cmath>

#include "base/elementary.hpp"

namespace wrc::geometry {
namespace {

/// The smoothing of one coordinate over fixed positions s: its equations, factored.
///
/// Second derivatives c of the curve at the inner points: (R + lambda Q' W^-1 Q) c = Q' g, where Q' takes
/// second differences, R is the mass matrix of hat functions and W the lengths the points stand for. Factors
/// L D L' of the five bands; the curve is g - lambda W^-1 Q c.
class Smoother {
 public:
  /// `bands`: 3 * count doubles.
  Smoother(std::int32_t count, const double* s, double lambda, double* bands)
      : count_(count),
        s_(s),
        lambda_(lambda),
        diagonal_(bands),
        first_(bands + count),
        second_(bands + 2 * count) {
    for (std::int32_t i = 1; i + 1 < count; ++i) {
      const double before = spacing(i - 1), after = spacing(i);
      double d = (before + after) / 3.0 +
                 lambda * (1.0 / (before * before * weight(i - 1)) + middle(i) * middle(i) / weight(i) +
                           1.0 / (after * after * weight(i + 1)));
      double e = i + 2 < count ? after / 6.0 + lambda * (middle(i) / (after * weight(i)) +
                                                         middle(i + 1) / (after * weight(i + 1)))
                               : 0.0;
      const double f = i + 3 < count ? lambda / (after * spacing(i + 1) * weight(i + 1)) : 0.0;
      if (i > 1) {
        d -= first_[i - 1] * first_[i - 1] * diagonal_[i - 1];
        e -= first_[i - 1] * second_[i - 1] * diagonal_[i - 1];
      }
      if (i > 2) d -= second_[i - 2] * second_[i - 2] * diagonal_[i - 2];
      diagonal_[i] = d;
      first_[i] = e / d;
      second_[i] = f / d;
    }
  }

  /// `c`: count doubles of scratch.
  void apply(const double* given, double* c, double* smoothed) const {
    c[0] = c[count_ - 1] = 0.0;
    for (std::int32_t i = 1; i + 1 < count_; ++i) {
      c[i] = (given[i + 1] - given[i]) / spacing(i) - (given[i] - given[i - 1]) / spacing(i - 1);
      if (i > 1) c[i] -= first_[i - 1] * c[i - 1];
      if (i > 2) c[i] -= second_[i - 2] * c[i - 2];
    }
    for (std::int32_t i = 1; i + 1 < count_; ++i) c[i] /= diagonal_[i];
    for (std::int32_t i = count_ - 2; i >= 1; --i) {
      if (i + 2 < count_) c[i] -= first_[i] * c[i + 1];
      if (i + 3 < count_) c[i] -= second_[i] * c[i + 2];
    }
    for (std::int32_t i = 0; i < count_; ++i) {
      double bend = 0.0;  // row i of Q c
      if (i > 0 && i + 1 < count_) bend += middle(i) * c[i];
      if (i > 0) bend += c[i - 1] / spacing(i - 1);
      if (i + 1 < count_) bend += c[i + 1] / spacing(i);
      smoothed[i] = given[i] - lambda_ * bend / weight(i);
    }
  }

 private:
  double spacing(std::int32_t i) const { return s_[i + 1] - s_[i]; }
  /// The length point i stands for.
  double weight(std::int32_t i) const {
    return 0.5 * ((i > 0 ? spacing(i - 1) : 0.0) + (i + 1 < count_ ? spacing(i) : 0.0));
  }
  /// Row i of Q on the diagonal.
  double middle(std::int32_t i) const { return -1.0 / spacing(i - 1) - 1.0 / spacing(i); }

  std::int32_t count_;
  const double* s_;
  double lambda_;
  double *diagonal_, *first_, *second_;
};

}  // namespace

SmoothedPoints smooth_points(std::int32_t count, const double* y, const double* z, double wavelength,
                             double* scratch) {
  const double length = wavelength / (2.0 * pi);
  const double lambda = length * length * length * length;
  double* const s = scratch;
  double* const bands = scratch + count;
  double* const c = scratch + 4 * count;
  double* const smooth_y = scratch + 5 * count;
  double* const smooth_z = scratch + 6 * count;

  // Chords between noisy points are too long, the more the denser the points: the second time they are taken
  // along the smoothed curve.
  const double *along_y = y, *along_z = z;
  for (int round = 0; round < 2; ++round) {
    s[0] = 0.0;
    for (std::int32_t i = 1; i < count; ++i) {
      const double dy = along_y[i] - along_y[i - 1], dz = along_z[i] - along_z[i - 1];
      s[i] = s[i - 1] + std::sqrt(dy * dy + dz * dz);
    }
    const Smoother smoother(count, s, lambda, bands);
    smoother.apply(y, c, smooth_y);
    smoother.apply(z, c, smooth_z);
    along_y = smooth_y;
    along_z = smooth_z;
  }

  SmoothedPoints result{smooth_y, smooth_z, 0.0};
  for (std::int32_t i = 0; i < count; ++i) {
    const std::int32_t left = std::max(i - 1, 0), right = std::min(i + 1, count - 1);
    const double ty = smooth_y[right] - smooth_y[left], tz = smooth_z[right] - smooth_z[left];
    const double across = (z[i] - smooth_z[i]) * ty - (y[i] - smooth_y[i]) * tz;
    result.deviation = std::max(result.deviation, std::abs(across) / std::sqrt(ty * ty + tz * tz));
  }
  return result;
}

}  // namespace wrc::geometry
