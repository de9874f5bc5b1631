// Writes random SDEC patches with the forces of exact half-space theory:
//     make_patches SEED COUNT FILE.csv
// One line per patch, written as soon as it is solved. Started again with the same seed it goes on where the
// file ends; Ctrl-C stops it after the patch at hand. The columns are those `wrc_compare sdec` reads, and two
// more: shift and shift_P, how far the extrapolation from the grids went (force over mu N; power, relative).

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "exact_forces.hpp"

namespace {

using namespace wrc::calibration;

constexpr const char* heading =
    "a_mm,b_mm,psi,nu,G_MPa,mu,N_kN,p0_MPa,cx,cy,phi_per_m,"
    "Fx_N,Fy_N,Mz_Nm,P_W_at_1mps,adh_frac,nx,ny,shift,shift_P";

volatile std::sig_atomic_t interrupted = 0;

std::string text_of(const Patch& p) {
  char text[400];
  std::snprintf(text, sizeof text, "%.8g,%.8g,%.8g,%.8g,%.8g,%.8g,%.8g,%.8g,%.8g,%.8g,%.8g", 1e3 * p.a,
                1e3 * p.b, p.psi, p.poisson, 1e-6 * p.shear_modulus, p.friction, 1e-3 * p.normal_force,
                1e-6 * p.p0, p.creepage.longitudinal, p.creepage.lateral, p.creepage.spin);
  return text;
}

std::string text_of(const ExactForces& f) {
  char text[300];
  std::snprintf(text, sizeof text, "%.8g,%.8g,%.8g,%.8g,%.6f,%d,%d,%.1e,%.1e", f.fx, f.fy, f.mz, f.power,
                f.adhesion, fine_cells, fine_cells, f.force_shift, f.power_shift);
  return text;
}

/// Rows the file holds; cuts off a line that was not finished. Throws a sentence when they are of another
/// seed.
std::uint64_t rows_present(const std::string& path, std::uint64_t seed) {
  std::ifstream file(path, std::ios::binary);
  std::uint64_t rows = 0, bytes = 0;
  std::string line;
  for (bool first = true; std::getline(file, line) && !file.eof(); first = false) {
    bytes += line.size() + 1;
    if (first) {
      if (line != heading) throw path + " is not a file of make_patches";
    } else if (line.rfind(text_of(random_patch(seed, rows++)) + ",", 0) != 0) {
      throw path + " holds patches of another seed";
    }
  }
  file.close();
  if (bytes > 0) std::filesystem::resize_file(path, bytes);
  return rows;
}

int make(std::uint64_t seed, std::uint64_t count, const std::string& path) {
  std::uint64_t row = rows_present(path, seed);
  std::FILE* file = std::fopen(path.c_str(), row > 0 ? "ab" : "wb");
  if (!file) throw "cannot write " + path;
  if (row == 0) std::fprintf(file, "%s\n", heading);
  std::uint64_t unconverged = 0;
  for (; row < count && !interrupted; ++row) {
    const Patch patch = random_patch(seed, row);
    const ExactForces forces = exact_forces(patch);
    if (!forces.converged) ++unconverged;
    std::fprintf(file, "%s,%s\n", text_of(patch).c_str(), text_of(forces).c_str());
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
  if (argc != 4) {
    std::fprintf(stderr, "usage: make_patches SEED COUNT FILE.csv\n");
    return 2;
  }
  std::signal(SIGINT, [](int) { interrupted = 1; });
  try {
    return make(std::strtoull(argv[1], nullptr, 10), std::strtoull(argv[2], nullptr, 10), argv[3]);
  } catch (const std::string& reason) {
    std::fprintf(stderr, "%s\n", reason.c_str());
    return 1;
  }
}
