// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "proofmass/report/html/page/section.hpp"
#include "proofmass/study/paper/reproduction.hpp"

namespace proofmass::html {

// The paper's tables in its layout beside ours, and its figures.
[[nodiscard]] std::vector<Section> reproduction_sections(const Reproduction& made,
                                                         InteractiveFigures& interactive,
                                                         const std::string& date);

}  // namespace proofmass::html
