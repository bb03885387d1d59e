// SPDX-License-Identifier: Apache-2.0
#include "proofmass/record/csv/rows.hpp"

#include <fmt/format.h>

#include <utility>

#include "proofmass/core/utf8.hpp"
#include "proofmass/record/csv/fields.hpp"
#include "proofmass/record/csv/number.hpp"

namespace proofmass {

RowParser::RowParser(const Header& header, const std::vector<PlacedColumn>& placed, Dataset& record)
    : file_(header.file), separator_(header.separator), slots_(header.cells.size()), lines_(record.line) {
  for (const PlacedColumn& column : placed) {
    Slot& slot = slots_[column.index];
    slot.name = column_name(column.column);
    if (column.column == Column::mount) {
      slot.labels = &record.mount;
      continue;
    }
    slot.numbers = &numbers(record, column.column);
    slot.to_canonical = column.unit.to_canonical;
    slot.non_negative = measured_by(column.column).has_value();
  }
}

void RowParser::reserve(std::size_t rows) {
  lines_.reserve(rows);
  for (const Slot& slot : slots_) {
    if (slot.numbers != nullptr) slot.numbers->reserve(rows);
    if (slot.labels != nullptr) slot.labels->reserve(rows);
  }
}

void RowParser::append(std::string_view line, std::size_t line_number) {
  const char* at = line.data();
  const char* const last = at + line.size();
  for (std::size_t k = 0; k < slots_.size(); ++k) {
    if (k > 0 && at++ == last) throw diagnose(line, line_number, k);
    at = take(slots_[k], at, last);
    if (at == nullptr) throw diagnose(line, line_number, k);
  }
  if (at != last) throw diagnose(line, line_number, slots_.size());
  lines_.push_back(line_number);
}

const char* RowParser::take(const Slot& slot, const char* first, const char* last) const {
  if (slot.numbers != nullptr) {
    if (const char* const end = take_number(slot, first, last)) return end;
  }
  const char* const end = field_end(first, last, separator_);
  if (slot.numbers == nullptr && slot.labels == nullptr) return end;
  const std::string_view field = trim({first, static_cast<std::size_t>(end - first)}, separator_);
  return take_text(slot, field) ? end : nullptr;
}

// The common case, read without a copy or a second pass: an unquoted number between blanks.
const char* RowParser::take_number(const Slot& slot, const char* first, const char* last) const {
  while (first != last && is_blank(*first, separator_)) ++first;
  const ScannedNumber number = scan_number(first, last);
  if (number.fault != NumberFault::none || (slot.non_negative && number.value < 0.0)) return nullptr;
  const char* end = number.end;
  while (end != last && is_blank(*end, separator_)) ++end;
  if (end != last && *end != separator_) return nullptr;
  slot.numbers->push_back(number.value * slot.to_canonical);
  return end;
}

bool RowParser::take_text(const Slot& slot, std::string_view field) {
  auto text = unquoted(field);
  if (!text) return false;
  if (slot.labels != nullptr) {
    if (!is_utf8(*text)) return false;
    slot.labels->push_back(std::move(*text));
    return true;
  }
  const std::string_view content = trim(*text, ',');
  if (number_fault(content) != NumberFault::none) return false;
  const double value = scan_number(content.data(), content.data() + content.size()).value;
  if (slot.non_negative && value < 0.0) return false;
  slot.numbers->push_back(value * slot.to_canonical);
  return true;
}

Error RowParser::diagnose(std::string_view line, std::size_t line_number, std::size_t failed) const {
  const auto fields = split_fields(line, separator_);
  Place place{.file = file_, .row = line_number, .column = {}};
  if (fields.size() != slots_.size()) {
    return bad_data(place, line,
                    fmt::format("{} fields as in the header, not {}", slots_.size(), fields.size()));
  }
  const Slot& slot = slots_[failed];
  const std::string_view field = fields[failed];
  place.column = slot.name;
  const auto text = unquoted(field);
  if (!text) return bad_data(place, field, "a field with matching quotes");
  if (slot.labels != nullptr) return bad_data(place, field, "text in UTF-8");
  const std::string_view content = trim(*text, ',');
  const NumberFault fault = number_fault(content);
  if (fault != NumberFault::none) return bad_data(place, field, expected_number(content, fault));
  return bad_data(place, field, "a standard uncertainty, which is not negative");
}

}  // namespace proofmass
