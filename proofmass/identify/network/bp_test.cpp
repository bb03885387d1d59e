// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/network/bp.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "proofmass/core/error.hpp"
#include "proofmass/identify/method.hpp"
#include "proofmass/identify/network/result.hpp"
#include "proofmass/identify/network/starts.hpp"
#include "support/networks.hpp"
#include "support/twin.hpp"

namespace proofmass {
namespace {

using testing::HasSubstr;

IdentifyOptions small(std::size_t hidden = 3, std::size_t epochs = 100) {
  IdentifyOptions options;
  options.terms = parse_terms("paper");
  options.network.hidden = hidden;
  options.network.epochs = epochs;
  return options;
}

Identification identify(const Dataset& record, const IdentifyOptions& options) {
  SilentProgress progress;
  return identify_bp(record, {}, options, progress);
}

const Curve& curve(const Identification& result, std::string_view name) {
  for (const Curve& curve : result.history) {
    if (curve.name == name) return curve;
  }
  throw std::out_of_range(std::string(name));
}

TEST(Bp, OneStartIsTheTextbookMethod) {
  const Dataset record = test::make_twin();
  for (const Trainer kind : {Trainer::lm, Trainer::varpro}) {
    IdentifyOptions options = small();
    options.network.trainer = kind;
    const Identification result = identify(record, options);
    const NetworkTask task = prepare_network(record, {}, options);
    const NetworkTrainer trainer(task.shape, task.samples, nullptr, options.network);
    TrainingState state = trainer.start(random_start(task.shape, kind, options.seed, 0),
                                        RandomStream(options.seed, stream_id("kick", 0)));
    trainer.train(state, options.network.epochs, test::always);
    EXPECT_EQ(result.network->weights, canonical_weights(task.shape, state.weights));
    EXPECT_EQ(result.diagnostics.training_epochs, state.epochs);
    EXPECT_THAT(result.ending.reason, HasSubstr("of 1 candidates"));
  }
}

TEST(Bp, CurveIsInTheDeclaredUnitAndEndsAtTheFit) {
  Dataset record = test::make_twin();
  record.output_unit = find_unit("mV").value();
  const Identification result = identify(record, small());
  const std::vector<double> predicted = predict(result, record);
  double square = 0.0;
  for (std::size_t row = 0; row < predicted.size(); ++row) {
    square += std::pow((predicted[row] - record.output[row]) / record.output_unit.to_canonical, 2);
  }
  const double rmse = std::sqrt(square / static_cast<double>(predicted.size()));
  EXPECT_NEAR(curve(result, "training_rmse").values.back(), rmse, 1e-6 * rmse);
}

TEST(Bp, SpendsWhatTheStartsAreGiven) {
  IdentifyOptions options = small(3, 30);
  options.network.trainer = Trainer::lm;
  options.network.starts = 5;
  options.network.start_epochs = 4;
  const Identification result = identify(test::make_twin(), options);
  // The plain trainer goes on with the best start alone.
  EXPECT_EQ(result.diagnostics.training_epochs, 5U * 4 + 30);
  options.network.trainer = Trainer::varpro;
  options.swarm.refined = 2;
  const Identification projected = identify(test::make_twin(), options);
  EXPECT_EQ(projected.diagnostics.training_epochs, 5U * 4 + 2 * 30);
  EXPECT_THAT(projected.ending.reason, HasSubstr("of 2 candidates"));
}

TEST(Bp, AnotherSeedIsAnotherNetwork) {
  IdentifyOptions options = small(3, 5);
  const Identification one = identify(test::make_twin(), options);
  options.seed = 2;
  EXPECT_NE(identify(test::make_twin(), options).network->weights, one.network->weights);
}

TEST(Bp, SaysHowManyRowsTheNetworkNeeds) {
  const IdentifyOptions options = small(7, 5);
  EXPECT_NO_THROW((void)identify(test::make_twin({.rows = 37}), options));
  try {
    (void)identify(test::make_twin({.rows = 36}), options);
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_data);
    EXPECT_THAT(error.what(), HasSubstr("36 training rows"));
    EXPECT_THAT(error.what(), HasSubstr("at least 37"));
    EXPECT_THAT(error.what(), HasSubstr("3-7-1 network has 36 weights"));
  }
}

TEST(Bp, RefusesANetworkThatCouldNotBeTrained) {
  IdentifyOptions options = small();
  options.network.trainer = Trainer::lm;
  options.network.mu = 1e300;  // beyond the largest damping: no step is even tried
  try {
    (void)identify(test::make_twin(), options);
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    EXPECT_THAT(error.what(), HasSubstr("could not be trained: no step reduces the sum of squares"));
    EXPECT_THAT(error.what(), HasSubstr("R² -"));
  }
  options.network.mu = 1e-3;
  options.network.minimum_gradient = 1e300;  // small enough before the first step
  EXPECT_THROW((void)identify(test::make_twin(), options), Error);
  options.network.minimum_gradient = 0.0;
  options.network.epochs = 1;  // as asked, however poor
  EXPECT_EQ(identify(test::make_twin(), options).ending.status, EndingStatus::iteration_limit);
}

TEST(Bp, TakesAnyHiddenLayer) {
  double before = 1e9;
  for (const std::size_t hidden : {1U, 4U, 12U}) {
    const Identification result = identify(test::make_twin(), small(hidden, 300));
    EXPECT_EQ(result.network->weights.size(), hidden * 5 + 1);
    EXPECT_EQ(*result.diagnostics.dof, 300 - hidden * 5 - 1);
    EXPECT_LT(*result.diagnostics.residual_sd, before) << hidden;
    before = *result.diagnostics.residual_sd;
  }
}

TEST(Bp, TakesRecordsOfOneAndTwoAxes) {
  for (const std::size_t missing : {1U, 2U}) {
    // Truth without the missing axes, which would be noise of no known size.
    const StaticModel truth =
        missing == 2
            ? StaticModel{.terms = parse_terms("K0,Ki,Kii"), .coefficients = {1e-3, 0.9, 2e-4}}
            : StaticModel{.terms = parse_terms("K0,Ki,Kii,Ko"), .coefficients = {1e-3, 0.9, 2e-4, 0.05}};
    Dataset record = test::make_twin({}, truth);
    for (std::size_t axis = 3 - missing; axis < 3; ++axis) record.acceleration[axis].clear();
    IdentifyOptions options = small(5, 500);
    options.terms = truth.terms;
    const Identification result = identify(record, options);
    EXPECT_EQ(result.network->inputs.size(), 3 - missing);
    EXPECT_EQ(result.network->weights.size(), 5 * (3 - missing) + 11);
    for (const Coefficient& c : result.coefficients) {
      EXPECT_NEAR(c.value, truth.coefficient(c.term), 5.0 * *c.standard_error) << name(c.term);
      EXPECT_LT(*c.standard_error, 1e-3) << name(c.term);
    }
  }
}

TEST(Bp, ExpansionHasNoStandardErrorsAndNoKoq) {
  IdentifyOptions options = small(5, 300);
  options.terms = parse_terms("full");
  options.network.extraction = Extraction::taylor;
  const Identification result = identify(test::make_twin(), options);
  EXPECT_TRUE(result.covariance.empty());
  for (const Coefficient& c : result.coefficients) {
    EXPECT_FALSE(c.standard_error.has_value()) << name(c.term);
    EXPECT_EQ(c.identified, c.term != Term::Koq) << name(c.term);
  }
  options.network.extraction = Extraction::projection;
  const Identification projected = identify(test::make_twin(), options);
  EXPECT_EQ(projected.network->weights, result.network->weights);
  EXPECT_EQ(projected.covariance.size(), 21U * 21U);
}

TEST(Bp, StopsWhenTheCallerAsks) {
  IdentifyOptions options = small(7, 1000);
  options.network.starts = 4;
  test::CancelAfter progress(2);
  try {
    (void)identify_bp(test::make_twin(), {}, options, progress);
    ADD_FAILURE() << "went on";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::interrupted);
  }
}

}  // namespace
}  // namespace proofmass
