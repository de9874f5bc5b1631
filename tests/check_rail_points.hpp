/// The outline of a check rail for tests: a flat top, a corner and a guiding face of 84 degrees, 45 mm deep;
/// of plain arithmetic, so that it has the same bits everywhere.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "test_config.hpp"
#include "wrc/wrc.h"

class CheckRailPoints {
 public:
  /// `far_side`: slope of the side that faces away from the wheel.
  explicit CheckRailPoints(double far_side = -1.0) {
    constexpr double step = 0.1e-3, face = 9.5;
    double height = 5e-3;
    for (int i = 0; i <= 355; ++i) {
      const double y = -30e-3 + step * i;
      y_.push_back(y);
      z_.push_back(height);
      const double middle = y + 0.5 * step;
      const double slope = middle < -25e-3   ? far_side
                           : middle < -20e-3 ? far_side * (-20e-3 - middle) / 5e-3
                           : middle < 0.0    ? 0.0
                           : middle < 1e-3   ? face * middle / 1e-3
                                             : face;
      height += step * slope;
    }
    const double top = z_[200];
    for (double& each : z_) each -= top;
  }
  wrc_profile profile() const {
    wrc_profile shown = sized<wrc_profile>();
    shown.kind = WRC_PROFILE_POINTS;
    shown.count = static_cast<std::uint32_t>(y_.size());
    shown.y = y_.data();
    shown.z = z_.data();
    return shown;
  }

 private:
  std::vector<double> y_, z_;
};
