// SPDX-License-Identifier: Apache-2.0
// Errors in the reader's language.
#pragma once

#include <string>

#include "proofmass/core/message.hpp"
#include "proofmass/report/text/language.hpp"

namespace proofmass {

// In English where the catalogue has no other words, as for defects of the program.
[[nodiscard]] std::string message_text(const Message& message, Language language);

}  // namespace proofmass
