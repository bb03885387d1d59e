// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/html/page/provenance.hpp"

#include "proofmass/report/html/page/findings.hpp"
#include "proofmass/report/text/label.hpp"
#include "proofmass/report/typography.hpp"

namespace proofmass::html {
namespace {

std::string ranges(const Identification& result) {
  std::string text;
  for (const auto& [axis, range] : result.input_range) {
    text += (text.empty() ? "" : "<br>") +
            both(in_print(
                text_of(Label::range_text,
                        {{"axis", std::string(axis_name(axis))}, {"low", range.low}, {"high", range.high}})));
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

std::string units(const Run& run, const Dataset* record) {
  const std::string output = typeset_unit(run.identification.output_unit.symbol);
  std::string acceleration = run.provenance.acceleration_unit;
  // Results of earlier versions do not say it.
  if (acceleration.empty() && record != nullptr) acceleration = record->acceleration_unit.symbol;
  if (acceleration.empty()) return both(text_of(Label::output_unit_text, {{"output", output}}));
  return both(text_of(Label::units_text, {{"acceleration", typeset_unit(acceleration)}, {"output", output}}));
}

}  // namespace

void add_record(Definitions& about, const Run& run, const Dataset* record) {
  const Identification& result = run.identification;
  about.add(text_of(Label::record), escaped(run.provenance.input));
  if (!run.provenance.input_sha256.empty())
    about.add(text_of(Label::sha256), element("code", escaped(run.provenance.input_sha256)));
  about.add(text_of(Label::row_count), rows(result));
  about.add(text_of(Label::units), units(run, record));
  if (!result.input_range.empty()) about.add(text_of(Label::ranges), ranges(result));
}

void add_origin(Definitions& about, const Run& run, const std::string& date) {
  about.add(text_of(Label::seed), std::to_string(run.identification.seed));
  about.add(text_of(Label::version), escaped(run.provenance.version));
  if (!date.empty()) about.add(text_of(Label::date), escaped(date));
}

std::string reading_part(const Provenance& provenance) {
  std::string body = element("h3", both(text_of(Label::reading)));
  const std::string& unit = provenance.acceleration_unit;
  const bool converted = !unit.empty() && unit != "g";
  if (converted) body += paragraph(text_of(Label::converted, {{"unit", typeset_unit(unit)}}));
  if (provenance.reading.empty() && !converted) body += paragraph(text_of(Label::reading_nothing));
  for (const Finding& one : provenance.reading) body += finding(one);
  return body;
}

std::string options_table(const Provenance& provenance, const Text& caption) {
  Table table(caption, {{text_of(Label::option), Align::left}, {text_of(Label::value), Align::left}});
  for (const auto& [option, value] : provenance.options)
    table.add({escaped(option), value.empty() ? "–" : escaped(value)});
  return table.empty() ? std::string() : table.html();
}

}  // namespace proofmass::html
