// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <tuple>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/identification.hpp"
#include "proofmass/core/progress.hpp"
#include "proofmass/identify/options/field.hpp"
#include "proofmass/identify/options/identify_options.hpp"
#include "proofmass/identify/options/method_info.hpp"
#include "proofmass/identify/regression/uncertainty_options.hpp"

namespace proofmass {

// Where weights come from: the record's sigma_E if it has one, else a model; that column; that model.
enum class WeightSource { automatic, sigma, model };
inline constexpr std::array kWeightWords{Word<WeightSource>{"auto", WeightSource::automatic},
                                         Word<WeightSource>{"sigma", WeightSource::sigma},
                                         Word<WeightSource>{"model", WeightSource::model}};

// Weighted least squares on the terms asked for (docs/wls.md). Weights are 1 / sigma_E² when the record has
// that column, otherwise those of the model sigma² = s0² + s1² |A|² fitted to the residuals by restricted
// maximum likelihood; the findings say which, with the figures.
struct Wls {
  WeightSource weights = WeightSource::automatic;
  ChiSquareScaling scaling = ChiSquareScaling::given;  // with weights from sigma_E only
  std::size_t iterations = 50;  // of estimating the variance model and refitting, at most

  // Those of the record that a fit goes by.
  [[nodiscard]] SigmaColumns sigma_columns() const noexcept;

  static constexpr MethodInfo info{
      .name = "wls",
      .summary = "least squares weighted by sigma_E, or by noise found to grow with |A|",
      .page = "wls.md",
      .training_fraction = 1.0};
  static constexpr auto fields = std::tuple{
      field("weights", &Wls::weights,
            "weights by sigma_E when there is one, by sigma_E, or by a model of noise that grows with |A|",
            kWeightWords, {.place = "wls.md#where-the-weights-come-from"}),
      field("sigma-scale", &Wls::scaling, "standard errors by the sigmas as given, or scaled by chi2/dof",
            kScalingWords, {.place = "wls.md#standard-errors"}),
      field("wls-iterations", &Wls::iterations, "iterations of the variance model, at most", whole(1),
            {.place = "wls.md#how-it-is-solved"})};
};

// Errors as fit in identify/method.hpp says, and bad data when sigma_E is asked for and missing, or is not
// above zero in every row.
[[nodiscard]] Identification fit(const Wls& method, const Dataset& training, const IdentifyOptions& options,
                                 Progress& progress);

}  // namespace proofmass
