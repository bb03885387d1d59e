// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/inspection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <tuple>
#include <unordered_map>

#include "proofmass/core/error.hpp"

namespace proofmass {
namespace {

void add_column(Inspection& inspection, const std::string& name, const std::vector<double>& values,
                const Unit& unit) {
  if (values.empty()) return;
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  double mean = 0.0;
  for (const double value : values) mean += value / static_cast<double>(values.size());
  inspection.columns.push_back({.name = name,
                                .unit = unit.symbol,
                                .minimum = *low / unit.to_canonical,
                                .maximum = *high / unit.to_canonical,
                                .mean = mean / unit.to_canonical});
}

void add_columns(Inspection& inspection, const Dataset& record) {
  for (const Axis axis : record.axes()) {
    add_column(inspection, std::string(axis_name(axis)), record.along(axis), record.acceleration_unit);
  }
  add_column(inspection, "E", record.output, record.output_unit);
  add_column(inspection, "sigma_E", record.output_sigma, record.output_unit);
  inspection.has_output_sigma = !record.output_sigma.empty();
  for (const Axis axis : kAxes) {
    const auto& sigma = record.acceleration_sigma[static_cast<std::size_t>(axis)];
    add_column(inspection, fmt::format("sigma_{}", axis_name(axis)), sigma, record.acceleration_unit);
    if (!sigma.empty()) inspection.axes_with_sigma.push_back(axis);
  }
  add_column(inspection, "T", record.temperature, record.temperature_unit);
  add_column(inspection, "t", record.time, record.time_unit);
}

std::vector<MountSummary> summarise_mounts(const std::vector<std::string>& labels) {
  std::vector<MountSummary> mounts;
  std::unordered_map<std::string, std::size_t> place;
  for (const std::string& label : labels) {
    const auto [entry, is_new] = place.try_emplace(label, mounts.size());
    if (is_new) mounts.push_back({.name = label, .rows = 0});
    ++mounts[entry->second].rows;
  }
  return mounts;
}

// Rows whose key equals an earlier row's.
template <typename Key>
std::size_t count_repeats(std::size_t rows, Key key) {
  std::vector<std::size_t> order(rows);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  std::size_t repeats = 0;
  for (std::size_t k = 1; k < rows; ++k) repeats += key(order[k]) == key(order[k - 1]) ? 1U : 0U;
  return repeats;
}

void add_presets(Inspection& inspection, const Dataset& record) {
  for (const char* preset : {"linear", "quadratic", "paper", "full"}) {
    const TermList terms = parse_terms(preset);
    inspection.presets.push_back({.name = preset,
                                  .terms = terms.size(),
                                  .rows_needed = terms.size() + 1,
                                  .found = analyse_identifiability(record, terms)});
  }
}

}  // namespace

Inspection inspect(const Dataset& record) {
  if (record.rows() == 0) {
    throw bad_data({.file = record.source, .row = 0, .column = {}}, "no data rows", "at least one");
  }
  const auto inputs = [&record](std::size_t row) {
    const Acceleration a = record.at(row);
    return std::tuple(a.i, a.o, a.p);
  };
  Inspection inspection;
  inspection.source = record.source;
  inspection.source_sha256 = record.source_sha256;
  inspection.rows = record.rows();
  inspection.axes = record.axes();
  add_columns(inspection, record);
  inspection.mounts = summarise_mounts(record.mount);
  inspection.repeated_inputs = count_repeats(record.rows(), inputs);
  inspection.repeated_rows = count_repeats(record.rows(), [&](std::size_t row) {
    return std::tuple_cat(inputs(row), std::tuple(record.output[row]));
  });
  add_presets(inspection, record);
  return inspection;
}

}  // namespace proofmass
