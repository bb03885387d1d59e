// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/error.hpp"
#include "proofmass/core/finding.hpp"
#include "proofmass/core/term.hpp"
#include "proofmass/identify/model/term_sums.hpp"
#include "proofmass/identify/options/identify_options.hpp"

namespace proofmass {

struct Identifiability {
  TermList identified;  // a largest separable subset of the terms asked for; lower-order terms are kept first
  // Why each other term is not: the first of the finding's terms, in canonical order. The identified terms
  // that it is a combination of over the rows, if there are any, follow it.
  std::vector<Finding> unidentified;
  double condition_raw = 0.0, condition_scaled = 0.0;  // of the identified terms' design matrix
};

// Which of the terms the record's inputs can tell apart, beyond what rounding and the uncertainties of the
// inputs do: a combination that the rows determine badly counts as identified, and its standard errors say
// how badly. The outputs play no part.
[[nodiscard]] Identifiability analyse_identifiability(const Dataset& data, const TermList& terms);

// The same without another look at the rows, for some of the terms summed. `input_sigma`: standard
// uncertainty of every input, in g, in place of the record's own.
[[nodiscard]] Identifiability analyse_identifiability(const TermSums& sums, const TermList& terms,
                                                      std::optional<double> input_sigma = {});

// The terms to fit. Throws a bad-data Error when the record has fewer rows than terms + 1 (saying how many
// are needed) or a constant output; a refusal that names every unidentifiable term, and has its finding, when
// there are some and the policy is refuse, or when no term is left; a usage Error when `terms` is empty.
[[nodiscard]] Identifiability require_identifiable(const Dataset& data, const TermList& terms,
                                                   RankLossPolicy policy,
                                                   std::optional<double> input_sigma = {});

// The same for the terms summed, which the caller then fits from the same sums.
[[nodiscard]] Identifiability require_identifiable(const TermSums& sums, RankLossPolicy policy,
                                                   std::optional<double> input_sigma = {});

// What to ask for where only these terms are identified; nothing where none is.
[[nodiscard]] std::vector<Remedy> terms_remedies(const TermList& identified);

// In the canonical order of each finding's first term.
void sort_by_term(std::vector<Finding>& findings);

// Throws bad data, naming the row, when an acceleration or output is so large that products with it leave the
// range of double precision.
void require_plausible_rows(const Dataset& record);

// The same of the largest, and when they are so small that their products do.
void require_plausible_sizes(const TermSums& sums);

}  // namespace proofmass
