// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "proofmass/core/finding.hpp"
#include "proofmass/core/term.hpp"
#include "proofmass/core/units.hpp"

namespace proofmass {

// A column of a file that no step uses.
struct IgnoredColumn {
  std::string header;
  std::string nearest;  // the column of the contract whose name it looks like a slip of; empty: none
};

// A test record as columns (structure of arrays). Every column that is not empty has rows() values.
struct Dataset {
  std::array<std::vector<double>, 3> acceleration;  // Ai, Ao, Ap in g; empty where the record lacks the axis
  std::vector<double> output;                       // E, in output_unit.canonical_symbol()
  std::array<std::vector<double>, 3>
      acceleration_sigma;            // standard uncertainties of Ai, Ao, Ap in g; optional
  std::vector<double> output_sigma;  // standard uncertainty of E, unit as output; optional
  std::vector<std::string> mount;    // label of the mounting position; optional
  std::vector<double> temperature;   // T, in temperature_unit; optional
  std::vector<double> time;          // t, in time_unit; optional
  std::vector<std::size_t> line;     // line of the file each row came from; empty otherwise

  Unit output_unit;        // as the record declares it
  Unit acceleration_unit;  // as the record declares it
  Unit temperature_unit{.quantity = Quantity::temperature, .symbol = "degC", .to_canonical = 1.0};
  Unit time_unit{.quantity = Quantity::time, .symbol = "s", .to_canonical = 1.0};
  bool output_unit_declared = true;        // by the record, not assumed
  bool acceleration_unit_declared = true;  // likewise
  // The step in which each input is written, in g: half of it is the largest rounding error. 0: not known.
  std::array<double, 3> acceleration_resolution{};
  std::vector<IgnoredColumn> ignored;
  std::vector<Finding> findings;  // what reading skipped, converted and assumed
  std::string source;             // file name, or what made the record
  std::string source_sha256;      // of the file's bytes; empty when not read from a file

  // Rows of the record. A record with inputs only (for prediction) counts the input rows.
  [[nodiscard]] std::size_t rows() const noexcept {
    return output.empty() ? acceleration[0].size() : output.size();
  }
  [[nodiscard]] bool has(Axis axis) const noexcept {
    return !acceleration[static_cast<std::size_t>(axis)].empty();
  }
  [[nodiscard]] const std::vector<double>& along(Axis axis) const noexcept {
    return acceleration[static_cast<std::size_t>(axis)];
  }
  // The axes the record has, in the order Ai, Ao, Ap.
  [[nodiscard]] std::vector<Axis> axes() const;
  // Specific force of one row. An axis that the record lacks counts as zero.
  [[nodiscard]] Acceleration at(std::size_t row) const noexcept;
  // Line of the file that a row came from; the row's number from 1 where it came from none.
  [[nodiscard]] std::size_t line_of(std::size_t row) const noexcept {
    return line.empty() ? row + 1 : line[row];
  }
  // Those of these rows.
  [[nodiscard]] std::vector<std::size_t> lines_of(std::span<const std::size_t> rows) const;
  // The rows with these numbers, in this order.
  [[nodiscard]] Dataset select(std::span<const std::size_t> rows) const;
};

// One row of three columns, one an axis; a column without values counts as zero.
[[nodiscard]] std::array<double, 3> across_axes(const std::array<std::vector<double>, 3>& columns,
                                                std::size_t row) noexcept;

// The rows of each mount, by the labels of the rows, in the order of its first row.
[[nodiscard]] std::vector<std::vector<std::size_t>> rows_by_mount(std::span<const std::string> mounts);

}  // namespace proofmass
