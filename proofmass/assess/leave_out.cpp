// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/leave_out.hpp"

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "proofmass/assess/metrics.hpp"
#include "proofmass/identify/method.hpp"
#include "proofmass/identify/model/term_rows.hpp"
#include "proofmass/numeric/linear/deletion_residuals.hpp"

namespace proofmass {
namespace {

// Mounts by number; rows without a label are none.
struct Mounts {
  std::vector<std::size_t> of_row;
  std::size_t count = 0;
  std::vector<std::size_t> unlabelled;
};

Mounts mounts_of(const std::vector<std::string>& labels) {
  Mounts mounts{.of_row = std::vector<std::size_t>(labels.size()), .count = 0, .unlabelled = {}};
  for (const std::vector<std::size_t>& members : rows_by_mount(labels)) {
    if (labels[members.front()].empty()) {
      mounts.unlabelled = members;
      continue;
    }
    for (const std::size_t row : members) mounts.of_row[row] = mounts.count;
    ++mounts.count;
  }
  for (const std::size_t row : mounts.unlabelled)
    mounts.of_row[row] = mounts.count;  // past the last: not left out
  return mounts;
}

// Over the rows that the others determine; nothing where there are none.
std::optional<Metrics> score_deleted(const Dataset& fitted, const std::vector<double>& residuals) {
  std::vector<double> measured;
  std::vector<double> predicted;
  for (std::size_t row = 0; row < residuals.size(); ++row) {
    if (std::isnan(residuals[row])) continue;
    measured.push_back(fitted.output[row]);
    predicted.push_back(fitted.output[row] - residuals[row]);
  }
  if (measured.empty()) return std::nullopt;
  return score(measured, predicted, 1.0 / fitted.output_unit.to_canonical);
}

void add_undetermined(Identification& result, Code code, std::size_t undetermined, std::size_t total) {
  if (undetermined == 0) return;
  result.findings.push_back({.code = code, .figures = {{"count", undetermined}, {"total", total}}});
}

}  // namespace

void add_leave_out_scores(Identification& result, const Dataset& fitted) {
  if (info(find_method(result.method)).training_fraction < 1.0) return;
  const StaticModel model = result.static_model();
  const TermRows rows(fitted, model.terms, axis_ranges(fitted));
  const std::vector<double> residuals = static_residuals(model, fitted);
  const std::vector<double>& weights = result.row_weights.values;

  result.findings.push_back(
      {.code = result.row_weights.fixed ? Code::left_out_exactly : Code::left_out_in_one_step});
  const DeletionResiduals by_row = deletion_residuals(rows, residuals, weights);
  result.leave_one_out = score_deleted(fitted, by_row.residuals);
  add_undetermined(result, Code::rows_not_left_out, by_row.undetermined, fitted.rows());

  const Mounts mounts = mounts_of(fitted.mount);
  if (mounts.count < 2) return;
  DeletionResiduals by_mount = deletion_residuals(rows, residuals, weights, mounts.of_row, mounts.count);
  for (const std::size_t row : mounts.unlabelled)
    by_mount.residuals[row] = std::numeric_limits<double>::quiet_NaN();
  result.leave_one_mount_out = score_deleted(fitted, by_mount.residuals);
  add_undetermined(result, Code::mounts_not_left_out, by_mount.undetermined, mounts.count);
}

}  // namespace proofmass
