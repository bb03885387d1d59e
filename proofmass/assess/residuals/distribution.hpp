// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

namespace proofmass {

// How often values fall into bins of one width.
struct Histogram {
  double low = 0.0;    // of the first bin
  double width = 0.0;  // of a bin
  std::vector<std::size_t> counts;
  double mean = 0.0, sd = 0.0;         // of the values
  std::vector<double> normal_heights;  // what a normal distribution of that mean and sd expects in each bin
};

// Bins by the rule of Freedman and Diaconis (Z. Wahrscheinlichkeitstheorie 57, 1981), at most `most` of them.
// Values that are not finite are left out; empty for fewer than two, or for values that are all alike.
[[nodiscard]] Histogram histogram(std::span<const double> values, std::size_t most = 60);

// Ordered values beside those that a standard normal distribution expects at their ranks (plotting positions
// of Blom, (i - 3/8) / (n + 1/4)).
struct NormalQuantiles {
  std::vector<double> expected, observed;
};

// Of so many values, all of the 100 least and largest, and of those between at most `most`, evenly spaced by
// rank.
[[nodiscard]] NormalQuantiles normal_quantiles(std::span<const double> values, std::size_t most = 800);

}  // namespace proofmass
