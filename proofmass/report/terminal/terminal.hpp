// SPDX-License-Identifier: Apache-2.0
// Results as text for people.
#pragma once

#include <cstddef>
#include <string>

#include "proofmass/core/run.hpp"
#include "proofmass/report/text/language.hpp"

namespace proofmass {

struct TerminalStyle {
  bool colour = false;     // ANSI escapes for headings and warnings
  std::size_t width = 80;  // columns of a line; 0: any
  // What a reader can do to see columns that do not fit, as the program that shows the text has it.
  std::string more_columns{};
  Language language = Language::en;
};

// Coefficients with their uncertainties, the terms that could not be identified and why, the metrics of each
// part, how the computation ended, and what must be known to read it. When the output is not an acceleration,
// the coefficients referred to input follow.
[[nodiscard]] std::string render_table(const Identification& result, const TerminalStyle& style = {});

// The same of a run, without colour, in 80 columns, in English.
[[nodiscard]] std::string summary(const Run& run);

}  // namespace proofmass
