// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/fit/unlike_rows.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace proofmass {
namespace {

constexpr double kUnlike = 3.0;
constexpr double kUnlikelyRatio = 1e-6;
constexpr double kRoundingOfOutput = 1e-9;  // of the largest output

// By how much the uncertainty of a fit of so many parameters raises the mean square error on rows like its
// own: n + p over n.
double prediction_variance_factor(const Identification& result) {
  const auto n = static_cast<double>(result.train->n);
  const auto dof = static_cast<double>(result.diagnostics.dof.value_or(result.train->n));
  return 1.0 + std::max(0.0, n - dof) / n;
}

}  // namespace

std::optional<Finding> find_unlike_rows(const FittedRows& rows, const Dataset& record, const Split& split,
                                        const Identification& result) {
  if (!result.train || !result.test || rows.dof() == 0) return std::nullopt;
  const auto n = static_cast<double>(result.train->n);
  const auto dof = static_cast<double>(result.diagnostics.dof.value_or(rows.dof()));
  if (!(dof > 0.0)) return std::nullopt;
  const double expected = result.train->mse * n / dof * prediction_variance_factor(result);
  const double ratio = result.test->mse / expected;
  if (!(ratio > kUnlike * kUnlike)) return std::nullopt;
  if (fisher_probability(ratio, static_cast<double>(result.test->n), dof) > kUnlikelyRatio)
    return std::nullopt;
  double largest = 0.0;
  for (const std::size_t row : split.test) largest = std::max(largest, std::abs(record.output[row]));
  if (result.test->rmse * record.output_unit.to_canonical <= kRoundingOfOutput * largest) return std::nullopt;
  return Finding{.code = Code::test_error_larger,
                 .severity = Severity::warning,
                 .figures = {{"test", result.test->rmse},
                             {"train", result.train->rmse},
                             {"ratio", result.test->rmse / result.train->rmse},
                             {"unit", record.output_unit.symbol}}};
}

}  // namespace proofmass
