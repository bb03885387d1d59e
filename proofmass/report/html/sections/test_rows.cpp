// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/html/page/html.hpp"
#include "proofmass/report/html/sections/parts_internal.hpp"
#include "proofmass/report/html/sections/sections.hpp"

namespace proofmass::html {

namespace {

// Predictions and errors on the rows that the fit has not seen (Shi et al., Figures 7 and 8).
std::optional<Section> test_rows_section(const IdentificationContext& context) {
  if (context.record == nullptr) return std::nullopt;
  const RecordFigures& record = *context.record;
  std::vector<double> number;
  std::vector<double> measured;
  std::vector<double> predicted;
  std::vector<double> error;
  for (std::size_t k = 0; k < record.rows.parts.size(); ++k) {
    if (record.rows.parts[k] != Part::test) continue;
    number.push_back(static_cast<double>(record.test_ranks[number.size()]));
    measured.push_back(record.record.output[k]);
    predicted.push_back(record.rows.predicted[k]);
    error.push_back(record.rows.residuals[k]);
  }
  if (number.empty()) return std::nullopt;
  const Unit& output = context.run.identification.output_unit;
  const ShownUnit large = shown_unit(output, largest_of(measured));
  const ShownUnit small = shown_unit(output, largest_of(error));
  const Chart predictions{.id = "test-predictions",
                          .title = text_of(Label::test_predictions),
                          .x = {.label = text_of(Label::test_row)},
                          .y = {.label = text_of(Label::output, {{"unit", large.symbol}})},
                          .series = {{.name = text_of(Label::measured_short),
                                      .x = number,
                                      .y = scaled(measured, large.factor),
                                      .mark = Mark::points},
                                     {.name = text_of(Label::predicted_short),
                                      .x = number,
                                      .y = scaled(predicted, large.factor),
                                      .colour = 1}}};
  const Chart errors{
      .id = "test-errors",
      .title = text_of(Label::test_errors),
      .x = {.label = text_of(Label::test_row)},
      .y = {.label = text_of(Label::error, {{"unit", small.symbol}})},
      .series = {{.name = {}, .x = number, .y = scaled(error, small.factor), .mark = Mark::points}},
      .guides = {{.at = 0.0}}};
  const std::string figures = figure(predictions, context.interactive) + figure(errors, context.interactive);
  return Section{.id = "test-rows",
                 .title = Label::test_rows,
                 .body = thinning_note(record) + element("div", figures, "class=\"figures\""),
                 .short_ = true};
}

}  // namespace

extern const PageSection test_rows_part;
const PageSection test_rows_part{.place = 90, .make = &test_rows_section};

}  // namespace proofmass::html
