// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/network/training/weight_path.hpp"

namespace proofmass {

void add_to_path(TrainingPath& path, std::size_t epoch, double training_rmse, std::span<const double> weights,
                 std::span<const double> further_weights) {
  constexpr double kVisible = 0.999;
  if (!path.epochs.empty() && !(training_rmse < kVisible * path.last_rmse)) return;
  path.epochs.push_back(epoch);
  path.last_rmse = training_rmse;
  std::vector<double>& added = path.weights.emplace_back(weights.begin(), weights.end());
  added.insert(added.end(), further_weights.begin(), further_weights.end());
}

}  // namespace proofmass
