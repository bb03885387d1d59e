// SPDX-License-Identifier: Apache-2.0
// What was measured and how it was read, as every report says it.
#pragma once

#include <string>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/run.hpp"
#include "proofmass/report/html/page/html.hpp"

namespace proofmass::html {

// The record, its hash, how many rows went where, units and ranges. `record`: null where it is not at hand.
void add_record(Definitions& about, const Run& run, const Dataset* record = nullptr);

// Seed, version and the report's date; the date is left out when it is empty.
void add_origin(Definitions& about, const Run& run, const std::string& date);

// What reading the record skipped, converted and assumed.
[[nodiscard]] std::string reading_part(const Provenance& provenance);

// The resolved options; empty without any.
[[nodiscard]] std::string options_table(const Provenance& provenance, const Text& caption);

}  // namespace proofmass::html
