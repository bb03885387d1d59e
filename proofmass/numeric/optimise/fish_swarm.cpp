// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/optimise/fish_swarm.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "proofmass/numeric/optimise/fish_move_internal.hpp"
#include "proofmass/numeric/parallel.hpp"

namespace proofmass {
namespace {

using Position = std::vector<double>;

class School {
 public:
  School(const FishObjective& objective, std::vector<Position> initial, const FishSettings& settings,
         std::uint64_t seed)
      : objective_(objective), settings_(settings) {
    for (std::size_t i = 0; i < initial.size(); ++i) {
      fish_.push_back({.place = {.position = std::move(initial[i])},
                       .best = {},
                       .random = RandomStream(seed, stream_id("fish", i))});
    }
    const std::vector<FishPlace> nobody;
    const FishMove first(objective_, settings_, nobody, visual_, step_);
    parallel_for(fish_.size(), [&](std::size_t i) {
      fish_[i].place = first.look(fish_[i], std::move(fish_[i].place.position));
    });
    bulletin_ = fish_.front().place;
    record();
  }

  FishResult run(const FishObserver& observer) {
    for (std::size_t iteration = 1; iteration <= settings_.iterations; ++iteration) {
      if (settings_.target && bulletin_.value <= *settings_.target) {
        return finish(ended(Cause::target_reached, Event::swarm_at_target,
                            {{"value", bulletin_.value}, {"target", *settings_.target}}));
      }
      shrink(iteration);
      move();
      record();
      if (observer && !observer(iteration, bulletin_.value))
        return finish(ended(Cause::stopped, Event::stopped_by_observer));
      if (stalled()) {
        return finish(
            ended(Cause::stalled, Event::swarm_stalled, {{"iterations", settings_.stall_iterations}}));
      }
    }
    return finish(ended(Cause::iteration_limit, Event::swarm_spent, {{"iterations", settings_.iterations}}));
  }

 private:
  void shrink(std::size_t iteration) {
    if (!settings_.decay) return;
    const double fraction = static_cast<double>(iteration - 1) / static_cast<double>(settings_.iterations);
    const double factor = std::exp(-settings_.decay_rate * std::pow(fraction, settings_.decay_exponent));
    visual_ = settings_.visual * factor;
    step_ = settings_.step * factor;
  }

  // Moves all fish at once, from their present positions.
  void move() {
    std::vector<FishPlace> before;
    for (const Fish& fish : fish_) before.push_back(fish.place);
    const FishMove move(objective_, settings_, before, visual_, step_);
    parallel_for(fish_.size(), [&](std::size_t i) { move(fish_[i], i); });
  }

  // Updates the bulletin and the histories.
  void record() {
    double sum = 0.0;
    double count = 0.0;
    for (const Fish& fish : fish_) {
      if (fish.best.value < bulletin_.value) bulletin_ = fish.best;
      if (!std::isfinite(fish.place.value)) continue;
      sum += fish.place.value;
      count += 1.0;
    }
    result_.history.push_back(bulletin_.value);
    result_.mean_history.push_back(count > 0.0 ? sum / count : std::numeric_limits<double>::infinity());
  }

  [[nodiscard]] bool stalled() const {
    const std::size_t window = settings_.stall_iterations;
    const auto& history = result_.history;
    return window > 0 && history.size() > window && !(history.back() < history[history.size() - 1 - window]);
  }

  FishResult finish(Termination termination) {
    result_.termination = std::move(termination);
    result_.best = std::move(bulletin_.position);
    result_.value = bulletin_.value;
    for (const Fish& fish : fish_) result_.evaluations += fish.evaluations;
    return std::move(result_);
  }

  const FishObjective& objective_;
  const FishSettings& settings_;
  double visual_ = settings_.visual;
  double step_ = settings_.step;
  std::vector<Fish> fish_;
  FishPlace bulletin_;
  FishResult result_;
};

void require_sense(const std::vector<Position>& initial, const FishSettings& settings) {
  if (initial.empty()) throw std::invalid_argument("a school needs at least one fish");
  for (const Position& position : initial) {
    if (position.empty() || position.size() != initial.front().size())
      throw std::invalid_argument("fish need positions of one length, at least 1");
  }
  const bool lengths = settings.visual > 0.0 && settings.step > 0.0;
  const bool shares =
      settings.crowd_factor >= 0.0 && settings.decay_rate >= 0.0 && settings.decay_exponent > 0.0;
  if (!lengths || !shares) {
    throw std::invalid_argument(fmt::format(
        "a school cannot swim with visual {}, step {}, crowd factor {}, decay rate {} and exponent {}",
        settings.visual, settings.step, settings.crowd_factor, settings.decay_rate, settings.decay_exponent));
  }
}

}  // namespace

FishResult minimise_by_fish(const FishObjective& objective, std::vector<std::vector<double>> initial,
                            const FishSettings& settings, std::uint64_t seed, const FishObserver& observer) {
  require_sense(initial, settings);
  return School(objective, std::move(initial), settings, seed).run(observer);
}

}  // namespace proofmass
