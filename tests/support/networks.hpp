// SPDX-License-Identifier: Apache-2.0
// Networks and training options for tests of the methods that use networks.
#pragma once

#include <atomic>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <vector>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/progress.hpp"
#include "proofmass/identify/network/scaling.hpp"
#include "proofmass/identify/network/training/starts.hpp"

namespace proofmass::test {

// An untrained network with the scaling of a record.
inline TrainedNetwork random_network(const Dataset& record, std::size_t hidden, std::uint64_t seed = 1) {
  TrainedNetwork network = learn_scaling(record);
  network.hidden = hidden;
  network.weights = random_start({network.inputs.size(), hidden}, Trainer::lm, seed, 0);
  return network;
}

// The network's output at one point, computed in extended precision.
inline long double network_output(const TrainedNetwork& network, const Acceleration& a) {
  const long double point[] = {a.i, a.o, a.p};
  const std::size_t inputs = network.inputs.size();
  const std::size_t bias = inputs * network.hidden;
  long double sum = network.weights.back();
  for (std::size_t j = 0; j < network.hidden; ++j) {
    long double z = network.weights[bias + j];
    for (std::size_t k = 0; k < inputs; ++k) {
      const auto [low, high] = network.input_range[k];
      const long double x = point[static_cast<std::size_t>(network.inputs[k])];
      const long double scaled =
          high > low ? 2 * (x - low) / (static_cast<long double>(high) - low) - 1 : 0.0L;
      z += network.weights[j * inputs + k] * scaled;
    }
    sum += network.weights[bias + network.hidden + j] * std::tanh(z);
  }
  const auto [low, high] = network.output_range;
  return low + (sum + 1) / 2 * (static_cast<long double>(high) - low);
}

inline bool always() { return true; }

// Asks the computation to stop after `updates` progress reports.
class CancelAfter final : public Progress {
 public:
  explicit CancelAfter(std::size_t updates) : left_(static_cast<long>(updates)) {}
  void update(std::string_view, std::size_t, std::size_t) override { --left_; }
  [[nodiscard]] bool cancelled() const noexcept override { return left_ <= 0; }

 private:
  std::atomic<long> left_;
};

}  // namespace proofmass::test
