// SPDX-License-Identifier: Apache-2.0
// What reading a record skipped, converted and assumed, as findings.
#pragma once

#include "proofmass/core/dataset.hpp"
#include "proofmass/record/csv/lines.hpp"
#include "proofmass/record/csv/preamble.hpp"
#include "proofmass/record/csv/rows.hpp"

namespace proofmass {

// Turns times of day and dates into seconds since the first row, and drops the columns t and T where values
// are missing, with a finding.
void settle_optional_columns(Dataset& record, const RowNotes& notes);

// The step in which the inputs are written. Throws a bad-data Error when a column's points may part
// thousands: "16.384" beside "86", unless the options say what the mark is.
void settle_decimals(Dataset& record, RowFormat format, const RowNotes& notes, const ReadOptions& options);

// Adds the findings on lines, characters and units.
void add_reading_findings(Dataset& record, const ChunkReader& reader, const Preamble& preamble,
                          const RowFormat& format, const RowNotes& notes);

}  // namespace proofmass
