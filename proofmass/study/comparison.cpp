// SPDX-License-Identifier: Apache-2.0
#include "proofmass/study/comparison.hpp"

#include <algorithm>
#include <cmath>

namespace proofmass {
namespace {

template <typename Figure>
std::optional<Spread> spread_over(const std::vector<Run>& runs, Figure figure) {
  std::vector<double> values;
  for (const Run& run : runs) {
    const std::optional<double> value = figure(run.identification);
    if (!value) return std::nullopt;
    values.push_back(*value);
  }
  return spread_of(values);
}

using Part = std::optional<Metrics> Identification::*;

std::optional<MetricSpreads> spreads_of(const std::vector<Run>& runs, Part part) {
  for (const Run& run : runs) {
    if (!(run.identification.*part)) return std::nullopt;
  }
  const auto of = [&runs, part](auto member) {
    return spread_over(
        runs, [part, member](const Identification& run) { return std::optional((*(run.*part)).*member); });
  };
  const auto maybe = [&runs, part](auto member) {
    return spread_over(runs, [part, member](const Identification& run) { return (*(run.*part)).*member; });
  };
  const auto count = [&runs, part](std::size_t Metrics::*member) {
    return *spread_over(runs, [part, member](const Identification& run) {
      return std::optional(static_cast<double>((*(run.*part)).*member));
    });
  };
  return MetricSpreads{.mae = *of(&Metrics::mae),
                       .mse = *of(&Metrics::mse),
                       .rmse = *of(&Metrics::rmse),
                       .mape_percent = maybe(&Metrics::mape_percent),
                       .r2 = maybe(&Metrics::r2),
                       .n = count(&Metrics::n),
                       .mape_rows = count(&Metrics::mape_rows)};
}

std::optional<double> ratio_of(const Spread& value, const Spread& reference) {
  return reference.mean > 0.0 ? std::optional(value.mean / reference.mean) : std::nullopt;
}

// A running root mean square.
struct RootMeanSquare {
  double sum = 0.0;
  double count = 0.0;
  void add(double value) {
    sum += value * value;
    count += 1.0;
  }
  [[nodiscard]] std::optional<double> value() const {
    return count > 0.0 ? std::optional(std::sqrt(sum / count)) : std::nullopt;
  }
};

}  // namespace

Spread spread_of(std::span<const double> values) {
  const auto n = static_cast<double>(values.size());
  Spread spread;
  for (const double value : values) spread.mean += value / n;
  if (values.size() < 2) return spread;
  double square = 0.0;
  for (const double value : values) square += (value - spread.mean) * (value - spread.mean);
  spread.sd = std::sqrt(square / (n - 1.0));
  return spread;
}

void summarise(Contestant& contestant) {
  contestant.train = spreads_of(contestant.runs, &Identification::train);
  contestant.test = spreads_of(contestant.runs, &Identification::test);
  contestant.time = spread_of(contestant.seconds);
  contestant.iterations =
      spread_over(contestant.runs, [](const Identification& run) -> std::optional<double> {
        if (!run.diagnostics.iterations) return std::nullopt;
        return static_cast<double>(*run.diagnostics.iterations);
      });
}

TermList terms_of(const Comparison& comparison) {
  TermList terms;
  for (const Contestant& contestant : comparison.contestants) {
    for (const Coefficient& c : contestant.runs.front().identification.coefficients) terms.push_back(c.term);
  }
  std::sort(terms.begin(), terms.end());
  terms.erase(std::unique(terms.begin(), terms.end()), terms.end());
  return terms;
}

CostRatios ratios_to(const Contestant& reference, const Contestant& contestant) {
  CostRatios ratios{.iterations = {}, .time = ratio_of(contestant.time, reference.time), .test_mse = {}};
  if (contestant.iterations && reference.iterations) {
    ratios.iterations = ratio_of(*contestant.iterations, *reference.iterations);
  }
  if (contestant.test && reference.test) {
    ratios.test_mse = ratio_of(contestant.test->mse, reference.test->mse);
  }
  return ratios;
}

TruthScore score_against(const StaticModel& truth, std::span<const Run> runs,
                         std::span<const std::vector<double>> bound) {
  TruthScore score;
  RootMeanSquare over_standard_error;
  RootMeanSquare over_bound;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const std::vector<Coefficient>& coefficients = runs[r].identification.coefficients;
    for (std::size_t k = 0; k < coefficients.size(); ++k) {
      const Coefficient& c = coefficients[k];
      if (!c.identified && !c.left_out) continue;
      const double error = (c.identified ? c.value : 0.0) - truth.coefficient(c.term);
      if (std::abs(error) > score.largest_error) {
        score.largest_error = std::abs(error);
        score.largest_term = c.term;
      }
      if (c.standard_error && *c.standard_error > 0.0) over_standard_error.add(error / *c.standard_error);
      if (!bound.empty() && bound[r][k] > 0.0) over_bound.add(error / bound[r][k]);
    }
  }
  score.rms_over_standard_error = over_standard_error.value();
  score.rms_over_bound = over_bound.value();
  return score;
}

std::vector<Occurrence> occurrences(const Contestant& contestant, Severity severity) {
  std::vector<Occurrence> said;
  for (const Run& run : contestant.runs) {
    for (const Finding& finding : run.identification.findings) {
      if (finding.severity != severity) continue;
      const auto same = [&finding](const Occurrence& other) {
        return other.finding.code == finding.code && other.finding.terms == finding.terms &&
               (finding.code != Code::verbatim || other.finding == finding);
      };
      auto known = std::find_if(said.begin(), said.end(), same);
      if (known == said.end()) known = said.insert(said.end(), {.finding = finding});
      ++known->repeats;
    }
  }
  return said;
}

}  // namespace proofmass
