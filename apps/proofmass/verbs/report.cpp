// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/html/report.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "common_flags.hpp"
#include "console_progress.hpp"
#include "interrupts.hpp"
#include "output.hpp"
#include "proofmass/assess/residuals/record_figures.hpp"
#include "proofmass/core/error.hpp"
#include "proofmass/files/sha256.hpp"
#include "proofmass/files/text_file.hpp"
#include "proofmass/numeric/parallel.hpp"
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

// Where the record is that a result was made from, or why it is not at hand.
struct Found {
  fs::path place;  // empty: it is not
  Text why;
};

bool is_file(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

// Where the result's record is: as the result names it, from here or from beside the result.
fs::path place_of(const fs::path& input, const fs::path& result) {
  for (const fs::path& place : {input, result.parent_path() / input, result.parent_path() / input.filename()})
    if (is_file(place)) return place;
  return {};
}

std::string hash_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  constexpr std::size_t kPiece = 1 << 20;
  std::string piece(kPiece, '\0');
  Sha256 hash;
  while (file.read(piece.data(), static_cast<std::streamsize>(kPiece)) || file.gcount() > 0)
    hash.update(std::string_view(piece).substr(0, static_cast<std::size_t>(file.gcount())));
  return hash.hex();
}

// The record given must be the one that the result was made from.
fs::path given_record(const ReportFlags& flags, const Run& run) {
  if (!is_file(flags.record)) throw cannot_open(flags.record, ENOENT);
  const std::string hash = hash_of(flags.record);
  if (hash != run.provenance.input_sha256) {
    throw Error(
        ErrorKind::bad_data,
        message("{} is not the record that {} was made from: its SHA-256 is {}, that of the result's "
                "record {}; give that record, or leave the option out for a report without figures of "
                "rows",
                flags.record, flags.result, hash, run.provenance.input_sha256));
  }
  return flags.record;
}

// What is not at hand is said on standard error too: the page alone may not be looked at.
Found without_record(Text why, Language language) {
  std::fputs(fmt::format("proofmass: {}\n", why.in(language)).c_str(), stderr);
  return {.place = {}, .why = std::move(why)};
}

Found find_record(const ReportFlags& flags, const Run& run) {
  if (!flags.record.empty()) return {.place = given_record(flags, run), .why = {}};
  const std::string& input = run.provenance.input;
  const Language language = flags.common.language;
  if (run.provenance.input_sha256.empty() || input == kStandardInput)
    return without_record(text_of(Label::absent_unnamed), language);
  const fs::path place = place_of(input, flags.result);
  if (place.empty()) return without_record(text_of(Label::absent_not_found, {{"file", input}}), language);
  if (hash_of(place) != run.provenance.input_sha256)
    return without_record(text_of(Label::absent_changed, {{"file", place.string()}}), language);
  return {.place = place, .why = {}};
}

std::optional<RecordFigures> read_figures(const fs::path& place, const Run& run, const ReportFlags& flags) {
  if (place.empty()) return std::nullopt;
  ConsoleProgress progress(flags.common.quiet);
  const Dataset record = read_record(place, read_options(flags_of(run.provenance), flags.common), progress);
  progress.clear();
  const Split split = split_again(record, run);
  require_own_scores(record, split, run);
  return record_figures(record, split, run.identification);
}

void run_report(const ReportFlags& flags) {
  require_writable_file(flags.out);
  require_other_file(flags.out, {flags.result, flags.record});
  const Run run = read_result(flags.result);
  const Found found = find_record(flags, run);
  require_other_file(flags.out, {found.place});
  const InterruptGuard guard;
  const ThreadLimit limit(flags.common.threads);
  const std::optional<RecordFigures> figures = read_figures(found.place, run, flags);
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
