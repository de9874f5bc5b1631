// The exact solver on the rail's curved surface against the reference program.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

#include "bench/halfspace_report.hpp"
#include "halfspace/surface_contact.hpp"

namespace wrc::halfspace::report {
namespace {

using Row = std::map<std::string, std::string>;

std::vector<Row> read_rows(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot read " + path);
  std::string line, cell;
  std::vector<std::string> names;
  std::vector<Row> rows;
  while (std::getline(file, line)) {
    std::istringstream cells(line);
    std::vector<std::string> values;
    while (std::getline(cells, cell, ',')) values.push_back(cell);
    if (names.empty()) {
      names = values;
      continue;
    }
    if (values.size() != names.size())
      throw std::runtime_error(path + ": a line is not as long as the heading");
    Row row;
    for (std::size_t k = 0; k < names.size(); ++k) row[names[k]] = values[k];
    rows.push_back(std::move(row));
  }
  return rows;
}

double number(const Row& row, const std::string& name) { return std::stod(row.at(name)); }

SectionCurve read_profile(const std::string& folder, std::string name) {
  if (name == "S1002") name = "s1002_benchmark";
  if (name == "UIC60") name = "uic60_benchmark";
  if (name.size() < 4 || name.compare(name.size() - 4, 4, ".txt") != 0) name += ".txt";
  std::ifstream file(folder + "/profiles/" + name);
  if (!file) throw std::runtime_error("cannot read " + folder + "/profiles/" + name);
  std::vector<double> y, z;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream cells(line);
    double a = 0.0, b = 0.0;
    if (!(cells >> a >> b)) continue;
    y.push_back(1e-3 * a);
    z.push_back(1e-3 * b);
  }
  return SectionCurve(y, z);
}

// A case as a right-hand wheel on a right-hand rail; `mirror` is -1 where it was a left-hand one.
struct Case {
  WheelAndRail bodies;
  WheelOnRail state;
  double mirror = 1.0;
};

Case read_case(const Row& row, const std::string& folder) {
  constexpr double wheel_y = 0.75, rail_y = 0.7605325577;
  const auto text = [&](const char* name, const char* otherwise) {
    const auto at = row.find(name);
    return at == row.end() ? std::string(otherwise) : at->second;
  };
  Case c;
  c.mirror = row.at("side") == "left" ? -1.0 : 1.0;
  c.bodies = {.wheel = read_profile(folder, text("wheel_file", "S1002")),
              .rail = read_profile(folder, text("rail_file", "UIC60")),
              .nominal_radius = 1e-3 * number(row, "r0_mm"),
              .rail_y = rail_y,
              .material = {1e6 * number(row, "G_MPa"), number(row, "nu")}};
  const double m = c.mirror;
  const double roll = m * number(row, "roll_rad"), yaw = m * number(row, "yaw_rad");
  const double cr = std::cos(roll), sr = std::sin(roll), cy = std::cos(yaw), sy = std::sin(yaw);
  const double r[3][3] = {{cy, -sy, 0.0}, {cr * sy, cr * cy, -sr}, {sr * sy, sr * cy, cr}};
  WheelMotion& w = c.state.wheel;
  const double rates[3] = {m * number(row, "vroll_radps"), number(row, "vpitch_radps"),
                           m * number(row, "vyaw_radps")};
  const double centre[3] = {0.0, 1e-3 * m * number(row, "y_ws_mm"),
                            1e-3 * number(row, "z_ws_mm") - c.bodies.nominal_radius};
  const double velocity[3] = {number(row, "vs_mps"), m * number(row, "vy_mps"), number(row, "vz_mps")};
  double arm[3];
  for (int k = 0; k < 3; ++k) {
    arm[k] = r[k][1] * wheel_y;
    w.position[k] = centre[k] + arm[k];
    for (int l = 0; l < 3; ++l) {
      w.rotation[k][l] = r[k][l];
      w.angular_velocity[k] += r[k][l] * rates[l];
    }
  }
  for (int k = 0; k < 3; ++k) {
    const int a = (k + 1) % 3, b = (k + 2) % 3;
    w.velocity[k] = velocity[k] + w.angular_velocity[a] * arm[b] - w.angular_velocity[b] * arm[a];
  }
  c.state.rail = {.y = 1e-3 * m * number(row, "dy_rail_mm"),
                  .z = 1e-3 * number(row, "dz_rail_mm"),
                  .roll = m * number(row, "roll_rail_rad")};
  c.state.friction = number(row, "mu");
  return c;
}

struct Errors {
  std::vector<double> force, moment, peak, area, power, height;
};

double quantile(std::vector<double> values, double q) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  const double at = q * static_cast<double>(values.size() - 1);
  const auto k = static_cast<std::size_t>(at);
  const double next = values[std::min(k + 1, values.size() - 1)];
  return values[k] + (at - static_cast<double>(k)) * (next - values[k]);
}

Json print(const std::map<std::string, Errors>& errors) {
  Json json;
  std::printf(
      "\nerrors: force vector over max(|F|, 20 kN), the rest relative; median, 95th percentile, largest\n");
  for (const auto& [setting, e] : errors) {
    const std::pair<const char*, const std::vector<double>*> columns[] = {
        {"force", &e.force}, {"moment", &e.moment}, {"peak", &e.peak},
        {"area", &e.area},   {"power", &e.power},   {"height_um", &e.height}};
    std::printf("%-18s %3zu cases", setting.c_str(), e.force.size());
    for (const auto& [name, values] : columns) {
      const bool percent = values != &e.height;
      const double scale = percent ? 100.0 : 1.0;
      std::printf("  %s %.3f %.3f %.3f%s", name, scale * quantile(*values, 0.5),
                  scale * quantile(*values, 0.95), scale * quantile(*values, 1.0), percent ? " %" : "");
      Json numbers;
      numbers.add("median", quantile(*values, 0.5));
      numbers.add("p95", quantile(*values, 0.95));
      numbers.add("max", quantile(*values, 1.0));
      json.add(setting + "." + name, numbers);
    }
    std::printf("\n");
  }
  return json;
}

// A case in one setting: rows first .. last - 1 are its patches.
void compare(const std::vector<Row>& rows, std::size_t first, std::size_t last, const std::string& folder,
             double cell, std::map<std::string, Errors>& errors) {
  const Row& row = rows[first];
  const std::string setting = row.at("setting");
  Case c = read_case(row, folder);
  SurfaceOptions options;
  options.cell_x = options.cell_s = cell;
  options.collocation = Collocation::reference_program;
  options.turned = setting != "conformal";
  const bool by_load = row.count("fz_N") != 0;
  if (by_load) {
    c.state.load_prescribed = true;
    c.state.vertical_load = -number(row, "Fz_total_N");
  }
  const SurfaceSolution s = SurfaceContact(c.bodies, options).solve({.state = c.state});
  const WheelMotion& w = c.state.wheel;
  double f[3], m[3];
  const double arm[3] = {w.rotation[0][1] * 0.75, w.rotation[1][1] * 0.75, w.rotation[2][1] * 0.75};
  for (int k = 0; k < 3; ++k) {
    const int a = (k + 1) % 3, b = (k + 2) % 3;
    f[k] = s.force[k];
    m[k] = s.moment[k] + arm[a] * s.force[b] - arm[b] * s.force[a];
  }
  f[1] *= c.mirror;
  m[0] *= c.mirror;
  m[2] *= c.mirror;
  const double f_ref[3] = {number(row, "Fx_total_N"), number(row, "Fy_total_N"), number(row, "Fz_total_N")};
  double m_ref[3] = {}, peak = 0.0, area = 0.0, power = 0.0, error = 0.0, size = 0.0, moment_error = 0.0;
  for (std::size_t k = first; k < last; ++k) {
    peak = std::max(peak, 1e6 * number(rows[k], "pmax_MPa"));
    area += 1e-6 * number(rows[k], "area_mm2");
    power += number(rows[k], by_load ? "P_W" : "P_work_W");
  }
  const char* names[3] = {"Mx_ws_Nm", "My_ws_Nm", "Mz_ws_Nm"};
  for (int k = 0; k < 3; ++k) {
    m_ref[k] = number(row, names[k]);
    error += (f[k] - f_ref[k]) * (f[k] - f_ref[k]);
    size += f_ref[k] * f_ref[k];
    moment_error += (m[k] - m_ref[k]) * (m[k] - m_ref[k]);
  }
  constexpr double least_force = 2e4, arm_length = 0.75;
  size = std::max(std::sqrt(size), least_force);
  const double own_power = by_load ? s.power_cells : s.power;
  const double height = w.position[2];  // the reference's
  Errors& e = errors[setting];
  e.force.push_back(std::sqrt(error) / size);
  e.moment.push_back(std::sqrt(moment_error) / (arm_length * size));
  e.peak.push_back(std::abs(s.peak_pressure / peak - 1.0));
  e.area.push_back(std::abs(s.area / area - 1.0));
  e.power.push_back(std::abs(own_power / power - 1.0));
  e.height.push_back(std::abs(1e6 * (s.height - height)));
  std::printf(
      "%4s %-15s F %8.0f %8.0f %8.0f ref %8.0f %8.0f %8.0f err %.3f%% M %6.1f %6.1f %6.1f ref %6.1f %6.1f "
      "%6.1f "
      "pmax %+.2f%% area %+.2f%% power %+.2f%% dz %+.3f um  %dx%d turns %d heights %d%s\n",
      row.at("case").c_str(), setting.c_str(), f[0], f[1], f[2], f_ref[0], f_ref[1], f_ref[2],
      100.0 * e.force.back(), m[0], m[1], m[2], m_ref[0], m_ref[1], m_ref[2],
      100.0 * (s.peak_pressure / peak - 1.0), 100.0 * (s.area / area - 1.0),
      100.0 * (own_power / power - 1.0), 1e6 * (s.height - height), s.grid.nx, s.grid.ny, s.turns, s.heights,
      s.fault.status == WRC_OK ? ""
      : s.fault.field          ? s.fault.field
                               : " flag");
  std::fflush(stdout);
}

}  // namespace

Json surface(const char* path, const char* only_settings, double cell) {
  const std::string file = path;
  const std::size_t slash = file.rfind('/');
  const std::string folder = slash == std::string::npos ? "." : file.substr(0, slash);
  const std::vector<Row> rows = read_rows(file);
  std::map<std::string, Errors> errors;
  const std::string wanted = std::string(",") + only_settings + ",";
  for (std::size_t first = 0, last = 0; first < rows.size(); first = last) {
    const std::string &setting = rows[first].at("setting"), &number_of = rows[first].at("case");
    while (last < rows.size() && rows[last].at("setting") == setting && rows[last].at("case") == number_of)
      ++last;
    if (wanted.find("," + setting + ",") == std::string::npos) continue;
    compare(rows, first, last, folder, cell, errors);
  }
  return print(errors);
}

}  // namespace wrc::halfspace::report
