/// Memory of a strip from one step to the next (patch_memory.hpp), and its energy.
#pragma once

#include <cstddef>
#include <cstdint>

#include "kernels/kernels.hpp"
#include "tangential/simd/tasks.hpp"

namespace wrc::tangential {

using simd::RememberingStrip;

inline constexpr std::int32_t half_cells = memory_cells / 2;  ///< cells up to the middle of a strip

/// Memory of a strip, of the bodies rolling forwards.
struct PastStrip {
  double y;                    ///< place on the rail [m], or number of the rail's strip
  double centre, half_length;  ///< [m]
  /// Forces of its cells: Fx, Fy [N], and Mz about its own middle over the factor on arms [N m].
  double force[3];
  double added[3];  ///< its part of the difference to strip FASTSIM, Mz about the origin, on a rail its own
  double energy;    ///< it could give back [J]
  double slip[3];   ///< in the step, on a rail: creepages of its middle [-], spin [1/m]
  double way;       ///< rolled under these conditions over the contact's length, backwards below zero [-]
  double px[memory_cells], py[memory_cells];  ///< tractions of its cells, from the largest x on [Pa]
  double bound[half_cells];  ///< their bounds up to the middle; the others are symmetric [Pa]
};
static_assert(sizeof(PastStrip) == (14 + 2 * memory_cells + half_cells) * sizeof(double),
              "no padding: its bytes are saved");

/// The strips that a contact remembers, and those of the step that is being solved: behind it in memory.
struct Memory {
  std::int64_t capacity;  ///< strips
  std::int64_t present;   ///< the list of the two behind that is remembered; the other is being written
  std::int64_t count;     ///< strips of the list that is remembered
  std::int64_t written;   ///< strips of the other list

  /// Bytes of this with `lists` lists of so many strips behind it.
  static std::size_t bytes(std::int32_t strips, std::size_t lists) {
    return sizeof(Memory) + static_cast<std::size_t>(strips) * lists * sizeof(PastStrip);
  }

  PastStrip* list(std::int64_t which) { return reinterpret_cast<PastStrip*>(this + 1) + which * capacity; }
  PastStrip* remembered() { return list(present); }
  PastStrip* other() { return list(1 - present); }
  RememberingStrip* scratch() { return reinterpret_cast<RememberingStrip*>(list(3)); }

  /// The strips written are remembered from now on.
  void turn_over() {
    present = 1 - present;
    count = written;
  }
};

/// Gives a strip's cells that share of those in steady rolling.
void tend_to(const simd::TangentialKernels& kernels, const PastStrip& steady, double share, PastStrip& strip);
/// Energy stored in the tractions of a strip's cells [J].
double stored_in(const simd::TangentialKernels& kernels, const PastStrip& strip, double area, double growth_x,
                 double growth_y);
/// Energy stored in the half-spaces under these forces of a patch [J].
double stored_by(const double yield[3], const double force[3]);
/// A strip's cells, times `scale`.
void lower(double scale, PastStrip& strip);

/// Energy that can be given back after a step, and the rest of it.
struct EnergyLeft {
  double scale = 1.0;       ///< on all forces and tractions
  double left = 0.0;        ///< [J]
  double dissipated = 0.0;  ///< [J]
};

/// `before`: energy that could be given back before; `work` put in; `stored` in tractions as they are [J].
EnergyLeft count_energy(double before, double work, double stored);

/// A past strip as the bodies roll now: backwards it is the mirror image.
PastStrip turned(const PastStrip& strip, double direction);

}  // namespace wrc::tangential
