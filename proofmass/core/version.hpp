// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace proofmass {

// The version of the library, as provenance records it: "0.1.0".
[[nodiscard]] std::string_view version() noexcept;

}  // namespace proofmass
