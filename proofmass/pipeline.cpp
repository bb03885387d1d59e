// SPDX-License-Identifier: Apache-2.0
#include "proofmass/pipeline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "proofmass/assess/intervals.hpp"
#include "proofmass/assess/metrics.hpp"
#include "proofmass/assess/selection/hidden_search.hpp"
#include "proofmass/core/error.hpp"
#include "proofmass/identify/model/identifiability.hpp"
#include "proofmass/identify/network/presets.hpp"
#include "proofmass/identify/regression/uncertainties.hpp"

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
  std::vector<HiddenTrial> trials =
      try_hidden_sizes(rows, method, options,
                       split_for_trials(rows.rows(), split, options.seed, options.network.search_repeats),
                       split.early_stopping, progress);
  options.network.hidden = trials[choose_hidden(trials)].hidden;
  return trials;
}

// Says when the rows that train do not speak for those that test.
void note_unlike_parts(Identification& result, const Dataset& test) {
  constexpr double kUnlike = 3.0;
  constexpr double kRounding = 1e-9;  // of the largest output
  if (!result.train || !result.test || !(result.test->rmse > kUnlike * result.train->rmse)) return;
  double largest = 0.0;
  for (const double e : test.output) largest = std::max(largest, std::abs(e));
  if (result.test->rmse * test.output_unit.to_canonical <= kRounding * largest) return;
  result.diagnostics.notes.push_back(
      fmt::format("the error on the test rows ({:.3g}) is more than three times that on the training rows "
                  "({:.3g}): what was fitted does not hold for rows that it has not seen",
                  result.test->rmse, result.train->rmse));
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
  require_plausible_rows(record);
  if (method.sigma_columns != nullptr) require_usable_sigmas(record, method.sigma_columns(asked));
  IdentifyOptions options = asked;
  std::vector<HiddenTrial> trials = search_hidden(record, method, options, split_options, progress);
  const SplitOptions parts = split_for(method, split_options);
  const Split split = split_rows(record.rows(), parts, options.seed);
  if (parts.early_stopping && parts.validation_share > 0.0 && split.validation.empty() && record.rows() > 0) {
    throw usage_error(
        fmt::format("a validation share of {} leaves no validation row of {} for early stopping",
                    parts.validation_share, record.rows()));
  }
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
  note_unlike_parts(result, test);
  return result;
}

}  // namespace proofmass
