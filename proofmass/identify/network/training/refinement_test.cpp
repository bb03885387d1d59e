// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/network/training/refinement.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "proofmass/core/error.hpp"
#include "proofmass/identify/network/scaling.hpp"
#include "proofmass/numeric/parallel.hpp"
#include "support/networks.hpp"
#include "support/twin.hpp"

namespace proofmass {
namespace {

constexpr PerceptronShape kShape{3, 3};

class Refine : public testing::Test {
 protected:
  // The plain trainer with limits that nothing reaches, so that every epoch allowed is spent.
  Refine() {
    options_.trainer = Trainer::lm;
    options_.minimum_gradient = 0.0;
    options_.mu_max = 1e300;
  }

  [[nodiscard]] std::vector<TrainingState> candidates(std::size_t count) const {
    std::vector<TrainingState> states;
    for (std::size_t i = 0; i < count; ++i) {
      states.push_back(trainer_.start(random_start(kShape, Trainer::lm, 1, i)));
    }
    return states;
  }

  const Dataset record_ = test::make_twin({.rows = 80, .noise = 0.5});
  const Samples samples_ = scale_rows(learn_scaling(record_), record_);
  TrainingOptions options_;
  NetworkTrainer trainer_{kShape, samples_, nullptr, options_};
  SilentProgress silent_;
};

TEST_F(Refine, KeepsTheBestOfTwo) {
  std::vector<TrainingState> alone = candidates(2);
  for (TrainingState& state : alone) trainer_.train(state, 20, test::always);
  ASSERT_NE(alone[0].training_rmse, alone[1].training_rmse);
  const TrainingState& expected = alone[0].training_rmse < alone[1].training_rmse ? alone[0] : alone[1];
  for (const bool swapped : {false, true}) {
    std::vector<TrainingState> pair = candidates(2);
    if (swapped) std::swap(pair[0], pair[1]);
    const Refinement refinement = refine(trainer_, std::move(pair), {.epochs = 20}, silent_);
    EXPECT_EQ(refinement.best.weights, expected.weights);
    EXPECT_EQ(refinement.epochs, 40U);
    EXPECT_EQ(refinement.candidates, 2U);
  }
}

TEST_F(Refine, HalvesTheFieldAsItGoesAndCountsTheEpochs) {
  std::vector<TrainingState> field = candidates(6);
  std::vector<TrainingState> alone = field;
  const Refinement refinement = refine(trainer_, field, {.epochs = 160}, silent_);
  // All six 50 epochs, the better three 100 and two of those 160.
  EXPECT_EQ(refinement.epochs, 6U * 50 + 3 * 50 + 2 * 60);
  EXPECT_EQ(refinement.candidates, 6U);
  EXPECT_EQ(refinement.best.epochs, 160U);
  // The same race by hand.
  const auto better = [](const TrainingState& a, const TrainingState& b) {
    return a.training_rmse < b.training_rmse;
  };
  for (const auto& [alive, epochs] : {std::pair{6, 50}, {3, 50}, {2, 60}}) {
    for (int i = 0; i < alive; ++i)
      trainer_.train(alone[static_cast<std::size_t>(i)], static_cast<std::size_t>(epochs), test::always);
    std::stable_sort(alone.begin(), alone.begin() + alive, better);
  }
  EXPECT_EQ(refinement.best.weights, alone.front().weights);
}

TEST_F(Refine, ReportsAllOfTheWork) {
  class Recorder final : public Progress {
   public:
    void update(std::string_view stage, std::size_t done, std::size_t total) override {
      stage_ = stage;
      monotone_ = monotone_ && done >= done_ && done <= total;
      done_ = done;
      total_ = total;
    }
    [[nodiscard]] bool cancelled() const noexcept override { return false; }
    std::string stage_;
    std::size_t done_ = 0;
    std::size_t total_ = 0;
    bool monotone_ = true;
  } recorder;
  const ThreadLimit one(1);
  const Refinement refinement = refine(trainer_, candidates(6), {.epochs = 160, .stage = "s"}, recorder);
  EXPECT_TRUE(recorder.monotone_);
  EXPECT_EQ(recorder.stage_, "s");
  EXPECT_EQ(recorder.done_, recorder.total_);
  EXPECT_EQ(recorder.total_, refinement.epochs);
}

TEST_F(Refine, TriesNoFurtherBatchThanNeeded) {
  const RefinementPlan content{.epochs = 5, .good_enough = std::numeric_limits<double>::infinity()};
  EXPECT_EQ(refine(trainer_, candidates(20), content, silent_).candidates, 16U);
  const Refinement all = refine(trainer_, candidates(20), {.epochs = 5, .good_enough = 0.0}, silent_);
  EXPECT_EQ(all.candidates, 20U);
  EXPECT_EQ(all.epochs, 100U);
}

TEST_F(Refine, KeepsTheBestOfAllBatches) {
  std::vector<TrainingState> field = candidates(20);
  std::vector<TrainingState> trained = field;
  for (TrainingState& state : trained) trainer_.train(state, 5, test::always);
  const auto best = std::min_element(trained.begin(), trained.end(), [](const auto& a, const auto& b) {
    return a.training_rmse < b.training_rmse;
  });
  // The winner once in the first batch and once in the second.
  for (const std::ptrdiff_t place : {2, 18}) {
    std::vector<TrainingState> ordered = field;
    std::swap(ordered[static_cast<std::size_t>(place)],
              ordered[static_cast<std::size_t>(best - trained.begin())]);
    EXPECT_EQ(refine(trainer_, ordered, {.epochs = 5}, silent_).best.weights, best->weights);
  }
}

TEST_F(Refine, DoesNotDependOnTheThreads) {
  const auto with = [this](std::size_t threads) {
    const ThreadLimit limit(threads);
    return refine(trainer_, candidates(7), {.epochs = 120}, silent_);
  };
  const Refinement one = with(1);
  const Refinement two = with(2);
  EXPECT_EQ(one.best.weights, two.best.weights);
  EXPECT_EQ(one.best.training_curve, two.best.training_curve);
  EXPECT_EQ(one.epochs, two.epochs);
}

TEST_F(Refine, ThrowsWhenInterrupted) {
  for (const std::size_t updates : {0U, 1U, 3U}) {
    test::CancelAfter progress(updates);
    try {
      (void)refine(trainer_, candidates(6), {.epochs = 160}, progress);
      ADD_FAILURE() << "went on after " << updates;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::interrupted);
    }
  }
}

}  // namespace
}  // namespace proofmass
