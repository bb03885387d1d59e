// SPDX-License-Identifier: Apache-2.0
// Errors of rows, and of mounts, as fits without them have them: against fits that are made again.
#include "proofmass/assess/leave_out.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "proofmass/numeric/random.hpp"
#include "proofmass/pipeline.hpp"
#include "support/findings.hpp"
#include "support/twin.hpp"

namespace proofmass {
namespace {

// 40 rows of six unequal mounts, whose uncertainties differ by a factor of ten and are right.
Dataset uneven_record(std::uint64_t seed) {
  Dataset record = test::make_twin({.rows = 40, .noise = 0.0, .seed = seed});
  RandomStream random(seed, stream_id("uneven record"));
  for (std::vector<double>& sigma : record.acceleration_sigma) sigma.assign(record.rows(), 1e-5);
  for (std::size_t row = 0; row < record.rows(); ++row) {
    const double sigma = 1e-4 * std::pow(10.0, random.uniform());
    record.output_sigma.push_back(sigma);
    record.output[row] += sigma * random.normal();
    for (std::vector<double>& axis : record.acceleration) axis[row] += 1e-5 * random.normal();
    record.mount.push_back("P" + std::to_string(random.index(10) / 2));
  }
  return record;
}

constexpr std::array kTerms{Term::K0, Term::Ki, Term::Kii, Term::Kiii, Term::Ko, Term::Kp};

Run fitted(const Dataset& record, const Method& method) {
  return identify(record, method, {.terms = {kTerms.begin(), kTerms.end()}});
}

// The root mean square error of each group of rows as predicted by a fit to the others.
double error_of_refits(const Dataset& record, const Method& method,
                       const std::vector<std::vector<std::size_t>>& groups) {
  double squares = 0.0;
  for (const std::vector<std::size_t>& group : groups) {
    std::vector<std::size_t> others;
    for (std::size_t row = 0; row < record.rows(); ++row) {
      if (std::find(group.begin(), group.end(), row) == group.end()) others.push_back(row);
    }
    const Identification result = fitted(record.select(others), method).identification;
    const Dataset left_out = record.select(group);
    const std::vector<double> predicted = predict(result, left_out);
    for (std::size_t row = 0; row < group.size(); ++row)
      squares += std::pow(left_out.output[row] - predicted[row], 2);
  }
  return std::sqrt(squares / static_cast<double>(record.rows()));
}

std::vector<std::vector<std::size_t>> each_row(std::size_t rows) {
  std::vector<std::vector<std::size_t>> groups(rows);
  for (std::size_t row = 0; row < rows; ++row) groups[row] = {row};
  return groups;
}

struct Promise {
  Method method;
  double tolerance;  // of the error, relative
};

TEST(LeaveOut, GivesWhatFitsWithoutTheRowsGive) {
  for (const auto& [method, tolerance] : {Promise{Ols{}, 1e-9}, Promise{Wls{}, 1e-9}, Promise{Tls{}, 1e-3},
                                          Promise{Eiv{}, 1e-2}, Promise{Robust{}, 0.1}}) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
      const Dataset record = uneven_record(seed);
      const Identification result = fitted(record, method).identification;
      ASSERT_TRUE(result.leave_one_out && result.leave_one_mount_out) << info(method).name;
      const double by_row = error_of_refits(record, method, each_row(record.rows()));
      const double by_mount = error_of_refits(record, method, rows_by_mount(record.mount));
      EXPECT_NEAR(result.leave_one_out->rmse / by_row, 1.0, tolerance) << info(method).name << " " << seed;
      EXPECT_NEAR(result.leave_one_mount_out->rmse / by_mount, 1.0, 2.0 * tolerance)
          << info(method).name << " " << seed;
    }
  }
}

// Rows whose weights leave too few of them to tell the coefficients are still fitted.
TEST(LeaveOut, LeavesOutNothingWhereTheWeightsLackRank) {
  Dataset record = uneven_record(4);
  for (std::vector<double>& sigma : record.acceleration_sigma) sigma.clear();
  record.output_sigma.assign(record.rows(), 1.0);
  for (std::size_t row = 0; row < 3; ++row) record.output_sigma[row] = 1e-25;
  const UncertaintyOptions inputs{.input = 1e-25};
  const Identification result = fitted(record, Eiv{.uncertainty = inputs}).identification;
  EXPECT_FALSE(result.leave_one_out);
  EXPECT_EQ(test::number(test::finding_of(result, Code::rows_not_left_out), "count"), 40.0);
}

TEST(LeaveOut, KnowsThatRowsWithoutALabelAreNoMount) {
  Dataset record = uneven_record(5);
  const auto all = fitted(record, Ols{}).identification.leave_one_mount_out->n;
  std::size_t unlabelled = 0;
  for (std::string& mount : record.mount) {
    if (mount != "P1") continue;
    mount.clear();
    ++unlabelled;
  }
  ASSERT_GT(unlabelled, 0U);
  EXPECT_EQ(fitted(record, Ols{}).identification.leave_one_mount_out->n, all - unlabelled);
}

}  // namespace
}  // namespace proofmass
