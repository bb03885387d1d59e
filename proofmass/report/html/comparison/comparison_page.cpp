// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/html/comparison/comparison_page.hpp"

#include <fmt/format.h>

#include "proofmass/report/coefficient_text.hpp"
#include "proofmass/report/html/comparison/comparison_figures.hpp"
#include "proofmass/report/html/page/findings.hpp"
#include "proofmass/report/html/page/html.hpp"
#include "proofmass/report/number_text.hpp"
#include "proofmass/report/typography.hpp"

namespace proofmass::html {
namespace {

const Identification& first_result(const Contestant& contestant) {
  return contestant.runs.front().identification;
}

Section findings_of_methods(const Comparison& comparison) {
  std::string body = paragraph(text_of(Label::comparison_text, {{"methods", comparison.contestants.size()},
                                                                {"input", comparison.input},
                                                                {"repeats", comparison.repeats},
                                                                {"fraction", comparison.training_fraction}}));
  for (const Finding& one : comparison.findings) body += finding(one);
  for (const Contestant& contestant : comparison.contestants) {
    std::string found;
    for (const Finding& one : first_result(contestant).findings)
      if (one.severity != Severity::basis) found += finding(one);
    if (!found.empty()) body += element("h3", escaped(contestant.method)) + found;
  }
  return {.id = "findings", .title = Label::findings, .body = body, .short_ = true};
}

std::string reading_of(const Contestant& contestant, Term term) {
  const Identification& result = first_result(contestant);
  for (const Coefficient& c : result.coefficients) {
    if (c.term != term) continue;
    if (!c.identified) return both(text_of(c.left_out ? Label::left_out : Label::unidentifiable));
    return in_print(readable_number(c, result.output_unit));
  }
  return "–";
}

// In the units that people speak; the columns are narrower then.
std::string coefficients_table(const Comparison& comparison) {
  const Unit& output = first_result(comparison.contestants.front()).output_unit;
  std::vector<Column> columns{{text_of(Label::term), Align::left}, {text_of(Label::unit), Align::left}};
  if (comparison.truth) columns.push_back({text_of(Label::truth)});
  for (const Contestant& contestant : comparison.contestants)
    columns.push_back({same_text(contestant.method)});
  Table table(text_of(Label::coefficients_of_seed, {{"seed", static_cast<double>(comparison.seed)}}),
              std::move(columns));
  for (const Term term : terms_of(comparison)) {
    const bool deviation = output.is_acceleration() && term == Term::Ki;
    std::vector<std::string> cells{escaped(deviation ? "Ki − 1" : std::string(name(term))),
                                   escaped(typeset_unit(reading_unit(term, output)))};
    if (comparison.truth) {
      Coefficient truth;
      truth.term = term;
      truth.value = comparison.truth->coefficient(term);
      cells.push_back(in_print(readable_number(truth, output)));
    }
    for (const Contestant& contestant : comparison.contestants) cells.push_back(reading_of(contestant, term));
    table.add(std::move(cells));
  }
  return table.html();
}

std::string truth_table(const Comparison& comparison) {
  Table table(text_of(Label::distance_truth), {{text_of(Label::method), Align::left},
                                               {text_of(Label::rms_error)},
                                               {text_of(Label::rms_bound)},
                                               {text_of(Label::largest_error)},
                                               {text_of(Label::term), Align::left}});
  for (const Contestant& c : comparison.contestants) {
    if (!c.truth) continue;
    table.add({escaped(c.method), number_cell(c.truth->rms_over_standard_error),
               number_cell(c.truth->rms_over_bound), number_cell(c.truth->largest_error),
               escaped(name(c.truth->largest_term))});
  }
  return table.empty() ? std::string() : table.html();
}

std::string scores_table(const Comparison& comparison) {
  const std::string unit = typeset_unit(first_result(comparison.contestants.front()).output_unit.symbol);
  Table table(text_of(Label::scores),
              {{text_of(Label::method), Align::left},
               {text_of(Label::part), Align::left},
               {same_text("RMSE, " + unit)},
               {same_text("MAE, " + unit)},
               {same_text("MSE")},
               {same_text("MAPE, %")},
               {same_text("R²")}},
              Table::Caption::hidden);
  for (const Contestant& c : comparison.contestants) {
    const auto add = [&](Label part, const std::optional<MetricSpreads>& m) {
      if (!m) return;
      table.add({escaped(c.method), both(text_of(part)), spread_cell(m->rmse, 5), spread_cell(m->mae, 5),
                 spread_cell(m->mse, 5), spread_cell(m->mape_percent, 4), determination_cell(m->r2)});
    };
    add(Label::train, c.train);
    add(Label::test, c.test);
  }
  return table.html() + paragraph(text_of(Label::mape_note));
}

std::string costs_table(const Comparison& comparison) {
  const Contestant& first = comparison.contestants.front();
  Table table(text_of(Label::cost),
              {{text_of(Label::method), Align::left},
               {text_of(Label::iterations)},
               {text_of(Label::iterations_ratio)},
               {text_of(Label::time_seconds)},
               {text_of(Label::time_ratio)},
               {text_of(Label::mse_ratio)},
               {text_of(Label::ended), Align::left}},
              Table::Caption::hidden);
  for (const Contestant& c : comparison.contestants) {
    const CostRatios ratios = ratios_to(first, c);
    table.add({escaped(c.method), spread_cell(c.iterations, 4), number_cell(ratios.iterations),
               spread_cell(c.time, 3), number_cell(ratios.time), number_cell(ratios.test_mse),
               escaped(to_string(first_result(c).ending.status))});
  }
  return table.html() + paragraph(text_of(Label::costs_text, {{"method", first.method}}));
}

Section settings(const Comparison& comparison) {
  const Provenance& provenance = comparison.contestants.front().runs.front().provenance;
  Definitions about;
  about.add(text_of(Label::record), escaped(comparison.input));
  if (!provenance.input_sha256.empty())
    about.add(text_of(Label::sha256), element("code", escaped(provenance.input_sha256)));
  about.add(text_of(Label::seed), std::to_string(comparison.seed));
  about.add(text_of(Label::repeats), std::to_string(comparison.repeats));
  about.add(text_of(Label::version), escaped(provenance.version));
  std::string body = about.html() + element("h3", both(text_of(Label::reading)));
  if (provenance.reading.empty()) body += paragraph(text_of(Label::reading_nothing));
  for (const Finding& one : provenance.reading) body += finding(one);
  for (const Contestant& contestant : comparison.contestants) {
    Table table(same_text(contestant.method),
                {{text_of(Label::options), Align::left}, {text_of(Label::value), Align::left}});
    for (const auto& [option, value] : contestant.runs.front().provenance.options)
      table.add({escaped(option), escaped(value)});
    body += table.html();
  }
  return {.id = "settings", .title = Label::settings, .body = body};
}

}  // namespace

std::vector<Section> comparison_sections(const Comparison& comparison, InteractiveFigures& interactive) {
  std::vector<Section> sections{findings_of_methods(comparison)};
  sections.push_back({.id = "coefficients",
                      .title = Label::coefficients,
                      .body = coefficients_table(comparison) + truth_table(comparison) +
                              deviation_figure(comparison, interactive)});
  sections.push_back({.id = "scores",
                      .title = Label::scores,
                      .body = scores_table(comparison) + repeats_figure(comparison, interactive)});
  sections.push_back({.id = "cost",
                      .title = Label::cost,
                      .body = costs_table(comparison) + time_figure(comparison, interactive)});
  sections.push_back(settings(comparison));
  return sections;
}

}  // namespace proofmass::html
