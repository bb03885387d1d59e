// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/network/perceptron_problem.hpp"

namespace proofmass {

PerceptronProblem::PerceptronProblem(const PerceptronShape& shape, const Samples& samples)
    : shape_(shape), samples_(samples), columns_(shape, samples) {}

double PerceptronProblem::evaluate(std::span<const double> weights) {
  trial_.assign(weights.begin(), weights.end());
  kept_ = trial_;
  return perceptron_sse(shape_, weights, samples_, columns_);
}

void PerceptronProblem::linearise(Matrix& normal, std::span<double> gradient) {
  perceptron_normal_equations(shape_, current_, samples_, kept_ == current_, columns_, normal, gradient);
  kept_ = current_;
  // The kernel differentiates the output; the residual is the target minus the output.
  for (double& g : gradient) g = -g;
}

}  // namespace proofmass
