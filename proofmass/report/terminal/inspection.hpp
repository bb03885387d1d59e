// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "proofmass/assess/inspection.hpp"
#include "proofmass/report/terminal/terminal.hpp"

namespace proofmass {

// What a record holds: rows, ranges and units of its columns, mounts, and which terms its inputs can
// identify.
[[nodiscard]] std::string render_inspection(const Inspection& inspection, const TerminalStyle& style = {});

}  // namespace proofmass
