#include "wheel_cases.hpp"

#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <sstream>

#include "presets.hpp"
#include "test_config.hpp"

namespace compare {

std::vector<CaseRows> case_rows(const Csv& file) {
  std::vector<CaseRows> cases;
  for (std::size_t row = 0; row < file.rows(); ++row) {
    const auto number = static_cast<long>(file(row, "case"));
    if (cases.empty() || cases.back().number != number) cases.push_back({number, row, row});
    cases.back().last = row + 1;
  }
  return cases;
}

CaseRows setting_rows(const Csv& file, const CaseRows& rows, const std::string& setting) {
  CaseRows found{rows.number, rows.first, rows.first};
  for (std::size_t row = rows.first; row < rows.last; ++row) {
    if (file.text(row, "setting") != setting) continue;
    if (file.has("smooth_Lfilt_mm") && file(row, "smooth_Lfilt_mm") != 0.0) continue;
    if (found.first == found.last) found.first = row;
    found.last = row + 1;
  }
  return found;
}

ProfilePoints read_profile(const std::filesystem::path& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot read " + path.string());
  ProfilePoints points;
  for (std::string line; std::getline(file, line);) {
    std::istringstream numbers(line);
    double y = 0.0, z = 0.0;
    if (line.empty() || line[0] == '#') continue;
    if (!(numbers >> y >> z)) throw std::runtime_error(path.string() + ": '" + line + "' is no point");
    points.y.push_back(1e-3 * y);
    points.z.push_back(1e-3 * z);
  }
  return points;
}

const ProfilePoints& Pairs::points(const std::string& name) {
  if (const auto found = points_.find(name); found != points_.end()) return found->second;
  std::string file_name = name == "S1002" ? "s1002_benchmark" : name == "UIC60" ? "uic60_benchmark" : name;
  if (file_name.size() < 4 || file_name.substr(file_name.size() - 4) != ".txt") file_name += ".txt";
  std::filesystem::path folder = std::filesystem::path(folder_).parent_path();
  if (!std::filesystem::exists(folder / "profiles")) folder /= "..";
  return points_[name] = read_profile(folder / "profiles" / file_name);
}

const Solver& Pairs::of(const PairOptions& options) {
  auto& solver =
      solvers_[{options.wheel, options.rail, options.shear_modulus, options.poisson, options.radius,
                options.smoothing, options.side, options.normal, options.tangential, options.remembers}];
  if (solver != nullptr) return *solver;
  const auto profile_of = [&](const std::string& name) {
    const ProfilePoints& given = points(name);
    wrc_profile profile = sized<wrc_profile>();
    profile.kind = WRC_PROFILE_POINTS;
    profile.count = static_cast<uint32_t>(given.y.size());
    profile.y = given.y.data();
    profile.z = given.z.data();
    profile.smoothing = options.smoothing;
    return profile;
  };
  wrc_config config = test_config();
  char text[1024] = "";
  if (wrc_config_use(&config, setting_.c_str(), text, sizeof text) != WRC_OK) throw std::runtime_error(text);
  config.wheel_material.shear_modulus = config.rail_material.shear_modulus = options.shear_modulus;
  config.wheel_material.poisson = config.rail_material.poisson = options.poisson;
  config.wheelset.wheel_radius = options.radius;
  config.track.placement = WRC_PLACEMENT_ORIGIN;
  config.track.rail_origin = 0.7605325577;
  config.wheel = profile_of(options.wheel);
  config.rail = profile_of(options.rail);
  if (options.normal >= 0) {
    config.normal.method = options.normal;
    choose_tangential(config, options.tangential);
  }
  config.surface.memory = options.remembers ? 1 : 0;
  solver = std::make_unique<Solver>(config, options.side);
  return *solver;
}

void choose_methods(const std::string& name, PairOptions& options) {
  std::string known;
  for (int32_t normal = 0; normal < normal_methods; ++normal) {
    for (int32_t tangential = 0; tangential < tangential_methods; ++tangential) {
      const std::string here = std::string(normal_names[normal]) + "+" + presets[tangential].identifier;
      known += "\n  " + here;
      if (here != name) continue;
      options.normal = normal;
      options.tangential = tangential;
      return;
    }
  }
  throw std::runtime_error("no variant '" + name + "'; known are" + known);
}

PairOptions pair_of(const Csv& file, std::size_t row) {
  PairOptions pair;
  pair.wheel = file.has("wheel_file") ? file.text(row, "wheel_file") : "S1002";
  pair.rail = file.has("rail_file") ? file.text(row, "rail_file") : "UIC60";
  pair.side = file.text(row, "side") == "left" ? WRC_SIDE_LEFT : WRC_SIDE_RIGHT;
  if (file.has("G_MPa")) pair.shear_modulus = 1e6 * file(row, "G_MPa");
  if (file.has("nu")) pair.poisson = file(row, "nu");
  if (file.has("r0_mm")) pair.radius = 1e-3 * file(row, "r0_mm");
  return pair;
}

WheelCase wheel_case(const Csv& file, std::size_t row) {
  WheelCase made_case;
  wrc_wheel_state& wheel = made_case.input.wheel;
  const auto if_there = [&](const char* column) { return file.has(column) ? file(row, column) : 0.0; };
  wheel.angular_axes = WRC_AXES_BODY;
  wheel.y = 1e-3 * if_there("y_ws_mm");
  wheel.z = 1e-3 * if_there("z_ws_mm");
  wheel.roll = if_there("roll_rad");
  wheel.yaw = if_there("yaw_rad");
  wheel.velocity[0] = if_there("vs_mps");
  wheel.velocity[1] = if_there("vy_mps");
  wheel.velocity[2] = if_there("vz_mps");
  wheel.angular_velocity[0] = if_there("vroll_radps");
  wheel.angular_velocity[1] = if_there("vpitch_radps");
  wheel.angular_velocity[2] = if_there("vyaw_radps");
  made_case.input.rail.y = 1e-3 * if_there("dy_rail_mm");
  made_case.input.rail.z = 1e-3 * if_there("dz_rail_mm");
  made_case.input.rail.roll = if_there("roll_rail_rad");
  made_case.input.friction.coefficient = if_there("mu");
  return made_case;
}

std::vector<wrc_region> regions_of(const Solver& solver, const wrc_wrench& wrench) {
  std::vector<wrc_region> regions;
  for (int32_t i = 0; i < wrench.region_count; ++i) {
    regions.push_back(sized<wrc_region>());
    if (wrc_contact_region(solver.contact(), i, &regions.back()) != WRC_OK)
      throw std::runtime_error("no such region");
  }
  return regions;
}

double length(const Vector& v) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

Vector difference(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Vector vector_of(const Csv& file, std::size_t row, const char* x, const char* y, const char* z) {
  return {file(row, x), file(row, y), file(row, z)};
}

void show_progress(const char* kind, std::size_t done, std::size_t all) {
  std::fprintf(stderr, "\r%s: %zu of %zu%s", kind, done, all, done == all ? "\n" : "");
}

}  // namespace compare
