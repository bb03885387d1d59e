// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "proofmass/report/html/page/section.hpp"
#include "proofmass/report/html/page/style.hpp"

namespace proofmass::html {

struct Page {
  Text title;
  std::string subject;  // what the report is about: a file
  std::string version;  // of the program that made the result
  std::vector<Section> sections;
};

// The whole file: style, sections, and the figures' data with the plotting library where there are both.
[[nodiscard]] std::string render(const Page& page, const InteractiveFigures& interactive,
                                 const ReportStyle& style);

}  // namespace proofmass::html
