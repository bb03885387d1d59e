// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace proofmass {

// Text for XML and HTML, between tags and in quoted attributes: "&", "<", ">" and quotes as entities. Control
// characters and bytes that are no UTF-8, which XML forbids, become U+FFFD.
[[nodiscard]] std::string xml_escaped(std::string_view text);

}  // namespace proofmass
