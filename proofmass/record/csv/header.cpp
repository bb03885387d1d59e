// SPDX-License-Identifier: Apache-2.0
#include "proofmass/record/csv/header.hpp"

#include <utility>

#include "proofmass/core/error.hpp"
#include "proofmass/core/units.hpp"
#include "proofmass/record/csv/fields.hpp"

namespace proofmass {
namespace {

constexpr std::size_t kMostColumns = 1000;

// `Ai[g]`, `Ai (g)`: whatever is between the brackets, known or not.
bool take_bracketed(std::string_view text, char open, char close, HeaderCell& cell) {
  const auto at = text.find(open);
  if (at == std::string_view::npos || at == 0 || text.back() != close) return false;
  cell.unit = trim(text.substr(at + 1, text.size() - at - 2), ',');
  cell.name = trim(text.substr(0, at), ',');
  return true;
}

// `Ai / g`: only what is a unit, for the mark may belong to the name.
bool take_after(std::string_view text, std::string_view mark, HeaderCell& cell) {
  for (auto at = text.find(mark); at != std::string_view::npos; at = text.find(mark, at + 1)) {
    const std::string_view name = trim(text.substr(0, at), ',');
    const std::string_view unit = trim(text.substr(at + mark.size()), ',');
    if (name.empty() || !find_unit(unit)) continue;
    cell.name = name;
    cell.unit = unit;
    cell.loose = mark == "_";
    return true;
  }
  return false;
}

// In a header of blanks, "Ai [g]" came apart.
void join_units(std::vector<HeaderCell>& cells) {
  std::vector<HeaderCell> joined;
  for (HeaderCell& cell : cells) {
    const bool is_unit = !joined.empty() && !joined.back().unit && cell.text.size() > 2 &&
                         (cell.text.front() == '[' || cell.text.front() == '(');
    if (is_unit) {
      joined.back() = parse_header_cell(joined.back().text + cell.text);
    } else {
      joined.push_back(std::move(cell));
    }
  }
  cells = std::move(joined);
}

Separation separation_of(std::string_view line, std::optional<char> separator) {
  if (separator) return {.mark = *separator};
  Separation found;
  const std::string plain = plain_characters(line);
  found.fullwidth =
      line.find_first_of(",;\t") == std::string_view::npos && plain.find_first_of(",;") != std::string::npos;
  found.mark = detect_separator(found.fullwidth ? plain : line);
  if (found.mark == ' ') found = {.mark = '\t', .blanks = true};
  return found;
}

}  // namespace

HeaderCell parse_header_cell(std::string_view text) {
  const std::string plain = plain_characters(text);
  const std::string_view whole = trim(plain, ',');
  HeaderCell cell{.text = std::string(whole), .name = std::string(whole), .unit = {}, .loose = false};
  if (whole.empty()) return cell;
  if (take_bracketed(whole, '[', ']', cell) || take_bracketed(whole, '(', ')', cell)) return cell;
  for (const std::string_view mark : {"/", " in ", ",", "_"}) {
    if (take_after(whole, mark, cell)) return cell;
  }
  return cell;
}

Header parse_header(const std::string& file, std::string_view line, std::size_t row,
                    std::optional<char> separator) {
  const Place place{.file = file, .row = row, .column = {}};
  Header header{.file = file,
                .row = row,
                .separation = separation_of(line, separator),
                .cells = {},
                .text = std::string(line)};
  const std::string marked = separated_by_marks(line, header.separation);
  auto fields = split_fields(marked, header.separation.mark);
  while (fields.size() > 1 && fields.back().empty()) fields.pop_back();
  if (fields.size() > kMostColumns) {
    throw bad_data(place, message("{} columns", fields.size()), message("at most {} columns", kMostColumns));
  }
  for (const std::string_view field : fields) {
    const auto text = unquoted(field);
    if (!text) throw bad_data(place, field, "a column name with matching quotes");
    header.cells.push_back(parse_header_cell(*text));
  }
  if (header.separation.blanks) join_units(header.cells);
  return header;
}

std::string separated_by_marks(std::string_view line, const Separation& separation) {
  if (separation.fullwidth) return plain_characters(line);
  if (!separation.blanks) return std::string(line);
  std::string marked;
  bool quoted = false;
  bool blank = false;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    if (!quoted && (c == ' ' || c == '\t')) {
      blank = true;
      continue;
    }
    if (blank && !marked.empty()) marked += '\t';
    blank = false;
    marked += c;
  }
  return marked;
}

}  // namespace proofmass
