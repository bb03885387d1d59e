// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "proofmass/core/message.hpp"

namespace proofmass {

// The name that a mistyped word stands for: the one with the fewest letters inserted, deleted, changed or
// exchanged with their neighbour, case aside, at most one in three letters. Empty when none is so near.
[[nodiscard]] std::string nearest_name(std::string_view word, std::span<const std::string_view> names);

// "; did you mean NAME?", or nothing.
[[nodiscard]] Message did_you_mean(std::string_view word, std::span<const std::string_view> names);

}  // namespace proofmass
