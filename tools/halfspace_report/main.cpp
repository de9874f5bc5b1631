// Accuracy and speed of the exact half-space solver, printed; with --json the last line is one JSON object.
//     halfspace_report hertz             peak, axes, approach of Hertz's contact; order of convergence
//     halfspace_report carter            the middle of a long contact against Carter's closed solution
//     halfspace_report kalker            linear theory against Kalker's printed coefficients
//     halfspace_report sdec FILE.csv     against reference cases with prescribed SDEC pressure
//     halfspace_report balance FILE.csv  dissipation over the cells against the energy balance, finer grids
//     halfspace_report paper             the source paper's cases, finer grids
//     halfspace_report speed             cost against grid size
#include <exception>
#include <vector>

#include "halfspace_report/report.hpp"

int main(int argc, char** argv) {
  using namespace wrc::halfspace::report;
  bool as_json = false;
  std::vector<std::string> words;
  for (int k = 1; k < argc; ++k) {
    if (std::string(argv[k]) == "--json") {
      as_json = true;
    } else {
      words.push_back(argv[k]);
    }
  }
  const std::string what = words.empty() ? "" : words[0];
  const bool with_file = words.size() == 2;
  Json json;
  try {
    if (what == "sdec" && with_file) {
      json = sdec(words[1].c_str());
    } else if (what == "balance" && with_file) {
      json = balance(words[1].c_str());
    } else if (what == "kalker") {
      json = kalker();
    } else if (what == "hertz") {
      json = hertz();
    } else if (what == "carter") {
      json = carter();
    } else if (what == "paper") {
      json = paper();
    } else if (what == "speed") {
      json = speed();
    } else {
      std::fprintf(
          stderr,
          "usage: halfspace_report hertz | carter | kalker | paper | speed | sdec FILE.csv | balance "
          "FILE.csv [--json]\n");
      return 2;
    }
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "%s\n", problem.what());
    return 2;
  }
  if (as_json) std::printf("%s\n", json.text().c_str());
  return 0;
}
