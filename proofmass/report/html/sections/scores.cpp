// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/html/page/html.hpp"
#include "proofmass/report/html/sections/sections.hpp"
#include "proofmass/report/number_text.hpp"
#include "proofmass/report/typography.hpp"

namespace proofmass::html {
namespace {

std::optional<Section> scores_section(const IdentificationContext& context) {
  const Identification& result = context.run.identification;
  const std::string unit = typeset_unit(result.output_unit.symbol);
  Table table(text_of(Label::scores),
              {{text_of(Label::part), Align::left},
               {text_of(Label::rows)},
               {same_text("RMSE, " + unit)},
               {same_text("MAE, " + unit)},
               {same_text("MSE, " + squared_unit(result.output_unit.symbol))},
               {same_text("MAPE, %")},
               {same_text("R²")}},
              Table::Caption::hidden);
  const auto number = [](double value, int digits) {
    return escaped(typeset(significant_text(value, digits)));
  };
  const auto add = [&](Label part, const std::optional<Metrics>& m) {
    if (!m) return;
    table.add({both(text_of(part)), std::to_string(m->n), number(m->rmse, 5), number(m->mae, 5),
               number(m->mse, 5), m->mape_percent ? number(*m->mape_percent, 4) : "–",
               m->r2 ? escaped(typeset(determination_text(*m->r2))) : "–"});
  };
  add(Label::train, result.train);
  add(Label::validation, result.validation);
  add(Label::test, result.test);
  add(Label::leave_one_out, result.leave_one_out);
  add(Label::leave_one_mount_out, result.leave_one_mount_out);
  if (table.empty()) return std::nullopt;
  const Label used = result.test ? Label::split_for : Label::used_for;
  return Section{.id = "scores",
                 .title = Label::scores,
                 .body = table.html() + paragraph(text_of(used)) + paragraph(text_of(Label::mape_note)),
                 .short_ = true};
}

}  // namespace

extern const PageSection scores_part;
const PageSection scores_part{.place = 30, .make = &scores_section};

}  // namespace proofmass::html
