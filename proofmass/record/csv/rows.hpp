// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/error.hpp"
#include "proofmass/record/csv/layout.hpp"

namespace proofmass {

// Appends lines of a record to the columns of a data set, in canonical units. The data set must outlive this
// object.
class RowParser {
 public:
  RowParser(const Header& header, const std::vector<PlacedColumn>& placed, Dataset& record);

  // Reserves memory for `rows` rows in total.
  void reserve(std::size_t rows);
  // Throws a bad-data Error that states what is wrong with the line.
  void append(std::string_view line, std::size_t line_number);

 private:
  // Destination of a field of a line. The field is ignored when both pointers are null.
  struct Slot {
    std::vector<double>* numbers = nullptr;
    std::vector<std::string>* labels = nullptr;
    double to_canonical = 1.0;
    bool non_negative = false;
    std::string name;
  };

  // The separator that ends the field at `first`, or `last`. Null when the field is not of the slot's type.
  [[nodiscard]] const char* take(const Slot& slot, const char* first, const char* last) const;
  [[nodiscard]] const char* take_number(const Slot& slot, const char* first, const char* last) const;
  [[nodiscard]] static bool take_text(const Slot& slot, std::string_view field);
  [[nodiscard]] Error diagnose(std::string_view line, std::size_t line_number, std::size_t failed) const;

  std::string file_;
  char separator_;
  std::vector<Slot> slots_;  // one per field of a line
  std::vector<std::size_t>& lines_;
};

}  // namespace proofmass
