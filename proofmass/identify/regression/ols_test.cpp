// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/regression/ols.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "proofmass/core/error.hpp"
#include "support/findings.hpp"
#include "support/nist.hpp"
#include "support/twin.hpp"

namespace proofmass {
namespace {

using testing::HasSubstr;

IdentifyOptions options_for(const char* terms, RankLossPolicy policy = RankLossPolicy::refuse) {
  return {.terms = parse_terms(terms), .on_rank_loss = policy};
}

Identification fitted(const Dataset& record, const char* terms,
                      RankLossPolicy policy = RankLossPolicy::refuse) {
  SilentProgress progress;
  return fit(Ols{}, record, options_for(terms, policy), progress);
}

TEST(Ols, ErrorsAreWhatTheStandardErrorsSay) {
  const StaticModel truth = test::paper_truth();
  double sum = 0.0;
  std::size_t count = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Identification result = fitted(test::make_twin({.noise = 1e-5, .seed = seed}), "full");
    for (const Coefficient& c : result.coefficients) {
      const double ratio = (c.value - truth.coefficient(c.term)) / *c.standard_error;
      EXPECT_LT(std::abs(ratio), 4.5) << name(c.term) << " seed " << seed;
      sum += ratio * ratio;
      ++count;
    }
    EXPECT_NEAR(*result.diagnostics.residual_sd / 1e-5, 1.0, 0.2);
  }
  EXPECT_NEAR(std::sqrt(sum / static_cast<double>(count)), 1.0, 0.06);
}

TEST(Ols, FillsEveryFigure) {
  const Dataset record = test::make_twin();
  const Identification result = fitted(record, "paper");
  EXPECT_EQ(result.method, "ols");
  EXPECT_EQ(result.model, "paper");
  EXPECT_EQ(result.ending.status, EndingStatus::direct);
  EXPECT_EQ(result.coefficients.size(), 15U);
  EXPECT_EQ(result.covariance.size(), 225U);
  EXPECT_DOUBLE_EQ(std::sqrt(result.covariance[16]), *result.coefficients[1].standard_error);
  EXPECT_EQ(*result.diagnostics.dof, 285U);
  EXPECT_GT(*result.diagnostics.r2_adjusted, 0.999999);
  EXPECT_FALSE(result.coefficients[0].vif.has_value());
  EXPECT_GT(*result.coefficients[1].vif, 1.0);
  EXPECT_TRUE(test::has(result, Code::white_noise_assumed));
}

TEST(Ols, CertifiedLoadCell) {
  const auto path = std::filesystem::path(PROOFMASS_REFERENCE_DATA) / "nist" / "linear" / "Pontius.dat";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "reference data absent: " << path;
  const test::NistProblem problem = test::read_nist(path);
  Dataset record;
  record.acceleration[0] = problem.x[0];
  record.output = problem.y;
  const Identification result = fitted(record, "K0,Ki,Kii");
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_GE(test::correct_digits(result.coefficients[k].value, problem.certified[k]), 12.0);
    EXPECT_GE(test::correct_digits(*result.coefficients[k].standard_error, problem.certified_sd[k]), 12.0);
  }
  EXPECT_GE(test::correct_digits(*result.diagnostics.residual_sd, problem.residual_sd), 12.0);
}

TEST(Ols, DroppedTermsAreListedWithTheirReasons) {
  Dataset record = test::make_twin();
  for (double& value : record.acceleration[0]) value = std::abs(value);
  const Identification result = fitted(record, "K0,Ki,Kii,Koq", RankLossPolicy::drop);
  ASSERT_EQ(result.coefficients.size(), 4U);
  EXPECT_FALSE(result.coefficients[3].identified);
  EXPECT_FALSE(result.coefficients[3].standard_error.has_value());
  EXPECT_EQ(result.covariance.size(), 9U);
  const Finding& aliased = test::finding_of(result, Code::term_aliased);
  EXPECT_EQ(aliased.terms, (TermList{Term::Koq, Term::Kii}));
  EXPECT_EQ(result.coefficients[3].reason, aliased);
}

TEST(Ols, WarnsOfCollinearInputsAndUnusedSigmas) {
  Dataset record = test::make_twin();
  record.output_sigma.assign(record.rows(), 3e-4);
  for (std::size_t row = 0; row < record.rows(); ++row) {
    record.acceleration[1][row] = record.acceleration[0][row] + 1e-3 * record.acceleration[1][row];
  }
  const Identification result = fitted(record, "linear");
  EXPECT_TRUE(test::has(result, Code::inputs_collinear));
  EXPECT_TRUE(test::has(result, Code::sigma_output_unused));
}

TEST(Ols, StopsWhenAsked) {
  class Cancelled final : public Progress {
    void update(std::string_view, std::size_t, std::size_t) override {}
    [[nodiscard]] bool cancelled() const noexcept override { return true; }
  } progress;
  try {
    (void)fit(Ols{}, test::make_twin(), options_for("linear"), progress);
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::interrupted);
  }
}

}  // namespace
}  // namespace proofmass
