/// Search of the height at which a wheel carries a load, for the strips of the rail (given_load.hpp) and for
/// the exact solution (halfspace/surface_contact.hpp).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/elementary.hpp"
#include "base/number.hpp"

namespace wrc {

/// F^(2/3): of Hertz's contact in proportion to the approach [N^(2/3)].
inline double straightened(double load) {
  return load > 0.0 ? natural_exp(natural_log(load) * (2.0 / 3.0)) : 0.0;
}

/// Search of the height for a load: by secants of the load's power 2/3, which is nearly straight, between a
/// height that carries too little and one that carries too much where both are known.
class HeightSearch {
 public:
  explicit HeightSearch(double load) : load_(load), target_(straightened(load)) {}

  /// Notes that `height` carries `load`, which is known to the part `doubt` of the one asked for.
  void take(double height, double load, double doubt) {
    const Place earlier = last_;
    last_ = {height, straightened(load) - target_, doubt};
    // beyond doubt too little or too much: an end of the bracket
    if (magnitude(load - load_) > doubt * load_) (last_.value < 0.0 ? low_ : high_) = last_;
    if (!earlier.known() || height == earlier.height) return;
    // the slope, unless the rise is within the doubts or the load fell on the way down
    const double risen = last_.value - earlier.value, known_to = (doubt + earlier.doubt) * target_;
    const double secant = risen / (height - earlier.height);
    if (magnitude(risen) > known_to && secant > 0.0) slope_ = secant;
    slow_ = magnitude(last_.value) > 0.5 * magnitude(earlier.value) ? slow_ + 1 : 0;
  }

  /// Forgets all heights, but not the slope of the load over them: for loads that have changed, with friction
  /// added.
  void forget_heights() {
    low_ = high_ = last_ = Place{};
    slow_ = 0;
  }

  /// Nothing is left between the heights.
  bool exhausted() const {
    return low_.known() && high_.known() && std::abs(high_.height - low_.height) < 1e-16;
  }

  /// Where to look after the last height, in the search's step `step`, counted from 0. `stiffness`: about how
  /// fast the load grows with the height, read where that was not seen yet [N/m]; 0: not known.
  double next(std::int32_t step, double stiffness) const {
    // d(F^(2/3))/dz = 2/3 F^(-1/3) dF/dz, and F^(1/3) is the root of the straightened load
    const double slope = slope_ > 0.0 ? slope_ : stiffness / (1.5 * root(target_));
    // no further than a step that doubles: beyond first touch the load says nothing
    const double far = 60e-6 * static_cast<double>(1 << std::min(step, 10));
    const double asked_for = slope > 0.0 ? -last_.value / slope : last_.value < 0.0 ? far : -far;
    const double height = last_.height + smaller(larger(asked_for, -far), far);
    if (!(low_.known() && high_.known())) return height;
    // between the ends of the bracket; by halves where secants leave it or no longer shrink the error
    const double low = smaller(low_.height, high_.height), high = larger(low_.height, high_.height);
    const bool slow = slow_ > 1 && magnitude(last_.value) > worth_halving * target_;
    return slow || !(height > low && height < high) ? 0.5 * (low + high) : height;
  }

 private:
  static constexpr double worth_halving =
      1e-5;  ///< relative error of the straightened load below which it is rounding

  struct Place {
    double height = 0.0, value = 0.0;  ///< [m], of the straightened load less the target
    double doubt = -1.0;
    bool known() const { return doubt >= 0.0; }
  };

  double load_, target_;
  double slope_ = 0.0;  ///< straightened load over height [N^(2/3)/m]
  Place low_, high_;    ///< too little and too much beyond doubt
  Place last_;
  std::int32_t slow_ = 0;  ///< steps in a row that brought little
};

}  // namespace wrc
