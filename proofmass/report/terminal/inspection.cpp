// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/terminal/inspection.hpp"

#include <fmt/format.h>

#include <cmath>

#include "proofmass/core/error.hpp"
#include "proofmass/report/terminal/terminal_findings.hpp"
#include "proofmass/report/terminal/terminal_text.hpp"
#include "proofmass/report/terminal/terminal_words.hpp"
#include "proofmass/report/terminal/with_figures_internal.hpp"
#include "proofmass/report/text/findings.hpp"
#include "proofmass/report/text/sentence.hpp"

namespace proofmass {
namespace {

void write_columns(TerminalText& out, const std::vector<ColumnSummary>& columns) {
  TextTable table(header_in(out.language(), {{"column", "列"},
                                             {"unit", "单位"},
                                             {"minimum", "最小值"},
                                             {"maximum", "最大值"},
                                             {"mean", "平均值"}}));
  for (const ColumnSummary& c : columns) {
    table.add({c.name, c.unit, fmt::format("{:.6g}", c.minimum), fmt::format("{:.6g}", c.maximum),
               fmt::format("{:.6g}", c.mean)});
  }
  out.table(table);
}

void write_mounts(TerminalText& out, const std::vector<MountSummary>& mounts) {
  if (mounts.empty()) return;
  out.heading(out.in({"Mounts", "安装位置"}));
  TextTable table(header_in(out.language(), {{"mount", "安装位置"}, {"rows", "行数"}}));
  for (const MountSummary& mount : mounts) table.add({mount.name, std::to_string(mount.rows)});
  out.table(table);
}

std::string condition_text(double condition) {
  return std::isfinite(condition) ? fmt::format("{:.4g}", condition) : "-";
}

// One line a model; then, for the largest, each unidentifiable term with its reason.
void write_models(TerminalText& out, const Inspection& inspection) {
  out.heading(out.in({"Terms that the inputs can identify", "输入能够辨识的模型项"}));
  TextTable table(header_in(out.language(), {{"model", "模型"},
                                             {"terms", "项数"},
                                             {"identified", "可辨识"},
                                             {"rows needed", "所需行数"},
                                             {"condition", "条件数"},
                                             {"scaled", "归一化后"},
                                             {"unidentifiable", "不可辨识"}}),
                  Left::last_too);
  for (const PresetVerdict& preset : inspection.presets) {
    TermList unidentified;
    for (const Finding& finding : preset.found.unidentified) unidentified.push_back(finding.terms.front());
    table.add({preset.name, std::to_string(preset.terms), std::to_string(preset.found.identified.size()),
               std::to_string(preset.rows_needed), condition_text(preset.found.condition_raw),
               condition_text(preset.found.condition_scaled), listed_names(unidentified, out.language())});
  }
  out.table(table);
  if (inspection.presets.empty()) return;
  for (const Finding& finding : inspection.presets.back().found.unidentified) {
    out.warning(with_figures({"  {}: {}", "  {}：{}"}, out.language(), name(finding.terms.front()),
                             reason(finding, out.language())));
  }
}

constexpr std::string_view kRepeatedInChinese = "{} 行与先前某行的加速度相同，其中 {} 行的输出也相同";

}  // namespace

std::string render_inspection(const Inspection& inspection, const TerminalStyle& style) {
  TerminalText out(style);
  out.heading(with_figures({"{}: {}", "{}：{}"}, out.language(), inspection.source,
                           amount(inspection.rows, {"row", "行"}, out.language())));
  write_findings(out, inspection.findings, Severity::warning);
  write_columns(out, inspection.columns);
  write_findings(out, inspection.findings, Severity::note);
  if (inspection.repeated_inputs > 0) {
    const Words repeats =
        inspection.repeated_inputs == 1
            ? Words{"{} row repeats an earlier row's accelerations, {} of them its output too",
                    kRepeatedInChinese}
            : Words{"{} rows repeat an earlier row's accelerations, {} of them its output too",
                    kRepeatedInChinese};
    out.line(with_figures(repeats, out.language(), inspection.repeated_inputs, inspection.repeated_rows));
  }
  write_mounts(out, inspection.mounts);
  write_models(out, inspection);
  return out.text();
}

}  // namespace proofmass
