// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/terminal/inspection.hpp"

#include <fmt/format.h>

#include <cmath>

#include "proofmass/report/terminal/terminal_text.hpp"

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

// One line a model; then, for the largest, each lost term with its reason.
void write_models(TerminalText& out, const Inspection& inspection) {
  out.heading("Terms that the inputs can identify");
  TextTable table({"model", "terms", "identified", "rows needed", "condition", "scaled", "unidentifiable"},
                  true);
  for (const PresetVerdict& preset : inspection.presets) {
    TermList lost;
    for (const Unidentifiable& term : preset.found.lost) lost.push_back(term.term);
    table.add({preset.name, std::to_string(preset.terms), std::to_string(preset.found.identified.size()),
               std::to_string(preset.rows_needed), condition_text(preset.found.condition_raw),
               condition_text(preset.found.condition_scaled), join_names(lost)});
  }
  out.table(table);
  if (inspection.presets.empty()) return;
  for (const Unidentifiable& lost : inspection.presets.back().found.lost) {
    out.warning(fmt::format("  {}: {}", name(lost.term), lost.reason));
  }
}

}  // namespace

std::string render_inspection(const Inspection& inspection, const TerminalStyle& style) {
  TerminalText out(style);
  out.heading(fmt::format("{}: {} rows", inspection.source, inspection.rows));
  write_columns(out, inspection.columns);
  if (inspection.repeated_inputs > 0) {
    out.line(fmt::format("{} rows repeat an earlier row's accelerations, {} of them its output too",
                         inspection.repeated_inputs, inspection.repeated_rows));
  }
  write_mounts(out, inspection.mounts);
  write_models(out, inspection);
  return out.text();
}

}  // namespace proofmass
