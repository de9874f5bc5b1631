#include "halfspace/section_curve.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "base/natural_spline.hpp"

namespace wrc::halfspace {

SectionCurve::SectionCurve(const std::vector<double>& y, const std::vector<double>& z, double least_spacing) {
  for (std::size_t k = 0; k < y.size(); ++k) {
    // arc length by chords; points nearer than the least spacing are left out
    const double dy = s_.empty() ? 0.0 : y[k] - y_.back(), dz = s_.empty() ? 0.0 : z[k] - z_.back();
    const double step = std::sqrt(dy * dy + dz * dz);
    if (!s_.empty() && step < least_spacing) continue;
    s_.push_back(s_.empty() ? 0.0 : s_.back() + step);
    y_.push_back(y[k]);
    z_.push_back(z[k]);
  }
  if (s_.empty()) return;
  // natural cubic splines y(s) and z(s)
  const auto n = static_cast<std::int32_t>(s_.size());
  std::vector<double> scratch(s_.size());
  for (std::vector<double>* second : {&y2_, &z2_}) second->assign(s_.size(), 0.0);
  second_derivatives(n, s_.data(), y_.data(), y2_.data(), scratch.data());
  second_derivatives(n, s_.data(), z_.data(), z2_.data(), scratch.data());
}

SectionCurve::Point SectionCurve::at(double s) const {
  const double inside = std::clamp(s, 0.0, length());
  const auto above = std::upper_bound(s_.begin() + 1, s_.end() - 1, inside);
  const auto k = static_cast<std::size_t>(above - s_.begin());
  const double h = s_[k] - s_[k - 1];
  // f = a f0 + b f1 + ((a^3 - a) f0'' + (b^3 - b) f1'') h^2 / 6 in the piece's own a = 1 - b
  const double a = (s_[k] - inside) / h, b = (inside - s_[k - 1]) / h;
  const auto value = [&](const std::vector<double>& f, const std::vector<double>& f2) {
    return a * f[k - 1] + b * f[k] + ((a * a * a - a) * f2[k - 1] + (b * b * b - b) * f2[k]) * h * h / 6.0;
  };
  const auto slope = [&](const std::vector<double>& f, const std::vector<double>& f2) {
    return (f[k] - f[k - 1]) / h + ((3.0 * b * b - 1.0) * f2[k] - (3.0 * a * a - 1.0) * f2[k - 1]) * h / 6.0;
  };
  // unit tangent; beyond the ends the curve goes on straight along it
  const double dy = slope(y_, y2_), dz = slope(z_, z2_), norm = std::sqrt(dy * dy + dz * dz);
  return {.y = value(y_, y2_) + (s - inside) * dy / norm,
          .z = value(z_, z2_) + (s - inside) * dz / norm,
          .dy = dy / norm,
          .dz = dz / norm};
}

}  // namespace wrc::halfspace
