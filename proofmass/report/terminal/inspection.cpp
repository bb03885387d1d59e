// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/terminal/inspection.hpp"

#include <fmt/format.h>

#include <cmath>

#include "proofmass/core/error.hpp"
#include "proofmass/core/text.hpp"
#include "proofmass/report/terminal/terminal_findings.hpp"
#include "proofmass/report/terminal/terminal_text.hpp"
#include "proofmass/report/text/en.hpp"

namespace proofmass {
namespace {

void write_columns(TerminalText& out, const std::vector<ColumnSummary>& columns) {
  TextTable table({"column", "unit", "minimum", "maximum", "mean"});
  for (const ColumnSummary& c : columns) {
    table.add({c.name, c.unit, fmt::format("{:.6g}", c.minimum), fmt::format("{:.6g}", c.maximum),
               fmt::format("{:.6g}", c.mean)});
  }
  out.table(table);
}

void write_ignored(TerminalText& out, const std::vector<IgnoredColumn>& columns) {
  if (columns.empty()) return;
  std::string names;
  for (const IgnoredColumn& column : columns) {
    names.append(names.empty() ? "" : ", ").append(excerpt(column.header));
    if (!column.nearest.empty()) names += fmt::format(" (not {}?)", column.nearest);
  }
  out.line(fmt::format("ignored columns: {}", names));
}

void write_mounts(TerminalText& out, const std::vector<MountSummary>& mounts) {
  if (mounts.empty()) return;
  out.heading("Mounts");
  TextTable table({"mount", "rows"});
  for (const MountSummary& mount : mounts) table.add({mount.name, std::to_string(mount.rows)});
  out.table(table);
}

std::string condition_text(double condition) {
  return std::isfinite(condition) ? fmt::format("{:.4g}", condition) : "-";
}

// One line a model; then, for the largest, each unidentifiable term with its reason.
void write_models(TerminalText& out, const Inspection& inspection) {
  out.heading("Terms that the inputs can identify");
  TextTable table({"model", "terms", "identified", "rows needed", "condition", "scaled", "unidentifiable"},
                  Left::last_too);
  for (const PresetVerdict& preset : inspection.presets) {
    TermList unidentified;
    for (const Finding& finding : preset.found.unidentified) unidentified.push_back(finding.terms.front());
    table.add({preset.name, std::to_string(preset.terms), std::to_string(preset.found.identified.size()),
               std::to_string(preset.rows_needed), condition_text(preset.found.condition_raw),
               condition_text(preset.found.condition_scaled), join_names(unidentified)});
  }
  out.table(table);
  if (inspection.presets.empty()) return;
  for (const Finding& finding : inspection.presets.back().found.unidentified) {
    out.warning(fmt::format("  {}: {}", name(finding.terms.front()), english_reason(finding)));
  }
}

}  // namespace

std::string render_inspection(const Inspection& inspection, const TerminalStyle& style) {
  TerminalText out(style);
  out.heading(fmt::format("{}: {}", inspection.source, amount_text(inspection.rows, "row")));
  write_findings(out, inspection.findings, Severity::warning);
  write_columns(out, inspection.columns);
  write_ignored(out, inspection.ignored);
  write_findings(out, inspection.findings, Severity::note);
  if (inspection.repeated_inputs > 0) {
    out.line(fmt::format("{} an earlier row's accelerations, {} of them its output too",
                         inspection.repeated_inputs == 1
                             ? "1 row repeats"
                             : std::to_string(inspection.repeated_inputs) + " rows repeat",
                         inspection.repeated_rows));
  }
  write_mounts(out, inspection.mounts);
  write_models(out, inspection);
  return out.text();
}

}  // namespace proofmass
