// SPDX-License-Identifier: Apache-2.0
#include "proofmass/pipeline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "proofmass/assess/intervals.hpp"
#include "proofmass/assess/metrics.hpp"
#include "proofmass/assess/selection/hidden_search.hpp"
#include "proofmass/core/error.hpp"
#include "proofmass/core/version.hpp"
#include "proofmass/identify/method_options.hpp"
#include "proofmass/identify/model/identifiability.hpp"
#include "proofmass/identify/regression/uncertainties.hpp"
#include "proofmass/split.hpp"

namespace proofmass {
namespace {

// Of all rows: what is refused must not hang on which of them train.
void require_usable(const Dataset& record, const Method& method) {
  require_valid_options(method);
  require_plausible_rows(record);
  require_usable_sigmas(record, sigma_columns(method));
}

// Says what the split has to do with too few rows; the methods know the training rows alone.
void require_training_rows(const Dataset& record, const Split& split, const IdentifyOptions& options) {
  const std::size_t needed = options.terms.size() + 1;
  if (split.training.size() >= needed || split.training.size() == record.rows()) return;
  std::vector<Remedy> remedies;
  if (record.rows() >= needed && options.split < 1.0) remedies.push_back({"split", "1"});
  remedies.push_back({"terms", ""});
  throw Error(ErrorKind::bad_data,
              fmt::format("{}: {} rows, {} of them used for fitting (split {}), {} needed for {} terms",
                          record.source, record.rows(), split.training.size(), options.split, needed,
                          options.terms.size()),
              std::move(remedies));
}

SplitOptions split_of(const Method& method, const IdentifyOptions& options) {
  const NetworkOptions* const network = network_options(method);
  const bool early = network != nullptr && network->early_stopping;
  return {.training_fraction = options.split,
          .validation_fraction = early ? network->validation_fraction : 0.0};
}

// The number of hidden units that trials on the training rows choose, put into the method, and the trials.
std::vector<HiddenTrial> search_hidden(const Dataset& record, Method& method, const IdentifyOptions& options,
                                       Progress& progress) {
  NetworkOptions* const network = network_options(method);
  if (network == nullptr || network->hidden) return {};
  const SplitOptions parts{.training_fraction = options.split,
                           .validation_fraction = network->validation_fraction};
  (void)split_rows(record.rows(), parts, options.seed);  // refuses fractions that leave nothing to train on
  const Dataset rows =
      record.select(split_rows(record.rows(), {.training_fraction = options.split}, options.seed).training);
  const auto splits = split_for_trials(rows.rows(), parts, options.seed, network->search_repeats);
  std::vector<HiddenTrial> trials = try_hidden_sizes(rows, method, options, splits, progress);
  network->hidden = trials[choose_hidden(trials)].hidden;
  return trials;
}

void score_parts(Identification& result, const Dataset& training, const Dataset& validation,
                 const Dataset& test) {
  const double to_declared = 1.0 / training.output_unit.to_canonical;
  const auto scores = [&](const Dataset& part) -> std::optional<Metrics> {
    if (part.rows() == 0) return std::nullopt;
    return score(part.output, predict(result, part), to_declared);
  };
  result.train = scores(training);
  result.validation = scores(validation);
  result.test = scores(test);
}

// Says when the rows that train do not speak for those that test.
void note_unlike_parts(Identification& result, const Dataset& test) {
  constexpr double kUnlike = 3.0;
  constexpr double kRounding = 1e-9;  // of the largest output
  if (!result.train || !result.test || !(result.test->rmse > kUnlike * result.train->rmse)) return;
  double largest = 0.0;
  for (const double e : test.output) largest = std::max(largest, std::abs(e));
  if (result.test->rmse * test.output_unit.to_canonical <= kRounding * largest) return;
  result.findings.push_back({.code = Code::test_error_larger,
                             .severity = Severity::warning,
                             .figures = {{"test", result.test->rmse},
                                         {"train", result.train->rmse},
                                         {"ratio", result.test->rmse / result.train->rmse},
                                         {"unit", test.output_unit.symbol}}});
}

}  // namespace

Run identify(const Dataset& record, const Method& asked, const IdentifyOptions& options, Progress& progress) {
  require_usable(record, asked);
  Method method = asked;
  std::vector<HiddenTrial> trials = search_hidden(record, method, options, progress);

  Run run;
  run.split = split_rows(record.rows(), split_of(method, options), options.seed);
  require_training_rows(record, run.split, options);
  const Dataset training = record.select(run.split.training);
  const Dataset validation = record.select(run.split.validation);
  const Dataset test = record.select(run.split.test);

  run.identification = fit(method, training, validation, options, progress);
  if (!trials.empty()) std::get<NetworkDetails>(run.identification.details).hidden_search = std::move(trials);
  add_intervals(run.identification);
  score_parts(run.identification, training, validation, test);
  note_unlike_parts(run.identification, test);
  run.provenance = {.version = std::string(version()),
                    .input = record.source,
                    .input_sha256 = record.source_sha256,
                    .options = resolved_options(asked, options),
                    .reading = record.findings};
  run.identification.findings.insert(run.identification.findings.begin(), record.findings.begin(),
                                     record.findings.end());
  return run;
}

Run identify(const Dataset& record, const Method& method, const IdentifyOptions& options) {
  SilentProgress silent;
  return identify(record, method, options, silent);
}

}  // namespace proofmass
