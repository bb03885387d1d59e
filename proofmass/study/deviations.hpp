// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "proofmass/study/comparison.hpp"

namespace proofmass {

// How far the coefficients of each method's first run are from a reference, in standard errors.
struct Deviations {
  bool from_truth = false;                       // else from the first method that has standard errors
  std::string reference;                         // that method; empty where the truth is known
  std::vector<Term> terms{};                     // that some method identifies, canonical order
  std::vector<std::string> methods{};            // compared, in the order of the comparison
  std::vector<std::vector<double>> in_errors{};  // of each method: one a term; NaN where it has none
  // Half of each 95 % interval likewise, in the method's own standard errors.
  std::vector<std::vector<double>> half_widths{};
};

// From the truth: in the standard errors of each method itself, which it should know to be about one. From
// another method: in that one's. A term that the truth lacks is zero there.
[[nodiscard]] Deviations deviations(const Comparison& comparison);

// Median, quartiles and whiskers of a sample (Tukey, Exploratory Data Analysis, 1977): whiskers end at the
// last values within 1.5 times the distance of the quartiles. Quartiles as medians of the halves. Not of an
// empty sample.
struct FiveNumbers {
  double low = 0.0, lower = 0.0, median = 0.0, upper = 0.0, high = 0.0;
  std::vector<double> beyond{};
};
[[nodiscard]] FiveNumbers five_numbers(std::vector<double> values);

}  // namespace proofmass
