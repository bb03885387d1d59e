// SPDX-License-Identifier: Apache-2.0
#include "proofmass/record/csv.hpp"

#include "proofmass/core/error.hpp"
#include "proofmass/record/csv_fields.hpp"
#include "proofmass/record/csv_header.hpp"
#include "proofmass/record/csv_layout.hpp"
#include "proofmass/record/csv_lines.hpp"
#include "proofmass/record/csv_rows.hpp"

namespace proofmass {

Dataset read_record(const std::filesystem::path& path, const ReadOptions& options) {
  LineReader lines(path);
  const Header header = read_header(lines);
  const std::vector<PlacedColumn> placed = lay_out(header, options);

  Dataset record;
  record.source = lines.name();
  for (const PlacedColumn& column : placed) {
    if (column.column != Column::mount && !measured_by(column.column))
      unit_of(record, column.column) = column.unit;
  }
  RowParser rows(header, placed, record);
  while (const auto line = lines.next()) {
    if (!is_skipped(*line)) rows.append(*line, lines.line_number());
  }
  if (record.rows() == 0) {
    throw bad_data({.file = header.file, .row = header.row, .column = {}}, "a header alone",
                   "data rows below it");
  }
  record.source_sha256 = lines.sha256();
  return record;
}

}  // namespace proofmass
