// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/html/page/html.hpp"
#include "proofmass/report/html/page/provenance.hpp"
#include "proofmass/report/html/sections/sections.hpp"

namespace proofmass::html {
namespace {

std::optional<Section> settings_section(const IdentificationContext& context) {
  const Run& run = context.run;
  Definitions about;
  add_record(about, run, context.record != nullptr ? &context.record->record : nullptr);
  about.add(text_of(Label::method), escaped(run.identification.method));
  about.add(text_of(Label::model), escaped(run.identification.model));
  add_origin(about, run, context.date);
  return Section{.id = "settings",
                 .title = Label::settings,
                 .body = about.html() + reading_part(run.provenance) +
                         options_table(run.provenance, text_of(Label::options))};
}

}  // namespace

extern const PageSection settings_part;
const PageSection settings_part{.place = 140, .make = &settings_section};

}  // namespace proofmass::html
