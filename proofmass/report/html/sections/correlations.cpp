// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/residuals/nonlinearity.hpp"
#include "proofmass/report/html/page/findings.hpp"
#include "proofmass/report/html/page/html.hpp"
#include "proofmass/report/html/sections/sections.hpp"

namespace proofmass::html {
namespace {

std::optional<Section> correlations_section(const IdentificationContext& context) {
  const Identification& result = context.run.identification;
  HeatMap map{.id = "correlations",
              .title = text_of(Label::correlation_map),
              .labels = {},
              .values = correlations_of(result)};
  for (const Coefficient& c : result.coefficients)
    if (c.identified) map.labels.emplace_back(name(c.term));
  if (map.values.empty() || map.labels.size() < 2) return std::nullopt;
  return Section{
      .id = "correlations",
      .title = Label::correlations,
      .body = element("div", figure(map, context.interactive, findings_of(result.findings, map.id)),
                      "class=\"figures\""),
      .short_ = true};
}

}  // namespace

extern const PageSection correlations_part;
const PageSection correlations_part{.place = 100, .make = &correlations_section};

}  // namespace proofmass::html
