/// wrc_compare - errors of every variant against exact results.
///
///   wrc_compare KIND FILE.csv [--only VARIANT[,VARIANT]] [--json]
///   wrc_compare wheelset|conformal|scan|loop FILE.csv [--setting NAME] [--case N[,N]] [--list] [--smoothing MM]
///   [--json]
///   wrc_compare wheelset|scan|loop FILE.csv --only NORMAL+TANGENTIAL[,NORMAL+TANGENTIAL] ...
///   wrc_compare rollers|...|track FILE.csv [--case N[,N]] [--list] [--only VARIANT[,VARIANT]] [--cell MM] [--json]
///   wrc_compare run FILE.csv [--step MM] [--from MM] [--to MM] [--y MM[,MM]] [--exact MM] [--keep FILE]
///   [--setting NAME] [--case N[,N]] [--list] [--json]
///   wrc_compare exact-wheel FILE.csv [--case N[,N]] [--list] [--cell MM] [--json]
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

#include "kinds.hpp"

namespace {

using compare::Csv;
using compare::Names;
using compare::Options;
using compare::Report;

/// An option with a length in mm.
struct Length {
  const char* name;
  double Options::*value;
};
struct Lengths {
  Length each[5];
};
constexpr Lengths none{};

/// A kind has variants to choose from, or cases along which a wheel on a rail is looked at.
struct Kind {
  const char* name;
  Report (*variants)(const Csv&, const Names& only);
  Report (*cases)(const Csv&, const Options&);
  Lengths lengths;  ///< that it takes
  const char* columns;
  bool methods = false;  ///< --only names pairs of methods
};

/// One of the kinds whose cases have several settings of the reference; all have the same columns.
constexpr Kind settings_kind(const char* name, const char* about) {
  return {name, nullptr, compare::compare_settings, {{{"--cell", &Options::cell}}}, about, true};
}

constexpr Kind kinds[] = {
    {"sdec", compare::compare_sdec, nullptr, none,
     "those of sdec_cases.csv: exact double ellipses, CONTACT's forces and power"},
    {"normal", compare::compare_normal, nullptr, none,
     "those of normal_rows.csv: S1002 on UIC60, CONTACT's pressure strip by strip"},
    {"wheelrail", compare::compare_wheelrail, nullptr, none,
     "those of wheelrail_cases.csv: S1002 on UIC60 end to end"},
    {"halfspace-sdec", compare::compare_halfspace_sdec, nullptr, none,
     "those of sdec_cases.csv: the exact solver on each row's grid"},
    {"halfspace-normal", compare::compare_halfspace_normal, nullptr, none,
     "those of normal_rows.csv: the exact solver, 0.2 mm cells"},
    {"transient", compare::compare_transient, nullptr, none,
     "those of transient_cases.csv, transient_params.csv beside it: rolling that is not steady"},
    {"memory", compare::compare_memory, nullptr, none,
     "those of memory_cases.csv, memory_params.csv beside it: shifts at rest, rolling either way, loads that "
     "vary; or of wheelrail_memory_cases.csv: wheels that wander from rest"},
    {"layer", compare::compare_layer, nullptr, none,
     "those of layer_cases.csv or layer_curves.csv: an elasto-plastic layer between the bodies"},
    {"grid", compare::compare_grid, nullptr, none,
     "those of sdec_cases.csv: grids of 16 to 128 against 512, no reference needed"},
    {"subsurf", compare::compare_subsurface, nullptr, none,
     "those of subsurf_cases.csv: largest stresses in the rail under a patch, and their depths"},
    {"subsurface", compare::compare_subsurface, nullptr, none, "the same kind by its longer name"},
    {"temperature", compare::compare_temperature, nullptr, none,
     "those of temperature_cases.csv: the largest rise of the surface's temperature by friction"},
    {"wheelset",
     nullptr,
     compare::compare_wheelset,
     {{{"--smoothing", &Options::smoothing}}},
     "those of wheelset_cases.csv or worn_cases.csv: pose to wrench, height prescribed",
     true},
    {"conformal", nullptr, compare::compare_conformal, none,
     "those of conformal_cases.csv: pose to wrench, load prescribed"},
    {"scan", nullptr, compare::compare_scan, none,
     "those of scan_cases.csv: smoothness along lines through pose space, no reference needed", true},
    {"loop", nullptr, compare::compare_loop, none,
     "those of loop_cases.csv: work round closed paths, no reference needed", true},
    {"exact-wheel",
     nullptr,
     compare::compare_exact_wheel,
     {{{"--cell", &Options::cell}}},
     "those of wheelset_cases.csv or conformal_cases.csv: the exact solver on the rail's surface"},
    settings_kind("rollers", "wheels on rollers"),
    settings_kind("materials", "wheel and rail of different materials"),
    settings_kind("friction_laws", "friction that falls with the sliding speed"),
    settings_kind("friction_zones", "friction over the rail's inclination"),
    settings_kind("loads_yaw", "vertical load prescribed, large yaw"),
    settings_kind("driven", "driven, braked, sliding and backwards wheels"),
    settings_kind("manchester", "the Manchester benchmark, vertical load prescribed"),
    settings_kind("out_of_round", "wheels that are not round"),
    settings_kind("flat", "a wheel with a measured flat"),
    settings_kind("track", "rails that change along the track; also at the reference's height"),
    {"run",
     nullptr,
     compare::compare_runs,
     {{{"--cell", &Options::cell},
       {"--step", &Options::step},
       {"--exact", &Options::exact_every},
       {"--from", &Options::from},
       {"--to", &Options::to}}},
     "those of track: each rail in small steps under the load of its first case, no reference needed"},
    {"cost",
     nullptr,
     compare::compare_cost,
     {{{"--step", &Options::step}, {"--from", &Options::from}, {"--to", &Options::to}}},
     "those of track: calls that tests/bench/crossing_cost.py counts the instructions of"},
};

void usage(FILE* to) {
  std::fprintf(to, "usage: wrc_compare KIND FILE.csv [options]\n\nKIND and the columns FILE must have:\n");
  for (const Kind& kind : kinds) std::fprintf(to, "  %-16s %s\n", kind.name, kind.columns);
  std::fprintf(
      to,
      "--json: the last line of the output is one JSON object\n"
      "--only VARIANT[,VARIANT]: just these, by the names in the table, as in --only strip_fastsim,table; "
      "all of\n"
      "        them may take minutes. A name that KIND does not know is answered with those it does\n"
      "wheelset, conformal, scan, loop, exact-wheel, whose profiles lie in profiles/ beside FILE, instead of "
      "--only:\n"
      "--case N[,N]: these cases alone\n"
      "--only NORMAL+TANGENTIAL[,...] (wheelset, scan, loop): in the default's stead a wheel on a rail with "
      "these\n"
      "        methods, by the identifiers of wrc_methods.h, as in hertz+fastsim,ekp+strip_fastsim\n"
      "--setting NAME: resolution of the wheel on a rail, as in --setting 'real time' [default]\n"
      "--list: every case as well, with its error and forces\n"
      "--smoothing MM (wheelset): wave length for measured profiles with noise [4.5]\n"
      "--cell MM (exact-wheel; rollers to track; run): cells of the exact solver [0.2]\n"
      "rollers to track have the columns of tests/data/README.md, geometry beside FILE, and --only "
      "wrc_contact_wrench (the\n"
      "        default), wrc_exact_wrench\n"
      "run, cost: within each rail's sections, at 13 lateral places 1 mm apart:\n"
      "--step MM: from place to place [1]\n"
      "--from MM, --to MM: another part of the track [-60, 460]\n"
      "--exact MM: the exact solver beside it every so many mm [never]\n"
      "--y MM[,MM]: these lateral places alone, -6 to 6 in whole mm, so that several processes share a run\n"
      "--keep FILE: notes of pieces of 10 mm done; a run that was ended goes on from them\n");
}

/// Refuses the command line.
int misused(const std::string& why) {
  std::fprintf(stderr, "wrc_compare: %s\n\n", why.c_str());
  usage(stderr);
  return 2;
}

Names split(const std::string& list) {
  Names names(1);
  for (const char c : list) {
    if (c == ',') {
      names.emplace_back();
    } else {
      names.back() += c;
    }
  }
  return names;
}

/// The whole of a word as a number; false: it is none.
bool number(const std::string& word, double& value) {
  char* end = nullptr;
  value = std::strtod(word.c_str(), &end);
  return end != word.c_str() && *end == '\0';
}

/// The length of a kind by its name on the command line; nullptr: it takes none of that name.
const Length* length_of(const Kind& kind, const std::string& word) {
  for (const Length& length : kind.lengths.each)
    if (length.name && word == length.name) return &length;
  return nullptr;
}

/// Does a kind go along the track at lateral places?
bool along_track(const Kind& kind) {
  return kind.cases == compare::compare_runs || kind.cases == compare::compare_cost;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() == 1 && words[0] == "--help") {
    usage(stdout);
    return 0;
  }
  if (words.size() < 2) return misused("KIND and FILE.csv are missing");
  const Kind* kind = nullptr;
  for (const Kind& known : kinds)
    if (words[0] == known.name) kind = &known;
  if (!kind) return misused("'" + words[0] + "' is no KIND");
  bool json = false;
  Names only;
  Options options;
  options.kind = kind->name;
  for (std::size_t i = 2; i < words.size(); ++i) {
    const bool has_value = i + 1 < words.size();
    double value = 0.0;
    if (words[i] == "--json") {
      json = true;
    } else if (words[i] == "--only" && (kind->variants || kind->methods) && has_value) {
      only = options.only = split(words[++i]);
    } else if (words[i] == "--setting" && kind->cases && has_value) {
      options.setting = words[++i];
    } else if (words[i] == "--list" && kind->cases) {
      options.list = true;
    } else if (words[i] == "--case" && kind->cases && has_value) {
      for (const std::string& word : split(words[++i])) {
        if (!number(word, value)) return misused("'" + word + "' is no number of a case");
        options.cases.push_back(static_cast<long>(value));
      }
    } else if (words[i] == "--y" && along_track(*kind) && has_value) {
      for (const std::string& word : split(words[++i])) {
        if (!number(word, value) || std::fabs(value) > compare::most_beside || value != std::floor(value))
          return misused("'" + word + "' is no lateral place of -6 to 6 in whole mm");
        options.beside.push_back(static_cast<int>(value));
      }
    } else if (words[i] == "--keep" && kind->cases == compare::compare_runs && has_value) {
      options.keep = words[++i];
    } else if (const Length* const length = length_of(*kind, words[i]); length && has_value) {
      if (!number(words[++i], value)) return misused("'" + words[i] + "' is no length in mm");
      options.*length->value = 1e-3 * value;
    } else {
      return misused("'" + words[i] + "' is no option of " + words[0] + ", or lacks its value");
    }
  }
  try {
    const Csv file(words[1]);
    const Report report = kind->variants ? kind->variants(file, only) : kind->cases(file, options);
    report.print_table();
    if (json) report.print_json();
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "wrc_compare: %s\n", error.what());
    return 1;
  }
}
