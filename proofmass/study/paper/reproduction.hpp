// SPDX-License-Identifier: Apache-2.0
// What repeating the paper's experiment on a twin came to (Shi et al., Tables 1-3 and Figures 4-8).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "proofmass/core/identification.hpp"
#include "proofmass/study/comparison.hpp"

namespace proofmass {

// One size of the hidden layer trained by textbook BP.
struct HiddenSizeScore {
  std::size_t hidden = 0;
  std::vector<double> training_mse;  // of each repeat, in the output's declared unit squared
};

// How much less test error PSO-BP leaves than BP on twins of one noise.
struct SwarmGain {
  double sigma = 0.0;  // g, of the noise simulated
  std::string preset;  // of PSO-BP
  // Test MSE of each seed, in the output's declared unit squared, and the mean of their iterations (as in
  // Diagnostics): epochs of training, and evaluations of a swarm that trains nothing.
  std::vector<double> bp_mse, swarm_mse;
  double bp_iterations = 0.0;
  double swarm_iterations = 0.0;
  // Geometric mean over the seeds of BP's MSE over the swarm's.
  [[nodiscard]] double ratio() const;
};

struct Reproduction {
  std::string twin;  // name of the plan
  std::size_t rows = 0;
  std::uint64_t seed = 0;
  double sigma = 0.0;                  // g, of the twin's noise
  double noise_mse = 0.0;              // in the declared unit squared
  StaticModel truth;                   // of the twin, in g per g^order
  std::string unit;                    // of every MSE (squared), curve and output: the declared one
  std::vector<HiddenSizeScore> sizes;  // Table 1
  Comparison coefficients;             // Table 2
  Comparison networks;                 // Table 3
  double search_iterations = 0.0;      // BP: the sizes of Table 1, one repeat, and the final training
  double swarm_iterations = 0.0;       // PSO-BP: the fitness evaluations and the final training
  std::vector<SwarmGain> gains;
  std::vector<Curve> bp_training, swarm_training;  // Figures 4 and 5: RMSE by epoch
  std::vector<Curve> swarm;                        // Figure 6: fitness by iteration
  std::vector<double> measured;                    // Figures 7 and 8: output of the test rows
  std::vector<Curve> predicted;                    // and what the networks say
};

// Variance of the test outputs that MSE and R² of the first repeat imply, MSE / (1 - R²), in the declared
// unit squared: the same for all that are scored on the same rows.
[[nodiscard]] std::optional<double> implied_variance(const Contestant& contestant);

}  // namespace proofmass
