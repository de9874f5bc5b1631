/// The radius of a wheel that is not round, as far as a rail that is level along the track can touch it.
///
/// The real-time side knows of the deviation d(theta) how deep it reaches, the largest of parabolas D(tau) =
/// max of d(theta) - r (theta - tau)^2 / 2 (surface/geometry/out_of_round.hpp). The least surface that
/// reaches so is
///
///     d*(theta) = min over tau of  D(tau) + r (theta - tau)^2 / 2,
///
/// d itself wherever the rail can touch it, and a chord over hollows. D + r tau^2 / 2 is convex, so that tau
/// lies where its slope is r theta; d*' = r (theta - tau).
#pragma once

#include <vector>

#include "surface/geometry/out_of_round.hpp"

namespace wrc::halfspace {

class WheelDeviation {
 public:
  /// The deviation of a wheel turned by `angle` about its axle [rad]; tabulated as far as contacts lie from
  /// below the axle.
  WheelDeviation(const surface::OutOfRound& wheel, double angle);

  /// Deviation of the radius [m], and its slope over the angle [m/rad].
  using Value = surface::Reach<double>;
  /// At y on the wheel's profile [m] and so far forwards from below the axle [rad].
  Value at(double y, double place) const;

 private:
  Value row_at(int row, double place) const;

  const surface::OutOfRound& wheel_;
  std::vector<Value> nodes_;  // row by row
};

}  // namespace wrc::halfspace
