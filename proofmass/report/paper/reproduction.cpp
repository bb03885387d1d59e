// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/paper/reproduction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "proofmass/report/json/comparison.hpp"
#include "proofmass/report/mape_rows.hpp"
#include "proofmass/report/number_text.hpp"
#include "proofmass/report/paper/reproduction_figures_internal.hpp"
#include "proofmass/report/plot/svg.hpp"
#include "proofmass/study/paper/citation.hpp"

namespace proofmass {
namespace {

// What the printed MSE and R² of each network say of the variance of its test outputs.
std::string variances(const Reproduction& made) {
  std::string out;
  for (const Contestant& c : made.networks.contestants) {
    const auto variance = implied_variance(c);
    if (!variance) continue;
    out += fmt::format("{}{} by {}", out.empty() ? "" : ", ", significant_text(*variance, 6), c.method);
  }
  return out;
}

std::string inconsistencies(const Reproduction& made) {
  return fmt::format(
      R"(## What does not fit in the paper

- **Table 1**: the exponent printed for 7 nodes, the size that the paper chose, does not agree with the sizes beside it. Table 1 above shows how far sizes and random starts make the training MSE differ; nothing sets 7 apart from 6 or 8 by a power of ten.
- **Table 3**: with one test set, 1 − R² = MSE / variance, so MSE / (1 − R²) must be the same for every method. The R² printed beside 2.6884e-3 for BP and 9.178e-6 for PSO-BP imply different variances: the two were not scored on the same rows, or a figure is misprinted. Here every method is scored on the same test rows, and the variance comes out as {} ({})².
- **BP's MSE**: 2.6884e-3 is 293 times 9.178e-6. Were the latter the noise of the record, BP had ended 17 times above it in RMSE; here one textbook run ends near the noise (Table 3).
- **The second Kop**: the model lists Kop twice, once for Ao·Ap and once for the odd quadratic term |Ai|·Ai. The standard's name of the latter is Koq, which is used here.
- How coefficients come out of the network is left open. Here the network is projected onto the model's terms by least squares.
- Fitness is said to be the RMSE of a particle; 50,000 iterations are 50 particles × 50 generations × 20 epochs, so each particle was trained before it was scored. The paper's preset does that.
)",
      variances(made), made.unit);
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

std::string table_1(const Reproduction& made) {
  std::string out = fmt::format(
      "## Table 1: size of the hidden layer\n\nTraining MSE of textbook BP in ({})²; repeats with other "
      "splits and starts: {}. The paper chose 7 of 3…12 by this figure alone.\n\n| hidden | mean | least | "
      "largest "
      "|\n|---|---|---|---|\n",
      made.unit, made.sizes.front().training_mse.size());
  for (const HiddenSizeScore& size : made.sizes) {
    const auto [least, most] = std::minmax_element(size.training_mse.begin(), size.training_mse.end());
    out += fmt::format("| {} | {} | {} | {} |\n", size.hidden,
                       significant_text(spread_of(size.training_mse).mean, 4), significant_text(*least, 4),
                       significant_text(*most, 4));
  }
  return out + "\n";
}

std::string coefficient_cell(const Contestant& contestant, Term term) {
  for (const Coefficient& c : contestant.runs.front().identification.coefficients) {
    if (c.term != term) continue;
    if (!c.identified) return c.left_out ? "left out" : "unidentifiable";
    if (!c.standard_error) return significant_text(c.value, 6);
    return fmt::format("{} ± {}", uncertain_text(c.value, c.standard_error),
                       significant_text(*c.standard_error, 2));
  }
  return "-";
}

std::string table_2(const Reproduction& made) {
  std::string out =
      "## Table 2: coefficients\n\nIn g per g^order, ± one standard error; \"left out\" is a method's choice "
      "and counts as zero, \"-\" was not asked for. The truth of the twin is what the paper's PSO-BP "
      "identified; the paper gives 8 coefficients by LSM, 10 by GMDH and 15 by PSO-BP.\n\n| term | the "
      "paper's PSO-BP: our truth |";
  std::string rule = "\n|---|---|";
  for (const Contestant& c : made.coefficients.contestants) {
    out += fmt::format(" {} |", c.method);
    rule += "---|";
  }
  out += rule + "\n";
  for (const TermInfo& term : all_terms()) {
    out += fmt::format("| {} | {:.6g} |", term.name, made.truth.coefficient(term.term));
    for (const Contestant& c : made.coefficients.contestants) {
      out += fmt::format(" {} |", coefficient_cell(c, term.term));
    }
    out += "\n";
  }
  const auto row = [&](const char* label, auto text) {
    out += fmt::format("| {} | |", label);
    for (const Contestant& c : made.coefficients.contestants) out += fmt::format(" {} |", text(c));
    out += "\n";
  };
  const auto figure = [](const std::optional<double>& value) {
    return value ? significant_text(*value, 3) : "-";
  };
  row("rms error / standard error",
      [&](const Contestant& c) { return figure(c.truth->rms_over_standard_error); });
  row("rms error / Cramér–Rao bound", [&](const Contestant& c) { return figure(c.truth->rms_over_bound); });
  row("test MSE", [](const Contestant& c) { return mse_text(c.test); });
  return out +
         "\nThe figures of error are over the terms that a method was asked for; a short model may look "
         "exact in its "
         "own "
         "terms and miss the rest. Least squares with the right terms already reaches the bound under "
         "this white noise: no network can do better here.\n\n";
}

std::string paper_mse(std::size_t contestant) {
  return contestant < kPaperTestMse.size() ? fmt::format("{}", kPaperTestMse.at(contestant)) : "-";
}

std::string table_3(const Reproduction& made) {
  std::string out = fmt::format(
      "## Table 3: errors\n\nOn the test rows, in {0} and ({0})², mean over repeats with other splits and "
      "starts, of which there are {1}. \"Ours\" "
      "is the "
      "default preset; multistart spends the swarm's epochs on random starts instead, an ablation that the "
      "paper lacks. The noise alone makes an MSE of about {2}.\n\n| method | the paper's MSE | MSE | MAE | "
      "RMSE | MAPE % | R² | training MSE | iterations | time, s "
      "|\n|---|---|---|---|---|---|---|---|---|---|\n",
      made.unit, made.networks.repeats, significant_text(made.noise_mse, 4));
  MapeRows mape_rows;
  for (std::size_t k = 0; k < made.networks.contestants.size(); ++k) {
    const Contestant& c = made.networks.contestants[k];
    out += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", c.method, paper_mse(k),
                       mse_text(c.test), significant_text(c.test->mae.mean, 4),
                       significant_text(c.test->rmse.mean, 4), spread_of_optional(c.test->mape_percent, 4),
                       c.test->r2 ? determination_text(c.test->r2->mean) : "-", mse_text(c.train),
                       spread_of_optional(c.iterations, 5), significant_text(c.time.mean, 3));
    for (const Run& run : c.runs) mape_rows.add("test", run.identification.test);
  }
  if (const std::string text = mape_rows.text(); !text.empty()) out += fmt::format("\n{}.\n", text);
  return out + "\n";
}

std::string costs(const Reproduction& made) {
  return fmt::format(
      "## Iterations\n\n| | the paper | here |\n|---|---|---|\n| BP: the sizes of Table 1, then the final "
      "training | 11,000 | {:.0f} |\n| PSO-BP: the swarm's training, then the final one | 50,000 | {:.0f} |\n"
      "| ratio | 4.5 | {} |\n\nThe paper's 11,000 are 10 sizes × 1000 + 1000; training that converges or "
      "stops "
      "early spends less. The swarm scores its particles once before its first generation, and its final "
      "training is counted here.\n\n",
      made.search_iterations, made.swarm_iterations,
      significant_text(made.swarm_iterations / made.search_iterations, 3));
}

std::string gains(const Reproduction& made) {
  std::string out = fmt::format(
      "## What the swarm gains over one BP run\n\nTest MSE of one textbook BP run over that of PSO-BP, "
      "geometric "
      "mean over {} records. The paper's is 293. With the paper's noise BP already ends near the noise, and "
      "no "
      "method can be much better; at 1 µg the training decides. Iterations are epochs of training, all "
      "particles together; where the swarm scores particles without training them, as ours does, each "
      "scoring "
      "counts as one iteration too, though it is less work than an epoch.\n\n| noise, µg | PSO-BP | MSE "
      "ratio "
      "| iterations of BP | of PSO-BP | over the {:.0f} of BP's search |\n|---|---|---|---|---|---|\n",
      made.gains.front().bp_mse.size(), made.search_iterations);
  for (const SwarmGain& gain : made.gains) {
    out += fmt::format("| {:.4g} | {} | {} | {:.0f} | {:.0f} | {} |\n", gain.sigma * 1e6, gain.preset,
                       significant_text(gain.ratio(), 4), gain.bp_iterations, gain.swarm_iterations,
                       significant_text(gain.swarm_iterations / made.search_iterations, 3));
  }
  return out +
         "\nThe paper's BP MSE (2.6884e-3) is far above the noise that its PSO-BP shows (9.178e-6, or 309 "
         "µg).\n\n";
}

std::string pictures(const Reproduction& made) {
  std::string out = "## Figures\n\n";
  int number = 4;
  for (const PaperFigure& figure : figures_of(made)) {
    out += fmt::format("![Figure {0}: {1}]({2}.svg)\n\nFigure {0}: {1} ([data]({2}.csv)).\n\n", number++,
                       figure.chart.title.en, figure.name);
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

std::string render_reproduction(const Reproduction& made) {
  return fmt::format(
             "# The paper's experiment, repeated\n\nThe paper: {}.\n\nThe paper's own record is not public. "
             "This is a "
             "simulated twin ({}): "
             "its coefficients as truth, {} rows, white noise of {:.4g} µg, seed {}, 70 % of the rows to "
             "train on. Figures of the two experiments need not agree, for the records differ; their "
             "order and the costs should.\n\n",
             kPaperCitation, made.twin, made.rows, made.sigma * 1e6, made.seed) +
         table_1(made) + table_2(made) + table_3(made) + costs(made) + gains(made) + pictures(made) +
         inconsistencies(made);
}

std::vector<NamedText> reproduction_files(const Reproduction& made) {
  std::vector<NamedText> files{{"reproduction.md", render_reproduction(made)},
                               {"table-1.csv", table_1_csv(made)},
                               {"table-2.json", to_json(made.coefficients)},
                               {"table-3.json", to_json(made.networks)}};
  for (const PaperFigure& figure : figures_of(made)) {
    files.push_back({figure.name + ".csv", figure_csv(figure.chart)});
    files.push_back({figure.name + ".svg", render_svg(figure.chart, {.file = Language::en})});
  }
  return files;
}

}  // namespace proofmass
