#include "cases.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>

namespace wrc::calibration {

std::string text_of(const Patch& p) {
  char text[400];
  std::snprintf(text, sizeof text, "%.8g,%.8g,%.8g,%.8g,%.8g,%.8g,%.8g,%.8g,%.8g,%.8g,%.8g", 1e3 * p.a,
                1e3 * p.b, p.psi, p.poisson, 1e-6 * p.shear_modulus, p.friction, 1e-3 * p.normal_force,
                1e-6 * p.p0, p.creepage.longitudinal, p.creepage.lateral, p.creepage.spin);
  return text;
}

std::string text_of(const Case& c) {
  const ExactForces& f = c.exact;
  char text[300];
  std::snprintf(text, sizeof text, ",%.8g,%.8g,%.8g,%.8g,%.6f,%d,%d,%.1e,%.1e,", f.fx, f.fy, f.mz, f.power,
                f.adhesion, fine_cells, fine_cells, f.force_shift, f.power_shift);
  std::string line = text_of(c.patch);
  line += text;
  for (const Strip& s : c.patch.strips) {
    std::snprintf(text, sizeof text, "%.9g %.9g %.9g %.9g %.9g ", s.y, s.width, s.centre, s.half_length,
                  s.peak);
    line += text;
  }
  return line;
}

void read_rows(const std::string& path, const char* first, const char* kind,
               const std::function<bool(std::istringstream&)>& take) {
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line) || line != first) throw path + " is not a file of " + kind;
  while (std::getline(file, line)) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream row(line);
    if (!take(row)) throw path + ": a line is not complete: " + line;
  }
}

std::vector<Case> read_cases(const std::string& path) {
  std::vector<Case> cases;
  read_rows(path, heading, "make_patches", [&](std::istringstream& text) {
    std::array<double, 20> v{};
    for (double& value : v) text >> value;
    if (!text) return false;
    Case c{};
    c.patch = {1e-3 * v[0], 1e-3 * v[1],         v[2], v[3], 1e6 * v[4], v[5], 1e3 * v[6],
               1e6 * v[7],  {v[8], v[9], v[10]}, {}};
    c.exact = {v[11], v[12], v[13], v[14], v[15], v[18], v[19], true};
    for (Strip s{}; text >> s.y >> s.width >> s.centre >> s.half_length >> s.peak;)
      c.patch.strips.push_back(s);
    cases.push_back(c);
    return true;
  });
  return cases;
}

}  // namespace wrc::calibration
