// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/uncertainty/row_covariance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "proofmass/core/error.hpp"
#include "proofmass/core/message.hpp"
#include "proofmass/identify/model/term_rows.hpp"
#include "proofmass/numeric/linear/deletion_covariance.hpp"

namespace proofmass {
namespace {

// What said of the standard errors of the model before.
constexpr std::array kModelBases{Code::white_noise_assumed, Code::weighted_noise_assumed,
                                 Code::robust_errors_asymptotic, Code::independent_errors_assumed};

const std::vector<Remedy>& by_rows() {
  static const std::vector<Remedy> remedies{{"covariance", "hc3"}};
  return remedies;
}

// Those whose coefficients are a linear fit to all rows.
std::string methods_with_row_covariance() {
  std::string names;
  for (const Method& method : methods()) {
    if (info(method).training_fraction == 1.0)
      names.append(names.empty() ? "" : ", ").append(info(method).name);
  }
  return names;
}

void require_mount_labels(const Dataset& record) {
  if (record.mount.empty()) {
    throw bad_data({.file = record.source, .row = 0, .column = "mount"}, "",
                   "a column with the label of the mount in each row, for a covariance by mounts", by_rows());
  }
  const auto unlabelled = std::find(record.mount.begin(), record.mount.end(), std::string());
  if (unlabelled == record.mount.end()) return;
  const auto row = static_cast<std::size_t>(unlabelled - record.mount.begin());
  throw bad_data({.file = record.source, .row = record.line_of(row), .column = "mount"}, "",
                 "the label of a mount in each row, for a covariance by mounts", by_rows());
}

struct Groups {
  std::vector<std::size_t> of_row;  // empty: each row alone
  std::vector<std::string> names;
};

Groups groups_of(const Dataset& fitted, CovarianceKind kind) {
  Groups groups;
  if (kind != CovarianceKind::mount) return groups;
  groups.of_row.resize(fitted.rows());
  for (const std::vector<std::size_t>& members : rows_by_mount(fitted.mount)) {
    for (const std::size_t row : members) groups.of_row[row] = groups.names.size();
    groups.names.push_back(fitted.mount[members.front()]);
  }
  return groups;
}

Error undetermined(const Dataset& fitted, const Groups& groups, std::size_t which) {
  const Message left_out = groups.names.empty() ? message("line {}", fitted.line_of(which))
                                                : message("the mount '{}'", excerpt(groups.names[which]));
  std::vector<Remedy> remedies{{"covariance", "model"}, {"terms", ""}};
  if (!groups.names.empty()) remedies.insert(remedies.begin(), by_rows().front());
  return refusal(
      message("{}: without {} the other rows cannot identify these terms, so that no covariance can "
              "be had by leaving it out",
              fitted.source, left_out),
      std::move(remedies));
}

Error flat(const Dataset& fitted, CovarianceKind kind) {
  return refusal(
      message("{}: the loss is flat at so many rows of high leverage that the covariance {} cannot be "
              "had; Huber's loss, or the covariance of the model, may do",
              fitted.source, to_string(kind)),
      {{"loss", "huber"}, {"covariance", "model"}});
}

void set_standard_errors(Identification& result, const Matrix& covariance) {
  result.covariance.assign(covariance.data(), covariance.data() + covariance.rows() * covariance.rows());
  std::size_t k = 0;
  for (Coefficient& c : result.coefficients) {
    if (!c.identified) continue;
    c.standard_error = std::sqrt(std::max(covariance(k, k), 0.0));
    ++k;
  }
}

void say_so(Identification& result, CovarianceKind kind, std::size_t mounts) {
  std::vector<Finding>& findings = result.findings;
  const auto is_of_model = [](const Finding& finding) {
    return std::find(kModelBases.begin(), kModelBases.end(), finding.code) != kModelBases.end();
  };
  findings.erase(std::remove_if(findings.begin(), findings.end(), is_of_model), findings.end());
  result.covariance_kind = kind;
  if (kind == CovarianceKind::hc3) {
    findings.push_back({.code = Code::errors_by_rows});
    return;
  }
  result.diagnostics.interval_dof = mounts - 1;
  findings.push_back({.code = Code::errors_by_mounts, .figures = {{"count", mounts}, {"dof", mounts - 1}}});
}

}  // namespace

void require_covariance(const Dataset& record, const Method& method, CovarianceKind kind) {
  if (kind == CovarianceKind::model) return;
  if (info(method).training_fraction < 1.0) {
    throw usage_error(message("covariance: found '{}', but {} has the covariance model alone; {} have it",
                              to_string(kind), info(method).name, methods_with_row_covariance()));
  }
  if (kind == CovarianceKind::mount) require_mount_labels(record);
}

void use_covariance(Identification& result, const Dataset& fitted, CovarianceKind kind) {
  if (kind == CovarianceKind::model) return;
  const Groups groups = groups_of(fitted, kind);
  if (groups.names.size() == 1) throw undetermined(fitted, groups, 0);
  const StaticModel model = result.static_model();
  const TermRows rows(fitted, model.terms, axis_ranges(fitted));
  const std::vector<double> residuals = static_residuals(model, fitted);
  const DeletionCovariance found = deletion_covariance({.rows = rows,
                                                        .residuals = residuals,
                                                        .weights = result.row_weights.values,
                                                        .slopes = result.row_weights.slopes},
                                                       groups.of_row, groups.names.size());
  if (found.flat) throw flat(fitted, kind);
  if (found.undetermined) throw undetermined(fitted, groups, *found.undetermined);
  set_standard_errors(result, found.covariance);
  say_so(result, kind, groups.names.size());
}

}  // namespace proofmass
