/// The kinds of comparison, one file each. Each runs the variants named in `only`, or all of its own when
/// that is empty; a name it does not know is an error that lists those it does (see chosen()).
#pragma once

#include <algorithm>

#include "csv.hpp"
#include "report.hpp"

namespace compare {

using Names = std::vector<std::string>;

/// What the wheel's kinds may be told on the command line.
/// Lateral places of a run to both sides, 1 mm apart.
inline constexpr int most_beside = 6;

struct Options {
  std::string kind;                 ///< its name on the command line
  std::vector<long> cases;          ///< to run; empty: all
  Names only;                       ///< pairs of methods, NORMAL+TANGENTIAL; empty: the default
  std::string setting = "default";  ///< resolution, of WRC_RESOLUTION_LIST
  bool list = false;                ///< print each case
  double smoothing = 4.5e-3;        ///< wrc_profile.smoothing of measured points with noise [m]
  double cell = 2e-4;               ///< of the exact solver [m]
  double step = 1e-3;               ///< of a run along the track [m]
  double from = -60e-3;             ///< where a run begins along the track, within the sections [m]
  double to = 460e-3;               ///< where it ends [m]
  double exact_every = 0.0;         ///< distance at which a run asks the exact solver [m]; 0: never
  std::string keep;                 ///< file from which an ended run goes on; empty: none
  std::vector<int> beside;          ///< lateral places of a run, from the case's own [mm]; empty: all

  bool wanted(long number) const {
    return cases.empty() || std::find(cases.begin(), cases.end(), number) != cases.end();
  }
  bool wants_beside(int place) const {
    return beside.empty() || std::find(beside.begin(), beside.end(), place) != beside.end();
  }
};

/// Exact double ellipses with prescribed pressure: forces and power of every tangential variant.
Report compare_sdec(const Csv& file, const Names& only);

/// Normal contact of S1002 on the benchmark UIC60, strip by strip: every normal method.
Report compare_normal(const Csv& file, const Names& only);

/// Wheel on rail end to end, from the pose to forces and power: normal and tangential methods together.
Report compare_wheelrail(const Csv& file, const Names& only);

/// The exact solver of wrc_offline.h on the same rows, on each row's own grid.
Report compare_halfspace_sdec(const Csv& file, const Names& only);
Report compare_halfspace_normal(const Csv& file, const Names& only);

/// Non-steady rolling, step by step: the exact solver with history and the real-time method with memory.
/// Errors are over mu times the row's load; beside all rows they are listed by wave length.
Report compare_transient(const Csv& file, const Names& only);

/// Ellipses with an elasto-plastic layer, or creep curves of such: forces, moment and power.
Report compare_layer(const Csv& file, const Names& only);

/// Contact with a memory at rest and rolling either way: the exact solver step by step. Errors of forces are
/// over mu times the row's load, those of the moment also over sqrt(ab); beside all rows they are listed by
/// family.
Report compare_memory(const Csv& file, const Names& only);

/// The same of wheels on rails from rest, of files with profiles: wrc_contact_wrench() of a model that
/// remembers. Errors of the horizontal force are over mu times the row's vertical load. `steady`: the same
/// poses without memory, beside the reference's steady forces.
Report compare_memory_of_wheels(const Csv& file, const Csv& parameters, const Names& only);

/// The default tangential variant on grids of 16 to 128 strips and cells against 512 x 512: the
/// discretisation's share of the error.
Report compare_grid(const Csv& file, const Names& only);

/// Largest stresses below double ellipses and their depths.
Report compare_subsurface(const Csv& file, const Names& only);

/// The largest rise of the surface's temperature in ellipses.
Report compare_temperature(const Csv& file, const Names& only);

/// Wheels on rails from the pose to the wrench (wrc_contact_wrench): new and worn profiles at given heights;
/// flange roots under given loads against conformal theory; second differences along lines through pose
/// space; work round closed paths.
Report compare_wheelset(const Csv& file, const Options& options);
Report compare_conformal(const Csv& file, const Options& options);
Report compare_scan(const Csv& file, const Options& options);
Report compare_loop(const Csv& file, const Options& options);

/// The exact solver on the rail's surface (wrc_exact_wrench) against the rows of wheelset and conformal
/// files, and wrc_contact_wrench against that solver on the same poses.
Report compare_exact_wheel(const Csv& file, const Options& options);

/// Wheels on rails of every kind (rollers, unlike materials, friction laws, not round, along the track) from
/// the pose to the force. Each case has several settings of the reference. An error is the part that lies
/// beyond all of them.
Report compare_settings(const Csv& file, const Options& options);

/// Runs along the rails of such files in small steps; each line along the track is a row. Counts places that
/// are flagged or fail, and has the largest jumps and real time beside the exact solver.
Report compare_runs(const Csv& file, const Options& options);

/// Calls along the rails of such files, cold and from a mark, and on their profiles held constant: one line
/// of the output for each, so that tests/bench/crossing_cost.py counts their instructions.
Report compare_cost(const Csv& file, const Options& options);

}  // namespace compare
