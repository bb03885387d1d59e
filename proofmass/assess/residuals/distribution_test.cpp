// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/residuals/distribution.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "proofmass/numeric/random.hpp"

namespace proofmass {
namespace {

std::vector<double> normal_values(std::size_t count) {
  RandomStream random(3, stream_id("distribution"));
  std::vector<double> values(count);
  for (double& v : values) v = 2.0 + 0.5 * random.normal();
  return values;
}

TEST(Histogram, CountsEveryValueOnceAndExpectsAsManyOfANormalDistribution) {
  const Histogram made = histogram(normal_values(4000));
  EXPECT_EQ(std::accumulate(made.counts.begin(), made.counts.end(), std::size_t{0}), 4000U);
  EXPECT_NEAR(std::accumulate(made.normal_heights.begin(), made.normal_heights.end(), 0.0), 4000.0, 20.0);
  EXPECT_NEAR(made.mean, 2.0, 0.04);
  EXPECT_NEAR(made.sd, 0.5, 0.02);
  double chi_square = 0.0;  // of bins with ten and more expected; about one for each
  std::size_t bins = 0;
  for (std::size_t k = 0; k < made.counts.size(); ++k) {
    if (made.normal_heights[k] < 10.0) continue;
    chi_square +=
        std::pow(static_cast<double>(made.counts[k]) - made.normal_heights[k], 2) / made.normal_heights[k];
    ++bins;
  }
  EXPECT_LT(chi_square, 2.5 * static_cast<double>(bins));
}

TEST(Histogram, HasNoBinsOfValuesThatAreAlikeOrNoNumbers) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(histogram(std::vector<double>{1.0, 1.0, 1.0}).counts.empty());
  EXPECT_TRUE(histogram(std::vector<double>{nan, 1.0}).counts.empty());
  EXPECT_TRUE(histogram(std::vector<double>{-1e308, 0.0, 1e308}).counts.empty());
  EXPECT_TRUE(histogram(std::vector<double>{0.0, 1e-310, 2e-310}).counts.empty());
  EXPECT_TRUE(histogram(std::vector<double>{0.0, 1e-200, 2e-200}).counts.empty());
  EXPECT_LE(histogram(std::vector<double>{0.0, 1.0, 2.0, 3.0, 4.0, 1e9}).counts.size(), 60U);
}

TEST(NormalQuantiles, LieOnALineForNormalValuesAndKeepTheEnds) {
  std::vector<double> values = normal_values(20'000);
  values[77] = 9.0;
  const NormalQuantiles made = normal_quantiles(values);
  EXPECT_LT(made.expected.size(), 1100U);
  EXPECT_EQ(made.observed.back(), 9.0);
  EXPECT_NEAR(made.expected.front(), -made.expected.back(), 1e-9);
  for (std::size_t k = 0; k < made.expected.size(); ++k) {
    const double z = made.expected[k];
    EXPECT_NEAR(made.observed[k], 2.0 + 0.5 * z, std::abs(z) < 2.0 ? 0.05 : 5.0);
  }
}

}  // namespace
}  // namespace proofmass
