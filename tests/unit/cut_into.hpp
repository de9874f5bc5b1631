/// Arrays of the library in a test's own memory.
#pragma once

#include <cstddef>
#include <vector>

#include "base/arena.hpp"

namespace wrc {

/// The arrays that `cut(arena)` takes, zeros in `memory`.
template <class Cut>
auto cut_into(std::vector<double>& memory, const Cut& cut) {
  Arena count;
  cut(count);
  memory.assign(static_cast<std::size_t>(count.doubles()), 0.0);
  Arena arena(memory.data());
  return cut(arena);
}

}  // namespace wrc
