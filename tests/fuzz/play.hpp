/// One hostile case: a model, a handful of calls on one contact with hostile inputs, and what must hold
/// whatever they were.
#pragma once

#include <string>

#include "choices.hpp"

namespace hostile {

struct Verdict {
  std::string broken;         ///< the first property that did not hold, in words; empty when all held
  bool model_made = false;    ///< the library accepted the configuration
  int inputs = 0;             ///< hostile inputs handed to the library, the model's own among them
  int solved = 0;             ///< calls that ended with status >= 0 and forces
  double slowest_call = 0.0;  ///< of the processor's time [s]
};

struct Size {
  std::int32_t finest = 512;  ///< strips and cells, at most
  std::uint32_t calls = 5;    ///< hostile calls on the contact, at most
  /// For many inputs in little time: as many calls as allowed, few of the long ones (a wheel on a rail), and
  /// every field read after one call in eight only.
  bool shallow = false;
};

Verdict play(Choices& choices, const Size& size);

}  // namespace hostile
