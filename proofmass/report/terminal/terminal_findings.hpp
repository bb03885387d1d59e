// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "proofmass/core/finding.hpp"
#include "proofmass/report/terminal/terminal_text.hpp"

namespace proofmass {

// A line, with more words after the sentence.
void write_finding(TerminalText& out, const Finding& finding, std::string_view more = {});

// A line for each finding of that severity.
void write_findings(TerminalText& out, std::span<const Finding> findings, Severity severity);

}  // namespace proofmass
