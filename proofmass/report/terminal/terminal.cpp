// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/terminal/terminal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

#include "proofmass/report/coefficient_text.hpp"
#include "proofmass/report/mape_rows.hpp"
#include "proofmass/report/number_text.hpp"
#include "proofmass/report/readable_units.hpp"
#include "proofmass/report/terminal/terminal_findings.hpp"
#include "proofmass/report/terminal/terminal_text.hpp"
#include "proofmass/report/terminal/terminal_words.hpp"
#include "proofmass/report/terminal/text_table.hpp"
#include "proofmass/report/terminal/with_figures_internal.hpp"
#include "proofmass/report/text/endings.hpp"
#include "proofmass/report/text/findings.hpp"
#include "proofmass/report/text/label.hpp"

namespace proofmass {
namespace {

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
          readable_text(c, output),
          uncertain_text(c.value, c.standard_error),
          optional_text(c.standard_error, 3),
          optional_text(c.t, 4),
          p_text(c.p),
          interval_text(c)};
}

void write_coefficients(TerminalText& out, std::span<const Coefficient> coefficients, const Unit& output) {
  TextTable table(header_in(out.language(), {{"term", "项"},
                                             {"reads", "常用单位"},
                                             {"value", "值"},
                                             {"std. error", "标准误差"},
                                             {"t", "t"},
                                             {"p", "p"},
                                             {"95 % interval", "95 % 置信区间"}}),
                  Left::second_too);
  for (const Coefficient& c : coefficients) {
    if (c.identified) table.add(cells(c, output));
  }
  out.first_columns(table);
  for (const Coefficient& c : coefficients) {
    if (!c.identified) {
      const std::string why = c.reason ? reason(*c.reason, out.language()) : "";
      out.warning(
          with_figures({"  {} not identified: {}", "  {} 未辨识：{}"}, out.language(), name(c.term), why));
    }
  }
}

void write_mape_rows(TerminalText& out, const Identification& result) {
  MapeRows rows;
  rows.add(words(Label::train), result.train);
  rows.add(words(Label::validation), result.validation);
  rows.add(words(Label::test), result.test);
  rows.add(Words{"left-out", "留一法"}, result.leave_one_out);
  if (const std::string text = rows.text(out.language()); !text.empty()) out.line(text);
}

void write_metrics(TerminalText& out, const Identification& result) {
  TextTable table({out.in({"part", "部分"}), out.in({"rows", "行数"}), "RMSE", "MAE", "R²", "MAPE %", "MSE"});
  const auto add = [&](const Words& part, const std::optional<Metrics>& m) {
    if (!m) return;
    table.add({out.in(part), std::to_string(m->n), significant_text(m->rmse, 5), significant_text(m->mae, 5),
               m->r2 ? determination_text(*m->r2) : "-", optional_text(m->mape_percent, 4),
               significant_text(m->mse, 5)});
  };
  add(kTrainingPart, result.train);
  add(words(Label::validation), result.validation);
  add(words(Label::test), result.test);
  add(words(Label::leave_one_out), result.leave_one_out);
  add(words(Label::leave_one_mount_out), result.leave_one_mount_out);
  out.heading(with_figures({"Errors, in {}", "误差，单位 {}"}, out.language(), result.output_unit.symbol));
  out.first_columns(table);
  write_mape_rows(out, result);
}

// The worst few, and how many there are.
void write_suspects(TerminalText& out, const std::vector<SuspectRow>& suspects, const Unit& output) {
  constexpr std::size_t most = 10;
  if (suspects.empty()) return;
  const std::size_t shown = std::min(most, suspects.size());
  std::string heading = with_figures({"Suspect rows: {}", "可疑行：{}"}, out.language(), suspects.size());
  if (shown < suspects.size())
    heading += with_figures({", the first {} here", "，以下为前 {} 行"}, out.language(), shown);
  out.heading(heading);
  TextTable table({suspects.front().line ? out.in({"line", "文件行号"}) : out.in({"row", "行序号"}),
                   with_figures({"residual, {}", "残差，{}"}, out.language(), output.symbol),
                   out.in({"over scale", "与尺度之比"}), out.in({"weight", "权"})});
  for (std::size_t k = 0; k < shown; ++k) {
    const SuspectRow& s = suspects[k];
    table.add({std::to_string(s.line.value_or(s.row)), significant_text(to_declared(s.residual, output), 5),
               significant_text(s.scaled_residual, 4), significant_text(s.weight, 4)});
  }
  out.table(table);
}

void write_hidden_search(TerminalText& out, const std::vector<HiddenTrial>& trials, const Unit& output) {
  if (trials.empty()) return;
  const std::string repeats =
      amount(trials.front().validation_rmse.size(), {"repeat", "次重复"}, out.language());
  out.heading(with_figures(
      {"Hidden units: RMSE on rows set aside, {}, in {}", "隐层单元数：留出行的 RMSE，{}，单位 {}"},
      out.language(), repeats, output.symbol));
  TextTable table(header_in(out.language(), {{"hidden", "单元数"},
                                             {"weights", "权值数"},
                                             {"mean", "平均"},
                                             {"best", "最优"},
                                             {"spread", "离散"},
                                             {"", ""}}));
  for (const HiddenTrial& trial : trials) {
    table.add({std::to_string(trial.hidden), std::to_string(trial.weights), significant_text(trial.mean, 5),
               significant_text(trial.best, 5), significant_text(trial.spread, 3),
               trial.chosen ? out.in({"chosen", "选定"}) : ""});
  }
  out.table(table);
  out.line(out.in({"chosen: the fewest units within one standard error of the least mean",
                   "选定：平均值与最小者相差不超过一倍标准误差的最少单元数"}));
}

// One line of the figures that there are.
class FigureLine {
 public:
  FigureLine(const Unit& output, Language language) : output_(output), language_(language) {}
  void number(const Words& label, const std::optional<double>& value) {
    if (value) add(fmt::format("{} {:.5g}", label.in(language_), *value));
  }
  void count(const Words& label, const std::optional<std::size_t>& value) {
    if (value) add(fmt::format("{} {}", label.in(language_), *value));
  }
  void output(const Words& label, const std::optional<double>& value) {
    if (value)
      add(fmt::format("{} {:.5g} {}", label.in(language_), to_declared(*value, output_), output_.symbol));
  }
  void text(const Words& label, const std::string& figure) {
    add(fmt::format("{} {}", label.in(language_), figure));
  }
  // {:.5g} stands for the figure.
  void phrase(const Words& words, double figure) { add(with_figures(words, language_, figure)); }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  void add(const std::string& figure) {
    if (!text_.empty()) text_ += Words{"; ", "；"}.in(language_);
    text_ += figure;
  }
  const Unit& output_;
  Language language_;
  std::string text_;
};

void add(FigureLine&, const std::monostate&) {}
void add(FigureLine& line, const NetworkDetails& details) {
  line.number({"saturated fraction", "饱和比例"}, details.saturated_fraction);
  line.output({"deviation induced by the network", "网络引起的偏差"}, details.induced_deviation);
  line.count({"training epochs", "训练轮次"}, details.training_epochs);
  line.count({"swarm evaluations", "群体计算次数"}, details.swarm_evaluations);
}
void add(FigureLine& line, const RobustDetails& details) {
  line.output({"robust scale", "稳健尺度"}, details.scale);
}
void add(FigureLine& line, const GmdhDetails& details) {
  line.count({"models tried", "试算模型数"}, details.models_tried);
}
void add(FigureLine& line, const AfsaDetails& details) {
  line.count({"swarm evaluations", "群体计算次数"}, details.swarm_evaluations);
  line.phrase({"rms residual {:.5g} times that of least squares", "均方根残差为最小二乘的 {:.5g} 倍"},
              details.optimum_rmse_ratio);
  line.phrase({"coefficients at most {:.5g} standard errors from those of least squares",
               "系数与最小二乘解最多相差 {:.5g} 倍标准误差"},
              details.optimum_distance);
}

void write_diagnostics(TerminalText& out, const Identification& result) {
  const Diagnostics& d = result.diagnostics;
  FigureLine line(result.output_unit, out.language());
  line.output({"residual sd", "残差标准差"}, d.residual_sd);
  line.count({"degrees of freedom", "自由度"}, d.dof);
  if (d.r2_adjusted) line.text({"adjusted R²", "调整 R²"}, determination_text(*d.r2_adjusted));
  line.number({"condition number", "条件数"}, d.condition_raw);
  line.number({"with scaled columns", "列归一化后"}, d.condition_scaled);
  std::visit([&line](const auto& details) { add(line, details); }, result.details);
  if (const std::string text = line.text(); !text.empty()) out.line(text);
}

}  // namespace

std::string render_table(const Identification& result, const TerminalStyle& style) {
  TerminalText out(style);
  const Unit& output = result.output_unit;
  out.heading(with_figures({"{}, model {}, seed {}", "{}，模型 {}，随机种子 {}"}, out.language(),
                           result.method, result.model, result.seed));
  write_findings(out, result.findings, Severity::warning);
  write_coefficients(out, result.coefficients, output);
  if (!output.is_acceleration()) {
    std::vector<Coefficient> referred = referred_to_input(result);
    std::erase_if(referred, [](const Coefficient& c) { return c.term == Term::Ki; });  // 1 by definition
    if (!referred.empty()) {
      out.heading(out.in(words(Label::referred)));
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
  out.heading(out.in({"Ended: ", "终止："}) + out.in(status_words(result.ending.status)));
  out.line(sentence(result.ending.parts, out.language()));
  write_diagnostics(out, result);
  write_findings(out, result.findings, Severity::note);
  write_findings(out, result.findings, Severity::basis);
  return out.text();
}

std::string summary(const Run& run) { return render_table(run.identification); }

}  // namespace proofmass
