/// The largest value of a function of one number between two.
#pragma once

namespace wrc {

/// Narrows `low` and `high` around the largest value of a function that rises to it and falls behind it, by
/// golden sections: `steps` of them, with one evaluation each and two before. Ends early where `goes_on()`
/// says no after one.
template <class Value, class GoesOn>
bool narrow_to_largest(double& low, double& high, int steps, const Value& value_at, const GoesOn& goes_on) {
  constexpr double golden = 0.6180339887498949;
  double left = high - golden * (high - low), right = low + golden * (high - low);
  double at_left = value_at(left), at_right = value_at(right);
  for (int n = 0; n < steps; ++n) {
    if (at_left >= at_right) {
      high = right;
      right = left;
      at_right = at_left;
      left = high - golden * (high - low);
      at_left = value_at(left);
    } else {
      low = left;
      left = right;
      at_left = at_right;
      right = low + golden * (high - low);
      at_right = value_at(right);
    }
    if (!goes_on()) return false;
  }
  return true;
}

template <class Value>
void narrow_to_largest(double& low, double& high, int steps, const Value& value_at) {
  narrow_to_largest(low, high, steps, value_at, [] { return true; });
}

}  // namespace wrc
