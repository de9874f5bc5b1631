/// Measured sections of a rail, each one line from the gauge side to the field side with gaps: checks of
/// them, and the pieces on which a wheel may roll. Offline: it allocates.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/fault.hpp"
#include "profiles/outline.hpp"

namespace wrc::profiles {

/// One line; NaN where nothing was measured.
struct MeasuredSection {
  double distance = 0.0;  ///< along the track [m]
  Outline line;           ///< z = 0 at the rail's top
};

/// Sections, and the limits by which they are parted.
struct FacesProblem {
  std::vector<MeasuredSection> sections;
  std::vector<double> interruptions;  ///< places that no face passes [m]
  double first = 0.0, last = 0.0;     ///< part of the track that is wanted [m]
  double depth = 0.0;                 ///< points lower than this belong to no face [m]
  double gap = 0.0;                   ///< between two points at which a line is parted [m]
  double kink = 0.0;                  ///< turn of a concave corner at which it is parted [rad]
  double least_width = 0.0;           ///< narrower pieces are left out [m]
  double tolerance = 0.0;             ///< distance of a section from the mean of its neighbours [m]
  std::size_t most_faces = 0;         ///< largest number of faces that a model holds
};

/// Part of a section's line between two cuts.
struct Piece {
  std::size_t number = 0;  ///< number of the section
  Outline line;
};

/// WRC_ERROR_PROFILE about a section, with its place. `why` receives the sentence that the fault points to.
Fault unsound(const MeasuredSection& section, std::size_t number, const std::string& told, std::string& why);

/// Are the sections sound: order along the track, unit, direction, no crossing of themselves?
Fault check_sections(const std::vector<MeasuredSection>& sections, std::string& why);

/// The pieces of each section above the depth, cut at gaps and concave corners. `notes` receives those
/// left out.
Fault part_sections(const FacesProblem& problem, std::vector<std::vector<Piece>>& pieces, std::string& notes,
                    std::string& why);

}  // namespace wrc::profiles
