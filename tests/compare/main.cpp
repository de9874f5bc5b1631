/// wrc_compare - errors of every variant against exact results.
///
///   wrc_compare KIND FILE.csv [--only VARIANT[,VARIANT]] [--json]
#include <cstdio>
#include <exception>
#include <string>

#include "kinds.hpp"

namespace {

struct Kind {
  const char* name;
  compare::Report (*run)(const compare::Csv&, const compare::Names& only);
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

void usage(FILE* to) {
  std::fprintf(to,
               "usage: wrc_compare KIND FILE.csv [--only VARIANT[,VARIANT]] [--json]\n\n"
               "KIND and the columns FILE must have:\n");
  for (const Kind& kind : kinds) std::fprintf(to, "  %-16s %s\n", kind.name, kind.columns);
  std::fprintf(to,
               "--only: just these variants, by the names in the table, as in --only strip_fastsim,table; "
               "all of them\n"
               "        may take minutes. A name that KIND does not know is answered with those it does\n"
               "--json: the last line of the output is one JSON object\n");
}

/// Refuses the command line.
int misused(const std::string& why) {
  std::fprintf(stderr, "wrc_compare: %s\n\n", why.c_str());
  usage(stderr);
  return 2;
}

compare::Names split(const std::string& list) {
  compare::Names names(1);
  for (const char c : list) {
    if (c == ',') {
      names.emplace_back();
    } else {
      names.back() += c;
    }
  }
  return names;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() == 1 && words[0] == "--help") {
    usage(stdout);
    return 0;
  }
  if (words.size() < 2) return misused("KIND and FILE.csv are missing");
  bool json = false;
  compare::Names only;
  for (std::size_t i = 2; i < words.size(); ++i) {
    if (words[i] == "--json") {
      json = true;
    } else if (words[i] == "--only" && i + 1 < words.size()) {
      only = split(words[++i]);
    } else {
      return misused("'" + words[i] + (words[i] == "--only" ? "' names no variant" : "' is no option"));
    }
  }
  for (const Kind& kind : kinds) {
    if (words[0] != kind.name) continue;
    try {
      const compare::Report report = kind.run(compare::Csv(words[1]), only);
      report.print_table();
      if (json) report.print_json();
      return 0;
    } catch (const std::exception& problem) {
      std::fprintf(stderr, "wrc_compare: %s\n", problem.what());
      return 1;
    }
  }
  return misused("no KIND '" + words[0] + "'");
}
