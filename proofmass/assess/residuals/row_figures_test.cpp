// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/residuals/row_figures.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "proofmass/assess/residuals/record_figures.hpp"
#include "proofmass/assess/residuals/shown_rows.hpp"
#include "proofmass/numeric/random.hpp"
#include "proofmass/pipeline.hpp"

namespace proofmass {
namespace {

Dataset noisy_line(std::size_t rows, std::uint64_t seed) {
  RandomStream random(seed, stream_id("row figures"));
  Dataset record;
  for (std::size_t k = 0; k < rows; ++k) {
    const double a = random.uniform(-3.0, 3.0);
    record.acceleration[0].push_back(a);
    record.output.push_back(1e-3 + 1.01 * a + 1e-4 * a * a + 1e-5 * random.normal());
  }
  return record;
}

const IdentifyOptions kQuadratic{.terms = {Term::K0, Term::Ki, Term::Kii}};

Dataset without(const Dataset& record, std::size_t left_out) {
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < record.rows(); ++row)
    if (row != left_out) rows.push_back(row);
  return record.select(rows);
}

// Cook's distance by its definition: how far all predictions move when a row is left out, D = Σ Δ² / (p s²).
TEST(RowFigures, CooksDistanceIsThatOfAFitWithoutTheRow) {
  const Dataset record = noisy_line(25, 7);
  const auto run = identify(record, Ols{}, kQuadratic);
  const RowFigures figures = row_figures(record, run.split, run.identification);
  const double variance = std::pow(*run.identification.diagnostics.residual_sd, 2);
  for (const std::size_t row : {std::size_t{0}, std::size_t{11}, std::size_t{24}}) {
    const auto other = identify(without(record, row), Ols{}, kQuadratic);
    const std::vector<double> moved = predict(other.identification, record);
    double sum = 0.0;
    for (std::size_t k = 0; k < record.rows(); ++k) sum += std::pow(moved[k] - figures.predicted[k], 2);
    EXPECT_NEAR(figures.cooks_distance[row] / (sum / (3.0 * variance)), 1.0, 1e-6);
  }
  EXPECT_NEAR(std::accumulate(figures.leverage.begin(), figures.leverage.end(), 0.0), 3.0, 1e-9);
}

TEST(RowFigures, OfRowsThatWereNotFittedHaveNoInfluence) {
  const Dataset record = noisy_line(40, 8);
  IdentifyOptions options = kQuadratic;
  options.split = 0.7;
  const auto run = identify(record, Ols{}, options);
  const RowFigures figures = row_figures(record, run.split, run.identification);
  for (const std::size_t row : run.split.test) {
    EXPECT_EQ(figures.parts[row], Part::test);
    EXPECT_TRUE(std::isnan(figures.cooks_distance[row]));
    EXPECT_DOUBLE_EQ(figures.residuals[row], record.output[row] - figures.predicted[row]);
  }
}

TEST(RowFigures, WeighTheRowsAsTheFitDoes) {
  Dataset record = noisy_line(30, 9);
  record.output_sigma.assign(30, 1e-5);
  record.output_sigma[4] = 1e-6;
  const auto run = identify(record, Wls{}, kQuadratic);
  const RowFigures figures = row_figures(record, run.split, run.identification);
  // A row of a tenth of the sigma counts a hundred times: the fit follows it.
  EXPECT_GT(figures.leverage[4], 0.5);
  EXPECT_NEAR(std::accumulate(figures.leverage.begin(), figures.leverage.end(), 0.0), 3.0, 1e-9);
}

TEST(RowFigures, HaveNoInfluenceWhereAFitIsNotLeastSquaresWithKnownWeights) {
  Dataset record = noisy_line(40, 9);
  record.output[7] += 1.0;
  const auto robust = identify(record, Robust{}, kQuadratic);
  EXPECT_TRUE(row_figures(record, robust.split, robust.identification).leverage.empty());
  record.output_sigma.assign(40, 1e-5);
  auto weighted = identify(record, Wls{}, kQuadratic);
  EXPECT_EQ(row_figures(record, weighted.split, weighted.identification).leverage.size(), 40U);
  weighted.identification.row_weights = {};  // as read from a result file
  EXPECT_TRUE(row_figures(record, weighted.split, weighted.identification).leverage.empty());
}

// Sixteen levels in turn: each is drawn about as often as another.
TEST(ShownRows, DoNotFallInWithTheLevelsOfATestPlan) {
  Dataset record;
  for (std::size_t k = 0; k < 57'585; ++k) {
    record.acceleration[0].push_back(static_cast<double>(k % 16) - 8.0);
    record.output.push_back(record.acceleration[0].back() + 1e-9 * static_cast<double>(k % 7));
  }
  const auto run = identify(record, Ols{}, {.terms = {Term::K0, Term::Ki}});
  const RecordFigures figures = record_figures(record, run.split, run.identification);
  std::array<std::size_t, 16> drawn{};
  for (const std::size_t number : figures.numbers) ++drawn.at(number % 16);
  for (const std::size_t count : drawn) EXPECT_GT(count, 150U);
}

TEST(ShownRows, KeepEveryExtremeOfALongRecord) {
  Dataset record = noisy_line(20'000, 10);
  record.acceleration[0][12'345] = 50.0;
  record.output[12'345] = 51.0;
  const auto run = identify(record, Ols{}, kQuadratic);
  const RecordFigures figures = record_figures(record, run.split, run.identification);
  ASSERT_LE(figures.numbers.size(), kMostShownRows);
  ASSERT_GT(figures.numbers.size(), kMostShownRows * 8 / 10);
  EXPECT_EQ(figures.total_rows, 20'000U);
  EXPECT_TRUE(std::is_sorted(figures.numbers.begin(), figures.numbers.end()));
  const std::size_t first = figures.most_influential.front();
  EXPECT_EQ(figures.numbers[first], 12'345U);
  EXPECT_EQ(figures.record.line_of(first), 12'346U);
  EXPECT_EQ(std::accumulate(figures.histogram.counts.begin(), figures.histogram.counts.end(), std::size_t{0}),
            20'000U);
}

}  // namespace
}  // namespace proofmass
