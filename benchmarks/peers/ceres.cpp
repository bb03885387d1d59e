// SPDX-License-Identifier: Apache-2.0
// Ceres' Levenberg-Marquardt with analytic Jacobian. Variants: batched (one cost function for all samples,
// vector tanh) and rows (a residual block per sample, the usual form), each also with -qr.
#include <ceres/ceres.h>
#include <ceres/version.h>

#include <cmath>

#include "contract/contend.hpp"
#include "peers/blas.hpp"
#include "peers/network.hpp"

namespace {

using namespace bench;
using peers::kHidden;
using peers::kHiddenWeights;
using peers::kInputs;
using peers::kParameters;

class Batch final : public ceres::CostFunction {
 public:
  explicit Batch(const NetworkSamples& samples) : network_(samples) {
    set_num_residuals(static_cast<int>(network_.rows()));
    mutable_parameter_block_sizes()->push_back(kParameters);
  }
  bool Evaluate(const double* const* weights, double* residuals, double** jacobians) const override {
    network_.residuals(weights[0], residuals);
    if (jacobians != nullptr && jacobians[0] != nullptr) network_.jacobian(weights[0], jacobians[0]);
    return true;
  }

 private:
  mutable peers::Network network_;  // keeps the hidden outputs for the Jacobian
};

class OneSample final : public ceres::SizedCostFunction<1, kParameters> {
 public:
  explicit OneSample(const Row& sample) : sample_(sample) {}
  bool Evaluate(const double* const* weights, double* residual, double** jacobians) const override {
    const double* const w = weights[0];
    const double* const v = w + kHiddenWeights;
    double* const row = jacobians != nullptr ? jacobians[0] : nullptr;
    residual[0] = v[kHidden] - sample_[kInputs];
    for (std::size_t j = 0; j < kHidden; ++j) {
      double z = w[kHidden * kInputs + j];
      for (std::size_t k = 0; k < kInputs; ++k) z += w[j * kInputs + k] * sample_[k];
      const double h = std::tanh(z);
      residual[0] += v[j] * h;
      if (row == nullptr) continue;
      const double slope = v[j] * (1.0 - h * h);
      for (std::size_t k = 0; k < kInputs; ++k) row[j * kInputs + k] = slope * sample_[k];
      row[kHidden * kInputs + j] = slope;
      row[kHiddenWeights + j] = h;
    }
    if (row != nullptr) row[kParameters - 1] = 1.0;
    return true;
  }

 private:
  const Row& sample_;
};

// Ceres counts rejected steps as iterations; an epoch here is an accepted step.
class StepLimit final : public ceres::IterationCallback {
 public:
  explicit StepLimit(std::size_t steps) : steps_(steps) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override {
    if (summary.iteration > 0 && summary.step_is_successful) ++taken_;
    return taken_ < steps_ ? ceres::SOLVER_CONTINUE : ceres::SOLVER_TERMINATE_SUCCESSFULLY;
  }
  [[nodiscard]] std::size_t taken() const noexcept { return taken_; }

 private:
  std::size_t steps_;
  std::size_t taken_ = 0;
};

ceres::Solver::Options options_for(const Request& request) {
  ceres::Solver::Options options;
  options.linear_solver_type =
      request.variant.ends_with("-qr") ? ceres::DENSE_QR : ceres::DENSE_NORMAL_CHOLESKY;
  options.max_num_iterations = static_cast<int>(10 * request.epochs);
  options.function_tolerance = options.gradient_tolerance = options.parameter_tolerance = 0.0;
  options.num_threads = 1;
  options.logging_type = ceres::SILENT;
  return options;
}

Answer train(const Request& request) {
  const NetworkSamples samples = read_samples(request);
  std::vector<double> weights(kParameters);
  ceres::Problem problem;
  if (request.variant.starts_with("rows")) {
    for (std::size_t row = 0; row < samples.rows; ++row) {
      problem.AddResidualBlock(new OneSample(samples.at(row)), nullptr, weights.data());
    }
  } else {
    problem.AddResidualBlock(new Batch(samples), nullptr, weights.data());
  }
  ceres::Solver::Options options = options_for(request);
  Answer answer = contend_training(request, samples, [&](std::span<const double> start, std::size_t epochs) {
    weights.assign(start.begin(), start.end());
    StepLimit limit(epochs);
    options.callbacks = {&limit};
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    return Trained{.weights = weights,
                   .rmse = std::sqrt(2.0 * summary.final_cost / static_cast<double>(samples.rows)),
                   .epochs = limit.taken()};
  });
  answer.about["version"] = CERES_VERSION_STRING;
  answer.about["blas"] = peers::blas_kernel();
  return answer;
}

}  // namespace

int main(int argc, char** argv) { return contend(argc, argv, {{"train", train}}); }
