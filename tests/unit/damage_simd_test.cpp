#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>
#include <vector>

#include "damage/cells.hpp"
#include "kernels/kernels.hpp"
#include "tangential_patches.hpp"

namespace wrc::damage {
namespace {

/// Every number the damage stage gives for a patch, and place and pressure of its cells.
std::vector<double> everything(const patch::Strips& region, int cells, const std::vector<double>& fields,
                               InstructionSet set) {
  const auto field = static_cast<std::size_t>(region.count * cells);
  const test::OwnedGrid grid(cells, set);
  std::vector<double> given(fields), all(4 * field + static_cast<std::size_t>(region.count));
  double* const f = given.data();
  double* const out = all.data();
  const tangential::TangentialFields tangential{f, f + field, f + 2 * field, f + 3 * field};
  const CellDamage found = assess_cells(
      {&region, &tangential, &grid.get().middles, cells, 23.0, 250e6, out, out + field, out + 4 * field},
      kernels_for(set));
  const auto& middles = grid.get().middles;
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < region.count; ++j) {
      double* const at = out + i * region.count + j;
      at[2 * field] = region.centre[j] + middles.place[i] * region.half_length[j];
      at[3 * field] = region.peak[j] * middles.pressure[i];
    }
  }
  for (double value : {found.power, found.peak_power_density, found.fatigue_index}) all.push_back(value);
  return all;
}

TEST(DamageInstructionSets, GiveTheSameBits) {
  std::mt19937 random(31);
  std::uniform_real_distribution<double> traction(-400e6, 400e6), slip(-2e-3, 2e-3);
  for (int strips = 1; strips <= 40; ++strips) {  // packs filled and not
    const int cells = 1 + (7 * strips) % 13;
    const test::OwnedStrips owned = test::sdec_strips(5e-3, 4e-3, 0.3, 70e3, strips);
    const patch::Strips region = owned.get();
    for (int j = 2; j < strips; j += 5) region.peak[j] = 0.0;
    const auto field = static_cast<std::size_t>(strips * cells);
    std::vector<double> fields(4 * field);
    for (std::size_t k = 0; k < fields.size(); ++k)
      fields[k] = k < 2 * field ? traction(random) : slip(random);
    const std::vector<double> baseline = everything(region, cells, fields, InstructionSet::baseline);
    for (InstructionSet set : {InstructionSet::avx2, InstructionSet::avx512}) {
      if (set > best_instruction_set()) continue;
      const std::vector<double> wide = everything(region, cells, fields, set);
      ASSERT_EQ(std::memcmp(baseline.data(), wide.data(), baseline.size() * sizeof(double)), 0)
          << strips << " strips, set " << static_cast<int>(set);
    }
  }
}

TEST(DamageInstructionSets, AreTheOnesAskedFor) {
  for (InstructionSet set : {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512}) {
    if (set > best_instruction_set()) continue;
    EXPECT_EQ(kernels_for(set).set, set);
  }
}

// Against the definitions, term by term; strips and cells fill no pack.
TEST(CellDamage, IsWhatItsEquationsSay) {
  const int strips = 11, cells = 6, field = strips * cells;
  const test::OwnedStrips owned = test::sdec_strips(5e-3, 4e-3, -0.2, 70e3, strips);
  const patch::Strips region = owned.get();
  std::mt19937 random(37);
  std::uniform_real_distribution<double> traction(-400e6, 400e6), slip(-2e-3, 2e-3);
  std::vector<double> fields(4 * field);
  for (int k = 0; k < 4 * field; ++k)
    fields[static_cast<std::size_t>(k)] = k < 2 * field ? traction(random) : slip(random);
  const std::vector<double> all = everything(region, cells, fields, InstructionSet::baseline);
  double power = 0.0;
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < strips; ++j) {
      const int at = i * strips + j;
      const double* f = fields.data() + at;
      const double density = -23.0 * (f[2 * field] * f[0] + f[3 * field] * f[field]);
      const double s = 1.0 - (i + 0.5) * 2.0 / cells;
      const double pressure = region.peak[j] * std::sqrt(1.0 - s * s);
      const double index = (std::hypot(f[0], f[field]) - 250e6) / pressure;
      EXPECT_NEAR(all[static_cast<std::size_t>(at)], density, 1e-12 * std::fabs(density));
      EXPECT_NEAR(all[static_cast<std::size_t>(at + field)], index, 1e-12 * (250e6 / pressure));
      EXPECT_NEAR(all[static_cast<std::size_t>(at + 2 * field)], region.centre[j] + s * region.half_length[j],
                  1e-15);
      EXPECT_NEAR(all[static_cast<std::size_t>(at + 3 * field)], pressure, 1e-12 * pressure);
      power += density * region.width[j] * 2.0 * region.half_length[j] / cells;
    }
  }
  EXPECT_NEAR(all[static_cast<std::size_t>(4 * field + strips)], power, 1e-9 * std::fabs(power));
}

}  // namespace
}  // namespace wrc::damage
