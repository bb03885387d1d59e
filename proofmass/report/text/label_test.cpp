// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/text/label.hpp"

#include <gtest/gtest.h>

namespace proofmass {
namespace {

TEST(Labels, HoldTheirFigures) {
  const Text text = text_of(Label::verdict_doubt, {{"warnings", 1.0}, {"count", 3.0}, {"total", 4.0}});
  EXPECT_EQ(text.en,
            "1 warning is to be settled before the coefficients are used; 3 of 4 terms of the model are "
            "identified.");
  EXPECT_EQ(text.zh, "使用系数之前须先处理 1 条警告；模型 4 项中有 3 项已辨识。");
}

}  // namespace
}  // namespace proofmass
