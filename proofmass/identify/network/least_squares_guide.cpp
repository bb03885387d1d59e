// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/network/least_squares_guide.hpp"

#include <algorithm>
#include <vector>

#include "proofmass/core/dataset.hpp"
#include "proofmass/identify/network/scaling.hpp"
#include "proofmass/numeric/network/perceptron_kernels.hpp"
#include "proofmass/numeric/random.hpp"

namespace proofmass {
namespace {

constexpr std::size_t kPointsARow = 4;
// Difference beside the rows, over least squares' residual and over that at the rows, beyond which a network
// strays: sound ones have 0.1 to 0.4 and about one.
constexpr double kStrays = 0.6;
constexpr double kTimesAtRows = 2.0;
// Standard deviation of a point's distance from its row along each input, as a fraction of the input's half
// range: about the distance between rows, so that points lie between them and hardly beyond all.
constexpr double kDistance = 0.02;
// Rows near the edge are few, and rows to be predicted may lie a little beyond them.
constexpr double kOutwards = 1.05;

// The rows of a record with the output of a model.
Samples modelled(const NetworkTask& task, Dataset data) {
  for (std::size_t r = 0; r < data.rows(); ++r) data.output[r] = task.least_squares.output(data.at(r));
  return scale_rows(task.network, data);
}

Dataset points_beside(const NetworkTask& task) {
  std::vector<std::size_t> repeated;
  for (std::size_t r = 0; r < task.training.rows(); ++r) repeated.insert(repeated.end(), kPointsARow, r);
  Dataset points = task.training.select(repeated);
  RandomStream random(0, stream_id("beside"));  // the same for every seed: they judge networks
  for (std::size_t k = 0; k < task.network.inputs.size(); ++k) {
    const Interval& range = task.network.input_range[k];
    const double distance = kDistance * (range.high - range.low) / 2.0;
    for (double& a : points.acceleration[static_cast<std::size_t>(task.network.inputs[k])])
      a += distance * random.normal();
  }
  return points;
}

// Every row moved away from the middle of the inputs.
Dataset rows_moved_outwards(const NetworkTask& task) {
  Dataset moved = task.training;
  for (std::size_t k = 0; k < task.network.inputs.size(); ++k) {
    const Interval& range = task.network.input_range[k];
    const double middle = (range.low + range.high) / 2.0;
    for (double& a : moved.acceleration[static_cast<std::size_t>(task.network.inputs[k])])
      a = middle + kOutwards * (a - middle);
  }
  return moved;
}

}  // namespace

LeastSquaresGuide::LeastSquaresGuide(const NetworkTask& task)
    : rows_(modelled(task, rows_moved_outwards(task))),
      at_rows_(modelled(task, task.training)),
      beside_(modelled(task, points_beside(task))),
      noise_(task.least_squares_sd) {}

double LeastSquaresGuide::deviation(const PerceptronShape& shape, std::span<const double> weights) const {
  return root_mean(perceptron_sse(shape, weights, beside_), beside_);
}

bool LeastSquaresGuide::strays(const PerceptronShape& shape, std::span<const double> weights) const {
  const double at_rows = root_mean(perceptron_sse(shape, weights, at_rows_), at_rows_);
  return !(deviation(shape, weights) <= std::max(kStrays * noise_, kTimesAtRows * at_rows));
}

}  // namespace proofmass
