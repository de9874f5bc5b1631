/// Coefficients of friction of the strips in contact, by the law of the model.
#pragma once

#include "surface/wrench/wheel_solution.hpp"

namespace wrc::surface {

/// Friction and layer of a strip at rest, as means over its width on the profile with zones or films: the
/// coefficient, the films' layer, and derivatives by the strip's place on the wheel's profile [1/m].
struct FrictionAtRest {
  double value, by_wheel_y;
  tangential::Layer layer{}, layer_by_wheel_y{};
};

/// Does a strip's friction at rest change with its place on the wheel?
inline bool moves_with_wheel(const WheelOnRail& in) {
  return in.zones_on_wheel || (in.films != nullptr && in.films->wheel.count > 1.0);
}
FrictionAtRest friction_at_rest(const WheelProblem& problem, const Overlaps& overlaps, std::int32_t i);

/// The law's factor of the sliding speed of the k-th strip in contact: the root mean square of its rigid slip
/// times `speed`, the divisor of slips [m/s] (tangential/friction/friction.hpp).
double strip_speed_factor(const tangential::FrictionLaw& law, const ContactArrays& strips, std::int32_t k,
                          double speed);

/// Fills the layers of cold strips, and their coefficients, means over their widths at their sliding speeds.
void set_cold_friction(const WheelProblem& problem, const Overlaps& overlaps, double speed,
                       const ContactStrips& strips);

}  // namespace wrc::surface
