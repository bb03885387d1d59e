// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/terminal/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "proofmass/core/text.hpp"
#include "proofmass/report/mape_rows.hpp"
#include "proofmass/report/number_text.hpp"
#include "proofmass/report/terminal/terminal_findings.hpp"
#include "proofmass/report/terminal/terminal_text.hpp"
#include "proofmass/report/terminal/text_table.hpp"

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

std::string coefficient_text(const Run& run, Term term) {
  for (const Coefficient& c : run.identification.coefficients) {
    if (c.term != term) continue;
    if (!c.identified) return c.left_out ? "left out" : "unidentifiable";
    if (!c.standard_error) return significant_text(c.value, 7);
    return fmt::format("{} ± {}", uncertain_text(c.value, c.standard_error),
                       significant_text(*c.standard_error, 2));
  }
  return "-";
}

void write_coefficients(TerminalText& out, const Comparison& comparison) {
  std::vector<std::string> header{"term"};
  if (comparison.truth) header.emplace_back("truth");
  std::vector<Term> terms;
  for (const Contestant& c : comparison.contestants) {
    header.push_back(c.method);
    for (const Coefficient& coefficient : c.runs.front().identification.coefficients)
      terms.push_back(coefficient.term);
  }
  std::sort(terms.begin(), terms.end());
  terms.erase(std::unique(terms.begin(), terms.end()), terms.end());
  TextTable table(std::move(header));
  for (const Term term : terms) {
    std::vector<std::string> row{std::string(name(term))};
    if (comparison.truth) row.push_back(fmt::format("{:.7g}", comparison.truth->coefficient(term)));
    for (const Contestant& c : comparison.contestants) row.push_back(coefficient_text(c.runs.front(), term));
    table.add(std::move(row));
  }
  const Unit& unit = comparison.contestants.front().runs.front().identification.output_unit;
  out.heading(
      fmt::format("Coefficients, in {} per g^order, seed {}", unit.canonical_symbol(), comparison.seed));
  out.table(table);
}

void write_mape_rows(TerminalText& out, const Comparison& comparison) {
  MapeRows rows;
  for (const Contestant& c : comparison.contestants) {
    for (const Run& run : c.runs) {
      rows.add("training", run.identification.train);
      rows.add("test", run.identification.test);
    }
  }
  if (const std::string text = rows.text(); !text.empty()) out.line(text);
}

void write_metrics(TerminalText& out, const Comparison& comparison) {
  TextTable table({"method", "part", "MAE", "MSE", "RMSE", "MAPE %", "R²"});
  for (const Contestant& c : comparison.contestants) {
    const auto add = [&table, &c](const char* part, const std::optional<MetricSpreads>& m) {
      if (!m) return;
      table.add({c.method, part, spread_text(m->mae), spread_text(m->mse), spread_text(m->rmse),
                 spread_text(m->mape_percent, 4), determination_spread(m->r2)});
    };
    add("train", c.train);
    add("test", c.test);
  }
  const Unit& unit = comparison.contestants.front().runs.front().identification.output_unit;
  out.heading(fmt::format("Errors, in {}, {}", unit.symbol, amount_text(comparison.repeats, "repeat")));
  out.table(table);
  write_mape_rows(out, comparison);
}

void write_costs(TerminalText& out, const Comparison& comparison) {
  const Contestant& first = comparison.contestants.front();
  TextTable table({"method", "iterations", "ratio", "time, s", "time ratio", "test MSE ratio", "ended"},
                  Left::last_too);
  for (const Contestant& c : comparison.contestants) {
    const CostRatios ratios = ratios_to(first, c);
    table.add({c.method, count_text(c.iterations), optional_text(ratios.iterations), spread_text(c.time, 3),
               optional_text(ratios.time), optional_text(ratios.test_mse),
               std::string(to_string(c.runs.front().identification.ending.status))});
  }
  out.heading(fmt::format("Cost, ratios to {}", first.method));
  out.table(table);
}

void write_truth(TerminalText& out, const Comparison& comparison) {
  const bool known = std::any_of(comparison.contestants.begin(), comparison.contestants.end(),
                                 [](const Contestant& c) { return c.truth.has_value(); });
  if (!known) return;
  TextTable table({"method", "rms error / std. error", "rms error / bound", "largest error", "of"},
                  Left::last_too);
  for (const Contestant& c : comparison.contestants) {
    if (!c.truth) continue;
    table.add({c.method, optional_text(c.truth->rms_over_standard_error),
               optional_text(c.truth->rms_over_bound), significant_text(c.truth->largest_error, 3),
               std::string(name(c.truth->largest_term))});
  }
  out.heading("Distance from the truth, over terms and repeats (1 is what noise explains)");
  out.table(table);
}

// A finding, with the figures of the first repeat that has it, and in how many repeats it occurs.
struct Occurrence {
  Finding finding;
  std::size_t repeats = 0;
};

std::string_view heading_of(Severity severity) {
  switch (severity) {
    case Severity::warning:
      return "Warnings on";
    case Severity::note:
      return "Notes on";
    case Severity::basis:
      return "Basis of";
  }
  return "";
}

void write_method_findings(TerminalText& out, const Contestant& contestant, Severity severity) {
  std::vector<Occurrence> said;
  for (const Run& run : contestant.runs) {
    for (const Finding& finding : run.identification.findings) {
      if (finding.severity != severity) continue;
      const auto same = [&finding](const Occurrence& other) {
        return other.finding.code == finding.code && other.finding.terms == finding.terms &&
               (finding.code != Code::verbatim || other.finding == finding);
      };
      auto known = std::find_if(said.begin(), said.end(), same);
      if (known == said.end()) known = said.insert(said.end(), {.finding = finding});
      ++known->repeats;
    }
  }
  if (said.empty()) return;
  out.heading(fmt::format("{} {}", heading_of(severity), contestant.method));
  for (const Occurrence& occurrence : said) {
    const bool always = occurrence.repeats == contestant.runs.size();
    write_finding(
        out, occurrence.finding,
        always ? "" : fmt::format(" ({} of {} repeats)", occurrence.repeats, contestant.runs.size()));
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
