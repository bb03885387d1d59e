// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/csv.hpp"

#include <fmt/format.h>

#include <ostream>
#include <stdexcept>

#include "proofmass/report/readable_units.hpp"

namespace proofmass {
namespace {

std::string_view word(Part part) {
  switch (part) {
    case Part::training:
      return "train";
    case Part::validation:
      return "validation";
    case Part::test:
      return "test";
  }
  throw std::invalid_argument("part of a record out of range");
}

// "Ai[g],Ao[g]," and the same for the values of one row.
std::string input_header(const Dataset& data) {
  std::string text;
  for (const Axis axis : data.axes()) text += fmt::format("{}[g],", axis_name(axis));
  return text;
}

std::string input_cells(const Dataset& data, std::size_t row) {
  std::string text;
  for (const Axis axis : data.axes()) text += fmt::format("{},", data.along(axis)[row]);
  return text;
}

}  // namespace

void write_predictions(std::ostream& out, const Dataset& record, std::span<const double> predicted,
                       std::span<const Part> parts) {
  if (predicted.size() != record.rows() || parts.size() != record.rows()) {
    throw std::invalid_argument("predictions and parts must have one entry a row");
  }
  const Unit& unit = record.output_unit;
  out << fmt::format("line,part,{1}E[{0}],E_predicted[{0}],residual[{0}]\n", unit.symbol,
                     input_header(record));
  for (std::size_t row = 0; row < record.rows(); ++row) {
    const std::size_t line = record.line_of(row);
    out << fmt::format("{},{},{}{},{},{}\n", line, word(parts[row]), input_cells(record, row),
                       to_declared(record.output[row], unit), to_declared(predicted[row], unit),
                       to_declared(record.output[row] - predicted[row], unit));
  }
}

void write_forecast(std::ostream& out, const Dataset& inputs, std::span<const double> predicted,
                    const Unit& output) {
  for (const Axis axis : inputs.axes()) {
    if (inputs.along(axis).size() != predicted.size()) {
      throw std::invalid_argument("predictions must have one entry a row");
    }
  }
  out << fmt::format("{}E_predicted[{}]\n", input_header(inputs), output.symbol);
  for (std::size_t row = 0; row < predicted.size(); ++row) {
    out << fmt::format("{}{}\n", input_cells(inputs, row), to_declared(predicted[row], output));
  }
}

void write_history(std::ostream& out, std::span<const Curve> curves) {
  out << "curve,iteration,value\n";
  for (const Curve& curve : curves) {
    for (std::size_t k = 0; k < curve.values.size(); ++k) {
      out << fmt::format("{},{},{}\n", curve.name, k, curve.values[k]);
    }
  }
}

}  // namespace proofmass
