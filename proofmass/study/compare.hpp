// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/progress.hpp"
#include "proofmass/identify/method.hpp"
#include "proofmass/pipeline.hpp"
#include "proofmass/study/comparison.hpp"

namespace proofmass {

// One entry of a comparison: a name to show and what to run.
struct Entry {
  std::string name;
  Method method;
  IdentifyOptions options;
};

// Runs every entry on the record `repeats` times, repeat r with the seed of its options plus r for split and
// draws alike, and summarises. Throws what an entry throws, its name in front.
[[nodiscard]] Comparison compare(const Dataset& record, std::span<const Entry> entries, std::size_t repeats,
                                 Progress& progress);

}  // namespace proofmass
