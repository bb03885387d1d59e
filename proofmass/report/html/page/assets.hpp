// SPDX-License-Identifier: Apache-2.0
// Files that the library carries for its reports (assets/, and plotly.js where it was built with it).
#pragma once

#include <string_view>

namespace proofmass::html {

[[nodiscard]] std::string_view page_style();   // page.css
[[nodiscard]] std::string_view page_script();  // upgrade.js

// plotly.js, compressed by gzip and written in base64, with its licence; empty in a build without it.
[[nodiscard]] std::string_view plotting_library();
[[nodiscard]] std::string_view plotting_licence();

}  // namespace proofmass::html
