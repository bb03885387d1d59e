// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>

#include "proofmass/report/json/endings_internal.hpp"
#include "proofmass/report/json/findings_internal.hpp"
#include "proofmass/report/json/json.hpp"
#include "proofmass/report/json/layout.hpp"
#include "proofmass/report/readable_units.hpp"
#include "proofmass/report/text/en.hpp"

namespace proofmass {
namespace {

using Json = nlohmann::ordered_json;

void set(Json& object, const char* key, double value) {
  if (std::isfinite(value)) object[key] = value;
}

void set(Json& object, const char* key, const std::optional<double>& value) {
  if (value && std::isfinite(*value)) object[key] = *value;
}

void set(Json& object, const char* key, const std::optional<std::size_t>& value) {
  if (value) object[key] = *value;
}

Json json_of(const Interval& interval) { return Json::array({interval.low, interval.high}); }

Json json_of(const Coefficient& coefficient, const Unit& output) {
  Json json{{"name", name(coefficient.term)}};
  if (coefficient.identified) json["value"] = coefficient.value;
  set(json, "standard_error", coefficient.standard_error);
  if (coefficient.ci95 && std::isfinite(coefficient.ci95->low) && std::isfinite(coefficient.ci95->high))
    json["ci95"] = json_of(*coefficient.ci95);
  json["unit"] = coefficient_unit(coefficient.term, output);
  json["identified"] = coefficient.identified;
  if (coefficient.left_out) json["left_out"] = true;
  if (coefficient.reason) {
    json["reason"] = english_reason(*coefficient.reason);
    if (coefficient.reason->code != Code::verbatim) json["cause"] = json_of(*coefficient.reason);
  }
  set(json, "t", coefficient.t);
  set(json, "p", coefficient.p);
  set(json, "vif", coefficient.vif);
  return json;
}

Json json_of(std::span<const Coefficient> coefficients, const Unit& output) {
  Json json = Json::array();
  for (const Coefficient& coefficient : coefficients) json.push_back(json_of(coefficient, output));
  return json;
}

Json json_of(const Metrics& metrics) {
  Json json{{"n", metrics.n}, {"mae", metrics.mae}, {"mse", metrics.mse}, {"rmse", metrics.rmse}};
  set(json, "mape_percent", metrics.mape_percent);
  json["mape_rows"] = metrics.mape_rows;
  set(json, "r2", metrics.r2);
  return json;
}

Json metrics_of(const Identification& result) {
  Json json = Json::object();
  if (result.train) json["train"] = json_of(*result.train);
  if (result.validation) json["validation"] = json_of(*result.validation);
  if (result.test) json["test"] = json_of(*result.test);
  if (result.leave_one_out) json["leave_one_out"] = json_of(*result.leave_one_out);
  if (result.leave_one_mount_out) json["leave_one_mount_out"] = json_of(*result.leave_one_mount_out);
  return json;
}

Json history_of(const std::vector<Curve>& curves) {
  Json json = Json::object();
  for (const Curve& curve : curves) json[curve.name] = curve.values;  // non-finite values become null
  return json;
}

Json json_of(const SuspectRow& suspect) {
  Json json{{"row", suspect.row}};
  set(json, "line", suspect.line);
  json["residual"] = suspect.residual;
  json["scaled_residual"] = suspect.scaled_residual;
  json["weight"] = suspect.weight;
  return json;
}

Json json_of(const HiddenTrial& trial) {
  return {{"hidden", trial.hidden}, {"weights", trial.weights}, {"validation_rmse", trial.validation_rmse},
          {"mean", trial.mean},     {"best", trial.best},       {"spread", trial.spread},
          {"chosen", trial.chosen}};
}

void add(Json&, const std::monostate&) {}

void add(Json& json, const NetworkDetails& details) {
  set(json, "saturated_share", details.saturated_fraction);  // the name of 0.1.0
  set(json, "saturated_fraction", details.saturated_fraction);
  set(json, "induced_deviation", details.induced_deviation);
  json["training_epochs"] = details.training_epochs;
  set(json, "swarm_evaluations", details.swarm_evaluations);
  for (const HiddenTrial& trial : details.hidden_search) json["hidden_search"].push_back(json_of(trial));
}

void add(Json& json, const RobustDetails& details) {
  set(json, "robust_scale", details.scale);
  for (const SuspectRow& suspect : details.suspect_rows) json["suspect_rows"].push_back(json_of(suspect));
}

void add(Json& json, const GmdhDetails& details) { json["models_tried"] = details.models_tried; }

void add(Json& json, const AfsaDetails& details) {
  json["swarm_evaluations"] = details.swarm_evaluations;
  set(json, "optimum_rmse_ratio", details.optimum_rmse_ratio);
  set(json, "optimum_distance", details.optimum_distance);
}

Json diagnostics_of(const Identification& result) {
  const Diagnostics& diagnostics = result.diagnostics;
  Json json = Json::object();
  set(json, "residual_sd", diagnostics.residual_sd);
  set(json, "dof", diagnostics.dof);
  set(json, "interval_dof", diagnostics.interval_dof);
  set(json, "r2_adjusted", diagnostics.r2_adjusted);
  set(json, "condition_raw", diagnostics.condition_raw);
  set(json, "condition_scaled", diagnostics.condition_scaled);
  set(json, "iterations", diagnostics.iterations);
  std::visit([&json](const auto& details) { add(json, details); }, result.details);
  json["notes"] = Json::array();
  for (const Finding& finding : result.findings) json["notes"].push_back(english(finding));
  return json;
}

Json json_of(const Provenance& provenance) {
  Json options = Json::object();
  for (const auto& [key, value] : provenance.options) options[key] = value;
  Json json{{"version", provenance.version},
            {"input", provenance.input},
            {"input_sha256", provenance.input_sha256}};
  if (!provenance.acceleration_unit.empty()) json["acceleration_unit"] = provenance.acceleration_unit;
  json["options"] = std::move(options);
  json["reading"] = json_of(std::span(provenance.reading));
  return json;
}

Json json_of(const TrainedNetwork& network) {
  Json inputs = Json::array();
  Json ranges = Json::array();
  for (const Axis axis : network.inputs) inputs.push_back(axis_name(axis));
  for (const Interval& range : network.input_range) ranges.push_back(json_of(range));
  Json json{{"inputs", std::move(inputs)},
            {"hidden", network.hidden},
            {"weights", network.weights},
            {"input_range", std::move(ranges)},
            {"output_range", json_of(network.output_range)}};
  for (std::size_t k = 0; k < network.skip.terms.size(); ++k) {
    json["skip"][std::string(name(network.skip.terms[k]))] = network.skip.coefficients[k];
  }
  return json;
}

// Square, rows in the order of the identified coefficients.
Json covariance_of(std::span<const double> flat) {
  const auto size = static_cast<std::size_t>(std::llround(std::sqrt(static_cast<double>(flat.size()))));
  Json json = Json::array();
  for (std::size_t row = 0; row < size; ++row) {
    const auto values = flat.subspan(row * size, size);
    json.push_back(std::vector<double>(values.begin(), values.end()));
  }
  return json;
}

bool all_finite(std::span<const double> values) {
  for (const double value : values) {
    if (!std::isfinite(value)) return false;
  }
  return true;
}

}  // namespace

std::string to_json(const Run& run) {
  const Identification& result = run.identification;
  Json json{{"schema", "proofmass.identification/1"},
            {"method", result.method},
            {"model", result.model},
            {"seed", result.seed},
            {"units", {{"acceleration", "g"}, {"output", result.output_unit.symbol}}},
            {"coefficients", json_of(result.coefficients, result.output_unit)}};
  if (!result.output_unit.is_acceleration()) {
    json["input_referred"] = json_of(referred_to_input(result), Unit{});
  }
  json["metrics"] = metrics_of(result);
  json["ending"] = json_of(result.ending);
  json["history"] = history_of(result.history);
  json["findings"] = json_of(result.findings);
  json["diagnostics"] = diagnostics_of(result);
  json["provenance"] = json_of(run.provenance);
  for (const auto& [axis, range] : result.input_range) {
    json["input_range"][std::string(axis_name(axis))] = json_of(range);
  }
  if (result.network) json["network"] = json_of(*result.network);
  if (!result.covariance.empty() && all_finite(result.covariance)) {
    json["covariance"] = covariance_of(result.covariance);
    json["covariance_kind"] = to_string(result.covariance_kind);
    json["correlations"] = covariance_of(correlations_of(result));
  }
  return json_layout(json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace proofmass
