// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/terminal/terminal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

#include "proofmass/report/number_text.hpp"
#include "proofmass/report/readable_units.hpp"
#include "proofmass/report/terminal/terminal_text.hpp"
#include "proofmass/report/terminal/text_table.hpp"

namespace proofmass {
namespace {

std::string readable(const Coefficient& coefficient) {
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
  const std::string last = output.is_acceleration() ? readable(c) : coefficient_unit(c.term, output);
  return {std::string(name(c.term)),
          uncertain_text(c.value, c.standard_error),
          optional_text(c.standard_error, 3),
          interval_text(c),
          optional_text(c.t, 4),
          p_text(c.p),
          last};
}

void write_coefficients(TerminalText& out, std::span<const Coefficient> coefficients, const Unit& output) {
  TextTable table(
      {"term", "value", "std. error", "95 % interval", "t", "p", output.is_acceleration() ? "reads" : "unit"},
      true);
  for (const Coefficient& c : coefficients) {
    if (c.identified) table.add(cells(c, output));
  }
  out.table(table);
  for (const Coefficient& c : coefficients) {
    if (!c.identified) out.warning(fmt::format("  {} not identified: {}", name(c.term), c.reason));
  }
}

void write_metrics(TerminalText& out, const Identification& result) {
  TextTable table({"part", "rows", "MAE", "MSE", "RMSE", "MAPE %", "R²"});
  const auto add = [&table](const char* part, const std::optional<Metrics>& m) {
    if (!m) return;
    table.add({part, std::to_string(m->n), significant_text(m->mae, 5), significant_text(m->mse, 5),
               significant_text(m->rmse, 5), optional_text(m->mape_percent, 4),
               m->r2 ? fmt::format("{:.12g}", *m->r2) : "-"});
  };
  add("train", result.train);
  add("validation", result.validation);
  add("test", result.test);
  out.heading(fmt::format("Errors, in {}", result.output_unit.symbol));
  out.table(table);
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
  out.heading(fmt::format("Hidden units: RMSE on rows set aside, {} repeats, in {}",
                          trials.front().validation_rmse.size(), output.symbol));
  TextTable table({"hidden", "weights", "mean", "best", "spread", ""});
  for (const HiddenTrial& trial : trials) {
    table.add({std::to_string(trial.hidden), std::to_string(trial.weights), significant_text(trial.mean, 5),
               significant_text(trial.best, 5), significant_text(trial.spread, 3),
               trial.chosen ? "chosen" : ""});
  }
  out.table(table);
  out.line("chosen: the fewest units within one standard error of the least mean");
}

void write_diagnostics(TerminalText& out, const Diagnostics& d, const Unit& output) {
  std::vector<std::string> figures;
  const auto add = [&figures](const char* label, const std::optional<double>& value) {
    if (value) figures.push_back(fmt::format("{} {:.5g}", label, *value));
  };
  if (d.residual_sd) {
    figures.push_back(
        fmt::format("residual sd {:.5g} {}", to_declared(*d.residual_sd, output), output.symbol));
  }
  if (d.dof) figures.push_back(fmt::format("degrees of freedom {}", *d.dof));
  if (d.r2_adjusted) figures.push_back(fmt::format("adjusted R² {:.12g}", *d.r2_adjusted));
  add("condition number", d.condition_raw);
  add("with scaled columns", d.condition_scaled);
  add("saturated share", d.saturated_share);
  if (d.induced_deviation) {
    figures.push_back(fmt::format("deviation induced by the network {:.5g} {}",
                                  to_declared(*d.induced_deviation, output), output.symbol));
  }
  if (d.training_epochs) figures.push_back(fmt::format("training epochs {}", *d.training_epochs));
  if (d.swarm_evaluations) figures.push_back(fmt::format("swarm evaluations {}", *d.swarm_evaluations));
  if (d.models_tried) figures.push_back(fmt::format("models tried {}", *d.models_tried));
  add("residual over the least-squares optimum's", d.optimum_rmse_ratio);
  add("farthest coefficient, standard errors from it", d.optimum_distance);
  if (d.robust_scale) {
    figures.push_back(
        fmt::format("robust scale {:.5g} {}", to_declared(*d.robust_scale, output), output.symbol));
  }
  if (!figures.empty()) out.line(fmt::format("{}", fmt::join(figures, "; ")));
  for (const std::string& note : d.notes) out.warning("note: " + note);
}

}  // namespace

std::string render_table(const Identification& result, const TerminalStyle& style) {
  TerminalText out(style);
  const Unit& output = result.output_unit;
  out.heading(fmt::format("{}, model {}, seed {}", result.method, result.model, result.seed));
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
  write_hidden_search(out, result.diagnostics.hidden_search, output);
  write_suspects(out, result.diagnostics.suspect_rows, output);
  out.heading(fmt::format("Ended: {}", to_string(result.ending.status)));
  out.line(result.ending.reason);
  write_diagnostics(out, result.diagnostics, output);
  return out.text();
}

}  // namespace proofmass
