// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/test_curve.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "proofmass/pipeline.hpp"
#include "support/twin.hpp"

namespace proofmass {
namespace {

const Curve* find_curve(const Identification& result, std::string_view name) {
  const auto found = std::find_if(result.history.begin(), result.history.end(),
                                  [&](const Curve& curve) { return curve.name == name; });
  return found == result.history.end() ? nullptr : &*found;
}

// The last point of the curve is the network that is handed over: its error is the result's test error.
TEST(TestCurve, EndsAtTheTestErrorOfTheResult) {
  const Dataset record = test::make_twin({.rows = 200});
  for (const char* method : {"bp", "pso-bp"}) {
    const auto run = identify(record, find_method(method), {.terms = {Term::K0, Term::Ki, Term::Kii}});
    const Curve* const training = find_curve(run.identification, "training_rmse");
    const Curve* const tested = find_curve(run.identification, "test_rmse");
    ASSERT_NE(tested, nullptr) << method;
    EXPECT_EQ(tested->values.size(), training->values.size());
    EXPECT_NEAR(tested->values.back() / run.identification.test->rmse, 1.0, 0.02) << method;
    EXPECT_NEAR(training->values.back() / run.identification.train->rmse, 1.0, 0.02) << method;
    EXPECT_GT(tested->values.front(), 2.0 * tested->values.back());
  }
}

TEST(TestCurve, IsAbsentWithoutTestRowsAndForOtherMethods) {
  const Dataset record = test::make_twin({.rows = 200});
  const TermList terms{Term::K0, Term::Ki};
  EXPECT_EQ(find_curve(identify(record, find_method("bp"), {.terms = terms, .split = 1.0}).identification,
                       "test_rmse"),
            nullptr);
  EXPECT_EQ(find_curve(identify(record, Ols{}, {.terms = terms, .split = 0.7}).identification, "test_rmse"),
            nullptr);
}

}  // namespace
}  // namespace proofmass
