// SPDX-License-Identifier: Apache-2.0
#include <utility>
#include <vector>

#include "proofmass/report/json/parts_internal.hpp"

namespace proofmass {

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

namespace {

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

}  // namespace

Diagnostics diagnostics_of(const JsonNode& node) {
  return {.residual_sd = optional_number(node, "residual_sd"),
          .dof = optional_count(node, "dof"),
          .interval_dof = optional_count(node, "interval_dof"),
          .r2_adjusted = optional_number(node, "r2_adjusted"),
          .condition_raw = optional_number(node, "condition_raw"),
          .condition_scaled = optional_number(node, "condition_scaled"),
          .iterations = optional_count(node, "iterations")};
}

Details details_of(const JsonNode& node) {
  if (const auto scale = optional_number(node, "robust_scale")) {
    return RobustDetails{.scale = *scale, .suspect_rows = suspects_of(node)};
  }
  if (const auto tried = optional_count(node, "models_tried")) return GmdhDetails{.models_tried = *tried};
  const auto evaluations = optional_count(node, "swarm_evaluations");
  if (const auto ratio = optional_number(node, "optimum_rmse_ratio")) {
    return AfsaDetails{.swarm_evaluations = evaluations.value_or(0),
                       .optimum_rmse_ratio = *ratio,
                       .optimum_distance = optional_number(node, "optimum_distance").value_or(0.0)};
  }
  const auto epochs = optional_count(node, "training_epochs");
  if (!epochs) return std::monostate();
  auto saturated = optional_number(node, "saturated_fraction");
  if (!saturated) saturated = optional_number(node, "saturated_share");  // the name of 0.1.0
  return NetworkDetails{.saturated_fraction = saturated,
                        .induced_deviation = optional_number(node, "induced_deviation"),
                        .training_epochs = *epochs,
                        .swarm_evaluations = evaluations,
                        .hidden_search = hidden_trials_of(node)};
}

}  // namespace proofmass
