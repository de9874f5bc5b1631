/// Results that several calls hand back.
#pragma once

#include "contact/assessments.hpp"
#include "wrc/wrc.h"

namespace wrc::abi {

/// A double ellipse with its load; `joint`: lateral place or arc length [m].
inline wrc_ellipse ellipse_of(const patch::Sdec& sdec, double joint, double normal_force) {
  return {
      .a = sdec.a, .b = sdec.b, .psi = sdec.psi, .y = joint, .normal_force = normal_force, .reserved = {}};
}

/// Wear and fatigue numbers; without tractions those of cells are missing.
wrc_damage damage_of(const contact::DamageNumbers& found, bool of_tractions);

/// A result with the flags of the call that made it.
template <typename Result>
Result with_flags(Result result, const Fault& outcome) {
  result.flags = outcome.all_flags();
  return result;
}

}  // namespace wrc::abi
