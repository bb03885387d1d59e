// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/regression/robust.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <variant>
#include <vector>

#include "proofmass/core/error.hpp"
#include "proofmass/numeric/random.hpp"
#include "support/efficiency.hpp"
#include "support/findings.hpp"
#include "support/twin.hpp"

namespace proofmass {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Identification fitted(const Dataset& record, LossKind loss, const char* terms = "linear",
                      RankLossPolicy policy = RankLossPolicy::refuse) {
  SilentProgress progress;
  return fit(Robust{.loss = loss, .tuning = {}}, record,
             {.terms = parse_terms(terms), .on_rank_loss = policy}, progress);
}

// Required: within 1.15 of the efficient bound, for the noise's own density with its outliers. Twenty seeds
// and 15 correlated terms tell the figure to about 0.03 (one standard deviation).
TEST(Robust, ReachesTheBoundUnderHeavyTailsAndOutliers) {
  const SimulationPlan plan = test::shipped_plan("twin-heavy-tails");
  const IdentifyOptions options{.terms = parse_terms("paper")};
  for (const LossKind loss : {LossKind::huber, LossKind::bisquare, LossKind::student}) {
    const test::Efficiency robust =
        test::measure_efficiency(Robust{.loss = loss, .tuning = {}}, plan, options, 20);
    EXPECT_LT(robust.over_bound, 1.15);
    EXPECT_GT(robust.over_bound, 0.88);  // nothing beats the bound by more than chance
    EXPECT_NEAR(robust.over_stated, 1.0, 0.1);
  }
  EXPECT_GT(test::measure_efficiency(Ols{}, plan, options, 20).over_bound, 4.0);
}

TEST(Robust, ListsOutliersByLineLargestFirst) {
  Dataset record = test::make_twin({.noise = 1e-5});
  for (std::size_t row = 0; row < record.rows(); ++row) record.line.push_back(row + 5);
  record.output[20] += 1e-3;
  record.output[200] -= 2e-3;
  const Identification result = fitted(record, LossKind::bisquare, "paper");
  const auto& [scale, suspects] = std::get<RobustDetails>(result.details);
  ASSERT_EQ(suspects.size(), 2U);
  EXPECT_EQ(suspects[0].line, 205U);
  EXPECT_EQ(suspects[1].line, 25U);
  EXPECT_EQ(suspects[1].row, 21U);
  EXPECT_NEAR(suspects[1].residual, 1e-3, 5e-5);
  EXPECT_NEAR(suspects[0].scaled_residual, -200.0, 40.0);
  EXPECT_EQ(suspects[0].weight, 0.0);
  EXPECT_NEAR(scale, 1e-5, 2e-6);
  const Finding& outlying = test::finding_of(result, Code::outlying_rows);
  EXPECT_EQ(test::number(outlying, "count"), 2.0);
  EXPECT_EQ(test::number(outlying, "total"), 300.0);
  EXPECT_EQ(test::number(outlying, "limit"), 4.0);
  EXPECT_EQ(test::number(outlying, "scale"), scale);
  EXPECT_THAT(outlying.lines, ElementsAre(205U, 25U));
}

TEST(Robust, ExactRecordsStayExactDespiteOutliers) {
  Dataset record = test::make_twin({.noise = 0.0});
  for (std::size_t row = 0; row < record.rows(); row += 7) record.output[row] += 0.01;
  const Identification result = fitted(record, LossKind::bisquare, "paper");
  const StaticModel truth = test::paper_truth();
  for (const Coefficient& c : result.coefficients) {
    EXPECT_NEAR(c.value, truth.coefficient(c.term), 1e-12) << name(c.term);
  }
}

// The two rows that move Ap contradict each other: half way between, both lose their weight.
Dataset pendulous_rows_at_odds() {
  Dataset record =
      test::make_twin({.noise = 1e-5}, {.terms = {Term::K0, Term::Ki}, .coefficients = {1e-3, 0.9}});
  record.acceleration[2].assign(record.rows(), 0.0);
  record.acceleration[2][100] = record.acceleration[2][200] = 10.0;
  record.output[100] += 0.5;
  record.output[200] -= 0.5;
  return record;
}

TEST(Robust, RankLossCountsRowsWithWeightOnly) {
  const Dataset record = pendulous_rows_at_odds();
  try {
    (void)fitted(record, LossKind::bisquare);
    ADD_FAILURE() << "no refusal";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    EXPECT_THAT(error.what(), HasSubstr("rows that have weight"));
    EXPECT_THAT(error.what(), HasSubstr("Kp"));
  }
  const Identification result = fitted(record, LossKind::bisquare, "linear", RankLossPolicy::drop);
  EXPECT_FALSE(result.coefficients[3].identified);
  EXPECT_NEAR(result.coefficients[1].value, 0.9, 1e-5);
}

Dataset line_with_noise(std::size_t rows, std::uint64_t seed, double outliers) {
  Dataset record;
  RandomStream random(seed);
  for (std::size_t row = 0; row < rows; ++row) {
    const double a = random.uniform(-10.0, 10.0);
    record.acceleration[0].push_back(a);
    const bool outlier = random.uniform(0.0, 1.0) < outliers;
    record.output.push_back(1e-3 + a + 1e-5 * random.normal() + (outlier ? 1e-2 : 0.0));
  }
  return record;
}

std::vector<Severity> scale_doubts(const Dataset& record) {
  std::vector<Severity> severities;
  for (const Finding& finding : fitted(record, LossKind::bisquare, "K0,Ki").findings) {
    if (finding.code == Code::scale_doubtful) severities.push_back(finding.severity);
  }
  return severities;
}

TEST(Robust, SaysThatTheScaleOfFewRowsCanHardlyBeChecked) {
  EXPECT_THAT(scale_doubts(line_with_noise(31, 1, 0.0)), ElementsAre(Severity::basis));
  EXPECT_THAT(scale_doubts(line_with_noise(32, 1, 0.0)), ElementsAre());
  const Identification result = fitted(line_with_noise(12, 1, 0.0), LossKind::bisquare, "K0,Ki");
  EXPECT_EQ(test::number(test::finding_of(result, Code::scale_doubtful), "spare"), 10.0);
  int clean = 0;
  int spoilt = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const std::vector<Severity> warning{Severity::warning};
    if (scale_doubts(line_with_noise(30, seed, 0.0)) == warning) ++clean;
    if (scale_doubts(line_with_noise(30, seed, 0.45)) == warning) ++spoilt;
  }
  EXPECT_LE(clean, 3);
  EXPECT_GE(spoilt, 50);
}

TEST(Robust, SaysWhatItUsedAndWhatNot) {
  Dataset record = test::make_twin();
  record.output_sigma.assign(record.rows(), 3e-4);
  const Identification huber = fitted(record, LossKind::huber);
  EXPECT_EQ(test::number(test::finding_of(huber, Code::huber_loss), "tuning"), 1.345);
  const Identification student = fitted(record, LossKind::student);
  EXPECT_EQ(test::word(test::finding_of(student, Code::student_loss), "origin"), "estimated");
  EXPECT_TRUE(test::has(fitted(record, LossKind::bisquare), Code::sigma_output_unused));
}

}  // namespace
}  // namespace proofmass
