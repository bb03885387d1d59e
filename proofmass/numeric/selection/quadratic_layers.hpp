// SPDX-License-Identifier: Apache-2.0
// A multilayer network of quadratic polynomials in two inputs each, grown layer by layer (Ivakhnenko,
// Automatica 6, 1970). It keeps the polynomial that it is equal to.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "proofmass/numeric/optimise/termination.hpp"
#include "proofmass/numeric/selection/polynomial_jet.hpp"
#include "proofmass/numeric/selection/subset_criterion.hpp"

namespace proofmass {

// An input, or a neuron's output.
struct PolynomialNode {
  std::vector<double> values;  // one per row
  PolynomialJet jet;           // the same as a polynomial in the variables of the inputs
};

// Returns the external criterion of a regression over all its rows; ranks the neurons.
using CriterionMaker =
    std::function<std::unique_ptr<SubsetCriterion>(const Matrix& design, std::span<const double> y)>;

struct QuadraticLayerSettings {
  std::size_t layers = 8;             // at most
  std::size_t survivors = 10;         // best neurons of a layer that feed the next
  bool inputs_in_every_layer = true;  // besides the survivors; otherwise the inputs feed only the first
  double improvement = 0.01;  // ends when a layer lowers the root of the criterion by less than this fraction
};

struct QuadraticLayers {
  PolynomialNode best;                 // the neuron with the least criterion in the layer with the least
  double value = 0.0;                  // its criterion
  std::size_t layer = 0;               // its layer, from 1; 0 when no neuron could be fitted
  std::vector<double> value_of_layer;  // the least criterion of each layer grown
  std::size_t neurons = 0;             // neurons fitted in total
  std::size_t discarded = 0;           // pairs whose six regressors the rows cannot separate
  Termination termination;
};

// Called after each layer; returns false to stop.
using LayerObserver = std::function<bool(std::size_t layer, double least)>;

// Grows z = c0 + c1 u + c2 v + c3 u v + c4 u² + c5 v² over all pairs of nodes, with coefficients by least
// squares over the `fitting` rows (all when empty), and keeps the best by the criterion. Inside a neuron, u
// is standardised and v is replaced by its standardised residual from a linear function of u. This spans the
// same functions without cancellation when u and v are nearly equal. No ridge, no rounding of coefficients.
[[nodiscard]] QuadraticLayers grow_quadratic_layers(const std::vector<PolynomialNode>& inputs,
                                                    std::span<const double> y,
                                                    std::span<const std::size_t> fitting,
                                                    const CriterionMaker& criterion,
                                                    const QuadraticLayerSettings& settings,
                                                    const LayerObserver& observer = {});

}  // namespace proofmass
