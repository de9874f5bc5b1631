/// Arrays cut from a block of memory, one behind the other.
#pragma once

#include <cstdint>

namespace wrc {

struct Cutter {
  double* at;  ///< where the next array begins

  double* operator()(std::int64_t doubles) {
    double* const here = at;
    at += doubles;
    return here;
  }
};

}  // namespace wrc
