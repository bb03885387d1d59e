// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/progress.hpp"
#include "proofmass/core/run.hpp"
#include "proofmass/identify/method.hpp"

namespace proofmass {

// Identifies the static model of the accelerometer that a record is of: splits the rows, fits the training
// rows by the method, adds intervals, and scores the fit on every part. Throws what the method throws, bad
// data on values that no accelerometer has or sigma columns that the method cannot go by, a usage Error on
// options that make no sense.
[[nodiscard]] Run identify(const Dataset& record, const Method& method, const IdentifyOptions& options = {});
[[nodiscard]] Run identify(const Dataset& record, const Method& method, const IdentifyOptions& options,
                           Progress& progress);

// The parts that the rows of a record had when a result was made from it, by the result's options: a result
// file does not keep them. Throws bad data where the record and the options cannot have made the result.
[[nodiscard]] Split split_again(const Dataset& record, const Run& result);

// Throws bad data where the result does not have the training error that its coefficients or network have on
// these rows of the record: one of them was changed.
void require_own_scores(const Dataset& record, const Split& split, const Run& result);

}  // namespace proofmass
