/// Errors of contact that remembers over a sequence that is solved exactly.
#pragma once

#include <memory>
#include <vector>

#include "memory_case.hpp"
#include "rolling.hpp"
#include "tangential/methods/strip_memory.hpp"

namespace wrc::calibration {

/// At the end of a step: of the force over mu N, of the moment over mu N sqrt(ab), N of the step.
struct MemoryError {
  double x, y, turn;
};

/// A sequence and its patch under each load, ready for strips that remember.
class RememberedCase {
 public:
  explicit RememberedCase(MemoryCase exact);

  const MemoryCase& exact() const { return exact_; }

  /// Errors after each step. `loop`: of the work in the closed loop, relative; 0 without one.
  std::vector<MemoryError> errors(const tangential::MemoryFactors& factors, double& loop) const;

 private:
  MemoryCase exact_;
  std::vector<std::unique_ptr<Rolling>> under_;  // one for each change of load
  std::vector<std::size_t> which_;               // of those, for each step
};

}  // namespace wrc::calibration
