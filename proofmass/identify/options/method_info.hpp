// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace proofmass {

// Fraction of the rows to train on where some are set aside to test on, when no fraction is asked for.
inline constexpr double kTrainingFraction = 0.7;

// What is said of a method wherever methods are listed.
struct MethodInfo {
  std::string_view name;                         // as --method takes it
  std::string_view summary;                      // one line, for --help
  std::string_view page;                         // of the documentation
  bool predicts_by_network = false;              // the fit predicts by its network, not by the coefficients
  double training_fraction = kTrainingFraction;  // of the rows when none is asked for; 1 fits all
  bool exact_without_noise = true;  // recovers the coefficients of a noise-free record to rounding
};

}  // namespace proofmass
