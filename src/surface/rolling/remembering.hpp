/// Strip FASTSIM that remembers, of a wheel on a rail: strips of the rail keep their tractions from one
/// committed step to the next (tangential/methods/patch_memory.hpp has the law).
///
///  - A strip's past is found by its number: it is the same strip in every step. Of two places along the track
///    (second_place.hpp) it is the nearer one's. A strip that was not in contact begins without tractions.
///    Tractions of one that leaves are gone, and the half-spaces yield by that.
///    Faces of a rail are separate bodies: strips that left one face do not make another face yield.
///  - A strip's displacement over the step is its own: slip velocities of the rigid bodies times the time.
///  - The yield U of the half-spaces is that of patches (strip_parts.hpp). Where two partitions hold, a strip's
///    cells move by the mean of its patches' yields by their shares.
///  - The steady force that the memory tends to is that of the surface (surface_rolling.hpp), strip by strip.
///  - Under conditions that stay, the tractions that are kept settle to those of steady rolling after 1.5 to 2
///    lengths of the contact, as within one long step. Forces of the step itself are not touched.
///  - The energy that could be given back is counted for the contact as a whole.
#pragma once

#include "base/arena.hpp"
#include "base/fault.hpp"
#include "surface/geometry/rail_strips.hpp"
#include "surface/rolling/surface_rolling.hpp"
#include "tangential/methods/patch_memory.hpp"

namespace wrc::surface {

struct RememberingInput {
  const SurfaceRollingInput& strips;  ///< slips as seen along the direction of rolling
  const double* along;                ///< x of the strips' middles, seen likewise [m]
  const double* number;               ///< numbers of the rail's strips, increasing
  const RailStrips& rail;             ///< where the wheel is
  const theory::SdecTable& linear_theory;
  double travel = 0.0;                          ///< displacement of a slip of 1 over the step [m]
  double rolled = 0.0;                          ///< amount of the distance rolled [m]
  double direction = 1.0;                       ///< -1: the bodies roll backwards
  const tangential::PastStrip* past = nullptr;  ///< the committed step's
  std::int64_t past_count = 0;
  tangential::PastStrip* written = nullptr;  ///< the step's: as many as `strips` has
};

struct RememberingResult {
  Fault fault;
  double dissipated = 0.0;  ///< work of the step [J]
};

/// Solves the step from the committed strips, and writes its own. Real-time: work proportional to strips.
RememberingResult roll_remembering(const RememberingInput& in, Arena arena,
                                   const SurfaceRollingForces& forces) noexcept;

/// Counts the scratch of so many strips.
void count_remembering(Arena& arena, std::int32_t most);

}  // namespace wrc::surface
