// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/metrics.hpp"

#include <gtest/gtest.h>

#include <span>
#include <stdexcept>
#include <vector>

namespace proofmass {
namespace {

TEST(Metrics, ByHand) {
  const std::vector<double> measured{1.0, 0.0, -2.0, 5.0};
  const std::vector<double> predicted{1.5, 1.0, -2.0, 4.0};
  const Metrics metrics = score(measured, predicted);
  EXPECT_EQ(metrics.n, 4U);
  EXPECT_DOUBLE_EQ(metrics.mae, 2.5 / 4.0);
  EXPECT_DOUBLE_EQ(metrics.mse, 2.25 / 4.0);
  EXPECT_DOUBLE_EQ(metrics.rmse, 0.75);
  EXPECT_DOUBLE_EQ(*metrics.mape_percent, 100.0 * (0.5 + 0.0 + 0.2) / 3.0);  // the zero is left out
  EXPECT_DOUBLE_EQ(*metrics.r2, 1.0 - 2.25 / 26.0);
}

TEST(Metrics, ScaleConvertsErrorsAlone) {
  const std::vector<double> measured{1.0, 3.0};
  const std::vector<double> predicted{2.0, 3.0};
  const Metrics metrics = score(measured, predicted, 1000.0);
  EXPECT_DOUBLE_EQ(metrics.mae, 500.0);
  EXPECT_DOUBLE_EQ(metrics.mse, 5e5);
  EXPECT_DOUBLE_EQ(*metrics.mape_percent, 50.0);
  EXPECT_DOUBLE_EQ(*metrics.r2, 0.5);
}

// Errors relative to outputs below a hundredth of the range would say nothing.
TEST(Metrics, PercentageErrorLeavesOutOutputsNearZero) {
  const std::vector<double> measured{100.0, 1.0, 0.5, -0.5, 0.0};
  const std::vector<double> predicted{110.0, 2.0, 5.0, 7.0, 3.0};
  const Metrics metrics = score(measured, predicted);
  EXPECT_EQ(metrics.n, 5U);
  EXPECT_EQ(metrics.mape_rows, 1U) << "the range is 100.5";
  EXPECT_DOUBLE_EQ(*metrics.mape_percent, 10.0);
  const Metrics positive = score(std::span(measured).first(3), std::span(predicted).first(3), -2.0);
  EXPECT_EQ(positive.mape_rows, 2U) << "the range is 99.5";
  EXPECT_DOUBLE_EQ(*positive.mape_percent, 55.0);
}

TEST(Metrics, AbsentWhereUndefined) {
  const std::vector<double> zero{0.0, 0.0};
  EXPECT_FALSE(score(zero, zero).mape_percent.has_value());
  // A mean of equal values may round; the output still does not vary.
  const std::vector<double> constant(7, 0.1);
  EXPECT_FALSE(score(constant, std::vector<double>(7, 0.2)).r2.has_value());
  EXPECT_THROW((void)score({}, {}), std::invalid_argument);
  EXPECT_THROW((void)score(zero, constant), std::invalid_argument);
}

}  // namespace
}  // namespace proofmass
