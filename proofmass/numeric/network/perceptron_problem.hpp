// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "proofmass/numeric/network/perceptron.hpp"
#include "proofmass/numeric/network/perceptron_kernels.hpp"
#include "proofmass/numeric/optimise/levenberg_marquardt.hpp"
#include "proofmass/numeric/samples.hpp"

namespace proofmass {

// Training of all weights at once: r = target - output over the samples, x = the network's weights.
class PerceptronProblem final : public SumOfSquares {
 public:
  // Keeps a reference to the samples.
  PerceptronProblem(const PerceptronShape& shape, const Samples& samples);

  [[nodiscard]] std::size_t parameters() const override { return shape_.parameters(); }
  double evaluate(std::span<const double> weights) override;
  void accept() override { current_ = trial_; }
  void linearise(Matrix& normal, std::span<double> gradient) override;

 private:
  PerceptronShape shape_;
  const Samples& samples_;
  std::vector<double> current_, trial_;
  PerceptronColumns columns_;
  std::vector<double> kept_;  // weights that the columns belong to
};

}  // namespace proofmass
