// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "proofmass/report/html/page/findings.hpp"
#include "proofmass/report/html/page/html.hpp"
#include "proofmass/report/html/sections/sections.hpp"
#include "proofmass/report/number_text.hpp"
#include "proofmass/report/readable_units.hpp"
#include "proofmass/report/text/endings.hpp"
#include "proofmass/report/typography.hpp"

namespace proofmass::html {
namespace {

// What the method tells beside that.
void add_details(Definitions& figures, const Identification& result) {
  const auto output = [&](Label label, double value) {
    figures.add(text_of(label), in_print(significant_text(to_declared(value, result.output_unit), 5)) + " " +
                                    escaped(typeset_unit(result.output_unit.symbol)));
  };
  const auto count = [&](Label label, std::size_t number) {
    figures.add(text_of(label), std::to_string(number));
  };
  if (const auto* network = std::get_if<NetworkDetails>(&result.details)) {
    if (network->saturated_fraction) {
      figures.add(text_of(Label::saturated_fraction),
                  in_print(significant_text(*network->saturated_fraction, 3)));
    }
    if (network->induced_deviation) output(Label::induced_deviation, *network->induced_deviation);
    count(Label::training_epochs, network->training_epochs);
    if (network->swarm_evaluations) count(Label::swarm_evaluations, *network->swarm_evaluations);
  } else if (const auto* robust = std::get_if<RobustDetails>(&result.details)) {
    output(Label::robust_scale, robust->scale);
  } else if (const auto* gmdh = std::get_if<GmdhDetails>(&result.details)) {
    count(Label::models_tried, gmdh->models_tried);
  } else if (const auto* afsa = std::get_if<AfsaDetails>(&result.details)) {
    count(Label::swarm_evaluations, afsa->swarm_evaluations);
  }
}

std::optional<Section> ending_section(const IdentificationContext& context) {
  const Identification& result = context.run.identification;
  const Diagnostics& d = result.diagnostics;
  const std::vector<EndingPart>& parts = result.ending.parts;
  std::string body =
      paragraph({typeset(sentence(parts, Language::en)), typeset(sentence(parts, Language::zh))});
  Definitions figures;
  const auto number = [&](Label label, const std::optional<double>& value, const std::string& unit = "") {
    if (value) figures.add(text_of(label), escaped(typeset(significant_text(*value, 5)) + unit));
  };
  if (d.residual_sd) {
    number(Label::residual_sd, to_declared(*d.residual_sd, result.output_unit),
           std::string(1, ' ').append(typeset_unit(result.output_unit.symbol)));
  }
  if (d.dof) figures.add(text_of(Label::dof), std::to_string(*d.dof));
  if (d.r2_adjusted)
    figures.add(text_of(Label::r2_adjusted), escaped(typeset(determination_text(*d.r2_adjusted))));
  number(Label::condition, d.condition_raw);
  number(Label::condition_scaled, d.condition_scaled);
  if (d.iterations) figures.add(text_of(Label::iterations), std::to_string(*d.iterations));
  add_details(figures, result);
  body += figures.html();
  for (const Finding& one : result.findings)
    if (one.severity == Severity::basis) body += finding(one);
  return Section{.id = "ending", .title = Label::ending, .body = body, .short_ = true};
}

}  // namespace

extern const PageSection ending_part;
const PageSection ending_part{.place = 130, .make = &ending_section};

}  // namespace proofmass::html
