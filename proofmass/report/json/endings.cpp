// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/text/endings.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

#include "proofmass/report/json/endings_internal.hpp"
#include "proofmass/report/json/findings_internal.hpp"

namespace proofmass {
namespace {

using EndingJson = nlohmann::ordered_json;

EndingJson json_of_parts(const std::vector<EndingPart>& parts) {
  EndingJson json = EndingJson::array();
  for (const EndingPart& part : parts) {
    json.push_back({{"code", to_string(part.code)}, {"figures", json_of_figures(part.figures)}});
    if (!part.parts.empty()) json.back()["parts"] = json_of_parts(part.parts);
  }
  return json;
}

// Nothing where a code is not known, or parts lie deeper within one another than any method writes them.
std::optional<std::vector<EndingPart>> parts_of(const JsonNode& node, int depth = 0) {
  constexpr int kDeepest = 8;
  if (depth > kDeepest) return std::nullopt;
  std::vector<EndingPart> parts;
  for (const JsonNode& item : node.items()) {
    const std::optional<EndingCode> code = find_ending_code(item.at("code").text());
    if (!code) return std::nullopt;
    EndingPart part{.code = *code, .figures = figures_of(item.at("figures"))};
    if (const auto within = item.find("parts")) {
      std::optional<std::vector<EndingPart>> known = parts_of(*within, depth + 1);
      if (!known) return std::nullopt;
      part.parts = std::move(*known);
    }
    parts.push_back(std::move(part));
  }
  return parts;
}

EndingStatus status_of(const JsonNode& node) {
  constexpr std::array kStatuses{EndingStatus::direct,         EndingStatus::converged,
                                 EndingStatus::target_reached, EndingStatus::stalled,
                                 EndingStatus::early_stopped,  EndingStatus::iteration_limit,
                                 EndingStatus::failed};
  const std::string word = node.text();
  const auto* const found =
      std::find_if(kStatuses.begin(), kStatuses.end(), [&](EndingStatus s) { return to_string(s) == word; });
  if (found == kStatuses.end()) node.fail("a known ending");
  return *found;
}

}  // namespace

EndingJson json_of(const Ending& ending) {
  EndingJson json{{"status", to_string(ending.status)}, {"reason", sentence(ending.parts, Language::en)}};
  if (!mentions(ending.parts, EndingCode::verbatim)) json["details"] = json_of_parts(ending.parts);
  return json;
}

Ending ending_of(const JsonNode& node) {
  Ending ending{.status = status_of(node.at("status"))};
  const std::string reason = node.at("reason").text();
  if (const auto details = node.find("details")) {
    if (auto parts = parts_of(*details)) {
      ending.parts = std::move(*parts);
      return ending;
    }
  }
  ending.parts = {{.code = EndingCode::verbatim, .figures = {{"text", reason}}}};
  return ending;
}

}  // namespace proofmass
