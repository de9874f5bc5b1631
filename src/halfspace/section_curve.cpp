#include "halfspace/section_curve.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace wrc::halfspace {
namespace {

// Second derivatives of the natural cubic spline through (s, f): Thomas's elimination.
std::vector<double> second_derivatives(const std::vector<double>& s, const std::vector<double>& f) {
  const std::size_t n = s.size();
  std::vector<double> m(n, 0.0), above(n, 0.0);
  for (std::size_t k = 1; k + 1 < n; ++k) {
    const double before = s[k] - s[k - 1], after = s[k + 1] - s[k];
    const double right = 6.0 * ((f[k + 1] - f[k]) / after - (f[k] - f[k - 1]) / before);
    const double pivot = 2.0 * (before + after) - before * above[k - 1];
    above[k] = after / pivot;
    m[k] = (right - before * m[k - 1]) / pivot;
  }
  for (std::size_t k = n - 1; k-- > 1;) m[k] -= above[k] * m[k + 1];
  return m;
}

}  // namespace

SectionCurve::SectionCurve(const std::vector<double>& y, const std::vector<double>& z, double least_spacing) {
  for (std::size_t k = 0; k < y.size(); ++k) {
    const double dy = s_.empty() ? 0.0 : y[k] - y_.back(), dz = s_.empty() ? 0.0 : z[k] - z_.back();
    const double step = std::sqrt(dy * dy + dz * dz);
    if (!s_.empty() && step < least_spacing) continue;
    s_.push_back(s_.empty() ? 0.0 : s_.back() + step);
    y_.push_back(y[k]);
    z_.push_back(z[k]);
  }
  y2_ = second_derivatives(s_, y_);
  z2_ = second_derivatives(s_, z_);
}

SectionCurve::Point SectionCurve::at(double s) const {
  const double inside = std::clamp(s, 0.0, length());
  const auto above = std::upper_bound(s_.begin() + 1, s_.end() - 1, inside);
  const auto k = static_cast<std::size_t>(above - s_.begin());
  const double h = s_[k] - s_[k - 1];
  const double a = (s_[k] - inside) / h, b = (inside - s_[k - 1]) / h;
  const auto value = [&](const std::vector<double>& f, const std::vector<double>& f2) {
    return a * f[k - 1] + b * f[k] + ((a * a * a - a) * f2[k - 1] + (b * b * b - b) * f2[k]) * h * h / 6.0;
  };
  const auto slope = [&](const std::vector<double>& f, const std::vector<double>& f2) {
    return (f[k] - f[k - 1]) / h + ((3.0 * b * b - 1.0) * f2[k] - (3.0 * a * a - 1.0) * f2[k - 1]) * h / 6.0;
  };
  const double dy = slope(y_, y2_), dz = slope(z_, z2_), norm = std::sqrt(dy * dy + dz * dz);
  return {.y = value(y_, y2_) + (s - inside) * dy / norm,
          .z = value(z_, z2_) + (s - inside) * dz / norm,
          .dy = dy / norm,
          .dz = dz / norm};
}

}  // namespace wrc::halfspace
