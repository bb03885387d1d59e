// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/json/inspection.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "proofmass/report/json/findings_internal.hpp"
#include "proofmass/report/json/layout.hpp"
#include "proofmass/report/text/en.hpp"

namespace proofmass {
namespace {

using Json = nlohmann::ordered_json;

Json names_of(const std::vector<Axis>& axes) {
  Json json = Json::array();
  for (const Axis axis : axes) json.push_back(axis_name(axis));
  return json;
}

Json names_of(const TermList& terms) {
  Json json = Json::array();
  for (const Term term : terms) json.push_back(name(term));
  return json;
}

Json json_of(const ColumnSummary& column) {
  return {{"name", column.name},
          {"unit", column.unit},
          {"minimum", column.minimum},
          {"maximum", column.maximum},
          {"mean", column.mean}};
}

Json json_of(const IgnoredColumn& column) {
  Json json{{"name", column.header}};
  if (!column.nearest.empty()) json["nearest"] = column.nearest;
  return json;
}

Json json_of(const MountSummary& mount) { return {{"name", mount.name}, {"rows", mount.rows}}; }

// Of a finding that says why a term is not identified.
Json json_of_unidentified(const Finding& finding) {
  const TermList others(finding.terms.begin() + 1, finding.terms.end());
  return {{"name", name(finding.terms.front())},
          {"confounded_with", names_of(others)},
          {"reason", english_reason(finding)},
          {"cause", json_of(finding)}};
}

Json json_of(const PresetVerdict& preset) {
  Json json{{"model", preset.name}, {"terms", preset.terms}, {"rows_needed", preset.rows_needed}};
  json["identified"] = names_of(preset.found.identified);
  json["unidentifiable"] = Json::array();
  for (const Finding& finding : preset.found.unidentified) {
    json["unidentifiable"].push_back(json_of_unidentified(finding));
  }
  json["lost"] = json["unidentifiable"];  // the name of 0.1.0
  const auto add = [&json](const char* key, double value) {
    if (std::isfinite(value)) json[key] = value;
  };
  add("condition_raw", preset.found.condition_raw);
  add("condition_scaled", preset.found.condition_scaled);
  return json;
}

template <typename Items>
Json list_of(const Items& items) {
  Json json = Json::array();
  for (const auto& item : items) json.push_back(json_of(item));
  return json;
}

}  // namespace

std::string to_json(const Inspection& inspection) {
  Json json{{"schema", "proofmass.inspection/1"},
            {"input", inspection.source},
            {"input_sha256", inspection.source_sha256},
            {"rows", inspection.rows},
            {"columns", list_of(inspection.columns)},
            {"axes", names_of(inspection.axes)},
            {"mounts", list_of(inspection.mounts)},
            {"has_output_sigma", inspection.has_output_sigma},
            {"axes_with_sigma", names_of(inspection.axes_with_sigma)},
            {"repeated_inputs", inspection.repeated_inputs},
            {"repeated_rows", inspection.repeated_rows},
            {"models", list_of(inspection.presets)},
            {"ignored_columns", list_of(inspection.ignored)},
            {"findings", json_of(std::span(inspection.findings))}};
  return json_layout(json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace proofmass
