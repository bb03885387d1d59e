// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "common_flags.hpp"
#include "console_progress.hpp"
#include "output.hpp"
#include "proofmass/assess/extrapolation.hpp"
#include "proofmass/core/error.hpp"
#include "proofmass/identify/method.hpp"
#include "proofmass/report/csv.hpp"
#include "proofmass/report/json/json.hpp"
#include "proofmass/report/text/en.hpp"
#include "verbs/verbs.hpp"

namespace proofmass::cli {
namespace {

struct PredictFlags {
  CommonFlags common;
  std::string result;
  std::string inputs;
  std::string out = "-";
  std::vector<std::string> map;
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
void warn_of_extrapolation(const Identification& fit, const Dataset& inputs) {
  if (const auto finding = find_extrapolation(fit, inputs)) {
    std::fputs(fmt::format("proofmass: warning: {}\n", english(*finding)).c_str(), stderr);
  }
}

void run_predict(const PredictFlags& flags) {
  if (flags.result == "-" && flags.inputs == "-") {
    throw usage_error("standard input can be the result or the inputs, not both");
  }
  require_other_file(flags.out, {flags.result, flags.inputs});
  require_folder_of(flags.out);
  const auto columns = renames(flags.map);
  const Identification fit = read_result(flags.result).identification;
  ConsoleProgress progress(flags.common.quiet);
  const Dataset inputs = read_record(flags.inputs, {.rename = columns, .require_output = false}, progress);
  progress.clear();
  std::ostringstream text;
  const std::vector<double> outputs = predict(fit, inputs);
  require_finite(outputs, inputs);
  warn_of_extrapolation(fit, inputs);
  write_forecast(text, inputs, outputs, fit.output_unit);
  OutputFiles files;
  files.add(flags.out, text.view());
  files.commit();
}

}  // namespace

Action add_predict(CLI::App& verb) {
  auto flags = std::make_shared<PredictFlags>();
  verb.add_option("RESULT.json", flags->result, "A result of identify; - is standard input")->required();
  verb.add_option("INPUTS.csv", flags->inputs, "Accelerations, a row each; - is standard input")->required();
  add_path(verb, "--out", flags->out, "The predictions to write; -, the default, is standard output")
      ->type_name("FILE");
  add_map(verb, flags->map);
  add_common(verb, flags->common);
  verb.footer(
      "Examples:\n"
      "  proofmass predict result.json inputs.csv --out predicted.csv\n"
      "  proofmass identify run.csv --json - | proofmass predict - inputs.csv\n");
  return [flags] { run_predict(*flags); };
}

}  // namespace proofmass::cli
