// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/residuals/row_figures.hpp"

#include <cmath>
#include <limits>

#include "proofmass/identify/method.hpp"
#include "proofmass/identify/model/term_rows.hpp"
#include "proofmass/numeric/linear/deletion_residuals.hpp"

namespace proofmass {
namespace {

// Least squares with weights that are the same whatever the outputs. A robust fit gives a row far off no
// weight, and an influence of zero would hide it; errors in variables have no hat matrix. A result file does
// not keep weights, and those of ols are all alike.
bool is_least_squares(const Identification& result, std::size_t rows) {
  if (result.network || result.method == "eiv" || result.method == "tls" || !result.row_weights.fixed)
    return false;
  return result.row_weights.values.size() == rows || result.method == "ols";
}

// Of residuals of one in every row, the deletion residual is 1 / (1 - h).
std::vector<double> leverages(const Dataset& fitted, const Identification& result) {
  const TermRows rows(fitted, result.static_model().terms, axis_ranges(fitted));
  const std::vector<double> ones(fitted.rows(), 1.0);
  std::vector<double> leverage = deletion_residuals(rows, ones, result.row_weights.values).residuals;
  for (double& h : leverage) h = std::isnan(h) ? 1.0 : 1.0 - 1.0 / h;
  return leverage;
}

void add_influence(RowFigures& figures, const Dataset& record, const Split& split,
                   const Identification& result) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double>& weights = result.row_weights.values;
  const Dataset fitted = record.select(split.training);
  const std::vector<double> leverage = leverages(fitted, result);
  const auto parameters = static_cast<double>(result.static_model().terms.size());
  double sum = 0.0;
  for (std::size_t k = 0; k < leverage.size(); ++k) {
    const double r = figures.residuals[split.training[k]];
    sum += (weights.empty() ? 1.0 : weights[k]) * r * r;
  }
  const double scale = std::sqrt(sum / (static_cast<double>(leverage.size()) - parameters));
  figures.leverage.assign(record.rows(), kNone);
  figures.studentised.assign(record.rows(), kNone);
  figures.cooks_distance.assign(record.rows(), kNone);
  for (std::size_t k = 0; k < leverage.size(); ++k) {
    const std::size_t row = split.training[k];
    const double h = leverage[k];
    figures.leverage[row] = h;
    if (!(h < 1.0) || !(scale > 0.0)) continue;
    const double root_weight = weights.empty() ? 1.0 : std::sqrt(weights[k]);
    const double t = figures.residuals[row] * root_weight / (scale * std::sqrt(1.0 - h));
    figures.studentised[row] = t;
    figures.cooks_distance[row] = t * t * h / ((1.0 - h) * parameters);
  }
}

}  // namespace

RowFigures row_figures(const Dataset& record, const Split& split, const Identification& result) {
  RowFigures figures;
  figures.parts = parts_of(split, record.rows());
  figures.predicted = predict(result, record);
  figures.residuals = figures.predicted;
  for (std::size_t row = 0; row < record.rows(); ++row)
    figures.residuals[row] = record.output[row] - figures.predicted[row];
  const bool some_left = split.training.size() > result.static_model().terms.size();
  if (some_left && is_least_squares(result, split.training.size()))
    add_influence(figures, record, split, result);
  return figures;
}

}  // namespace proofmass
