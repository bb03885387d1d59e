// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/network/coefficients.hpp"

#include <Eigen/Core>
#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "proofmass/identify/model/term_sums.hpp"
#include "proofmass/identify/network/scaling.hpp"
#include "proofmass/numeric/linear/normal_solution.hpp"
#include "proofmass/numeric/linear/triangular_accumulator.hpp"
#include "proofmass/numeric/network/perceptron.hpp"

namespace proofmass {
namespace {

constexpr std::size_t kBlockRows = 512;
// Directions of the tangent space weaker than this fraction of the strongest (of unit-length columns) are
// rounding, not freedom of the network.
constexpr double kTangentTolerance = 1e-10;

// Derivatives of the scaled output by all weights, for scaled inputs x of one row.
void tangent_row(const PerceptronShape& shape, const std::vector<double>& weights,
                 const std::array<double, 3>& x, Matrix& block, std::size_t row, std::size_t first_column) {
  const std::size_t bias = shape.hidden * shape.inputs;
  const std::size_t outer = shape.hidden_weights();
  for (std::size_t j = 0; j < shape.hidden; ++j) {
    double z = weights[bias + j];
    for (std::size_t k = 0; k < shape.inputs; ++k) z += weights[j * shape.inputs + k] * x[k];
    const double h = std::tanh(z);
    const double slope = weights[outer + j] * (1.0 - h * h);
    for (std::size_t k = 0; k < shape.inputs; ++k)
      block(row, first_column + j * shape.inputs + k) = slope * x[k];
    block(row, first_column + bias + j) = slope;
    block(row, first_column + outer + j) = h;
  }
  block(row, first_column + outer + shape.hidden) = 1.0;
}

// Triangular factor of [X J]: the terms' design matrix beside the tangent space of the network.
Matrix joint_factor(const TrainedNetwork& network, const Dataset& data, const TermList& terms) {
  const PerceptronShape shape{network.inputs.size(), network.hidden};
  const Samples samples = scale_rows(network, data);
  TriangularAccumulator accumulator(terms.size() + shape.parameters());
  Matrix block(kBlockRows, terms.size() + shape.parameters());
  for (std::size_t first = 0; first < data.rows(); first += kBlockRows) {
    const std::size_t rows = std::min(kBlockRows, data.rows() - first);
    for (std::size_t r = 0; r < rows; ++r) {
      for (std::size_t c = 0; c < terms.size(); ++c) block(r, c) = regressor(terms[c], data.at(first + r));
      std::array<double, 3> x{};
      for (std::size_t k = 0; k < shape.inputs; ++k) x[k] = samples.input_data(k)[first + r];
      tangent_row(shape, network.weights, x, block, r, terms.size());
    }
    accumulator.add(block, rows);
  }
  return accumulator.r();
}

// X⁺ P X⁺ᵀ from the triangular factor of [X J]: in the basis of its Q, X is the leading triangle and J the
// rest.
Matrix projected_covariance(const Matrix& factor, std::size_t terms, double variance) {
  const auto size = static_cast<Eigen::Index>(factor.columns());
  const auto t = static_cast<Eigen::Index>(terms);
  const Eigen::Map<const Eigen::MatrixXd> r(factor.data(), size, size);
  Eigen::MatrixXd tangent = r.rightCols(size - t);
  for (Eigen::Index c = 0; c < tangent.cols(); ++c) {
    if (const double norm = tangent.col(c).norm(); norm > 0.0) tangent.col(c) /= norm;
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(tangent);
  qr.setThreshold(kTangentTolerance);
  const Eigen::MatrixXd basis = qr.householderQ() * Eigen::MatrixXd::Identity(size, qr.rank());
  const Eigen::MatrixXd half = r.topLeftCorner(t, t).triangularView<Eigen::Upper>().solve(basis.topRows(t));
  Matrix covariance(terms, terms);
  Eigen::Map<Eigen::MatrixXd>(covariance.data(), t, t) = variance * half * half.transpose();
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
  const std::size_t weights = network.weights.size();
  if (data.rows() > weights) {
    projected.fit.covariance =
        projected_covariance(joint_factor(network, data, terms), terms.size(),
                             projected.rss / static_cast<double>(data.rows() - weights));
  }
  rows.output = std::move(residual);
  const NormalSolution missed = fit_terms(rows, terms);
  projected.deviation = missed.coefficients;
  projected.induced_deviation =
      std::sqrt(std::max(0.0, projected.rss - missed.rss) / static_cast<double>(data.rows()));
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
