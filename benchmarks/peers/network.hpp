// SPDX-License-Identifier: Apache-2.0
// The network as a careful user of another library would write it: samples in columns, blocks that stay in
// the cache, loops that a compiler can vectorise. The build compiles it twice (see CMakeLists.txt): plainly,
// with the C library's scalar tanh, and with -O3 -march=native -ffast-math, with libmvec's vector tanh.
#pragma once

#include <cstddef>
#include <vector>

#include "contract/table.hpp"

namespace bench::peers {

inline constexpr std::size_t kInputs = 3;
inline constexpr std::size_t kHidden = 7;
inline constexpr std::size_t kHiddenWeights = kHidden * (kInputs + 1);
inline constexpr std::size_t kParameters = kHiddenWeights + kHidden + 1;

// Weights in the order w_1 … w_7 (three each), b_1 … b_7, v_1 … v_7, c. Residuals are output - target.
class Network {
 public:
  explicit Network(const NetworkSamples& samples);
  [[nodiscard]] std::size_t rows() const noexcept { return rows_; }

  [[nodiscard]] double sum_of_squares(const double* weights) const;
  void residuals(const double* weights, double* result);
  // Row-major: kParameters values per sample. Hidden outputs are kept from the last call with these weights.
  void jacobian(const double* weights, double* result);
  // Second derivative of the residuals along `direction`.
  void second_derivative(const double* weights, const double* direction, double* result);

 private:
  void activate(const double* weights);
  [[nodiscard]] double* hidden(std::size_t j) { return hidden_.data() + j * rows_; }

  std::size_t rows_;
  std::vector<double> inputs_[kInputs];
  std::vector<double> target_;
  std::vector<double> hidden_;     // outputs of unit j from j * rows_
  std::vector<double> activated_;  // the weights of these outputs
};

}  // namespace bench::peers
