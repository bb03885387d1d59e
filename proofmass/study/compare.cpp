// SPDX-License-Identifier: Apache-2.0
#include "proofmass/study/compare.hpp"

#include <algorithm>
#include <utility>

#include "proofmass/assess/diagnosis/diagnosis.hpp"
#include "proofmass/core/error.hpp"

namespace proofmass {
namespace {

// All methods of a comparison set rows aside to test on.
double fraction_of(const Entry& entry) { return entry.options.split.value_or(kTrainingFraction); }

Contestant contest(const Dataset& record, std::span<const Finding> said, const Entry& entry,
                   std::size_t repeats, Progress& progress) {
  Contestant contestant;
  contestant.method = entry.name;
  IdentifyOptions options = entry.options;
  options.split = fraction_of(entry);
  for (std::size_t r = 0; r < repeats; ++r, ++options.seed) {
    contestant.runs.push_back(identify(record, entry.method, options, progress));
    // What was found in the record is said once, not of each run.
    std::erase_if(contestant.runs.back().identification.findings, [&](const Finding& finding) {
      return std::find(said.begin(), said.end(), finding) != said.end();
    });
    contestant.seconds.push_back(contestant.runs.back().seconds);
  }
  summarise(contestant);
  return contestant;
}

}  // namespace

Comparison compare(const Dataset& record, std::span<const Entry> entries, std::size_t repeats,
                   Progress& progress) {
  Comparison comparison;
  comparison.input = record.source;
  comparison.repeats = repeats;
  comparison.findings = record.findings;
  const std::vector<Finding> found = diagnose_record(record);
  comparison.findings.insert(comparison.findings.end(), found.begin(), found.end());
  for (const Entry& entry : entries) {
    comparison.seed = entry.options.seed;
    comparison.training_fraction = fraction_of(entry);
    try {
      comparison.contestants.push_back(contest(record, comparison.findings, entry, repeats, progress));
    } catch (const Error& error) {
      const std::string_view what = error.what();
      const Message named = what.starts_with(entry.name + " ")
                                ? error.message()
                                : message("{}: {}", entry.name, error.message());
      throw Error(error.kind(), named, error.remedies(), error.findings());
    }
  }
  return comparison;
}

}  // namespace proofmass
