// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/mape_rows.hpp"

#include <gtest/gtest.h>

namespace proofmass {
namespace {

Metrics scored(std::size_t rows, std::size_t mape_rows) {
  return {.n = rows, .mape_percent = 1.0, .mape_rows = mape_rows, .r2 = {}};
}

TEST(MapeRows, NamesThePartsThatLeaveRowsOut) {
  MapeRows rows;
  EXPECT_EQ(rows.text(), "");
  rows.add(same_text("training"), scored(70, 70));
  rows.add(same_text("validation"), std::nullopt);
  EXPECT_EQ(rows.text(), "");
  rows.add(same_text("test"), scored(30, 29));
  EXPECT_EQ(rows.text(), "MAPE leaves out outputs below 1 % of their range: it is over 29 of 30 test rows");
}

TEST(MapeRows, GivesTheRangeOverMethodsAndRepeats) {
  MapeRows rows;
  rows.add(same_text("training"), scored(70, 68));
  rows.add(same_text("test"), scored(30, 30));
  rows.add(same_text("training"), scored(60, 60));
  rows.add(same_text("test"), scored(30, 28));
  EXPECT_EQ(
      rows.text(),
      "MAPE leaves out outputs below 1 % of their range: it is over 60 to 68 of 60 to 70 training rows, "
      "28 to 30 of 30 test rows");
}

// Results of before 0.1.0 say nothing of the rows.
TEST(MapeRows, PassesOverScoresWithoutThem) {
  MapeRows rows;
  rows.add(same_text("test"), scored(30, 0));
  EXPECT_EQ(rows.text(), "");
}

}  // namespace
}  // namespace proofmass
