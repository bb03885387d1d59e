// SPDX-License-Identifier: Apache-2.0
#include "proofmass/core/version.hpp"

namespace proofmass {

std::string_view version() noexcept { return PROOFMASS_VERSION; }

}  // namespace proofmass
