// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/linear/rank_analysis.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "proofmass/numeric/random.hpp"

namespace proofmass {
namespace {

using Columns = std::vector<std::size_t>;

// Columns 1, x, y of random numbers on very different scales; further columns stay zero.
Matrix three_columns(std::size_t rows, std::size_t columns, std::uint64_t seed) {
  RandomStream random(seed);
  Matrix design(rows, columns);
  for (std::size_t r = 0; r < rows; ++r) {
    design(r, 0) = 1.0;
    design(r, 1) = 1e-9 * random.normal();
    design(r, 2) = 1e6 * random.normal();
  }
  return design;
}

RC_GTEST_PROP(RankAnalysis, KeepsEarlierColumnsAndNamesWhatVanishes, (std::uint64_t seed)) {
  Matrix design = three_columns(700, 6, seed);
  RandomStream random(seed, 1);
  for (std::size_t r = 0; r < 700; ++r) {
    design(r, 3) = 5.0 - 2e15 * design(r, 1);  // a combination of columns 0 and 1; column 4 stays zero
    design(r, 5) = random.normal();
  }
  const RankAnalysis analysis = analyse_rank(design);
  RC_ASSERT(analysis.rank == 4U);
  RC_ASSERT((analysis.independent == Columns{0, 1, 2, 5}));
  RC_ASSERT(analysis.null_space.size() == 2U);
  const auto& combination = analysis.null_space[0];
  RC_ASSERT(std::abs(combination[1]) > 0.5);
  RC_ASSERT(std::abs(combination[3]) > 0.5);
  for (const std::size_t absent : Columns{2, 4, 5}) RC_ASSERT(std::abs(combination[absent]) < 1e-12);
  RC_ASSERT((analysis.null_space[1] == std::vector<double>{0, 0, 0, 0, 1, 0}));
}

TEST(RankAnalysis, ConditionOfAKnownMatrix) {
  // Columns (1, 1, 0) and (0, 1e-3, 0): with c = cos 45°, the unit columns have condition sqrt((1 + c) / (1 -
  // c)).
  Matrix design(3, 2);
  design(0, 0) = design(1, 0) = 1.0;
  design(1, 1) = 1e-3;
  const RankAnalysis analysis = analyse_rank(design);
  EXPECT_NEAR(analysis.condition_scaled, 1.0 + std::sqrt(2.0), 1e-14);
  // Singular values s of the raw matrix: s1² + s2² = 2 + 1e-6, s1 s2 = |det| = 1e-3.
  const double sum = 2.0 + 1e-6;
  const double largest = (sum + std::sqrt(sum * sum - 4e-6)) / 2.0;
  EXPECT_NEAR(analysis.condition_raw, largest / 1e-3, 1e-9);
}

TEST(RankAnalysis, NearDependenceAboveRoundingIsNotRankLoss) {
  Matrix design = three_columns(50, 4, 3);
  RandomStream random(4);
  for (std::size_t r = 0; r < 50; ++r) design(r, 3) = design(r, 1) * (1.0 + 1e-10 * random.normal());
  EXPECT_EQ(analyse_rank(design).rank, 4U);
  for (std::size_t r = 0; r < 50; ++r) design(r, 3) = design(r, 1) * (1.0 + 1e-16 * random.normal());
  EXPECT_EQ(analyse_rank(design).rank, 3U);
}

TEST(RankAnalysis, FewerRowsThanColumns) {
  const RankAnalysis analysis = analyse_rank(three_columns(2, 3, 5));
  EXPECT_EQ(analysis.independent, (Columns{0, 1}));
  EXPECT_EQ(analysis.null_space.size(), 1U);
}

TEST(RankAnalysis, RejectsWhatIsNotFinite) {
  Matrix design = three_columns(9, 3, 6);
  design(4, 1) = std::numeric_limits<double>::infinity();
  EXPECT_THROW((void)analyse_rank(design), std::invalid_argument);
  EXPECT_THROW((void)analyse_rank(Matrix(0, 3)), std::invalid_argument);
}

}  // namespace
}  // namespace proofmass
