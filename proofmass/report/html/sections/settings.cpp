// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "proofmass/report/html/page/findings.hpp"
#include "proofmass/report/html/page/html.hpp"
#include "proofmass/report/html/sections/sections.hpp"
#include "proofmass/report/typography.hpp"

namespace proofmass::html {
namespace {

std::string ranges(const Identification& result) {
  std::string text;
  for (const auto& [axis, range] : result.input_range) {
    text += (text.empty() ? "" : "<br>") +
            both(text_of(Label::range_text,
                         {{"axis", std::string(axis_name(axis))}, {"low", range.low}, {"high", range.high}}));
  }
  return text;
}

// How many rows each part has, by the scores: they are there without the record too.
std::string rows(const Identification& result) {
  const auto count = [](const std::optional<Metrics>& part) { return part ? part->n : 0; };
  const std::size_t training = count(result.train);
  const std::size_t validation = count(result.validation);
  const std::size_t test = count(result.test);
  return both(text_of(Label::rows_text, {{"total", training + validation + test},
                                         {"training", training},
                                         {"validation", validation},
                                         {"test", test}}));
}

std::string options_table(const Provenance& provenance) {
  Table table(text_of(Label::options),
              {{text_of(Label::options), Align::left}, {text_of(Label::value), Align::left}});
  for (const auto& [option, value] : provenance.options) table.add({escaped(option), escaped(value)});
  return table.empty() ? std::string() : table.html();
}

}  // namespace

std::optional<Section> settings_section(const IdentificationContext& context) {
  const Run& run = context.run;
  const Identification& result = run.identification;
  Definitions about;
  about.add(text_of(Label::record), escaped(run.provenance.input));
  if (!run.provenance.input_sha256.empty())
    about.add(text_of(Label::sha256), element("code", escaped(run.provenance.input_sha256)));
  about.add(text_of(Label::row_count), rows(result));
  const std::string acceleration =
      context.record != nullptr ? context.record->record.acceleration_unit.symbol : "g";
  about.add(text_of(Label::units),
            both(text_of(Label::units_text, {{"acceleration", typeset_unit(acceleration)},
                                             {"output", typeset_unit(result.output_unit.symbol)}})));
  if (!result.input_range.empty()) about.add(text_of(Label::ranges), ranges(result));
  about.add(text_of(Label::method), escaped(result.method));
  about.add(text_of(Label::model), escaped(result.model));
  about.add(text_of(Label::seed), std::to_string(result.seed));
  about.add(text_of(Label::version), escaped(run.provenance.version));
  if (!context.date.empty()) about.add(text_of(Label::date), escaped(context.date));
  std::string body = about.html() + element("h3", both(text_of(Label::reading)));
  if (run.provenance.reading.empty()) body += paragraph(text_of(Label::reading_nothing));
  for (const Finding& one : run.provenance.reading) body += finding(one);
  return Section{.id = "settings", .title = Label::settings, .body = body + options_table(run.provenance)};
}

}  // namespace proofmass::html
