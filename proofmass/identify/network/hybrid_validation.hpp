// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/progress.hpp"
#include "proofmass/identify/network/hybrid.hpp"

namespace proofmass {

// Errors at rows left out of the fit, with a network beside the terms and without.
struct HybridValidation {
  std::size_t rows = 0;         // left out, all folds together; 0 when no fold could be fitted
  double rmse_with = 0.0;       // canonical output unit
  double rmse_without = 0.0;    // likewise
  double gain = 0.0;            // mean over the rows of squared error without less squared error with
  double standard_error = 0.0;  // of that mean
  std::size_t epochs = 0;
  std::size_t evaluations = 0;  // of the swarms' fitness
  // Whether the network predicts better by more than one standard error.
  [[nodiscard]] bool favours_network() const noexcept { return gain > standard_error; }
};

// Fivefold cross-validation (Stone 1974) of `hidden` units against none; row r of the training rows is left
// out in fold r mod 5. Folds whose rows no longer tell the terms apart are passed over.
[[nodiscard]] HybridValidation validate_hybrid(const Hybrid& method, const Dataset& training,
                                               const TermList& terms, std::size_t hidden, std::uint64_t seed,
                                               Progress& progress);

}  // namespace proofmass
