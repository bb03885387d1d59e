// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/regression/wls.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "proofmass/core/error.hpp"
#include "proofmass/identify/model/ending_of.hpp"
#include "proofmass/identify/model/identifiability.hpp"
#include "proofmass/identify/model/static_fit.hpp"
#include "proofmass/identify/model/term_sums.hpp"
#include "proofmass/identify/options/field_text.hpp"
#include "proofmass/identify/regression/uncertainties.hpp"
#include "proofmass/identify/regression/weighted_rows.hpp"
#include "proofmass/numeric/linear/normal_solution.hpp"
#include "proofmass/numeric/regression/growing_variance.hpp"

namespace proofmass {
namespace {

// A weighted fit, the variance that turns its unscaled covariance into the covariance, and what to say.
struct Weighted {
  std::vector<double> coefficients;
  Matrix unscaled_covariance;
  double rss = 0.0;  // all rows alike
  double variance = 0.0;
  std::size_t rows = 0;  // with weight
  Ending ending;
  std::vector<Finding> findings;
  std::optional<std::size_t> iterations;  // of the variance model
  RowWeights row_weights;
};

// 1 / sigma_E², that of the first row being one.
std::vector<double> sigma_weights(const Dataset& training) {
  std::vector<double> weights;
  weights.reserve(training.rows());
  for (std::size_t row = 0; row < training.rows(); ++row) {
    const double ratio = training.output_sigma.front() / training.output_sigma[row];
    weights.push_back(ratio * ratio);
  }
  return weights;
}

// `ratio`: chi²/dof.
void add_chi_square_findings(std::vector<Finding>& findings, double ratio, double dof,
                             ChiSquareScaling scaling) {
  const double spread = std::sqrt(2.0 / dof);
  const double factor = std::sqrt(ratio);
  if (scaling == ChiSquareScaling::given) {
    findings.push_back({.code = Code::sigma_output_taken,
                        .figures = {{"ratio", ratio}, {"spread", spread}, {"factor", factor}}});
  } else {
    findings.push_back({.code = Code::sigma_output_scaled,
                        .figures = {{"ratio", ratio}, {"spread", spread}, {"factor", 1.0 / factor}}});
  }
}

// `counted`: the rows with weight.
Weighted fit_by_sigma(const TermSums& sums, const TermList& terms, std::vector<double> weights,
                      std::size_t counted, const Wls& options) {
  const Dataset& training = sums.data();
  // The variance that weight 1 stands for.
  const double unit_variance = training.output_sigma.front() * training.output_sigma.front();
  const TermRows rows = sums.rows(terms);
  const WeightedRows weighted(rows, weights);
  NormalSolution solution = solve_normal_equations(sums.weighted_gram(terms), weighted);
  const auto dof = static_cast<double>(counted - terms.size());
  const double ratio = solution.rss / dof / unit_variance;
  Weighted result;
  result.row_weights = {.values = std::move(weights), .fixed = true};
  result.rows = counted;
  result.rss = residual_sum_of_squares(sums.gram(terms), rows, solution.coefficients);
  result.coefficients = std::move(solution.coefficients);
  result.unscaled_covariance = std::move(solution.unscaled_covariance);
  result.variance = options.scaling == ChiSquareScaling::given ? unit_variance : unit_variance * ratio;
  result.findings.push_back({.code = Code::weights_from_sigma});
  add_chi_square_findings(result.findings, ratio, dof, options.scaling);
  if (counted < training.rows()) {
    result.findings.push_back(
        {.code = Code::rows_without_weight,
         .figures = {{"count", training.rows() - counted}, {"total", training.rows()}}});
  }
  result.ending = {.status = EndingStatus::direct,
                   .parts = {{.code = EndingCode::weighted_normal_equations,
                              .figures = {{"rows", counted}, {"count", terms.size()}}}}};
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

Weighted fit_by_model(const TermSums& sums, const TermList& terms, const Wls& options) {
  const Dataset& training = sums.data();
  std::vector<double> weights = squared_magnitudes(training);
  GrowingVarianceFit fit =
      fit_growing_variance(sums.rows(terms), weights, {.iterations = options.iterations});
  Weighted result;
  result.rows = training.rows();
  result.findings.push_back({.code = Code::weights_from_model,
                             .figures = {{"s0", std::sqrt(fit.base)},
                                         {"s1", std::sqrt(fit.slope)},
                                         {"unit", training.output_unit.canonical_symbol()},
                                         {"axes", axes_text(training)}}});
  if (options.scaling == ChiSquareScaling::scaled) result.findings.push_back({.code = Code::scaling_unused});
  if (fit.slope == 0.0) result.findings.push_back({.code = Code::variance_does_not_grow});
  result.iterations = fit.iterations;
  result.variance = fit.variance;
  for (double& w : weights) w = 1.0 / (fit.base + fit.slope * w);
  const bool exact = !std::all_of(weights.begin(), weights.end(), [](double w) { return std::isfinite(w); });
  if (exact) weights.clear();  // no residuals that tell one row from another
  result.row_weights = {.values = std::move(weights), .fixed = false};
  result.ending = ending_of(fit.termination);
  result.coefficients = std::move(fit.fit.coefficients);
  result.unscaled_covariance = std::move(fit.fit.unscaled_covariance);
  result.rss = fit.fit.rss;
  return result;
}

bool uses_sigma(const Dataset& training, WeightSource source) {
  if (source == WeightSource::sigma && training.output_sigma.empty()) {
    throw bad_data(
        {.file = training.source, .row = 0, .column = "sigma_E"}, "",
        "a column with the standard uncertainty of E in each row; or let the residuals decide the weights",
        {{"weights", "model"}});
  }
  return source != WeightSource::model && !training.output_sigma.empty();
}

StaticFit static_fit(const TermSums& sums, const TermList& terms, const Weighted& weighted) {
  return {.coefficients = weighted.coefficients,
          .covariance = scaled(weighted.unscaled_covariance, weighted.variance),
          .vif = variance_inflation(sums.gram(terms))};
}

}  // namespace

SigmaColumns Wls::sigma_columns() const noexcept {
  return {.output = weights != WeightSource::model,
          .inputs = false,
          .instead_of_output = {"weights", "model"},
          .instead_of_inputs = {}};
}

Identification fit(const Wls& method, const Dataset& training, const IdentifyOptions& options,
                   Progress& progress) {
  require_in_range(method);
  progress.update("weighted least squares", 0, 1);
  const bool by_sigma = uses_sigma(training, method.weights);
  require_usable_sigmas(training, method.sigma_columns());
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
    weighted = fit_by_sigma(sums, found.identified, std::move(weights), counted, method);
  } else {
    weighted = fit_by_model(sums, found.identified, method);
  }

  Identification result =
      make_identification("wls", training, options, found, static_fit(sums, found.identified, weighted));
  add_residual_figures(result.diagnostics, training, weighted.rss, found.identified.size());
  result.diagnostics.dof = weighted.rows - found.identified.size();
  result.findings.insert(result.findings.end(), weighted.findings.begin(), weighted.findings.end());
  result.findings.push_back({.code = Code::weighted_noise_assumed});
  if (!by_sigma) note_unused_sigma(result, training);
  result.diagnostics.iterations = weighted.iterations;
  result.row_weights = std::move(weighted.row_weights);
  result.ending = std::move(weighted.ending);
  progress.update("weighted least squares", 1, 1);
  return result;
}

}  // namespace proofmass
