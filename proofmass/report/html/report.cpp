// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/html/report.hpp"

#include "proofmass/core/version.hpp"
#include "proofmass/report/html/comparison/comparison_page.hpp"
#include "proofmass/report/html/page/page.hpp"
#include "proofmass/report/html/reproduction/reproduction_page.hpp"
#include "proofmass/report/html/sections/sections.hpp"

namespace proofmass {

std::string render_report(const Run& run, const RecordFigures* record, const ReportStyle& style,
                          const Text& why) {
  InteractiveFigures interactive;
  const html::IdentificationContext context{
      .run = run, .record = record, .why_no_record = why, .date = style.date, .interactive = interactive};
  const html::Page page{.title = text_of(Label::identification),
                        .subject = run.provenance.input,
                        .version = run.provenance.version,
                        .sections = html::identification_sections(context)};
  return html::render(page, interactive, style);
}

std::string render_report(const Comparison& comparison, const ReportStyle& style) {
  InteractiveFigures interactive;
  const html::Page page{.title = text_of(Label::comparison),
                        .subject = comparison.input,
                        .version = comparison.contestants.front().runs.front().provenance.version,
                        .sections = html::comparison_sections(comparison, interactive, style.date)};
  return html::render(page, interactive, style);
}

std::string render_report(const Reproduction& made, const ReportStyle& style) {
  InteractiveFigures interactive;
  const html::Page page{.title = text_of(Label::reproduction),
                        .subject = made.twin,
                        .version = std::string(version()),
                        .sections = html::reproduction_sections(made, interactive, style.date)};
  return html::render(page, interactive, style);
}

}  // namespace proofmass
