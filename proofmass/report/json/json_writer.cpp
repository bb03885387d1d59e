// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>

#include "proofmass/report/json/json.hpp"
#include "proofmass/report/json/layout.hpp"
#include "proofmass/report/readable_units.hpp"

namespace proofmass {
namespace {

using Json = nlohmann::ordered_json;

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
  if (!coefficient.reason.empty()) json["reason"] = coefficient.reason;
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
  set(json, "r2", metrics.r2);
  return json;
}

Json metrics_of(const Identification& result) {
  Json json = Json::object();
  if (result.train) json["train"] = json_of(*result.train);
  if (result.validation) json["validation"] = json_of(*result.validation);
  if (result.test) json["test"] = json_of(*result.test);
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

Json json_of(const Diagnostics& diagnostics) {
  Json json = Json::object();
  set(json, "residual_sd", diagnostics.residual_sd);
  set(json, "dof", diagnostics.dof);
  set(json, "r2_adjusted", diagnostics.r2_adjusted);
  set(json, "condition_raw", diagnostics.condition_raw);
  set(json, "condition_scaled", diagnostics.condition_scaled);
  set(json, "saturated_share", diagnostics.saturated_share);
  set(json, "induced_deviation", diagnostics.induced_deviation);
  set(json, "iterations", diagnostics.iterations);
  set(json, "training_epochs", diagnostics.training_epochs);
  set(json, "swarm_evaluations", diagnostics.swarm_evaluations);
  set(json, "models_tried", diagnostics.models_tried);
  for (const HiddenTrial& trial : diagnostics.hidden_search) json["hidden_search"].push_back(json_of(trial));
  set(json, "robust_scale", diagnostics.robust_scale);
  for (const SuspectRow& suspect : diagnostics.suspect_rows) json["suspect_rows"].push_back(json_of(suspect));
  set(json, "optimum_rmse_ratio", diagnostics.optimum_rmse_ratio);
  set(json, "optimum_distance", diagnostics.optimum_distance);
  json["notes"] = diagnostics.notes;
  return json;
}

Json json_of(const Provenance& provenance) {
  Json options = Json::object();
  for (const auto& [key, value] : provenance.options) options[key] = value;
  return {{"version", provenance.version},
          {"input", provenance.input},
          {"input_sha256", provenance.input_sha256},
          {"options", std::move(options)}};
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

std::string to_json(const Identification& result) {
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
  json["ending"] = {{"status", to_string(result.ending.status)}, {"reason", result.ending.reason}};
  json["history"] = history_of(result.history);
  json["diagnostics"] = json_of(result.diagnostics);
  json["provenance"] = json_of(result.provenance);
  if (result.network) json["network"] = json_of(*result.network);
  if (!result.covariance.empty() && all_finite(result.covariance)) {
    json["covariance"] = covariance_of(result.covariance);
  }
  return json_layout(json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace proofmass
