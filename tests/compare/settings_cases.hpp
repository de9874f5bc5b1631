/// Cases of the kinds rollers to track: the bodies and inputs of their rows. Columns and frames:
/// tests/data/README.md.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "wheel_cases.hpp"

namespace compare {

/// The contacts of a file, each made once, and the profile of its rail. `setting`: a resolution of
/// WRC_RESOLUTION_LIST; `along_track`: false for the rail's profile in place of its sections, without a
/// distance along the track.
class CaseBodies {
 public:
  CaseBodies(const Csv& file, std::string setting, bool along_track = true);

  struct Made {
    std::unique_ptr<Solver> solver;
    ProfilePoints rail;
    double begin = 0.0, end = 0.0;  ///< where its sections begin and end along the track [m]
  };
  const Made& of(std::size_t row);

 private:
  void make(std::size_t row, Made& made);

  const Csv& file_;
  std::string folder_, setting_;
  bool along_track_;
  std::map<std::string, Made> made_;
};

/// Breakpoints of friction over the rail's y, from those over its inclination.
struct Zones {
  std::vector<double> y, coefficients;
};
Zones zones_of(const std::string& text, const ProfilePoints& rail);

/// Pose, motion and friction of a row, its load or height prescribed. It reads `zones` as long as it lives.
WheelCase case_of(const Csv& file, std::size_t row, const Zones& zones);

/// The exact solver at a wheel's input, on cells of that size [m].
int32_t solve_exactly(WheelCase& wheel, const Solver& solver, double cell_size);

}  // namespace compare
