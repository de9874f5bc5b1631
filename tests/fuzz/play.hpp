/// One hostile case: a model, a handful of calls on one contact with hostile inputs, and what must hold
/// whatever they were.
#pragma once

#include <string>

#include "choices.hpp"

namespace hostile {

struct Verdict {
  std::string broken;       ///< the first property that did not hold, in words; empty when all held
  bool model_made = false;  ///< the library accepted the configuration
  int calls = 0,
      solved = 0;  ///< calls on the contact, and how many of them ended with status >= 0 and forces
  double slowest_call = 0.0;  ///< [s]
};

/// Grids are at most `finest` by `finest` cells; at most `most_calls` hostile calls on the contact.
Verdict play(Choices& choices, std::int32_t finest, std::uint32_t most_calls = 5);

}  // namespace hostile
