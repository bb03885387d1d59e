// SPDX-License-Identifier: Apache-2.0
#include "proofmass/record/csv/header.hpp"

#include <fmt/format.h>

#include <string_view>

#include "proofmass/core/error.hpp"
#include "proofmass/record/csv/fields.hpp"

namespace proofmass {
namespace {

constexpr std::size_t kMostColumns = 1000;
constexpr std::string_view kExpectedHeader = "a header line that names the columns Ai Ao Ap E";

Header parse_header(std::string_view line, const LineReader& lines) {
  const Place place{.file = lines.name(), .row = lines.line_number(), .column = {}};
  Header header{.file = place.file, .row = place.row, .separator = detect_separator(line), .cells = {}};
  const auto fields = split_fields(line, header.separator);
  if (fields.size() > kMostColumns) {
    throw bad_data(place, fmt::format("{} columns", fields.size()),
                   fmt::format("at most {} columns", kMostColumns));
  }
  for (const std::string_view field : fields) {
    auto text = unquoted(field);
    if (!text) throw bad_data(place, field, "a column name with matching quotes");
    header.cells.push_back(parse_header_cell(*text));
  }
  return header;
}

}  // namespace

HeaderCell parse_header_cell(const std::string& text) {
  HeaderCell cell;
  const std::string_view whole = trim(text, ',');
  const auto bracket = whole.find('[');
  if (bracket != std::string_view::npos && whole.back() == ']') {
    cell.unit = trim(whole.substr(bracket + 1, whole.size() - bracket - 2), ',');
    cell.name = trim(whole.substr(0, bracket), ',');
  } else {
    cell.name = whole;
  }
  cell.text = whole;
  return cell;
}

Header read_header(LineReader& lines) {
  while (const auto line = lines.next()) {
    if (!is_skipped(*line)) return parse_header(*line, lines);
  }
  const bool empty = lines.line_number() == 0;
  throw bad_data({.file = lines.name(), .row = 0, .column = {}},
                 empty ? "an empty file" : "nothing but blank lines and comments", kExpectedHeader);
}

}  // namespace proofmass
