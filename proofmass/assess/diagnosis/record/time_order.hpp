// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/finding.hpp"

namespace proofmass {

// Says when the column t runs backwards, or stands still in rows of a record whose time otherwise goes on
// from row to row, or in all of them. A clock that several rows share a reading of throughout is no disorder.
[[nodiscard]] std::optional<Finding> find_time_disorder(const Dataset& record);

}  // namespace proofmass
