/// Contact geometry and creepages against the 40 end-to-end cases of the reference program
/// (tests/data/wheelrail_cases.csv: S1002 on the benchmark UIC60).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "../unit/geometry_test_bodies.hpp"
#include "geometry/creepages.hpp"
#include "overlap_weighted_point.hpp"

namespace wrc {
namespace {

constexpr double mm = 1e-3;

using Case = std::map<std::string, double>;

std::vector<Case> read_cases(const std::string& path) {
  std::ifstream file(path);
  std::vector<std::string> names;
  std::vector<Case> cases;
  std::string line, word;
  std::getline(file, line);
  for (std::istringstream words(line); std::getline(words, word, ',');) names.push_back(word);
  while (std::getline(file, line)) {
    std::istringstream words(line);
    Case one;
    for (const std::string& name : names) {
      std::getline(words, word, ',');
      one[name] = std::stod(word);
    }
    cases.push_back(one);
  }
  return cases;
}

TEST(GeometryReference, ContactPointPenetrationAndCreepages) {
  const std::vector<Case> cases = read_cases(WRC_DATA "/wheelrail_cases.csv");
  ASSERT_EQ(cases.size(), 40u);

  const ReferenceBodies bodies;
  double worst_y = 0.0, worst_angle = 0.0, worst_overlap = 0.0, worst_x = 0.0, worst_lateral = 0.0,
         worst_spin = 0.0;
  for (const Case& c : cases) {
    const geometry::Pose pose{.lateral = c.at("y_ws_mm") * mm,
                              .vertical = c.at("z_ws_mm") * mm,
                              .roll = c.at("roll_rad"),
                              .yaw = c.at("yaw_rad")};
    const geometry::PosedWheel wheel = geometry::posed(bodies.wheel, pose);
    geometry::ContactPoint first;
    std::int32_t count = 0;
    ASSERT_EQ(geometry::find_contact(bodies.rail, wheel, 1, &first, count).status, WRC_OK);
    const geometry::ContactPoint contact =
        test::overlap_weighted_point(bodies.rail, wheel, first, -first.vertical_gap);
    const geometry::RigidCreepage ours = geometry::creepage(
        wheel, contact,
        {.speed = c.at("vs_mps"), .lateral_velocity = c.at("vy_mps"), .pitch_rate = c.at("vpitch_radps")});

    // Penetration along the normal: the vertical overlap at the first contact times the cosine there.
    const double overlap = -first.vertical_gap * first.cosine;
    worst_y = std::max(worst_y, std::abs(contact.y_rail - c.at("ycp_rail_mm") * mm));
    worst_angle = std::max(worst_angle, std::abs(contact.angle - c.at("delta_rad")));
    worst_overlap = std::max(worst_overlap, std::abs(overlap - c.at("pen_mm") * mm));
    // The file gives the rail relative to the wheel: opposite signs.
    worst_x = std::max(worst_x, std::abs(ours.longitudinal + c.at("cksi")));
    worst_lateral = std::max(worst_lateral, std::abs(ours.lateral + c.at("ceta")));
    worst_spin = std::max(worst_spin, std::abs(ours.spin + c.at("cphi_per_m")));
    EXPECT_NEAR(contact.y_rail, c.at("ycp_rail_mm") * mm, 0.005 * mm) << c.at("case");
    EXPECT_NEAR(contact.angle, c.at("delta_rad"), 1e-4) << c.at("case");
    EXPECT_NEAR(overlap, c.at("pen_mm") * mm, 0.2e-3 * mm) << c.at("case");
    EXPECT_NEAR(ours.longitudinal, -c.at("cksi"), 5e-5) << c.at("case");
    EXPECT_NEAR(ours.lateral, -c.at("ceta"), 5e-5) << c.at("case");
    EXPECT_NEAR(ours.spin, -c.at("cphi_per_m"), 2e-4) << c.at("case");
  }
  std::printf(
      "%zu cases, largest deviations: y %.2g mm, angle %.2g rad, penetration %.2g mm, nu_x %.2g, nu_y %.2g, "
      "spin %.2g 1/m\n",
      cases.size(), worst_y / mm, worst_angle, worst_overlap / mm, worst_x, worst_lateral, worst_spin);
}

}  // namespace
}  // namespace wrc
