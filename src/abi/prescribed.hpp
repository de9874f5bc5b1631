/// Which half of enum wrc_prescribed a struct takes.
#pragma once

#include "base/fault.hpp"
#include "wrc/wrc.h"

namespace wrc::abi {

/// `prescribed` of the struct `of` must be one of two values; `cause`: which, and whose the others are.
inline Fault check_prescribed(std::int32_t prescribed, std::int32_t one, std::int32_t other, const char* of,
                              const char* cause) {
  if (prescribed == one || prescribed == other) return {};
  return Fault::unsupported({of, "prescribed"}, {prescribed, ""}, cause);
}

/// A wheel prescribes its height or its vertical load.
inline Fault check_prescribed_of_wheel(std::int32_t prescribed, const char* of) {
  return check_prescribed(prescribed, WRC_PRESCRIBE_HEIGHT, WRC_PRESCRIBE_VERTICAL_LOAD, of,
                          "WRC_PRESCRIBE_NORMAL_FORCE and _APPROACH are of a contact plane: a wheel takes "
                          "WRC_PRESCRIBE_HEIGHT (0) or WRC_PRESCRIBE_VERTICAL_LOAD (1)");
}

/// A load of a contact plane prescribes its force or its approach.
inline Fault check_prescribed_of_plane(std::int32_t prescribed, const char* of) {
  return check_prescribed(prescribed, WRC_PRESCRIBE_NORMAL_FORCE, WRC_PRESCRIBE_APPROACH, of,
                          "WRC_PRESCRIBE_HEIGHT and _VERTICAL_LOAD are of a wheel: a contact plane takes "
                          "WRC_PRESCRIBE_NORMAL_FORCE (2) or WRC_PRESCRIBE_APPROACH (3)");
}

}  // namespace wrc::abi
