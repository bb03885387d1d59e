// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/efficient_bound.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace proofmass {
namespace {

TEST(EfficientBound, OutliersFarAwayTakeTheirShareOfTheInformation) {
  EXPECT_DOUBLE_EQ(location_information({}), 1.0);
  EXPECT_DOUBLE_EQ(location_information({.dof = 3.0}), 4.0 / 6.0);
  // Components that do not overlap: each keeps its own information.
  EXPECT_NEAR(location_information({.fraction = 0.1, .distance = 40.0}), 1.0, 1e-6);
  EXPECT_NEAR(location_information({.dof = 3.0, .fraction = 1e-9, .distance = 10.0}), 4.0 / 6.0, 1e-6);
  // Outliers at no distance are none.
  EXPECT_NEAR(location_information({.fraction = 0.3, .distance = 0.0}), 1.0, 1e-6);
  const double overlapping = location_information({.fraction = 0.1, .distance = 3.0});
  EXPECT_LT(overlapping, 0.9);
  EXPECT_GT(overlapping, 0.3);
}

TEST(EfficientBound, IsTheMeansErrorForAConstant) {
  Dataset rows;
  rows.acceleration[0] = {1.0, -1.0, 2.0, -2.0};
  rows.output.assign(4, 0.0);
  const std::vector<double> errors =
      efficient_errors(rows, {Term::K0}, std::vector<double>{4.0, 4.0, 1.0, 1.0});
  EXPECT_NEAR(errors.at(0), 1.0 / std::sqrt(10.0), 1e-15);
}

}  // namespace
}  // namespace proofmass
