// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "proofmass/report/text/language.hpp"

namespace proofmass {

struct ReportStyle {
  Language language = Language::en;  // shown first; the page has a switch
  std::string date{};                // of the report, ISO 8601; empty: none is printed
  bool interactive = true;           // figures that can be zoomed, where the library was built with plotly.js
};

}  // namespace proofmass
