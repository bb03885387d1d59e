// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/network/bp.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "proofmass/core/error.hpp"
#include "proofmass/identify/method.hpp"
#include "proofmass/identify/network/result.hpp"
#include "proofmass/identify/network/training/starts.hpp"
#include "support/endings.hpp"
#include "support/findings.hpp"
#include "support/networks.hpp"
#include "support/twin.hpp"

namespace proofmass {
namespace {

using testing::HasSubstr;

Bp small(std::size_t hidden = 3, std::size_t epochs = 100) {
  Bp method;
  method.network.hidden = hidden;
  method.network.training.epochs = epochs;
  return method;
}

IdentifyOptions paper_model(std::uint64_t seed = 1) { return {.terms = parse_terms("paper"), .seed = seed}; }

Identification fitted(const Dataset& record, const Bp& method,
                      const IdentifyOptions& options = paper_model()) {
  SilentProgress progress;
  return fit(method, record, {}, options, progress);
}

const NetworkDetails& details_of(const Identification& result) {
  return std::get<NetworkDetails>(result.details);
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
    Bp method = small();
    method.network.training.trainer = kind;
    const Identification result = fitted(record, method);
    const IdentifyOptions options = paper_model();
    const NetworkTask task = prepare_network(method.network, record, {}, options);
    const NetworkTrainer trainer(task.shape, task.samples, nullptr, method.network.training);
    TrainingState state = trainer.start(random_start(task.shape, kind, options.seed, 0),
                                        RandomStream(options.seed, stream_id("kick", 0)));
    trainer.train(state, method.network.training.epochs, test::always);
    EXPECT_EQ(result.network->weights, canonical_weights(task.shape, state.weights));
    EXPECT_EQ(details_of(result).training_epochs, state.epochs);
    EXPECT_THAT(test::said(result.ending), HasSubstr("of 1 candidate)"));
  }
}

// Least squares with all 21 terms leaves sqrt(39 / 60) of the noise over the rows alone, and all of it over
// its degrees of freedom; so does the network.
TEST(Bp, CallsStructureMisfitAndNotWhiteNoise) {
  const IdentifyOptions options{.terms = linear_terms()};
  const StaticModel linear{.terms = {Term::K0, Term::Ki}, .coefficients = {1e-3, 1.0}};
  const StaticModel crossed{.terms = {Term::K0, Term::Ki, Term::Kop, Term::Koo},
                            .coefficients = {1e-3, 1.0, 1e-3, 1e-3}};
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const test::TwinOptions twin{.rows = 60, .noise = 1e-2, .seed = seed};
    EXPECT_FALSE(test::has(fitted(test::make_twin(twin, linear), small(1), options), Code::network_misfit));
    EXPECT_TRUE(test::has(fitted(test::make_twin(twin, crossed), small(1), options), Code::network_misfit));
  }
}

TEST(Bp, CurveIsInTheDeclaredUnitAndEndsAtTheFit) {
  Dataset record = test::make_twin();
  record.output_unit = find_unit("mV").value();
  const Identification result = fitted(record, small());
  const std::vector<double> predicted = predict(result, record);
  double square = 0.0;
  for (std::size_t row = 0; row < predicted.size(); ++row) {
    square += std::pow((predicted[row] - record.output[row]) / record.output_unit.to_canonical, 2);
  }
  const double rmse = std::sqrt(square / static_cast<double>(predicted.size()));
  EXPECT_NEAR(curve(result, "training_rmse").values.back(), rmse, 1e-6 * rmse);
}

TEST(Bp, SpendsWhatTheStartsAreGiven) {
  Bp method = small(3, 30);
  method.network.training.trainer = Trainer::lm;
  method.starts = 5;
  method.start_epochs = 4;
  const Identification result = fitted(test::make_twin(), method);
  // The plain trainer goes on with the best start alone.
  EXPECT_EQ(details_of(result).training_epochs, 5U * 4 + 30);
  method.network.training.trainer = Trainer::varpro;
  method.refined = 2;
  const Identification projected = fitted(test::make_twin(), method);
  EXPECT_EQ(details_of(projected).training_epochs, 5U * 4 + 2 * 30);
  EXPECT_THAT(test::said(projected.ending), HasSubstr("of 2 candidates"));
}

TEST(Bp, AnotherSeedIsAnotherNetwork) {
  const Identification one = fitted(test::make_twin(), small(3, 5));
  const Identification two = fitted(test::make_twin(), small(3, 5), paper_model(2));
  EXPECT_NE(two.network->weights, one.network->weights);
}

TEST(Bp, SaysHowManyRowsTheNetworkNeeds) {
  const Bp method = small(7, 5);
  EXPECT_NO_THROW((void)fitted(test::make_twin({.rows = 37}), method));
  try {
    (void)fitted(test::make_twin({.rows = 36}), method);
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_data);
    EXPECT_THAT(error.what(), HasSubstr("36 training rows"));
    EXPECT_THAT(error.what(), HasSubstr("at least 37"));
    EXPECT_THAT(error.what(), HasSubstr("3-7-1 network has 36 weights"));
  }
}

TEST(Bp, RefusesANetworkThatCouldNotBeTrained) {
  Bp method = small();
  method.network.training.trainer = Trainer::lm;
  method.network.training.mu = 1e300;  // beyond the largest damping: no step is even tried
  try {
    (void)fitted(test::make_twin(), method);
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    EXPECT_THAT(error.what(), HasSubstr("could not be trained"));
    EXPECT_THAT(sentence(error.ending(), Language::en), HasSubstr("no step reduces the sum of squares"));
    EXPECT_THAT(error.what(), HasSubstr("R² -"));
  }
  method.network.training.mu = 1e-3;
  method.network.training.minimum_gradient = 1e300;  // small enough before the first step
  EXPECT_THROW((void)fitted(test::make_twin(), method), Error);
  method.network.training.minimum_gradient = 0.0;
  method.network.training.epochs = 1;  // as asked, however poor
  EXPECT_EQ(fitted(test::make_twin(), method).ending.status, EndingStatus::iteration_limit);
}

// The pipeline chooses the size by trial; the method itself needs a number.
TEST(Bp, DoesNotSearchForItsSize) {
  Bp method = small();
  method.network.hidden.reset();
  try {
    (void)fitted(test::make_twin(), method);
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
    EXPECT_THAT(error.what(), HasSubstr("hidden"));
  }
}

TEST(Bp, TakesAnyHiddenLayer) {
  double before = 1e9;
  for (const std::size_t hidden : {1U, 4U, 12U}) {
    const Identification result = fitted(test::make_twin(), small(hidden, 300));
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
    const Identification result = fitted(record, small(5, 500), {.terms = truth.terms});
    EXPECT_EQ(result.network->inputs.size(), 3 - missing);
    EXPECT_EQ(result.network->weights.size(), 5 * (3 - missing) + 11);
    for (const Coefficient& c : result.coefficients) {
      EXPECT_NEAR(c.value, truth.coefficient(c.term), 5.0 * *c.standard_error) << name(c.term);
      EXPECT_LT(*c.standard_error, 1e-3) << name(c.term);
    }
  }
}

TEST(Bp, ExpansionHasNoStandardErrorsAndNoKoq) {
  const IdentifyOptions full{.terms = parse_terms("full")};
  Bp method = small(5, 300);
  method.network.extraction = Extraction::taylor;
  const Identification result = fitted(test::make_twin(), method, full);
  EXPECT_TRUE(result.covariance.empty());
  for (const Coefficient& c : result.coefficients) {
    EXPECT_FALSE(c.standard_error.has_value()) << name(c.term);
    EXPECT_EQ(c.identified, c.term != Term::Koq) << name(c.term);
  }
  method.network.extraction = Extraction::projection;
  const Identification projected = fitted(test::make_twin(), method, full);
  EXPECT_EQ(projected.network->weights, result.network->weights);
  EXPECT_EQ(projected.covariance.size(), 21U * 21U);
}

TEST(Bp, StopsWhenTheCallerAsks) {
  Bp method = small(7, 1000);
  method.starts = 4;
  test::CancelAfter progress(2);
  try {
    (void)fit(method, test::make_twin(), {}, paper_model(), progress);
    ADD_FAILURE() << "went on";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::interrupted);
  }
}

}  // namespace
}  // namespace proofmass
