// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/terminal/text_table.hpp"

#include <algorithm>
#include <utility>

#include "proofmass/report/terminal/wrapped_text.hpp"
#include "proofmass/report/text/display_width.hpp"

namespace proofmass {
namespace {

constexpr std::size_t kGap = 2;         // before each column
constexpr std::size_t kLeastText = 20;  // of a last column: narrower ones are not broken

}  // namespace

TextTable::TextTable(std::vector<std::string> header, Left left) : left_(left) {
  rows_.push_back(std::move(header));
}

void TextTable::add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }

std::vector<std::size_t> TextTable::widths() const {
  std::vector<std::size_t> widths(columns(), 0);
  for (const auto& row : rows_) {
    for (std::size_t c = 0; c < std::min(columns(), row.size()); ++c) {
      widths[c] = std::max(widths[c], display_width(row[c]));
    }
  }
  return widths;
}

std::vector<std::string> TextTable::lines(std::size_t width) const {
  const std::vector<std::size_t> widths_of = widths();
  std::vector<std::string> lines;
  for (const auto& row : rows_) {
    std::string line;
    std::size_t last_start = 0;
    for (std::size_t c = 0; c < row.size(); ++c) {
      const bool left =
          c == 0 || (c == 1 && left_ == Left::second_too) || (left_ == Left::last_too && c + 1 == columns());
      const std::string padding(c < columns() ? widths_of[c] - display_width(row[c]) : 0, ' ');
      line += std::string(kGap, ' ');
      last_start = display_width(line);
      line += left ? row[c] + padding : padding + row[c];
    }
    line.erase(line.find_last_not_of(' ') + 1);
    const bool breaks =
        left_ == Left::last_too && row.size() == columns() && last_start + kLeastText <= width;
    if (!breaks || display_width(line) <= width) {
      lines.push_back(std::move(line));
      continue;
    }
    const std::vector<std::string> cell = wrapped_lines(row.back(), width - last_start);
    const std::string before = line.substr(0, line.size() - row.back().size());
    for (std::size_t k = 0; k < cell.size(); ++k)
      lines.push_back((k == 0 ? before : std::string(last_start, ' ')) + cell[k]);
  }
  return lines;
}

TextTable TextTable::columns_from(std::size_t first, std::size_t width) const {
  const std::vector<std::size_t> widths_of = widths();
  std::size_t used = kGap + widths_of[0];
  std::size_t last = first;
  while (last < columns() && (last == first || width == 0 || used + kGap + widths_of[last] <= width)) {
    used += kGap + widths_of[last];
    ++last;
  }
  TextTable part({}, left_ == Left::second_too && first > 1 ? Left::first_alone : left_);
  part.rows_.clear();
  for (const auto& row : rows_) {
    std::vector<std::string> cells{row.front()};
    for (std::size_t c = first; c < std::min(last, row.size()); ++c) cells.push_back(row[c]);
    part.rows_.push_back(std::move(cells));
  }
  return part;
}

TextTable TextTable::fitting(std::size_t width) const { return columns_from(1, width); }

std::vector<TextTable> TextTable::parts(std::size_t width) const {
  std::vector<TextTable> parts;
  for (std::size_t first = 1; first < columns();) {
    parts.push_back(columns_from(first, width));
    first += parts.back().columns() - 1;
  }
  return parts;
}

}  // namespace proofmass
