// SPDX-License-Identifier: Apache-2.0
// Names that the program itself gives, in every language; others, such as a method's, stay as they are.
#pragma once

#include <string>

#include "proofmass/report/text/language.hpp"

namespace proofmass {

// Of a curve of a history: "train", "swarm_best".
[[nodiscard]] Text curve_name(const std::string& curve);

// Of what the reproduction compares: "LSM, 8 terms", "PSO-BP, ours".
[[nodiscard]] Text entry_name(const std::string& entry);

}  // namespace proofmass
