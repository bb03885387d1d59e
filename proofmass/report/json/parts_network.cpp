// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "proofmass/report/json/parts_internal.hpp"

namespace proofmass {
namespace {

std::vector<Axis> axes_of(const JsonNode& node) {
  std::vector<Axis> axes;
  for (const JsonNode& item : node.items()) {
    const std::string word = item.text();
    const auto* const axis =
        std::find_if(kAxes.begin(), kAxes.end(), [&](Axis a) { return axis_name(a) == word; });
    if (axis == kAxes.end()) item.fail("Ai, Ao or Ap");
    if (!axes.empty() && *axis <= axes.back()) item.fail("axes in the order Ai, Ao, Ap");
    axes.push_back(*axis);
  }
  if (axes.empty()) node.fail("at least one axis");
  return axes;
}

}  // namespace

Interval interval_of(const JsonNode& node) {
  const std::vector<double> ends = node.numbers();
  if (ends.size() != 2) node.fail("two numbers");
  return {.low = ends[0], .high = ends[1]};
}

TrainedNetwork network_of(const JsonNode& node) {
  TrainedNetwork network{.inputs = axes_of(node.at("inputs")),
                         .hidden = node.at("hidden").count(),
                         .weights = node.at("weights").numbers(),
                         .input_range = {},
                         .output_range = interval_of(node.at("output_range")),
                         .skip = {}};
  for (const JsonNode& range : node.at("input_range").items())
    network.input_range.push_back(interval_of(range));
  if (network.input_range.size() != network.inputs.size()) {
    node.at("input_range").fail("one range for each input");
  }
  const auto ordered = [](const Interval& range) { return range.low <= range.high; };
  if (!std::all_of(network.input_range.begin(), network.input_range.end(), ordered)) {
    node.at("input_range").fail("ranges whose low end is not above the high end");
  }
  if (!(network.output_range.low < network.output_range.high)) {
    node.at("output_range").fail("a low end below the high end");
  }
  // Compared by division, so that an absurd number of hidden units cannot wrap around.
  const std::size_t per_unit = network.inputs.size() + 2;
  const std::size_t count = network.weights.size();
  if (network.hidden == 0 || count < 1 || (count - 1) % per_unit != 0 ||
      (count - 1) / per_unit != network.hidden) {
    node.at("weights").fail("(inputs + 2) * hidden + 1 numbers");
  }
  if (const auto skip = node.find("skip")) {
    for (const TermInfo& term : all_terms()) {
      const auto value = skip->find(std::string(term.name));
      if (!value) continue;
      network.skip.terms.push_back(term.term);
      network.skip.coefficients.push_back(value->number());
    }
  }
  return network;
}

}  // namespace proofmass
