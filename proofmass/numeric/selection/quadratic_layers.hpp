// SPDX-License-Identifier: Apache-2.0
// A multilayer network of quadratic polynomials in two inputs each, grown layer by layer (Ivakhnenko,
// Automatica 6, 1970), that keeps the polynomial it amounts to.
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
  std::vector<double> values;  // one a row
  PolynomialJet jet;           // the same as a polynomial in the variables that the inputs are made of
};

// The external criterion of a regression given all its rows, for the neurons to be ranked by.
using CriterionMaker =
    std::function<std::unique_ptr<SubsetCriterion>(const Matrix& design, std::span<const double> y)>;

struct QuadraticLayerSettings {
  std::size_t layers = 8;             // at most
  std::size_t survivors = 10;         // best neurons of a layer that feed the next
  bool inputs_in_every_layer = true;  // the inputs feed every layer beside the survivors, or the first alone
  double improvement = 0.01;  // ends when the root of the criterion falls by less than this share in a layer
};

struct QuadraticLayers {
  PolynomialNode best;                 // the neuron with the least criterion in the layer with the least
  double value = 0.0;                  // its criterion
  std::size_t layer = 0;               // its layer, from 1; 0 when no neuron could be fitted
  std::vector<double> value_of_layer;  // the least criterion of each layer grown
  std::size_t neurons = 0;             // fitted in all
  std::size_t discarded = 0;           // pairs whose six regressors the rows cannot tell apart
  Termination termination;
};

// Called after each layer; returns false to stop.
using LayerObserver = std::function<bool(std::size_t layer, double least)>;

// Grows z = c0 + c1 u + c2 v + c3 u v + c4 u² + c5 v² over all pairs of nodes, the coefficients by least
// squares over `fitting` rows (all when empty), and keeps the best by the criterion. Inside a neuron u and v
// are replaced by u standardised and by what v has beyond a linear function of u, standardised: the same
// functions, without the cancellation when u and v are nearly alike. No ridge, no rounding of coefficients.
[[nodiscard]] QuadraticLayers grow_quadratic_layers(const std::vector<PolynomialNode>& inputs,
                                                    std::span<const double> y,
                                                    std::span<const std::size_t> fitting,
                                                    const CriterionMaker& criterion,
                                                    const QuadraticLayerSettings& settings,
                                                    const LayerObserver& observer = {});

}  // namespace proofmass
