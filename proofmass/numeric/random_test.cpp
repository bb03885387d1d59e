// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <vector>

namespace proofmass {
namespace {

constexpr std::size_t kDraws = 200'000;

std::vector<double> sample(const std::function<double()>& draw) {
  std::vector<double> values(kDraws);
  std::generate(values.begin(), values.end(), draw);
  return values;
}

double mean_power(const std::vector<double>& values, int power) {
  double sum = 0.0;
  for (const double v : values) sum += std::pow(v, power);
  return sum / static_cast<double>(values.size());
}

// sqrt(n) times the Kolmogorov-Smirnov distance. If the distribution is correct, it exceeds 1.95 with
// probability 0.001.
double kolmogorov(std::vector<double> values, const std::function<double(double)>& cdf) {
  std::sort(values.begin(), values.end());
  const auto n = static_cast<double>(values.size());
  double distance = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double p = cdf(values[i]);
    distance = std::max({distance, p - static_cast<double>(i) / n, static_cast<double>(i + 1) / n - p});
  }
  return std::sqrt(n) * distance;
}

double normal_cdf(double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); }

// The known-answer vectors that Random123 publishes for philox4x64 with 10 rounds.
TEST(Random, PhiloxKnownAnswers) {
  using Block = std::array<std::uint64_t, 4>;
  constexpr std::uint64_t ones = ~std::uint64_t{0};
  EXPECT_EQ(philox_block({0, 0, 0, 0}, {0, 0}),
            (Block{0x16554d9eca36314c, 0xdb20fe9d672d0fdc, 0xd7e772cee186176b, 0x7e68b68aec7ba23b}));
  EXPECT_EQ(philox_block({ones, ones, ones, ones}, {ones, ones}),
            (Block{0x87b092c3013fe90b, 0x438c3c67be8d0224, 0x9cc7d7c69cd777b6, 0xa09caebf594f0ba0}));
  EXPECT_EQ(philox_block({0x243f6a8885a308d3, 0x13198a2e03707344, 0xa4093822299f31d0, 0x082efa98ec4e6c89},
                         {0x452821e638d01377, 0xbe5466cf34e90c6c}),
            (Block{0xa528f45403e61d95, 0x38c72dbd566e9788, 0xa5a1610e72fd18b5, 0x57bd43b5e52b7fe6}));
}

TEST(Random, StreamHandsOutTheBlocksOfItsCounterInOrder) {
  RandomStream random(5, 6);
  for (std::uint64_t block = 0; block < 3; ++block) {
    for (const auto word : philox_block({block, 0, 0, 0}, {5, 6})) EXPECT_EQ(random.bits(), word);
  }
}

TEST(Random, UniformIsUniform) {
  RandomStream random(1, stream_id("uniform"));
  const auto values = sample([&] { return random.uniform(); });
  EXPECT_LT(kolmogorov(values, [](double x) { return x; }), 1.95);
  EXPECT_GE(*std::min_element(values.begin(), values.end()), 0.0);
  EXPECT_LT(*std::max_element(values.begin(), values.end()), 1.0);
  for (int k = 0; k < 100; ++k) {
    const double v = random.uniform(1.0, std::nextafter(1.0, 2.0));
    EXPECT_EQ(v, 1.0);
  }
}

TEST(Random, NormalIsNormal) {
  RandomStream random(2, stream_id("normal"));
  const auto values = sample([&] { return random.normal(); });
  EXPECT_LT(kolmogorov(values, normal_cdf), 1.95);
  const double root = std::sqrt(static_cast<double>(kDraws));
  EXPECT_LT(std::abs(mean_power(values, 1)) * root, 4.0);                          // variance of x is 1
  EXPECT_LT(std::abs(mean_power(values, 2) - 1.0) * root, 4.0 * std::sqrt(2.0));   // of x^2, 2
  EXPECT_LT(std::abs(mean_power(values, 3)) * root, 4.0 * std::sqrt(15.0));        // of x^3, 15
  EXPECT_LT(std::abs(mean_power(values, 4) - 3.0) * root, 4.0 * std::sqrt(96.0));  // of x^4, 96
}

// Both numbers of a polar pair are used; they must be independent.
TEST(Random, SuccessiveNormalsAreUncorrelated) {
  RandomStream random(3);
  double products = 0.0;
  double square_products = 0.0;
  for (std::size_t k = 0; k < kDraws; ++k) {
    const double a = random.normal();
    const double b = random.normal();
    products += a * b;
    square_products += (a * a - 1.0) * (b * b - 1.0);
  }
  const double root = std::sqrt(static_cast<double>(kDraws));
  EXPECT_LT(std::abs(products) / root, 4.0);
  EXPECT_LT(std::abs(square_products) / root, 4.0 * 2.0);
}

TEST(Random, GammaHasItsMoments) {
  for (const double shape : {0.5, 1.0, 2.5, 40.0}) {
    RandomStream random(4, stream_id("gamma"));
    const auto values = sample([&] { return random.gamma(shape); });
    const double root = std::sqrt(static_cast<double>(kDraws));
    EXPECT_LT(std::abs(mean_power(values, 1) - shape) * root, 4.0 * std::sqrt(shape)) << shape;
    // The variance of x² is a(a+1)(4a+6).
    EXPECT_LT(std::abs(mean_power(values, 2) - shape * (shape + 1)) * root,
              4.0 * std::sqrt(shape * (shape + 1) * (4 * shape + 6)))
        << shape;
  }
}

// The distribution functions of Student's t with 1, 2 and 4 degrees of freedom are elementary.
TEST(Random, StudentFollowsItsDistribution) {
  const std::map<double, std::function<double(double)>> cdfs{
      {1.0, [](double t) { return 0.5 + std::atan(t) / std::acos(-1.0); }},
      {2.0, [](double t) { return 0.5 + 0.5 * t / std::sqrt(2.0 + t * t); }},
      {4.0,
       [](double t) {
         const double s = t / std::sqrt(4.0 + t * t);
         return 0.5 + 0.75 * (s - s * s * s / 3.0);
       }},
  };
  for (const auto& [dof, cdf] : cdfs) {
    RandomStream random(6, stream_id("student"));
    const double nu = dof;
    EXPECT_LT(kolmogorov(sample([&] { return random.student_t(nu); }), cdf), 1.95) << dof;
  }
}

TEST(Random, SameSeedSameDrawsAndOtherStreamsOtherDraws) {
  RandomStream a(7, 1);
  RandomStream same(7, 1);
  RandomStream other_stream(7, 2);
  RandomStream other_seed(8, 1);
  double with_stream = 0.0;
  double with_seed = 0.0;
  for (std::size_t k = 0; k < kDraws; ++k) {
    const double x = a.normal();
    EXPECT_EQ(x, same.normal());
    with_stream += x * other_stream.normal();
    with_seed += x * other_seed.normal();
  }
  const double root = std::sqrt(static_cast<double>(kDraws));
  EXPECT_LT(std::abs(with_stream) / root, 4.0);
  EXPECT_LT(std::abs(with_seed) / root, 4.0);
}

// The first draws of many neighbouring streams must themselves be a good sequence, because records use one
// stream per row.
TEST(Random, NeighbouringStreamsAreIndependent) {
  std::uint64_t row = 0;
  const auto values = sample([&] { return RandomStream(9, stream_id("row", row++)).uniform(); });
  EXPECT_LT(kolmogorov(values, [](double x) { return x; }), 1.95);
  double products = 0.0;
  for (std::size_t k = 1; k < values.size(); ++k) products += (values[k] - 0.5) * (values[k - 1] - 0.5);
  EXPECT_LT(std::abs(products) * 12.0 / std::sqrt(static_cast<double>(kDraws)), 4.0);
}

TEST(Random, StreamIdsDiffer) {
  std::set<std::uint64_t> ids;
  for (const char* purpose : {"", "a", "b", "split", "swarm"}) {
    for (std::uint64_t index = 0; index < 1000; ++index) ids.insert(stream_id(purpose, index));
  }
  EXPECT_EQ(ids.size(), 5000U);
}

TEST(Random, IndexIsUniform) {
  RandomStream random(10);
  EXPECT_EQ(random.index(1), 0U);
  std::vector<double> counts(7, 0.0);
  for (std::size_t k = 0; k < kDraws; ++k) counts[random.index(7)] += 1.0;
  double chi_square = 0.0;
  const double expected = static_cast<double>(kDraws) / 7.0;
  for (const double c : counts) chi_square += (c - expected) * (c - expected) / expected;
  EXPECT_LT(chi_square, 22.46);  // 99.9 % point with 6 degrees of freedom
}

// Of 8 words scaled to 5 values, three values would get two words each unless the surplus is rejected.
TEST(Random, LargeIndexIsUnbiased) {
  RandomStream random(10);
  constexpr std::size_t large = std::size_t{5} << 61U;
  std::vector<double> counts(5, 0.0);
  for (std::size_t k = 0; k < kDraws; ++k) {
    const std::size_t value = random.index(large);
    ASSERT_LT(value, large);
    counts[value % 5] += 1.0;
  }
  const double expected = static_cast<double>(kDraws) / 5.0;
  for (const double c : counts) EXPECT_NEAR(c, expected, 4.0 * std::sqrt(expected));
}

TEST(Random, PermutationsAreUniform) {
  RandomStream random(11);
  std::map<std::vector<std::size_t>, double> counts;
  for (int k = 0; k < 24'000; ++k) counts[random_permutation(4, random)] += 1.0;
  ASSERT_EQ(counts.size(), 24U);
  double chi_square = 0.0;
  for (const auto& [order, count] : counts) chi_square += (count - 1000.0) * (count - 1000.0) / 1000.0;
  EXPECT_LT(chi_square, 49.73);  // 99.9 % point with 23 degrees of freedom
  EXPECT_TRUE(random_permutation(0, random).empty());
  auto large = random_permutation(1000, random);
  std::sort(large.begin(), large.end());
  for (std::size_t k = 0; k < large.size(); ++k) ASSERT_EQ(large[k], k);
}

}  // namespace
}  // namespace proofmass
