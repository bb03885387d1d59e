// SPDX-License-Identifier: Apache-2.0
#include "proofmass/study/paper/reproduce.hpp"

#include <filesystem>
#include <memory>
#include <string>

#include "common_flags.hpp"
#include "console_progress.hpp"
#include "interrupts.hpp"
#include "output.hpp"
#include "proofmass/numeric/parallel.hpp"
#include "proofmass/report/html/report.hpp"
#include "proofmass/report/paper/reproduction.hpp"
#include "proofmass/report/terminal/wrapped_text.hpp"
#include "proofmass/stand/twin/simulation_file.hpp"
#include "proofmass/study/paper/citation.hpp"
#include "verbs/verbs.hpp"

namespace proofmass::cli {
namespace {

namespace fs = std::filesystem;

struct ReproduceFlags {
  CommonFlags common;
  std::string out;
  std::string report;
  bool quick = false;
  std::uint64_t seed = 1;
};

void run_reproduce(const ReproduceFlags& flags) {
  require_writable(flags.out, {flags.report});
  const InterruptGuard guard;
  const ThreadLimit limit(flags.common.threads);
  ReproduceOptions options = flags.quick ? quick_reproduction() : ReproduceOptions{};
  options.seed = flags.seed;
  Reproduction made;
  {
    ConsoleProgress progress(flags.common.quiet);
    made = reproduce(paper_twin(), options, progress);
  }
  OutputFiles files;
  if (!flags.out.empty()) {
    files.make_folder(flags.out);
    for (const NamedText& file : reproduction_files(made, flags.common.language))
      files.add(fs::path(flags.out) / file.name, file.text);
  }
  if (!flags.report.empty())
    files.add(flags.report, render_report(made, {.language = flags.common.language, .date = today()}));
  if (flags.report != "-") files.add("-", render_reproduction(made, flags.common.language));
  files.commit();
}

std::string citation() {
  constexpr std::size_t kCharacters = 60;  // Chinese ones take two columns each
  std::string text;
  for (const std::string& line : wrapped_lines("The paper: " + std::string(kPaperCitation), kCharacters))
    text.append(line).append("\n");
  return text;
}

}  // namespace

Action add_reproduce(CLI::App& verb) {
  auto flags = std::make_shared<ReproduceFlags>();
  add_path(verb, "--out", flags->out, "Write the page, the tables' data and the figures to the folder DIR")
      ->type_name("DIR");
  add_report_file(verb, flags->report);
  verb.add_flag("--quick", flags->quick, "One repeat of everything, two records for BP against PSO-BP");
  add_whole(verb, "--seed", 0, 1'000'000'000, "Seed of record, split and draws (default 1)",
            [flags](std::uint64_t n) { flags->seed = n; });
  add_language(verb, flags->common);
  add_common(verb, flags->common);
  verb.footer(
      "Examples:\n"
      "  proofmass reproduce --quick\n"
      "  proofmass reproduce --out reproduction\n\n" +
      citation());
  return [flags] { run_reproduce(*flags); };
}

}  // namespace proofmass::cli
