// SPDX-License-Identifier: Apache-2.0
#include "proofmass/study/compare.hpp"

#include <algorithm>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common_flags.hpp"
#include "console_progress.hpp"
#include "identify_flags.hpp"
#include "interrupts.hpp"
#include "output.hpp"
#include "proofmass/core/error.hpp"
#include "proofmass/numeric/parallel.hpp"
#include "proofmass/report/html/report.hpp"
#include "proofmass/report/json/comparison.hpp"
#include "proofmass/report/terminal/comparison.hpp"
#include "proofmass/stand/twin/simulation_file.hpp"
#include "proofmass/study/truth.hpp"
#include "proofmass/study/truth_doubts.hpp"
#include "record_flags.hpp"
#include "verbs/verbs.hpp"

namespace proofmass::cli {
namespace {

struct CompareFlags {
  CommonFlags common;
  IdentifyFlags identify;
  RecordFlags record;
  std::vector<std::string> methods;
  std::uint64_t repeats = 1;
  std::string json;
  std::string report;
  std::string truth;  // the plan that the record was simulated by, or empty
};

// The names between the commas; CLI11 would pass over empty ones.
std::vector<std::string> names_of(const std::vector<std::string>& lists) {
  std::vector<std::string> names;
  for (const std::string& list : lists) {
    std::size_t start = 0;
    for (std::size_t comma = 0; comma != std::string::npos; start = comma + 1) {
      comma = list.find(',', start);
      names.push_back(list.substr(start, comma == std::string::npos ? comma : comma - start));
    }
  }
  return names;
}

std::vector<Entry> entries_of(const CompareFlags& flags) {
  const std::vector<std::string> names = names_of(flags.methods);
  for (const std::string& name : names) {
    if (name.empty())
      throw usage_error("--methods: found an empty name, expected a method before and after every comma");
    if (std::count(names.begin(), names.end(), name) > 1)
      throw usage_error(message("--methods: '{}' is listed twice", name));
  }
  const IdentifyOptions options = flags.identify.options();
  std::vector<Entry> entries;
  for (Method& method : flags.identify.methods(names)) {
    entries.push_back({std::string(info(method).name), std::move(method), options});
  }
  return entries;
}

// The plan that the record's file says it was simulated from; what comes by standard input is read once, and
// says nothing.
std::string plan_named_by(const std::string& record) {
  if (record == "-") return {};
  std::ifstream file(record);
  return plan_named_in(file);
}

void run_compare(const CompareFlags& flags) {
  const std::vector<Entry> entries = entries_of(flags);
  const ReadOptions reading = read_options(flags.record, flags.common);
  require_writable_file(flags.json);
  require_other_file(flags.json, {flags.record.path, flags.truth});
  require_writable_file(flags.report);
  require_other_file(flags.report, {flags.record.path, flags.truth});
  require_distinct_outputs({flags.json, flags.report});
  std::optional<SimulationPlan> truth;
  if (!flags.truth.empty()) truth = read_simulation(flags.truth);
  ConsoleProgress progress(flags.common.quiet);
  const Dataset record = read_record(flags.record.path, reading, progress);
  std::vector<Finding> doubts;
  if (truth) doubts = doubts_about_truth(*truth, record, plan_named_by(flags.record.path));
  const InterruptGuard guard;
  const ThreadLimit limit(flags.common.threads);
  Comparison comparison = compare(record, entries, flags.repeats, progress);
  progress.clear();
  if (truth) score_truth(comparison, record, *truth);
  comparison.findings.insert(comparison.findings.end(), doubts.begin(), doubts.end());
  for (Contestant& contestant : comparison.contestants) {
    for (Run& run : contestant.runs) {
      add_given(run.provenance, find_method(contestant.method), flags.identify);
      add_given(run.provenance, flags.record);
    }
  }
  OutputFiles files;
  if (!flags.json.empty()) files.add(flags.json, to_json(comparison));
  const ReportStyle page{.language = flags.common.language, .date = today()};
  if (!flags.report.empty()) files.add(flags.report, render_report(comparison, page));
  const TerminalStyle style = terminal_style(flags.common.wide, flags.common.language);
  if (flags.json != "-" && flags.report != "-") files.add("-", render_comparison(comparison, style));
  files.commit();
}

}  // namespace

Action add_compare(CLI::App& verb) {
  auto flags = std::make_shared<CompareFlags>();
  add_record(verb, flags->record, "RUN.csv", "The test record; - is standard input");
  verb.add_option("--methods", flags->methods,
                  "Methods to compare, separated by commas; ratios refer to the first")
      ->required()
      ->type_name("A,B,...");
  add_whole(verb, "--repeats", 1, 100'000, "Repeat with seeds S, S+1, ... (default 1)",
            [flags](std::uint64_t n) { flags->repeats = n; });
  add_path(verb, "--truth", flags->truth,
           "The plan that the record was simulated by: adds how far the coefficients are from the truth")
      ->type_name("STAND.toml");
  flags->identify.add_to(verb, IdentifyFlags::Naming::elsewhere);
  add_json(verb, flags->json);
  add_report_file(verb, flags->report);
  add_wide(verb, flags->common);
  add_language(verb, flags->common);
  add_common(verb, flags->common);
  verb.footer(
      "Examples:\n"
      "  proofmass compare run.csv --methods ols,bp,pso-bp\n"
      "  proofmass compare run.csv --methods ols,gmdh,bp,hybrid --json comparison.json\n"
      "  proofmass compare run.csv --methods ols,robust --repeats 10 --truth stand.toml\n");
  return [flags] { run_compare(*flags); };
}

}  // namespace proofmass::cli
