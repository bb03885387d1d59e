// SPDX-License-Identifier: Apache-2.0
#include "proofmass/core/dataset.hpp"

namespace proofmass {
namespace {

template <typename Value>
std::vector<Value> pick(const std::vector<Value>& column, std::span<const std::size_t> rows) {
  std::vector<Value> picked;
  if (column.empty()) return picked;
  picked.reserve(rows.size());
  for (const std::size_t row : rows) picked.push_back(column[row]);
  return picked;
}

}  // namespace

std::vector<Axis> Dataset::axes() const {
  std::vector<Axis> present;
  for (const Axis axis : kAxes) {
    if (has(axis)) present.push_back(axis);
  }
  return present;
}

Acceleration Dataset::at(std::size_t row) const noexcept {
  const auto along_axis = [this, row](std::size_t axis) {
    return acceleration[axis].empty() ? 0.0 : acceleration[axis][row];
  };
  return {.i = along_axis(0), .o = along_axis(1), .p = along_axis(2)};
}

std::vector<std::size_t> Dataset::lines_of(std::span<const std::size_t> rows) const {
  constexpr std::size_t kMost = 10;
  std::vector<std::size_t> lines;
  for (const std::size_t row : rows.first(std::min(kMost, rows.size()))) lines.push_back(line_of(row));
  return lines;
}

Dataset Dataset::select(std::span<const std::size_t> rows) const {
  Dataset part;
  for (std::size_t axis = 0; axis < acceleration.size(); ++axis) {
    part.acceleration[axis] = pick(acceleration[axis], rows);
    part.acceleration_sigma[axis] = pick(acceleration_sigma[axis], rows);
  }
  part.output = pick(output, rows);
  part.output_sigma = pick(output_sigma, rows);
  part.mount = pick(mount, rows);
  part.temperature = pick(temperature, rows);
  part.time = pick(time, rows);
  part.line = pick(line, rows);
  part.output_unit = output_unit;
  part.acceleration_unit = acceleration_unit;
  part.temperature_unit = temperature_unit;
  part.time_unit = time_unit;
  part.output_unit_declared = output_unit_declared;
  part.acceleration_unit_declared = acceleration_unit_declared;
  part.acceleration_resolution = acceleration_resolution;
  part.source = source;
  part.source_sha256 = source_sha256;
  return part;
}

}  // namespace proofmass
