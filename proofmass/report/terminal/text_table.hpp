// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace proofmass {

// Columns that UTF-8 text takes on a terminal: its code points, for all that our units need (µ, ², ³, ±) is
// one wide.
[[nodiscard]] std::size_t display_width(std::string_view text) noexcept;

// Rows of cells, aligned when rendered: the first column to the left, the others to the right, and the last
// one to the left again where `last_left` says so. Rows may be of different lengths.
class TextTable {
 public:
  explicit TextTable(std::vector<std::string> header, bool last_left = false);
  void add(std::vector<std::string> row);
  // One line a row, each indented by two blanks; no trailing blanks. The header is line 1.
  [[nodiscard]] std::vector<std::string> lines() const;

 private:
  std::vector<std::vector<std::string>> rows_;
  bool last_left_;
};

}  // namespace proofmass
