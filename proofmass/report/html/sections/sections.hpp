// SPDX-License-Identifier: Apache-2.0
// The parts of a report of an identification. One file here is one part: FILE.cpp defines FILE_part, and the
// build lists them all; parts.cpp alone has what several share. A part without data is absent.
#pragma once

#include <optional>
#include <vector>

#include "proofmass/report/html/page/section.hpp"

namespace proofmass::html {

struct PageSection {
  int place;  // on the page, ascending
  std::optional<Section> (*make)(const IdentificationContext&);
};

// Those with data, in the order of the page.
[[nodiscard]] std::vector<Section> identification_sections(const IdentificationContext& context);

}  // namespace proofmass::html
