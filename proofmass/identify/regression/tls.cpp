// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/regression/tls.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "proofmass/core/error.hpp"
#include "proofmass/identify/model/design_matrix.hpp"
#include "proofmass/identify/model/identifiability.hpp"
#include "proofmass/identify/model/static_fit.hpp"
#include "proofmass/identify/options/field_text.hpp"
#include "proofmass/identify/regression/static_surface.hpp"
#include "proofmass/identify/regression/uncertainties.hpp"
#include "proofmass/numeric/linear/least_squares.hpp"
#include "proofmass/numeric/regression/total_least_squares.hpp"

namespace proofmass {
namespace {

// gap² - 1 times the degrees of freedom is the square of a t statistic: how far the weakest combination of
// the uncertain regressors stands out of its own noise.
constexpr double kLeastSquaredT = 9.0;

// Root mean square over the rows of a column of standard deviations.
double typical(const std::vector<double>& sigma) {
  double sum = 0.0;
  for (const double value : sigma) sum += value * value;
  return std::sqrt(sum / static_cast<double>(sigma.size()));
}

// Mean over the rows of the variance of one term's regressor to first order: sum over the axes of
// (d regressor / dA)² sigma_A².
double regressor_variance(Term term, const Dataset& data, const Uncertainties& sigmas) {
  const std::vector<Axis> axes = data.axes();
  const StaticSurface surface({term}, axes);
  SurfaceBlock block(axes.size(), 1);
  const double one = 1.0;
  double sum = 0.0;
  for (std::size_t first = 0; first < data.rows(); first += SurfaceBlock::kRows) {
    const std::size_t count = std::min(SurfaceBlock::kRows, data.rows() - first);
    for (std::size_t k = 0; k < axes.size(); ++k) {
      std::copy_n(data.along(axes[k]).begin() + static_cast<std::ptrdiff_t>(first), count,
                  block.x.column(k).begin());
    }
    surface.evaluate({&one, 1}, count, block);
    for (std::size_t k = 0; k < axes.size(); ++k) {
      const auto& sigma = sigmas.input[static_cast<std::size_t>(axes[k])];
      if (sigma.empty()) continue;
      for (std::size_t r = 0; r < count; ++r) {
        const double error = block.by_input(r, k) * sigma[first + r];
        sum += error * error;
      }
    }
  }
  return sum / static_cast<double>(data.rows());
}

std::vector<double> regressor_sigmas(const TermList& terms, const Dataset& data,
                                     const Uncertainties& sigmas) {
  std::vector<double> result;
  for (const Term term : terms) result.push_back(std::sqrt(regressor_variance(term, data, sigmas)));
  return result;
}

double residual_square_sum(const Matrix& design, const std::vector<double>& output,
                           const std::vector<double>& coefficients) {
  std::vector<double> residual = output;
  for (std::size_t c = 0; c < design.columns(); ++c) {
    for (std::size_t r = 0; r < residual.size(); ++r) residual[r] -= coefficients[c] * design(r, c);
  }
  double sum = 0.0;
  for (const double value : residual) sum += value * value;
  return sum;
}

void require_generic(const TotalLeastSquaresFit& fit) {
  if ((fit.gap * fit.gap - 1.0) * static_cast<double>(fit.dof) > kLeastSquaredT) return;
  throw refusal(
      "tls has no generic solution: by the uncertainties given, some combination of the regressors is no "
      "larger than its own error; give smaller ones or fewer terms, or use eiv");
}

void add_findings(std::vector<Finding>& findings, const TermList& terms, const Uncertainties& sigmas,
                  ChiSquareScaling scaling, double variance_ratio) {
  findings.insert(findings.end(), sigmas.findings.begin(), sigmas.findings.end());
  findings.push_back(explain_standard_errors(scaling, variance_ratio));
  const bool powers = std::any_of(terms.begin(), terms.end(), [](Term t) { return info(t).order() > 1; });
  if (powers) {
    findings.push_back({.code = Code::total_least_squares_biased, .severity = Severity::warning});
  }
}

}  // namespace

SigmaColumns Tls::sigma_columns() const noexcept { return uncertainty.sigma_columns(); }

Identification fit(const Tls& method, const Dataset& training, const IdentifyOptions& options,
                   Progress& progress) {
  require_in_range(method);
  progress.update("total least squares", 0, 1);
  const Identifiability found =
      require_identifiable(training, options.terms, options.on_rank_loss, method.uncertainty.input);
  if (progress.cancelled()) throw Error(ErrorKind::interrupted, "interrupted before total least squares");
  const TermList& terms = found.identified;
  const Matrix design = design_matrix(training, terms);
  const Uncertainties sigmas = find_uncertainties(
      "tls", training, terms, solve_least_squares(design, training.output).coefficients, method.uncertainty);
  TotalLeastSquaresFit solution = solve_total_least_squares(
      design, training.output, regressor_sigmas(terms, training, sigmas), typical(sigmas.output));
  require_generic(solution);

  const double ratio = solution.variance_ratio();
  if (method.uncertainty.scaling == ChiSquareScaling::scaled) {
    solution.unscaled_covariance = scaled(std::move(solution.unscaled_covariance), ratio);
  }
  const double rss = residual_square_sum(design, training.output, solution.coefficients);
  Identification result = make_identification("tls", training, options, found,
                                              {.coefficients = std::move(solution.coefficients),
                                               .covariance = std::move(solution.unscaled_covariance),
                                               .vif = {}});
  add_residual_figures(result.diagnostics, training, rss, terms.size());
  result.row_weights = {.values = {}, .fixed = false};  // one uncertainty a column: all rows weigh alike
  add_findings(result.findings, terms, sigmas, method.uncertainty.scaling, ratio);
  result.ending = {
      .status = EndingStatus::direct,
      .parts = {{.code = EndingCode::singular_values,
                 .figures = {{"rows", training.rows()}, {"count", terms.size()}, {"gap", solution.gap}}}}};
  progress.update("total least squares", 1, 1);
  return result;
}

}  // namespace proofmass
