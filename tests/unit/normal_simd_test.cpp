#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <memory>
#include <random>
#include <vector>

#include "base/instruction_set.hpp"
#include "kernels/kernels.hpp"
#include "normal/elasticity/contact_condition.hpp"
#include "normal/penetration/penetration.hpp"
#include "normal/simd/tasks.hpp"
#include "normal/strip_halfspace/strip_halfspace.hpp"
#include "normal_gaps.hpp"

namespace wrc::normal {
namespace {

using test::OwnedGap;

const InfluenceTables& tables() {
  static const auto filled = [] {
    auto made = std::make_unique<InfluenceTables>();
    tabulate(*made);
    return made;
  }();
  return *filled;
}

/// The kernels of each set this processor has.
std::vector<const Kernels*> all_kernels() {
  std::vector<const Kernels*> all;
  for (InstructionSet set : {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512}) {
    if (set <= best_instruction_set()) all.push_back(&kernels_for(set));
  }
  return all;
}

/// Every number of a cold solve and of three warm ones after it.
std::vector<double> everything(const Kernels& kernels, OwnedGap gap, double skew, std::int32_t strips) {
  for (std::size_t j = 0; j < gap.y.size(); ++j) gap.centre[j] = skew * gap.y[j];
  std::vector<std::byte> scratch(static_cast<std::size_t>(strip_halfspace_workspace(strips)));
  std::vector<double> memory(static_cast<std::size_t>(4 * strips));
  NormalWorkspace workspace{scratch.data(), static_cast<std::int64_t>(scratch.size())};
  double* const m = memory.data();
  StripHalfspaceStart start{strips, 0, m, m + strips, m + 2 * strips, m + 3 * strips};
  test::StripMemory owned(strips);
  std::vector<double> all;
  for (const double load : {80e3, 82e3, 60e3, 95e3}) {
    NormalSolution solution;
    NormalProblem problem = test::under_load(gap, load, strips);
    problem.kernels = &kernels;
    const Fault fault =
        solve_strip_halfspace(problem, {}, tables(), workspace, start, owned.strips, solution);
    EXPECT_FALSE(fault.failed());
    const patch::Strips& found = owned.strips;
    for (std::int32_t j = 0; j < found.count; ++j)
      for (const double value :
           {found.y[j], found.width[j], found.centre[j], found.half_length[j], found.peak[j]})
        all.push_back(value);
    for (const double value : {solution.approach, solution.area, solution.stiffness, solution.peak_pressure})
      all.push_back(value);
  }
  return all;
}

TEST(NormalInstructionSets, GiveTheSameBits) {
  const auto kernels = all_kernels();
  const OwnedGap gap = test::s1002_on_uic60();
  for (const double skew : {0.0, -0.05, 0.4})
    for (std::int32_t strips = 5; strips <= 75; strips += 7) {  // packs filled and not
      const std::vector<double> baseline = everything(*kernels.front(), gap, skew, strips);
      for (const Kernels* kernel : kernels) {
        const std::vector<double> wide = everything(*kernel, gap, skew, strips);
        ASSERT_EQ(baseline.size(), wide.size());
        ASSERT_EQ(std::memcmp(baseline.data(), wide.data(), baseline.size() * sizeof(double)), 0)
            << strips << " strips, set " << static_cast<int>(kernel->set);
      }
    }
}

TEST(NormalInstructionSets, AreTheOnesAskedFor) {
  for (InstructionSet set : {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512}) {
    if (set <= best_instruction_set()) {
      EXPECT_EQ(kernels_for(set).set, set);
    }
  }
}

/// Strips side by side with half lengths and centres that differ, in arrays as the kernels want them.
struct RowOfStrips {
  static constexpr std::size_t room = 64 + 2 * simd::beyond_sources;
  std::int32_t count;
  std::vector<double> memory;
  double *y, *width, *centre, *inverse_length, *line_load, *edge, *half_width, *found;

  RowOfStrips(std::int32_t strips, double skew) : count(strips), memory(8 * room, 0.0) {
    double* next = memory.data() + simd::beyond_sources;
    for (double** array : {&y, &width, &centre, &inverse_length, &line_load, &edge, &half_width, &found}) {
      *array = next;
      next += room;
    }
    for (std::int32_t j = 0; j < count; ++j) {
      width[j] = 0.5e-3;
      y[j] = 0.5e-3 * j;
      centre[j] = skew * y[j];
      const double half_length = 4e-3 + 0.5e-3 * std::sin(0.4 * j);
      inverse_length[j] = 1.0 / half_length;
      line_load[j] = width[j] * half_length;
      edge[j] = centre[j] + half_length;
      half_width[j] = 0.5 * width[j] * inverse_length[j];
    }
  }
};

TEST(Kernels, InfluenceIsTheDisplacementUnderAStrip) {
  for (const Kernels* kernel : all_kernels())
    for (const std::int32_t count : {1, 7, 16, 33, 60}) {
      const RowOfStrips s(count, 0.0);
      const simd::InfluenceTask task{tables().tables(), count, s.y, s.width, s.centre,
                                     s.inverse_length,  false};
      std::vector<double> row(RowOfStrips::room);
      for (const std::int32_t j : {0, count / 2, count - 1}) {
        kernel->normal.influence_row(task, j, row.data());
        for (std::int32_t i = 0; i < count; ++i) {
          if (i == j) continue;  // left to the caller
          const double from = s.y[i] - s.y[j] - 0.5 * s.width[i];
          const double exact = strip_displacement(1.0 / s.inverse_length[i], from, from + s.width[i]);
          EXPECT_NEAR(row[static_cast<std::size_t>(i)], exact, 2e-3 * exact) << j << " sees " << i;
        }
      }
    }
}

TEST(Kernels, InfluenceOfShiftedStripsFollowsTheQuadrature) {
  for (const Kernels* kernel : all_kernels()) {
    const RowOfStrips s(60, 0.3);
    const simd::InfluenceTask task{tables().tables(), 60, s.y, s.width, s.centre, s.inverse_length, true};
    std::vector<double> row(RowOfStrips::room);
    for (std::int32_t j = 0; j < 60; j += 7) {
      kernel->normal.influence_row(task, j, row.data());
      for (std::int32_t i = 0; i < 60; ++i) {
        if (std::abs(i - j) <= 8) continue;  // corrected for their width
        const double inverse = s.inverse_length[i];
        const double exact = s.width[i] * line_potential(std::abs(s.y[i] - s.y[j]) * inverse,
                                                         std::abs(s.centre[i] - s.centre[j]) * inverse);
        EXPECT_NEAR(row[static_cast<std::size_t>(i)], exact, 2e-3 * exact) << j << " sees " << i;
      }
    }
  }
}

TEST(Kernels, EdgesSeeAllStrips) {
  for (const Kernels* kernel : all_kernels())
    for (const std::int32_t count : {1, 2, 5, 6, 8, 9, 17, 31, 60}) {
      RowOfStrips s(count, 0.1), pairs(count, 0.1);
      // Pair k at the middle of strips k and k + 1, with the line_load of both; the outermost strips alone.
      const auto alone = [&](std::int32_t k, std::int32_t a) {
        pairs.y[k] = s.y[a];
        pairs.centre[k] = s.centre[a];
        pairs.inverse_length[k] = s.inverse_length[a];
        pairs.line_load[k] = s.line_load[a];
      };
      for (std::int32_t k = 0; k + 1 < count; ++k) {
        const double load =
            s.line_load[k] / s.inverse_length[k] + s.line_load[k + 1] / s.inverse_length[k + 1];
        pairs.y[k] = 0.5 * (s.y[k] + s.y[k + 1]);
        pairs.centre[k] = 0.5 * (s.centre[k] + s.centre[k + 1]);
        pairs.inverse_length[k] = 0.5 * (s.inverse_length[k] + s.inverse_length[k + 1]);
        pairs.line_load[k] = load * pairs.inverse_length[k];
      }
      alone(count - 1, count - 1);
      alone(-1, 0);
      kernel->normal.edge_displacements({tables().tables(),
                                         count,
                                         {s.y, s.centre, s.inverse_length, s.line_load},
                                         {pairs.y, pairs.centre, pairs.inverse_length, pairs.line_load},
                                         s.edge,
                                         s.y,
                                         s.half_width,
                                         s.found});
      for (std::int32_t a = 0; a < count; ++a) {
        double exact = s.line_load[a] * tables().own_edge(s.half_width[a]);
        for (std::int32_t b = 0; b < count; ++b)
          if (b != a)
            exact += s.line_load[b] * line_potential(std::abs(s.y[a] - s.y[b]) * s.inverse_length[b],
                                                     std::abs(s.edge[a] - s.centre[b]) * s.inverse_length[b]);
        EXPECT_NEAR(s.found[a], exact, 2e-3 * exact) << "edge " << a << " of " << count;
      }
    }
}

TEST(Kernels, EliminationSolvesTheEquations) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (const Kernels* kernel : all_kernels())
    for (std::int32_t size = 4; size <= 64; size += 4) {
      const auto n = static_cast<std::size_t>(size);
      const auto stride = static_cast<std::size_t>(simd::elimination_stride(size));
      std::vector<double> matrix(n * stride, 0.0), r(stride), s(stride);
      for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n + 2; ++j) matrix[i * stride + j] = uniform(random);
        matrix[i * stride + i] += 0.6 * size;
      }
      const std::vector<double> given = matrix;
      kernel->normal.eliminate({size, simd::elimination_stride(size), matrix.data(), r.data(), s.data()});
      for (std::size_t i = 0; i < n; ++i) {
        double left_r = given[i * stride + n], left_s = given[i * stride + n + 1];
        for (std::size_t j = 0; j < n; ++j) {
          left_r -= given[i * stride + j] * r[j];
          left_s -= given[i * stride + j] * s[j];
        }
        EXPECT_NEAR(left_r, 0.0, 1e-13);
        EXPECT_NEAR(left_s, 0.0, 1e-13);
      }

      // Rows with a place, then eight at a time: the same bits.
      const std::int32_t places = simd::least_places(size);
      std::vector<double> coming = given, other_r(stride), other_s(stride);
      std::vector<double> kept(static_cast<std::size_t>(places) * stride);
      std::copy_n(given.begin(), static_cast<std::size_t>(std::min(places, size)) * stride, kept.begin());
      for (std::int32_t first = 0, end = 0; first < size; first = end) {
        end = std::min(first == 0 ? places : first + 8, size);
        double* const rows =
            first == 0 ? kept.data() : coming.data() + static_cast<std::size_t>(first) * stride;
        kernel->normal.eliminate({size, simd::elimination_stride(size), kept.data(), other_r.data(),
                                  other_s.data(), rows, first, end, places});
      }
      for (std::size_t i = 0; i < n; ++i) {
        EXPECT_EQ(other_r[i], r[i]);
        EXPECT_EQ(other_s[i], s[i]);
      }
    }
}

/// Rows at uneven distances.
OwnedGap uneven_rows() {
  OwnedGap gap;
  for (int j = 0; j < 40; ++j) {
    const double y = 0.5e-3 * (j - 20) + 0.15e-3 * std::sin(2.0 * j);
    gap.y.push_back(y);
    gap.height.push_back(1.2 * y * y + 2e-6 * std::sin(900.0 * y));
    gap.centre.push_back(0.1 * y);
    gap.curvature.push_back(2.2 + 20.0 * y);
  }
  return gap;
}

TEST(Kernels, StripsOfASpanAreThoseOfTheInterpolatedGap) {
  const OwnedGap gap = uneven_rows();
  const patch::GapRows rows = gap.rows();
  const patch::GapMinimum lowest = patch::minimum(rows);
  constexpr double approach = 100e-6;
  const PenetrationScale scale{.at_centre = 0.6, .bend = -2e3, .centre = 1e-3};
  // Inside, over all rows, and in the outermost intervals alone.
  const Span spans[] = {
      {-6e-3, 5e-3}, {rows.y[0], rows.y[39]}, {rows.y[0], rows.y[1]}, {rows.y[38], rows.y[39]}};
  for (const Kernels* kernel : all_kernels())
    for (const Span& span : spans)
      for (const std::int32_t count : {1, 5, 16, 33, 60}) {
        test::StripMemory owned(count);
        patch::Strips& found = owned.strips;
        divide_span(*kernel, rows, lowest, scale, approach, span, count, found);
        ASSERT_EQ(found.count, count);
        for (std::int32_t j = 0; j < count; ++j) {
          const double y = span.y_from + (j + 0.5) * (span.width() / count);
          const patch::GapRow row = patch::interpolate(rows, y);
          const double overlap =
              std::max(scale.at(y) * approach - (row.height - lowest.height), 1e-12 * approach);
          EXPECT_EQ(found.y[j], y);
          EXPECT_EQ(found.width[j], span.width() / count);
          EXPECT_EQ(found.centre[j], row.centre);
          EXPECT_EQ(found.half_length[j], std::sqrt(2.0 * overlap / row.curvature));
        }
      }
}

TEST(Kernels, APointSeesEachStripOnce) {
  // Side by side, and apart as far as the tables reach and beyond; with and without a shift.
  constexpr std::int32_t count = 61;
  constexpr double x = 1e-3, y = 0.3e-3, approach = 80e-6;
  const patch::Material material = test::steel;
  for (const double spread : {1.0, 40.0, 4000.0})
    for (const double skew : {0.0, 0.2}) {
      std::vector<double> peaks;
      for (const Kernels* kernel : all_kernels()) {
        test::StripMemory owned(count);
        patch::Strips& strips = owned.strips;
        strips.count = count;
        double displacement = 0.0, load = 0.0;
        for (std::int32_t j = 0; j < count; ++j) {
          constexpr double width = 0.2e-3;
          strips.y[j] = (j - 28) * width * spread;
          strips.width[j] = width;
          strips.centre[j] = x + skew * (strips.y[j] - y);
          const double l = strips.half_length[j] = 5e-3 * std::sqrt(1.0 - (j - 30.0) * (j - 30.0) / 1000.0);
          const double dy = strips.y[j] - y, shift = strips.centre[j] - x;
          displacement += l * strip_displacement(l, dy - 0.5 * width, dy + 0.5 * width) *
                          std::sqrt((l * l + dy * dy) / (l * l + dy * dy + shift * shift));
          load += 0.5 * pi * l * l * width;
        }
        const double level = approach / (material.normal_compliance() * displacement);
        EXPECT_NEAR(impose_approach(*kernel, approach, material, x, y, strips), level * load,
                    1e-13 * level * load);
        for (std::int32_t j = 0; j < count; ++j)
          EXPECT_NEAR(strips.peak[j], level * strips.half_length[j], 1e-13 * level * strips.half_length[j]);
        std::vector<double> found(strips.peak, strips.peak + count);
        if (peaks.empty()) peaks = found;
        EXPECT_EQ(found, peaks);
      }
    }
}

}  // namespace
}  // namespace wrc::normal
