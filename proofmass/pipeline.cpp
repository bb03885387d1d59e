// SPDX-License-Identifier: Apache-2.0
#include "proofmass/pipeline.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "proofmass/assess/diagnosis/diagnosis.hpp"
#include "proofmass/assess/intervals.hpp"
#include "proofmass/assess/leave_out.hpp"
#include "proofmass/assess/metrics.hpp"
#include "proofmass/assess/selection/hidden_search.hpp"
#include "proofmass/assess/test_curve.hpp"
#include "proofmass/assess/uncertainty/row_covariance.hpp"
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
  if (record.rows() >= needed && *options.split < 1.0) remedies.push_back({"split", "1"});
  remedies.push_back({"terms", ""});
  throw Error(ErrorKind::bad_data,
              message("{}: {}, {} of them used for fitting (split {}), {} needed for {}", record.source,
                      amount_of(record.rows(), "row", "rows"), split.training.size(), *options.split, needed,
                      amount_of(options.terms.size(), "term", "terms")),
              std::move(remedies));
}

// All rows that are not for testing, ascending.
std::vector<std::size_t> rows_not_for_testing(const Split& split) {
  std::vector<std::size_t> rows;
  rows.reserve(split.training.size() + split.validation.size());
  std::merge(split.training.begin(), split.training.end(), split.validation.begin(), split.validation.end(),
             std::back_inserter(rows));
  return rows;
}

// A search of hidden units sets rows aside too, other ones in each trial. That they leave some to train on is
// checked here; without early stopping the network then trains on them again.
Split divide(const Dataset& record, const Method& method, const IdentifyOptions& options) {
  const NetworkOptions* const network = network_options(method);
  const bool early = network != nullptr && network->early_stopping;
  const bool searches = network != nullptr && !network->hidden;
  const SplitOptions parts{.training_fraction = *options.split,
                           .validation_fraction = early || searches ? network->validation_fraction : 0.0};
  Split split = options.split_by == SplitBy::mount ? split_mounts(record.mount, parts, options.seed)
                                                   : split_rows(record.rows(), parts, options.seed);
  if (!early) {
    split.training = rows_not_for_testing(split);
    split.validation.clear();
  }
  return split;
}

void require_mounts(const Dataset& record, const IdentifyOptions& options) {
  if (options.split_by == SplitBy::row) return;
  const auto unlabelled = std::find(record.mount.begin(), record.mount.end(), std::string());
  if (unlabelled != record.mount.end()) {
    const auto row = static_cast<std::size_t>(unlabelled - record.mount.begin());
    throw bad_data({.file = record.source, .row = record.line_of(row), .column = "mount"}, "",
                   "the label of a mount in each row, to keep the rows of a mount together",
                   {{"split-by", "row"}});
  }
  if (!record.mount.empty()) return;
  throw bad_data({.file = record.source, .row = 0, .column = "mount"}, "",
                 "a column with the label of the mount in each row, to keep the rows of a mount together",
                 {{"split-by", "row"}});
}

// The number of hidden units that trials on the training rows choose, put into the method, and the trials.
std::vector<HiddenTrial> search_hidden(const Dataset& record, const Split& split, Method& method,
                                       const IdentifyOptions& options, Progress& progress) {
  const NetworkOptions* const network = network_options(method);
  if (network == nullptr || network->hidden) return {};
  const SplitOptions parts{.training_fraction = *options.split,
                           .validation_fraction = network->validation_fraction};
  const Dataset rows = record.select(rows_not_for_testing(split));
  const auto splits = options.split_by == SplitBy::mount
                          ? split_mounts_for_trials(rows.mount, parts, options.seed, network->search_repeats)
                          : split_for_trials(rows.rows(), parts, options.seed, network->search_repeats);
  std::vector<HiddenTrial> trials = try_hidden_sizes(rows, method, options, splits, progress);
  set_hidden(method, trials[choose_hidden(trials)].hidden);
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

TermList in_canonical_order(TermList terms) {
  std::sort(terms.begin(), terms.end());
  terms.erase(std::unique(terms.begin(), terms.end()), terms.end());
  return terms;
}

// Before the method's own findings, and after those of reading: faults found in the record and the fit.
void add_diagnosis(Run& run, const Dataset& record, const Method& method) {
  std::vector<Finding> found = diagnose_record(record);
  const SigmaUse sigmas{.inputs_uncertain = takes_inputs_for_uncertain(method),
                        .input_columns = sigma_columns(method).inputs,
                        .constant = constant_input_sigma(method)};
  const std::vector<Finding> of_fit = diagnose_fit(record, found, run.split, run.identification, sigmas);
  found.insert(found.end(), of_fit.begin(), of_fit.end());
  std::vector<Finding>& findings = run.identification.findings;
  findings.insert(findings.begin(), found.begin(), found.end());
}

}  // namespace

Run identify(const Dataset& record, const Method& asked, const IdentifyOptions& given, Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  require_usable(record, asked);
  require_mounts(record, given);
  require_covariance(record, asked, given.covariance);
  IdentifyOptions options = given;
  options.terms = in_canonical_order(std::move(options.terms));
  options.split = training_fraction(asked, given);

  Run run;
  run.split = divide(record, asked, options);
  require_training_rows(record, run.split, options);
  Method method = asked;
  std::vector<HiddenTrial> trials = search_hidden(record, run.split, method, options, progress);
  const Dataset training = record.select(run.split.training);
  const Dataset validation = record.select(run.split.validation);
  const Dataset test = record.select(run.split.test);

  run.identification = fit(method, training, validation, options, progress);
  if (!trials.empty()) std::get<NetworkDetails>(run.identification.details).hidden_search = std::move(trials);
  use_covariance(run.identification, training, options.covariance);
  add_intervals(run.identification);
  score_parts(run.identification, training, validation, test);
  run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  add_test_curve(run.identification, test);
  if (training.rows() == record.rows()) add_leave_out_scores(run.identification, training);
  add_diagnosis(run, record, method);
  run.provenance = {.version = std::string(version()),
                    .input = record.source,
                    .input_sha256 = record.source_sha256,
                    .acceleration_unit = record.acceleration_unit.symbol,
                    .options = resolved_options(asked, options),
                    .reading = record.findings};
  run.identification.findings.insert(run.identification.findings.begin(), record.findings.begin(),
                                     record.findings.end());
  return run;
}

namespace {

Error contradiction_of(const Dataset& record, const Message& what) {
  return {ErrorKind::bad_data,
          message("{}: {}, which contradicts the result; the result file was changed, or made by another "
                  "version",
                  record.source, what)};
}

double largest_magnitude(const std::vector<double>& values) {
  double largest = 0.0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

}  // namespace

Split split_again(const Dataset& record, const Run& result) {
  const Identification& made = result.identification;
  const auto contradiction = [&](const Message& what) { return contradiction_of(record, what); };
  const auto option = [&](std::string_view name) -> std::string_view {
    for (const auto& [known, value] : result.provenance.options)
      if (known == name) return value;
    return {};
  };
  const auto fraction = [&](std::string_view name, double otherwise) {
    const std::string_view text = option(name);
    if (text.empty()) return otherwise;
    double value = -1.0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = read.ec == std::errc() && read.ptr == text.data() + text.size();
    if (!whole || !(value >= 0.0 && value <= 1.0))
      throw contradiction(message("option {} is '{}'", name, text));
    return value;
  };
  const bool early = option("early-stopping") == "on";
  const SplitOptions parts{.training_fraction = fraction("split", 1.0),
                           .validation_fraction = early ? fraction("validation-fraction", 0.0) : 0.0};
  const bool by_mount = option("split-by") == "mount";
  if (by_mount && record.mount.size() != record.rows())
    throw contradiction("no mounts, and option split-by is mount");
  Split split =
      by_mount ? split_mounts(record.mount, parts, made.seed) : split_rows(record.rows(), parts, made.seed);
  const auto counts = [](const std::optional<Metrics>& part, const std::vector<std::size_t>& rows) {
    return (part ? part->n : 0) == rows.size();
  };
  if (!counts(made.train, split.training) || !counts(made.validation, split.validation) ||
      !counts(made.test, split.test)) {
    throw contradiction(message("{} training, {} validation and {} test rows by the options",
                                split.training.size(), split.validation.size(), split.test.size()));
  }
  return split;
}

void require_own_scores(const Dataset& record, const Split& split, const Run& result) {
  // Results of other processors and versions differ in the last digits.
  constexpr double kTolerance = 1e-6;
  if (!result.identification.train || split.training.empty()) return;
  const Dataset training = record.select(split.training);
  const Metrics found = score(training.output, predict(result.identification, training),
                              1.0 / training.output_unit.to_canonical);
  const double said = result.identification.train->rmse;
  // The rounding of the outputs themselves is no contradiction.
  const double rounding = 1e-13 * largest_magnitude(training.output) / training.output_unit.to_canonical;
  if (std::abs(found.rmse - said) <= kTolerance * said + rounding) return;
  throw contradiction_of(
      record,
      message("its training error is {:.6g}, and that of its coefficients is {:.6g}", said, found.rmse));
}

Run identify(const Dataset& record, const Method& method, const IdentifyOptions& options) {
  SilentProgress silent;
  return identify(record, method, options, silent);
}

}  // namespace proofmass
