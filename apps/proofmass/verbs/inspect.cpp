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
#include "verbs/verbs.hpp"

namespace proofmass::cli {
namespace {

struct InspectFlags {
  CommonFlags common;
  std::string record;
  std::vector<std::string> map;
  std::string json;
};

void run_inspect(const InspectFlags& flags) {
  require_other_file(flags.json, {flags.record});
  require_folder_of(flags.json);
  const auto columns = renames(flags.map);
  ConsoleProgress progress(flags.common.quiet);
  const Inspection inspection = inspect(read_record(flags.record, {.rename = columns}, progress));
  progress.clear();
  OutputFiles files;
  if (!flags.json.empty()) files.add(flags.json, to_json(inspection));
  if (flags.json != "-") files.add("-", render_inspection(inspection, terminal_style()));
  files.commit();
}

}  // namespace

Action add_inspect(CLI::App& verb) {
  auto flags = std::make_shared<InspectFlags>();
  verb.add_option("RUN.csv", flags->record, "The test record; - is standard input")->required();
  add_map(verb, flags->map);
  add_json(verb, flags->json);
  add_common(verb, flags->common);
  verb.footer(
      "Examples:\n"
      "  proofmass inspect run.csv\n"
      "  proofmass inspect raw.csv --map Ai=ax,E=out --json inspection.json\n");
  return [flags] { run_inspect(*flags); };
}

}  // namespace proofmass::cli
