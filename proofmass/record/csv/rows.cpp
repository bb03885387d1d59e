// SPDX-License-Identifier: Apache-2.0
#include "proofmass/record/csv/rows.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "proofmass/core/utf8.hpp"
#include "proofmass/record/csv/fields.hpp"
#include "proofmass/record/csv/lenient.hpp"
#include "proofmass/record/csv/lines.hpp"
#include "proofmass/record/csv/number.hpp"

namespace proofmass {
namespace {

constexpr std::size_t kLinesListed = 8;

std::uint32_t bit_of(int decimals) noexcept {
  return std::uint32_t{1} << static_cast<unsigned>(std::clamp(decimals, 0, 31));
}

template <typename Value>
void move_to_end(std::vector<Value>& all, std::vector<Value>& later) {
  if (all.empty()) {
    all = std::move(later);
  } else {
    all.insert(all.end(), std::make_move_iterator(later.begin()), std::make_move_iterator(later.end()));
  }
}

// The text of a field without its quotes.
std::string content_of(std::string_view field, const Place& place) {
  const auto text = unquoted(field);
  if (!text) throw bad_data(place, field, "a field with matching quotes");
  return std::string(trim(*text, ','));
}

Error bad_number(const Place& place, std::string_view field, const LenientNumber& number,
                 bool decimal_comma) {
  if (number.overload) {
    return bad_data(place, field, "a measured value; this is a meter's mark for one beyond its range",
                    {{"overload", "leave-out"}});
  }
  if (decimal_comma && number.fault == NumberFault::not_a_number &&
      field.find('.') != std::string_view::npos) {
    return bad_data(place, field, "a number with a decimal comma and no point, as in the other rows",
                    {{"decimal", "point"}});
  }
  std::vector<Remedy> remedies;
  if (!decimal_comma && read_lenient(field, true).fault == NumberFault::none)
    remedies.push_back({"decimal", "comma"});
  return bad_data(place, field, expected_number(field, number.fault), std::move(remedies));
}

}  // namespace

void LineList::add(std::size_t line) {
  if (line == last) return;
  last = line;
  if (++count <= kLinesListed) first.push_back(line);
}

void LineList::append(const LineList& later) {
  count += later.count;
  const std::size_t room = kLinesListed - std::min(kLinesListed, first.size());
  first.insert(first.end(), later.first.begin(),
               later.first.begin() + static_cast<std::ptrdiff_t>(std::min(room, later.first.size())));
}

void RowNotes::append(const RowNotes& later) {
  for (const auto list : {&RowNotes::labelled, &RowNotes::comments, &RowNotes::empty, &RowNotes::headers,
                          &RowNotes::overloads, &RowNotes::converted, &RowNotes::cell_units}) {
    (this->*list).append(later.*list);
  }
  clocks += later.clocks;
  dates += later.dates;
  for (std::size_t k = 0; k < kColumns.size(); ++k) {
    missing[k] += later.missing[k];
    decimals[k] |= later.decimals[k];
  }
}

void RowBlock::append(RowBlock&& later) {
  for (const Column column : kColumns) {
    if (column != Column::mount) move_to_end(numbers(rows, column), numbers(later.rows, column));
  }
  move_to_end(rows.mount, later.rows.mount);
  move_to_end(rows.line, later.rows.line);
  notes.append(later.notes);
}

RowParser::RowParser(const RowFormat& format, RowBlock& block)
    : format_(format),
      block_(block),
      separator_(format.header.separation.mark),
      slots_(format.header.cells.size()) {
  for (const PlacedColumn& column : format.placed) {
    Slot& slot = slots_[column.index];
    slot.column = column.column;
    slot.unit = column.unit.symbol;
    if (column.column == Column::mount) {
      slot.labels = &block.rows.mount;
      continue;
    }
    slot.numbers = &numbers(block.rows, column.column);
    slot.to_canonical = column.unit.to_canonical;
    slot.non_negative = measured_by(column.column).has_value();
    slot.may_miss = column.column == Column::T || column.column == Column::t;
  }
}

void RowParser::reserve(std::size_t rows) {
  block_.rows.line.reserve(rows);
  for (const Slot& slot : slots_) {
    if (slot.numbers != nullptr) slot.numbers->reserve(rows);
    if (slot.labels != nullptr) slot.labels->reserve(rows);
  }
}

void RowParser::parse(std::string_view text, std::size_t first_line) {
  for_each_line(text, first_line, [this](std::string_view line, std::size_t number) {
    append(line, number);
    return true;
  });
  for (const Slot& slot : slots_)
    block_.notes.decimals[static_cast<std::size_t>(slot.column)] |= slot.decimals;
}

void RowParser::append(std::string_view line, std::size_t line_number) {
  const auto first = line.find_first_not_of(" \t");
  if (first == std::string_view::npos) return;
  const Separation& separation = format_.header.separation;
  const bool plain =
      line[first] != '#' && !format_.decimal_comma && !separation.blanks && !separation.fullwidth;
  if (!plain || !append_plain(line)) {
    append_other(line, line_number);
  } else {
    keep_row(line_number);
  }
}

void RowParser::keep_row(std::size_t line_number) {
  for (Slot& slot : slots_) slot.decimals |= slot.row_decimals;
  block_.rows.line.push_back(line_number);
}

bool RowParser::append_plain(std::string_view line) {
  const char* at = line.data();
  const char* const last = at + line.size();
  for (std::size_t k = 0; k < slots_.size(); ++k) {
    const bool there = k == 0 || at++ != last;
    at = there ? take(slots_[k], at, last) : nullptr;
    if (at == nullptr) {
      keep(block_.rows.line.size());
      return false;
    }
  }
  if (at == last) return true;
  keep(block_.rows.line.size());
  return false;
}

// Takes back what was appended of a row.
void RowParser::keep(std::size_t rows) {
  for (const Slot& slot : slots_) {
    if (slot.numbers != nullptr) slot.numbers->resize(rows);
    if (slot.labels != nullptr) slot.labels->resize(rows);
  }
}

// The separator that ends the field at `first`, or `last`. Null when the field is not plain.
const char* RowParser::take(Slot& slot, const char* first, const char* last) const {
  if (slot.numbers != nullptr) return take_number(slot, first, last);
  const char* const end = field_end(first, last, separator_);
  if (slot.labels == nullptr) return end;
  const std::string_view field = trim({first, static_cast<std::size_t>(end - first)}, separator_);
  auto text = unquoted(field);
  if (!text || !is_utf8(*text)) return nullptr;
  slot.labels->push_back(std::move(*text));
  return end;
}

const char* RowParser::take_number(Slot& slot, const char* first, const char* last) const {
  while (first != last && is_blank(*first, separator_)) ++first;
  const ScannedNumber number = scan_number(first, last);
  // Meters mark what they measure, not its uncertainty.
  const bool good = slot.non_negative ? number.value >= 0.0 : std::abs(number.value) < kOverload;
  if (number.fault != NumberFault::none || !good) return nullptr;
  const char* end = number.end;
  while (end != last && is_blank(*end, separator_)) ++end;
  if (end != last && *end != separator_) return nullptr;
  slot.numbers->push_back(number.value * slot.to_canonical);
  slot.row_decimals = bit_of(number.decimals);
  return end;
}

void RowParser::append_other(std::string_view line, std::size_t line_number) {
  RowNotes& notes = block_.notes;
  const std::string marked = separated_by_marks(line, format_.header.separation);
  std::vector<std::string_view> fields = split_fields(marked, separator_);
  const bool comment = line[line.find_first_not_of(" \t")] == '#';
  if (is_repeated_header(line, line_number)) return notes.headers.add(line_number);
  if (comment && !is_commented_row(fields)) return notes.comments.add(line_number);
  if (comment) notes.labelled.add(line_number);
  if (std::all_of(fields.begin(), fields.end(), [](std::string_view field) { return field.empty(); }))
    return notes.empty.add(line_number);
  require_fields(fields, line, line_number);
  if (format_.leave_out_overloads && has_overload(fields)) return notes.overloads.add(line_number);

  Place place{.file = format_.header.file, .row = line_number, .column = {}};
  for (std::size_t k = 0; k < slots_.size(); ++k) {
    Slot& slot = slots_[k];
    if (slot.numbers == nullptr && slot.labels == nullptr) continue;
    place.column = column_name(slot.column);
    if (slot.labels != nullptr) {
      take_label(slot, fields[k], place);
    } else {
      take_lenient(slot, fields[k], place);
    }
  }
  keep_row(line_number);
}

// A line that begins with '#' is a comment, unless it has the header's number of fields and a number in each
// that needs one, after a label such as "#0"; or an error of a spreadsheet in front.
bool RowParser::is_commented_row(const std::vector<std::string_view>& fields) const {
  if (fields.size() != slots_.size() || format_.header.separation.blanks) return false;
  if (is_spreadsheet_error(fields.front())) return true;
  if (fields.front().size() > 1 && is_blank(fields.front()[1], '\0')) return false;  // "# mean,…"
  return std::all_of(slots_.begin(), slots_.end(), [&](const Slot& slot) {
    if (slot.numbers == nullptr || slot.may_miss) return true;
    const auto text = unquoted(fields[static_cast<std::size_t>(&slot - slots_.data())]);
    if (!text) return false;
    const LenientNumber number = read_lenient(*text, format_.decimal_comma);
    return number.fault == NumberFault::none || number.overload;
  });
}

// Whether a line names columns as a header does: at least two of Proofmass's. Throws when it names others
// than the header: the rows below it would be read under the wrong names.
bool RowParser::is_repeated_header(std::string_view line, std::size_t line_number) const {
  if (line == format_.header.text) return true;
  const auto begin = line.find_first_not_of("# \t");
  if (begin == std::string_view::npos) return false;
  // Two names of columns have other letters than exponents have; most lines end here.
  if (line.find_first_not_of("0123456789.,;+-eEdD\"# \t") == std::string_view::npos) return false;
  const std::string marked = separated_by_marks(line.substr(begin), format_.header.separation);
  std::vector<std::string> cells;
  std::size_t known = 0;
  for (const std::string_view field : split_fields(marked, separator_)) {
    const HeaderCell cell = parse_header_cell(unquoted(field).value_or(""));
    cells.push_back(cell.text);
    if (find_column(cell.name)) ++known;
  }
  if (known < 2) return false;
  while (cells.size() > 1 && cells.back().empty()) cells.pop_back();
  const auto same = [](const std::string& text, const HeaderCell& cell) {
    return text == cell.text || parse_header_cell(text).name == cell.name;
  };
  const bool repeated =
      std::equal(cells.begin(), cells.end(), format_.header.cells.begin(), format_.header.cells.end(),
                 [&same](const std::string& text, const HeaderCell& cell) {
                   const HeaderCell again = parse_header_cell(text);
                   return same(text, cell) && (!again.unit || again.unit == cell.unit);
                 });
  if (repeated) return true;
  throw bad_data(
      {.file = format_.header.file, .row = line_number}, line,
      message("rows under the header of line {}; this looks like another header: put what follows into a "
              "file of its own",
              format_.header.row));
}

bool RowParser::has_overload(const std::vector<std::string_view>& fields) const {
  for (std::size_t k = 0; k < slots_.size(); ++k) {
    if (slots_[k].numbers == nullptr || slots_[k].may_miss) continue;
    const LenientNumber number = read_lenient(unquoted(fields[k]).value_or(""), format_.decimal_comma);
    // Meters mark what they measure, not its uncertainty.
    if (number.overload && (!slots_[k].non_negative || number.fault != NumberFault::none)) return true;
  }
  return false;
}

// Empty fields after the last column are no fields; columns that no step uses may be missing at the end.
void RowParser::require_fields(std::vector<std::string_view>& fields, std::string_view line,
                               std::size_t line_number) const {
  const std::size_t written = fields.size();
  while (fields.size() > slots_.size() && fields.back().empty()) fields.pop_back();
  const auto needed = [](const Slot& slot) {
    return slot.labels != nullptr || (slot.numbers != nullptr && !slot.may_miss);
  };
  // Of fields between blanks nobody knows which one is missing.
  const bool spare =
      fields.size() < slots_.size() && !format_.header.separation.blanks &&
      std::none_of(slots_.begin() + static_cast<std::ptrdiff_t>(fields.size()), slots_.end(), needed);
  if (spare) fields.resize(slots_.size());
  if (fields.size() == slots_.size()) return;
  throw bad_data(
      {.file = format_.header.file, .row = line_number, .column = {}}, line,
      message("{} as in the header, not {}", amount_of(slots_.size(), "field", "fields"), written));
}

void RowParser::take_label(const Slot& slot, std::string_view field, const Place& place) const {
  auto text = unquoted(field);
  if (!text) throw bad_data(place, field, "a field with matching quotes");
  if (!is_utf8(*text)) throw bad_data(place, field, "text in UTF-8", {{"encoding", "Windows-1252"}});
  slot.labels->push_back(std::move(*text));
}

void RowParser::take_lenient(Slot& slot, std::string_view field, const Place& place) {
  const std::string content = slot.may_miss ? unquoted(field).value_or("") : content_of(field, place);
  const LenientNumber number = read_lenient(content, format_.decimal_comma);
  const bool good = number.fault == NumberFault::none && (slot.non_negative || !number.overload);
  if (!good && slot.may_miss) return take_missing(slot, content);
  if (!good) throw bad_number(place, field, number, format_.decimal_comma);
  if (slot.non_negative && number.value < 0.0)
    throw bad_data(place, field, "a standard uncertainty, which is not negative");
  if (!number.unit.empty()) {
    if (find_unit(number.unit)->symbol != slot.unit)
      throw bad_data(place, field, message("a number, or one in the unit of the column, {}", slot.unit));
    block_.notes.cell_units.add(place.row);
  }
  if (number.converted) block_.notes.converted.add(place.row);
  slot.numbers->push_back(number.value * slot.to_canonical);
  slot.row_decimals = bit_of(number.decimals);
}

// A time of day or a date in the column t, or nothing that can be read.
void RowParser::take_missing(Slot& slot, std::string_view field) {
  if (slot.column == Column::t) {
    if (const auto time = read_time(field)) {
      ++(time->clock ? block_.notes.clocks : block_.notes.dates);
      return slot.numbers->push_back(time->seconds);
    }
  }
  ++block_.notes.missing[static_cast<std::size_t>(slot.column)];
  slot.numbers->push_back(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace proofmass
