// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "proofmass/report/text/language.hpp"
#include "proofmass/study/paper/reproduction.hpp"

namespace proofmass {

struct NamedText {
  std::string name;  // of the file
  std::string text;
};

// The page that puts the paper's figures beside ours, in Markdown; its pictures are those of
// reproduction_files.
[[nodiscard]] std::string render_reproduction(const Reproduction& made, Language language = Language::en);

// reproduction.md, the tables' data (table-1.csv, table-2.json, table-3.json) and the data and pictures of
// the figures (figure-4-….csv, figure-4-….svg, ...).
[[nodiscard]] std::vector<NamedText> reproduction_files(const Reproduction& made,
                                                        Language language = Language::en);

}  // namespace proofmass
