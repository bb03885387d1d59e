// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/terminal/text_table.hpp"

#include <algorithm>
#include <utility>

namespace proofmass {

std::size_t display_width(std::string_view text) noexcept {
  const auto starts_character = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; };
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), starts_character));
}

TextTable::TextTable(std::vector<std::string> header, bool last_left) : last_left_(last_left) {
  rows_.push_back(std::move(header));
}

void TextTable::add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }

std::vector<std::string> TextTable::lines() const {
  const std::size_t columns = rows_.front().size();
  std::vector<std::size_t> width(columns, 0);
  for (const auto& row : rows_) {
    for (std::size_t c = 0; c < std::min(columns, row.size()); ++c) {
      width[c] = std::max(width[c], display_width(row[c]));
    }
  }
  std::vector<std::string> lines;
  for (const auto& row : rows_) {
    std::string line;
    for (std::size_t c = 0; c < row.size(); ++c) {
      const bool left = c == 0 || (last_left_ && c + 1 == columns);
      const std::string padding(c < columns ? width[c] - display_width(row[c]) : 0, ' ');
      line += "  " + (left ? row[c] + padding : padding + row[c]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace proofmass
