/// Measured sections of a turnout: faces, files, and sections that cannot be used, through the C interface.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include "not_finite.hpp"
#include "test_config.hpp"
#include "wrc/wrc_profiles.h"

namespace {

/// A head: flat top between round corners, upright flanks down to the depth [m].
struct Head {
  double gauge, field, top;
};

struct Line {
  std::vector<double> y, z;
};

Line joined(std::initializer_list<Head> heads) {
  constexpr double corner = 10e-3, depth = 45e-3, turn = 1.5707963267948966;
  Line line;
  const auto add = [&](double y, double z) {
    line.y.push_back(y);
    line.z.push_back(z);
  };
  for (const Head& head : heads) {
    const double wide = std::min(corner, 0.4 * (head.field - head.gauge));
    for (double z = depth; z > head.top + corner; z -= 1e-3) add(head.gauge - 0.02 * (z - corner), z);
    for (int i = 0; i <= 30; ++i)
      add(head.gauge + wide * (1.0 - std::cos(turn * i / 30)),
          head.top + corner * (1.0 - std::sin(turn * i / 30)));
    for (double y = head.gauge + wide + 5e-4; y < head.field - wide; y += 5e-4) add(y, head.top);
    for (int i = 30; i >= 0; --i)
      add(head.field - wide * (1.0 - std::cos(turn * i / 30)),
          head.top + corner * (1.0 - std::sin(turn * i / 30)));
    for (double z = head.top + corner + 1e-3; z < depth; z += 1e-3) add(head.field + 0.02 * (z - corner), z);
  }
  return line;
}

class RailFaces : public testing::Test {
 protected:
  std::vector<double> places;
  std::vector<Line> lines;
  std::vector<wrc_section_line> sections;
  wrc_rail_faces_problem problem = wrc_rail_faces_problem_default();
  wrc_rail_faces* faces = nullptr;
  wrc_found_faces found = sized<wrc_found_faces>();
  std::string sentence;

  void TearDown() override { wrc_rail_faces_destroy(faces); }

  /// A wing rail that leaves sideways 1:10, and from 0.2 m on a nose.
  void give_crossing() {
    for (int k = 0; k <= 20; ++k) {
      const double x = 0.05 * k, away = 0.1 * x;
      places.push_back(x);
      if (x < 0.19)
        lines.push_back(joined({{-35e-3 + away, 35e-3 + away, 0.0}}));
      else
        lines.push_back(
            joined({{-90e-3, -60e-3 + 0.02 * x, 20e-3 * (1.0 - x)}, {-35e-3 + away, 35e-3 + away, 0.0}}));
    }
    give();
  }
  void give() {
    sections.clear();
    for (std::size_t k = 0; k < lines.size(); ++k) {
      wrc_section_line each{};
      each.distance = places[k];
      each.count = static_cast<uint32_t>(lines[k].y.size());
      each.y = lines[k].y.data();
      each.z = lines[k].z.data();
      sections.push_back(each);
    }
    problem.sections = sections.data();
    problem.section_count = static_cast<uint32_t>(sections.size());
  }
  int32_t create() {
    wrc_rail_faces_destroy(faces);
    char text[512] = "";
    const int32_t status = wrc_rail_faces_create(&problem, &faces, text, sizeof text);
    sentence = text;
    EXPECT_EQ(wrc_rail_faces_found(faces, &found), status == WRC_OK ? WRC_OK : WRC_ERROR_NULL);
    return status;
  }
  wrc_face_outline outline(uint32_t index) {
    auto each = sized<wrc_face_outline>();
    EXPECT_EQ(wrc_rail_faces_outline(faces, index, &each), WRC_OK) << index;
    return each;
  }
  void refused(const char* place, const char* word) {
    EXPECT_EQ(create(), WRC_ERROR_PROFILE) << sentence;
    EXPECT_EQ(faces, nullptr);
    EXPECT_NE(sentence.find(place), std::string::npos) << sentence;
    EXPECT_NE(sentence.find(word), std::string::npos) << sentence;
  }
};

TEST_F(RailFaces, ACrossingIsANoseAndAWingThatAModelTakes) {
  give_crossing();
  ASSERT_EQ(create(), WRC_OK) << sentence;
  ASSERT_EQ(found.face_count, 2U);
  ASSERT_EQ(found.outline_count, 17U + 21U);
  EXPECT_EQ(outline(0).kind, WRC_FACE_NOSE);
  EXPECT_DOUBLE_EQ(outline(0).distance, 0.2);
  EXPECT_EQ(outline(0).number, 4U);
  const wrc_face_outline wing = outline(17 + 10);
  EXPECT_EQ(wing.kind, WRC_FACE_WING);
  EXPECT_EQ(wing.face, 1U);
  EXPECT_DOUBLE_EQ(wing.distance, 0.5);
  // 45 degrees of round corners of 10 mm
  ASSERT_EQ(wing.mark_count, 2U);
  const double in = 10e-3 * (1.0 - std::sqrt(0.5));
  EXPECT_NEAR(wing.marks[0], -35e-3 + 0.05 + in, 2e-4);
  EXPECT_NEAR(wing.marks[1], 35e-3 + 0.05 - in, 2e-4);
  EXPECT_LE(*std::max_element(wing.z, wing.z + wing.count), 0.03);
  EXPECT_EQ(wrc_rail_faces_outline(faces, found.outline_count, nullptr), WRC_ERROR_NULL);
  auto beyond = sized<wrc_face_outline>();
  EXPECT_EQ(wrc_rail_faces_outline(faces, found.outline_count, &beyond), WRC_ERROR_RANGE);

  wrc_config config = wrc_config_default();
  config.wheel.kind = WRC_PROFILE_S1002;
  config.rail.kind = WRC_PROFILE_UIC60_BENCHMARK;
  config.rail_sections = found.rail_sections;
  config.rail_section_count = found.rail_section_count;
  config.rail_section_size = found.rail_section_size;
  char text[512] = "";
  EXPECT_EQ(wrc_config_check(&config, text, sizeof text), WRC_OK) << text;
}

TEST_F(RailFaces, APartHasASectionBeyondEitherEnd) {
  give_crossing();
  problem.first = 0.42;
  problem.last = 0.58;
  ASSERT_EQ(create(), WRC_OK) << sentence;
  ASSERT_EQ(found.outline_count, 10U);
  EXPECT_DOUBLE_EQ(outline(0).distance, 0.4);
  EXPECT_DOUBLE_EQ(outline(4).distance, 0.6);
}

TEST_F(RailFaces, AGapPartsALineAndAJointItsRail) {
  give_crossing();
  for (Line& line : lines)
    for (std::size_t i = 0; i < line.y.size(); ++i)
      if (line.z[i] == 0.0 && std::abs(line.y[i] - line.y.back() + 35e-3) < 4e-3) line.z[i] = nan_value;
  ASSERT_EQ(create(), WRC_OK) << sentence;
  EXPECT_EQ(found.face_count, 3U);
  const double joint = 0.125;
  problem.interruptions = &joint;
  problem.interruption_count = 1;
  ASSERT_EQ(create(), WRC_OK) << sentence;
  EXPECT_EQ(found.face_count, 5U);
  EXPECT_STREQ(found.notes, "");
}

TEST_F(RailFaces, ThinDataAreTold) {
  for (const double x : {0.0, 0.1, 0.2, 0.3, 0.4}) {
    places.push_back(x);
    lines.push_back(joined({{-35e-3, 35e-3, x == 0.2 ? 1e-3 : 0.0}}));
  }
  give();
  ASSERT_EQ(create(), WRC_OK) << sentence;
  EXPECT_NEAR(outline(2).spacing_error, 1e-3, 1e-6);
  EXPECT_NEAR(outline(1).spacing_error, 0.5e-3, 1e-6);
  EXPECT_NE(std::string(found.thin).find("rail: section 3 at 0.2 m is 1 mm off the mean"), std::string::npos)
      << found.thin;
  problem.tolerance = 2e-3;
  ASSERT_EQ(create(), WRC_OK);
  EXPECT_STREQ(found.thin, "");
}

TEST_F(RailFaces, SectionsThatCannotBeUsedAreNamed) {
  give_crossing();
  const std::vector<double> as_given = places;
  const std::vector<Line> sound = lines;
  const auto with = [&](auto&& change) {
    places = as_given;
    lines = sound;
    change(lines[2]);
    give();
  };
  places[2] = 0.05;
  give();
  refused("(section 3 at 0.05 m)", "measured twice");
  places[2] = 0.01;
  give();
  refused("(section 3 at 0.01 m)", "sections cross");
  with([](Line& line) {
    for (double& y : line.y) y *= 1e3;
  });
  refused("(section 3 at 0.1 m)", "another unit");
  with([](Line& line) {
    for (double& z : line.z) z = -z;
  });
  refused("(section 3 at 0.1 m)", "turn its sign");
  with([](Line& line) {
    for (std::size_t i = 40; i < 50; ++i) line.y[i] -= 0.4e-3 * static_cast<double>(i - 40);
  });
  refused("(section 3 at 0.1 m)", "overhangs");
  with([](Line& line) {
    const double y = line.y[60];
    for (const double dy : {2e-3, 4e-3}) line.y.insert(line.y.begin() + 61, y + dy);
    for (const double dz : {3e-3, -3e-3}) line.z.insert(line.z.begin() + 61, line.z[60] + dz);
  });
  refused("(section 3 at 0.1 m)", "crosses itself");
  with([](Line& line) {
    for (double& z : line.z) z += 0.05;
  });
  refused("(section 3 at 0.1 m)", "nothing lies above");
  sections[2].y = nullptr;
  EXPECT_EQ(create(), WRC_ERROR_NULL);
  EXPECT_NE(sentence.find("(section 3 at 0.1 m)"), std::string::npos) << sentence;
  EXPECT_EQ(wrc_rail_faces_create(&problem, nullptr, nullptr, 0), WRC_ERROR_NULL);
  EXPECT_EQ(wrc_rail_faces_found(nullptr, &found), WRC_ERROR_NULL);
  wrc_rail_faces_destroy(nullptr);
}

class SectionFile : public RailFaces {
 protected:
  std::string folder = testing::TempDir();
  wrc_section_file* file = nullptr;

  void TearDown() override {
    wrc_section_file_destroy(file);
    RailFaces::TearDown();
  }
  std::string write(const char* name, const std::string& text) {
    std::ofstream(folder + name) << text;
    return folder + name;
  }
  int32_t read(const std::string& path, double unit = 0.0, int32_t mirror_y = 0) {
    wrc_section_file_destroy(file);
    char text[1024] = "";
    const int32_t status = wrc_section_file_read(path.c_str(), unit, mirror_y, 0, &file, text, sizeof text);
    sentence = text;
    return status;
  }
  wrc_section_line line(uint32_t index) {
    wrc_section_line each{};
    EXPECT_EQ(wrc_section_file_line(file, index, &each), WRC_OK) << index;
    return each;
  }
};

TEST_F(SectionFile, WrittenAndReadAgain) {
  give_crossing();
  for (const char* name : {"wrc_faces.slcs", "wrc_faces.txt"}) {
    const std::string path = folder + name;
    char text[512] = "";
    ASSERT_EQ(wrc_section_file_write(path.c_str(), sections.data(), problem.section_count, text, sizeof text),
              WRC_OK)
        << text;
    ASSERT_EQ(read(path), WRC_OK) << sentence;
    for (uint32_t k = 0; k < problem.section_count; ++k) {
      const wrc_section_line each = line(k);
      ASSERT_EQ(each.count, sections[k].count);
      EXPECT_NEAR(each.distance, sections[k].distance, 1e-7);
      for (uint32_t i = 0; i < each.count; ++i) {
        ASSERT_NEAR(each.y[i], sections[k].y[i], 1e-9);
        ASSERT_NEAR(each.z[i], sections[k].z[i], 1e-9);
      }
    }
    wrc_section_line beyond{};
    EXPECT_EQ(wrc_section_file_line(file, problem.section_count, &beyond), WRC_ERROR_RANGE);
  }
  EXPECT_EQ(wrc_section_file_write((folder + "no/such/folder.txt").c_str(), sections.data(), 2, nullptr, 0),
            WRC_ERROR_FILE);
}

TEST_F(SectionFile, PointsOfSimpackAndMiniProf) {
  // 70 mm wide; the first in metres, moved and mirrored by its keys, the second in mm with columns of its own
  write("wrc_a.prr",
        "header.begin\n type = 0\nheader.end\nspline.begin\n units.len.f = 1.0\n shift.y = 0.01 ! m\n "
        "mirror.y = 1\n"
        "point.begin\n 0.025 0.02 1\n -0.01 0.0\n -4.5D-2 2e-2\npoint.end\nspline.end\n");
  write("wrc_b.ban", "ColumnDef=A,Y,X\nXYPoints=3\n7 20 -35\n7 0 0\n7 20,35\n");
  const std::string path = write("wrc_mixed.slcs",
                                 "% slices\n 0.5  1000.0  U_OFFSET, U_SCALE\n 2 NSLC\n 0 0 0\n 1\n"
                                 " 0.25 'wrc_a.prr'\n 1.5d0 'wrc_b.ban' % the last\n");
  ASSERT_EQ(read(path), WRC_OK) << sentence;
  EXPECT_NEAR(line(0).distance, 0.75, 1e-12);
  EXPECT_NEAR(line(1).distance, 2.0, 1e-12);
  for (const uint32_t k : {0U, 1U}) {
    const wrc_section_line each = line(k);
    ASSERT_EQ(each.count, 3U);
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(each.y[i], -0.035 + 0.035 * i, 1e-15);
      EXPECT_NEAR(each.z[i], i == 1 ? 0.0 : 0.02, 1e-15);
    }
  }
  ASSERT_EQ(read(path, 1e-3, 1), WRC_OK) << sentence;
  EXPECT_NEAR(line(0).y[0], -0.035, 1e-15);
}

TEST_F(SectionFile, TableOfPlaces) {
  write("wrc_rail_7.txt", "y;z\n-35,5;2\n0;0\n35,5;2\n");
  ASSERT_EQ(read(write("SectionPositionwrc_rail.txt", "# number, place\n 7  1.25\n")), WRC_OK) << sentence;
  EXPECT_EQ(line(0).distance, 1.25);
  EXPECT_NEAR(line(0).y[2], 0.0355, 1e-15);
  EXPECT_EQ(read(write("SectionPositionwrc_none.txt", "7  1.25\n")), WRC_ERROR_FILE);
  EXPECT_NE(sentence.find("section 7 at 1.25 m has no file wrc_none_7.txt"), std::string::npos) << sentence;
}

TEST_F(SectionFile, FilesThatCannotBeReadAreNamed) {
  const auto refuse = [&](const std::string& path, const char* word) {
    EXPECT_EQ(read(path), WRC_ERROR_FILE) << sentence;
    EXPECT_EQ(file, nullptr);
    EXPECT_NE(sentence.find(word), std::string::npos) << sentence;
    EXPECT_NE(sentence.find(path), std::string::npos) << sentence;
  };
  refuse(folder + "wrc_not_there.slcs", "cannot be opened");
  refuse(folder + "wrc_not_there.txt", "cannot be opened");
  refuse(write("wrc_1.slcs", "words\n"), "no heading of slices");
  refuse(write("wrc_points.txt", "-35.5 2\n0 0\n35.5 2\n"), "are these points of a section");
  refuse(write("wrc_2.slcs", "0 1\n2\n"), "2 slices are promised, 0 named");
  refuse(write("wrc_3.slcs", "0 1\n1\n0 'wrc_lost.txt'\n"), "line 3: there is no file");
  write("wrc_4.txt", "0 0\n1 none\n");
  refuse(write("wrc_4.slcs", "0 1\n1\n0 'wrc_4.txt'\n"), "line 2: '1 none' is no point");
  write("wrc_5.prr", "point.begin\n 0 0\n 1\npoint.end\n");
  refuse(write("wrc_5.slcs", "0 1\n1\n0 'wrc_5.prr'\n"), "line 3: '1' is neither");
  refuse(write("wrc_6.txt", "0 0 0\n1 0\n"), "line 2: neither columns");
  refuse(write("wrc_7.txt", "0 0 0\n0 5 0\n"), "neither in mm nor in m");
  refuse(write("wrc_8.txt", ""), "neither columns");
  EXPECT_EQ(read(folder + "wrc_7.txt", 2.0), WRC_ERROR_RANGE);
  EXPECT_EQ(wrc_section_file_read(nullptr, 0.0, 0, 0, &file, nullptr, 0), WRC_ERROR_NULL);
  EXPECT_EQ(wrc_section_file_line(nullptr, 0, nullptr), WRC_ERROR_NULL);
  wrc_section_file_destroy(nullptr);
}

}  // namespace
