/// The undeformed gap around a contact point as rows along the rolling direction (patch/gap.hpp), from the
/// wheel's outline and the rail's profile.
///
/// Contact frame: origin where the bodies first touch (the wheel is moved vertically by the contact point's
/// gap), x along the track, y along the common tangent, z along the normal into the rail. The height of a row
/// is the separation of the two curves at the same contact-frame y; both are found there by Newton's method.
#pragma once

#include <cstdint>

#include "base/fault.hpp"
#include "geometry/contact_search.hpp"
#include "geometry/placement.hpp"
#include "geometry/silhouette.hpp"
#include "kernels/kernels.hpp"
#include "patch/gap.hpp"

namespace wrc::geometry {

/// Memory of the rows, owned by the caller.
struct GapRowMemory {
  std::int32_t capacity = 0;
  double* y = nullptr;
  double* height = nullptr;
  double* centre = nullptr;
  double* curvature = nullptr;
};

/// Reason why the rows end on one side.
enum class RowsEnd {
  gap,          ///< the gap grew beyond the limit: nothing nearby is left out
  half_width,   ///< max_half_width was reached
  inclination,  ///< a surface turned away from the contact plane
  fold,         ///< the wheel's outline folds back: flange root under strong yaw (beyond about 30 mrad)
  profile_end,  ///< the wheel's or the rail's profile ends there while the gap is still within the limit
};

struct GapWindow {
  double low = 0.0, high = 0.0;  ///< contact-frame y of the first and the last row [m]
  RowsEnd low_end = RowsEnd::gap, high_end = RowsEnd::gap;
};

struct GapLimits {
  double height = 0.5e-3;         ///< rows are wanted where the gap stays below this [m]
  double max_half_width = 30e-3;  ///< and no further from the contact point than this [m]
};

/// The y-range around the contact point in which the gap stays below the limit, out to the last place within
/// max_half_width where it does. A second zone that nearly touches (flange) is included with the hollow
/// between. The ends are interpolated crossings and move continuously with the pose. So rows spread uniformly
/// over the range do not jump as the wheelset moves. The exception is a second zone that appears at the limit
/// itself, where nothing touches yet.
GapWindow gap_window(const Rail& rail, const PosedWheel& wheel, const ContactPoint& contact,
                     const GapLimits& limits);

/// Fills `count` rows (4 <= count <= capacity) uniformly over the window. WRC_FLAG_ITERATION_CAP if a row's
/// Newton iteration did not reach its tolerance; WRC_ERROR_GAP if the window is empty.
Fault fill_gap_rows(const Rail& rail, const PosedWheel& wheel, const ContactPoint& contact,
                    const GapWindow& window, std::int32_t count, const GapRowMemory& memory,
                    const Kernels& kernels, patch::GapRows& rows);

}  // namespace wrc::geometry
