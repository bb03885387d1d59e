// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/terminal/terminal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

#include "proofmass/core/text.hpp"
#include "proofmass/report/mape_rows.hpp"
#include "proofmass/report/number_text.hpp"
#include "proofmass/report/readable_units.hpp"
#include "proofmass/report/terminal/terminal_findings.hpp"
#include "proofmass/report/terminal/terminal_text.hpp"
#include "proofmass/report/terminal/text_table.hpp"
#include "proofmass/report/text/en.hpp"
#include "proofmass/report/text/endings.hpp"

namespace proofmass {
namespace {

// In the unit that users speak; in the output's own where that is no acceleration.
std::string readable(const Coefficient& coefficient, const Unit& output) {
  if (!output.is_acceleration()) {
    const std::string unit = coefficient_unit(coefficient.term, output);
    return coefficient.standard_error
               ? fmt::format("{} ± {} {}", uncertain_text(coefficient.value, coefficient.standard_error),
                             significant_text(*coefficient.standard_error, 2), unit)
               : fmt::format("{} {}", significant_text(coefficient.value, 6), unit);
  }
  const ReadableUnit unit = readable_unit(coefficient.term);
  const double value = (coefficient.value - unit.offset) * unit.factor;
  const std::string label = coefficient.term == Term::Ki ? "Ki-1 = " : "";
  const std::string number = coefficient.standard_error
                                 ? plus_minus_text(value, *coefficient.standard_error * unit.factor)
                                 : significant_text(value, 6);
  return fmt::format("{}{} {}", label, number, unit.symbol);
}

std::string optional_text(const std::optional<double>& value, int digits) {
  return value ? significant_text(*value, digits) : "-";
}

std::string interval_text(const Coefficient& c) {
  if (!c.ci95) return "-";
  return fmt::format("[{}, {}]", uncertain_text(c.ci95->low, c.standard_error),
                     uncertain_text(c.ci95->high, c.standard_error));
}

std::string p_text(const std::optional<double>& p) {
  if (!p) return "-";
  return *p < 1e-4 ? "<0.0001" : fmt::format("{:.4f}", *p);
}

std::vector<std::string> cells(const Coefficient& c, const Unit& output) {
  return {std::string(name(c.term)),
          readable(c, output),
          uncertain_text(c.value, c.standard_error),
          optional_text(c.standard_error, 3),
          optional_text(c.t, 4),
          p_text(c.p),
          interval_text(c)};
}

void write_coefficients(TerminalText& out, std::span<const Coefficient> coefficients, const Unit& output) {
  TextTable table({"term", "reads", "value", "std. error", "t", "p", "95 % interval"}, Left::second_too);
  for (const Coefficient& c : coefficients) {
    if (c.identified) table.add(cells(c, output));
  }
  out.first_columns(table);
  for (const Coefficient& c : coefficients) {
    if (!c.identified) {
      out.warning(
          fmt::format("  {} not identified: {}", name(c.term), c.reason ? english_reason(*c.reason) : ""));
    }
  }
}

void write_mape_rows(TerminalText& out, const Identification& result) {
  MapeRows rows;
  rows.add("training", result.train);
  rows.add("validation", result.validation);
  rows.add("test", result.test);
  rows.add("left-out", result.leave_one_out);
  if (const std::string text = rows.text(); !text.empty()) out.line(text);
}

void write_metrics(TerminalText& out, const Identification& result) {
  TextTable table({"part", "rows", "RMSE", "MAE", "R²", "MAPE %", "MSE"});
  const auto add = [&table](const char* part, const std::optional<Metrics>& m) {
    if (!m) return;
    table.add({part, std::to_string(m->n), significant_text(m->rmse, 5), significant_text(m->mae, 5),
               m->r2 ? determination_text(*m->r2) : "-", optional_text(m->mape_percent, 4),
               significant_text(m->mse, 5)});
  };
  add("train", result.train);
  add("validation", result.validation);
  add("test", result.test);
  add("leave one out", result.leave_one_out);
  add("leave one mount out", result.leave_one_mount_out);
  out.heading(fmt::format("Errors, in {}", result.output_unit.symbol));
  out.first_columns(table);
  write_mape_rows(out, result);
}

// The worst few, and how many there are.
void write_suspects(TerminalText& out, const std::vector<SuspectRow>& suspects, const Unit& output) {
  constexpr std::size_t most = 10;
  if (suspects.empty()) return;
  const std::size_t shown = std::min(most, suspects.size());
  out.heading(fmt::format("Suspect rows: {}{}", suspects.size(),
                          shown < suspects.size() ? fmt::format(", the first {} here", shown) : ""));
  TextTable table(
      {suspects.front().line ? "line" : "row", "residual, " + output.symbol, "over scale", "weight"});
  for (std::size_t k = 0; k < shown; ++k) {
    const SuspectRow& s = suspects[k];
    table.add({std::to_string(s.line.value_or(s.row)), significant_text(to_declared(s.residual, output), 5),
               significant_text(s.scaled_residual, 4), significant_text(s.weight, 4)});
  }
  out.table(table);
}

void write_hidden_search(TerminalText& out, const std::vector<HiddenTrial>& trials, const Unit& output) {
  if (trials.empty()) return;
  out.heading(fmt::format("Hidden units: RMSE on rows set aside, {}, in {}",
                          amount_text(trials.front().validation_rmse.size(), "repeat"), output.symbol));
  TextTable table({"hidden", "weights", "mean", "best", "spread", ""});
  for (const HiddenTrial& trial : trials) {
    table.add({std::to_string(trial.hidden), std::to_string(trial.weights), significant_text(trial.mean, 5),
               significant_text(trial.best, 5), significant_text(trial.spread, 3),
               trial.chosen ? "chosen" : ""});
  }
  out.table(table);
  out.line("chosen: the fewest units within one standard error of the least mean");
}

// One line of the figures that there are.
class FigureLine {
 public:
  explicit FigureLine(const Unit& output) : output_(output) {}
  void number(const char* label, const std::optional<double>& value) {
    if (value) figures_.push_back(fmt::format("{} {:.5g}", label, *value));
  }
  void count(const char* label, const std::optional<std::size_t>& value) {
    if (value) figures_.push_back(fmt::format("{} {}", label, *value));
  }
  void output(const char* label, const std::optional<double>& value) {
    if (value) {
      figures_.push_back(fmt::format("{} {:.5g} {}", label, to_declared(*value, output_), output_.symbol));
    }
  }
  void text(std::string figure) { figures_.push_back(std::move(figure)); }
  [[nodiscard]] std::string text() const { return fmt::format("{}", fmt::join(figures_, "; ")); }

 private:
  const Unit& output_;
  std::vector<std::string> figures_;
};

void add(FigureLine&, const std::monostate&) {}
void add(FigureLine& line, const NetworkDetails& details) {
  line.number("saturated fraction", details.saturated_fraction);
  line.output("deviation induced by the network", details.induced_deviation);
  line.count("training epochs", details.training_epochs);
  line.count("swarm evaluations", details.swarm_evaluations);
}
void add(FigureLine& line, const RobustDetails& details) { line.output("robust scale", details.scale); }
void add(FigureLine& line, const GmdhDetails& details) { line.count("models tried", details.models_tried); }
void add(FigureLine& line, const AfsaDetails& details) {
  line.count("swarm evaluations", details.swarm_evaluations);
  line.text(fmt::format("rms residual {:.5g} times that of least squares", details.optimum_rmse_ratio));
  line.text(fmt::format("coefficients at most {:.5g} standard errors from those of least squares",
                        details.optimum_distance));
}

void write_diagnostics(TerminalText& out, const Identification& result) {
  const Diagnostics& d = result.diagnostics;
  FigureLine line(result.output_unit);
  line.output("residual sd", d.residual_sd);
  line.count("degrees of freedom", d.dof);
  if (d.r2_adjusted) line.text("adjusted R² " + determination_text(*d.r2_adjusted));
  line.number("condition number", d.condition_raw);
  line.number("with scaled columns", d.condition_scaled);
  std::visit([&line](const auto& details) { add(line, details); }, result.details);
  if (const std::string text = line.text(); !text.empty()) out.line(text);
}

}  // namespace

std::string render_table(const Identification& result, const TerminalStyle& style) {
  TerminalText out(style);
  const Unit& output = result.output_unit;
  out.heading(fmt::format("{}, model {}, seed {}", result.method, result.model, result.seed));
  write_findings(out, result.findings, Severity::warning);
  write_coefficients(out, result.coefficients, output);
  if (!output.is_acceleration()) {
    std::vector<Coefficient> referred = referred_to_input(result);
    std::erase_if(referred, [](const Coefficient& c) { return c.term == Term::Ki; });  // 1 by definition
    if (!referred.empty()) {
      out.heading("Referred to input (divided by Ki)");
      write_coefficients(out, referred, Unit{});
    }
  }
  write_metrics(out, result);
  if (const auto* network = std::get_if<NetworkDetails>(&result.details)) {
    write_hidden_search(out, network->hidden_search, output);
  }
  if (const auto* robust = std::get_if<RobustDetails>(&result.details)) {
    write_suspects(out, robust->suspect_rows, output);
  }
  out.heading(fmt::format("Ended: {}", to_string(result.ending.status)));
  out.line(sentence(result.ending.parts, Language::en));
  write_diagnostics(out, result);
  write_findings(out, result.findings, Severity::note);
  write_findings(out, result.findings, Severity::basis);
  return out.text();
}

std::string summary(const Run& run) { return render_table(run.identification); }

}  // namespace proofmass
