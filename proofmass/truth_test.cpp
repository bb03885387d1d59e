// SPDX-License-Identifier: Apache-2.0
#include "proofmass/truth.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "proofmass/core/error.hpp"

namespace proofmass {
namespace {

// E = 2 Ai and a slope of 1 in Ao, in V.
SimulationPlan plan() {
  SimulationPlan made;
  made.model = {.terms = {Term::Ki, Term::Ko}, .coefficients = {1.0, 0.5}};
  made.sphere = SphereInputs{};
  made.output_unit = find_unit("V").value();
  made.output_per_g = 2.0;
  made.noise.sigma = 0.1;
  made.rows = 60;
  return made;
}

TEST(RowInformation, IsOneOverTheVarianceOfTheOutput) {
  const SimulationPlan white = plan();
  for (const double value : row_information(white, simulate(white))) EXPECT_DOUBLE_EQ(value, 1.0 / 0.04);
}

TEST(RowInformation, FollowsTheScaleTheDensityAndTheInputs) {
  SimulationPlan growing = plan();
  growing.noise.sigma_per_g = 0.02;
  growing.noise.student_dof = 3.0;
  const Dataset record = simulate(growing);
  const std::vector<double> information = row_information(growing, record);
  const Acceleration a = record.at(5);
  const double variance = 4.0 * (0.01 + 0.0004 * (a.i * a.i + a.o * a.o + a.p * a.p));
  EXPECT_NEAR(information.at(5), (4.0 / 6.0) / variance, 1e-12 * information[5]);

  SimulationPlan inputs = plan();
  inputs.input_sigma = {0.1, 0.2, 0.3};
  const double effective = 0.04 + 4.0 * 0.01 + 1.0 * 0.04;
  EXPECT_NEAR(row_information(inputs, simulate(inputs)).at(0), 1.0 / effective, 1e-8);
}

TEST(RowInformation, IsUnknownWithoutNoiseOrWithBothKindsAtOnce) {
  SimulationPlan exact = plan();
  exact.noise.sigma = 0.0;
  EXPECT_TRUE(row_information(exact, simulate(exact)).empty());
  SimulationPlan both = plan();
  both.noise.outlier_share = 0.01;
  both.noise.outlier_magnitude = 1.0;
  EXPECT_FALSE(row_information(both, simulate(both)).empty());
  both.input_sigma = {0.1, 0.1, 0.1};
  EXPECT_TRUE(row_information(both, simulate(both)).empty());
}

TEST(ScoreTruth, LeastSquaresUnderWhiteNoiseIsAtTheBound) {
  const SimulationPlan white = plan();
  const Dataset record = simulate(white);
  Entry entry{.name = "ols", .method = &find_method("ols"), .options = {}, .split = {}};
  entry.options.terms = white.model.terms;
  SilentProgress progress;
  Comparison comparison = compare(record, std::span(&entry, 1), 40, progress);
  score_truth(comparison, record, std::span(&entry, 1), white);
  const TruthScore& score = comparison.contestants.at(0).truth.value();
  // The 40 splits share one record, so this is one draw of two terms, not eighty.
  EXPECT_GT(score.rms_over_bound.value(), 0.1);
  EXPECT_LT(score.rms_over_bound.value(), 3.0);
  EXPECT_NEAR(score.rms_over_bound.value() / score.rms_over_standard_error.value(), 1.0, 0.25);

  SimulationPlan in_g = white;
  in_g.output_unit = {};
  EXPECT_THROW(score_truth(comparison, record, std::span(&entry, 1), in_g), Error);
}

}  // namespace
}  // namespace proofmass
