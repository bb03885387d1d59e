// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "proofmass/report/json/findings_internal.hpp"
#include "proofmass/report/text/en.hpp"

namespace proofmass {

namespace {
using Json = nlohmann::ordered_json;
}  // namespace

Json json_of_figures(std::span<const Figure> figures) {
  Json json = Json::object();
  for (const Figure& figure : figures) {
    // What is not finite has no number in JSON.
    const auto* const number = std::get_if<double>(&figure.value);
    if (number != nullptr && !std::isfinite(*number)) {
      json[figure.name] = std::isnan(*number) ? "not a number" : "infinite";
    } else {
      std::visit([&](const auto& value) { json[figure.name] = value; }, figure.value);
    }
  }
  return json;
}

std::vector<Figure> figures_of(const JsonNode& node) {
  std::vector<Figure> figures;
  for (const auto& [name, value] : node.members()) {
    if (value.is_text()) {
      figures.emplace_back(name, value.text());
    } else {
      figures.emplace_back(name, value.number());
    }
  }
  return figures;
}

Json json_of(const Finding& finding) {
  Json json{{"code", to_string(finding.code)}, {"severity", to_string(finding.severity)}};
  for (const Term term : finding.terms) json["terms"].push_back(name(term));
  if (!finding.lines.empty()) json["lines"] = finding.lines;
  json["figures"] = json_of_figures(finding.figures);
  json["text"] = english(finding);
  return json;
}

Finding finding_of(const JsonNode& node) {
  Finding finding;
  const auto severity = find_severity(node.at("severity").text());
  if (!severity) node.at("severity").fail("basis, note or warning");
  finding.severity = *severity;
  if (const auto terms = node.find("terms")) {
    for (const JsonNode& item : terms->items()) {
      const auto term = find_term(item.text());
      if (!term) item.fail("the name of a term");
      finding.terms.push_back(*term);
    }
  }
  if (const auto lines = node.find("lines")) {
    for (const JsonNode& item : lines->items()) finding.lines.push_back(item.count());
  }
  const auto code = find_code(node.at("code").text());
  if (!code) {
    finding.figures = {{"text", node.at("text").text()}};
    return finding;
  }
  finding.code = *code;
  finding.figures = figures_of(node.at("figures"));
  return finding;
}

nlohmann::ordered_json json_of(std::span<const Finding> findings) {
  Json json = Json::array();
  for (const Finding& finding : findings) json.push_back(json_of(finding));
  return json;
}

std::vector<Finding> findings_of(const JsonNode& node) {
  std::vector<Finding> findings;
  for (const JsonNode& item : node.items()) findings.push_back(finding_of(item));
  return findings;
}

}  // namespace proofmass
