/// Patches that are displaced, rest and roll at random, and the forces of exact theory: the sequences that
/// the factors of contact that remembers (src/tangential/methods/patch_memory.hpp) are fitted to.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "random_patch.hpp"

namespace wrc::calibration {

/// A step: rolled forwards (1), backwards (-1) or not at all (0), and the wheel's displacement over the rail.
struct MemoryStep {
  int direction;
  double rolled;      ///< amount [m]
  double x, y, turn;  ///< [m], [m], [rad]
  double load;        ///< at the end of the step, even within [N]
  double fx, fy, mz;  ///< exact, at the end of the step [N], [N], [N m]
};

/// An ellipse and its steps from rest on. In a closed loop the last `loop` steps bring the wheel back to
/// where it was before them.
struct MemoryCase {
  Patch patch;
  std::vector<MemoryStep> steps;
  int loop = 0;

  bool load_varies() const {
    return std::any_of(steps.begin(), steps.end(),
                       [&](const MemoryStep& s) { return s.load != patch.normal_force; });
  }
};

/// Case `row` of the endless list that belongs to `seed`. Ellipses with a/b 0.3 to 3. One of four is at rest,
/// in turn: loops along a line, circles, paths, loads that vary by 30 %. The others roll: off after a shift,
/// with waves of creepage of 1 to 12 a, with stops and reversals, under loads that vary.
MemoryCase random_memory_case(std::uint64_t seed, std::uint64_t row);
const char* memory_kind(std::uint64_t row);  ///< the name of its kind

/// Loops of spin alone at rest, of 0.4 to 2.1 times the unit of spin, 9 pi / 128 mu N / (G a b).
MemoryCase random_spin_at_rest(std::uint64_t seed, std::uint64_t row);

/// A patch under another load (Hertz).
Patch under_load(Patch patch, double load);

/// Adds the exact forces, on cells of a/8 and a/16, extrapolated. At rest the error is of second order in the
/// cell, by the staircase of the border; from the first step that rolls on it is of first order.
void solve_exactly(MemoryCase& c);

std::string patch_text(const MemoryCase& c);  ///< the first columns
std::string text_of(const MemoryCase& c);     ///< a line, without its end
std::vector<MemoryCase> read_memory_cases(const std::string& path);

inline constexpr const char* memory_heading = "a,b,poisson,shear_modulus,friction,normal_force,loop,steps";

}  // namespace wrc::calibration
