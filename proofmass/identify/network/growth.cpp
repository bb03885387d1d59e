// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/network/growth.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "proofmass/identify/network/added_units.hpp"
#include "proofmass/identify/network/least_squares_guide.hpp"
#include "proofmass/numeric/random.hpp"

namespace proofmass {
namespace {

// Training rows for each weight: with fewer, further weights would fit noise.
constexpr std::size_t kRowsAWeight = 4;
// Difference from least squares, over its residual, that costs the test error a hundredth.
constexpr double kRepresented = 0.15;
// Difference beyond which growth ended in a poor minimum and is tried again from other random numbers.
constexpr double kPoor = 0.18;
constexpr std::size_t kAttempts = 2;
constexpr std::uint64_t kBetweenSeeds = 0x9E3779B97F4A7C15;  // far from the seeds that people choose
constexpr std::size_t kEpochsAUnit = 100;                    // of a candidate with one more unit, at most

struct Grown {
  PerceptronShape shape;
  Refinement refinement;
};

// One unit more, trained towards the output of least squares.
Grown with_one_more(const Grown& from, const LeastSquaresGuide& guide, const GrowthPlan& plan,
                    Progress& progress) {
  Grown grown{.shape = {from.shape.inputs, from.shape.hidden + 1}, .refinement = {}};
  const NetworkTrainer trainer(grown.shape, guide.rows(), nullptr, plan.training);
  std::vector<TrainingState> candidates;
  for (std::vector<double>& start :
       starts_with_added_unit(from.shape, from.refinement.best.weights, guide.rows(), plan.seed, progress)) {
    const std::uint64_t stream = stream_id("grown", 100 * grown.shape.hidden + candidates.size());
    candidates.push_back(trainer.start(std::move(start), RandomStream(plan.seed, stream)));
  }
  grown.refinement =
      refine(trainer, std::move(candidates), {.epochs = kEpochsAUnit, .stage = "growth"}, progress);
  grown.refinement.epochs += from.refinement.epochs;
  grown.refinement.candidates += from.refinement.candidates;
  return grown;
}

// Units added one by one until the network represents what least squares finds.
Grown grown_once(const Grown& from, std::size_t limit, const NetworkTask& task,
                 const LeastSquaresGuide& guide, const GrowthPlan& plan, Progress& progress) {
  Grown grown = from;
  do {
    grown = with_one_more(grown, guide, plan, progress);
  } while (grown.shape.hidden < limit &&
           grown.refinement.best.training_rmse > kRepresented * task.least_squares_rmse);
  return grown;
}

// The best of a few attempts where the first ends in a poor minimum.
Grown sought(const Grown& from, std::size_t limit, const NetworkTask& task, const LeastSquaresGuide& guide,
             const GrowthPlan& plan, Progress& progress) {
  Grown best = grown_once(from, limit, task, guide, plan, progress);
  for (std::size_t attempt = 1; attempt < kAttempts; ++attempt) {
    if (best.refinement.best.training_rmse <= kPoor * task.least_squares_rmse) break;
    GrowthPlan other = plan;
    other.seed += attempt * kBetweenSeeds;
    Grown next = grown_once(from, limit, task, guide, other, progress);
    const std::size_t epochs = best.refinement.epochs + next.refinement.epochs - from.refinement.epochs;
    const std::size_t candidates =
        best.refinement.candidates + next.refinement.candidates - from.refinement.candidates;
    if (next.refinement.best.training_rmse < best.refinement.best.training_rmse) best = std::move(next);
    best.refinement.epochs = epochs;
    best.refinement.candidates = candidates;
  }
  return best;
}

// On the measured output, from the weights found; as they are where training would go astray.
void train(Grown& grown, const NetworkTask& task, const LeastSquaresGuide& guide, const GrowthPlan& plan,
           Progress& progress) {
  TrainingOptions options = plan.training;
  options.perturbations = 0;  // the network stands where it belongs
  const NetworkTrainer trainer(grown.shape, task.samples, nullptr, options);
  std::vector<double> hidden = grown.refinement.best.weights;
  hidden.resize(grown.shape.hidden_weights());
  TrainingState start = trainer.start(std::move(hidden));
  Refinement trained = refine(trainer, {start}, {.epochs = options.epochs, .stage = "growth"}, progress);
  const std::vector<double>& weights = trained.best.weights;
  if (guide.strays(grown.shape, weights) &&
      guide.deviation(grown.shape, start.weights) < guide.deviation(grown.shape, weights)) {
    start.termination = trained.best.termination;
    trained.best = start;
  }
  trained.epochs += grown.refinement.epochs;
  trained.candidates = grown.refinement.candidates;
  grown.refinement = std::move(trained);
}

// The residual over the degrees of freedom, over that of least squares.
double residual_ratio(const NetworkTask& task, const Grown& network) {
  const auto rows = static_cast<double>(task.samples.rows());
  const double dof = rows - static_cast<double>(network.shape.parameters());
  return network.refinement.best.training_rmse * std::sqrt(rows / dof) / task.least_squares_sd;
}

}  // namespace

std::size_t hidden_limit(const NetworkTask& task, const GrowthPlan& plan) {
  const bool serves = plan.training.trainer == Trainer::varpro && !task.validation && task.leaves_noise();
  if (!serves) return task.shape.hidden;
  std::size_t most = plan.most_hidden;
  const auto weights = [&task](std::size_t hidden) {
    return PerceptronShape{task.shape.inputs, hidden}.parameters();
  };
  while (most > task.shape.hidden && kRowsAWeight * weights(most) > task.samples.rows()) --most;
  return std::max(most, task.shape.hidden);
}

EndingPart grow(NetworkTask& task, Refinement& refinement, const GrowthPlan& plan, Progress& progress) {
  const Grown before{.shape = task.shape, .refinement = refinement};
  const std::size_t limit = hidden_limit(task, plan);
  const double ratio = residual_ratio(task, before);
  if (limit == before.shape.hidden || refinement.best.training_rmse <= task.good_enough())
    return {.code = EndingCode::units_suffice, .figures = {{"units", before.shape.hidden}, {"ratio", ratio}}};
  const LeastSquaresGuide guide(task);
  Grown grown = sought(before, limit, task, guide, plan, progress);
  train(grown, task, guide, plan, progress);
  const double reached = residual_ratio(task, grown);
  refinement.epochs = grown.refinement.epochs;
  refinement.candidates = grown.refinement.candidates;
  const std::vector<Figure> figures{
      {"from", before.shape.hidden}, {"units", grown.shape.hidden}, {"before", ratio}, {"after", reached}};
  if (!(reached < ratio)) return {.code = EndingCode::units_in_vain, .figures = figures};
  task.shape = grown.shape;
  task.network.hidden = grown.shape.hidden;
  refinement = std::move(grown.refinement);
  return {.code = EndingCode::units_added, .figures = figures};
}

}  // namespace proofmass
