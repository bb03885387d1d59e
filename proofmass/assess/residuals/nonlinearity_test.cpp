// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/residuals/nonlinearity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace proofmass {
namespace {

Identification curved() {
  Identification result;
  for (const auto& [term, value] :
       {std::pair{Term::K0, 5.0}, {Term::Kii, 2.0}, {Term::Ko, 0.0}, {Term::Kiii, -1.0}}) {
    Coefficient& added = result.coefficients.emplace_back();
    added.term = term;
    added.value = value;
    added.identified = term != Term::Ko;
  }
  result.covariance = {1.0, 0.0, 0.0, 0.0, 0.04, -0.01, 0.0, -0.01, 0.09};
  result.input_range = {{Axis::input, {-2.0, 4.0}}};
  return result;
}

TEST(Nonlinearity, IsTheCurveOfTheTermsOfAiWithItsDeltaMethodBand) {
  const Nonlinearity made = nonlinearity_of(curved());
  ASSERT_FALSE(made.input.empty());
  EXPECT_EQ(made.input.front(), -2.0);
  EXPECT_EQ(made.input.back(), 4.0);
  EXPECT_DOUBLE_EQ(made.value.back(), 2.0 * 16.0 - 64.0);
  // var = 16² 0.04 + 64² 0.09 - 2 16 64 0.01, times the normal factor: no degrees of freedom are stated.
  EXPECT_NEAR(made.half_width.back(), 1.959964 * std::sqrt(256.0 * 0.04 + 4096.0 * 0.09 - 2048.0 * 0.01),
              1e-5);
}

TEST(Nonlinearity, IsAbsentWithoutSuchTermsOrARange) {
  Identification result = curved();
  result.coefficients[1].identified = result.coefficients[3].identified = false;
  EXPECT_TRUE(nonlinearity_of(result).input.empty());
  result = curved();
  result.input_range.clear();
  EXPECT_TRUE(nonlinearity_of(result).input.empty());
  result = curved();
  result.covariance.clear();
  EXPECT_TRUE(nonlinearity_of(result).half_width.empty());
  EXPECT_TRUE(correlations_of(result).empty());
}

TEST(Correlations, DivideTheCovarianceByTheStandardErrors) {
  const std::vector<double> made = correlations_of(curved());
  ASSERT_EQ(made.size(), 9U);
  EXPECT_NEAR(made[5], -0.01 / (0.2 * 0.3), 1e-12);
  EXPECT_EQ(made[0], 1.0);
}

}  // namespace
}  // namespace proofmass
