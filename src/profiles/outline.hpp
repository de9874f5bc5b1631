/// Outlines of rails as instruments measure them: points from the gauge side to the field side. Offline: it
/// allocates.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "base/elementary.hpp"
#include "base/sentence.hpp"

namespace wrc::profiles {

/// y to the field side, z down [m].
struct Outline {
  std::vector<double> y, z;

  std::size_t size() const { return y.size(); }
  double width() const { return y.back() - y.front(); }
  double top() const { return *std::min_element(z.begin(), z.end()); }
  void add(double at_y, double at_z) {
    y.push_back(at_y);
    z.push_back(at_z);
  }
};

/// Linear between the points of a table whose x increases; constant beyond its ends.
inline double linear_between(const std::vector<double>& x, const std::vector<double>& f, double at) {
  if (at <= x.front()) return f.front();
  if (at >= x.back()) return f.back();
  const std::size_t j = static_cast<std::size_t>(std::upper_bound(x.begin(), x.end(), at) - x.begin()) - 1;
  return f[j] + (f[j + 1] - f[j]) / (x[j + 1] - x[j]) * (at - x[j]);
}

/// Length along the outline at each of its points [m].
inline std::vector<double> arc_lengths(const Outline& line) {
  std::vector<double> s(line.size(), 0.0);
  for (std::size_t i = 1; i < s.size(); ++i) {
    const double dy = line.y[i] - line.y[i - 1], dz = line.z[i] - line.z[i - 1];
    s[i] = s[i - 1] + std::sqrt(dy * dy + dz * dz);
  }
  return s;
}

/// Inclination of the chord between two places of the outline, by length [rad].
inline double chord_angle(const Outline& line, const std::vector<double>& s, double from, double to) {
  const double low = std::clamp(from, 0.0, s.back()), high = std::clamp(to, 0.0, s.back());
  const double dy = linear_between(s, line.y, high) - linear_between(s, line.y, low),
               dz = linear_between(s, line.z, high) - linear_between(s, line.z, low);
  return dy == 0.0 && dz == 0.0 ? 0.0 : arctangent2(dz, dy);
}

/// A sentence of texts and numbers.
template <class... Parts>
std::string sentence(const Parts&... parts) {
  char text[512];
  Sentence out(text, sizeof text);
  (out.add(parts), ...);
  return text;
}

/// A length in millimetres, to a hundredth, for sentences.
inline double in_mm(double metres) { return std::floor(1e5 * metres + 0.5) / 100.0; }

/// A measured section as sentences name it: number, counted from 1, and distance along the track [m].
inline std::string section_at(std::size_t number, double distance) {
  return sentence("section ", static_cast<std::int32_t>(number + 1), " at ", distance, " m");
}

}  // namespace wrc::profiles
