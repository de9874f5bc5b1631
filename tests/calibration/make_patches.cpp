// Writes random patches with the forces of exact half-space theory:
//     make_patches sdec|wheelrail SEED COUNT FILE.csv
// One line per patch, written as soon as it is solved. Started again with the same seed it goes on where the
// file ends; Ctrl-C stops it after the patch at hand.

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "cases.hpp"

namespace {

using namespace wrc::calibration;

volatile std::sig_atomic_t interrupted = 0;

using Draw = Patch (*)(std::uint64_t seed, std::uint64_t row);

/// Rows the file holds; cuts off a line that was not finished. Throws a sentence when they are of another
/// seed.
std::uint64_t rows_present(const std::string& path, Draw draw, std::uint64_t seed) {
  std::ifstream file(path, std::ios::binary);
  std::uint64_t rows = 0, bytes = 0;
  std::string line;
  for (bool first = true; std::getline(file, line) && !file.eof(); first = false) {
    bytes += line.size() + 1;
    if (first) {
      if (line != heading) throw path + " is not a file of make_patches";
    } else if (line.rfind(text_of(draw(seed, rows++)) + ",", 0) != 0) {
      throw path + " holds patches of another seed";
    }
  }
  file.close();
  if (bytes > 0) std::filesystem::resize_file(path, bytes);
  return rows;
}

int make(Draw draw, std::uint64_t seed, std::uint64_t count, const std::string& path) {
  std::uint64_t row = rows_present(path, draw, seed);
  std::FILE* file = std::fopen(path.c_str(), row > 0 ? "ab" : "wb");
  if (!file) throw "cannot write " + path;
  if (row == 0) std::fprintf(file, "%s\n", heading);
  std::uint64_t unconverged = 0;
  for (; row < count && !interrupted; ++row) {
    Case c{draw(seed, row), {}};
    c.exact = exact_forces(c.patch);
    if (!c.exact.converged) ++unconverged;
    std::fprintf(file, "%s\n", text_of(c).c_str());
    std::fflush(file);
    if ((row + 1) % 100 == 0) std::fprintf(stderr, "%llu of %llu\n", row + 1ULL, count + 0ULL);
  }
  std::fclose(file);
  std::printf("%s: %llu patches of seed %llu; %llu of this run above the solver's tolerance\n", path.c_str(),
              row + 0ULL, seed + 0ULL, unconverged + 0ULL);
  return row < count ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string kind = argc > 1 ? argv[1] : "";
  if (argc != 5 || (kind != "sdec" && kind != "wheelrail")) {
    std::fprintf(stderr, "usage: make_patches sdec|wheelrail SEED COUNT FILE.csv\n");
    return 2;
  }
  std::signal(SIGINT, [](int) { interrupted = 1; });
  try {
    return make(kind == "sdec" ? random_sdec : random_wheel_on_rail, std::strtoull(argv[2], nullptr, 10),
                std::strtoull(argv[3], nullptr, 10), argv[4]);
  } catch (const std::string& reason) {
    std::fprintf(stderr, "%s\n", reason.c_str());
    return 1;
  }
}
