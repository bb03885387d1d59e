// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "proofmass/report/html/page/findings.hpp"
#include "proofmass/report/html/page/html.hpp"
#include "proofmass/report/html/sections/sections.hpp"

namespace proofmass::html {
namespace {

std::size_t count_of(const Identification& result, Severity severity) {
  return static_cast<std::size_t>(std::count_if(result.findings.begin(), result.findings.end(),
                                                [&](const Finding& f) { return f.severity == severity; }));
}

// One sentence: whether the coefficients can be used.
std::string verdict(const Identification& result) {
  const std::size_t total = result.coefficients.size();
  const auto identified =
      static_cast<std::size_t>(std::count_if(result.coefficients.begin(), result.coefficients.end(),
                                             [](const Coefficient& c) { return c.identified; }));
  const std::size_t warnings = count_of(result, Severity::warning);
  const std::vector<Figure> figures{{"count", identified}, {"total", total}, {"warnings", warnings}};
  const Label label = identified == 0       ? Label::verdict_none
                      : warnings > 0        ? Label::verdict_doubt
                      : identified == total ? Label::verdict_sound
                                            : Label::verdict_part;
  const bool sound = label == Label::verdict_sound || label == Label::verdict_part;
  return element("p", both(text_of(label, figures)), sound ? "class=\"verdict\"" : "class=\"verdict doubt\"");
}

// Why a term is not identified: it stands beside the term, in the table of those.
bool is_of_one_term(const Identification& result, const Finding& finding) {
  return std::any_of(result.coefficients.begin(), result.coefficients.end(),
                     [&](const Coefficient& c) { return !c.identified && c.reason == finding; });
}

std::optional<Section> verdict_section(const IdentificationContext& context) {
  const Identification& result = context.run.identification;
  std::string body = verdict(result);
  for (const Severity severity : {Severity::warning, Severity::note}) {
    for (const Finding& one : result.findings)
      if (one.severity == severity && !is_of_one_term(result, one)) body += finding(one);
  }
  return Section{.id = "verdict", .title = Label::verdict, .body = body, .short_ = true};
}

}  // namespace

extern const PageSection verdict_part;
const PageSection verdict_part{.place = 10, .make = &verdict_section};

}  // namespace proofmass::html
