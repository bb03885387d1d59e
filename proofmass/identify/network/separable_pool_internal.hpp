// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

#include "proofmass/numeric/network/variable_projection.hpp"

namespace proofmass {

// The error of networks given by their hidden weights, for searches. Working storage is lent to one
// evaluation at a time; each stays at its initial state, so that a value cannot depend on which one computed
// it. Safe to call from several threads.
class SeparablePool {
 public:
  // Keeps references.
  SeparablePool(const PerceptronShape& shape, const Samples& samples, const ColumnBlock& fixed)
      : shape_(shape), samples_(samples), fixed_(fixed) {}

  // Root mean square over the samples, the output layer solved by least squares, to about four digits.
  [[nodiscard]] double rmse(std::span<const double> hidden_weights) const {
    std::unique_ptr<SeparablePerceptron> problem;
    {
      const std::lock_guard lock(mutex_);
      if (!idle_.empty()) {
        problem = std::move(idle_.back());
        idle_.pop_back();
      }
    }
    if (!problem) problem = std::make_unique<SeparablePerceptron>(shape_, samples_, fixed_);
    const double value = root_mean(problem->estimate(hidden_weights), samples_);
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(problem));
    return value;
  }

 private:
  const PerceptronShape& shape_;
  const Samples& samples_;
  const ColumnBlock& fixed_;
  mutable std::mutex mutex_;
  mutable std::vector<std::unique_ptr<SeparablePerceptron>> idle_;
};

}  // namespace proofmass
