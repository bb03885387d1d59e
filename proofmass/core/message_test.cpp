// SPDX-License-Identifier: Apache-2.0
#include "proofmass/core/message.hpp"

#include <gtest/gtest.h>

#include <string>

namespace proofmass {
namespace {

TEST(Messages, AreTheirWordsWithEachValueInItsPlace) {
  const Message inner = message("{} of {}", 2, amount_of(1, "row", "rows"));
  const Message made = message("'{}' is {:.3g}, in {}", "{}", 1.23456, inner);
  EXPECT_EQ(made.english(), "'{}' is 1.23, in 2 of 1 row");
  EXPECT_EQ(made.words(), "'{}' is {:.3g}, in {}");
  ASSERT_EQ(made.values().size(), 3U);
  EXPECT_TRUE(made.values().front().is_verbatim());
  EXPECT_EQ(made.values().at(1).english(), "1.23");
  EXPECT_EQ(amount_of(2, "row", "rows").english(), "2 rows");
}

TEST(Messages, TakeNumbersAsTheyAre) {
  EXPECT_EQ(message("{} {} {}", -1, 18446744073709551615U, 0.1).english(), "-1 18446744073709551615 0.1");
}

TEST(Messages, SayNothingWhenTheyAreEmpty) {
  EXPECT_TRUE(Message().empty());
  EXPECT_EQ(Message().english(), "");
  EXPECT_EQ(message("none{}", Message()).english(), "none");
}

TEST(Messages, LeaveBracesOfAFileAlone) {
  EXPECT_EQ(Message::verbatim("{0} {").english(), "{0} {");
  EXPECT_EQ(message("{}: {}", Message::verbatim("a{}"), "{b}").english(), "a{}: {b}");
}

}  // namespace
}  // namespace proofmass
