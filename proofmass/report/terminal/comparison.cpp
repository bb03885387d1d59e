// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/terminal/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "proofmass/report/mape_rows.hpp"
#include "proofmass/report/number_text.hpp"
#include "proofmass/report/terminal/terminal_findings.hpp"
#include "proofmass/report/terminal/terminal_text.hpp"
#include "proofmass/report/terminal/terminal_words.hpp"
#include "proofmass/report/terminal/text_table.hpp"
#include "proofmass/report/terminal/with_figures_internal.hpp"
#include "proofmass/report/text/label.hpp"

namespace proofmass {
namespace {

std::string spread_text(const Spread& spread, int digits = 5) {
  if (!spread.sd) return significant_text(spread.mean, digits);
  return fmt::format("{} ± {}", significant_text(spread.mean, digits), significant_text(*spread.sd, 2));
}

std::string spread_text(const std::optional<Spread>& spread, int digits = 5) {
  return spread ? spread_text(*spread, digits) : "-";
}

std::string determination_spread(const std::optional<Spread>& r2) {
  if (!r2) return "-";
  return r2->sd ? fmt::format("{} ± {:.2g}", determination_text(r2->mean), *r2->sd)
                : determination_text(r2->mean);
}

// One run's counts are whole.
std::string count_text(const std::optional<Spread>& count) {
  return count && !count->sd ? fmt::format("{:.0f}", count->mean) : spread_text(count, 4);
}

std::string optional_text(const std::optional<double>& value) {
  return value ? significant_text(*value, 3) : "-";
}

std::string coefficient_text(const Run& run, Term term, Language language) {
  for (const Coefficient& c : run.identification.coefficients) {
    if (c.term != term) continue;
    if (!c.identified) {
      const Words why = c.left_out ? words(Label::left_out) : Words{"unidentifiable", "不可辨识"};
      return std::string(why.in(language));
    }
    if (!c.standard_error) return significant_text(c.value, 7);
    return fmt::format("{} ± {}", uncertain_text(c.value, c.standard_error),
                       significant_text(*c.standard_error, 2));
  }
  return "-";
}

void write_coefficients(TerminalText& out, const Comparison& comparison) {
  std::vector<std::string> header{out.in({"term", "项"})};
  if (comparison.truth) header.push_back(out.in({"truth", "真值"}));
  for (const Contestant& c : comparison.contestants) header.push_back(c.method);
  TextTable table(std::move(header));
  for (const Term term : terms_of(comparison)) {
    std::vector<std::string> row{std::string(name(term))};
    if (comparison.truth) row.push_back(fmt::format("{:.7g}", comparison.truth->coefficient(term)));
    for (const Contestant& c : comparison.contestants)
      row.push_back(coefficient_text(c.runs.front(), term, out.language()));
    table.add(std::move(row));
  }
  const Unit& unit = comparison.contestants.front().runs.front().identification.output_unit;
  out.heading(
      with_figures({"Coefficients, in {} per g^order, seed {}", "系数，单位 {} / g^阶次，随机种子 {}"},
                   out.language(), unit.canonical_symbol(), comparison.seed));
  out.table(table);
}

void write_mape_rows(TerminalText& out, const Comparison& comparison) {
  MapeRows rows;
  for (const Contestant& c : comparison.contestants) {
    for (const Run& run : c.runs) {
      rows.add(words(Label::train), run.identification.train);
      rows.add(words(Label::test), run.identification.test);
    }
  }
  if (const std::string text = rows.text(out.language()); !text.empty()) out.line(text);
}

void write_metrics(TerminalText& out, const Comparison& comparison) {
  TextTable table(
      {out.in({"method", "方法"}), out.in({"part", "部分"}), "MAE", "MSE", "RMSE", "MAPE %", "R²"});
  for (const Contestant& c : comparison.contestants) {
    const auto add = [&](const Words& part, const std::optional<MetricSpreads>& m) {
      if (!m) return;
      table.add({c.method, out.in(part), spread_text(m->mae), spread_text(m->mse), spread_text(m->rmse),
                 spread_text(m->mape_percent, 4), determination_spread(m->r2)});
    };
    add(kTrainingPart, c.train);
    add(words(Label::test), c.test);
  }
  const Unit& unit = comparison.contestants.front().runs.front().identification.output_unit;
  const std::string repeats = amount(comparison.repeats, {"repeat", "次重复"}, out.language());
  out.heading(with_figures({"Errors, in {}, {}", "误差，单位 {}，{}"}, out.language(), unit.symbol, repeats));
  out.table(table);
  write_mape_rows(out, comparison);
}

void write_costs(TerminalText& out, const Comparison& comparison) {
  const Contestant& first = comparison.contestants.front();
  TextTable table(header_in(out.language(), {{"method", "方法"},
                                             {"iterations", "迭代次数"},
                                             {"ratio", "比值"},
                                             {"time, s", "时间，s"},
                                             {"time ratio", "时间之比"},
                                             {"test MSE ratio", "测试 MSE 之比"},
                                             {"ended", "终止"}}),
                  Left::last_too);
  for (const Contestant& c : comparison.contestants) {
    const CostRatios ratios = ratios_to(first, c);
    table.add({c.method, count_text(c.iterations), optional_text(ratios.iterations), spread_text(c.time, 3),
               optional_text(ratios.time), optional_text(ratios.test_mse),
               out.in(status_words(c.runs.front().identification.ending.status))});
  }
  out.heading(with_figures({"Cost, ratios to {}", "计算量，与 {} 之比"}, out.language(), first.method));
  out.table(table);
}

void write_truth(TerminalText& out, const Comparison& comparison) {
  const bool known = std::any_of(comparison.contestants.begin(), comparison.contestants.end(),
                                 [](const Contestant& c) { return c.truth.has_value(); });
  if (!known) return;
  TextTable table(header_in(out.language(), {{"method", "方法"},
                                             {"rms error / std. error", "误差均方根 / 标准误差"},
                                             {"rms error / bound", "误差均方根 / 下界"},
                                             {"largest error", "最大误差"},
                                             {"of", "所在项"}}),
                  Left::last_too);
  for (const Contestant& c : comparison.contestants) {
    if (!c.truth) continue;
    table.add({c.method, optional_text(c.truth->rms_over_standard_error),
               optional_text(c.truth->rms_over_bound), significant_text(c.truth->largest_error, 3),
               std::string(name(c.truth->largest_term))});
  }
  out.heading(out.in({"Distance from the truth, over terms and repeats (1 is what noise explains)",
                      "与真值的偏差，统计各项和各次重复（1 为噪声所能解释的大小）"}));
  out.table(table);
}

Words heading_of(Severity severity) {
  switch (severity) {
    case Severity::warning:
      return {"Warnings on {}", "{} 的警告"};
    case Severity::note:
      return {"Notes on {}", "{} 的说明"};
    case Severity::basis:
      return {"Basis of {}", "{} 的依据"};
  }
  return {};
}

void write_method_findings(TerminalText& out, const Contestant& contestant, Severity severity) {
  const std::vector<Occurrence> said = occurrences(contestant, severity);
  if (said.empty()) return;
  out.heading(with_figures(heading_of(severity), out.language(), contestant.method));
  for (const Occurrence& occurrence : said) {
    const std::size_t all = contestant.runs.size();
    const std::string how_often = with_figures({" ({0} of {1} repeats)", "（{1} 次重复中有 {0} 次）"},
                                               out.language(), occurrence.repeats, all);
    write_finding(out, occurrence.finding, occurrence.repeats == all ? "" : how_often);
  }
}

void write_all_findings(TerminalText& out, const Comparison& comparison, Severity severity) {
  write_findings(out, comparison.findings, severity);
  for (const Contestant& contestant : comparison.contestants)
    write_method_findings(out, contestant, severity);
}

}  // namespace

std::string render_comparison(const Comparison& comparison, const TerminalStyle& style) {
  TerminalText out(style);
  write_all_findings(out, comparison, Severity::warning);
  write_coefficients(out, comparison);
  write_metrics(out, comparison);
  write_costs(out, comparison);
  write_truth(out, comparison);
  write_all_findings(out, comparison, Severity::note);
  write_all_findings(out, comparison, Severity::basis);
  return out.text();
}

}  // namespace proofmass
