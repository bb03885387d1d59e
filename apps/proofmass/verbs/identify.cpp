// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "common_flags.hpp"
#include "console_progress.hpp"
#include "identify_flags.hpp"
#include "interrupts.hpp"
#include "output.hpp"
#include "proofmass/assess/residuals/record_figures.hpp"
#include "proofmass/core/error.hpp"
#include "proofmass/numeric/parallel.hpp"
#include "proofmass/pipeline.hpp"
#include "proofmass/report/csv.hpp"
#include "proofmass/report/html/report.hpp"
#include "proofmass/report/json/json.hpp"
#include "proofmass/report/terminal/terminal.hpp"
#include "record_flags.hpp"
#include "verbs/verbs.hpp"

namespace proofmass::cli {
namespace {

namespace fs = std::filesystem;

struct VerbFlags {
  CommonFlags common;
  IdentifyFlags identify;
  RecordFlags record;
  std::string json;
  std::string out;
  std::string report;
};

Run identify(const Dataset& record, const Method& method, const IdentifyOptions& options,
             const VerbFlags& flags, Progress& progress) {
  const ThreadLimit limit(flags.common.threads);
  Run run = proofmass::identify(record, method, options, progress);
  add_given(run.provenance, method, flags.identify);
  add_given(run.provenance, flags.record);
  return run;
}

// predictions.csv: what the fit says about every row of the record, and which part the row was in.
std::string predictions(const Run& run, const Dataset& record) {
  std::ostringstream text;
  write_predictions(text, record, predict(run.identification, record), parts_of(run.split, record.rows()));
  return text.str();
}

std::string history(const Identification& result) {
  std::ostringstream text;
  write_history(text, result.history);
  return text.str();
}

std::string report(const Run& run, const Dataset& record, Language language) {
  const RecordFigures figures = record_figures(record, run.split, run.identification);
  return render_report(run, &figures, {.language = language, .date = today()});
}

void write_result(const Run& run, const Dataset& record, const VerbFlags& flags) {
  const std::string json = to_json(run);
  OutputFiles files;
  if (!flags.out.empty()) files.make_folder(flags.out);  // other outputs may be in it
  if (!flags.json.empty()) files.add(flags.json, json);
  if (!flags.out.empty()) {
    const fs::path folder = flags.out;
    files.add(folder / "result.json", json);
    files.add(folder / "predictions.csv", predictions(run, record));
    files.add(folder / "history.csv", history(run.identification));
  }
  if (!flags.report.empty()) files.add(flags.report, report(run, record, flags.common.language));
  const TerminalStyle style = terminal_style(flags.common.wide, flags.common.language);
  if (flags.json != "-" && flags.report != "-") files.add("-", render_table(run.identification, style));
  files.commit();
}

void require_outputs(const VerbFlags& flags) {
  require_other_file(flags.json, {flags.record.path});
  require_other_file(flags.report, {flags.record.path});
  const fs::path out = flags.out;
  const bool folder = !flags.out.empty();
  require_distinct_outputs({flags.json, flags.report, folder ? out / "result.json" : "",
                            folder ? out / "predictions.csv" : "", folder ? out / "history.csv" : ""});
  if (folder) {
    for (const char* name : {"result.json", "predictions.csv", "history.csv"}) {
      require_other_file(out / name, {flags.record.path});
    }
  }
  require_writable(out, {flags.json, flags.report});
}

void run_identify(const VerbFlags& flags) {
  const Method method = flags.identify.method();
  const IdentifyOptions options = flags.identify.options();
  const ReadOptions reading = read_options(flags.record, flags.common);
  require_outputs(flags);
  ConsoleProgress progress(flags.common.quiet);
  const Dataset record = read_record(flags.record.path, reading, progress);
  const InterruptGuard guard;
  const Run run = identify(record, method, options, flags, progress);
  progress.clear();
  write_result(run, record, flags);
}

}  // namespace

Action add_identify(CLI::App& verb) {
  auto flags = std::make_shared<VerbFlags>();
  add_record(verb, flags->record, "RUN.csv", "The test record; - is standard input");
  flags->identify.add_to(verb);
  add_json(verb, flags->json);
  add_report_file(verb, flags->report);
  add_path(verb, "--out", flags->out, "Write result.json, predictions.csv and history.csv to the folder DIR")
      ->type_name("DIR");
  add_wide(verb, flags->common);
  add_language(verb, flags->common);
  add_common(verb, flags->common);
  verb.footer(
      "Examples:\n"
      "  proofmass identify run.csv\n"
      "  proofmass identify run.csv --model full --on-rank-loss drop --json result.json\n"
      "  proofmass identify run.csv --method pso-bp --seed 3 --out results\n"
      "  proofmass identify raw.csv --map Ai=ax,E=out[mA] --terms K0,Ki,Kii --split 1\n");
  return [flags] { run_identify(*flags); };
}

}  // namespace proofmass::cli
