// SPDX-License-Identifier: Apache-2.0
#include "peers/network.hpp"

#include <algorithm>
#include <cmath>

namespace bench::peers {
namespace {

constexpr std::size_t kBlock = 64;

// h[s] = tanh(b + w . x[s]) for `rows` samples from `first` on.
void tanh_block(const std::vector<double>* inputs, const double* weights, std::size_t j, std::size_t first,
                std::size_t rows, double* h) {
  const double* const x0 = inputs[0].data() + first;
  const double* const x1 = inputs[1].data() + first;
  const double* const x2 = inputs[2].data() + first;
  const double* const w = weights + j * kInputs;
  const double b = weights[kHidden * kInputs + j];
  for (std::size_t s = 0; s < rows; ++s) h[s] = std::tanh(b + w[0] * x0[s] + w[1] * x1[s] + w[2] * x2[s]);
}

}  // namespace

Network::Network(const NetworkSamples& samples) : rows_(samples.rows) {
  for (auto& input : inputs_) input.resize(rows_);
  target_.resize(rows_);
  hidden_.resize(kHidden * rows_);
  for (std::size_t row = 0; row < rows_; ++row) {
    for (std::size_t k = 0; k < kInputs; ++k) inputs_[k][row] = samples.at(row)[k];
    target_[row] = samples.at(row)[kInputs];
  }
}

double Network::sum_of_squares(const double* weights) const {
  const double* const v = weights + kHiddenWeights;
  double sum = 0.0;
  double h[kBlock], e[kBlock];
  for (std::size_t first = 0; first < rows_; first += kBlock) {
    const std::size_t rows = std::min(kBlock, rows_ - first);
    for (std::size_t s = 0; s < rows; ++s) e[s] = v[kHidden] - target_[first + s];
    for (std::size_t j = 0; j < kHidden; ++j) {
      tanh_block(inputs_, weights, j, first, rows, h);
      for (std::size_t s = 0; s < rows; ++s) e[s] += v[j] * h[s];
    }
    for (std::size_t s = 0; s < rows; ++s) sum += e[s] * e[s];
  }
  return sum;
}

void Network::activate(const double* weights) {
  if (std::equal(activated_.begin(), activated_.end(), weights) && !activated_.empty()) return;
  for (std::size_t j = 0; j < kHidden; ++j) tanh_block(inputs_, weights, j, 0, rows_, hidden(j));
  activated_.assign(weights, weights + kHiddenWeights);
}

void Network::residuals(const double* weights, double* result) {
  activate(weights);
  const double* const v = weights + kHiddenWeights;
  for (std::size_t s = 0; s < rows_; ++s) result[s] = v[kHidden] - target_[s];
  for (std::size_t j = 0; j < kHidden; ++j) {
    const double* const h = hidden(j);
    for (std::size_t s = 0; s < rows_; ++s) result[s] += v[j] * h[s];
  }
}

void Network::jacobian(const double* weights, double* result) {
  activate(weights);
  const double* const v = weights + kHiddenWeights;
  for (std::size_t s = 0; s < rows_; ++s) {
    double* const row = result + s * kParameters;
    const double x[kInputs] = {inputs_[0][s], inputs_[1][s], inputs_[2][s]};
    for (std::size_t j = 0; j < kHidden; ++j) {
      const double h = hidden_[j * rows_ + s];
      const double slope = v[j] * (1.0 - h * h);
      for (std::size_t k = 0; k < kInputs; ++k) row[j * kInputs + k] = slope * x[k];
      row[kHidden * kInputs + j] = slope;
      row[kHiddenWeights + j] = h;
    }
    row[kParameters - 1] = 1.0;
  }
}

void Network::second_derivative(const double* weights, const double* direction, double* result) {
  activate(weights);
  const double* const v = weights + kHiddenWeights;
  const double* const dv = direction + kHiddenWeights;
  std::fill_n(result, rows_, 0.0);
  for (std::size_t j = 0; j < kHidden; ++j) {
    const double* const h = hidden(j);
    const double* const dw = direction + j * kInputs;
    const double db = direction[kHidden * kInputs + j];
    for (std::size_t s = 0; s < rows_; ++s) {
      const double dz = db + dw[0] * inputs_[0][s] + dw[1] * inputs_[1][s] + dw[2] * inputs_[2][s];
      const double slope = 1.0 - h[s] * h[s];
      result[s] += slope * dz * 2.0 * (dv[j] - v[j] * h[s] * dz);
    }
  }
}

}  // namespace bench::peers
