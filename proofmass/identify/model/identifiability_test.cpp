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

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const Unidentifiable& lost(const Identifiability& found, Term term) {
  const auto at = std::find_if(found.lost.begin(), found.lost.end(),
                               [term](const auto& entry) { return entry.term == term; });
  if (at == found.lost.end()) throw std::out_of_range("not lost");
  return *at;
}

std::string error_of(const Dataset& data, const TermList& terms, RankLossPolicy policy, ErrorKind kind) {
  try {
    (void)require_identifiable(data, terms, policy);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), kind) << error.what();
    return error.what();
  }
  ADD_FAILURE() << "no error";
  return {};
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
  EXPECT_THAT(found.lost, IsEmpty());
  EXPECT_GT(found.condition_raw, found.condition_scaled);
  EXPECT_LT(found.condition_scaled, 100.0);
}

TEST(Identifiability, OutwardInputAxisCannotTellBuckingFromSquare) {
  Dataset record = test::make_twin();
  for (double& value : record.acceleration[0]) value = std::abs(value);
  const Identifiability found = analyse_identifiability(record, parse_terms("K0,Ki,Kii,Koq,Kiii"));
  EXPECT_EQ(join_names(found.identified), "K0, Ki, Kii, Kiii");
  EXPECT_THAT(lost(found, Term::Koq).confounded_with, ElementsAre(Term::Kii));
  EXPECT_THAT(lost(found, Term::Koq).reason, HasSubstr("|Ai|*Ai is proportional to Ai^2"));
}

TEST(Identifiability, TumbleInOneGravityNamesEveryConfounding) {
  const Identifiability found = analyse_identifiability(make_tumble(), parse_terms("full"));
  // cos² + sin² = 1, and times cos or sin; rounded cosines of 90 degrees are no regressors.
  EXPECT_THAT(lost(found, Term::Koo).confounded_with, ElementsAre(Term::K0, Term::Kii));
  EXPECT_THAT(lost(found, Term::Kioo).confounded_with, ElementsAre(Term::Ki, Term::Kiii));
  EXPECT_THAT(lost(found, Term::Koii).confounded_with, ElementsAre(Term::Ko, Term::Kooo));
  EXPECT_EQ(lost(found, Term::Kip).reason, "Ap is zero in every row");
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
  EXPECT_EQ(lost(found, Term::Kio).reason, "Ai*Ao is zero in every row");
  EXPECT_EQ(lost(found, Term::Kp).reason, "Ap is zero in every row");
}

TEST(Identifiability, ConstantAxisIsTheBias) {
  Dataset record = test::make_twin();
  for (double& value : record.acceleration[1]) value = 1.0;
  const Identifiability found = analyse_identifiability(record, parse_terms("linear"));
  EXPECT_THAT(lost(found, Term::Ko).confounded_with, ElementsAre(Term::K0));
  EXPECT_THAT(lost(found, Term::Ko).reason, HasSubstr("Ao is the same in every row"));
}

TEST(RequireIdentifiable, RefusesNamingTermsReasonsAndRemedy) {
  Dataset record = test::make_twin();
  record.acceleration[1].clear();
  const TermList terms = parse_terms("quadratic");
  const std::string message = error_of(record, terms, RankLossPolicy::refuse, ErrorKind::refused);
  for (const char* part :
       {"4 of the 10", "Ko: ", "Koo: ", "Kio: ", "Kop: ", "no column Ao", "Fit without them"}) {
    EXPECT_THAT(message, HasSubstr(part));
  }
  EXPECT_EQ(require_identifiable(record, terms, RankLossPolicy::drop).lost.size(), 4U);
  EXPECT_THAT(error_of(record, {Term::Ko}, RankLossPolicy::drop, ErrorKind::refused),
              HasSubstr("no column Ao"));
}

TEST(RequireIdentifiable, SaysHowManyRowsAreNeeded) {
  const Dataset record = test::make_twin({.rows = 21});
  const std::string message =
      error_of(record, parse_terms("full"), RankLossPolicy::drop, ErrorKind::bad_data);
  EXPECT_THAT(message, HasSubstr("21 rows"));
  EXPECT_THAT(message, HasSubstr("at least 22"));
}

TEST(RequireIdentifiable, RejectsAConstantOutput) {
  Dataset record = test::make_twin();
  std::fill(record.output.begin(), record.output.end(), 0.25);
  EXPECT_THAT(error_of(record, parse_terms("linear"), RankLossPolicy::refuse, ErrorKind::bad_data),
              HasSubstr("0.25 in every row"));
}

}  // namespace
}  // namespace proofmass
