// The errors of contact that remembers with given factors over the sequences of files, as a library for
// fit.py.

#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>

#include "memory_case.hpp"
#include "rolling.hpp"
#include "tangential/methods/strip_memory.hpp"

namespace {

using namespace wrc;
using namespace wrc::calibration;

constexpr int strips = 24, cells = 24;
constexpr int factor_count = sizeof(tangential::MemoryFactors) / sizeof(double);

struct Loaded {
  MemoryCase exact;
  std::unique_ptr<Rolling> rolling;
};
std::vector<Loaded> loaded;
std::size_t steps = 0;

const OwnedGrid& grid() {
  static const OwnedGrid owned(cells);
  return owned;
}

/// Work that the wheel puts into the last steps, by forces at their ends [J].
template <class ForceAt>
double work_of_loop(const MemoryCase& c, ForceAt force_at) {
  double work = 0.0;
  for (std::size_t k = c.steps.size() - static_cast<std::size_t>(c.loop); k < c.steps.size(); ++k) {
    const tangential::TangentialForces before = force_at(k - 1), now = force_at(k);
    const MemoryStep& s = c.steps[k];
    work -= 0.5 * ((before.fx + now.fx) * s.x + (before.fy + now.fy) * s.y + (before.mz + now.mz) * s.turn);
  }
  return work;
}

/// Forces after each step of a case.
std::vector<tangential::TangentialForces> remembered(const Loaded& l,
                                                     const tangential::MemoryFactors& factors) {
  std::vector<double> memory(tangential::strip_memory_bytes(strips) / sizeof(double) + 1);
  tangential::make_strip_memory(strips, memory.data());
  tangential::RollingContact contact = l.rolling->contact;
  contact.memory.at = memory.data();
  std::vector<tangential::TangentialForces> forces;
  for (const MemoryStep& s : l.exact.steps) {
    // backwards as the mirror image that rolls forwards; at rest displacements are creepages over 1 mm
    const double direction = s.direction < 0 ? -1.0 : 1.0, length = s.direction == 0 ? 1e-3 : s.rolled;
    contact.memory.rolled = length;
    contact.memory.at_rest = s.direction == 0;
    contact.memory.direction = direction;
    contact.creepage = {direction * s.x / length, s.y / length, direction * s.turn / length};
    Fault fault;
    tangential::begin_step(memory.data());
    tangential::TangentialForces f = tangential::roll_with_memory(contact, {}, fault, factors);
    tangential::end_step(memory.data());
    f.fx *= direction;
    f.mz *= direction;
    forces.push_back(f);
  }
  return forces;
}

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
      loaded.push_back({std::move(c), nullptr});
      Loaded& l = loaded.back();
      l.rolling = std::make_unique<Rolling>(l.exact.patch, grid().grid, strips);
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
  for (const Loaded& l : loaded) {
    const MemoryCase& c = l.exact;
    const Patch& p = c.patch;
    const std::vector<tangential::TangentialForces> f = remembered(l, factors);
    double loop = 0.0;
    if (c.loop > 0) {
      const double exact = work_of_loop(c, [&](std::size_t k) {
        return tangential::TangentialForces{c.steps[k].fx, c.steps[k].fy, c.steps[k].mz, 0.0, 0.0};
      });
      loop = work_of_loop(c, [&](std::size_t k) { return f[k]; }) / exact - 1.0;
    }
    const double limit = p.friction * p.normal_force;
    for (std::size_t k = 0; k < f.size(); ++k) {
      *out++ = 0.0;
      *out++ = (f[k].fx - c.steps[k].fx) / limit;
      *out++ = (f[k].fy - c.steps[k].fy) / limit;
      *out++ = (f[k].mz - c.steps[k].mz) / (limit * std::sqrt(p.a * p.b));
      *out++ = k + static_cast<std::size_t>(c.loop) >= f.size() ? loop : 0.0;
    }
  }
}
