/// Which of enum wrc_prescribed a struct takes: a wheel the first two, a contact plane the others.
#pragma once

#include <cstdint>

#include "base/fault.hpp"
#include "wrc/wrc.h"

namespace wrc::abi {

/// `of`: the struct as the caller knows it; `plane`: is it that of a contact plane?
inline Fault check_prescribed(std::int32_t prescribed, const char* of, bool plane) {
  const bool of_plane = prescribed == WRC_PRESCRIBE_NORMAL_FORCE || prescribed == WRC_PRESCRIBE_APPROACH;
  if (of_plane == plane) return {};
  return {.status = WRC_ERROR_UNSUPPORTED,
          .of = of,
          .field = "prescribed",
          .value = static_cast<double>(prescribed),
          .unit = "",
          .cause = plane ? "WRC_PRESCRIBE_HEIGHT and _VERTICAL_LOAD are of a wheel: take "
                           "WRC_PRESCRIBE_NORMAL_FORCE (2) or WRC_PRESCRIBE_APPROACH (3)"
                         : "WRC_PRESCRIBE_NORMAL_FORCE and _APPROACH are of a contact plane: take "
                           "WRC_PRESCRIBE_HEIGHT (0) or WRC_PRESCRIBE_VERTICAL_LOAD (1)"};
}

}  // namespace wrc::abi
