// SPDX-License-Identifier: Apache-2.0
#include "proofmass/pipeline.hpp"

#include <optional>
#include <utility>

#include "proofmass/assess/metrics.hpp"
#include "proofmass/assess/uncertainty.hpp"
#include "proofmass/hidden_search.hpp"
#include "proofmass/identify/presets.hpp"
#include "proofmass/identify/uncertainties.hpp"

namespace proofmass {

namespace {

// The number of hidden units that the trials on the training share choose, put into the options.
std::vector<HiddenTrial> search_hidden(const Dataset& record, const Method& method, IdentifyOptions& options,
                                       SplitOptions split, Progress& progress) {
  if (!method.takes_hidden || !options.network.search_hidden) return {};
  SplitOptions whole = split;
  whole.early_stopping = true;  // refuses shares that leave nothing to train on
  (void)split_rows(record.rows(), whole, options.seed);
  whole.early_stopping = false;
  const Dataset rows = record.select(split_rows(record.rows(), whole, options.seed).training);
  std::vector<HiddenTrial> trials = try_hidden_sizes(rows, method, options, split, progress);
  options.network.hidden = trials[choose_hidden(trials)].hidden;
  return trials;
}

}  // namespace

void apply_paper_preset(IdentifyOptions& options, SplitOptions& split) {
  apply_paper_preset(options);
  split.early_stopping = true;
}

SplitOptions split_for(const Method& method, SplitOptions options) noexcept {
  options.early_stopping = options.early_stopping && method.predicts_by_network;
  return options;
}

Identification run(const Dataset& record, const Method& method, const IdentifyOptions& asked,
                   const SplitOptions& split_options, Progress& progress) {
  // Of all rows: what is refused must not hang on which of them train.
  if (method.sigma_columns != nullptr) require_usable_sigmas(record, method.sigma_columns(asked));
  IdentifyOptions options = asked;
  std::vector<HiddenTrial> trials = search_hidden(record, method, options, split_options, progress);
  const Split split = split_rows(record.rows(), split_for(method, split_options), options.seed);
  const Dataset training = record.select(split.training);
  const Dataset validation = record.select(split.validation);
  const Dataset test = record.select(split.test);

  Identification result = method.identify(training, validation, options, progress);
  result.diagnostics.hidden_search = std::move(trials);
  add_intervals(result);

  const double to_declared = 1.0 / record.output_unit.to_canonical;
  const auto assess = [&](const Dataset& part) -> std::optional<Metrics> {
    if (part.rows() == 0) return std::nullopt;
    return score(part.output, predict(result, part), to_declared);
  };
  result.train = assess(training);
  result.validation = assess(validation);
  result.test = assess(test);
  return result;
}

}  // namespace proofmass
