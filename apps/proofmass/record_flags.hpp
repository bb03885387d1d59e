// SPDX-License-Identifier: Apache-2.0
// How a record is to be read: the options of every verb that reads one.
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <vector>

#include "common_flags.hpp"
#include "proofmass/core/dataset.hpp"
#include "proofmass/core/progress.hpp"
#include "proofmass/core/run.hpp"
#include "proofmass/record/csv/csv.hpp"

namespace proofmass::cli {

struct RecordFlags {
  std::string path;
  std::vector<std::string> map;
  std::string encoding;
  DecimalMark decimal = DecimalMark::automatic;
  OverloadPolicy overload = OverloadPolicy::refuse;
};

// The record itself, as the positional argument `name`, and the options.
void add_record(CLI::App& verb, RecordFlags& flags, const std::string& name, const std::string& help);

// Throws a usage Error on a --map that is not NAME=COLUMN, or names a column twice.
[[nodiscard]] ReadOptions read_options(const RecordFlags& flags, const CommonFlags& common);

// The options by which a result's record was read.
[[nodiscard]] RecordFlags flags_of(const Provenance& provenance);

// Adds the options to what a result says of its making.
void add_given(Provenance& provenance, const RecordFlags& flags);

}  // namespace proofmass::cli
