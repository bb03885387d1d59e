// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/network/bp.hpp"

#include <algorithm>
#include <mutex>
#include <utility>
#include <vector>

#include "proofmass/core/error.hpp"
#include "proofmass/identify/network/result.hpp"
#include "proofmass/identify/network/training/refinement.hpp"
#include "proofmass/identify/network/training/starts.hpp"
#include "proofmass/identify/options/field_text.hpp"
#include "proofmass/numeric/parallel.hpp"
#include "proofmass/numeric/random.hpp"

namespace proofmass {
namespace {

// Several starts, each trained for a few epochs; the best of them, at most `keep`.
std::vector<TrainingState> best_starts(const NetworkTask& task, const NetworkTrainer& trainer,
                                       const Bp& method, std::uint64_t seed, std::size_t keep,
                                       Progress& progress, std::size_t& epochs) {
  std::vector<TrainingState> states(method.starts);
  const auto keep_going = [&progress] { return !progress.cancelled(); };
  std::mutex reporting;
  std::size_t started = 0;
  parallel_for(states.size(), [&](std::size_t i) {
    if (progress.cancelled()) return;
    states[i] = trainer.start(random_start(task.shape, method.network.training.trainer, seed, i),
                              RandomStream(seed, stream_id("kick", i)));
    if (states.size() > 1) trainer.train(states[i], method.start_epochs, keep_going);
    const std::lock_guard lock(reporting);
    progress.update("starts", ++started, states.size());
  });
  if (progress.cancelled()) throw Error(ErrorKind::interrupted, "interrupted");
  std::stable_sort(states.begin(), states.end(), [&trainer](const TrainingState& a, const TrainingState& b) {
    return trainer.merit(a) < trainer.merit(b);
  });
  for (std::size_t i = keep; i < states.size(); ++i) epochs += states[i].epochs;
  states.resize(std::min(keep, states.size()));
  return states;
}

}  // namespace

Identification fit(const Bp& method, const Dataset& training, const Dataset& validation,
                   const IdentifyOptions& options, Progress& progress) {
  require_in_range(method);
  const NetworkTask task = prepare_network(method.network, training, validation, options);
  const NetworkTrainer trainer(task.shape, task.samples, task.validation ? &*task.validation : nullptr,
                               method.network.training);
  std::size_t spent = 0;
  // The textbook trainer's rival to a paper-like swarm refines its single best start, as the paper does.
  const std::size_t keep =
      method.network.training.trainer == Trainer::lm ? 1 : std::max<std::size_t>(1, method.refined);
  std::vector<TrainingState> states = best_starts(task, trainer, method, options.seed, keep, progress, spent);
  Refinement refinement =
      refine(trainer, std::move(states),
             {.epochs = method.network.training.epochs, .good_enough = task.good_enough()}, progress);
  refinement.epochs += spent;
  return make_network_identification("bp", task, method.network.extraction, options, refinement);
}

}  // namespace proofmass
