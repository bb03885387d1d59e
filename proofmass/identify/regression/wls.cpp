// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/regression/wls.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "proofmass/core/error.hpp"
#include "proofmass/identify/model/identifiability.hpp"
#include "proofmass/identify/model/static_fit.hpp"
#include "proofmass/identify/model/term_sums.hpp"
#include "proofmass/identify/regression/weighted_rows.hpp"
#include "proofmass/numeric/linear/normal_solution.hpp"
#include "proofmass/numeric/regression/growing_variance.hpp"

namespace proofmass {
namespace {

// Standard deviations of chi²/dof, sqrt(2/dof), beyond which a note doubts the sigmas.
constexpr double kDoubt = 4.0;

// A weighted fit, the variance that turns its unscaled covariance into the covariance, and what to say.
struct Weighted {
  std::vector<double> coefficients;
  Matrix unscaled_covariance;
  double rss = 0.0;  // all rows alike
  double variance = 0.0;
  std::size_t rows = 0;  // with weight
  Ending ending;
  std::vector<std::string> notes;
  std::optional<std::size_t> iterations;  // of the variance model
};

Error bad_sigma(const Dataset& training, std::size_t row) {
  const std::size_t line = training.line.empty() ? 0 : training.line[row];
  return bad_data(
      {.file = training.source, .row = line, .column = "sigma_E"},
      fmt::format("{}", training.output_sigma[row]),
      "a standard uncertainty above zero; or leave weights to the residuals with --weights model");
}

// 1 / sigma_E², that of the first row being one.
std::vector<double> sigma_weights(const Dataset& training) {
  std::vector<double> weights;
  weights.reserve(training.rows());
  for (std::size_t row = 0; row < training.rows(); ++row) {
    const double sigma = training.output_sigma[row];
    if (!(sigma > 0.0) || !std::isfinite(sigma)) throw bad_sigma(training, row);
    const double ratio = training.output_sigma.front() / sigma;
    weights.push_back(ratio * ratio);
  }
  return weights;
}

std::string chi_square_note(double ratio, double dof, ChiSquareScaling scaling) {
  std::string note = fmt::format("chi²/dof = {:.5g} (about 1 ± {:.2g} when sigma_E is right); ", ratio,
                                 std::sqrt(2.0 / dof));
  note += scaling == ChiSquareScaling::given
              ? fmt::format(
                    "standard errors take sigma_E as given; scaled to the residuals (--sigma-scale "
                    "chi2) they are {:.5g} times as large",
                    std::sqrt(ratio))
              : fmt::format(
                    "standard errors are scaled to the residuals; with sigma_E taken as given "
                    "(--sigma-scale given) they are {:.5g} times as large",
                    1.0 / std::sqrt(ratio));
  if (std::abs(ratio - 1.0) > kDoubt * std::sqrt(2.0 / dof)) {
    note += ratio > 1.0
                ? ". The residuals are larger than sigma_E allows: it is too small, or the model lacks "
                  "terms, or there are outliers"
                : ". The residuals are smaller than sigma_E says: it is too large";
  }
  return note;
}

// `counted`: the rows with weight.
Weighted fit_by_sigma(const TermSums& sums, const TermList& terms, std::vector<double> weights,
                      std::size_t counted, const WlsOptions& options) {
  const Dataset& training = sums.data();
  // The variance that weight 1 stands for.
  const double unit_variance = training.output_sigma.front() * training.output_sigma.front();
  const TermRows rows = sums.rows(terms);
  const WeightedRows weighted(rows, std::move(weights));
  NormalSolution solution = solve_normal_equations(sums.weighted_gram(terms), weighted);
  const auto dof = static_cast<double>(counted - terms.size());
  const double ratio = solution.rss / dof / unit_variance;
  Weighted result;
  result.rows = counted;
  result.rss = residual_sum_of_squares(sums.gram(terms), rows, solution.coefficients);
  result.coefficients = std::move(solution.coefficients);
  result.unscaled_covariance = std::move(solution.unscaled_covariance);
  result.variance = options.scaling == ChiSquareScaling::given ? unit_variance : unit_variance * ratio;
  result.notes.emplace_back("weights are 1 / sigma_E² from the record");
  result.notes.push_back(chi_square_note(ratio, dof, options.scaling));
  if (counted < training.rows()) {
    result.notes.push_back(
        fmt::format("{} of {} rows have no weight beside the others, their sigma_E being so much larger: "
                    "they tell nothing and do not count as degrees of freedom",
                    training.rows() - counted, training.rows()));
  }
  result.ending = {
      .status = EndingStatus::direct,
      .reason = fmt::format("solved directly by normal equations in twice the working precision: {} weighted "
                            "rows, {} coefficients",
                            counted, terms.size())};
  return result;
}

// |A|² over the axes that the record has.
std::vector<double> squared_magnitudes(const Dataset& training) {
  std::vector<double> squares(training.rows());
  for (std::size_t row = 0; row < squares.size(); ++row) {
    const Acceleration a = training.at(row);
    squares[row] = a.i * a.i + a.o * a.o + a.p * a.p;
  }
  return squares;
}

std::string axes_text(const Dataset& training) {
  std::string text;
  for (const Axis axis : training.axes())
    text += fmt::format("{}{}", text.empty() ? "" : ", ", axis_name(axis));
  return text;
}

Weighted fit_by_model(const TermSums& sums, const TermList& terms, const WlsOptions& options) {
  const Dataset& training = sums.data();
  GrowingVarianceFit fit = fit_growing_variance(sums.rows(terms), squared_magnitudes(training),
                                                {.iterations = options.iterations});
  Weighted result;
  result.rows = training.rows();
  const std::string unit = training.output_unit.canonical_symbol();
  result.notes.push_back(fmt::format(
      "weights are from the residuals by restricted maximum likelihood: sigma² = s0² + s1² |A|², s0 = {:.5g} "
      "{}, s1 = {:.5g} {}/g, |A| over {}",
      std::sqrt(fit.base), unit, std::sqrt(fit.slope), unit, axes_text(training)));
  if (fit.slope == 0.0) {
    result.notes.emplace_back(
        "the residuals show no growth with |A|, or |A| is the same in every row: all rows weigh alike, the "
        "result is that of ols");
  }
  result.iterations = fit.iterations;
  result.variance = fit.variance;
  result.ending = {.status = fit.termination.cause == Cause::converged ? EndingStatus::converged
                                                                       : EndingStatus::iteration_limit,
                   .reason = std::move(fit.termination.reason)};
  result.coefficients = std::move(fit.fit.coefficients);
  result.unscaled_covariance = std::move(fit.fit.unscaled_covariance);
  result.rss = fit.fit.rss;
  return result;
}

bool uses_sigma(const Dataset& training, WeightSource source) {
  if (source == WeightSource::sigma && training.output_sigma.empty()) {
    throw bad_data({.file = training.source, .row = 0, .column = "sigma_E"}, "",
                   "a column with the standard uncertainty of E in each row; or --weights model");
  }
  return source != WeightSource::model && !training.output_sigma.empty();
}

StaticFit static_fit(const TermSums& sums, const TermList& terms, const Weighted& weighted) {
  Matrix covariance = weighted.unscaled_covariance;
  for (std::size_t c = 0; c < covariance.columns(); ++c) {
    for (double& value : covariance.column(c)) value *= weighted.variance;
  }
  return {.coefficients = weighted.coefficients,
          .covariance = std::move(covariance),
          .vif = variance_inflation(sums.gram(terms))};
}

}  // namespace

Identification identify_wls(const Dataset& training, const Dataset& /*validation*/,
                            const IdentifyOptions& options, Progress& progress) {
  progress.update("weighted least squares", 0, 1);
  const bool by_sigma = uses_sigma(training, options.wls.weights);
  std::vector<double> weights = by_sigma ? sigma_weights(training) : std::vector<double>();
  const TermSums sums =
      by_sigma ? TermSums(training, options.terms, weights) : TermSums(training, options.terms);
  Identifiability found = require_identifiable(sums, options.on_rank_loss);
  if (progress.cancelled())
    throw Error(ErrorKind::interrupted, "interrupted before the weighted least-squares solution");
  Weighted weighted;
  if (by_sigma) {
    const std::size_t counted = count_rows_with_weight(weights);
    if (counted < training.rows()) {
      found = require_identifiable_by_weight(training, found, weights, options.on_rank_loss);
    }
    weighted = fit_by_sigma(sums, found.identified, std::move(weights), counted, options.wls);
  } else {
    weighted = fit_by_model(sums, found.identified, options.wls);
  }

  Identification result =
      make_identification("wls", training, options, found, static_fit(sums, found.identified, weighted));
  add_residual_figures(result.diagnostics, training, weighted.rss, found.identified.size());
  result.diagnostics.dof = weighted.rows - found.identified.size();
  auto& notes = result.diagnostics.notes;
  notes.insert(notes.end(), weighted.notes.begin(), weighted.notes.end());
  notes.emplace_back(
      "standard errors assume exact inputs and independent output noise whose variance is as said; residual "
      "sd is over all rows alike");
  if (!by_sigma && !training.output_sigma.empty()) {
    notes.emplace_back("sigma_E is not used: weights were asked for from the residuals");
  }
  result.diagnostics.iterations = weighted.iterations;
  result.ending = std::move(weighted.ending);
  progress.update("weighted least squares", 1, 1);
  return result;
}

}  // namespace proofmass
