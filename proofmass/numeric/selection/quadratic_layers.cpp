// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/selection/quadratic_layers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "proofmass/numeric/linear/least_squares.hpp"
#include "proofmass/numeric/linear/rank_analysis.hpp"
#include "proofmass/numeric/parallel.hpp"

namespace proofmass {
namespace {

constexpr std::size_t kRegressors = 6;
constexpr Subset kAllRegressors = (Subset{1} << kRegressors) - 1;
// When the residual of v from a linear function of u is below this fraction of v, it is rounding.
constexpr double kSame = 1e-10;

double mean(std::span<const double> values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double root_mean_square(std::span<const double> values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

// node * factor + shift.
PolynomialNode affine(const PolynomialNode& node, double factor, double shift) {
  PolynomialNode result{.values = node.values, .jet = PolynomialJet::constant(shift)};
  for (double& value : result.values) value = value * factor + shift;
  result.jet.add(factor, node.jet);
  return result;
}

std::optional<PolynomialNode> standardised(const PolynomialNode& node, double size) {
  const double centre = mean(node.values);
  PolynomialNode result = affine(node, 1.0, -centre);
  const double spread = root_mean_square(result.values);
  if (!(spread > kSame * size)) return std::nullopt;
  return affine(result, 1.0 / spread, 0.0);
}

// The residual of `node` from a linear function of `other`, which is standardised.
std::optional<PolynomialNode> beyond(const PolynomialNode& node, const PolynomialNode& other) {
  const double size = root_mean_square(node.values);
  std::optional<PolynomialNode> result = standardised(node, size);
  for (int pass = 0; pass < 2 && result; ++pass) {  // twice is enough (Parlett & Kahan)
    double slope = 0.0;
    for (std::size_t r = 0; r < other.values.size(); ++r) slope += other.values[r] * result->values[r];
    slope /= static_cast<double>(other.values.size());
    for (std::size_t r = 0; r < other.values.size(); ++r) result->values[r] -= slope * other.values[r];
    result->jet.add(-slope, other.jet);
    result = standardised(*result, 1.0);
  }
  return result;
}

Matrix regressors(const PolynomialNode& u, const PolynomialNode& v) {
  Matrix design(u.values.size(), kRegressors);
  for (std::size_t r = 0; r < u.values.size(); ++r) {
    const double a = u.values[r];
    const double b = v.values[r];
    const std::array<double, kRegressors> row{1.0, a, b, a * b, a * a, b * b};
    for (std::size_t c = 0; c < kRegressors; ++c) design(r, c) = row[c];
  }
  return design;
}

PolynomialJet combined(const PolynomialNode& u, const PolynomialNode& v, std::span<const double> c) {
  PolynomialJet jet = PolynomialJet::constant(c[0]);
  jet.add(c[1], u.jet);
  jet.add(c[2], v.jet);
  jet.add(c[3], u.jet * v.jet);
  jet.add(c[4], u.jet * u.jet);
  jet.add(c[5], v.jet * v.jet);
  return jet;
}

LeastSquaresFit fit_rows(const Matrix& design, std::span<const double> y, std::span<const std::size_t> rows) {
  if (rows.empty()) return solve_least_squares(design, y);
  Matrix part(rows.size(), kRegressors);
  std::vector<double> target(rows.size());
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (std::size_t c = 0; c < kRegressors; ++c) part(r, c) = design(rows[r], c);
    target[r] = y[rows[r]];
  }
  if (analyse_rank(part).rank < kRegressors) return {};
  return solve_least_squares(part, target);
}

struct Neuron {
  double value = std::numeric_limits<double>::infinity();
  PolynomialNode output;
};

std::optional<Neuron> fit_neuron(const PolynomialNode& first, const PolynomialNode& second,
                                 std::span<const double> y, std::span<const std::size_t> fitting,
                                 const CriterionMaker& criterion) {
  const std::optional<PolynomialNode> u = standardised(first, root_mean_square(first.values));
  if (!u) return std::nullopt;
  const std::optional<PolynomialNode> v = beyond(second, *u);
  if (!v) return std::nullopt;
  const Matrix design = regressors(*u, *v);
  if (analyse_rank(design).rank < kRegressors) return std::nullopt;
  const std::vector<double> c = fit_rows(design, y, fitting).coefficients;
  if (c.empty()) return std::nullopt;
  Neuron neuron{.value = criterion(design, y)->value(kAllRegressors),
                .output = {.values = std::vector<double>(y.size()), .jet = combined(*u, *v, c)}};
  if (!std::isfinite(neuron.value)) return std::nullopt;
  for (std::size_t r = 0; r < y.size(); ++r) {
    for (std::size_t k = 0; k < kRegressors; ++k) neuron.output.values[r] += c[k] * design(r, k);
  }
  return neuron;
}

std::vector<Neuron> grow_layer(const std::vector<PolynomialNode>& pool, std::span<const double> y,
                               std::span<const std::size_t> fitting, const CriterionMaker& criterion) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t a = 0; a < pool.size(); ++a) {
    for (std::size_t b = a + 1; b < pool.size(); ++b) pairs.emplace_back(a, b);
  }
  std::vector<std::optional<Neuron>> fitted(pairs.size());
  parallel_for(pairs.size(), [&](std::size_t k) {
    fitted[k] = fit_neuron(pool[pairs[k].first], pool[pairs[k].second], y, fitting, criterion);
  });
  std::vector<Neuron> neurons;
  for (auto& neuron : fitted) {
    if (neuron) neurons.push_back(std::move(*neuron));
  }
  std::stable_sort(neurons.begin(), neurons.end(),
                   [](const Neuron& a, const Neuron& b) { return a.value < b.value; });
  return neurons;
}

std::vector<PolynomialNode> next_pool(const std::vector<PolynomialNode>& inputs, std::vector<Neuron> neurons,
                                      const QuadraticLayerSettings& settings) {
  std::vector<PolynomialNode> pool;
  if (settings.inputs_in_every_layer) pool = inputs;
  neurons.resize(std::min(neurons.size(), settings.survivors));
  for (Neuron& neuron : neurons) pool.push_back(std::move(neuron.output));
  return pool;
}

// Whether another layer should be grown; if not, the reason.
bool improves(const QuadraticLayers& result, double before, double improvement, Termination& termination) {
  const double least = result.value_of_layer.back();
  if (std::sqrt(least) < (1.0 - improvement) * std::sqrt(before)) return true;
  termination = ended(Cause::converged, Event::layers_stalled,
                      {{"layer", result.value_of_layer.size()},
                       {"before", std::sqrt(before)},
                       {"after", std::sqrt(least)},
                       {"percent", 100.0 * improvement}});
  return false;
}

}  // namespace

QuadraticLayers grow_quadratic_layers(const std::vector<PolynomialNode>& inputs, std::span<const double> y,
                                      std::span<const std::size_t> fitting, const CriterionMaker& criterion,
                                      const QuadraticLayerSettings& settings, const LayerObserver& observer) {
  QuadraticLayers result;
  result.value = std::numeric_limits<double>::infinity();
  result.termination = ended(Cause::iteration_limit, Event::layers_spent, {{"layers", settings.layers}});
  std::vector<PolynomialNode> pool = inputs;
  for (std::size_t layer = 1; layer <= settings.layers; ++layer) {
    std::vector<Neuron> neurons = grow_layer(pool, y, fitting, criterion);
    const std::size_t pairs = pool.size() * (pool.size() - 1) / 2;
    result.neurons += neurons.size();
    result.discarded += pairs - neurons.size();
    if (neurons.empty()) {
      result.termination = ended(Cause::stalled, Event::layers_without_pair, {{"layer", layer}});
      break;
    }
    const double before = result.value;
    result.value_of_layer.push_back(neurons.front().value);
    if (neurons.front().value < before) {
      result.value = neurons.front().value;
      result.layer = layer;
      result.best = neurons.front().output;
    }
    if (!improves(result, before, settings.improvement, result.termination)) break;
    if (observer && !observer(layer, result.value)) {
      result.termination = ended(Cause::stopped, Event::stopped_by_observer);
      break;
    }
    pool = next_pool(inputs, std::move(neurons), settings);
  }
  return result;
}

}  // namespace proofmass
