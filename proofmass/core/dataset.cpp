// SPDX-License-Identifier: Apache-2.0
#include "proofmass/core/dataset.hpp"

#include <algorithm>
#include <string_view>
#include <unordered_map>

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

std::array<double, 3> across_axes(const std::array<std::vector<double>, 3>& columns,
                                  std::size_t row) noexcept {
  const auto along = [row](const std::vector<double>& column) { return column.empty() ? 0.0 : column[row]; };
  return {along(columns[0]), along(columns[1]), along(columns[2])};
}

Acceleration Dataset::at(std::size_t row) const noexcept {
  const auto [i, o, p] = across_axes(acceleration, row);
  return {.i = i, .o = o, .p = p};
}

std::vector<std::size_t> Dataset::lines_of(std::span<const std::size_t> rows) const {
  std::vector<std::size_t> lines;
  lines.reserve(rows.size());
  for (const std::size_t row : rows) lines.push_back(line_of(row));
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

std::vector<std::vector<std::size_t>> rows_by_mount(std::span<const std::string> mounts) {
  std::unordered_map<std::string_view, std::size_t> place;
  std::vector<std::vector<std::size_t>> members;
  for (std::size_t row = 0; row < mounts.size(); ++row) {
    const auto [entry, is_new] = place.try_emplace(mounts[row], members.size());
    if (is_new) members.emplace_back();
    members[entry->second].push_back(row);
  }
  return members;
}

}  // namespace proofmass
