// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/uncertainty/row_covariance.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "proofmass/core/error.hpp"
#include "proofmass/numeric/random.hpp"
#include "proofmass/pipeline.hpp"

namespace proofmass {
namespace {

using testing::HasSubstr;

constexpr std::size_t kMounts = 12;

// Rows of twelve mounts in turn; an offset of each mount, and noise that grows with Ai.
Dataset mounted_record(std::uint64_t seed, double offsets, double growth) {
  RandomStream random(seed, stream_id("row covariance"));
  std::vector<double> offset(kMounts);
  for (double& value : offset) value = offsets * random.normal();
  Dataset record;
  record.source = "mounts.csv";
  for (std::size_t row = 0; row < 240; ++row) {
    const std::size_t mount = row % kMounts;
    const double a = random.uniform(-5.0, 5.0);
    record.acceleration[0].push_back(a);
    record.acceleration[1].push_back(random.uniform(-5.0, 5.0));
    record.acceleration[2].push_back(random.uniform(-5.0, 5.0));
    record.output.push_back(a + offset[mount] + (1e-5 + growth * std::abs(a)) * random.normal());
    record.mount.push_back("m" + std::to_string(mount));
    record.line.push_back(row + 2);
  }
  return record;
}

IdentifyOptions with(CovarianceKind kind) { return {.terms = parse_terms("K0,Ki"), .covariance = kind}; }

double error_of(const Run& run, Term term) { return *run.identification.find(term).standard_error; }

int covers(const Run& run, Term term, double truth) {
  const Interval& ci = *run.identification.find(term).ci95;
  return ci.low <= truth && truth <= ci.high ? 1 : 0;
}

// Coverage of Ki by HC3 under noise that grows, and of K0 by mounts under offsets: both are short by far
// under the model of white noise.
TEST(RowCovariance, CoversWhereTheModelDoesNot) {
  constexpr int kRecords = 400;
  int model_ki = 0;
  int hc3_ki = 0;
  int model_k0 = 0;
  int mount_k0 = 0;
  for (std::uint64_t seed = 1; seed <= kRecords; ++seed) {
    const Dataset growing = mounted_record(seed, 0.0, 1e-4);
    model_ki += covers(identify(growing, Ols{}, with(CovarianceKind::model)), Term::Ki, 1.0);
    hc3_ki += covers(identify(growing, Ols{}, with(CovarianceKind::hc3)), Term::Ki, 1.0);
    const Dataset shifted = mounted_record(seed, 1e-4, 0.0);
    model_k0 += covers(identify(shifted, Ols{}, with(CovarianceKind::model)), Term::K0, 0.0);
    mount_k0 += covers(identify(shifted, Ols{}, with(CovarianceKind::mount)), Term::K0, 0.0);
  }
  EXPECT_LT(model_ki, 365);
  EXPECT_LT(model_k0, 200);
  EXPECT_NEAR(hc3_ki, 380, 14);  // 95 % of 400, three standard deviations of the count
  EXPECT_NEAR(mount_k0, 380, 14);
}

TEST(RowCovariance, SaysWhatTheErrorsGoByAndCountsMounts) {
  const Dataset record = mounted_record(1, 1e-4, 0.0);
  const auto run = identify(record, Robust{}, with(CovarianceKind::mount));
  const Identification& result = run.identification;
  EXPECT_EQ(result.covariance_kind, CovarianceKind::mount);
  EXPECT_EQ(result.diagnostics.interval_dof, kMounts - 1);
  const auto says = [&](Code code) {
    return std::any_of(result.findings.begin(), result.findings.end(),
                       [code](const Finding& finding) { return finding.code == code; });
  };
  EXPECT_TRUE(says(Code::errors_by_mounts));
  EXPECT_FALSE(says(Code::robust_errors_asymptotic));
  const Coefficient& ki = result.find(Term::Ki);
  EXPECT_NEAR((ki.ci95->high - ki.value) / *ki.standard_error, 2.201, 1e-3);  // t of 11 degrees of freedom
}

TEST(RowCovariance, IsTheModelsOwnUnderItsNoise) {
  const Dataset record = mounted_record(3, 0.0, 0.0);
  for (const Method& method : {Method(Ols{}), Method(Robust{}), Method(Wls{})}) {
    const auto model = identify(record, method, with(CovarianceKind::model));
    const auto hc3 = identify(record, method, with(CovarianceKind::hc3));
    EXPECT_NEAR(error_of(hc3, Term::Ki) / error_of(model, Term::Ki), 1.0, 0.15) << info(method).name;
  }
}

std::string refusal_of(const Dataset& record, const Method& method, const IdentifyOptions& options) {
  try {
    static_cast<void>(identify(record, method, options));
  } catch (const Error& error) {
    return error.what();
  }
  return "none";
}

TEST(RowCovariance, RefusesByName) {
  Dataset record = mounted_record(1, 0.0, 0.0);
  EXPECT_THAT(refusal_of(record, PsoBp{}, with(CovarianceKind::hc3)), HasSubstr("pso-bp has the covariance"));
  for (std::size_t row = 0; row < record.rows(); ++row)
    if (record.mount[row] != "m3") record.acceleration[1][row] = 0.0;
  IdentifyOptions options = with(CovarianceKind::mount);
  options.terms = parse_terms("K0,Ki,Ko");
  EXPECT_THAT(refusal_of(record, Ols{}, options), HasSubstr("without the mount 'm3'"));
  record.mount[7].clear();
  EXPECT_THAT(refusal_of(record, Ols{}, options), HasSubstr("mounts.csv:9"));
  record.mount.clear();
  EXPECT_THAT(refusal_of(record, Ols{}, options), HasSubstr("'mount'"));
}

}  // namespace
}  // namespace proofmass
