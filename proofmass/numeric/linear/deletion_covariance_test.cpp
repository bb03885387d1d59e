// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/linear/deletion_covariance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

#include "proofmass/numeric/linear/weighted_least_squares.hpp"
#include "proofmass/numeric/random.hpp"

namespace proofmass {
namespace {

constexpr std::size_t kClusteredRows = 80;
constexpr std::size_t kClusteredColumns = 3;
constexpr std::size_t kClusters = 9;

struct Clustered {
  Matrix design{kClusteredRows, kClusteredColumns};
  std::vector<double> y = std::vector<double>(kClusteredRows);
  std::vector<double> weights = std::vector<double>(kClusteredRows);
  std::vector<std::size_t> group = std::vector<std::size_t>(kClusteredRows);
};

Clustered make_clustered() {
  RandomStream random(7, stream_id("deletion covariance"));
  Clustered made;
  for (std::size_t row = 0; row < kClusteredRows; ++row) {
    const double x = random.uniform(-2.0, 2.0);
    for (std::size_t c = 0; c < kClusteredColumns; ++c)
      made.design(row, c) = std::pow(x, static_cast<double>(c));
    made.y[row] = 1.0 - x + (0.1 + 0.2 * x * x) * random.normal();
    made.weights[row] = random.uniform(0.2, 2.0);
    made.group[row] = row % kClusters;
  }
  return made;
}

std::vector<double> coefficients_by(const Clustered& made, std::span<const double> weights) {
  return solve_weighted_least_squares(made.design, made.y, {weights.begin(), weights.end()}).coefficients;
}

std::vector<double> residuals_left(const Clustered& made) {
  const std::vector<double> b = coefficients_by(made, made.weights);
  std::vector<double> residuals = made.y;
  for (std::size_t row = 0; row < kClusteredRows; ++row)
    for (std::size_t c = 0; c < kClusteredColumns; ++c) residuals[row] -= made.design(row, c) * b[c];
  return residuals;
}

// From fits without each group.
Matrix by_refitting(const Clustered& made, const std::vector<std::size_t>& group, std::size_t groups) {
  const std::vector<double> all = coefficients_by(made, made.weights);
  Matrix sum(kClusteredColumns, kClusteredColumns);
  for (std::size_t g = 0; g < groups; ++g) {
    std::vector<double> weights = made.weights;
    for (std::size_t row = 0; row < kClusteredRows; ++row)
      if (group[row] == g) weights[row] = 0.0;
    const std::vector<double> others = coefficients_by(made, weights);
    for (std::size_t r = 0; r < kClusteredColumns; ++r)
      for (std::size_t c = 0; c < kClusteredColumns; ++c)
        sum(r, c) += (all[r] - others[r]) * (all[c] - others[c]);
  }
  return sum;
}

TEST(DeletionCovariance, IsTheSpreadOfFitsWithoutEachRowOrGroup) {
  const Clustered made = make_clustered();
  const std::vector<double> residuals = residuals_left(made);
  const MatrixRows rows(made.design, made.y);
  const EstimatingRows fit{.rows = rows, .residuals = residuals, .weights = made.weights};
  std::vector<std::size_t> alone(kClusteredRows);
  std::iota(alone.begin(), alone.end(), std::size_t{0});

  const Matrix hc3 = deletion_covariance(fit).covariance;
  const Matrix hc3_expected = by_refitting(made, alone, kClusteredRows);
  const Matrix cr3 = deletion_covariance(fit, made.group, kClusters).covariance;
  const Matrix cr3_expected =
      scaled(by_refitting(made, made.group, kClusters), (kClusters - 1.0) / kClusters);
  for (std::size_t r = 0; r < kClusteredColumns; ++r) {
    for (std::size_t c = 0; c < kClusteredColumns; ++c) {
      EXPECT_NEAR(hc3(r, c), hc3_expected(r, c), 1e-9 * std::sqrt(hc3_expected(r, r) * hc3_expected(c, c)));
      EXPECT_NEAR(cr3(r, c), cr3_expected(r, c), 1e-9 * std::sqrt(cr3_expected(r, r) * cr3_expected(c, c)));
    }
  }
}

// Slopes in place of the weights: a loss that is flat at half of the rows doubles every change.
TEST(DeletionCovariance, DividesByTheSlopesOfTheLoss) {
  const Clustered made = make_clustered();
  const std::vector<double> residuals = residuals_left(made);
  const MatrixRows rows(made.design, made.y);
  std::vector<double> slopes = made.weights;
  for (double& slope : slopes) slope *= 0.5;
  const EstimatingRows steep{.rows = rows, .residuals = residuals, .weights = made.weights};
  const EstimatingRows flat{.rows = rows, .residuals = residuals, .weights = made.weights, .slopes = slopes};
  const double ratio = deletion_covariance(flat, made.group, kClusters).covariance(1, 1) /
                       deletion_covariance(steep, made.group, kClusters).covariance(1, 1);
  EXPECT_NEAR(ratio, 4.0, 1e-9);
}

TEST(DeletionCovariance, NamesTheGroupThatTheOthersCannotReplace) {
  Clustered made = make_clustered();
  for (std::size_t row = 0; row < kClusteredRows; ++row) {
    if (made.group[row] != 4) made.design(row, 2) = 0.0;
  }
  const std::vector<double> residuals = residuals_left(made);
  const MatrixRows rows(made.design, made.y);
  const DeletionCovariance found = deletion_covariance(
      {.rows = rows, .residuals = residuals, .weights = made.weights}, made.group, kClusters);
  EXPECT_EQ(found.undetermined, 4U);
  EXPECT_EQ(found.covariance.rows(), 0U);
}

}  // namespace
}  // namespace proofmass
