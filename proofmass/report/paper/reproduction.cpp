// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/paper/reproduction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "proofmass/report/json/comparison.hpp"
#include "proofmass/report/mape_rows.hpp"
#include "proofmass/report/number_text.hpp"
#include "proofmass/report/paper/reproduction_figures_internal.hpp"
#include "proofmass/report/paper/reproduction_words_internal.hpp"
#include "proofmass/report/plot/svg.hpp"
#include "proofmass/report/terminal/with_figures_internal.hpp"
#include "proofmass/study/paper/citation.hpp"

namespace proofmass {
namespace {

// What the printed MSE and R² of each network say of the variance of its test outputs.
std::string variances(const Reproduction& made, Language language) {
  std::string out;
  for (const Contestant& c : made.networks.contestants) {
    const auto variance = implied_variance(c);
    if (!variance) continue;
    out += with_figures(reproduction_words::kVariance, language,
                        out.empty() ? "" : reproduction_words::kComma.in(language),
                        significant_text(*variance, 6), c.method);
  }
  return out;
}

std::string inconsistencies(const Reproduction& made, Language language) {
  return with_figures(reproduction_words::kInconsistencies, language, variances(made, language), made.unit);
}

std::string mse_text(const std::optional<MetricSpreads>& metrics) {
  if (!metrics) return "-";
  const Spread& mse = metrics->mse;
  if (!mse.sd) return significant_text(mse.mean, 4);
  return fmt::format("{} ± {}", significant_text(mse.mean, 4), significant_text(*mse.sd, 2));
}

std::string spread_of_optional(const std::optional<Spread>& spread, int digits) {
  return spread ? significant_text(spread->mean, digits) : "-";
}

std::string table_1(const Reproduction& made, Language language) {
  std::string out =
      with_figures(reproduction_words::kTable1, language, made.unit, made.sizes.front().training_mse.size());
  for (const HiddenSizeScore& size : made.sizes) {
    const auto [least, most] = std::minmax_element(size.training_mse.begin(), size.training_mse.end());
    out += fmt::format("| {} | {} | {} | {} |\n", size.hidden,
                       significant_text(spread_of(size.training_mse).mean, 4), significant_text(*least, 4),
                       significant_text(*most, 4));
  }
  return out + "\n";
}

std::string coefficient_cell(const Contestant& contestant, Term term, Language language) {
  for (const Coefficient& c : contestant.runs.front().identification.coefficients) {
    if (c.term != term) continue;
    if (!c.identified) {
      return std::string(
          (c.left_out ? reproduction_words::kLeftOut : reproduction_words::kUnidentifiable).in(language));
    }
    if (!c.standard_error) return significant_text(c.value, 6);
    return fmt::format("{} ± {}", uncertain_text(c.value, c.standard_error),
                       significant_text(*c.standard_error, 2));
  }
  return "-";
}

std::string table_2(const Reproduction& made, Language language) {
  std::string out(reproduction_words::kTable2.in(language));
  std::string rule = "\n|---|---|";
  for (const Contestant& c : made.coefficients.contestants) {
    out += fmt::format(" {} |", c.method);
    rule += "---|";
  }
  out += rule + "\n";
  for (const TermInfo& term : all_terms()) {
    out += fmt::format("| {} | {:.6g} |", term.name, made.truth.coefficient(term.term));
    for (const Contestant& c : made.coefficients.contestants) {
      out += fmt::format(" {} |", coefficient_cell(c, term.term, language));
    }
    out += "\n";
  }
  const auto row = [&](const Words& label, auto text) {
    out += fmt::format("| {} | |", label.in(language));
    for (const Contestant& c : made.coefficients.contestants) out += fmt::format(" {} |", text(c));
    out += "\n";
  };
  const auto figure = [](const std::optional<double>& value) {
    return value ? significant_text(*value, 3) : "-";
  };
  row(reproduction_words::kOverStandardError,
      [&](const Contestant& c) { return figure(c.truth->rms_over_standard_error); });
  row(reproduction_words::kOverBound, [&](const Contestant& c) { return figure(c.truth->rms_over_bound); });
  row(reproduction_words::kTestMse, [](const Contestant& c) { return mse_text(c.test); });
  return out.append(reproduction_words::kTable2End.in(language));
}

std::string paper_mse(std::size_t contestant) {
  return contestant < kPaperTestMse.size() ? fmt::format("{}", kPaperTestMse.at(contestant)) : "-";
}

std::string table_3(const Reproduction& made, Language language) {
  std::string out = with_figures(reproduction_words::kTable3, language, made.unit, made.networks.repeats,
                                 significant_text(made.noise_mse, 4));
  MapeRows mape_rows;
  for (std::size_t k = 0; k < made.networks.contestants.size(); ++k) {
    const Contestant& c = made.networks.contestants[k];
    out += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", c.method, paper_mse(k),
                       mse_text(c.test), significant_text(c.test->mae.mean, 4),
                       significant_text(c.test->rmse.mean, 4), spread_of_optional(c.test->mape_percent, 4),
                       c.test->r2 ? determination_text(c.test->r2->mean) : "-", mse_text(c.train),
                       spread_of_optional(c.iterations, 5), significant_text(c.time.mean, 3));
    for (const Run& run : c.runs) mape_rows.add(reproduction_words::kTestPart, run.identification.test);
  }
  if (const std::string text = mape_rows.text(language); !text.empty())
    out += with_figures(reproduction_words::kSentence, language, text);
  return out + "\n";
}

std::string costs(const Reproduction& made, Language language) {
  return with_figures(reproduction_words::kCosts, language, made.search_iterations, made.swarm_iterations,
                      significant_text(made.swarm_iterations / made.search_iterations, 3));
}

std::string gains(const Reproduction& made, Language language) {
  std::string out = with_figures(reproduction_words::kGains, language, made.gains.front().bp_mse.size(),
                                 made.search_iterations);
  for (const SwarmGain& gain : made.gains) {
    out += fmt::format("| {:.4g} | {} | {} | {:.0f} | {:.0f} | {} |\n", gain.sigma * 1e6, gain.preset,
                       significant_text(gain.ratio(), 4), gain.bp_iterations, gain.swarm_iterations,
                       significant_text(gain.swarm_iterations / made.search_iterations, 3));
  }
  return out.append(reproduction_words::kGainsEnd.in(language));
}

std::string pictures(const Reproduction& made, Language language) {
  std::string out(reproduction_words::kPictures.in(language));
  int number = 4;
  for (const PaperFigure& figure : figures_of(made)) {
    out += with_figures(reproduction_words::kPicture, language, number++, figure.chart.title.in(language),
                        figure.name);
  }
  return out;
}

std::string table_1_csv(const Reproduction& made) {
  std::string out = "hidden,repeat,training_mse\n";
  for (const HiddenSizeScore& size : made.sizes) {
    for (std::size_t r = 0; r < size.training_mse.size(); ++r) {
      out += fmt::format("{},{},{}\n", size.hidden, r + 1, size.training_mse[r]);
    }
  }
  return out;
}

}  // namespace

std::string render_reproduction(const Reproduction& made, Language language) {
  return with_figures(reproduction_words::kIntro, language, kPaperCitation, made.twin, made.rows,
                      made.sigma * 1e6, made.seed) +
         table_1(made, language) + table_2(made, language) + table_3(made, language) + costs(made, language) +
         gains(made, language) + pictures(made, language) + inconsistencies(made, language);
}

std::vector<NamedText> reproduction_files(const Reproduction& made, Language language) {
  std::vector<NamedText> files{{"reproduction.md", render_reproduction(made, language)},
                               {"table-1.csv", table_1_csv(made)},
                               {"table-2.json", to_json(made.coefficients)},
                               {"table-3.json", to_json(made.networks)}};
  for (const PaperFigure& figure : figures_of(made)) {
    files.push_back({figure.name + ".csv", figure_csv(figure.chart)});
    files.push_back({figure.name + ".svg", render_svg(figure.chart, {.file = language})});
  }
  return files;
}

}  // namespace proofmass
