// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/network/coefficients.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "proofmass/identify/model/term_sums.hpp"
#include "proofmass/identify/network/scaling.hpp"
#include "proofmass/numeric/linear/normal_solution.hpp"
#include "proofmass/numeric/network/perceptron.hpp"

namespace proofmass {
namespace {

// Of least squares with the terms on the same rows, and beside it the outer product of the difference.
Matrix compared_covariance(const NormalSolution& least_squares, const std::vector<double>& difference) {
  const double variance = least_squares.rss / static_cast<double>(least_squares.dof);
  Matrix covariance = scaled(least_squares.unscaled_covariance, variance);
  for (std::size_t r = 0; r < difference.size(); ++r)
    for (std::size_t c = 0; c < difference.size(); ++c) covariance(r, c) += difference[r] * difference[c];
  return covariance;
}

// The k-th derivative of tanh at a point where tanh is t, k = 0 … 3.
double tanh_derivative(double t, int k) {
  const double slope = 1.0 - t * t;
  const std::array<double, 4> derivatives{t, slope, -2.0 * t * slope, slope * (6.0 * t * t - 2.0)};
  return derivatives[static_cast<std::size_t>(k)];
}

// Least squares of the rows' output on the terms, by sums over the rows.
NormalSolution fit_terms(const Dataset& rows, const TermList& terms) {
  const TermSums sums(rows, terms);
  return solve_normal_equations(sums.gram(), sums.rows(terms));
}

}  // namespace

ProjectedCoefficients project_onto_terms(const TrainedNetwork& network, const Dataset& data,
                                         const TermList& terms) {
  const std::vector<double> outputs = network_outputs(network, data);
  ProjectedCoefficients projected;
  std::vector<double> residual(outputs.size());
  for (std::size_t r = 0; r < outputs.size(); ++r) {
    residual[r] = data.output[r] - outputs[r];
    projected.rss += residual[r] * residual[r];
  }

  Dataset rows;
  rows.acceleration = data.acceleration;
  rows.output = outputs;
  NormalSolution fit = fit_terms(rows, terms);
  projected.fit.coefficients = std::move(fit.coefficients);
  projected.fit.vif = std::move(fit.vif);
  rows.output = std::move(residual);
  const NormalSolution missed = fit_terms(rows, terms);
  projected.deviation = missed.coefficients;
  projected.induced_deviation =
      std::sqrt(std::max(0.0, projected.rss - missed.rss) / static_cast<double>(data.rows()));
  if (data.rows() > terms.size())
    projected.fit.covariance = compared_covariance(fit_terms(data, terms), projected.deviation);
  return projected;
}

std::vector<double> expand_at_zero(const TrainedNetwork& network, const TermList& terms) {
  const PerceptronShape shape{network.inputs.size(), network.hidden};
  const double half = output_half_range(network);
  std::vector<double> coefficients(terms.size(), 0.0);
  for (std::size_t c = 0; c < terms.size(); ++c) {
    if (terms[c] == Term::K0)
      coefficients[c] = network.output_range.low + half * (1.0 + network.weights.back());
  }
  for (std::size_t j = 0; j < shape.hidden; ++j) {
    // Fold the inputs' scaling in: w . scaled(A) + b = slope . A + bias, axis by axis; an axis without range
    // has no slope.
    std::array<double, 3> slope{};
    double bias = network.weights[shape.hidden * shape.inputs + j];
    for (std::size_t k = 0; k < shape.inputs; ++k) {
      const auto [low, high] = network.input_range[k];
      if (!(high > low)) continue;
      const double w = network.weights[j * shape.inputs + k] * 2.0 / (high - low);
      slope[static_cast<std::size_t>(network.inputs[k])] = w;
      bias -= w * (low + high) / 2.0;
    }
    const double t = std::tanh(bias);
    const double v = network.weights[shape.hidden_weights() + j];
    for (std::size_t c = 0; c < terms.size(); ++c) {
      if (terms[c] == Term::Koq) continue;
      const TermInfo& term = info(terms[c]);
      double product = half * v * tanh_derivative(t, term.order());
      for (std::size_t axis = 0; axis < 3; ++axis) {
        for (int power = 1; power <= term.powers[axis]; ++power) product *= slope[axis] / power;
      }
      coefficients[c] += product;
    }
  }
  return coefficients;
}

}  // namespace proofmass
