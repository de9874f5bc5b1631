#include <gtest/gtest.h>

#include <cstring>

#include "base/instruction_set.hpp"
#include "kernels/kernels.hpp"
#include "tangential/methods/fastsim.hpp"
#include "tangential/methods/strip_fastsim.hpp"
#include "tangential_patches.hpp"

namespace wrc::tangential {
namespace {

using test::OwnedGrid;
using test::OwnedStrips;
using test::RandomCase;

using Method = decltype(fastsim);

/// Every number a method gives: forces, sensitivities, fields.
std::vector<double> everything(Method& method, const RandomCase& c, TractionBound bound, int strips,
                               int cells, InstructionSet set) {
  const OwnedStrips region = test::sdec_strips(c.a, c.b, c.psi, c.normal_force, strips);
  const OwnedGrid grid(cells, set);
  const theory::SdecTable table(c.poisson);
  const auto field = static_cast<std::size_t>(strips * cells);
  std::vector<double> all(4 * field);
  Fault fault;
  TangentialSensitivities s;
  const RollingContact contact{region.get(), c.a,         c.b,        c.psi,      c.shear_modulus,
                               &table,       &grid.get(), c.creepage, c.friction, bound};
  double* const p = all.data();
  for (const TangentialForces& f :
       {method(contact, {p, p + field, p + 2 * field, p + 3 * field}, fault, nullptr),
        method(contact, {}, fault, &s)}) {
    for (double value : {f.fx, f.fy, f.mz, f.power_per_speed, f.adhesion_fraction}) all.push_back(value);
  }
  for (const auto& row : s.d) all.insert(all.end(), row, row + 5);
  return all;
}

TEST(InstructionSets, GiveTheSameBits) {
  std::mt19937 random(29);
  for (int n = 0; n < 24; ++n) {
    const RandomCase c = test::random_case(random);
    const int strips = 5 + 3 * n, cells = 7 + 2 * n;  // groups filled and not
    for (Method* method : {&fastsim, &strip_fastsim}) {
      for (TractionBound bound : {TractionBound::parabolic, TractionBound::elliptic}) {
        const std::vector<double> baseline =
            everything(*method, c, bound, strips, cells, InstructionSet::baseline);
        for (InstructionSet set : {InstructionSet::avx2, InstructionSet::avx512}) {
          if (set > best_instruction_set()) continue;
          const std::vector<double> wide = everything(*method, c, bound, strips, cells, set);
          ASSERT_EQ(std::memcmp(baseline.data(), wide.data(), baseline.size() * sizeof(double)), 0)
              << "case " << n << ", set " << static_cast<int>(set);
        }
      }
    }
  }
}

TEST(InstructionSets, AreTheOnesAskedFor) {
  for (InstructionSet set : {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512}) {
    if (set > best_instruction_set()) continue;
    EXPECT_EQ(kernels_for(set).set, set);
    EXPECT_EQ(OwnedGrid(8, set).get().kernels, &kernels_for(set));
  }
}

}  // namespace
}  // namespace wrc::tangential
