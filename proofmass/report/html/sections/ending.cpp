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
  body += figures.html();
  for (const Finding& one : result.findings)
    if (one.severity == Severity::basis) body += finding(one);
  return Section{.id = "ending", .title = Label::ending, .body = body, .short_ = true};
}

}  // namespace

extern const PageSection ending_part;
const PageSection ending_part{.place = 130, .make = &ending_section};

}  // namespace proofmass::html
