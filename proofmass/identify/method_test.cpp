// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/method.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <string_view>

#include "proofmass/core/error.hpp"
#include "support/networks.hpp"
#include "support/twin.hpp"

namespace proofmass {
namespace {

using testing::HasSubstr;

TEST(Methods, AreFoundByTheirNames) {
  std::set<std::string_view> names;
  for (const Method& method : methods()) {
    const std::string_view name = info(method).name;
    EXPECT_TRUE(names.insert(name).second) << name;
    EXPECT_EQ(find_method(name).index(), method.index()) << name;
    EXPECT_FALSE(info(method).summary.empty()) << name;
  }
  for (const char* name : {"ols", "bp", "pso-bp"}) EXPECT_TRUE(names.contains(name)) << name;
}

TEST(Methods, UnknownNameListsTheKnown) {
  try {
    (void)find_method("magic");
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
    EXPECT_THAT(error.what(), HasSubstr("'magic'"));
    for (const Method& method : methods())
      EXPECT_THAT(error.what(), HasSubstr(std::string(info(method).name)));
  }
}

// A result with both a network and coefficients that say otherwise.
Identification two_minded(const Dataset& record) {
  Identification fit;
  fit.network = test::random_network(record, 3);
  fit.coefficients.resize(2);
  fit.coefficients[0].term = Term::Ki;
  fit.coefficients[0].value = 2.0;
  fit.coefficients[1].term = Term::Ko;
  fit.coefficients[1].value = 5.0;
  fit.coefficients[1].identified = false;
  return fit;
}

TEST(Predict, TakesTheNetworkWhereThereIsOneElseTheModel) {
  const Dataset record = test::make_twin({.rows = 9});
  Identification fit = two_minded(record);
  EXPECT_EQ(predict(fit, record), network_outputs(*fit.network, record));
  fit.network.reset();
  const std::vector<double> outputs = predict(fit, record);
  for (std::size_t row = 0; row < outputs.size(); ++row) EXPECT_EQ(outputs[row], 2.0 * record.at(row).i);
}

TEST(Predict, NeedsOnlyTheAxesOfIdentifiedTerms) {
  Dataset record = test::make_twin({.rows = 9});
  Identification fit = two_minded(record);
  fit.network.reset();
  record.acceleration[1].clear();
  EXPECT_EQ(predict(fit, record).size(), 9U);
  fit.coefficients[1].identified = true;
  try {
    (void)predict(fit, record);
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_data);
    EXPECT_THAT(error.what(), HasSubstr("'Ao'"));
    EXPECT_THAT(error.what(), HasSubstr("Ko"));
  }
}

}  // namespace
}  // namespace proofmass
