// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/error.hpp"
#include "proofmass/record/columns.hpp"
#include "proofmass/record/csv/layout.hpp"

namespace proofmass {

// Numbers of lines: how many, and the first few.
struct LineList {
  std::size_t count = 0;
  std::size_t last = 0;
  std::vector<std::size_t> first;

  // The line that was added last is not added again.
  void add(std::size_t line);
  void append(const LineList& later);
};

// How a record's rows are written.
struct RowFormat {
  Header header;
  std::vector<PlacedColumn> placed;
  bool decimal_comma = false;
  bool comma_proven = false;  // by a number that no thousands can be
  bool leave_out_overloads = false;
};

// What became of the lines of a record beside rows.
struct RowNotes {
  LineList labelled;                             // rows whose label begins with '#'
  LineList comments, empty, headers, overloads;  // lines without data, and rows that were left out
  LineList converted;                            // rows with numbers in other characters or exponents
  LineList cell_units;                           // rows with units in their cells
  std::array<std::size_t, kColumns.size()>
      missing{};                      // of a column that may miss values: rows without a number
  std::size_t clocks = 0, dates = 0;  // rows whose t is a time of day; a date and time
  // Of each column: bit d is set when a number has d digits after the point (31 and more together).
  std::array<std::uint32_t, kColumns.size()> decimals{};

  void append(const RowNotes& later);
};

// Consecutive rows of a record.
struct RowBlock {
  Dataset rows;
  RowNotes notes;

  void append(RowBlock&& later);
};

// Appends lines of a record to the columns of a block, in canonical units. The format and the block must
// outlive this object.
class RowParser {
 public:
  RowParser(const RowFormat& format, RowBlock& block);

  // Reserves memory for `rows` rows in total.
  void reserve(std::size_t rows);
  // Throws a bad-data Error that states what is wrong with a line.
  void parse(std::string_view text, std::size_t first_line);

 private:
  // Destination of a field of a line. The field is ignored when both pointers are null.
  struct Slot {
    std::vector<double>* numbers = nullptr;
    std::vector<std::string>* labels = nullptr;
    double to_canonical = 1.0;
    bool non_negative = false;
    bool may_miss = false;  // T and t: a value that cannot be read does not refuse the record
    std::uint32_t decimals = 0, row_decimals = 0;  // of the rows kept; of the last number read
    Column column = Column::Ai;
    std::string unit;
  };

  void append(std::string_view line, std::size_t line_number);
  // The common case, without a copy: unquoted numbers. False, and nothing appended, for any other line.
  [[nodiscard]] bool append_plain(std::string_view line);
  // Any other: comments, rows of empty fields, repeated headers, numbers in other forms.
  void append_other(std::string_view line, std::size_t line_number);
  [[nodiscard]] const char* take(Slot& slot, const char* first, const char* last) const;
  [[nodiscard]] const char* take_number(Slot& slot, const char* first, const char* last) const;
  void take_lenient(Slot& slot, std::string_view field, const Place& place);
  void take_missing(Slot& slot, std::string_view field);
  void take_label(const Slot& slot, std::string_view field, const Place& place) const;
  [[nodiscard]] bool is_commented_row(const std::vector<std::string_view>& fields) const;
  [[nodiscard]] bool has_overload(const std::vector<std::string_view>& fields) const;
  void require_fields(std::vector<std::string_view>& fields, std::string_view line,
                      std::size_t line_number) const;
  void keep(std::size_t rows);
  void keep_row(std::size_t line_number);
  [[nodiscard]] bool is_repeated_header(std::string_view line, std::size_t line_number) const;

  const RowFormat& format_;
  RowBlock& block_;
  char separator_;
  std::vector<Slot> slots_;  // one per field of a line
};

}  // namespace proofmass
