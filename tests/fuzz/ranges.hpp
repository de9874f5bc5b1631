/// Numbers of a struct's members, drawn from the ranges the headers give them.
#pragma once

#include <algorithm>

#include "abi/generated/members.hpp"
#include "choices.hpp"

namespace hostile {

using wrc::abi::Member;

/// Anywhere in the range, evenly.
inline double anywhere(Choices& choices, const Member& of) { return choices.between(of.low, of.high); }

/// Every order of magnitude from `least` on alike, of both signs where the range has both.
inline double sized(Choices& choices, const Member& of, double least) {
  return of.low < 0.0 ? choices.signed_magnitude(least, of.high)
                      : choices.magnitude(std::max(least, of.low), of.high);
}
inline double sized(Choices& choices, const Member& of) { return sized(choices, of, of.low); }

}  // namespace hostile
