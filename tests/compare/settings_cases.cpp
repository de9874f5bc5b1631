#include "settings_cases.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>
#include <stdexcept>

#include "json.hpp"
#include "test_config.hpp"
#include "wrc/wrc_offline.h"

namespace compare {
namespace {

/// A cell that may be empty, in the unit given.
double cell(const Csv& file, std::size_t row, const char* column, double unit = 1.0) {
  return file.text(row, column).empty() ? 0.0 : unit * file(row, column);
}

bool left(const Csv& file, std::size_t row) {
  const double config = file(row, "config");
  return config == 0.0 || config == 4.0;
}

/// A profile of the interface that reads points kept elsewhere.
wrc_profile profile_of(const ProfilePoints& points) {
  wrc_profile profile{};
  profile.kind = WRC_PROFILE_POINTS;
  profile.count = static_cast<uint32_t>(points.y.size());
  profile.y = points.y.data();
  profile.z = points.z.data();
  return profile;
}

/// The sections of a file, those of a face side by side. They point into `outlines` and `marks`.
std::vector<wrc_rail_section> read_sections(const std::filesystem::path& path,
                                            std::vector<ProfilePoints>& outlines,
                                            std::vector<std::vector<double>>& marks) {
  std::vector<Json> list = read_json(path).list;
  std::stable_sort(list.begin(), list.end(),
                   [](const Json& a, const Json& b) { return a["face"].number < b["face"].number; });
  for (const Json& each : list) {
    outlines.push_back(read_profile(path.parent_path() / each["file"].text));
    marks.push_back(each.has("marks") ? each["marks"].numbers() : std::vector<double>{});
    for (double& mark : marks.back()) mark *= 1e-3;
  }
  std::vector<wrc_rail_section> sections;
  for (std::size_t i = 0; i < list.size(); ++i) {
    wrc_rail_section section{};
    section.distance = list[i]["distance"].number;
    section.surface = static_cast<int32_t>(list[i]["face"].number);
    section.mark_count = static_cast<uint32_t>(marks[i].size());
    section.marks = marks[i].empty() ? nullptr : marks[i].data();
    // A nose lies deep at its tip: the origin of its profile is level with its top.
    section.z = *std::min_element(outlines[i].z.begin(), outlines[i].z.end());
    for (double& z : outlines[i].z) z -= section.z;
    section.profile = profile_of(outlines[i]);
    sections.push_back(section);
  }
  return sections;
}

/// y at which the inclination of a rail's head, which grows from gauge to field, first reaches an angle.
double place_of(double angle, const ProfilePoints& rail) {
  double y_before = rail.y.front(), before = -2.0;
  for (std::size_t i = 0; i + 1 < rail.y.size(); ++i) {
    const double here = std::atan2(rail.z[i + 1] - rail.z[i], rail.y[i + 1] - rail.y[i]);
    const double y = 0.5 * (rail.y[i] + rail.y[i + 1]);
    if (here >= angle) return i == 0 ? y : y_before + (angle - before) / (here - before) * (y - y_before);
    y_before = y;
    before = here;
  }
  return rail.y.back();
}

}  // namespace

CaseBodies::CaseBodies(const Csv& file, std::string setting, bool along_track)
    : file_(file),
      folder_(std::filesystem::path(file.path()).parent_path().string()),
      setting_(std::move(setting)),
      along_track_(along_track) {}

const CaseBodies::Made& CaseBodies::of(std::size_t row) {
  std::string key;
  for (const char* const column : {"config", "wheel_file", "rail_file", "sections", "roundness", "G_w",
                                   "nu_w", "G_r", "nu_r", "nomradr", "r0", "fbdist", "fbpos", "raily0"})
    key += file_.text(row, column) + ' ';
  Made& made = made_[key];
  if (!made.solver) make(row, made);
  return made;
}

void CaseBodies::make(std::size_t row, Made& made) {
  wrc_config config = test_config();
  char text[1024] = "";
  if (wrc_config_use(&config, setting_.c_str(), text, sizeof text) != WRC_OK) throw std::runtime_error(text);
  const std::filesystem::path folder = folder_;
  const ProfilePoints wheel = read_profile(folder / file_.text(row, "wheel_file"));
  made.rail = read_profile(folder / file_.text(row, "rail_file"));
  config.wheel = profile_of(wheel);
  config.rail = profile_of(made.rail);
  config.wheel_material.shear_modulus = 1e6 * file_(row, "G_w");
  config.wheel_material.poisson = file_(row, "nu_w");
  config.rail_material.shear_modulus = 1e6 * file_(row, "G_r");
  config.rail_material.poisson = file_(row, "nu_r");
  config.wheelset.wheel_radius = 1e-3 * file_(row, "r0");
  config.wheelset.tape_circle_distance = 1e-3 * (file_(row, "fbdist") - 2.0 * file_(row, "fbpos"));
  config.track.placement = WRC_PLACEMENT_ORIGIN;
  config.track.rail_origin = 1e-3 * std::fabs(file_(row, "raily0"));
  if (const double radius = cell(file_, row, "nomradr", 1e-3); radius > 0.0)
    config.roller_curvature = 1.0 / radius;

  // A wheel that is not round.
  std::vector<double> angles, places, deviations;
  if (const std::string& name = file_.text(row, "roundness"); !name.empty()) {
    const Json roundness = read_json(folder / name);
    angles = roundness["angle"].numbers();
    deviations = roundness["deviation"].numbers();
    if (roundness.has("y")) places = roundness["y"].numbers();
    config.roundness.angle_count = static_cast<uint32_t>(angles.size());
    config.roundness.row_count = static_cast<uint32_t>(deviations.size() / angles.size());
    config.roundness.angles = angles.data();
    config.roundness.y = places.empty() ? nullptr : places.data();
    config.roundness.deviations = deviations.data();
  }

  // A rail along the track. Its sections take the place of the profile, which the stages alone read: any
  // rail will do.
  std::vector<ProfilePoints> outlines;
  std::vector<std::vector<double>> marks;
  std::vector<wrc_rail_section> sections;
  if (const std::string& name = file_.text(row, "sections"); along_track_ && !name.empty()) {
    sections = read_sections(folder / name, outlines, marks);
    config.rail = {};
    config.rail.kind = WRC_PROFILE_UIC60_BENCHMARK;
    config.rail_section_count = static_cast<uint32_t>(sections.size());
    config.rail_section_size = sizeof(wrc_rail_section);
    config.rail_sections = sections.data();
    const auto along = [](const wrc_rail_section& a, const wrc_rail_section& b) {
      return a.distance < b.distance;
    };
    const auto ends = std::minmax_element(sections.begin(), sections.end(), along);
    made.begin = ends.first->distance;
    made.end = ends.second->distance;
  }
  made.solver = std::make_unique<Solver>(config, left(file_, row) ? WRC_SIDE_LEFT : WRC_SIDE_RIGHT);
}

/// Friction is linear in the inclination between the points of the file: that many places of equal steps of
/// the angle.
Zones zones_of(const std::string& text, const ProfilePoints& rail) {
  std::vector<double> angles, coefficients;
  std::istringstream points(text);
  for (std::string point; std::getline(points, point, ';');) {
    const std::size_t colon = point.find(':');
    angles.push_back(std::stod(point.substr(0, colon)));
    coefficients.push_back(std::stod(point.substr(colon + 1)));
  }
  constexpr std::size_t most = 64;  // breakpoints of wrc_friction
  const std::size_t steps = angles.size() > 1 ? (most - 1) / (angles.size() - 1) : 0;
  Zones zones;
  const auto add = [&](double angle, double coefficient) {
    zones.y.push_back(place_of(angle, rail));
    zones.coefficients.push_back(coefficient);
  };
  for (std::size_t i = 0; i + 1 < angles.size(); ++i) {
    for (std::size_t k = 0; k < steps; ++k) {
      const double share = static_cast<double>(k) / static_cast<double>(steps);
      add(angles[i] + share * (angles[i + 1] - angles[i]),
          coefficients[i] + share * (coefficients[i + 1] - coefficients[i]));
    }
  }
  add(angles.back(), coefficients.back());
  return zones;
}

WheelCase case_of(const Csv& file, std::size_t row, const Zones& zones) {
  WheelCase made;
  wrc_wheel_input& input = made.input;
  const auto value = [&](const char* column, double unit = 1.0) { return cell(file, row, column, unit); };
  const bool roller = value("nomradr") > 0.0;
  input.wheel.angular_axes = WRC_AXES_BODY;
  input.wheel.y = value("y", 1e-3);
  input.wheel.z = value("z", 1e-3);
  input.wheel.roll = value("roll");
  input.wheel.yaw = value("yaw");
  (roller ? input.roller_rate : input.wheel.velocity[0]) = value("vs", roller ? 1.0 : 1e-3);
  input.wheel.velocity[1] = value("vy", 1e-3);
  input.wheel.velocity[2] = value("vz", 1e-3);
  input.wheel.angular_velocity[0] = value("vroll");
  input.wheel.angular_velocity[1] = value("vpitch");
  input.wheel.angular_velocity[2] = value("vyaw");
  input.rail.y = value("dyrail", 1e-3);
  input.rail.z = value("railz0", 1e-3) + value("dzrail", 1e-3);
  input.rail.roll = value("rollr");
  input.rail.y_velocity = value("vyrail", 1e-3);
  input.rail.z_velocity = value("vzrail", 1e-3);
  input.rail.roll_rate = value("vrollr");
  if (!roller) input.distance = value("s", 1e-3);
  input.angle = value("pitch");
  input.friction.coefficient = value("mu");
  if (file.text(row, "law") == "falling") {
    input.friction.speed_law = WRC_SPEED_LAW_EXPONENTIAL;
    input.friction.fall_rate = value("law_b");
  } else if (file.text(row, "law") == "static_kinetic") {
    input.friction.speed_law = WRC_SPEED_LAW_HYPERBOLIC;
    input.friction.half_speed = value("law_b");
  }
  if (input.friction.speed_law != WRC_SPEED_LAW_NONE) input.friction.kinetic_ratio = value("law_a");
  if (!zones.y.empty()) {
    input.friction.zone_frame = WRC_ZONES_RAIL_PROFILE;
    input.friction.zone_count = static_cast<uint32_t>(zones.y.size());
    input.friction.zone_y = zones.y.data();
    input.friction.zone_coefficients = zones.coefficients.data();
  }
  if (!file.text(row, "fz").empty()) {
    input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
    input.vertical_load = value("fz");
    input.wheel.z = 0.0;
  }
  return made;
}

int32_t solve_exactly(WheelCase& wheel, const Solver& solver, double cell_size) {
  wrc_exact_wrench_options options = wrc_exact_wrench_options_default();
  options.cell_x = options.cell_s = cell_size;
  return wrc_exact_wrench(solver.contact(), &wheel.input, &options, &wheel.wrench);
}

}  // namespace compare
