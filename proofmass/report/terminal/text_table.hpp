// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace proofmass {

// Which columns of a table have their cells to the left: the first one always, and one more.
enum class Left { first_alone, second_too, last_too };

// Rows of cells, aligned when rendered, the others to the right. Rows may be of different lengths.
class TextTable {
 public:
  explicit TextTable(std::vector<std::string> header, Left left = Left::first_alone);
  void add(std::vector<std::string> row);

  // One line a row, each indented by two blanks; no trailing blanks. The header is line 1. In a last column
  // to the left, words that would go beyond the width (0: any) go on in lines below.
  [[nodiscard]] std::vector<std::string> lines(std::size_t width = 0) const;
  // The first columns that fit the width, two at least.
  [[nodiscard]] TextTable fitting(std::size_t width) const;
  // All columns, in as many tables as they need, each with the first column.
  [[nodiscard]] std::vector<TextTable> parts(std::size_t width) const;
  [[nodiscard]] std::span<const std::string> header() const noexcept { return rows_.front(); }
  [[nodiscard]] std::size_t columns() const noexcept { return rows_.front().size(); }

 private:
  [[nodiscard]] std::vector<std::size_t> widths() const;
  // The first column and those from `first` on that fit.
  [[nodiscard]] TextTable columns_from(std::size_t first, std::size_t width) const;
  std::vector<std::vector<std::string>> rows_;
  Left left_;
};

}  // namespace proofmass
