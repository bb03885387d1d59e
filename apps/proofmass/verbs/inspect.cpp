// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <string>
#include <vector>

#include "common_flags.hpp"
#include "console_progress.hpp"
#include "output.hpp"
#include "proofmass/assess/inspection.hpp"
#include "proofmass/report/json/inspection.hpp"
#include "proofmass/report/terminal/inspection.hpp"
#include "record_flags.hpp"
#include "verbs/verbs.hpp"

namespace proofmass::cli {
namespace {

struct InspectFlags {
  CommonFlags common;
  RecordFlags record;
  std::string json;
};

void run_inspect(const InspectFlags& flags) {
  require_other_file(flags.json, {flags.record.path});
  require_folder_of(flags.json);
  const ReadOptions reading = read_options(flags.record, flags.common);
  ConsoleProgress progress(flags.common.quiet);
  const Inspection inspection = inspect(read_record(flags.record.path, reading, progress));
  progress.clear();
  OutputFiles files;
  if (!flags.json.empty()) files.add(flags.json, to_json(inspection));
  const TerminalStyle style = terminal_style(flags.common.wide, flags.common.language);
  if (flags.json != "-") files.add("-", render_inspection(inspection, style));
  files.commit();
}

}  // namespace

Action add_inspect(CLI::App& verb) {
  auto flags = std::make_shared<InspectFlags>();
  add_record(verb, flags->record, "RUN.csv", "The test record; - is standard input");
  add_json(verb, flags->json);
  add_wide(verb, flags->common);
  add_language(verb, flags->common);
  add_common(verb, flags->common);
  verb.footer(
      "Examples:\n"
      "  proofmass inspect run.csv\n"
      "  proofmass inspect raw.csv --map Ai=ax,E=out --json inspection.json\n");
  return [flags] { run_inspect(*flags); };
}

}  // namespace proofmass::cli
