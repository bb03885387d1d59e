// SPDX-License-Identifier: Apache-2.0
// Pieces of an HTML page. Whatever comes from a record or a result is escaped here and nowhere else.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "proofmass/report/text/language.hpp"

namespace proofmass::html {

[[nodiscard]] std::string escaped(std::string_view text);

// Text with numbers and units as the program writes them, as printed: true minus signs, raised powers.
[[nodiscard]] std::string in_print(std::string_view text);

// Text in every language with its numbers as printed; not escaped yet.
[[nodiscard]] Text in_print(const Text& text);

// The text in every language, of which the page shows the one that is chosen.
[[nodiscard]] std::string both(const Text& text);

// <tag>content</tag>; the content is HTML.
[[nodiscard]] std::string element(std::string_view tag, std::string_view content,
                                  std::string_view attributes = "");
[[nodiscard]] std::string paragraph(const Text& text);  // none where there is no text

enum class Align : std::uint8_t { left, right, reading };  // a reading: left, in one line

struct Column {
  Text name;
  Align align = Align::right;
};

// A table with headers for columns and, in its first column, for rows.
class Table {
 public:
  // A caption that repeats the heading above it is for those alone who do not see the page.
  enum class Caption : std::uint8_t { shown, hidden };
  Table(const Text& caption, std::vector<Column> columns, Caption shown = Caption::shown)
      : caption_(both(caption)), columns_(std::move(columns)), hidden_(shown == Caption::hidden) {}
  // Cells as HTML, one a column.
  void add(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }
  [[nodiscard]] bool empty() const noexcept { return rows_.empty(); }
  [[nodiscard]] std::string html() const;

 private:
  std::string caption_;
  std::vector<Column> columns_;
  std::vector<std::vector<std::string>> rows_;
  bool hidden_ = false;
};

// Names and what they stand for.
class Definitions {
 public:
  void add(const Text& name, std::string_view content);
  [[nodiscard]] std::string html() const;

 private:
  std::string body_;
};

}  // namespace proofmass::html
