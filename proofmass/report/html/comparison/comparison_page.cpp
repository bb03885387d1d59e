// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/html/comparison/comparison_page.hpp"

#include <algorithm>

#include "proofmass/report/html/comparison/comparison_figures.hpp"
#include "proofmass/report/html/page/findings.hpp"
#include "proofmass/report/html/page/html.hpp"
#include "proofmass/report/html/page/provenance.hpp"
#include "proofmass/report/mape_rows.hpp"
#include "proofmass/report/readable_units.hpp"
#include "proofmass/report/shown_unit.hpp"
#include "proofmass/report/terminal/terminal_words.hpp"
#include "proofmass/report/typography.hpp"

namespace proofmass::html {
namespace {

Section findings_of_methods(const Comparison& comparison) {
  const Label how = comparison.repeats == 1 ? Label::comparison_text_once : Label::comparison_text;
  std::string body = paragraph(text_of(how, {{"methods", comparison.contestants.size()},
                                             {"input", comparison.input},
                                             {"repeats", comparison.repeats},
                                             {"fraction", comparison.training_fraction}}));
  for (const Finding& one : comparison.findings) body += finding(one);
  for (const Contestant& contestant : comparison.contestants) {
    std::string found;
    for (const Severity severity : {Severity::warning, Severity::note, Severity::basis}) {
      for (const Occurrence& one : occurrences(contestant, severity)) {
        const bool always = one.repeats == contestant.runs.size();
        const std::vector<Figure> counts{{"count", one.repeats}, {"total", contestant.runs.size()}};
        found += finding(one.finding, always ? Text() : text_of(Label::in_repeats, counts));
      }
    }
    if (!found.empty()) body += element("h3", escaped(contestant.method)) + found;
  }
  return {.id = "findings", .title = Label::findings, .body = body, .short_ = true};
}

std::string truth_table(const Comparison& comparison) {
  const Unit& output = first_result(comparison.contestants.front()).output_unit;
  Table table(text_of(Label::distance_truth), {{text_of(Label::method), Align::left},
                                               {text_of(Label::rms_error)},
                                               {text_of(Label::rms_bound)},
                                               {text_of(Label::largest_error)},
                                               {text_of(Label::unit), Align::left},
                                               {text_of(Label::term), Align::left}});
  for (const Contestant& c : comparison.contestants) {
    if (!c.truth) continue;
    table.add({escaped(c.method), number_cell(c.truth->rms_over_standard_error),
               number_cell(c.truth->rms_over_bound), number_cell(c.truth->largest_error),
               escaped(typeset_unit(coefficient_unit(c.truth->largest_term, output))),
               escaped(name(c.truth->largest_term))});
  }
  return table.empty() ? std::string() : table.html();
}

std::string scores_table(const Comparison& comparison) {
  const ShownUnit unit = error_unit(comparison);
  Table table(text_of(Label::scores),
              {{text_of(Label::method), Align::left},
               {text_of(Label::part), Align::left},
               {same_text("RMSE, " + unit.symbol)},
               {same_text("MAE, " + unit.symbol)},
               {same_text("MSE, " + squared_unit(unit.symbol))},
               {same_text("MAPE, %")},
               {same_text("R²")}},
              Table::Caption::hidden);
  for (const Contestant& c : comparison.contestants) {
    const auto add = [&](Label part, const std::optional<MetricSpreads>& m) {
      if (!m) return;
      table.add({escaped(c.method), both(text_of(part)), plus_minus_cell(m->rmse, unit.factor),
                 plus_minus_cell(m->mae, unit.factor), plus_minus_cell(m->mse, unit.factor * unit.factor),
                 plus_minus_cell(m->mape_percent), determination_cell(m->r2)});
    };
    add(Label::train, c.train);
    add(Label::test, c.test);
  }
  MapeRows rows;
  for (const Contestant& c : comparison.contestants) {
    for (const Run& run : c.runs) {
      rows.add(text_of(Label::train), run.identification.train);
      rows.add(text_of(Label::test), run.identification.test);
    }
  }
  return table.html() + paragraph({rows.text(Language::en), rows.text(Language::zh)});
}

// "iteration limit"
Text status_text(EndingStatus status) {
  Text text = status_words(status);
  std::replace(text.en.begin(), text.en.end(), '_', ' ');
  return text;
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
    table.add({escaped(c.method), count_cell(c.iterations), number_cell(ratios.iterations),
               plus_minus_cell(c.time), number_cell(ratios.time), number_cell(ratios.test_mse),
               both(status_text(first_result(c).ending.status))});
  }
  return table.html() + paragraph(text_of(Label::costs_text, {{"method", first.method}}));
}

Section settings(const Comparison& comparison, const std::string& date) {
  const Run& first = comparison.contestants.front().runs.front();
  Definitions about;
  add_record(about, first);
  about.add(text_of(Label::repeats), std::to_string(comparison.repeats));
  add_origin(about, first, date);
  std::string body = about.html() + reading_part(first.provenance);
  for (const Contestant& contestant : comparison.contestants)
    body += options_table(contestant.runs.front().provenance, same_text(contestant.method));
  return {.id = "settings", .title = Label::settings, .body = body};
}

}  // namespace

std::vector<Section> comparison_sections(const Comparison& comparison, InteractiveFigures& interactive,
                                         const std::string& date) {
  const StaticModel* const truth = comparison.truth ? &*comparison.truth : nullptr;
  const Text caption = text_of(Label::coefficients_of_seed, {{"seed", static_cast<double>(comparison.seed)}});
  std::vector<Section> sections{findings_of_methods(comparison)};
  sections.push_back({.id = "coefficients",
                      .title = Label::coefficients,
                      .body = coefficients_table(caption, terms_of(comparison), comparison.contestants, truth,
                                                 text_of(Label::truth)) +
                              truth_table(comparison) + deviation_figure(comparison, interactive)});
  sections.push_back({.id = "scores",
                      .title = Label::scores,
                      .body = scores_table(comparison) + repeats_figure(comparison, interactive)});
  sections.push_back({.id = "cost",
                      .title = Label::cost,
                      .body = costs_table(comparison) + time_figure(comparison, interactive)});
  sections.push_back(settings(comparison, date));
  return sections;
}

}  // namespace proofmass::html
