/// Search of the height at which a wheel carries a load, for the strips of the rail (given_load.hpp) and for
/// the exact solution (halfspace/surface_contact.hpp).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/elementary.hpp"
#include "base/number.hpp"

namespace wrc::surface {

/// Load to the power 2/3: in Hertz's contact in proportion to the approach [N^(2/3)].
inline double straightened(double load) {
  return load > 0.0 ? natural_exp(natural_log(load) * (2.0 / 3.0)) : 0.0;
}

/// Search of the height for a load: by secants of the load's power 2/3, which is nearly straight, between a
/// height that carries too little and one that carries too much where both are known.
class HeightSearch {
 public:
  explicit HeightSearch(double load) : load_(load), target_(straightened(load)) {}

  /// Notes that `height` carries `load`; `doubt`: error of `load` relative to the load asked for.
  void take(double height, double load, double doubt) {
    const Place earlier = last_;
    last_ = {height, straightened(load) - target_, doubt};
    if (magnitude(load - load_) > beyond_doubt * doubt * load_) (last_.value < 0.0 ? low_ : high_) = last_;
    if (!earlier.known() || height == earlier.height) return;
    // a slope from two loads counts where their difference stands out of their errors
    const double risen = last_.value - earlier.value, known_to = (doubt + earlier.doubt) * target_;
    const double secant = risen / (height - earlier.height);
    if (magnitude(risen) > known_to && secant > 0.0) slope_ = secant;
    if (magnitude(risen) > 10.0 * known_to) firm_slope_ = slope_;
    slow_ = magnitude(last_.value) > 0.5 * magnitude(earlier.value) ? slow_ + 1 : 0;
  }

  /// Forgets all heights, but not the slope of the load over them: for loads that have changed, with friction
  /// added.
  void forget_heights() {
    low_ = high_ = last_ = Place{};
    slow_ = 0;
  }

  /// The last slope that is known to a tenth, as a part of that by a stiffness [N/m]; 0: none is known.
  double part_of(double stiffness) const {
    return stiffness > 0.0 ? firm_slope_ * (1.5 * root(target_)) / stiffness : 0.0;
  }

  /// The heights of too little and too much load coincide.
  bool exhausted() const {
    return low_.known() && high_.known() && std::abs(high_.height - low_.height) < 1e-16;
  }

  /// The height after the last one, in the search's step `step`, counted from 0. `stiffness`: estimated
  /// growth of the load with the height, read before there are two loads [N/m]; 0: not known.
  double next(std::int32_t step, double stiffness) const {
    // secant, or f' = 2/3 F^(-1/3) dF/dh; at most `far`, which doubles from step to step
    const double slope = slope_ > 0.0 ? slope_ : stiffness / (1.5 * root(target_));
    const double far = 60e-6 * static_cast<double>(1 << std::min(step, 10));
    const double asked_for = slope > 0.0 ? -last_.value / slope : last_.value < 0.0 ? far : -far;
    const double height = last_.height + smaller(larger(asked_for, -far), far);
    if (!(low_.known() && high_.known())) return height;
    // between both: halving where the secant leaves the interval or brings little
    const double low = smaller(low_.height, high_.height), high = larger(low_.height, high_.height);
    const bool slow = slow_ > 1 && magnitude(last_.value) > worth_halving * target_;
    return slow || !(height > low && height < high) ? 0.5 * (low + high) : height;
  }

 private:
  /// Errors of loads from another height's solution reach 1.4 times the doubt: a height is on a side for sure
  /// beyond so many times that.
  static constexpr double beyond_doubt = 4.0;
  static constexpr double worth_halving =
      1e-5;  ///< part of the straightened load: slower than that is rounding

  struct Place {
    double height = 0.0, value = 0.0;  ///< [m], of the straightened load less the target
    double doubt = -1.0;
    bool known() const { return doubt >= 0.0; }
  };

  double load_, target_;                   ///< asked for [N], and straightened
  double slope_ = 0.0, firm_slope_ = 0.0;  ///< derivative of the straightened load by the height
  Place low_, high_;                       ///< too little and too much beyond doubt
  Place last_;
  std::int32_t slow_ = 0;  ///< steps in a row that brought little
};

}  // namespace wrc::surface
