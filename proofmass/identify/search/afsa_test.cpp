// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/search/afsa.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <variant>

#include "proofmass/identify/model/design_matrix.hpp"
#include "proofmass/identify/regression/ols.hpp"
#include "proofmass/identify/search/coefficient_space.hpp"
#include "support/endings.hpp"
#include "support/findings.hpp"
#include "support/twin.hpp"

namespace proofmass {
namespace {

IdentifyOptions options_for(const char* terms) { return {.terms = parse_terms(terms)}; }

Identification fitted(const Dataset& record, const IdentifyOptions& options, const Afsa& method = {}) {
  SilentProgress progress;
  return fit(method, record, options, progress);
}

const AfsaDetails& details_of(const Identification& result) { return std::get<AfsaDetails>(result.details); }

Identification least_squares(const Dataset& record, const IdentifyOptions& options) {
  SilentProgress progress;
  return fit(Ols{}, record, options, progress);
}

double farthest(const Identification& found, const Identification& best) {
  double largest = 0.0;
  for (std::size_t k = 0; k < best.coefficients.size(); ++k) {
    const double difference = found.coefficients[k].value - best.coefficients[k].value;
    largest = std::max(largest, std::abs(difference) / best.coefficients[k].standard_error.value());
  }
  return largest;
}

TEST(Afsa, ReachesLeastSquaresOnAllTermsFromAnySeed) {
  const Dataset record = test::make_twin({.rows = 400, .noise = 1e-5});
  IdentifyOptions options = options_for("full");
  const Identification best = least_squares(record, options);
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
    options.seed = seed;
    const Identification found = fitted(record, options);
    EXPECT_LT(farthest(found, best), 0.01) << seed;
    EXPECT_LT(details_of(found).optimum_rmse_ratio, 1.0 + 1e-6) << seed;
  }
}

// Scaled columns alone leave the collinearity of the regressors to the fish, and there they stay behind; what
// matters is that the result says so, and by how much.
TEST(Afsa, SaysHowFarItStaysWhenItStaysFar) {
  const Dataset record = test::make_twin({.rows = 400, .noise = 1e-5});
  const IdentifyOptions options = options_for("paper");
  const Identification best = least_squares(record, options);
  const Identification found =
      fitted(record, options, {.target = {}, .coordinates = FishCoordinates::columns});
  const double distance = farthest(found, best);
  EXPECT_GT(distance, 1.0);
  EXPECT_NEAR(details_of(found).optimum_distance, distance, 1e-6 * distance);
  EXPECT_NEAR(details_of(found).optimum_rmse_ratio,
              found.diagnostics.residual_sd.value() / best.diagnostics.residual_sd.value(), 1e-9 * distance);
  EXPECT_EQ(test::number(test::finding_of(found, Code::search_short_of_optimum), "distance"),
            details_of(found).optimum_distance);
  EXPECT_TRUE(test::has(found, Code::search_errors_added));
  for (std::size_t k = 0; k < best.coefficients.size(); ++k) {
    const Coefficient& c = found.coefficients[k];
    const double ols = best.coefficients[k].standard_error.value();
    EXPECT_NEAR(c.standard_error.value(), std::hypot(ols, c.value - best.coefficients[k].value),
                1e-9 * c.standard_error.value())
        << name(c.term);
  }
}

TEST(Afsa, EndsAtTheTargetAskedFor) {
  const Identification found = fitted(test::make_twin(), options_for("linear"), {.target = 0.1});
  EXPECT_EQ(found.ending.status, EndingStatus::target_reached);
  EXPECT_THAT(test::said(found.ending), testing::HasSubstr("0.1"));
}

// The objective that the fish see, summed over the rows.
TEST(CoefficientSpace, ItsResidualIsThatOfTheRows) {
  const Dataset record = test::make_twin();
  const Matrix design = design_matrix(record, parse_terms("quadratic"));
  for (const auto coordinates : {FishCoordinates::whitened, FishCoordinates::columns}) {
    const CoefficientSpace space(design, record.output, coordinates);
    const std::vector<double> position{0.3, -0.2, 0.7, 0.0, 0.1, -0.5, 0.4, 0.2, -0.1, 0.6};
    ASSERT_EQ(space.dimensions(), position.size());
    const std::vector<double> coefficients = space.coefficients(position);
    double sum = 0.0;
    for (std::size_t r = 0; r < design.rows(); ++r) {
      double residual = record.output[r];
      for (std::size_t c = 0; c < coefficients.size(); ++c) residual -= design(r, c) * coefficients[c];
      sum += residual * residual;
    }
    const double expected = std::sqrt(sum / static_cast<double>(design.rows()));
    EXPECT_NEAR(space.rmse(position), expected, 1e-12 * expected);
  }
}

}  // namespace
}  // namespace proofmass
