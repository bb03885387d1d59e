// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/terminal/terminal_findings.hpp"

#include "proofmass/report/text/en.hpp"

namespace proofmass {

void write_findings(TerminalText& out, std::span<const Finding> findings, Severity severity) {
  for (const Finding& finding : findings) {
    if (finding.severity != severity) continue;
    if (severity == Severity::warning) {
      out.warning("warning: " + english(finding));
    } else {
      out.line("note: " + english(finding));
    }
  }
}

}  // namespace proofmass
