// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/html/reproduction/reproduction_page.hpp"

#include <algorithm>

#include "proofmass/core/version.hpp"
#include "proofmass/report/html/comparison/comparison_page.hpp"
#include "proofmass/report/html/page/html.hpp"
#include "proofmass/report/number_text.hpp"
#include "proofmass/report/paper/reproduction_figures_internal.hpp"
#include "proofmass/report/text/names.hpp"
#include "proofmass/report/typography.hpp"
#include "proofmass/study/paper/citation.hpp"

namespace proofmass::html {
namespace {

Section table_1(const Reproduction& made) {
  Table table(
      text_of(Label::table_1),
      {{text_of(Label::hidden)}, {text_of(Label::mean)}, {text_of(Label::least)}, {text_of(Label::largest)}},
      Table::Caption::hidden);
  for (const HiddenSizeScore& size : made.sizes) {
    const auto [least, most] = std::minmax_element(size.training_mse.begin(), size.training_mse.end());
    table.add({std::to_string(size.hidden), number_cell(spread_of(size.training_mse).mean, 4),
               number_cell(*least, 4), number_cell(*most, 4)});
  }
  const Text text = text_of(Label::table_1_text, {{"unit", typeset_unit(made.unit)},
                                                  {"repeats", made.sizes.front().training_mse.size()}});
  return {.id = "table-1", .title = Label::table_1, .body = paragraph(text) + table.html(), .short_ = true};
}

// Of each method's coefficients from the truth, and its test error.
std::string distances(const Reproduction& made) {
  Table table(text_of(Label::distance_truth), {{text_of(Label::method), Align::left},
                                               {text_of(Label::rms_error)},
                                               {text_of(Label::rms_bound)},
                                               {text_of(Label::test_mse)}});
  for (const Contestant& c : made.coefficients.contestants) {
    table.add({both(entry_name(c.method)), number_cell(c.truth->rms_over_standard_error),
               number_cell(c.truth->rms_over_bound), c.test ? spread_cell(c.test->mse, 4) : "–"});
  }
  return table.html();
}

Section table_2(const Reproduction& made) {
  TermList terms;
  for (const TermInfo& term : all_terms()) terms.push_back(term.term);
  const std::string table =
      coefficients_table(text_of(Label::table_2), terms, made.coefficients.contestants, &made.truth,
                         text_of(Label::paper_truth), Table::Caption::hidden);
  return {.id = "table-2",
          .title = Label::table_2,
          .body = paragraph(text_of(Label::table_2_text)) + table + distances(made)};
}

Section table_3(const Reproduction& made) {
  Table table(text_of(Label::table_3),
              {{text_of(Label::method), Align::left},
               {text_of(Label::paper_mse)},
               {same_text("MSE")},
               {same_text("MAE")},
               {same_text("RMSE")},
               {same_text("MAPE, %")},
               {same_text("R²")},
               {text_of(Label::training_mse)},
               {text_of(Label::iterations)},
               {text_of(Label::time_seconds)}},
              Table::Caption::hidden);
  for (std::size_t k = 0; k < made.networks.contestants.size(); ++k) {
    const Contestant& c = made.networks.contestants[k];
    const std::string paper = k < kPaperTestMse.size() ? number_cell(kPaperTestMse.at(k), 5) : "–";
    table.add({both(entry_name(c.method)), paper, spread_cell(c.test->mse, 4),
               number_cell(c.test->mae.mean, 4), number_cell(c.test->rmse.mean, 4),
               c.test->mape_percent ? number_cell(c.test->mape_percent->mean, 4) : "–",
               determination_cell(c.test->r2), c.train ? spread_cell(c.train->mse, 4) : "–",
               c.iterations ? count_cell(c.iterations->mean) : "–", number_cell(c.time.mean, 3)});
  }
  const Text text = text_of(Label::table_3_text, {{"unit", typeset_unit(made.unit)},
                                                  {"repeats", made.networks.repeats},
                                                  {"noise", typeset(significant_text(made.noise_mse, 4))}});
  return {.id = "table-3",
          .title = Label::table_3,
          .body = paragraph(text) + table.html() + paragraph(text_of(Label::mape_note))};
}

Section iterations(const Reproduction& made) {
  Table table(text_of(Label::iterations_cost),
              {{same_text(""), Align::left}, {text_of(Label::the_paper_short)}, {text_of(Label::here)}},
              Table::Caption::hidden);
  const auto whole = [](double count) { return std::to_string(static_cast<long long>(count)); };
  table.add({both(text_of(Label::bp_cost)), whole(kPaperIterations.at(0)), whole(made.search_iterations)});
  table.add({both(text_of(Label::pso_bp_cost)), whole(kPaperIterations.at(1)), whole(made.swarm_iterations)});
  table.add({both(text_of(Label::ratio)), number_cell(kPaperIterations.at(1) / kPaperIterations.at(0), 2),
             number_cell(made.swarm_iterations / made.search_iterations)});
  return {.id = "iterations",
          .title = Label::iterations_cost,
          .body = table.html() + paragraph(text_of(Label::iterations_text)),
          .short_ = true};
}

Section gains(const Reproduction& made) {
  Table table(text_of(Label::gain),
              {{text_of(Label::noise_ug)},
               {same_text("PSO-BP"), Align::left},
               {text_of(Label::mse_ratio)},
               {text_of(Label::bp_iterations)},
               {text_of(Label::pso_iterations)}},
              Table::Caption::hidden);
  for (const SwarmGain& gain : made.gains) {
    table.add({count_cell(gain.sigma * 1e6), both(entry_name(gain.preset)), number_cell(gain.ratio(), 4),
               count_cell(gain.bp_iterations), count_cell(gain.swarm_iterations)});
  }
  const Text text = text_of(Label::gain_text, {{"records", made.gains.front().bp_mse.size()}});
  return {.id = "gain", .title = Label::gain, .body = paragraph(text) + table.html(), .short_ = true};
}

Section figures(const Reproduction& made, InteractiveFigures& interactive) {
  std::string drawn;
  std::size_t number = 4;  // as in the paper
  std::vector<PaperFigure> all = figures_of(made);
  for (PaperFigure& one : all) {
    const Text before = text_of(Label::figure_number, {{"number", number++}});
    one.chart.title = {before.en + one.chart.title.en, before.zh + one.chart.title.zh};
    drawn += figure(one.chart, interactive);
  }
  return {.id = "figures", .title = Label::paper_figures, .body = element("div", drawn, "class=\"figures\"")};
}

Section about(const Reproduction& made, const std::string& date) {
  const Text twin = text_of(Label::paper_intro, {{"twin", made.twin},
                                                 {"rows", made.rows},
                                                 {"noise", made.sigma * 1e6},
                                                 {"seed", static_cast<double>(made.seed)}});
  Definitions origin;
  origin.add(text_of(Label::seed), std::to_string(made.seed));
  origin.add(text_of(Label::version), escaped(version()));
  if (!date.empty()) origin.add(text_of(Label::date), escaped(date));
  return {.id = "about",
          .title = Label::reproduction,
          .body = paragraph(text_of(Label::the_paper, {{"citation", std::string(kPaperCitation)}})) +
                  paragraph(twin) + origin.html(),
          .short_ = true};
}

}  // namespace

std::vector<Section> reproduction_sections(const Reproduction& made, InteractiveFigures& interactive,
                                           const std::string& date) {
  return {
      about(made, date),         table_1(made), table_2(made), table_3(made), iterations(made), gains(made),
      figures(made, interactive)};
}

}  // namespace proofmass::html
