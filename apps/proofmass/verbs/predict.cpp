// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "common_flags.hpp"
#include "console_progress.hpp"
#include "output.hpp"
#include "proofmass/assess/extrapolation.hpp"
#include "proofmass/core/error.hpp"
#include "proofmass/identify/method.hpp"
#include "proofmass/report/csv.hpp"
#include "proofmass/report/json/json.hpp"
#include "proofmass/report/terminal/terminal_words.hpp"
#include "proofmass/report/text/findings.hpp"
#include "record_flags.hpp"
#include "verbs/verbs.hpp"

namespace proofmass::cli {
namespace {

struct PredictFlags {
  CommonFlags common;
  std::string result;
  RecordFlags inputs;
  std::string out = "-";
};

void require_finite(const std::vector<double>& outputs, const Dataset& inputs) {
  for (std::size_t r = 0; r < outputs.size(); ++r) {
    if (std::isfinite(outputs[r])) continue;
    const std::size_t line = inputs.line.empty() ? r + 1 : inputs.line[r];
    throw bad_data({.file = inputs.source, .row = line, .column = {}},
                   "accelerations or weights beyond all measure",
                   "inputs for which the result predicts a finite output");
  }
}

// A word to standard error, for standard output is the prediction.
void say(const Finding& finding, Language language) {
  const std::string_view severity = severity_words(finding.severity).in(language);
  std::fputs(fmt::format("proofmass: {}{}\n", severity, sentence(finding, language)).c_str(), stderr);
}

void warn_of_extrapolation(const Identification& fit, const Dataset& inputs, Language language) {
  if (const auto finding = find_extrapolation(fit, inputs)) say(*finding, language);
}

void run_predict(const PredictFlags& flags) {
  if (flags.result == "-" && flags.inputs.path == "-") {
    throw usage_error("standard input can be the result or the inputs, not both");
  }
  require_other_file(flags.out, {flags.result, flags.inputs.path});
  require_folder_of(flags.out);
  ReadOptions reading = read_options(flags.inputs, flags.common);
  reading.require_output = false;
  const Identification fit = read_result(flags.result).identification;
  ConsoleProgress progress(flags.common.quiet);
  const Dataset inputs = read_record(flags.inputs.path, reading, progress);
  progress.clear();
  std::ostringstream text;
  const std::vector<double> outputs = predict(fit, inputs);
  require_finite(outputs, inputs);
  for (const Finding& finding : inputs.findings) say(finding, flags.common.language);
  warn_of_extrapolation(fit, inputs, flags.common.language);
  write_forecast(text, inputs, outputs, fit.output_unit);
  OutputFiles files;
  files.add(flags.out, text.view());
  files.commit();
}

}  // namespace

Action add_predict(CLI::App& verb) {
  auto flags = std::make_shared<PredictFlags>();
  verb.add_option("RESULT.json", flags->result, "A result of identify; - is standard input")->required();
  add_record(verb, flags->inputs, "INPUTS.csv", "Accelerations, a row each; - is standard input");
  add_path(verb, "--out", flags->out, "The predictions to write; -, the default, is standard output")
      ->type_name("FILE");
  add_language(verb, flags->common);
  add_common(verb, flags->common);
  verb.footer(
      "Examples:\n"
      "  proofmass predict result.json inputs.csv --out predicted.csv\n"
      "  proofmass identify run.csv --json - | proofmass predict - inputs.csv\n");
  return [flags] { run_predict(*flags); };
}

}  // namespace proofmass::cli
