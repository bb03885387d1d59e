// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace proofmass {

extern const char* const kPaperTwin;  // text of data/twin-300ug.toml; made by CMake

}  // namespace proofmass
