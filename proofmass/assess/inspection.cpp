// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/inspection.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "proofmass/assess/diagnosis/diagnosis.hpp"
#include "proofmass/assess/diagnosis/record/repeats.hpp"
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
  for (const auto& rows : rows_by_mount(labels))
    mounts.push_back({.name = labels[rows.front()], .rows = rows.size()});
  return mounts;
}

void add_repeats(Inspection& inspection, const Dataset& record) {
  std::vector<const std::vector<double>*> columns;
  for (const Axis axis : record.axes()) columns.push_back(&record.along(axis));
  inspection.repeated_inputs = count_repeats(record.rows(), columns);
  if (inspection.repeated_inputs == 0) return;  // then no whole rows are repeated either
  if (!record.output.empty()) columns.push_back(&record.output);
  inspection.repeated_rows = count_repeats(record.rows(), columns);
}

void add_presets(Inspection& inspection, const Dataset& record) {
  require_plausible_rows(record);
  const TermSums sums(record, parse_terms("full"));
  require_plausible_sizes(sums);
  for (const char* preset : {"linear", "quadratic", "paper", "full"}) {
    const TermList terms = parse_terms(preset);
    inspection.presets.push_back({.name = preset,
                                  .terms = terms.size(),
                                  .rows_needed = terms.size() + 1,
                                  .found = analyse_identifiability(sums, terms)});
  }
}

}  // namespace

Inspection inspect(const Dataset& record) {
  if (record.rows() == 0) {
    throw bad_data({.file = record.source, .row = 0, .column = {}}, "no data rows", "at least one");
  }
  Inspection inspection;
  inspection.source = record.source;
  inspection.source_sha256 = record.source_sha256;
  inspection.rows = record.rows();
  inspection.axes = record.axes();
  inspection.ignored = record.ignored;
  inspection.findings = record.findings;
  add_columns(inspection, record);
  inspection.mounts = summarise_mounts(record.mount);
  add_repeats(inspection, record);
  add_presets(inspection, record);
  if (!record.output.empty()) {
    const std::vector<Finding> found = diagnose_record(record);
    inspection.findings.insert(inspection.findings.end(), found.begin(), found.end());
  }
  return inspection;
}

}  // namespace proofmass
