// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/fit/likely_reason.hpp"

#include "proofmass/assess/diagnosis/record/term_space.hpp"
#include "proofmass/assess/diagnosis/record/unexplained.hpp"
#include "proofmass/assess/diagnosis/units/mixed_units.hpp"

namespace proofmass {
std::string likely_reason(const FittedRows& rows, double unexplained) {
  const Dataset& record = rows.record();
  if (!rows_in_other_unit(record).empty()) return "mixed";
  if (unexplained_by(orthonormal_rows(record, full_terms()), record.output) < unexplained) return "terms";
  if (unexplained_without_far_rows(record) < unexplained) return "rows";
  return {};
}

}  // namespace proofmass
