// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/network/training/trainer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "proofmass/identify/model/ending_of.hpp"
#include "proofmass/identify/network/scaling.hpp"
#include "proofmass/numeric/network/perceptron_kernels.hpp"
#include "support/endings.hpp"
#include "support/networks.hpp"
#include "support/twin.hpp"

namespace proofmass {
namespace {

using testing::HasSubstr;

constexpr PerceptronShape kShape{3, 7};

double rmse(const std::vector<double>& weights, const Samples& samples) {
  return std::sqrt(perceptron_sse(kShape, weights, samples) / static_cast<double>(samples.rows()));
}

// Few rows and much noise, so that training soon fits the noise.
struct Overfitting {
  Dataset training = test::make_twin({.rows = 60, .noise = 2.0});
  Dataset other = test::make_twin({.rows = 60, .noise = 2.0, .seed = 2});
  TrainedNetwork scaling = learn_scaling(training);
  Samples samples = scale_rows(scaling, training);
  Samples validation = scale_rows(scaling, other);
};

TrainingOptions options_for(Trainer trainer) {
  TrainingOptions options;
  options.trainer = trainer;
  return options;
}

class EachTrainer : public testing::TestWithParam<Trainer> {
 protected:
  const TrainingOptions options_ = options_for(GetParam());
  const std::vector<double> start_ = random_start(kShape, GetParam(), 1, 0);
  const Overfitting data_{};
};

TEST_P(EachTrainer, NeverGetsWorseAndTellsItsError) {
  const NetworkTrainer trainer(kShape, data_.samples, nullptr, options_);
  TrainingState state = trainer.start(start_);
  EXPECT_NEAR(state.training_rmse, rmse(state.weights, data_.samples), 1e-12);
  trainer.train(state, 40, test::always);
  EXPECT_EQ(state.epochs, 40U);
  ASSERT_EQ(state.training_curve.size(), 41U);
  EXPECT_TRUE(std::is_sorted(state.training_curve.rbegin(), state.training_curve.rend()));
  EXPECT_EQ(state.training_curve.back(), state.training_rmse);
  EXPECT_NEAR(state.training_rmse, rmse(state.weights, data_.samples), 1e-9 * state.training_rmse);
  EXPECT_LT(state.training_rmse, 0.8 * state.training_curve.front());
  EXPECT_EQ(trainer.merit(state), state.training_rmse);
  EXPECT_TRUE(state.validation_curve.empty());
}

TEST(VariableProjection, IsPerturbedUntilThatNoLongerHelps) {
  const Overfitting data;
  const std::vector<double> start = random_start(kShape, Trainer::varpro, 1, 0);
  TrainingOptions options;
  options.perturbations = 0;
  const NetworkTrainer calm(kShape, data.samples, nullptr, options);
  TrainingState at_rest = calm.start(start);
  calm.train(at_rest, 3000, test::always);
  EXPECT_EQ(at_rest.perturbations, 0U);
  EXPECT_TRUE(at_rest.finished);

  options.perturbations = 2;
  const NetworkTrainer trainer(kShape, data.samples, nullptr, options);
  TrainingState whole = trainer.start(start);
  trainer.train(whole, 3000, test::always);
  EXPECT_TRUE(whole.finished);
  EXPECT_GE(whole.perturbations, 2U);
  EXPECT_EQ(whole.idle_perturbations, 2U);
  EXPECT_LE(whole.training_rmse, at_rest.training_rmse);
  EXPECT_NEAR(whole.training_rmse, rmse(whole.weights, data.samples), 1e-9 * whole.training_rmse);
  EXPECT_EQ(whole.training_curve.back(), whole.training_rmse);

  const std::string reason = test::said(ending_of(whole.termination));
  trainer.train(whole, 100, test::always);
  EXPECT_EQ(test::said(ending_of(whole.termination)), reason);

  // Validation rows stop training in another way.
  const NetworkTrainer watched(kShape, data.samples, &data.validation, options);
  TrainingState state = watched.start(start);
  watched.train(state, 3000, test::always);
  EXPECT_EQ(state.perturbations, 0U);
}

TEST_P(EachTrainer, StopsEarlyAndKeepsTheBestValidationWeights) {
  const NetworkTrainer trainer(kShape, data_.samples, &data_.validation, options_);
  TrainingState state = trainer.start(start_);
  trainer.train(state, 1000, test::always);
  EXPECT_TRUE(state.finished);
  EXPECT_EQ(state.termination.cause, Cause::stopped);
  EXPECT_THAT(test::said(ending_of(state.termination)), HasSubstr("did not improve in 6 epochs"));

  const auto& curve = state.validation_curve;
  const auto best = std::min_element(curve.begin(), curve.end());
  EXPECT_EQ(curve.end() - best, 7) << "the best epoch and six failures";
  EXPECT_EQ(curve.size(), state.epochs + 1);
  EXPECT_EQ(state.validation_rmse, *best);
  EXPECT_EQ(trainer.merit(state), *best);
  EXPECT_NEAR(rmse(state.weights, data_.validation), *best, 1e-12);
  // The training error is that of the same epoch, not of the last.
  EXPECT_EQ(state.training_rmse, state.training_curve[static_cast<std::size_t>(best - curve.begin())]);
  EXPECT_LT(state.training_curve.back(), state.training_rmse);

  const std::vector<double> weights = state.weights;
  trainer.train(state, 100, test::always);
  EXPECT_EQ(state.weights, weights) << "a finished network was trained";
}

TEST_P(EachTrainer, WaitsAsManyEpochsAsAsked) {
  TrainingOptions options = options_;
  options.validation_failures = 2;
  const NetworkTrainer trainer(kShape, data_.samples, &data_.validation, options);
  TrainingState state = trainer.start(start_);
  trainer.train(state, 1000, test::always);
  const auto& curve = state.validation_curve;
  EXPECT_EQ(curve.end() - std::min_element(curve.begin(), curve.end()), 3);
}

TEST_P(EachTrainer, EndsWhenTheCallerSaysSo) {
  const NetworkTrainer trainer(kShape, data_.samples, nullptr, options_);
  TrainingState state = trainer.start(start_);
  int asked = 0;
  trainer.train(state, 40, [&asked] { return ++asked < 3; });
  EXPECT_EQ(asked, 3);
  EXPECT_EQ(state.epochs, 3U);
}

INSTANTIATE_TEST_SUITE_P(Both, EachTrainer, testing::Values(Trainer::varpro, Trainer::lm),
                         [](const auto& trainer) {
                           return trainer.param == Trainer::varpro ? "varpro" : "lm";
                         });

// With and without validation rows: a pause costs no patience and does not lose the place.
TEST(VariableProjection, IsPolishedFromWhereItRests) {
  const Overfitting data;
  TrainingOptions options;
  const NetworkTrainer trainer(kShape, data.samples, nullptr, options);
  TrainingState state = trainer.start(random_start(kShape, Trainer::varpro, 1, 0));
  trainer.train(state, 5, test::always);
  const TrainingState unfinished = state;
  trainer.polish(state, 100, test::always);
  EXPECT_EQ(state.epochs, unfinished.epochs);  // it does not rest yet

  trainer.train(state, 3000, test::always);
  ASSERT_TRUE(state.finished);
  const TrainingState rested = state;
  trainer.polish(state, 0, test::always);
  EXPECT_EQ(state.epochs, rested.epochs);
  trainer.polish(state, 7, test::always);
  EXPECT_EQ(state.epochs, rested.epochs + 7);
  EXPECT_EQ(state.termination.cause, Cause::iteration_limit);
  EXPECT_LT(state.training_rmse, rested.training_rmse);
  EXPECT_EQ(state.training_curve.back(), state.training_rmse);
  EXPECT_NEAR(state.training_rmse, rmse(state.weights, data.samples), 1e-9 * state.training_rmse);

  state = rested;
  trainer.polish(state, 3000, test::always);
  EXPECT_EQ(state.termination.cause, Cause::stalled);
  EXPECT_THAT(test::said(ending_of(state.termination)), HasSubstr("the last 2 without gain"));
  state = rested;
  trainer.polish(state, 3000, [] { return false; });
  EXPECT_EQ(state.epochs, rested.epochs + 1);
  EXPECT_EQ(state.termination.cause, Cause::stopped);
}

TEST(TextbookTrainer, IsNotPolished) {
  const Overfitting data;
  const TrainingOptions options = options_for(Trainer::lm);
  const NetworkTrainer trainer(kShape, data.samples, nullptr, options);
  TrainingState state = trainer.start(random_start(kShape, Trainer::lm, 1, 0));
  trainer.train(state, 20, test::always);
  trainer.polish(state, 100, test::always);
  EXPECT_EQ(state.epochs, 20U);
}

TEST(TextbookTrainer, GoesOnWhereItPaused) {
  const Overfitting data;
  const TrainingOptions options = options_for(Trainer::lm);
  for (const Samples* validation : {static_cast<const Samples*>(nullptr), &data.validation}) {
    const NetworkTrainer trainer(kShape, data.samples, validation, options);
    TrainingState once = trainer.start(random_start(kShape, Trainer::lm, 1, 0));
    TrainingState paused = once;
    trainer.train(once, 60, test::always);
    for (int piece = 0; piece < 20; ++piece) trainer.train(paused, 3, test::always);
    EXPECT_EQ(once.finished, validation != nullptr) << "early stopping was not reached";
    EXPECT_EQ(paused.weights, once.weights);
    EXPECT_EQ(paused.training_curve, once.training_curve);
    EXPECT_EQ(paused.validation_curve, once.validation_curve);
    EXPECT_EQ(paused.epochs, once.epochs);
  }
}

TEST(TextbookTrainer, EndsAtTheGradientAndTheDampingAsked) {
  const Overfitting data;
  TrainingOptions options = options_for(Trainer::lm);
  options.minimum_gradient = 1e9;
  const NetworkTrainer content(kShape, data.samples, nullptr, options);
  TrainingState state = content.start(random_start(kShape, Trainer::lm, 1, 0));
  content.train(state, 10, test::always);
  EXPECT_EQ(state.epochs, 0U);
  EXPECT_TRUE(state.finished);
  EXPECT_THAT(test::said(ending_of(state.termination)), HasSubstr("gradient"));

  options.minimum_gradient = 0.0;
  options.mu = 2.0;
  options.mu_max = 1.0;
  const NetworkTrainer damped(kShape, data.samples, nullptr, options);
  state = damped.start(random_start(kShape, Trainer::lm, 1, 0));
  damped.train(state, 10, test::always);
  EXPECT_EQ(state.epochs, 0U);
  EXPECT_THAT(test::said(ending_of(state.termination)), HasSubstr("damping"));
}

TEST(SolvedOutputLayer, IsTheBestThereIs) {
  const Overfitting data;
  const std::vector<double> hidden = random_start(kShape, Trainer::varpro, 4, 0);
  const std::vector<double> weights = with_solved_output_layer(kShape, data.samples, hidden);
  ASSERT_EQ(weights.size(), kShape.parameters());
  EXPECT_TRUE(std::equal(hidden.begin(), hidden.end(), weights.begin()));
  const double least = perceptron_sse(kShape, weights, data.samples);
  for (std::size_t k = hidden.size(); k < weights.size(); ++k) {
    for (const double step : {-1e-3, 1e-3}) {
      std::vector<double> other = weights;
      other[k] += step;
      EXPECT_GT(perceptron_sse(kShape, other, data.samples), least) << k;
    }
  }
}

}  // namespace
}  // namespace proofmass
