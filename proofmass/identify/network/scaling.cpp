// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/network/scaling.hpp"

#include <algorithm>
#include <numeric>
#include <span>
#include <string>

#include "proofmass/core/error.hpp"
#include "proofmass/numeric/network/perceptron_kernels.hpp"

namespace proofmass {
namespace {

Interval range_of(const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return {*low, *high};
}

void scale_into(const std::vector<double>& values, const Interval& range, std::span<double> scaled) {
  const double width = range.high - range.low;
  for (std::size_t r = 0; r < values.size(); ++r) {
    scaled[r] = width > 0.0 ? 2.0 * (values[r] - range.low) / width - 1.0 : 0.0;
  }
}

}  // namespace

TrainedNetwork learn_scaling(const Dataset& training) {
  TrainedNetwork network;
  network.inputs = training.axes();
  for (const Axis axis : network.inputs) network.input_range.push_back(range_of(training.along(axis)));
  network.output_range = range_of(training.output);
  return network;
}

double output_half_range(const TrainedNetwork& network) noexcept {
  return (network.output_range.high - network.output_range.low) / 2.0;
}

Samples scale_rows(const TrainedNetwork& network, const Dataset& data) {
  Samples samples(network.inputs.size(), data.rows());
  for (std::size_t k = 0; k < network.inputs.size(); ++k) {
    const Axis axis = network.inputs[k];
    if (!data.has(axis)) {
      throw bad_data({.file = data.source, .column = std::string(axis_name(axis))}, "",
                     "a column with the specific force along an axis that the network takes as input");
    }
    scale_into(data.along(axis), network.input_range[k], samples.input(k));
  }
  if (!data.output.empty()) scale_into(data.output, network.output_range, samples.target());
  return samples;
}

Dataset in_canonical_order(const Dataset& data) {
  std::vector<std::size_t> order(data.rows());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto precedes = [&data](std::size_t a, std::size_t b) {
    for (const auto& column : data.acceleration) {
      if (!column.empty() && column[a] != column[b]) return column[a] < column[b];
    }
    return data.output[a] < data.output[b];
  };
  std::stable_sort(order.begin(), order.end(), precedes);
  return data.select(order);
}

std::vector<double> network_outputs(const TrainedNetwork& network, const Dataset& data) {
  const Samples samples = scale_rows(network, data);
  std::vector<double> outputs(samples.rows());
  perceptron_outputs({network.inputs.size(), network.hidden}, network.weights, samples, outputs);
  const double half = output_half_range(network);
  for (double& output : outputs) output = network.output_range.low + (output + 1.0) * half;
  if (network.skip.terms.empty()) return outputs;
  for (std::size_t r = 0; r < outputs.size(); ++r) outputs[r] += network.skip.output(data.at(r));
  return outputs;
}

}  // namespace proofmass
