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

struct Line {
  std::string_view text;
  std::size_t number = 0;
  bool comment = false;
};

// The lines that are not blank.
std::vector<Line> lines_of(const Chunk& chunk) {
  std::vector<Line> lines;
  for_each_line(chunk.text, chunk.first_line, [&lines](std::string_view text, std::size_t number) {
    const auto first = text.find_first_not_of(" \t");
    if (first != std::string_view::npos) {
      lines.push_back({.text = text, .number = number, .comment = text[first] == '#'});
    }
    return true;
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

// Whether a line looks like data: two numbers or more, or its only field, which are at least half of its
// fields.
bool is_data(std::string_view text, const Separation& separation) {
  const std::vector<std::string> fields = fields_of(text, separation);
  const auto numbers = static_cast<std::size_t>(std::count_if(
      fields.begin(), fields.end(), [](const std::string& field) { return looks_like_number(field); }));
  return numbers >= std::min<std::size_t>(2, fields.size()) && 2 * numbers >= fields.size();
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

// The places, from 0, of columns of numbers that are named by position.
std::vector<std::size_t> positions(const ReadOptions& options) {
  std::vector<std::size_t> found;
  for (const auto& [name, wanted] : options.rename) {
    const auto position = position_of(wanted.substr(0, wanted.find('[')));
    if (position && name != column_name(Column::mount) && name != column_name(Column::t))
      found.push_back(*position);
  }
  return found;
}

// The place among the lines of the header.
struct Found {
  std::size_t index = 0;
  bool certain = false;  // false: the line that looks most like it
  bool absent = false;   // the columns have positions, and the line is the first of data
};

// Columns by position: the header is the line above the first one with numbers at those positions, if it has
// as many fields.
Found find_above_data(const std::string& file, const std::vector<Line>& lines, std::size_t first,
                      std::optional<char> separator, const std::vector<std::size_t>& places) {
  for (std::size_t k = first; k < lines.size(); ++k) {
    const auto header = lines[k].comment ? std::nullopt : header_of(file, lines[k], separator);
    if (!header) continue;
    const std::vector<std::string> fields = fields_of(lines[k].text, header->separation);
    const auto is_number = [&fields](std::size_t place) {
      return place < fields.size() && looks_like_number(fields[place]);
    };
    if (!std::all_of(places.begin(), places.end(), is_number)) continue;
    const bool above = k > first && !lines[k - 1].comment &&
                       fields_of(lines[k - 1].text, header->separation).size() == fields.size();
    return {.index = above ? k - 1 : k, .certain = true, .absent = !above};
  }
  return {.index = first, .certain = false, .absent = false};
}

Error header_below_data(const std::string& file, const Line& header, const Line& data) {
  return bad_data({.file = file, .row = header.number}, header.text,
                  message("the header above all rows of numbers; line {} looks like one", data.number));
}

// The line that names the columns.
Found find_header(const std::string& file, const std::vector<Line>& lines, std::size_t first,
                  std::optional<char> separator, const ReadOptions& options) {
  std::optional<std::size_t> in_comment;
  std::optional<std::size_t> data;
  for (std::size_t k = first; k < lines.size(); ++k) {
    const auto header = header_of(file, lines[k], separator);
    if (!header) continue;
    if (!lines[k].comment && is_data(lines[k].text, header->separation)) {
      if (in_comment) return {.index = *in_comment, .certain = true, .absent = false};
      if (!data) data = k;
      continue;
    }
    if (!names_what_is_needed(*header, options)) continue;
    if (!lines[k].comment) {
      const bool below =
          data && fields_of(lines[*data].text, header->separation).size() == header->cells.size();
      if (below) throw header_below_data(file, lines[k], lines[*data]);
      return {.index = k, .certain = true, .absent = false};
    }
    const bool followed = k + 1 < lines.size() && !lines[k + 1].comment &&
                          fields_of(lines[k + 1].text, header->separation).size() == header->cells.size();
    if (followed && !data && !in_comment) in_comment = k;
  }
  // None: the line above the first data looks most like it.
  if (data) {
    const bool above = *data > first && !lines[*data - 1].comment;
    return {.index = above ? *data - 1 : *data, .certain = false, .absent = false};
  }
  const auto text = std::find_if(lines.begin() + static_cast<std::ptrdiff_t>(first), lines.end(),
                                 [](const Line& line) { return !line.comment; });
  if (text == lines.end())
    throw bad_data({.file = file}, "nothing but blank lines and comments", expected_header());
  return {.index = static_cast<std::size_t>(text - lines.begin()), .certain = false, .absent = false};
}

std::string_view without_brackets(std::string_view field) {
  const bool bracketed = field.size() > 2 && (field.front() == '[' || field.front() == '(');
  return bracketed ? field.substr(1, field.size() - 2) : field;
}

// A line whose every field is a unit, or says that there is none. Its units go to the cells that have none.
bool take_units(const Line& line, Header& header) {
  const std::vector<std::string> fields = fields_of(without_comment_mark(line), header.separation);
  if (fields.size() > header.cells.size()) return false;
  const auto empty = [](const std::string& field) { return field.empty() || field == "-" || field == "#"; };
  if (!std::all_of(fields.begin(), fields.end(),
                   [&empty](const std::string& field) {
                     return empty(field) || find_unit(without_brackets(field));
                   }) ||
      std::all_of(fields.begin(), fields.end(), empty)) {
    return false;
  }
  for (std::size_t k = 0; k < fields.size(); ++k) {
    if (empty(fields[k]) || header.cells[k].unit) continue;
    header.cells[k].unit = without_brackets(fields[k]);
  }
  return true;
}

Error no_header(const std::string& file, const Line& line, std::size_t fields) {
  const char* const map = fields >= 4   ? "Ai=#1[g],Ao=#2[g],Ap=#3[g],E=#4[V]"
                          : fields == 3 ? "Ai=#1[g],Ao=#2[g],E=#3[V]"
                                        : "Ai=#1[g],E=#2[V]";
  return bad_data({.file = file, .row = line.number}, line.text,
                  message("{}; without one, say which column is which, and the units", expected_header()),
                  {{"map", map}});
}

// The names of columns of a file without a header.
Header numbered(const std::string& file, const Line& line, std::optional<char> separator) {
  Header header = parse_header(file, line.text, line.number, separator);
  for (std::size_t k = 0; k < header.cells.size(); ++k) {
    header.cells[k] = {
        .text = fmt::format("#{}", k + 1), .name = fmt::format("#{}", k + 1), .unit = {}, .loose = false};
  }
  header.text.clear();
  return header;
}

// Where the line after this one begins.
void begin_data(Preamble& preamble, const Chunk& chunk, const Line& last) {
  const auto end = chunk.text.find('\n', static_cast<std::size_t>(last.text.data() - chunk.text.data()));
  preamble.data_begin = end == std::string::npos ? chunk.text.size() : end + 1;
  preamble.data_line = last.number + 1;
}

}  // namespace

Message expected_header() { return message("a header line that names the columns Ai Ao Ap E"); }

Preamble read_preamble(const std::string& file, const Chunk& chunk, const ReadOptions& options) {
  const std::vector<Line> lines = lines_of(chunk);
  if (lines.empty())
    throw bad_data({.file = file}, "nothing but blank lines and comments", expected_header());
  const std::optional<char> separator = stated_separator(lines.front().text);
  const std::size_t first = separator ? 1 : 0;
  if (first == lines.size())
    throw bad_data({.file = file, .row = lines.front().number}, lines.front().text, expected_header());
  const std::vector<std::size_t> places = positions(options);
  const Found found = places.empty() ? find_header(file, lines, first, separator, options)
                                     : find_above_data(file, lines, first, separator, places);
  const Line& line = lines[found.index];

  Preamble preamble;
  if (found.absent) {
    preamble.header = numbered(file, line, separator);
    preamble.data_begin = static_cast<std::size_t>(line.text.data() - chunk.text.data());
    preamble.data_line = line.number;
  } else {
    preamble.header = parse_header(file, without_comment_mark(line), line.number, separator);
    if (!found.certain && is_data(line.text, preamble.header.separation))
      throw no_header(file, line, preamble.header.cells.size());
    begin_data(preamble, chunk, line);
  }
  preamble.header_in_comment = line.comment;
  for (std::size_t k = first; k < found.index; ++k) {
    if (!lines[k].comment) preamble.skipped.push_back(lines[k].number);
  }
  const std::size_t next = found.index + 1;
  if (!found.absent && next < lines.size() && take_units(lines[next], preamble.header)) {
    preamble.units_row = lines[next].number;
    begin_data(preamble, chunk, lines[next]);
  }
  return preamble;
}

}  // namespace proofmass
