// SPDX-License-Identifier: Apache-2.0
#include "proofmass/record/csv/preamble.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>

#include "proofmass/core/error.hpp"
#include "proofmass/core/units.hpp"
#include "proofmass/record/columns.hpp"
#include "proofmass/record/csv/fields.hpp"
#include "proofmass/record/csv/layout.hpp"
#include "proofmass/record/csv/lenient.hpp"

namespace proofmass {
namespace {

constexpr std::size_t kMostLines = 1000;  // in which the header is looked for
constexpr std::string_view kExpectedHeader = "a header line that names the columns Ai Ao Ap E";

struct Line {
  std::string_view text;
  std::size_t number = 0;
  bool comment = false;
};

// The lines that are not blank.
std::vector<Line> first_lines(const Chunk& chunk) {
  std::vector<Line> lines;
  for_each_line(chunk.text, chunk.first_line, [&lines](std::string_view text, std::size_t number) {
    const auto first = text.find_first_not_of(" \t");
    if (first != std::string_view::npos) {
      lines.push_back({.text = text, .number = number, .comment = text[first] == '#'});
    }
    return lines.size() < kMostLines;
  });
  return lines;
}

std::string_view without_comment_mark(const Line& line) {
  if (!line.comment) return line.text;
  const auto first = line.text.find_first_not_of("# \t");
  return first == std::string_view::npos ? std::string_view() : line.text.substr(first);
}

// The character that spreadsheets state in a first line "sep=;".
std::optional<char> stated_separator(std::string_view text) {
  std::string plain(text);
  std::erase(plain, '"');
  if (plain.size() < 5) return std::nullopt;
  for (std::size_t k = 0; k < 3; ++k)
    plain[k] = static_cast<char>(std::tolower(static_cast<unsigned char>(plain[k])));
  if (!plain.starts_with("sep=")) return std::nullopt;
  return plain[4];
}

std::vector<std::string> fields_of(std::string_view text, const Separation& separation) {
  const std::string marked = separated_by_marks(text, separation);
  std::vector<std::string> fields;
  for (const std::string_view field : split_fields(marked, separation.mark)) {
    fields.push_back(unquoted(field).value_or(std::string(field)));
  }
  while (fields.size() > 1 && fields.back().empty()) fields.pop_back();
  return fields;
}

// Whether a line looks like data: two numbers or more, which are at least half of its fields.
bool is_data(std::string_view text, const Separation& separation) {
  const std::vector<std::string> fields = fields_of(text, separation);
  const auto numbers = static_cast<std::size_t>(std::count_if(
      fields.begin(), fields.end(), [](const std::string& field) { return looks_like_number(field); }));
  return numbers >= 2 && 2 * numbers >= fields.size();
}

std::optional<Header> header_of(const std::string& file, const Line& line, std::optional<char> separator) {
  try {
    return parse_header(file, without_comment_mark(line), line.number, separator);
  } catch (const Error&) {
    return std::nullopt;
  }
}

bool names_what_is_needed(const Header& header, const ReadOptions& options) {
  return has_column(header, Column::Ai, options) &&
         (!options.require_output || has_column(header, Column::E, options));
}

bool by_position(const ReadOptions& options) {
  return std::any_of(options.rename.begin(), options.rename.end(),
                     [](const auto& entry) { return entry.second.starts_with('#'); });
}

// The place among the lines of the header, and whether a line was found that is it.
struct Found {
  std::size_t index = 0;
  bool certain = false;
};

// The line that names the columns; columns by position need a line of data below it besides.
Found find_header(const std::string& file, const std::vector<Line>& lines, std::size_t first,
                  std::optional<char> separator, const ReadOptions& options) {
  std::optional<std::size_t> in_comment;
  std::optional<std::size_t> likely;
  for (std::size_t k = first; k < lines.size(); ++k) {
    const auto header = header_of(file, lines[k], separator);
    if (!header) continue;
    if (!lines[k].comment && is_data(lines[k].text, header->separation)) {
      if (in_comment) return {.index = *in_comment, .certain = true};
      if (!likely && k > first && !lines[k - 1].comment) likely = k - 1;
      if (!likely) likely = k;
      continue;
    }
    if (!names_what_is_needed(*header, options)) continue;
    const bool followed = k + 1 < lines.size() && !lines[k + 1].comment &&
                          fields_of(lines[k + 1].text, header->separation).size() == header->cells.size();
    if (by_position(options) && (!followed || lines[k].comment)) continue;
    if (!lines[k].comment) return {.index = k, .certain = true};
    if (followed && !in_comment) in_comment = k;
  }
  const auto noncomment = std::find_if(lines.begin() + static_cast<std::ptrdiff_t>(first), lines.end(),
                                       [](const Line& line) { return !line.comment; });
  const auto first_text = static_cast<std::size_t>(noncomment - lines.begin());
  return {.index = likely.value_or(first_text), .certain = false};
}

bool is_unit_field(std::string_view field) {
  if (field.size() > 2 && (field.front() == '[' || field.front() == '('))
    field = field.substr(1, field.size() - 2);
  return find_unit(field).has_value();
}

// A line whose every field is a unit, or says that there is none. Its units go to the cells that have none.
bool take_units(const Line& line, Header& header) {
  const std::vector<std::string> fields = fields_of(without_comment_mark(line), header.separation);
  if (fields.size() > header.cells.size()) return false;
  const auto empty = [](const std::string& field) { return field.empty() || field == "-" || field == "#"; };
  if (!std::all_of(fields.begin(), fields.end(),
                   [&empty](const std::string& field) { return empty(field) || is_unit_field(field); }) ||
      std::all_of(fields.begin(), fields.end(), empty)) {
    return false;
  }
  for (std::size_t k = 0; k < fields.size(); ++k) {
    if (empty(fields[k]) || header.cells[k].unit) continue;
    const HeaderCell named = parse_header_cell("x" + fields[k]);
    header.cells[k].unit = named.unit ? *named.unit : fields[k];
  }
  return true;
}

Error no_header(const std::string& file, const Line& line) {
  return bad_data({.file = file, .row = line.number}, line.text, kExpectedHeader, {{"map", "Ai=#1,E=#2"}});
}

// The names of columns of a file without a header.
Header numbered(const std::string& file, const Line& line, std::optional<char> separator) {
  Header header = parse_header(file, line.text, line.number, separator);
  for (std::size_t k = 0; k < header.cells.size(); ++k) {
    header.cells[k] = {.text = fmt::format("#{}", k + 1), .name = fmt::format("#{}", k + 1), .unit = {}};
  }
  header.text.clear();
  return header;
}

void begin_data(Preamble& preamble, const Chunk& chunk, const std::vector<Line>& lines, std::size_t next) {
  if (next >= lines.size()) {
    preamble.data_begin = chunk.text.size();
    preamble.data_line = lines.back().number + 1;
    return;
  }
  // Comments between header and data are the rows' business: they are counted there.
  preamble.data_begin = static_cast<std::size_t>(lines[next].text.data() - chunk.text.data());
  preamble.data_line = lines[next].number;
}

}  // namespace

Preamble read_preamble(const std::string& file, const Chunk& chunk, const ReadOptions& options) {
  const std::vector<Line> lines = first_lines(chunk);
  if (std::all_of(lines.begin(), lines.end(), [](const Line& line) { return line.comment; }) &&
      std::none_of(lines.begin(), lines.end(), [&](const Line& line) {
        const auto header = header_of(file, line, std::nullopt);
        return header && names_what_is_needed(*header, options);
      })) {
    throw bad_data({.file = file}, "nothing but blank lines and comments", kExpectedHeader);
  }
  std::optional<char> separator = stated_separator(lines.front().text);
  const std::size_t first = separator ? 1 : 0;
  if (first == lines.size()) throw bad_data({.file = file, .row = 1}, lines.front().text, kExpectedHeader);
  const Found found = find_header(file, lines, first, separator, options);
  const Line& line = lines[found.index];
  const bool numbers = !found.certain && header_of(file, line, separator) &&
                       is_data(line.text, header_of(file, line, separator)->separation);
  if (numbers && !by_position(options)) throw no_header(file, line);

  Preamble preamble;
  preamble.header = numbers ? numbered(file, line, separator)
                            : parse_header(file, without_comment_mark(line), line.number, separator);
  preamble.header_in_comment = line.comment;
  for (std::size_t k = first; k < found.index; ++k) {
    if (!lines[k].comment) preamble.skipped.push_back(lines[k].number);
  }
  std::size_t next = found.index + (numbers ? 0 : 1);
  if (!numbers && next < lines.size() && take_units(lines[next], preamble.header)) {
    preamble.units_row = lines[next].number;
    ++next;
  }
  begin_data(preamble, chunk, lines, next);
  return preamble;
}

}  // namespace proofmass
