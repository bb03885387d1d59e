// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/identification.hpp"
#include "proofmass/core/progress.hpp"
#include "proofmass/identify/method.hpp"
#include "proofmass/split.hpp"

namespace proofmass {

// The split that a method gets: only networks stop early, others train on the validation rows too.
[[nodiscard]] SplitOptions split_for(const Method& method, SplitOptions options) noexcept;

// The paper's PSO-BP: apply_paper_preset of identify/presets.hpp, and early stopping.
void apply_paper_preset(IdentifyOptions& options, SplitOptions& split);

// Checks the sigma columns that the method goes by, splits the record by split_for, seeks the number of
// hidden units on the training share when asked to, identifies on the training rows, and assesses on every
// part.
[[nodiscard]] Identification run(const Dataset& record, const Method& method, const IdentifyOptions& options,
                                 const SplitOptions& split_options, Progress& progress);

}  // namespace proofmass
