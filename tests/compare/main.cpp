/// wrc_compare - errors of every variant against exact results.
///
///   wrc_compare KIND FILE.csv [--json]
#include <cstdio>
#include <cstring>
#include <exception>

#include "kinds.hpp"

namespace {

struct Kind {
  const char* name;
  compare::Report (*run)(const compare::Csv&);
  const char* columns;
};

constexpr Kind kinds[] = {
    {"sdec", compare::compare_sdec,
     "those of sdec_cases.csv: exact double ellipses, CONTACT's forces and power"},
    {"normal", compare::compare_normal,
     "those of normal_rows.csv: S1002 on UIC60, CONTACT's pressure strip by strip"},
    {"wheelrail", compare::compare_wheelrail, "those of wheelrail_cases.csv: S1002 on UIC60 end to end"},
    {"halfspace-sdec", compare::compare_halfspace_sdec,
     "those of sdec_cases.csv: the exact solver on each row's grid"},
    {"halfspace-normal", compare::compare_halfspace_normal,
     "those of normal_rows.csv: the exact solver, 0.2 mm cells"},
    {"grid", compare::compare_grid,
     "those of sdec_cases.csv: grids of 16 to 128 against 512, no reference needed"},
};

int usage() {
  std::fprintf(stderr, "usage: wrc_compare KIND FILE.csv [--json]\n\nKIND and the columns FILE must have:\n");
  for (const Kind& kind : kinds) std::fprintf(stderr, "  %-16s %s\n", kind.name, kind.columns);
  std::fprintf(stderr, "--json: the last line of the output is one JSON object\n");
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  const bool json = argc == 4 && std::strcmp(argv[3], "--json") == 0;
  if (argc != 3 && !json) return usage();
  for (const Kind& kind : kinds) {
    if (std::strcmp(argv[1], kind.name) != 0) continue;
    try {
      const compare::Report report = kind.run(compare::Csv(argv[2]));
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
