// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/network/training/refinement.hpp"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <iterator>
#include <mutex>
#include <span>
#include <utility>

#include "proofmass/core/error.hpp"
#include "proofmass/numeric/parallel.hpp"

namespace proofmass {
namespace {

constexpr std::size_t kFinalists = 2;
// Epochs of a batch's first round; each later round doubles what a candidate has had.
constexpr std::size_t kFirstRound = 50;

// Epochs that every candidate still in the race will have had after each round.
std::vector<std::size_t> round_ends(std::size_t candidates, std::size_t epochs) {
  std::vector<std::size_t> ends;
  std::size_t end = kFirstRound;
  for (std::size_t alive = candidates; alive > kFinalists && end < epochs;
       alive = (alive + 1) / 2, end *= 2) {
    ends.push_back(end);
  }
  ends.push_back(epochs);
  return ends;
}

std::size_t planned_epochs(std::size_t candidates, std::size_t epochs) {
  std::size_t total = 0;
  std::size_t before = 0;
  for (const std::size_t end : round_ends(candidates, epochs)) {
    total += candidates * (end - before);
    candidates = (candidates + 1) / 2;
    before = end;
  }
  return total;
}

// Counts epochs from all threads and passes them on now and then.
class EpochCounter {
 public:
  EpochCounter(std::string_view stage, std::size_t total, Progress& progress)
      : stage_(stage), total_(total), progress_(progress) {}

  // One more epoch; false when the work should stop.
  bool count() {
    constexpr std::size_t kReportEvery = 25;
    const std::size_t now = ++done_;
    if (now % kReportEvery == 0) {
      const std::lock_guard lock(mutex_);
      progress_.update(stage_, std::min(now, total_), total_);
    }
    return !progress_.cancelled();
  }

 private:
  std::string_view stage_;
  std::size_t total_;
  Progress& progress_;
  std::atomic<std::size_t> done_{0};
  std::mutex mutex_;
};

// Leaves the candidates with the best first, the losers as far as they were trained.
void race(const NetworkTrainer& trainer, std::span<TrainingState> batch, std::size_t epochs,
          EpochCounter& counter, const Progress& progress) {
  const auto better = [&trainer](const TrainingState& a, const TrainingState& b) {
    return trainer.merit(a) < trainer.merit(b);
  };
  std::size_t alive = batch.size();
  std::size_t before = 0;
  for (const std::size_t end : round_ends(batch.size(), epochs)) {
    parallel_for(alive, [&](std::size_t i) {
      if (!progress.cancelled())
        trainer.train(batch[i], end - before, [&counter] { return counter.count(); });
    });
    if (progress.cancelled()) throw Error(ErrorKind::interrupted, "interrupted");
    std::stable_sort(batch.begin(), batch.begin() + static_cast<std::ptrdiff_t>(alive), better);
    alive = (alive + 1) / 2;
    before = end;
  }
}

}  // namespace

Refinement refine(const NetworkTrainer& trainer, std::vector<TrainingState> candidates,
                  const RefinementPlan& plan, Progress& progress) {
  std::size_t total = 0;
  for (std::size_t first = 0; first < candidates.size(); first += kRefinementBatch) {
    total += planned_epochs(std::min(kRefinementBatch, candidates.size() - first), plan.epochs);
  }
  EpochCounter counter(plan.stage, total, progress);
  Refinement refinement;
  for (std::size_t first = 0; first < candidates.size(); first += kRefinementBatch) {
    const std::span<TrainingState> batch(candidates.data() + first,
                                         std::min(kRefinementBatch, candidates.size() - first));
    race(trainer, batch, plan.epochs, counter, progress);
    TrainingState& winner = batch.front();
    trainer.polish(winner, plan.epochs - std::min(plan.epochs, winner.epochs),
                   [&counter] { return counter.count(); });
    if (progress.cancelled()) throw Error(ErrorKind::interrupted, "interrupted");
    refinement.candidates += batch.size();
    if (first == 0 || trainer.merit(winner) < trainer.merit(refinement.best)) refinement.best = winner;
    if (refinement.best.training_rmse <= plan.good_enough) break;
  }
  progress.update(plan.stage, total, total);
  for (const TrainingState& candidate : candidates) refinement.epochs += candidate.epochs;
  return refinement;
}

}  // namespace proofmass
