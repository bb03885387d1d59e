// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/model/identifiability.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "proofmass/core/error.hpp"
#include "support/twin.hpp"

namespace proofmass {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

// Why a term is not identified.
const Finding& cause(const Identifiability& found, Term term) {
  const auto at = std::find_if(found.unidentified.begin(), found.unidentified.end(),
                               [term](const Finding& finding) { return finding.terms.front() == term; });
  if (at == found.unidentified.end()) throw std::out_of_range("identified");
  return *at;
}

void expect_aliased(const Identifiability& found, const TermList& terms) {
  const Finding& finding = cause(found, terms.front());
  EXPECT_EQ(finding.code, Code::term_aliased);
  EXPECT_EQ(finding.terms, terms);
}

void expect_zero(const Identifiability& found, Term term, const std::string& product) {
  const Finding zero{.code = Code::term_input_zero, .terms = {term}, .figures = {{"product", product}}};
  EXPECT_EQ(cause(found, term), zero);
}

Error error_of(const Dataset& data, const TermList& terms, RankLossPolicy policy, ErrorKind kind) {
  try {
    (void)require_identifiable(data, terms, policy);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), kind) << error.what();
    return error;
  }
  ADD_FAILURE() << "no error";
  return {ErrorKind::internal, ""};
}

// A one-g tumble about the pendulous axis, angles in steps of 15 degrees.
Dataset make_tumble() {
  Dataset record;
  record.source = "tumble.csv";
  for (int step = 0; step < 24; ++step) {
    const double angle = step * std::numbers::pi / 12.0;
    record.acceleration[0].push_back(std::cos(angle));
    record.acceleration[1].push_back(std::sin(angle));
    record.acceleration[2].push_back(0.0);
    record.output.push_back(std::cos(angle) + 1e-5 * step);
  }
  return record;
}

TEST(Identifiability, RandomDirectionsIdentifyAllTerms) {
  const Identifiability found = analyse_identifiability(test::make_twin(), parse_terms("full"));
  EXPECT_EQ(found.identified, parse_terms("full"));
  EXPECT_THAT(found.unidentified, IsEmpty());
  EXPECT_GT(found.condition_raw, found.condition_scaled);
  EXPECT_LT(found.condition_scaled, 100.0);
}

TEST(Identifiability, OutwardInputAxisCannotTellBuckingFromSquare) {
  Dataset record = test::make_twin();
  for (double& value : record.acceleration[0]) value = std::abs(value);
  const Identifiability found = analyse_identifiability(record, parse_terms("K0,Ki,Kii,Koq,Kiii"));
  EXPECT_EQ(join_names(found.identified), "K0, Ki, Kii, Kiii");
  expect_aliased(found, {Term::Koq, Term::Kii});
}

TEST(Identifiability, TumbleInOneGravityNamesEveryConfounding) {
  const Identifiability found = analyse_identifiability(make_tumble(), parse_terms("full"));
  // cos² + sin² = 1, and times cos or sin; rounded cosines of 90 degrees are no regressors.
  expect_aliased(found, {Term::Koo, Term::K0, Term::Kii});
  expect_aliased(found, {Term::Kioo, Term::Ki, Term::Kiii});
  expect_aliased(found, {Term::Koii, Term::Ko, Term::Kooo});
  expect_zero(found, Term::Kip, "Ap");
  EXPECT_EQ(join_names(found.identified), "K0, Ki, Kii, Koq, Kiii, Kio, Ko, Kooo");
}

TEST(Identifiability, RoundedZeroIsNoRegressor) {
  Dataset record = test::make_twin();
  for (std::size_t row = 0; row < record.rows(); ++row) {
    const bool along_input = row % 2 == 0;
    const double magnitude = record.acceleration[0][row];
    record.acceleration[0][row] = along_input ? magnitude : 6e-17 * magnitude * static_cast<double>(row % 3);
    record.acceleration[1][row] = along_input ? 6e-17 * magnitude * static_cast<double>(row % 5) : magnitude;
    record.acceleration[2][row] *= 1e-17;
  }
  const Identifiability found = analyse_identifiability(record, parse_terms("quadratic"));
  EXPECT_EQ(join_names(found.identified), "K0, Ki, Kii, Ko, Koo");
  expect_zero(found, Term::Kio, "Ai*Ao");
  expect_zero(found, Term::Kp, "Ap");
}

TEST(Identifiability, ConstantAxisIsTheBias) {
  Dataset record = test::make_twin();
  for (double& value : record.acceleration[1]) value = 1.0;
  const Identifiability found = analyse_identifiability(record, parse_terms("linear"));
  expect_aliased(found, {Term::Ko, Term::K0});
}

// Rounded to a number of decimals, as a record holds it.
Dataset rounded(Dataset record, int decimals) {
  const double step = std::pow(10.0, -decimals);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (double& value : record.acceleration[axis]) value = std::round(value / step) * step;
    if (!record.acceleration[axis].empty()) record.acceleration_resolution[axis] = step;
  }
  return record;
}

// cos² + sin² = 1 however the record is written: rounding alone must not tell K0, Kii and Koo apart.
TEST(Identifiability, RoundingTellsNoTermsApart) {
  for (const int decimals : {3, 4, 5, 6}) {
    const Identifiability found =
        analyse_identifiability(rounded(make_tumble(), decimals), parse_terms("full"));
    EXPECT_EQ(join_names(found.identified), "K0, Ki, Kii, Koq, Kiii, Kio, Ko, Kooo") << decimals;
    const Finding& koo = cause(found, Term::Koo);
    EXPECT_EQ(koo.code, Code::term_hidden_by_rounding) << decimals;
    EXPECT_EQ(koo.terms, (TermList{Term::Koo, Term::K0, Term::Kii})) << decimals;
    EXPECT_EQ(koo.figures, (std::vector<Figure>{{"step", std::pow(10.0, -decimals)}}));
  }
}

// So must not the noise of measured inputs, which eiv would take for a signal; by columns or by a constant.
TEST(Identifiability, UncertaintyTellsNoTermsApart) {
  for (const double sigma : {1e-5, 1e-4, 1e-3}) {
    Dataset record = make_tumble();
    RandomStream random(1, stream_id("inputs"));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (double& value : record.acceleration[axis]) value += sigma * random.normal();
      if (!record.acceleration[axis].empty()) record.acceleration_sigma[axis].assign(record.rows(), sigma);
    }
    const TermList terms = parse_terms("K0,Ki,Kii,Ko,Koo");
    const Identifiability found = analyse_identifiability(record, terms);
    EXPECT_EQ(join_names(found.identified), "K0, Ki, Kii, Ko") << sigma;
    const Finding& koo = cause(found, Term::Koo);
    EXPECT_EQ(koo.code, Code::term_hidden_by_uncertainty);
    EXPECT_EQ(koo.terms, (TermList{Term::Koo, Term::K0, Term::Kii}));
    EXPECT_NEAR(std::get<double>(koo.figures.front().value), sigma, 1e-9 * sigma);
    record.acceleration_sigma = {};
    EXPECT_EQ(analyse_identifiability(record, terms).identified, terms) << sigma;
    EXPECT_EQ(analyse_identifiability(TermSums(record, terms), terms, sigma).identified, found.identified);
  }
}

// A record that can tell all terms apart still can when it is written with few decimals.
TEST(Identifiability, RoundingHidesNothingOfARecordWithLevels) {
  const Identifiability found = analyse_identifiability(rounded(test::make_twin(), 3), parse_terms("full"));
  EXPECT_EQ(found.identified, parse_terms("full"));
  EXPECT_THAT(found.unidentified, IsEmpty());
}

// An axis that holds nothing but rounding has no coefficient.
TEST(Identifiability, AnAxisOfRoundingIsNoInput) {
  Dataset record = test::make_twin();
  for (std::size_t row = 0; row < record.rows(); ++row)
    record.acceleration[2][row] = 0.001 * (static_cast<double>(row % 3) - 1.0);
  record.acceleration_resolution[2] = 0.001;
  const Identifiability found = analyse_identifiability(record, parse_terms("linear"));
  EXPECT_EQ(join_names(found.identified), "K0, Ki, Ko");
  EXPECT_EQ(cause(found, Term::Kp).code, Code::term_hidden_by_rounding);
}

TEST(RequireIdentifiable, RefusesNamingTermsReasonsAndRemedy) {
  Dataset record = test::make_twin();
  record.acceleration[1].clear();
  const TermList terms = parse_terms("quadratic");
  const Error error = error_of(record, terms, RankLossPolicy::refuse, ErrorKind::refused);
  EXPECT_THAT(error.what(), HasSubstr("4 of the 10 terms asked for: Kio, Kop, Ko, Koo. Fit without them"));
  EXPECT_EQ(error.findings(), require_identifiable(record, terms, RankLossPolicy::drop).unidentified);
  ASSERT_EQ(error.findings().size(), 4U);
  EXPECT_EQ(error.findings().front().code, Code::term_without_column);
  ASSERT_EQ(error.remedies().size(), 2U);
  EXPECT_EQ(error.remedies()[1].value, "K0,Ki,Kii,Kip,Kp,Kpp");
  // There is nothing left to fit.
  const Error nothing = error_of(record, {Term::Ko}, RankLossPolicy::drop, ErrorKind::refused);
  EXPECT_EQ(nothing.findings().size(), 1U);
  EXPECT_THAT(nothing.remedies(), IsEmpty());
}

TEST(RequireIdentifiable, SaysHowManyRowsAreNeeded) {
  const Dataset record = test::make_twin({.rows = 21});
  const std::string message =
      error_of(record, parse_terms("full"), RankLossPolicy::drop, ErrorKind::bad_data).what();
  EXPECT_THAT(message, HasSubstr("21 rows"));
  EXPECT_THAT(message, HasSubstr("at least 22"));
}

TEST(RequireIdentifiable, RejectsAConstantOutput) {
  Dataset record = test::make_twin();
  std::fill(record.output.begin(), record.output.end(), 0.25);
  EXPECT_THAT(error_of(record, parse_terms("linear"), RankLossPolicy::refuse, ErrorKind::bad_data).what(),
              HasSubstr("0.25 in every row"));
}

}  // namespace
}  // namespace proofmass
