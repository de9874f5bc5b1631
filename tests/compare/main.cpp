/// wrc_compare - errors of every variant against exact results.
///
///   wrc_compare KIND FILE.csv [--json]
///   wrc_compare wheelset|conformal|scan|loop FILE.csv [--json] [--only CASE,CASE] [--list] [--smoothing MM]
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>

#include "kinds.hpp"

namespace {

using compare::Csv;
using compare::Options;
using compare::Report;

/// A kind that takes no options.
template <Report (*compare_rows)(const Csv&)>
Report plain(const Csv& file, const Options&) {
  return compare_rows(file);
}

struct Kind {
  const char* name;
  Report (*run)(const Csv&, const Options&);
  bool by_cases;  ///< takes --only and --list
  bool smooths;   ///< takes --smoothing
  const char* columns;
};

constexpr Kind kinds[] = {
    {"sdec", plain<compare::compare_sdec>, false, false,
     "those of sdec_cases.csv: exact double ellipses, CONTACT's forces and power"},
    {"normal", plain<compare::compare_normal>, false, false,
     "those of normal_rows.csv: S1002 on UIC60, CONTACT's pressure strip by strip"},
    {"wheelrail", plain<compare::compare_wheelrail>, false, false,
     "those of wheelrail_cases.csv: S1002 on UIC60 end to end"},
    {"halfspace-sdec", plain<compare::compare_halfspace_sdec>, false, false,
     "those of sdec_cases.csv: the exact solver on each row's grid"},
    {"halfspace-normal", plain<compare::compare_halfspace_normal>, false, false,
     "those of normal_rows.csv: the exact solver, 0.2 mm cells"},
    {"grid", plain<compare::compare_grid>, false, false,
     "those of sdec_cases.csv: grids of 16 to 128 against 512, no reference needed"},
    {"wheelset", compare::compare_wheelset, true, true,
     "those of wheelset_cases.csv or worn_cases.csv: pose to wrench, height prescribed"},
    {"conformal", compare::compare_conformal, true, false,
     "those of conformal_cases.csv: pose to wrench, load prescribed"},
    {"scan", compare::compare_scan, true, false,
     "those of scan_cases.csv: smoothness along lines through pose space, no reference needed"},
    {"loop", compare::compare_loop, true, false,
     "those of loop_cases.csv: work round closed paths, no reference needed"},
};

int usage() {
  std::fprintf(stderr,
               "usage: wrc_compare KIND FILE.csv [options]\n\nKIND and the columns FILE must have:\n");
  for (const Kind& kind : kinds) std::fprintf(stderr, "  %-16s %s\n", kind.name, kind.columns);
  std::fprintf(stderr,
               "--json            the last line of the output is one JSON object\n"
               "wheelset, conformal, scan, loop, whose profiles lie in profiles/ beside FILE:\n"
               "--only CASE,CASE  these cases alone\n"
               "--list            every case as well: error, forces\n"
               "wheelset:\n"
               "--smoothing MM    wave length for measured profiles with noise [4.5]\n");
  return 2;
}

/// false: not an option of this kind.
bool read_option(const Kind& kind, int argc, char** argv, int& at, Options& options, bool& json) {
  const std::string name = argv[at];
  if (name == "--json") {
    json = true;
  } else if (name == "--list" && kind.by_cases) {
    options.list = true;
  } else if (name == "--only" && kind.by_cases && at + 1 < argc) {
    for (char* text = argv[++at]; *text != '\0';) {
      char* end = text;
      options.only.push_back(std::strtol(text, &end, 10));
      if (end == text || (*end != ',' && *end != '\0')) return false;
      text = *end == ',' ? end + 1 : end;
    }
  } else if (name == "--smoothing" && kind.smooths && at + 1 < argc) {
    char* end = nullptr;
    options.smoothing = 1e-3 * std::strtod(argv[++at], &end);
    if (*end != '\0') return false;
  } else {
    return false;
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) return usage();
  for (const Kind& kind : kinds) {
    if (std::strcmp(argv[1], kind.name) != 0) continue;
    Options options;
    bool json = false;
    for (int i = 3; i < argc; ++i) {
      if (!read_option(kind, argc, argv, i, options, json)) return usage();
    }
    try {
      const Report report = kind.run(Csv(argv[2]), options);
      report.print_table();
      if (json) report.print_json();
      return 0;
    } catch (const std::exception& problem) {
      std::fprintf(stderr, "wrc_compare: %s\n", problem.what());
      return 1;
    }
  }
  return usage();
}
