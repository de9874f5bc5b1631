/// Wheels on rails of files with the columns of wheelset_cases.csv and its like, through
/// wrc_contact_wrench().
///
/// Files are in mm, MPa and the track axes of wrc.h: wheelset's middle at (0, y_ws, z_ws - r0), angular
/// velocity in the wheelset's axes, rails by the origin of their profiles.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "csv.hpp"
#include "library.hpp"
#include "test_config.hpp"

namespace compare {

using Vector = std::array<double, 3>;

inline constexpr double least_force = 20e3;  ///< errors are over this where a force is smaller [N]
inline constexpr double moment_arm = 0.75;   ///< errors of moments are over this [m]

/// Consecutive rows of the file that belong to one case and setting: [first, last).
struct CaseRows {
  long number = 0;
  std::size_t first = 0, last = 0;
};

/// Every run of rows with the same number in column `case`.
std::vector<CaseRows> case_rows(const Csv& file);

/// The rows of a case whose column `setting` is this, and column smooth_Lfilt_mm 0 where there is one; empty
/// if none.
CaseRows setting_rows(const Csv& file, const CaseRows& rows, const std::string& setting);

/// What a pair of bodies is made of.
struct PairOptions {
  std::string wheel,
      rail;  ///< names of files in profiles/ beside the csv or a folder up, with or without .txt; S1002 and
             ///< UIC60
  double shear_modulus = 82e9, poisson = 0.28, radius = 0.46;  ///< [Pa], [-], [m]
  double smoothing = 0.0;                                      ///< [m]
  int32_t side = WRC_SIDE_RIGHT;
  int32_t normal = -1,
          tangential = -1;  ///< WRC_NORMAL_... and number of a published method; < 0: the default
  bool remembers = false;   ///< config.surface.memory
};

/// Methods by the name NORMAL+TANGENTIAL; throws std::runtime_error where it is none.
void choose_methods(const std::string& name, PairOptions& options);

/// Points of a profile [m].
struct ProfilePoints {
  std::vector<double> y, z;
};

/// Reads a file with y and z in mm on each line, # before a comment; throws std::runtime_error where it
/// cannot.
ProfilePoints read_profile(const std::filesystem::path& path);

/// The contacts of a file, each pair of profiles made once. `setting`: a resolution of WRC_RESOLUTION_LIST.
class Pairs {
 public:
  explicit Pairs(const Csv& file, std::string setting = "default")
      : folder_(file.path()), setting_(std::move(setting)) {}
  const Solver& of(const PairOptions& options);

 private:
  const ProfilePoints& points(const std::string& name);

  std::string folder_, setting_;
  std::map<std::string, ProfilePoints> points_;
  std::map<
      std::tuple<std::string, std::string, double, double, double, double, int32_t, int32_t, int32_t, bool>,
      std::unique_ptr<Solver>>
      solvers_;
};

/// The bodies of a row with columns side, wheel_file, rail_file (S1002 on UIC60 without), G_MPa, nu, r0_mm.
PairOptions pair_of(const Csv& file, std::size_t row);

/// A wheel on a rail that can be changed before it is solved.
struct WheelCase {
  wrc_wheel_input input = wrc_wheel_input_default();
  wrc_wrench wrench = sized<wrc_wrench>();

  int32_t solve(const Solver& solver) { return wrc_contact_wrench(solver.contact(), &input, &wrench); }
  Vector force() const { return {wrench.force[0], wrench.force[1], wrench.force[2]}; }
  Vector moment() const { return {wrench.moment[0], wrench.moment[1], wrench.moment[2]}; }
};

/// Pose, motion and friction of a row, height prescribed.
WheelCase wheel_case(const Csv& file, std::size_t row);

std::vector<wrc_region> regions_of(const Solver& solver, const wrc_wrench& wrench);

double length(const Vector& v);
Vector difference(const Vector& a, const Vector& b);
Vector vector_of(const Csv& file, std::size_t row, const char* x, const char* y, const char* z);

/// Shows on stderr that a long run goes on.
void show_progress(const char* kind, std::size_t done, std::size_t all);

}  // namespace compare
