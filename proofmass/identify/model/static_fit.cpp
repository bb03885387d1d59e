// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/model/static_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <stdexcept>

#include "proofmass/core/error.hpp"

namespace proofmass {
namespace {

// Marquardt's rule of thumb (Technometrics 12, 1970): beyond it collinearity governs the standard error.
constexpr double kInflationLimit = 10.0;
constexpr double kConditionLimit = 1e8;
// Records are written with six decimals and more; what tells terms apart by less may be the rounding of the
// text.
constexpr double kRoundingLimit = 1e5;

// Whether identifiability was judged by the rounding of every input (input_errors.hpp).
bool knows_rounding(const Dataset& data) {
  const std::vector<Axis> axes = data.axes();
  return std::all_of(axes.begin(), axes.end(), [&data](Axis axis) {
    return data.acceleration_resolution[static_cast<std::size_t>(axis)] > 0.0;
  });
}

void add_condition_findings(const Identification& result, const Dataset& data,
                            std::vector<Finding>& findings) {
  Finding collinear{.code = Code::inputs_collinear};
  std::string inflated;
  for (const Coefficient& c : result.coefficients) {
    if (!c.vif || *c.vif <= kInflationLimit) continue;
    collinear.terms.push_back(c.term);
    inflated += fmt::format("{}{} {:.3g}", inflated.empty() ? "" : ", ", name(c.term), *c.vif);
  }
  if (!inflated.empty()) {
    collinear.figures = {{"limit", kInflationLimit}, {"inflated", inflated}};
    findings.push_back(std::move(collinear));
  }
  const double condition = result.diagnostics.condition_scaled.value_or(1.0);
  if (condition > kRoundingLimit && !knows_rounding(data)) {
    findings.push_back({.code = Code::terms_apart_by_rounding,
                        .severity = Severity::warning,
                        .figures = {{"separation", 1.0 / condition}}});
  }
  if (condition > kConditionLimit) {
    findings.push_back({.code = Code::rounding_costs_digits,
                        .figures = {{"condition", condition}, {"digits", std::log10(condition)}}});
  }
}

Coefficient unidentified_coefficient(Term term, const Identifiability& found) {
  Coefficient coefficient;
  coefficient.term = term;
  coefficient.identified = false;
  for (const Finding& finding : found.unidentified) {
    if (finding.terms.front() == term) coefficient.reason = finding;
  }
  return coefficient;
}

Coefficient fitted_coefficient(Term term, std::size_t k, const StaticFit& fit) {
  Coefficient coefficient;
  coefficient.term = term;
  coefficient.value = fit.coefficients[k];
  if (fit.covariance.rows() > 0) coefficient.standard_error = std::sqrt(std::max(0.0, fit.covariance(k, k)));
  if (!fit.vif.empty() && !std::isnan(fit.vif[k])) coefficient.vif = fit.vif[k];
  return coefficient;
}

void require_sizes(const Identifiability& found, const StaticFit& fit) {
  const std::size_t n = found.identified.size();
  const auto all_or_none = [n](std::size_t size) { return size == n || size == 0; };
  if (fit.coefficients.size() != n || !all_or_none(fit.vif.size()) || !all_or_none(fit.covariance.rows()) ||
      fit.covariance.columns() != fit.covariance.rows()) {
    throw std::invalid_argument("a fit needs one coefficient, variance and vif for each identified term");
  }
}

void require_finite(const StaticFit& fit) {
  const std::span<const double> variances(fit.covariance.data(),
                                          fit.covariance.rows() * fit.covariance.columns());
  const auto finite = [](double value) { return std::isfinite(value); };
  if (std::all_of(fit.coefficients.begin(), fit.coefficients.end(), finite) &&
      std::all_of(variances.begin(), variances.end(), finite)) {
    return;
  }
  throw refusal(
      "the record's values are so large or so small that the coefficients or their variances overflow");
}

}  // namespace

void note_unused_sigma(Identification& result, const Dataset& training) {
  if (training.output_sigma.empty()) return;
  result.findings.push_back({.code = Code::sigma_output_unused, .figures = {{"method", result.method}}});
}

std::string model_name(const TermList& terms) {
  for (const char* preset : {"linear", "quadratic", "paper", "full"}) {
    if (terms == parse_terms(preset)) return preset;
  }
  return join_names(terms);
}

Identification make_identification(std::string_view method, const Dataset& training,
                                   const IdentifyOptions& options, const Identifiability& found,
                                   const StaticFit& fit) {
  require_sizes(found, fit);
  require_finite(fit);
  Identification result;
  result.method = method;
  result.model = model_name(options.terms);
  result.seed = options.seed;
  result.output_unit = training.output_unit;
  for (const Axis axis : training.axes()) {
    const auto [low, high] = std::minmax_element(training.along(axis).begin(), training.along(axis).end());
    result.input_range.push_back({axis, {.low = *low, .high = *high}});
  }
  for (const Term term : options.terms) {
    const auto at = std::find(found.identified.begin(), found.identified.end(), term);
    const auto place = static_cast<std::size_t>(at - found.identified.begin());
    result.coefficients.push_back(at != found.identified.end() ? fitted_coefficient(term, place, fit)
                                                               : unidentified_coefficient(term, found));
  }
  // Symmetric, so that column-major and row-major agree.
  result.covariance.assign(fit.covariance.data(),
                           fit.covariance.data() + fit.covariance.rows() * fit.covariance.rows());
  result.diagnostics.condition_raw = found.condition_raw;
  result.diagnostics.condition_scaled = found.condition_scaled;
  result.findings = found.unidentified;
  add_condition_findings(result, training, result.findings);
  return result;
}

void add_residual_figures(Diagnostics& diagnostics, const Dataset& training, double rss,
                          std::size_t parameters) {
  const std::size_t n = training.rows();
  if (n <= parameters) return;
  const auto dof = static_cast<double>(n - parameters);
  double mean = 0.0;
  for (const double value : training.output) mean += value / static_cast<double>(n);
  double total = 0.0;
  for (const double value : training.output) total += (value - mean) * (value - mean);
  diagnostics.dof = n - parameters;
  diagnostics.residual_sd = std::sqrt(rss / dof);
  if (total > 0.0) diagnostics.r2_adjusted = 1.0 - (rss / dof) / (total / static_cast<double>(n - 1));
}

}  // namespace proofmass
