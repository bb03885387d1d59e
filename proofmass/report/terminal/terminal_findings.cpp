// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/terminal/terminal_findings.hpp"

#include "proofmass/report/terminal/terminal_words.hpp"
#include "proofmass/report/text/findings.hpp"

namespace proofmass {

void write_finding(TerminalText& out, const Finding& finding, std::string_view more) {
  std::string text = out.in(severity_words(finding.severity));
  text.append(sentence(finding, out.language())).append(more);
  if (finding.severity == Severity::warning) {
    out.warning(text);
  } else {
    out.line(text);
  }
}

void write_findings(TerminalText& out, std::span<const Finding> findings, Severity severity) {
  for (const Finding& finding : findings) {
    if (finding.severity == severity) write_finding(out, finding);
  }
}

}  // namespace proofmass
