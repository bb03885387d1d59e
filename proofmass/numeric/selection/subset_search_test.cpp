// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/selection/subset_search.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "proofmass/numeric/linear/least_squares.hpp"
#include "proofmass/numeric/random.hpp"

namespace proofmass {
namespace {

struct Sample {
  Matrix design;
  std::vector<double> y;
};

// y depends on the even columns. The columns are correlated, so that stepwise search can fail.
Sample make_sample(std::size_t rows, std::size_t columns, double noise, std::uint64_t seed) {
  RandomStream random(seed);
  Sample sample{Matrix(rows, columns), std::vector<double>(rows)};
  for (std::size_t r = 0; r < rows; ++r) {
    const double common = random.normal();
    for (std::size_t c = 0; c < columns; ++c) {
      sample.design(r, c) = random.normal() + common;
      if (c % 2 == 0) sample.y[r] += static_cast<double>(c + 1) * 0.1 * sample.design(r, c);
    }
    sample.y[r] += noise * random.normal();
  }
  return sample;
}

Regression rows_of(const Sample& sample) { return {.design = sample.design, .y = sample.y}; }

Sample rows_between(const Sample& sample, std::size_t first, std::size_t last, Subset subset) {
  Sample part{Matrix(last - first, static_cast<std::size_t>(__builtin_popcount(subset))), {}};
  for (std::size_t r = first; r < last; ++r) {
    part.y.push_back(sample.y[r]);
    std::size_t next = 0;
    for (std::size_t c = 0; c < sample.design.columns(); ++c) {
      if ((subset >> c & 1U) != 0U) part.design(r - first, next++) = sample.design(r, c);
    }
  }
  return part;
}

double prediction(const Matrix& design, std::size_t row, const std::vector<double>& coefficients) {
  double sum = 0.0;
  for (std::size_t c = 0; c < coefficients.size(); ++c) sum += coefficients[c] * design(row, c);
  return sum;
}

std::vector<double> fitted(const Sample& sample) {
  return solve_least_squares(sample.design, sample.y).coefficients;
}

constexpr Subset kSome = 0b1011010;

TEST(SubsetCriterion, PressIsLeaveOneOut) {
  const Sample sample = make_sample(30, 7, 0.5, 1);
  const Sample whole = rows_between(sample, 0, 30, kSome);
  double sum = 0.0;
  for (std::size_t left_out = 0; left_out < 30; ++left_out) {
    Sample others{Matrix(29, whole.design.columns()), {}};
    for (std::size_t r = 0; r < 30; ++r) {
      if (r == left_out) continue;
      for (std::size_t c = 0; c < whole.design.columns(); ++c)
        others.design(others.y.size(), c) = whole.design(r, c);
      others.y.push_back(whole.y[r]);
    }
    sum += std::pow(whole.y[left_out] - prediction(whole.design, left_out, fitted(others)), 2);
  }
  const auto press = press_criterion(rows_of(sample));
  EXPECT_NEAR(press->value(kSome), sum / 30.0, 1e-12 * sum);
  EXPECT_NEAR(press->bound(kSome), solve_least_squares(whole.design, whole.y).rss / 30.0, 1e-12);
}

TEST(SubsetCriterion, RegularityAndUnbiasednessAsDefined) {
  const Sample sample = make_sample(40, 7, 0.5, 2);
  const Sample first = rows_between(sample, 0, 18, 0b1111111);
  const Sample second = rows_between(sample, 18, 40, 0b1111111);
  const std::vector<double> a = fitted(rows_between(sample, 0, 18, kSome));
  const std::vector<double> b = fitted(rows_between(sample, 18, 40, kSome));
  const Sample chosen = rows_between(sample, 0, 40, kSome);
  double regularity = 0.0;
  double unbiasedness = 0.0;
  for (std::size_t r = 0; r < 40; ++r) {
    const double by_a = prediction(chosen.design, r, a);
    unbiasedness += std::pow(by_a - prediction(chosen.design, r, b), 2) / 40.0;
    if (r >= 18) regularity += std::pow(chosen.y[r] - by_a, 2) / 22.0;
  }
  EXPECT_NEAR(regularity_criterion(rows_of(first), rows_of(second))->value(kSome), regularity,
              1e-12 * regularity);
  EXPECT_NEAR(unbiasedness_criterion(rows_of(first), rows_of(second))->value(kSome), unbiasedness,
              1e-12 * unbiasedness);
}

struct Found {
  Subset best = 0;
  double value = std::numeric_limits<double>::infinity();
};

// Every subset of 10 columns, one by one.
Found enumerate(const SubsetCriterion& criterion) {
  Found result;
  for (Subset subset = 1; subset < (Subset{1} << criterion.columns()); ++subset) {
    const double value = criterion.value(subset);
    if (value < result.value) result = {.best = subset, .value = value};
  }
  return result;
}

// Enumerating takes ThreadSanitizer long and starts no thread; how threads share a search depends on no seed.
#ifdef __SANITIZE_THREAD__
constexpr std::uint64_t kSeeds = 1;
#else
constexpr std::uint64_t kSeeds = 20;
#endif

TEST(SubsetSearch, FindsTheBestOfAllSubsets) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Sample sample = make_sample(40, 10, 3.0, seed);
    const Sample first = rows_between(sample, 0, 20, 0b1111111111);
    const Sample second = rows_between(sample, 20, 40, 0b1111111111);
    std::vector<std::unique_ptr<SubsetCriterion>> criteria;
    criteria.push_back(press_criterion(rows_of(sample)));
    criteria.push_back(regularity_criterion(rows_of(first), rows_of(second)));
    criteria.push_back(unbiasedness_criterion(rows_of(first), rows_of(second)));
    for (const auto& criterion : criteria) {
      const Found expected = enumerate(*criterion);
      const SubsetSearchResult found = search_subsets(*criterion, {.beam = 1});
      EXPECT_TRUE(found.proven);
      EXPECT_EQ(found.best, expected.best) << "seed " << seed;
      EXPECT_EQ(found.value, expected.value);
      EXPECT_EQ(found.value_of_size.at(static_cast<std::size_t>(__builtin_popcount(found.best)) - 1),
                found.value);
    }
  }
}

TEST(SubsetSearch, BoundsSpareMostOfTheSubsets) {
  const Sample sample = make_sample(200, 16, 1e-3, 5);
  const SubsetSearchResult found = search_subsets(*press_criterion(rows_of(sample)), {});
  EXPECT_TRUE(found.proven);
  EXPECT_EQ(found.best & 0x5555U, 0x5555U);
  EXPECT_LT(found.evaluations, 2000U);
}

TEST(SubsetSearch, BudgetEndsTheSearchWithoutAProof) {
  const Sample sample = make_sample(60, 12, 3.0, 4);
  const Sample first = rows_between(sample, 0, 30, 0xFFF);
  const Sample second = rows_between(sample, 30, 60, 0xFFF);
  const auto criterion = unbiasedness_criterion(rows_of(first), rows_of(second));
  const SubsetSearchResult stepwise = search_subsets(*criterion, {.models = 0});
  const SubsetSearchResult some = search_subsets(*criterion, {.models = 100});
  EXPECT_FALSE(stepwise.proven);
  EXPECT_FALSE(some.proven);
  EXPECT_LE(some.evaluations, stepwise.evaluations + 100);
  EXPECT_LE(some.value, stepwise.value);
}

TEST(SubsetSearch, WithoutNoiseExactlyTheTrueColumns) {
  const Sample sample = make_sample(60, 14, 0.0, 6);
  const SubsetSearchResult found = search_subsets(*press_criterion(rows_of(sample)), {.floor = 1e-28});
  EXPECT_EQ(found.best, 0x1555U);
  EXPECT_EQ(found.value, 1e-28);
}

TEST(SubsetSearch, ToleranceTakesTheSmallestSubsetWithinIt) {
  const Sample sample = make_sample(40, 10, 3.0, 3);
  const auto criterion = press_criterion(rows_of(sample));
  const SubsetSearchResult least = search_subsets(*criterion, {});
  const SubsetSearchResult small = search_subsets(*criterion, {.tolerance = 0.3});
  EXPECT_LT(__builtin_popcount(small.best), __builtin_popcount(least.best));
  EXPECT_LE(small.value, 1.3 * least.value);
  for (int size = 1; size < __builtin_popcount(small.best); ++size)
    EXPECT_GT(small.value_of_size[static_cast<std::size_t>(size) - 1], 1.3 * least.value);
}

}  // namespace
}  // namespace proofmass
