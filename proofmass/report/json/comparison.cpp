// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/json/comparison.hpp"

#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "proofmass/report/json/findings_internal.hpp"
#include "proofmass/report/json/json.hpp"
#include "proofmass/report/json/layout.hpp"
#include "proofmass/report/text/en.hpp"

namespace proofmass {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Spread& spread) {
  Json json{{"mean", spread.mean}};
  if (spread.sd) json["sd"] = *spread.sd;
  return json;
}

Json json_of(const MetricSpreads& spreads) {
  Json json{{"n", json_of(spreads.n)},
            {"mae", json_of(spreads.mae)},
            {"mse", json_of(spreads.mse)},
            {"rmse", json_of(spreads.rmse)}};
  if (spreads.mape_percent) {
    json["mape_percent"] = json_of(*spreads.mape_percent);
    json["mape_rows"] = json_of(spreads.mape_rows);
  }
  if (spreads.r2) json["r2"] = json_of(*spreads.r2);
  return json;
}

Json json_of(const TruthScore& score) {
  Json json{{"largest_error", score.largest_error}, {"largest_error_term", name(score.largest_term)}};
  if (score.rms_over_standard_error) json["rms_error_over_standard_error"] = *score.rms_over_standard_error;
  if (score.rms_over_bound) json["rms_error_over_bound"] = *score.rms_over_bound;
  return json;
}

Json json_of(const CostRatios& ratios) {
  Json json = Json::object();
  if (ratios.iterations) json["iterations"] = *ratios.iterations;
  if (ratios.time) json["seconds"] = *ratios.time;
  if (ratios.test_mse) json["test_mse"] = *ratios.test_mse;
  return json;
}

Json json_of(const Contestant& contestant, const Contestant& reference) {
  Json json{{"method", contestant.method}};
  if (contestant.train) json["train"] = json_of(*contestant.train);
  if (contestant.test) json["test"] = json_of(*contestant.test);
  if (contestant.iterations) json["iterations"] = json_of(*contestant.iterations);
  json["seconds"] = json_of(contestant.time);
  json["ratios"] = json_of(ratios_to(reference, contestant));
  if (contestant.truth) json["truth"] = json_of(*contestant.truth);
  json["runs"] = Json::array();
  for (const Run& run : contestant.runs) json["runs"].push_back(Json::parse(to_json(run)));
  return json;
}

}  // namespace

std::string to_json(const Comparison& comparison) {
  Json json{{"schema", "proofmass.comparison/1"},
            {"input", comparison.input},
            {"seed", comparison.seed},
            {"repeats", comparison.repeats},
            {"split", comparison.training_fraction},
            {"methods", Json::array()}};
  for (const Contestant& contestant : comparison.contestants) {
    json["methods"].push_back(json_of(contestant, comparison.contestants.front()));
  }
  if (comparison.truth) {
    for (std::size_t k = 0; k < comparison.truth->terms.size(); ++k) {
      json["truth"].push_back(
          {{"name", name(comparison.truth->terms[k])}, {"value", comparison.truth->coefficients[k]}});
    }
  }
  if (!comparison.findings.empty()) {
    json["findings"] = json_of(std::span(comparison.findings));
    for (const Finding& finding : comparison.findings) json["notes"].push_back(english(finding));
  }
  return json_layout(json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace proofmass
