// SPDX-License-Identifier: Apache-2.0
#include "proofmass/core/term.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "proofmass/core/error.hpp"
#include "proofmass/core/static_model.hpp"

namespace proofmass {
namespace {

constexpr Acceleration kA{.i = -2.0, .o = 3.0, .p = 5.0};

TEST(Term, RegressorsAreTheProductsOfTheModelEquation) {
  // Worked by hand from the products of IEEE Std 1293 at Ai = -2, Ao = 3, Ap = 5.
  const double expected[kTermCount] = {1, -2, 4,   -4,  -8,  -6, -10, 15, 3,  9,  27,
                                       5, 25, 125, -18, -50, 75, 12,  45, 20, -30};
  for (const TermInfo& t : all_terms()) {
    EXPECT_EQ(regressor(t.term, kA), expected[static_cast<std::size_t>(t.term)]) << t.name;
  }
}

TEST(Term, TableIsInCanonicalOrderAndNamesAreFound) {
  for (std::size_t k = 0; k < kTermCount; ++k) {
    const TermInfo& t = all_terms()[k];
    EXPECT_EQ(static_cast<std::size_t>(t.term), k);
    EXPECT_EQ(find_term(t.name), t.term);
  }
  EXPECT_EQ(
      join_names(parse_terms("full")),
      "K0, Ki, Kii, Koq, Kiii, Kio, Kip, Kop, Ko, Koo, Kooo, Kp, Kpp, Kppp, Kioo, Kipp, Kopp, Koii, Kpoo, "
      "Kpii, Kiop");
  EXPECT_FALSE(find_term("ki"));
  EXPECT_FALSE(find_term(""));
}

TEST(Term, PresetsHaveTheirTermsInCanonicalOrder) {
  EXPECT_EQ(join_names(parse_terms("linear")), "K0, Ki, Ko, Kp");
  EXPECT_EQ(join_names(parse_terms("quadratic")), "K0, Ki, Kii, Kio, Kip, Kop, Ko, Koo, Kp, Kpp");
  EXPECT_EQ(join_names(parse_terms("paper")),
            "K0, Ki, Kii, Kiii, Kio, Kip, Kop, Ko, Koo, Kooo, Kp, Kpp, Kipp, Koii, Kpoo");
  EXPECT_EQ(parse_terms("paper").size(), 15U);
  EXPECT_EQ(parse_terms("full").size(), 21U);
}

TEST(Term, ListsAreSortedAndTrimmed) { EXPECT_EQ(join_names(parse_terms(" Kpp , K0,Ki ")), "K0, Ki, Kpp"); }

void expect_refused(std::string_view text, const std::string& culprit) {
  try {
    static_cast<void>(parse_terms(text));
    FAIL() << "accepted '" << text << "'";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
    EXPECT_NE(std::string(error.what()).find(culprit), std::string::npos) << error.what();
  }
}

TEST(Term, UnknownAndRepeatedNamesAreRefusedByName) {
  expect_refused("K0,Kxx", "'Kxx'");
  expect_refused("K0,,Ki", "''");
  expect_refused("", "''");
  expect_refused("K0,Ki,K0", "'K0' is listed twice");
}

TEST(StaticModel, OutputIsTheSumOfItsTerms) {
  const StaticModel model{.terms = {Term::K0, Term::Ki, Term::Koq, Term::Kiop},
                          .coefficients = {0.5, 2.0, 0.25, 0.125}};
  EXPECT_EQ(model.output(kA), 0.5 - 4.0 - 1.0 - 3.75);
  EXPECT_EQ(model.coefficient(Term::Koq), 0.25);
  EXPECT_EQ(model.coefficient(Term::Kpp), 0.0);
}

}  // namespace
}  // namespace proofmass
