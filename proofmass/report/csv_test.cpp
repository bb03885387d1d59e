// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/csv.hpp"

#include <gtest/gtest.h>

#include <array>
#include <sstream>
#include <stdexcept>

namespace proofmass {
namespace {

Dataset two_rows() {
  Dataset data;
  data.acceleration[0] = {0.1, -1.0};
  data.acceleration[2] = {2.0, 1.0 / 3};
  data.output = {1.0, 0.25};
  data.line = {3, 5};
  data.output_unit = *find_unit("mg");
  return data;
}

TEST(Csv, WritesPredictionsInTheDeclaredUnit) {
  std::ostringstream out;
  const std::array predicted{0.5, 0.5};
  write_predictions(out, two_rows(), predicted, std::array{Part::test, Part::training});
  const double mg = two_rows().output_unit.to_canonical;
  std::ostringstream expected;
  expected << "line,part,Ai[g],Ap[g],E[mg],E_predicted[mg],residual[mg]\n"
           << "3,test,0.1,2," << 1 / mg << "," << 0.5 / mg << "," << 0.5 / mg << "\n"
           << "5,train,-1,0.3333333333333333," << 0.25 / mg << "," << 0.5 / mg << "," << -0.25 / mg << "\n";
  EXPECT_EQ(out.str(), expected.str());
}

TEST(Csv, WritesForecastsOfRecordsWithoutOutput) {
  Dataset inputs = two_rows();
  inputs.output.clear();
  std::ostringstream out;
  write_forecast(out, inputs, std::array{1.5, 2.5}, *find_unit("mA"));
  EXPECT_EQ(out.str(), "Ai[g],Ap[g],E_predicted[mA]\n0.1,2,1.5\n-1,0.3333333333333333,2.5\n");
}

TEST(Csv, WritesCurvesOfDifferentLengths) {
  std::ostringstream out;
  write_history(out, std::vector<Curve>{{.name = "a", .values = {1.0, 0.5}}, {.name = "b", .values = {2.0}}});
  EXPECT_EQ(out.str(), "curve,iteration,value\na,0,1\na,1,0.5\nb,0,2\n");
}

TEST(Csv, RefusesColumnsOfDifferentLengths) {
  std::ostringstream out;
  EXPECT_THROW(write_predictions(out, two_rows(), std::array{1.0}, std::array{Part::test, Part::test}),
               std::invalid_argument);
  EXPECT_THROW(write_forecast(out, two_rows(), std::array{1.0}, Unit{}), std::invalid_argument);
}

}  // namespace
}  // namespace proofmass
