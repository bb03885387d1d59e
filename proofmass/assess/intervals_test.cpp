// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/intervals.hpp"

#include <gtest/gtest.h>

namespace proofmass {
namespace {

Identification one_coefficient(double value, double error, std::optional<std::size_t> dof) {
  Identification result;
  Coefficient coefficient;
  coefficient.value = value;
  coefficient.standard_error = error;
  result.coefficients = {coefficient};
  result.diagnostics.dof = dof;
  return result;
}

TEST(Uncertainty, StudentWithTenDegreesOfFreedom) {
  Identification result = one_coefficient(5.0, 2.0, 10);
  add_intervals(result);
  // Tabulated: t(0.975; 10) = 2.228139; two-sided p of t = 2.5 with 10 degrees is 0.031447.
  EXPECT_NEAR(result.coefficients[0].ci95->low, 5.0 - 2.0 * 2.2281388519, 1e-9);
  EXPECT_NEAR(result.coefficients[0].ci95->high, 5.0 + 2.0 * 2.2281388519, 1e-9);
  EXPECT_DOUBLE_EQ(*result.coefficients[0].t, 2.5);
  EXPECT_NEAR(*result.coefficients[0].p, 0.0314468, 1e-6);
}

TEST(Uncertainty, NormalWithoutDegreesOfFreedom) {
  Identification result = one_coefficient(-1.0, 1.0, std::nullopt);
  add_intervals(result);
  EXPECT_NEAR(result.coefficients[0].ci95->high, -1.0 + 1.959963984540054, 1e-12);
  EXPECT_NEAR(*result.coefficients[0].p, 0.31731050786291, 1e-12);
}

TEST(Uncertainty, NothingThatIsNotANumber) {
  Identification exact = one_coefficient(3.0, 0.0, 10);
  add_intervals(exact);
  EXPECT_EQ(exact.coefficients[0].ci95->low, 3.0);
  EXPECT_FALSE(exact.coefficients[0].t.has_value());
  EXPECT_FALSE(exact.coefficients[0].p.has_value());

  Identification saturated = one_coefficient(3.0, 1.0, 0);
  Coefficient lost;
  lost.identified = false;
  lost.standard_error = 1.0;
  saturated.coefficients.push_back(lost);
  add_intervals(saturated);
  for (const Coefficient& coefficient : saturated.coefficients) EXPECT_FALSE(coefficient.ci95.has_value());
}

}  // namespace
}  // namespace proofmass
