// SPDX-License-Identifier: Apache-2.0
#include "proofmass/study/truth.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "proofmass/core/error.hpp"
#include "proofmass/study/compare.hpp"
#include "proofmass/study/truth_doubts.hpp"
#include "support/findings.hpp"

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
  both.noise.outlier_fraction = 0.01;
  both.noise.outlier_magnitude = 1.0;
  EXPECT_FALSE(row_information(both, simulate(both)).empty());
  both.input_sigma = {0.1, 0.1, 0.1};
  EXPECT_TRUE(row_information(both, simulate(both)).empty());
}

TEST(ScoreTruth, LeastSquaresUnderWhiteNoiseIsAtTheBound) {
  const SimulationPlan white = plan();
  const Dataset record = simulate(white);
  const Entry entry{.name = "ols", .method = Ols{}, .options = {.terms = white.model.terms}};
  SilentProgress progress;
  Comparison comparison = compare(record, std::span(&entry, 1), 40, progress);
  score_truth(comparison, record, white);
  const TruthScore& score = comparison.contestants.at(0).truth.value();
  // The 40 splits share one record, so this is one draw of two terms, not eighty.
  EXPECT_GT(score.rms_over_bound.value(), 0.1);
  EXPECT_LT(score.rms_over_bound.value(), 3.0);
  EXPECT_NEAR(score.rms_over_bound.value() / score.rms_over_standard_error.value(), 1.0, 0.25);

  SimulationPlan in_g = white;
  in_g.output_unit = {};
  EXPECT_THROW(score_truth(comparison, record, in_g), Error);
}

// A method that keeps none of the slope in Ao.
Comparison without_ko(const Dataset& record, const Entry& entry, bool by_choice) {
  SilentProgress progress;
  Comparison comparison = compare(record, std::span(&entry, 1), 1, progress);
  Coefficient& ko = comparison.contestants[0].runs[0].identification.coefficients.at(1);
  ko = {};
  ko.term = Term::Ko;
  ko.identified = false;
  ko.left_out = by_choice;
  return comparison;
}

TEST(ScoreTruth, ATermLeftOutByChoiceIsAnEstimateOfZero) {
  const SimulationPlan white = plan();
  const Dataset record = simulate(white);
  const Entry entry{.name = "ols", .method = Ols{}, .options = {.terms = white.model.terms}};
  Comparison chosen = without_ko(record, entry, true);
  score_truth(chosen, record, white);
  EXPECT_EQ(chosen.contestants[0].truth->largest_term, Term::Ko);
  EXPECT_DOUBLE_EQ(chosen.contestants[0].truth->largest_error, 1.0);
  EXPECT_GT(chosen.contestants[0].truth->rms_over_bound.value(), 50.0);

  Comparison lost = without_ko(record, entry, false);
  score_truth(lost, record, white);
  EXPECT_EQ(lost.contestants[0].truth->largest_term, Term::Ki);
  EXPECT_LT(lost.contestants[0].truth->rms_over_bound.value(), 5.0);
}

TEST(DoubtsAboutTruth, AreNoneForTheRecordsOwnPlan) {
  for (const double dof : {0.0, 3.0}) {
    SimulationPlan white = plan();
    if (dof > 0.0) white.noise.student_dof = dof;
    for (const std::size_t rows : {5U, 60U, 2000U}) {
      for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const auto doubts = doubts_about_truth(white, simulate(white, rows, seed), white.source);
        EXPECT_TRUE(doubts.empty()) << to_string(doubts.front().code) << ", rows " << rows << ", seed "
                                    << seed;
      }
    }
  }
}

TEST(DoubtsAboutTruth, NameWhatDoesNotFit) {
  const SimulationPlan white = plan();
  const Dataset record = simulate(white, 500, 1);
  // The only doubt about the record.
  const auto doubt = [&record](const SimulationPlan& truth, const std::string& named) {
    const std::vector<Finding> doubts = doubts_about_truth(truth, record, named);
    EXPECT_EQ(doubts.size(), 1U);
    EXPECT_EQ(doubts.at(0).severity, Severity::warning);
    return doubts.at(0);
  };
  SimulationPlan louder = white;
  louder.noise.sigma = 0.3;
  const Finding quiet = doubt(louder, "");
  EXPECT_EQ(quiet.code, Code::outputs_unlike_plan);
  EXPECT_NEAR(test::number(quiet, "ratio"), 1.0 / 3.0, 0.1);
  SimulationPlan other = white;
  other.model.coefficients[0] = 1.1;
  const Finding distant = doubt(other, "");
  EXPECT_EQ(distant.code, Code::outputs_unlike_plan);
  EXPECT_GT(test::number(distant, "ratio"), 2.0);
  SimulationPlan gentler = white;
  gentler.sphere->maximum = 10.0;
  const Finding beyond = doubt(gentler, "");
  EXPECT_EQ(beyond.code, Code::inputs_unlike_plan);
  EXPECT_EQ(test::number(beyond, "to"), 10.0);
  EXPECT_EQ(test::number(beyond, "from"), white.sphere->minimum);
  EXPECT_GT(test::number(beyond, "largest"), 10.0);
  EXPECT_GE(test::number(beyond, "least"), white.sphere->minimum * (1.0 - 1e-9));
  const Finding misnamed = doubt(white, "another.toml");
  EXPECT_EQ(misnamed.code, Code::other_plan_named);
  EXPECT_EQ(test::word(misnamed, "named"), "another.toml");
  EXPECT_EQ(test::word(misnamed, "plan"), white.source);
  SimulationPlan in_g = white;
  in_g.output_unit = {};
  EXPECT_THROW((void)doubts_about_truth(in_g, record, ""), Error);
}

}  // namespace
}  // namespace proofmass
