// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/html/report.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "common_flags.hpp"
#include "console_progress.hpp"
#include "interrupts.hpp"
#include "output.hpp"
#include "proofmass/assess/residuals/record_figures.hpp"
#include "proofmass/core/error.hpp"
#include "proofmass/pipeline.hpp"
#include "proofmass/report/json/json.hpp"
#include "proofmass/report/text/label.hpp"
#include "record_flags.hpp"
#include "verbs/verbs.hpp"

namespace proofmass::cli {
namespace {

namespace fs = std::filesystem;

struct ReportFlags {
  CommonFlags common;
  std::string result;
  std::string record;
  std::string out;
};

// The record that a result was made from, or why it is not at hand.
struct Found {
  std::optional<Dataset> record;
  Text why;
};

// Where the result's record is: as the result names it, from here or from beside the result.
fs::path place_of(const fs::path& input, const fs::path& result) {
  if (fs::is_regular_file(input)) return input;
  const fs::path beside = result.parent_path() / input;
  if (fs::is_regular_file(beside)) return beside;
  const fs::path named = result.parent_path() / input.filename();
  return fs::is_regular_file(named) ? named : fs::path();
}

Dataset read(const fs::path& path, const Run& run, const CommonFlags& common, Progress& progress) {
  return read_record(path, read_options(flags_of(run.provenance), common), progress);
}

// The record given must be the one that the result was made from.
Found given_record(const ReportFlags& flags, const Run& run, Progress& progress) {
  Dataset record = read(flags.record, run, flags.common, progress);
  if (!run.provenance.input_sha256.empty() && record.source_sha256 != run.provenance.input_sha256) {
    throw Error(ErrorKind::bad_data,
                flags.record + ": is not the record that " + flags.result +
                    " was made from: its SHA-256 is " + record.source_sha256 + ", the result's record has " +
                    run.provenance.input_sha256 +
                    "; give that record, or leave the option out for a report without figures of rows");
  }
  return {.record = std::move(record), .why = {}};
}

Found find_record(const ReportFlags& flags, const Run& run, Progress& progress) {
  if (!flags.record.empty()) return given_record(flags, run, progress);
  const std::string& input = run.provenance.input;
  if (input.empty() || input == "-") return {.record = {}, .why = text_of(Label::absent_unnamed)};
  const fs::path place = place_of(input, flags.result);
  if (place.empty()) return {.record = {}, .why = text_of(Label::absent_not_found, {{"file", input}})};
  Found found{.record = read(place, run, flags.common, progress), .why = {}};
  if (found.record->source_sha256 != run.provenance.input_sha256)
    return {.record = {}, .why = text_of(Label::absent_changed, {{"file", place.string()}})};
  return found;
}

void run_report(const ReportFlags& flags) {
  require_writable_file(flags.out);
  require_other_file(flags.out, {flags.result, flags.record});
  const Run run = read_result(flags.result);
  ConsoleProgress progress(flags.common.quiet);
  const Found found = find_record(flags, run, progress);
  progress.clear();
  std::optional<RecordFigures> figures;
  if (found.record)
    figures = record_figures(*found.record, split_again(*found.record, run), run.identification);
  const RecordFigures* const shown = figures ? &*figures : nullptr;
  OutputFiles files;
  files.add(flags.out,
            render_report(run, shown, {.language = flags.common.language, .date = today()}, found.why));
  files.commit();
}

}  // namespace

Action add_report(CLI::App& verb) {
  auto flags = std::make_shared<ReportFlags>();
  verb.add_option("RESULT.json", flags->result, "A result of identify; - is standard input")->required();
  add_path(verb, "--record", flags->record,
           "The record that the result was made from (default: where the result says, or beside it)")
      ->type_name("RUN.csv");
  add_path(verb, "--out", flags->out, "The report to write; - is standard output")
      ->type_name("FILE")
      ->required();
  add_language(verb, flags->common);
  add_common(verb, flags->common);
  verb.footer(
      "Examples:\n"
      "  proofmass report result.json --out report.html\n"
      "  proofmass report result.json --record archive/run.csv --out report.html\n");
  return [flags] { run_report(*flags); };
}

}  // namespace proofmass::cli
