/// The faces of a rail that changes along the track, found in measured sections: blade and stock rail, wing
/// and nose, check rail. Offline: it allocates.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/fault.hpp"
#include "profiles/section_lines.hpp"

namespace wrc::profiles {

enum class FaceKind { rail, stock, blade, wing, nose, check };

/// A face in one of the sections.
struct FaceOutline {
  std::size_t number = 0;      ///< number of the section
  double distance = 0.0;       ///< along the track [m]
  Outline line;                ///< as measured
  std::vector<double> marks;   ///< y of corners that belong together, as many in each outline of a face [m]
  double spacing_error = 0.0;  ///< distance from the mean of its neighbours [m]
  double top = 0.0;            ///< z of its highest point [m]
  Outline profile;             ///< from that point, wide enough for a model
};

struct Face {
  FaceKind kind = FaceKind::rail;
  std::vector<FaceOutline> outlines;
};

/// Faces from the gauge side, and sentences about them, one in a line.
struct RailFaces {
  std::vector<Face> faces;
  std::string notes;  ///< pieces that were left out or joined
  std::string thin;   ///< places where sections are too far apart, or faces too many
};

/// WRC_ERROR_PROFILE about a section; `why` holds the sentence that the fault points to.
Fault find_faces(const FacesProblem& problem, RailFaces& found, std::string& why);

}  // namespace wrc::profiles
