// SPDX-License-Identifier: Apache-2.0
#include "proofmass/record/csv/notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>
#include <utility>

#include "proofmass/core/error.hpp"
#include "proofmass/record/columns.hpp"

namespace proofmass {
namespace {

constexpr double kDay = 86'400.0;

// Seconds since the first row; a clock that falls back by more than half a day has passed midnight.
void use_elapsed_seconds(std::vector<double>& time, bool clock) {
  double days = 0.0;
  double previous = time.front();
  const double start = time.front();
  for (double& value : time) {
    if (clock && value < previous - 0.5 * kDay) days += 1.0;
    previous = value;
    value += days * kDay - start;
  }
}

void drop(Dataset& record, Column column, std::size_t missing) {
  record.findings.push_back(
      {.code = Code::record_column_unusable,
       .figures = {
           {"column", std::string(column_name(column))}, {"count", missing}, {"total", record.rows()}}});
  numbers(record, column).clear();
}

void add_lines(Dataset& record, Code code, const LineList& lines) {
  if (lines.count == 0) return;
  record.findings.push_back({.code = code, .lines = lines.first, .figures = {{"count", lines.count}}});
}

// Digits after the point in a column's numbers, whole numbers aside: three and no others.
constexpr std::uint32_t kThousands = 1U | 1U << 3U;

bool is_whole(double value) { return value == std::floor(value); }

// Whether some number shows that its point is decimal: one below 1, or with more than three digits before the
// point.
bool shows_decimal_point(const std::vector<double>& values, double to_canonical) {
  return std::any_of(values.begin(), values.end(), [to_canonical](double value) {
    const double written = std::abs(value / to_canonical);
    return written != 0.0 && !is_whole(std::round(written * 1000.0) / 1000.0) &&
           (written < 1.0 || written >= 1000.0);
  });
}

void require_clear_thousands(const Dataset& record, const RowFormat& format, const PlacedColumn& column,
                             std::uint32_t decimals) {
  const std::vector<double>& values = numbers(record, column.column);
  const bool unclear =
      decimals == kThousands || (format.decimal_comma && decimals == 1U << 3U && !format.comma_proven);
  // Between commas a point is decimal.
  if (!unclear || format.header.separation.mark == ',' ||
      shows_decimal_point(values, column.unit.to_canonical))
    return;
  const auto parted = std::find_if(values.begin(), values.end(), [&column](double value) {
    return !is_whole(std::round(value / column.unit.to_canonical * 1000.0) / 1000.0);
  });
  if (parted == values.end()) return;
  const double written = std::round(*parted / column.unit.to_canonical * 1000.0) / 1000.0;
  const Message word = format.decimal_comma ? Message("comma") : Message("point");
  std::string found = fmt::format("{:.3f}", written);
  if (format.decimal_comma) std::replace(found.begin(), found.end(), '.', ',');
  throw bad_data(
      {.file = record.source,
       .row = record.line[static_cast<std::size_t>(parted - values.begin())],
       .column = std::string(column_name(column.column))},
      found,
      message("numbers whose {} is decimal for certain: here each has three digits after it or none at "
              "all, as thousands do. Take the {}s out if they part thousands",
              word, word),
      {{"decimal", word.english()}});
}

// Whether a number of the record shows that its comma is decimal.
bool proves_comma(const Dataset& record, const RowFormat& format, const RowNotes& notes) {
  return std::any_of(format.placed.begin(), format.placed.end(), [&](const PlacedColumn& p) {
    if (p.column == Column::mount) return false;
    const std::uint32_t decimals = notes.decimals[static_cast<std::size_t>(p.column)];
    return (decimals & ~kThousands) != 0 ||
           shows_decimal_point(numbers(record, p.column), p.unit.to_canonical);
  });
}

// "Ai, Ao, Ap"
std::string undeclared(const std::vector<PlacedColumn>& placed) {
  std::string names;
  for (const PlacedColumn& p : placed) {
    const bool has_unit = p.column != Column::mount && p.column != Column::T && p.column != Column::t;
    if (!has_unit || p.declared || measured_by(p.column)) continue;
    names.append(names.empty() ? "" : ", ").append(column_name(p.column));
  }
  return names;
}

void add_unit_findings(Dataset& record, const Preamble& preamble, const RowFormat& format,
                       const RowNotes& notes) {
  if (preamble.units_row) {
    record.findings.push_back({.code = Code::record_units_line, .lines = {*preamble.units_row}});
  }
  add_lines(record, Code::record_units_in_cells, notes.cell_units);
  for (const PlacedColumn& p : format.placed) {
    if (!format.header.cells[p.index].loose || !p.declared) continue;
    record.findings.push_back(
        {.code = Code::record_unit_in_name,
         .figures = {{"column", format.header.cells[p.index].text}, {"unit", p.unit.symbol}}});
  }
  if (std::string names = undeclared(format.placed); !names.empty()) {
    record.findings.push_back({.code = Code::record_units_assumed,
                               .figures = {{"columns", std::move(names)}, {"unit", std::string("g")}}});
  }
}

// "rpm, kii (Ki?)", the first of them.
void add_ignored_columns(Dataset& record) {
  constexpr std::size_t kMostNamed = 8;
  if (record.ignored.empty()) return;
  std::string names;
  for (std::size_t k = 0; k < std::min(record.ignored.size(), kMostNamed); ++k) {
    const IgnoredColumn& column = record.ignored[k];
    // In quotes where it would not be seen where the name ends.
    const bool plain = !column.header.empty() && column.header.find_first_of(" ,;\"") == std::string::npos;
    const std::string name = excerpt(column.header);
    names.append(k == 0 ? "" : ", ").append(plain ? name : "'" + name + "'");
    if (!column.nearest.empty()) names.append(" (").append(column.nearest).append("?)");
  }
  if (record.ignored.size() > kMostNamed) names.append(", …");
  record.findings.push_back({.code = Code::record_columns_ignored,
                             .figures = {{"count", record.ignored.size()}, {"columns", std::move(names)}}});
}

}  // namespace

void settle_optional_columns(Dataset& record, const RowNotes& notes) {
  for (const Column column : {Column::T, Column::t}) {
    const std::size_t missing = notes.missing[static_cast<std::size_t>(column)];
    if (missing > 0) drop(record, column, missing);
  }
  const std::size_t times = notes.clocks + notes.dates;
  if (times == 0 || record.time.empty()) return;
  if (notes.clocks != record.rows() && notes.dates != record.rows()) {
    drop(record, Column::t, record.rows() - std::max(notes.clocks, notes.dates));
    return;
  }
  use_elapsed_seconds(record.time, notes.clocks > 0);
  record.time_unit = *find_unit("s");
  record.findings.push_back({.code = Code::record_times_converted});
}

void settle_decimals(Dataset& record, RowFormat format, const RowNotes& notes, const ReadOptions& options) {
  format.comma_proven = format.decimal_comma && proves_comma(record, format, notes);
  // More are those of a value that is zero but for rounding, as 6.1e-17 for the cosine of a right angle, or
  // of a program that prints all digits it has: the other values of the column tell how it is written.
  constexpr unsigned kMostWrittenDecimals = 17;
  constexpr std::uint32_t kWritten = (std::uint32_t{1} << (kMostWrittenDecimals + 1)) - 1;
  for (const PlacedColumn& p : format.placed) {
    if (p.column == Column::mount || p.column == Column::t || p.column == Column::T) continue;
    const std::uint32_t decimals = notes.decimals[static_cast<std::size_t>(p.column)];
    if (options.decimal == DecimalMark::automatic) require_clear_thousands(record, format, p, decimals);
    static_assert(static_cast<std::size_t>(Column::Ap) == static_cast<std::size_t>(Axis::pendulous));
    const auto axis = static_cast<std::size_t>(p.column);
    const int most = static_cast<int>(std::bit_width(decimals & kWritten)) - 1;
    // Whole numbers are nominal positions, "1" and "-1" g, not measurements to the nearest g.
    if (axis < kAxes.size() && most >= 1)
      record.acceleration_resolution[axis] = std::pow(10.0, -most) * p.unit.to_canonical;
  }
}

void add_reading_findings(Dataset& record, const ChunkReader& reader, const Preamble& preamble,
                          const RowFormat& format, const RowNotes& notes) {
  if (reader.encoding() != Encoding::utf8) {
    record.findings.push_back(
        {.code = Code::record_decoded, .figures = {{"encoding", std::string(to_string(reader.encoding()))}}});
  }
  LineList skipped;
  for (const std::size_t line : preamble.skipped) skipped.add(line);
  add_lines(record, Code::record_preamble_skipped, skipped);
  if (preamble.header_in_comment)
    record.findings.push_back({.code = Code::record_header_in_comment, .lines = {preamble.header.row}});
  if (format.decimal_comma) record.findings.push_back({.code = Code::record_decimal_comma});
  add_lines(record, Code::record_labels_with_mark, notes.labelled);
  add_lines(record, Code::record_comments_skipped, notes.comments);
  add_lines(record, Code::record_empty_rows_skipped, notes.empty);
  add_lines(record, Code::record_headers_skipped, notes.headers);
  add_lines(record, Code::record_overloads_left_out, notes.overloads);
  add_lines(record, Code::record_numbers_converted, notes.converted);
  if (format.header.separation.fullwidth) record.findings.push_back({.code = Code::record_fullwidth});
  if (reader.had_end_mark()) record.findings.push_back({.code = Code::record_end_mark});
  add_unit_findings(record, preamble, format, notes);
  add_ignored_columns(record);
}

}  // namespace proofmass
