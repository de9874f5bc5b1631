/// Files of measured sections: .slcs of CONTACT, a table of places with a file of points for each, columns of
/// x, y, z. Offline: it allocates, reads and writes files.
#pragma once

#include <string>
#include <vector>

#include "base/fault.hpp"
#include "profiles/section_lines.hpp"

namespace wrc::profiles {

/// Unit and directions of a file's points.
struct FileAxes {
  double unit = 0.0;  ///< unit of the points [m]; 0: mm or m, whichever fits
  bool mirror_y = false, mirror_z = false;
};

/// WRC_ERROR_FILE where the file, or one that it names, cannot be used; `why` holds the sentence that the
/// fault points to.
Fault read_section_file(const std::string& path, const FileAxes& axes, std::vector<MeasuredSection>& sections,
                        std::string& why);

/// Writes .slcs where the name ends so, with the points beside it [mm]; else columns x, y, z [m].
Fault write_section_file(const std::string& path, const std::vector<MeasuredSection>& sections,
                         std::string& why);

}  // namespace wrc::profiles
