// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/test_curve.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "proofmass/assess/metrics.hpp"
#include "proofmass/identify/method.hpp"

namespace proofmass {

void add_test_curve(Identification& result, const Dataset& test) {
  const TrainingPath& path = result.training_path;
  const auto training = std::find_if(result.history.begin(), result.history.end(),
                                     [](const Curve& curve) { return curve.name == "training_rmse"; });
  if (!result.network || test.rows() == 0 || path.epochs.empty() || training == result.history.end()) return;
  Identification passed;  // the network as it was
  passed.network = result.network;
  passed.output_unit = result.output_unit;
  std::vector<double> values(training->values.size());
  for (std::size_t k = 0; k < path.epochs.size(); ++k) {
    passed.network->weights = path.weights[k];
    const double rmse = score(test.output, predict(passed, test), 1.0 / test.output_unit.to_canonical).rmse;
    const std::size_t end = k + 1 < path.epochs.size() ? path.epochs[k + 1] : values.size();
    for (std::size_t epoch = path.epochs[k]; epoch < std::min(end, values.size()); ++epoch)
      values[epoch] = rmse;
  }
  // Behind it, before the curves of a swarm.
  auto place = training + 1;
  if (place != result.history.end() && place->name == "validation_rmse") ++place;
  result.history.insert(place, {"test_rmse", std::move(values)});
}

}  // namespace proofmass
