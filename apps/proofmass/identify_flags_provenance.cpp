// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "identify_flags.hpp"
#include "option_words.hpp"

namespace proofmass::cli {
namespace {

using Entries = std::vector<std::pair<std::string, std::string>>;

std::string text_of(double value) { return fmt::format("{}", value); }
std::string text_of(std::uint64_t value) { return std::to_string(value); }

void describe(const SplitOptions& split, Entries& entries) {
  entries.insert(entries.end(), {{"split", text_of(split.training_share)},
                                 {"early-stopping", word_of(kSwitchWords, split.early_stopping)},
                                 {"validation-share", text_of(split.validation_share)}});
}

void describe(const NetworkOptions& network, Entries& entries) {
  entries.insert(entries.end(), {{"hidden", network.search_hidden ? "search" : text_of(network.hidden)},
                                 {"search-repeats", text_of(network.search_repeats)},
                                 {"trainer", word_of(kTrainerWords, network.trainer)},
                                 {"epochs", text_of(network.epochs)},
                                 {"kicks", text_of(network.kicks)},
                                 {"starts", text_of(network.starts)},
                                 {"start-epochs", text_of(network.start_epochs)},
                                 {"mu", text_of(network.mu)},
                                 {"mu-decrease", text_of(network.mu_decrease)},
                                 {"mu-increase", text_of(network.mu_increase)},
                                 {"mu-max", text_of(network.mu_max)},
                                 {"minimum-gradient", text_of(network.minimum_gradient)},
                                 {"validation-failures", text_of(network.validation_failures)},
                                 {"extract", word_of(kExtractionWords, network.extraction)}});
}

void describe(const SwarmOptions& swarm, Entries& entries) {
  entries.insert(entries.end(), {{"particles", text_of(swarm.particles)},
                                 {"iterations", text_of(swarm.iterations)},
                                 {"inertia", text_of(swarm.inertia)},
                                 {"cognitive", text_of(swarm.cognitive)},
                                 {"social", text_of(swarm.social)},
                                 {"update", word_of(kUpdateWords, swarm.update)},
                                 {"topology", word_of(kTopologyWords, swarm.topology)},
                                 {"velocity-limit", text_of(swarm.velocity_limit)},
                                 {"fitness", word_of(kFitnessWords, swarm.fitness)},
                                 {"fitness-epochs", text_of(swarm.fitness_epochs)},
                                 {"stall", text_of(swarm.stall_iterations)},
                                 {"target", swarm.target ? text_of(*swarm.target) : "none"},
                                 {"refine", text_of(swarm.refined)}});
}

void describe(const WlsOptions& wls, Entries& entries) {
  entries.insert(entries.end(), {{"weights", word_of(kWeightWords, wls.weights)},
                                 {"sigma-scale", word_of(kScalingWords, wls.scaling)}});
}

void describe(const UncertaintyOptions& uncertainty, Entries& entries) {
  const auto micro_g = [](const std::optional<double>& sigma) {
    return sigma ? text_of(1e6 * *sigma) : "none";
  };
  entries.insert(entries.end(), {{"sigma-input-ug", micro_g(uncertainty.input)},
                                 {"sigma-output-ug", micro_g(uncertainty.output)},
                                 {"eiv-iterations", text_of(uncertainty.iterations)}});
}

void describe(const RobustSettings& robust, Entries& entries) {
  entries.insert(entries.end(), {{"loss", word_of(kLossWords, robust.fit.loss)},
                                 {"tuning", robust.fit.tuning ? text_of(*robust.fit.tuning) : "default"},
                                 {"outlier-limit", text_of(robust.outlier_limit)}});
}

void describe(const GmdhOptions& gmdh, Entries& entries) {
  entries.insert(entries.end(), {{"gmdh-form", word_of(kGmdhFormWords, gmdh.form)},
                                 {"gmdh-criterion", word_of(kGmdhCriterionWords, gmdh.criterion)},
                                 {"gmdh-checking-share", text_of(gmdh.checking_share)},
                                 {"gmdh-tolerance", text_of(gmdh.tolerance)},
                                 {"gmdh-beam", text_of(gmdh.beam)},
                                 {"gmdh-models", text_of(gmdh.models)},
                                 {"gmdh-layers", text_of(gmdh.layers)},
                                 {"gmdh-survivors", text_of(gmdh.survivors)},
                                 {"gmdh-inputs", word_of(kSwitchWords, gmdh.inputs_in_every_layer)},
                                 {"gmdh-improvement", text_of(gmdh.improvement)}});
}

void describe(const FishSwarmOptions& fish, Entries& entries) {
  entries.insert(entries.end(), {{"fish", text_of(fish.fish)},
                                 {"fish-iterations", text_of(fish.iterations)},
                                 {"fish-tries", text_of(fish.tries)},
                                 {"fish-visual", text_of(fish.visual)},
                                 {"fish-step", text_of(fish.step)},
                                 {"crowd-factor", text_of(fish.crowd_factor)},
                                 {"fish-decay", word_of(kSwitchWords, fish.decay)},
                                 {"fish-decay-rate", text_of(fish.decay_rate)},
                                 {"fish-decay-exponent", text_of(fish.decay_exponent)},
                                 {"fish-coordinates", word_of(kFishCoordinateWords, fish.coordinates)},
                                 {"fish-stall", text_of(fish.stall_iterations)},
                                 {"fish-target", fish.target ? text_of(*fish.target) : "none"}});
}

}  // namespace

std::vector<std::pair<std::string, std::string>> describe(const IdentifySettings& settings) {
  Entries entries{{"method", settings.method},
                  {"model", settings.model},
                  {"seed", text_of(settings.options.seed)},
                  {"on-rank-loss", word_of(kRankLossWords, settings.options.on_rank_loss)},
                  {"preset", settings.preset}};
  describe(settings.split, entries);
  describe(settings.options.wls, entries);
  describe(settings.options.uncertainty, entries);
  describe(settings.options.robust, entries);
  describe(settings.options.gmdh, entries);
  describe(settings.options.network, entries);
  describe(settings.options.swarm, entries);
  entries.emplace_back("initial-swarm", settings.initial_swarm);
  describe(settings.options.fish, entries);
  return entries;
}

}  // namespace proofmass::cli
