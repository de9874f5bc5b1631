/// Members by name: rows of tables that have one, and friction.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <iterator>

#include "base/fault.hpp"
#include "wrc/wrc.h"

namespace wrc::abi {

/// The row of a name; the end of the table where there is none.
template <typename Row, std::size_t rows>
const Row* row_of(const Row (&table)[rows], const char* name) {
  return std::find_if(std::begin(table), std::end(table),
                      [&](const Row& each) { return std::strcmp(each.name, name) == 0; });
}

/// Sets a friction's law and layer by its name in WRC_FRICTION_LIST. WRC_ERROR_UNSUPPORTED: there is none.
Fault use_friction(wrc_friction* friction, const char* name);

}  // namespace wrc::abi
