// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/perceptron_problem.hpp"

#include "proofmass/numeric/perceptron_kernels.hpp"

namespace proofmass {

PerceptronProblem::PerceptronProblem(const PerceptronShape& shape, const Samples& samples)
    : shape_(shape), samples_(samples) {}

double PerceptronProblem::evaluate(std::span<const double> weights) {
  trial_.assign(weights.begin(), weights.end());
  return perceptron_sse(shape_, weights, samples_);
}

void PerceptronProblem::linearise(Matrix& normal, std::span<double> gradient) {
  perceptron_normal_equations(shape_, current_, samples_, normal, gradient);
  // The kernel differentiates the output; the residual is the target less the output.
  for (double& g : gradient) g = -g;
}

}  // namespace proofmass
