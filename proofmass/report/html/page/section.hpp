// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "proofmass/assess/residuals/record_figures.hpp"
#include "proofmass/core/run.hpp"
#include "proofmass/report/plot/interactive.hpp"
#include "proofmass/report/text/label.hpp"

namespace proofmass::html {

// A part of a report with a heading of its own.
struct Section {
  std::string id;
  Label title;
  std::string body;     // HTML
  bool short_ = false;  // fits below another one on a printed page
};

// All that the sections of an identification are made from.
struct IdentificationContext {
  const Run& run;
  const RecordFigures* record = nullptr;  // absent: the record was not found
  Text why_no_record{};
  std::string date{};  // ISO 8601
  InteractiveFigures& interactive;
};

// A drawing in the page, with its caption and what was found that it shows.
[[nodiscard]] std::string figure(const Drawing& drawing, InteractiveFigures& interactive,
                                 const std::string& findings = {});

}  // namespace proofmass::html
