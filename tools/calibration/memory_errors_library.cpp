// The errors of contact that remembers with given factors over the sequences of files, as a library for
// fit.py.

#include <cstdio>
#include <cstring>
#include <string>

#include "memory_errors.hpp"

namespace {

using namespace wrc;
using namespace wrc::calibration;

constexpr int factor_count = sizeof(tangential::MemoryFactors) / sizeof(double);

std::vector<RememberedCase> loaded;
std::size_t steps = 0;

}  // namespace

#define EXPORTED extern "C" __attribute__((visibility("default")))

EXPORTED int calibration_quantities() { return 1; }
EXPORTED int calibration_terms() { return factor_count; }
EXPORTED int calibration_allowed(int, int) { return 1; }
EXPORTED void calibration_fitted(double* constants) {
  std::memcpy(constants, &tangential::fitted_memory, sizeof tangential::fitted_memory);
}

/// Adds the cases of a file; returns how many steps there are now, -1 where it cannot be read.
EXPORTED int calibration_load(const char* path) {
  try {
    for (MemoryCase& c : read_memory_cases(path)) {
      steps += c.steps.size();
      loaded.emplace_back(std::move(c));
    }
  } catch (const std::string& reason) {
    std::fprintf(stderr, "%s\n", reason.c_str());
    return -1;
  }
  return static_cast<int>(steps);
}

/// Per step: zero for the adhesion, errors of Fx, Fy (over mu N), of Mz (over mu N c), and in closed loops
/// that of the loop's work (relative).
EXPORTED void calibration_errors(const double* constants, double* out) {
  tangential::MemoryFactors factors;
  std::memcpy(&factors, constants, sizeof factors);
  for (const RememberedCase& c : loaded) {
    double loop = 0.0;
    const std::vector<MemoryError> errors = c.errors(factors, loop);
    for (std::size_t k = 0; k < errors.size(); ++k) {
      *out++ = 0.0;
      *out++ = errors[k].x;
      *out++ = errors[k].y;
      *out++ = errors[k].turn;
      *out++ = k + static_cast<std::size_t>(c.exact().loop) >= errors.size() ? loop : 0.0;
    }
  }
}
