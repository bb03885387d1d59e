// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/html/page/findings.hpp"
#include "proofmass/report/html/page/html.hpp"
#include "proofmass/report/html/sections/parts_internal.hpp"
#include "proofmass/report/html/sections/sections.hpp"

namespace proofmass::html {
namespace {

std::optional<Section> excitation_section(const IdentificationContext& context) {
  if (context.record == nullptr) return std::nullopt;
  const Dataset& record = context.record->record;
  if (record.axes().empty()) return std::nullopt;
  const auto column = [&](Axis axis) {
    return record.has(axis) ? record.along(axis) : std::vector<double>(record.rows(), 0.0);
  };
  const SpacePlot plot{.id = "excitation",
                       .title = text_of(Label::excitation_plot),
                       .axes = {same_text("Ai"), same_text("Ao"), same_text("Ap")},
                       .x = column(Axis::input),
                       .y = column(Axis::output),
                       .z = column(Axis::pendulous)};
  const std::string shown =
      figure(plot, context.interactive, findings_of(context.run.identification.findings, plot.id));
  return Section{.id = "excitation",
                 .title = Label::excitation,
                 .body = thinning_note(*context.record) + paragraph(text_of(Label::excitation_text)) +
                         element("div", shown, "class=\"figures\""),
                 .short_ = true};
}

}  // namespace

extern const PageSection excitation_part;
const PageSection excitation_part{.place = 120, .make = &excitation_section};

}  // namespace proofmass::html
