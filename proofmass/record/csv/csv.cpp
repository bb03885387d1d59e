// SPDX-License-Identifier: Apache-2.0
#include "proofmass/record/csv/csv.hpp"

#include <algorithm>
#include <cstddef>

#include "proofmass/core/error.hpp"
#include "proofmass/record/csv/fields.hpp"
#include "proofmass/record/csv/header.hpp"
#include "proofmass/record/csv/layout.hpp"
#include "proofmass/record/csv/lines.hpp"
#include "proofmass/record/csv/rows.hpp"

namespace proofmass {
namespace {

constexpr std::size_t kSample = 1000;  // rows whose mean length predicts the number of rows in the file
constexpr std::size_t kMostExpected = std::size_t{1} << 24;  // most rows to reserve memory for in advance

void append_rows(LineReader& lines, RowParser& rows) {
  for (std::size_t count = 0; const auto line = lines.next();) {
    if (is_skipped(*line)) continue;
    rows.append(*line, lines.line_number());
    // Reserving memory in advance, with a small margin, avoids copies of the columns as they grow.
    if (++count != kSample) continue;
    const std::size_t expected = lines.expected_lines();
    rows.reserve(std::min(expected + expected / 20, kMostExpected));
  }
}

}  // namespace

Dataset read_record(const std::filesystem::path& path, const ReadOptions& options) {
  SilentProgress nobody;
  return read_record(path, options, nobody);
}

Dataset read_record(const std::filesystem::path& path, const ReadOptions& options, Progress& progress) {
  LineReader lines(path, progress);
  const Header header = read_header(lines);
  const std::vector<PlacedColumn> placed = lay_out(header, options);

  Dataset record;
  record.source = lines.name();
  for (const PlacedColumn& column : placed) {
    if (column.column != Column::mount && !measured_by(column.column))
      unit_of(record, column.column) = column.unit;
  }
  RowParser rows(header, placed, record);
  append_rows(lines, rows);
  if (record.rows() == 0) {
    throw bad_data({.file = header.file, .row = header.row, .column = {}}, "a header alone",
                   "data rows below it");
  }
  record.source_sha256 = lines.sha256();
  return record;
}

}  // namespace proofmass
