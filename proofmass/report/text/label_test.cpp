// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/text/label.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

namespace proofmass {
namespace {

// Names of figures in braces; not the words for one or many, which Chinese does without.
std::set<std::string> placeholders(std::string_view text) {
  std::set<std::string> names;
  for (std::size_t at = text.find('{'); at != std::string_view::npos; at = text.find('{', at + 1)) {
    const std::string_view rest = text.substr(at + 1);
    const std::string_view name = rest.substr(0, rest.find_first_of(":}"));
    if (!rest.substr(name.size()).starts_with(":?")) names.emplace(name);
  }
  return names;
}

bool is_chinese(std::string_view text) {
  return std::any_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) >= 0xE4; });
}

TEST(Labels, HaveTheSameFiguresInEveryLanguage) {
  for (const Label label : all_labels()) {
    const Words both = words(label);
    EXPECT_FALSE(both.en.empty());
    EXPECT_TRUE(is_chinese(both.zh)) << both.zh;
    EXPECT_FALSE(is_chinese(both.en)) << both.en;
    EXPECT_EQ(placeholders(both.en), placeholders(both.zh)) << both.en;
    EXPECT_EQ(both.en.ends_with('.'), both.zh.ends_with("。")) << both.en;
  }
}

TEST(Labels, HoldTheirFigures) {
  const Text text = text_of(Label::verdict_doubt, {{"warnings", 1.0}, {"count", 3.0}, {"total", 4.0}});
  EXPECT_EQ(text.en,
            "1 warning is to be settled before the coefficients are used; 3 of 4 terms of the model are "
            "identified.");
  EXPECT_EQ(text.zh, "使用系数之前须先处理 1 条警告；模型 4 项中有 3 项可辨识。");
}

}  // namespace
}  // namespace proofmass
