// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "proofmass/core/error.hpp"
#include "proofmass/core/text_file.hpp"
#include "proofmass/report/json.hpp"
#include "proofmass/report/json_node_internal.hpp"

namespace proofmass {
namespace {

constexpr std::string_view kSchema = "proofmass.identification/1";

std::optional<double> optional_number(const JsonNode& node, const std::string& key) {
  const auto found = node.find(key);
  if (!found) return std::nullopt;
  return found->number();
}

std::optional<std::size_t> optional_count(const JsonNode& node, const std::string& key) {
  const auto found = node.find(key);
  if (!found) return std::nullopt;
  return found->count();
}

Interval interval_of(const JsonNode& node) {
  const std::vector<double> ends = node.numbers();
  if (ends.size() != 2) node.fail("two numbers");
  return {.low = ends[0], .high = ends[1]};
}

Unit unit_of(const JsonNode& node) {
  const auto unit = find_unit(node.text());
  if (!unit) node.fail("a known unit");
  return *unit;
}

Coefficient coefficient_of(const JsonNode& node) {
  const auto term = find_term(node.at("name").text());
  if (!term) node.at("name").fail("the name of a term");
  Coefficient coefficient;
  coefficient.term = *term;
  coefficient.identified = node.at("identified").flag();
  if (coefficient.identified) coefficient.value = node.at("value").number();
  coefficient.standard_error = optional_number(node, "standard_error");
  if (const auto ci95 = node.find("ci95")) coefficient.ci95 = interval_of(*ci95);
  coefficient.t = optional_number(node, "t");
  coefficient.p = optional_number(node, "p");
  coefficient.vif = optional_number(node, "vif");
  if (const auto reason = node.find("reason")) coefficient.reason = reason->text();
  return coefficient;
}

std::vector<Coefficient> coefficients_of(const JsonNode& node) {
  std::vector<Coefficient> coefficients;
  for (const JsonNode& item : node.items()) {
    coefficients.push_back(coefficient_of(item));
    const auto same = [&](const Coefficient& c) { return c.term == coefficients.back().term; };
    if (std::count_if(coefficients.begin(), coefficients.end(), same) > 1) {
      item.at("name").fail("each term once");
    }
  }
  return coefficients;
}

std::vector<double> covariance_of(const JsonNode& node, std::size_t size) {
  const std::vector<JsonNode> rows = node.items();
  if (rows.size() != size) node.fail(fmt::format("{} rows, one an identified coefficient", size));
  std::vector<double> flat;
  for (const JsonNode& row : rows) {
    const std::vector<double> values = row.numbers();
    if (values.size() != size) row.fail(fmt::format("{} numbers", size));
    flat.insert(flat.end(), values.begin(), values.end());
  }
  return flat;
}

std::optional<Metrics> metrics_of(const JsonNode& parts, const std::string& part) {
  const auto node = parts.find(part);
  if (!node) return std::nullopt;
  return Metrics{.n = node->at("n").count(),
                 .mae = node->at("mae").number(),
                 .mse = node->at("mse").number(),
                 .rmse = node->at("rmse").number(),
                 .mape_percent = optional_number(*node, "mape_percent"),
                 .r2 = optional_number(*node, "r2")};
}

Ending ending_of(const JsonNode& node) {
  constexpr std::array kStatuses{EndingStatus::direct,         EndingStatus::converged,
                                 EndingStatus::target_reached, EndingStatus::stalled,
                                 EndingStatus::early_stopped,  EndingStatus::iteration_limit,
                                 EndingStatus::failed};
  const JsonNode status = node.at("status");
  const std::string word = status.text();
  const auto* const found =
      std::find_if(kStatuses.begin(), kStatuses.end(), [&](EndingStatus s) { return to_string(s) == word; });
  if (found == kStatuses.end()) status.fail("a known ending");
  return {.status = *found, .reason = node.at("reason").text()};
}

std::vector<Curve> history_of(const JsonNode& node) {
  std::vector<Curve> curves;
  for (const auto& [name, values] : node.members()) {
    Curve curve{.name = name, .values = {}};
    for (const JsonNode& value : values.items()) {
      curve.values.push_back(value.is_null() ? std::numeric_limits<double>::infinity() : value.number());
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

std::vector<SuspectRow> suspects_of(const JsonNode& diagnostics) {
  std::vector<SuspectRow> suspects;
  const auto list = diagnostics.find("suspect_rows");
  if (!list) return suspects;
  for (const JsonNode& node : list->items()) {
    suspects.push_back({.row = node.at("row").count(),
                        .line = optional_count(node, "line"),
                        .residual = node.at("residual").number(),
                        .scaled_residual = node.at("scaled_residual").number(),
                        .weight = node.at("weight").number()});
  }
  return suspects;
}

std::vector<HiddenTrial> hidden_trials_of(const JsonNode& diagnostics) {
  std::vector<HiddenTrial> trials;
  const auto list = diagnostics.find("hidden_search");
  if (!list) return trials;
  for (const JsonNode& node : list->items()) {
    HiddenTrial trial{.hidden = node.at("hidden").count(),
                      .weights = node.at("weights").count(),
                      .validation_rmse = {},
                      .mean = node.at("mean").number(),
                      .best = node.at("best").number(),
                      .spread = node.at("spread").number(),
                      .chosen = node.at("chosen").flag()};
    for (const JsonNode& rmse : node.at("validation_rmse").items()) {
      trial.validation_rmse.push_back(rmse.number());
    }
    trials.push_back(std::move(trial));
  }
  return trials;
}

Diagnostics diagnostics_of(const JsonNode& node) {
  Diagnostics diagnostics{.residual_sd = optional_number(node, "residual_sd"),
                          .dof = optional_count(node, "dof"),
                          .r2_adjusted = optional_number(node, "r2_adjusted"),
                          .condition_raw = optional_number(node, "condition_raw"),
                          .condition_scaled = optional_number(node, "condition_scaled"),
                          .saturated_share = optional_number(node, "saturated_share"),
                          .induced_deviation = optional_number(node, "induced_deviation"),
                          .training_epochs = optional_count(node, "training_epochs"),
                          .swarm_evaluations = optional_count(node, "swarm_evaluations"),
                          .models_tried = optional_count(node, "models_tried"),
                          .hidden_search = hidden_trials_of(node),
                          .robust_scale = optional_number(node, "robust_scale"),
                          .suspect_rows = suspects_of(node),
                          .optimum_rmse_ratio = optional_number(node, "optimum_rmse_ratio"),
                          .optimum_distance = optional_number(node, "optimum_distance"),
                          .notes = {}};
  for (const JsonNode& note : node.at("notes").items()) diagnostics.notes.push_back(note.text());
  return diagnostics;
}

Provenance provenance_of(const JsonNode& node) {
  Provenance provenance{.version = node.at("version").text(),
                        .input = node.at("input").text(),
                        .input_sha256 = node.at("input_sha256").text(),
                        .options = {}};
  for (const auto& [key, value] : node.at("options").members()) {
    provenance.options.emplace_back(key, value.text());
  }
  return provenance;
}

std::vector<Axis> axes_of(const JsonNode& node) {
  std::vector<Axis> axes;
  for (const JsonNode& item : node.items()) {
    const std::string word = item.text();
    const auto* const axis =
        std::find_if(kAxes.begin(), kAxes.end(), [&](Axis a) { return axis_name(a) == word; });
    if (axis == kAxes.end()) item.fail("Ai, Ao or Ap");
    if (!axes.empty() && *axis <= axes.back()) item.fail("axes in the order Ai, Ao, Ap");
    axes.push_back(*axis);
  }
  if (axes.empty()) node.fail("at least one axis");
  return axes;
}

TrainedNetwork network_of(const JsonNode& node) {
  TrainedNetwork network{.inputs = axes_of(node.at("inputs")),
                         .hidden = node.at("hidden").count(),
                         .weights = node.at("weights").numbers(),
                         .input_range = {},
                         .output_range = interval_of(node.at("output_range")),
                         .skip = {}};
  for (const JsonNode& range : node.at("input_range").items())
    network.input_range.push_back(interval_of(range));
  if (network.input_range.size() != network.inputs.size()) {
    node.at("input_range").fail("one range for each input");
  }
  const auto ordered = [](const Interval& range) { return range.low <= range.high; };
  if (!std::all_of(network.input_range.begin(), network.input_range.end(), ordered)) {
    node.at("input_range").fail("ranges whose low end is not above the high end");
  }
  if (!(network.output_range.low < network.output_range.high)) {
    node.at("output_range").fail("a low end below the high end");
  }
  // Compared by division, so that an absurd number of hidden units cannot wrap around.
  const std::size_t per_unit = network.inputs.size() + 2;
  const std::size_t count = network.weights.size();
  if (network.hidden == 0 || count < 1 || (count - 1) % per_unit != 0 ||
      (count - 1) / per_unit != network.hidden) {
    node.at("weights").fail("(inputs + 2) * hidden + 1 numbers");
  }
  if (const auto skip = node.find("skip")) {
    for (const TermInfo& term : all_terms()) {
      const auto value = skip->find(std::string(term.name));
      if (!value) continue;
      network.skip.terms.push_back(term.term);
      network.skip.coefficients.push_back(value->number());
    }
  }
  return network;
}

constexpr std::size_t kMostBytes = std::size_t{1} << 30U;  // of a result

}  // namespace

Identification parse_result(std::string_view text, const std::string& source) {
  JsonNode::Json json;
  try {
    json = JsonNode::Json::parse(text.begin(), text.end());
  } catch (const JsonNode::Json::exception& error) {
    const std::string message = error.what();  // "[json.exception.…] parse error at line 1, column 2: …"
    throw Error(ErrorKind::bad_data,
                fmt::format("{}: not JSON:{}", source, message.substr(message.find(']') + 1)));
  }
  const JsonNode root(json, source);
  if (root.at("schema").text() != kSchema) root.at("schema").fail(fmt::format("\"{}\"", kSchema));
  Identification result{.method = root.at("method").text(),
                        .model = root.at("model").text(),
                        .seed = root.at("seed").count(),
                        .output_unit = unit_of(root.at("units").at("output")),
                        .coefficients = coefficients_of(root.at("coefficients")),
                        .covariance = {},
                        .network = std::nullopt,
                        .train = metrics_of(root.at("metrics"), "train"),
                        .validation = metrics_of(root.at("metrics"), "validation"),
                        .test = metrics_of(root.at("metrics"), "test"),
                        .ending = ending_of(root.at("ending")),
                        .history = history_of(root.at("history")),
                        .diagnostics = diagnostics_of(root.at("diagnostics")),
                        .provenance = provenance_of(root.at("provenance"))};
  if (const auto network = root.find("network")) result.network = network_of(*network);
  if (const auto covariance = root.find("covariance")) {
    const auto identified = std::count_if(result.coefficients.begin(), result.coefficients.end(),
                                          [](const Coefficient& c) { return c.identified; });
    result.covariance = covariance_of(*covariance, static_cast<std::size_t>(identified));
  }
  return result;
}

Identification read_result(const std::filesystem::path& path) {
  return parse_result(read_text_file(path, "a result file that can be read", kMostBytes),
                      path == "-" ? "standard input" : path.string());
}

}  // namespace proofmass
