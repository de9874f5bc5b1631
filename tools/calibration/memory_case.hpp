/// Patches that are displaced, rest and roll at random, and the forces of exact theory: the sequences that
/// the factors of contact that remembers (src/tangential/methods/patch_memory.hpp) are fitted to.
#pragma once

#include <string>
#include <vector>

#include "random_patch.hpp"

namespace wrc::calibration {

/// A step: rolled forwards (1), backwards (-1) or not at all (0), and the wheel's displacement over the rail.
struct MemoryStep {
  int direction;
  double rolled;      ///< amount [m]
  double x, y, turn;  ///< [m], [m], [rad]
  double fx, fy, mz;  ///< exact, at the end of the step [N], [N], [N m]
};

/// An ellipse and its steps from rest on. In a closed loop the last `loop` steps bring the wheel back to
/// where it was before them.
struct MemoryCase {
  Patch patch;
  std::vector<MemoryStep> steps;
  int loop = 0;
};

/// Case `row` of the endless list that belongs to `seed`. Ellipses with a/b 0.3 to 3. In turn: loops at rest
/// along a line, circles at rest, paths at rest, a shift that rolls off, waves of creepage of 1 to 12 a, and
/// rolling that stops and reverses.
MemoryCase random_memory_case(std::uint64_t seed, std::uint64_t row);

/// Adds the exact forces, on cells of a/8 and of a/16, extrapolated.
void solve_exactly(MemoryCase& c);

std::string patch_text(const MemoryCase& c);  ///< the first columns
std::string text_of(const MemoryCase& c);     ///< a line, without its end
std::vector<MemoryCase> read_memory_cases(const std::string& path);

inline constexpr const char* memory_heading = "a,b,poisson,shear_modulus,friction,normal_force,loop,steps";

}  // namespace wrc::calibration
