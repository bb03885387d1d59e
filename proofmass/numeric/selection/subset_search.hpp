// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "proofmass/numeric/selection/subset_criterion.hpp"

namespace proofmass {

struct SubsetSearchSettings {
  std::size_t beam = 8;          // subsets of each size that the stepwise search keeps
  std::size_t models = 100'000;  // values the exhaustive search may compute; 0: stepwise search only
  double tolerance = 0.0;        // the smallest subset within (1 + tolerance) times the least value is chosen
  double floor = 0.0;            // smaller values are rounding and count as this
};

struct SubsetSearchResult {
  Subset best = 0;
  double value = 0.0;                 // its value
  double least = 0.0;                 // the least value of any subset
  std::vector<double> value_of_size;  // the least found of subsets with 1, 2, … columns
  std::size_t evaluations = 0;        // values computed
  bool proven = false;                // whether every subset has been computed or ruled out by its bound
};

// Called at intervals with the number of values computed; returns false to stop.
using SubsetSearchObserver = std::function<bool(std::size_t evaluations)>;

// The nonempty subset of columns with the least value; among equal ones the one with fewer columns. A
// stepwise search comes first: backwards from all columns, dropping one at a time from the best few subsets
// of each size. A depth-first search through all subsets follows. It skips subsets whose superset's bound is
// already above the best value (branch and bound; Furnival & Wilson, Technometrics 16, 1974).
[[nodiscard]] SubsetSearchResult search_subsets(const SubsetCriterion& criterion,
                                                const SubsetSearchSettings& settings,
                                                const SubsetSearchObserver& observer = {});

}  // namespace proofmass
