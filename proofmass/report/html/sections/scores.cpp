// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/html/page/html.hpp"
#include "proofmass/report/html/sections/sections.hpp"
#include "proofmass/report/mape_rows.hpp"
#include "proofmass/report/number_text.hpp"
#include "proofmass/report/shown_unit.hpp"
#include "proofmass/report/typography.hpp"

namespace proofmass::html {
namespace {

std::optional<Section> scores_section(const IdentificationContext& context) {
  const Identification& result = context.run.identification;
  const ShownUnit unit = shown_from_declared(result.output_unit, result.train ? result.train->rmse : 0.0);
  Table table(text_of(Label::scores),
              {{text_of(Label::part), Align::left},
               {text_of(Label::rows)},
               {same_text("RMSE, " + unit.symbol)},
               {same_text("MAE, " + unit.symbol)},
               {same_text("MSE, " + squared_unit(unit.symbol))},
               {same_text("MAPE, %")},
               {same_text("R²")}},
              Table::Caption::hidden);
  const auto number = [](double value, int digits) {
    return escaped(typeset(significant_text(value, digits)));
  };
  MapeRows rows;
  const auto add = [&](Label part, const std::optional<Metrics>& m) {
    if (!m) return;
    rows.add(text_of(part), m);
    table.add({both(text_of(part)), std::to_string(m->n), number(unit.factor * m->rmse, 5),
               number(unit.factor * m->mae, 5), number(unit.factor * unit.factor * m->mse, 5),
               m->mape_percent ? number(*m->mape_percent, 4) : "–",
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
                 .body = table.html() + paragraph(text_of(used)) +
                         paragraph({rows.text(Language::en), rows.text(Language::zh)}),
                 .short_ = true};
}

}  // namespace

extern const PageSection scores_part;
const PageSection scores_part{.place = 30, .make = &scores_section};

}  // namespace proofmass::html
