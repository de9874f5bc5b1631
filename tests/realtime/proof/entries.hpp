/// Every real-time function of the C interface as one call on a wheel, for what must hold of each of them.
#pragma once

#include <vector>

#include "proof/wheel.hpp"

struct Entry {
  const char* name;
  int32_t (*call)(Wheel&);  ///< a failure is not as it should be
};

/// In an order in which each finds what it needs in the contact.
const std::vector<Entry>& all_entries();
