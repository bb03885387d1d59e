// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <tuple>

#include "proofmass/identify/options/field.hpp"

namespace proofmass {

enum class Trainer { varpro, lm };  // variable projection; textbook Levenberg-Marquardt
inline constexpr std::array kTrainerWords{Word<Trainer>{"varpro", Trainer::varpro},
                                          Word<Trainer>{"lm", Trainer::lm}};

// What every method that trains takes.
template <typename Owner>
[[nodiscard]] constexpr auto epochs_field(std::size_t Owner::*member) {
  return field("epochs", member, "training epochs of a start, at most", whole(1),
               {.place = "bp.md#training"});
}
template <typename Owner>
[[nodiscard]] constexpr auto perturbations_field(std::size_t Owner::*member) {
  return field("perturbations", member, "perturbations in a row without gain before varpro ends", whole(0),
               {.place = "bp.md#training", .former = "kicks"});
}

// How a network is trained. Defaults of the damping are those that MATLAB documents for trainlm.
struct TrainingOptions {
  std::size_t epochs = 1000;      // at most, for the training of one start
  std::size_t perturbations = 2;  // in a row without gain before training goes on to a minimum (varpro)
  Trainer trainer = Trainer::varpro;
  double mu = 1e-3;                     // initial damping (lm)
  double mu_decrease = 0.1;             // factor after an accepted step (lm)
  double mu_increase = 10.0;            // factor after a rejected step (lm)
  double mu_max = 1e10;                 // training ends beyond this damping (lm)
  double minimum_gradient = 1e-7;       // |Jᵀe| of the scaled output that ends training (lm)
  std::size_t validation_failures = 6;  // successive epochs without improvement on the validation rows, if
                                        // there are any, that end training; the best epoch's weights are kept

  static constexpr auto fields = std::tuple{
      epochs_field(&TrainingOptions::epochs),
      perturbations_field(&TrainingOptions::perturbations),
      field("trainer", &TrainingOptions::trainer, "variable projection, or textbook Levenberg-Marquardt",
            kTrainerWords, {.place = "bp.md#training"}),
      field("mu", &TrainingOptions::mu, "initial damping of trainer lm", above(0.0),
            {.place = "bp.md#training"}),
      field("mu-decrease", &TrainingOptions::mu_decrease, "factor of the damping after an accepted step",
            above(0.0, 1.0), {.place = "bp.md#training"}),
      field("mu-increase", &TrainingOptions::mu_increase, "factor of the damping after a rejected step",
            above(1.0), {.place = "bp.md#training"}),
      field("mu-max", &TrainingOptions::mu_max, "damping that ends training by lm", above(0.0),
            {.place = "bp.md#training"}),
      field("minimum-gradient", &TrainingOptions::minimum_gradient, "gradient that ends training by lm",
            at_least(0.0), {.place = "bp.md#training"}),
      field("validation-failures", &TrainingOptions::validation_failures,
            "training stops early after N epochs in a row without a smaller validation error", whole(1),
            {.place = "bp.md#how-it-ends"})};
};

}  // namespace proofmass
