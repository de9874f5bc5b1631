/// A patch with memory whose half-spaces yield as a whole (patch_memory.hpp): one of a plane, or a part of a
/// rail's strips between valleys of their load. Strips may be of several such patches, by shares.
#pragma once

#include "tangential/methods/past_strip.hpp"
#include "tangential/methods/patch_numbers.hpp"
#include "tangential/rolling_contact.hpp"

namespace wrc::tangential {

/// Forces are Fx, Fy [N] and the moment about the patch's centre, with the factor on arms [N m].
/// Displacements are those of the centre [m] and a rotation [rad].
struct YieldingPatch {
  PatchNumbers numbers;
  double share = 1.0;  ///< part of its yield in that of its strips: those of a strip's patches add up to 1
  std::int32_t first = 0, end = 0;               ///< its strips
  double inside_first = 1.0, inside_last = 1.0;  ///< share of the width of the first and of the last within
  std::int32_t first_lobe = 0, end_lobe = 1;     ///< it is as many parts between valleys
  double before[3] = {}, left[3] = {};           ///< forces before, and of strips that leave in the step
  double yield[3] = {};                          ///< S in the part of the step that is solved
  double shift[3] = {}, local[3] = {}, rest[3] = {};  ///< U = local - shift; by how much it is not S (F - F')

  /// Share of a strip's width within the patch; j is one of its strips.
  double inside(std::int32_t j) const {
    if (j > first) return j == end - 1 ? inside_last : 1.0;
    return first == end - 1 ? inside_first + inside_last - 1.0 : inside_first;
  }
  /// Force of a strip's cells, `of`, whose moment is about the place x, y: adds `part` of it to `to`.
  void add_force(double part, const double of[3], double x, double y, double to[3]) const {
    const double fx = part * of[0], fy = part * of[1];
    to[0] += fx;
    to[1] += fy;
    to[2] += numbers.arm * (part * of[2] + (x - numbers.centre_x) * fy - (y - numbers.centre_y) * fx);
  }
};

/// A strip without bounds and stiffness, to which patches add theirs.
void clear_strip(RememberingStrip& strip);

/// Adds bounds up to the middle, stiffness and turning to those of the patch's strips, by its share.
/// `contact` has the patch alone; `strips` begin with its first one.
void add_to_strips(const RollingContact& contact, const YieldingPatch& patch, const MemoryFactors& factors,
                   RememberingStrip* strips);

/// Bounds behind a strip's middle, once all its patches have added theirs: they are symmetric.
void complete_bounds(RememberingStrip& strip);

}  // namespace wrc::tangential
