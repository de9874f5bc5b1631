// The table of methods: its rows against the enumerations, and against what the manual says of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "contact/methods.hpp"
#include "wrc/wrc.h"

namespace wrc::contact {
namespace {

TEST(Methods, ValuesWithoutARowHaveNone) {
  EXPECT_EQ(normal_method(-1), nullptr);
  EXPECT_EQ(normal_method(WRC_NORMAL_STRIP_HALFSPACE + 1), nullptr);
  EXPECT_EQ(tangential_method(-1), nullptr);
  std::int32_t count = 0;
  while (tangential_method(count) != nullptr) ++count;
  EXPECT_GT(count, static_cast<std::int32_t>(WRC_TANGENTIAL_FORCE_TABLE));
}

TEST(Methods, EveryRowIsComplete) {
  for (std::int32_t value = 0; const NormalMethod* method = normal_method(value); ++value) {
    EXPECT_EQ(method->is.value, value);
    EXPECT_EQ(std::string(method->is.name).find("WRC_NORMAL_"), 0u);
    EXPECT_NE(method->solve == nullptr, method->planar == nullptr);
  }
  for (std::int32_t value = 0; const TangentialMethod* method = tangential_method(value); ++value) {
    EXPECT_EQ(method->is.value, value);
    EXPECT_EQ(std::string(method->is.name).find("WRC_TANGENTIAL_"), 0u);
    EXPECT_NE(method->solve, nullptr);
    EXPECT_FALSE(method->gives_derivatives && !method->gives_tractions);
  }
}

/// Who reads an option, as docs/embedding.md writes it.
std::string readers(Option option) {
  std::string text;
  const auto add = [&](const Enumerator& method, const OptionSet& reads, const std::string& prefix) {
    if (!reads.has(option)) return;
    text += (text.empty() ? "`" : ", `") + std::string(method.name).substr(prefix.size()) + "`";
  };
  for (std::int32_t value = 0; const NormalMethod* method = normal_method(value); ++value)
    add(method->is, method->reads, "WRC_NORMAL_");
  for (std::int32_t value = 0; const TangentialMethod* method = tangential_method(value); ++value)
    add(method->is, method->reads, "WRC_TANGENTIAL_");
  return text;
}

TEST(Methods, TheManualSaysWhoReadsWhat) {
  const struct {
    Option option;
    const char* members;
  } options[] = {{Option::max_iterations, "`config.normal.max_iterations`"},
                 {Option::max_sweeps, "`config.planar.max_sweeps`"},
                 {Option::load_tolerance, "`config.normal.load_tolerance`"},
                 {Option::warm_start, "`config.planar.start`"},
                 {Option::surface_iteration, "`config.surface.tolerance`, `max_work`, `max_iterations`"},
                 {Option::patch_model, "`config.tangential.patch_model`"},
                 {Option::traction_bound, "`config.tangential.bound`"},
                 {Option::flexibility, "`config.tangential.flexibility`"},
                 {Option::force_table, "`config.tangential.force_table`"},
                 {Option::non_steady, "`config.planar.non_steady`"},
                 {Option::surface_memory, "`config.surface.memory`"},
                 {Option::slope_fall, "`friction.slope_limit`, `slope_fall`"},
                 {Option::reduction_factors, "`friction.adhesion_reduction`, `slip_reduction`"}};
  ASSERT_EQ(std::size(options), static_cast<std::size_t>(Option::count));
  std::ifstream file(WRC_DOCS "/embedding.md");
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  ASSERT_FALSE(lines.empty());
  for (const auto& [option, members] : options) {
    const std::string row = "| " + std::string(members) + " | " + readers(option) + " |";
    EXPECT_NE(std::find(lines.begin(), lines.end(), row), lines.end()) << "docs/embedding.md lacks\n" << row;
  }
}

}  // namespace
}  // namespace wrc::contact
