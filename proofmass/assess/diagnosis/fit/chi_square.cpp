// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/fit/chi_square.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>

#include "proofmass/assess/diagnosis/record/output_resolution.hpp"
#include "proofmass/assess/diagnosis/record/term_space.hpp"
#include "proofmass/numeric/regression/robust_loss.hpp"

namespace proofmass {
namespace {

constexpr double kDoubt = 4.5;              // standard errors of the ratio
constexpr double kFar = 0.1;                // of the ratio from one
constexpr double kMedianEfficiency = 0.37;  // of the scale by the median of normal residuals
constexpr double kAlike = 1.01;             // greatest over least uncertainty of rows that all weigh alike
constexpr double kUneven = 4.0;             // of squared scales between rows with large and small sigma
constexpr double kUnlikelyUneven = 1e-6;
constexpr double kOtherSigma = 2.0;        // greatest over least uncertainty, for rows to be compared
constexpr std::size_t kLeastOfEither = 5;  // rows, beside those that the terms take
constexpr double kInputsMatter = 0.25;     // of the residuals' variance

bool is_robust(const Identification& result) { return std::holds_alternative<RobustDetails>(result.details); }

// The variance that the inputs' uncertainties give each output; empty where the record has none.
std::vector<double> variance_from_inputs(const Dataset& record, const StaticModel& model) {
  std::vector<double> variance;
  const auto& sigmas = record.acceleration_sigma;
  const std::vector<Axis> axes = record.axes();
  const auto is_exact = [&sigmas](Axis axis) { return sigmas[static_cast<std::size_t>(axis)].empty(); };
  if (std::all_of(axes.begin(), axes.end(), is_exact)) return variance;
  for (std::size_t row = 0; row < record.rows(); ++row)
    variance.push_back(model.variance_from_inputs(record.at(row), across_axes(sigmas, row)));
  return variance;
}

// The residuals over their standard uncertainties. A fit whose weights are other ones spreads the noise of a
// row over rows with less; what a fit by these uncertainties would take up again is taken off.
std::vector<double> scaled_residuals(const FittedRows& rows, const std::vector<double>& sigma,
                                     const Identification& result) {
  const std::span<const double> robust_weights =
      is_robust(result) ? rows.weights() : std::span<const double>();
  const auto [least, greatest] = std::minmax_element(sigma.begin(), sigma.end());
  std::vector<double> scaled(rows.residuals().begin(), rows.residuals().end());
  if (*greatest >= kAlike * *least) {
    std::vector<double> weights(rows.rows());
    for (std::size_t row = 0; row < weights.size(); ++row)
      weights[row] = (robust_weights.empty() ? 1.0 : robust_weights[row]) / (sigma[row] * sigma[row]);
    scaled = rows.residuals_by(weights);
  }
  for (std::size_t row = 0; row < scaled.size(); ++row) scaled[row] /= sigma[row];
  return scaled;
}

// Where the rows in the order of their uncertainty are divided: at the widest step in it, or in the middle
// where there is none that is wide.
std::size_t divided_at(const std::vector<double>& ascending) {
  std::size_t widest = ascending.size() / 2;
  double ratio = kOtherSigma;
  for (std::size_t k = 1; k < ascending.size(); ++k) {
    if (ascending[k] <= ratio * ascending[k - 1]) continue;
    ratio = ascending[k] / ascending[k - 1];
    widest = k;
  }
  return widest;
}

// Whether rows with large uncertainties and rows with small ones scatter by the same multiple of them, by the
// median, so that a few outliers do not matter. The terms go by the rows with small ones, and take up as many
// of their degrees of freedom.
std::optional<Finding> uneven_sigma(const std::vector<double>& sigma, const std::vector<double>& scaled,
                                    std::size_t terms, const Unit& unit) {
  std::vector<std::size_t> order(sigma.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return sigma[a] < sigma[b]; });
  std::vector<double> ascending;
  ascending.reserve(sigma.size());
  for (const std::size_t row : order) ascending.push_back(sigma[row]);
  const std::size_t small = divided_at(ascending);
  const std::size_t large = order.size() - small;
  if (ascending.back() < kOtherSigma * ascending.front() || small < terms + kLeastOfEither ||
      large < kLeastOfEither)
    return std::nullopt;
  std::vector<double> of_small;
  std::vector<double> of_large;
  for (std::size_t k = 0; k < order.size(); ++k)
    (k < small ? of_small : of_large).push_back(scaled[order[k]]);
  const double small_scale = median_scale(of_small, terms);
  const double large_scale = median_scale(of_large, 0);
  const double small_dof = kMedianEfficiency * static_cast<double>(small - terms);
  const double large_dof = kMedianEfficiency * static_cast<double>(large);
  const double ratio = std::pow(small_scale / large_scale, 2);
  const double unlikely = ratio > 1.0 ? fisher_probability(ratio, small_dof, large_dof)
                                      : fisher_probability(1.0 / ratio, large_dof, small_dof);
  if ((ratio < kUneven && ratio * kUneven > 1.0) || unlikely > kUnlikelyUneven) return std::nullopt;
  return Finding{.code = Code::sigma_output_uneven,
                 .severity = Severity::warning,
                 .figures = {{"count", large},
                             {"limit", ascending[small] / std::abs(unit.to_canonical)},
                             {"unit", unit.symbol},
                             {"large", large_scale},
                             {"small", small_scale}}};
}

// Of sigma_E with what the inputs' uncertainties add; empty where the record has none, or a row has neither.
std::vector<double> standard_uncertainties(const Dataset& record, const std::vector<double>& from_inputs) {
  std::vector<double> sigma(record.output_sigma);
  for (std::size_t row = 0; row < sigma.size(); ++row) {
    sigma[row] = std::hypot(sigma[row], from_inputs.empty() ? 0.0 : std::sqrt(from_inputs[row]));
    if (!(sigma[row] > 0.0)) return {};
  }
  return sigma;
}

std::optional<Finding> wrong_sigma(const FittedRows& rows, const Identification& result,
                                   const std::vector<double>& scaled) {
  const Dataset& record = rows.record();
  const bool robust = is_robust(result);
  const auto fitted = static_cast<double>(result.diagnostics.dof.value_or(rows.dof()));
  const double n = result.train ? static_cast<double>(result.train->n) : static_cast<double>(rows.rows());
  const double dof = static_cast<double>(rows.rows()) * std::min(1.0, fitted / n);
  // The median of rounding errors is not that of normal noise.
  const double step = output_resolution(record).step;
  if (robust && step > *std::min_element(record.output_sigma.begin(), record.output_sigma.end()))
    return std::nullopt;
  const double scale = median_scale(scaled, rows.basis().columns());
  const double ratio = robust ? scale * scale : sum_of_squares(scaled) / dof;
  // The cube root of chi² per degree of freedom is nearly normal (Wilson and Hilferty, PNAS 17, 1931).
  const double counted = robust ? kMedianEfficiency * dof : dof;
  const double variance = 2.0 / (9.0 * counted);
  const double errors = (std::cbrt(ratio) - (1.0 - variance)) / std::sqrt(variance);
  if (!(std::abs(errors) > kDoubt && std::abs(ratio - 1.0) > kFar)) return std::nullopt;
  return Finding{.code = ratio > 1.0 ? Code::sigma_output_too_small : Code::sigma_output_too_large,
                 .severity = Severity::warning,
                 .figures = {{"ratio", ratio}, {"factor", std::sqrt(ratio)}}};
}

// Against the residuals by their median, lest outliers hide it.
std::optional<Finding> find_unused_input_sigma(const FittedRows& rows, const Identification& result,
                                               const std::vector<double>& from_inputs) {
  if (from_inputs.empty()) return std::nullopt;
  const double mean =
      std::accumulate(from_inputs.begin(), from_inputs.end(), 0.0) / static_cast<double>(from_inputs.size());
  const double fraction = rows.scale() > 0.0 ? mean / (rows.scale() * rows.scale()) : 1.0;
  return Finding{.code = Code::sigma_inputs_unused,
                 .severity = fraction > kInputsMatter ? Severity::warning : Severity::note,
                 .figures = {{"method", result.method}, {"percent", 100.0 * std::min(1.0, fraction)}}};
}

}  // namespace

std::vector<Finding> find_wrong_sigmas(const FittedRows& rows, const Identification& result,
                                       bool input_columns_used, bool explained) {
  std::vector<Finding> findings;
  const auto add = [&findings](std::optional<Finding> found) {
    if (found) findings.push_back(std::move(*found));
  };
  const Dataset& record = rows.record();
  const std::vector<double> from_inputs = variance_from_inputs(record, result.static_model());
  const std::vector<double> sigma = standard_uncertainties(record, from_inputs);
  const bool has_sigma = !sigma.empty() && rows.dof() > 0;
  const std::vector<double> scaled =
      has_sigma ? scaled_residuals(rows, sigma, result) : std::vector<double>();
  // Where the method has the inputs' uncertainties from its options, the record does not tell the variance.
  const bool known = !rows.inputs_uncertain() || !from_inputs.empty();
  if (has_sigma && known) add(wrong_sigma(rows, result, scaled));
  if (!input_columns_used) add(find_unused_input_sigma(rows, result, from_inputs));
  if (!explained) add(find_uneven_sigma(rows, result));
  return findings;
}

std::optional<Finding> find_uneven_sigma(const FittedRows& rows, const Identification& result) {
  const Dataset& record = rows.record();
  const std::vector<double> sigma =
      standard_uncertainties(record, variance_from_inputs(record, result.static_model()));
  if (sigma.empty() || rows.dof() == 0 || !rows.has_noise() || is_robust(result)) return std::nullopt;
  return uneven_sigma(record.output_sigma, scaled_residuals(rows, sigma, result), rows.basis().columns(),
                      record.output_unit);
}

}  // namespace proofmass
