// Writes random patches with the forces of exact half-space theory:
//     make_patches sdec|wheelrail|surface|memory|spin SEED COUNT FILE.csv
// patches in a plane, whole contacts on the rail's surface (surface_case.hpp), or sequences of steps
// (memory_case.hpp), of which `spin` are loops of spin at rest. One line per patch, written
// as soon as it is solved. Started again with the same seed it goes on where the file ends; Ctrl-C stops it
// after the patch at hand.

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "cases.hpp"
#include "memory_case.hpp"
#include "surface_case.hpp"

namespace {

using namespace wrc::calibration;

volatile std::sig_atomic_t interrupted = 0;

/// What a file holds: its heading, how a row begins and the whole of it, once solved.
struct Kind {
  const char* heading;
  std::string (*drawn)(std::uint64_t seed, std::uint64_t row);
  std::string (*solved)(std::uint64_t seed, std::uint64_t row, bool& converged);
};

template <Patch draw(std::uint64_t, std::uint64_t)>
Kind planar() {
  return {heading, [](std::uint64_t seed, std::uint64_t row) { return text_of(draw(seed, row)); },
          [](std::uint64_t seed, std::uint64_t row, bool& converged) {
            Case c{draw(seed, row), {}};
            c.exact = exact_forces(c.patch);
            converged = c.exact.converged;
            return text_of(c);
          }};
}

Kind surface() {
  return {surface_heading,
          [](std::uint64_t seed, std::uint64_t row) { return text_of(random_surface_case(seed, row)); },
          [](std::uint64_t seed, std::uint64_t row, bool& converged) {
            ExactSurfaceCase c{random_surface_case(seed, row), {}};
            c.exact = exact_forces(c.rolling);
            converged = c.exact.converged;
            return text_of(c);
          }};
}

template <MemoryCase draw(std::uint64_t, std::uint64_t)>
Kind sequences() {
  return {memory_heading, [](std::uint64_t seed, std::uint64_t row) { return patch_text(draw(seed, row)); },
          [](std::uint64_t seed, std::uint64_t row, bool& converged) {
            MemoryCase c = draw(seed, row);
            solve_exactly(c);
            converged = true;
            return text_of(c);
          }};
}

/// Rows the file holds; cuts off a line that was not finished. Throws a sentence when they are of another
/// seed.
std::uint64_t rows_present(const std::string& path, const Kind& kind, std::uint64_t seed) {
  std::ifstream file(path, std::ios::binary);
  std::uint64_t rows = 0, bytes = 0;
  std::string line;
  for (bool first = true; std::getline(file, line) && !file.eof(); first = false) {
    bytes += line.size() + 1;
    if (first) {
      if (line != kind.heading) throw path + " is not a file of make_patches of this kind";
    } else if (line.rfind(kind.drawn(seed, rows++) + ",", 0) != 0) {
      throw path + " holds patches of another seed";
    }
  }
  file.close();
  if (bytes > 0) std::filesystem::resize_file(path, bytes);
  return rows;
}

int make(const Kind& kind, std::uint64_t seed, std::uint64_t count, const std::string& path) {
  std::uint64_t row = rows_present(path, kind, seed);
  std::FILE* file = std::fopen(path.c_str(), row > 0 ? "ab" : "wb");
  if (!file) throw "cannot write " + path;
  if (row == 0) std::fprintf(file, "%s\n", kind.heading);
  std::uint64_t unconverged = 0;
  for (; row < count && !interrupted; ++row) {
    bool converged = false;
    const std::string line = kind.solved(seed, row, converged);
    if (!converged) ++unconverged;
    std::fprintf(file, "%s\n", line.c_str());
    std::fflush(file);
    if ((row + 1) % 100 == 0) std::fprintf(stderr, "%llu of %llu\n", row + 1ULL, count + 0ULL);
  }
  std::fclose(file);
  std::printf("%s: %llu patches of seed %llu; %llu of this run above the solver's tolerance\n", path.c_str(),
              row + 0ULL, seed + 0ULL, unconverged + 0ULL);
  return row < count ? 1 : 0;
}

/// The kind of this name; nullptr: there is none.
Kind (*kind_of(const std::string& name))() {
  if (name == "sdec") return planar<random_sdec>;
  if (name == "wheelrail") return planar<random_wheel_on_rail>;
  if (name == "surface") return surface;
  if (name == "memory") return sequences<random_memory_case>;
  return name == "spin" ? sequences<random_spin_at_rest> : nullptr;
}

}  // namespace

int main(int argc, char** argv) {
  Kind (*const kind)() = kind_of(argc == 5 ? argv[1] : "");
  if (!kind) {
    std::fprintf(stderr, "usage: make_patches sdec|wheelrail|surface|memory|spin SEED COUNT FILE.csv\n");
    return 2;
  }
  std::signal(SIGINT, [](int) { interrupted = 1; });
  try {
    return make(kind(), std::strtoull(argv[2], nullptr, 10), std::strtoull(argv[3], nullptr, 10), argv[4]);
  } catch (const std::string& reason) {
    std::fprintf(stderr, "%s\n", reason.c_str());
    return 1;
  }
}
